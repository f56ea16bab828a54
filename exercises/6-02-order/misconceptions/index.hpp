std::vector<int> order(const Box& cell, const Ray& r) {
    const dvec3 middle = (cell.lo + cell.hi) / 2.0;
    double begin = 0, end = INF;
    std::vector<double> times;
    for (int i = 0; i < 3; ++i) {
        if (r.d[i] == 0) {
            if (r.o[i] < cell.lo[i] || r.o[i] > cell.hi[i]) return {};
            continue;
        }
        const double low = (cell.lo[i] - r.o[i]) / r.d[i], high = (cell.hi[i] - r.o[i]) / r.d[i];
        begin = std::max(begin, std::min(low, high));
        end = std::min(end, std::max(low, high));
        times.push_back((middle[i] - r.o[i]) / r.d[i]);
    }
    if (!(begin < end)) return {};
    std::erase_if(times, [&](double t) { return t <= begin || t >= end; });
    times.push_back(begin);
    times.push_back(end);
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    std::vector<int> result;
    for (std::size_t k = 0; k + 1 < times.size(); ++k) {
        const dvec3 p = r.o + (times[k] + times[k + 1]) / 2 * r.d;
        int child = 0;
        for (int i = 0; i < 3; ++i)
            if (p[i] >= middle[i]) child |= 1 << i;
        result.push_back(child);
    }
    std::sort(result.begin(), result.end());
    return result;
}
