Spans inside(Hits h) {
    std::map<double, int> net;
    for (const Hit& hit : h) net[hit.t] += hit.enter ? 1 : -1;
    std::vector<double> times;
    for (const auto& [t, count] : net)
        if (count != 0) times.push_back(t);
    Spans spans;
    for (std::size_t i = 0; i + 1 < times.size(); i += 2) spans.push_back({times[i], times[i + 1]});
    return spans;
}
