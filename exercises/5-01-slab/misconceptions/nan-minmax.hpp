std::optional<Span> slab(const Ray& r, const Box& b) {
    Span span{-INF, INF};
    for (int i = 0; i < 3; ++i) {
        const double t0 = (b.lo[i] - r.o[i]) / r.d[i], t1 = (b.hi[i] - r.o[i]) / r.d[i];
        span.a = std::max(std::min(t0, t1), span.a);
        span.b = std::min(std::max(t0, t1), span.b);
    }
    if (span.a > span.b) return std::nullopt;
    return span;
}
