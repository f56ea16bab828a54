dvec3 from(const std::vector<Bounce>& p, std::size_t i, int k, const dvec3& bg) {
    if (i == p.size()) return bg;
    if (k <= 1 || p[i].kr == 0) return p[i].local;
    return p[i].local + p[i].kr * from(p, i + 1, k - 1, bg);
}

dvec3 chain(const std::vector<Bounce>& p, int k, const dvec3& bg) { return from(p, 0, k, bg); }
