Spans halfSpace(const Ray& r) {
    if (std::abs(r.d.z) < 1e-6) return r.o.z <= 0 ? Spans{{-INF, INF}} : Spans{};
    const double t = -r.o.z / r.d.z;
    return r.d.z < 0 ? Spans{{t, INF}} : Spans{{-INF, t}};
}
