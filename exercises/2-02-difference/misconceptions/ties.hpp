Hits difference(const Hits& A, const Hits& B) {
    bool inA = !A.empty() && !A.front().enter, inB = !B.empty() && !B.front().enter;
    Hits result;
    for (std::size_t a = 0, b = 0; a < A.size() || b < B.size();) {
        const bool before = inA && !inB;
        const bool takeA = a < A.size() && (b == B.size() || A[a].t <= B[b].t);
        const Hit hit = takeA ? A[a++] : B[b++];
        (takeA ? inA : inB) = hit.enter;
        const bool after = inA && !inB;
        if (before == after) continue;
        result.push_back({hit.t, takeA ? hit.n : -hit.n, after, hit.obj});
    }
    return result;
}
