dvec3 chain(const std::vector<Bounce>& p, int k, const dvec3& bg) {
    if (p.empty()) return bg;
    dvec3 sum = p[0].local;
    for (std::size_t i = 1; int(i) <= k && p[i - 1].kr > 0; ++i) {
        if (i == p.size()) return sum + p[i - 1].kr * bg;
        sum += p[i - 1].kr * p[i].local;
    }
    return sum;
}
