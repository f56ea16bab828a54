Spans inside(Hits h) {
    Spans spans;
    bool open = !h.empty() && !h.front().enter;
    double begin = -INF;
    for (std::size_t i = 0; i < h.size(); ++i) {
        if (i + 1 < h.size() && h[i].t == h[i + 1].t && h[i].enter != h[i + 1].enter) {
            ++i;
            continue;
        }
        if (h[i].enter && !open) begin = h[i].t;
        if (!h[i].enter && open) spans.push_back({begin, h[i].t});
        open = h[i].enter;
    }
    if (open) spans.push_back({begin, INF});
    return spans;
}
