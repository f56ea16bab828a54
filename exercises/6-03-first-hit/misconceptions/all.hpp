Found first(const std::vector<Cell>& cells, const std::vector<double>& tHit) {
    Found found;
    double best = INF;
    std::set<int> tested;
    for (const Cell& cell : cells)
        for (const int obj : cell.objs) {
            if (!tested.insert(obj).second) continue;
            ++found.tests;
            const double t = tHit[std::size_t(obj)];
            if (t > 0 && t < best) best = t, found.obj = obj;
        }
    return found;
}
