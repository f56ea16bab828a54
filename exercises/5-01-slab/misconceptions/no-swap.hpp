std::optional<Span> slab(const Ray& r, const Box& b) {
    Span span{-INF, INF};
    for (int i = 0; i < 3; ++i) {
        if (r.d[i] == 0) {
            if (r.o[i] < b.lo[i] || r.o[i] > b.hi[i]) return std::nullopt;
            continue;
        }
        span.a = std::max(span.a, (b.lo[i] - r.o[i]) / r.d[i]);
        span.b = std::min(span.b, (b.hi[i] - r.o[i]) / r.d[i]);
    }
    if (span.a > span.b) return std::nullopt;
    return span;
}
