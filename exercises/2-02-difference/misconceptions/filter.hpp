Hits difference(const Hits& A, const Hits& B) {
    bool inB = !B.empty() && !B.front().enter;
    Hits result;
    std::size_t b = 0;
    for (const Hit& hit : A) {
        for (; b < B.size() && B[b].t <= hit.t; ++b) inB = B[b].enter;
        if (!inB) result.push_back(hit);
    }
    return result;
}
