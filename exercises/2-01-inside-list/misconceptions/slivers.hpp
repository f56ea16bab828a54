Spans inside(Hits h) {
    std::stable_sort(h.begin(), h.end(), [](const Hit& x, const Hit& y) { return x.t < y.t; });
    Spans spans;
    bool open = !h.empty() && !h.front().enter;
    double begin = -INF;
    for (const Hit& hit : h) {
        if (hit.enter && !open) begin = hit.t;
        if (!hit.enter && open) spans.push_back({begin, hit.t});
        open = hit.enter;
    }
    if (open) spans.push_back({begin, INF});
    return spans;
}
