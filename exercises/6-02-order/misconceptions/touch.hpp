std::vector<int> order(const Box& cell, const Ray& r) {
    const dvec3 middle = (cell.lo + cell.hi) / 2.0;
    std::vector<std::tuple<double, int, int>> met;
    int mask = 0;
    for (int i = 0; i < 3; ++i)
        if (r.d[i] < 0) mask |= 1 << i;
    for (int child = 0; child < 8; ++child) {
        double begin = 0, end = INF;
        bool misses = false;
        for (int i = 0; i < 3; ++i) {
            const bool upper = (child >> i & 1) != 0;
            const double lo = upper ? middle[i] : cell.lo[i], hi = upper ? cell.hi[i] : middle[i];
            if (r.d[i] == 0) {
                misses = misses || r.o[i] < lo || r.o[i] > hi;
                continue;
            }
            const double low = (lo - r.o[i]) / r.d[i], high = (hi - r.o[i]) / r.d[i];
            begin = std::max(begin, std::min(low, high));
            end = std::min(end, std::max(low, high));
        }
        if (!misses && begin <= end) met.push_back({begin, child ^ mask, child});
    }
    std::sort(met.begin(), met.end());
    std::vector<int> result;
    for (const auto& [t, turned, child] : met) result.push_back(child);
    return result;
}
