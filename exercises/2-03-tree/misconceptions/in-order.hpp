Spans complement(const Spans& spans) {
    Spans result;
    double begin = -INF;
    for (const Span& span : spans) {
        if (begin < span.a) result.push_back({begin, span.a});
        begin = span.b;
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

struct Walk {
    Spans so_far;
    int op = 0;
    bool turned = false;
};

void visit(const std::vector<Node>& n, int root, const std::vector<Spans>& leaf, Walk& walk) {
    const Node& node = n[std::size_t(root)];
    if (node.op == '!') {
        walk.turned = !walk.turned;
        visit(n, node.l, leaf, walk);
    } else if (node.op != '.') {
        visit(n, node.l, leaf, walk);
        walk.op = node.op;
        visit(n, node.r, leaf, walk);
    } else {
        const Spans& given = leaf[std::size_t(node.l)];
        const Spans next = walk.turned ? complement(given) : given;
        walk.turned = false;
        if (walk.op == 0) walk.so_far = next;
        if (walk.op == '&') walk.so_far = both(walk.so_far, next);
        if (walk.op == '-') walk.so_far = both(walk.so_far, complement(next));
        if (walk.op == '|') walk.so_far = complement(both(complement(walk.so_far), complement(next)));
    }
}

Spans eval(const std::vector<Node>& n, int root, const std::vector<Spans>& leaf) {
    Walk walk;
    visit(n, root, leaf, walk);
    return walk.so_far;
}
