Found first(const std::vector<Cell>& cells, const std::vector<double>& tHit) {
    Found found;
    double best = INF;
    for (const Cell& cell : cells) {
        for (const int obj : cell.objs) {
            ++found.tests;
            const double t = tHit[std::size_t(obj)];
            if (t > 0 && t < best) best = t, found.obj = obj;
        }
        if (best <= cell.t1) break;
    }
    return found;
}
