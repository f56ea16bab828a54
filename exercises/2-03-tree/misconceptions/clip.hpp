Spans complement(const Spans& spans, double from) {
    Spans result;
    double begin = from;
    for (const Span& span : spans) {
        if (begin < span.a) result.push_back({begin, span.a});
        begin = std::max(begin, span.b);
    }
    if (begin < INF) result.push_back({begin, INF});
    return result;
}

Spans both(const Spans& a, const Spans& b) {
    Spans result;
    for (const Span& x : a)
        for (const Span& y : b)
            if (std::max(x.a, y.a) < std::min(x.b, y.b))
                result.push_back({std::max(x.a, y.a), std::min(x.b, y.b)});
    return result;
}

Spans eval(const std::vector<Node>& n, int root, const std::vector<Spans>& leaf) {
    const Node& node = n[std::size_t(root)];
    if (node.op == '.') return leaf[std::size_t(node.l)];
    const Spans left = eval(n, node.l, leaf);
    if (node.op == '!') return complement(left, 0);
    const Spans right = eval(n, node.r, leaf);
    if (node.op == '&') return both(left, right);
    if (node.op == '-') return both(left, complement(right, -INF));
    return complement(both(complement(left, -INF), complement(right, -INF)), -INF);
}
