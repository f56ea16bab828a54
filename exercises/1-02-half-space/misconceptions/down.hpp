Spans halfSpace(const Ray& r) {
    if (r.d.z == 0) return r.o.z <= 0 ? Spans{{-INF, INF}} : Spans{};
    const double t = -r.o.z / r.d.z;
    return {{t, INF}};
}
