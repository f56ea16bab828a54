std::optional<Span> slab(const Ray& r, const Box& b) {
    Span span{-INF, INF};
    for (int i = 0; i < 3; ++i) {
        double t0 = (b.lo[i] - r.o[i]) / r.d[i], t1 = (b.hi[i] - r.o[i]) / r.d[i];
        if (t0 > t1) std::swap(t0, t1);
        if (t0 > span.a) span.a = t0;
        if (t1 < span.b) span.b = t1;
    }
    if (span.a > span.b) return std::nullopt;
    return span;
}
