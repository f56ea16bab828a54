std::vector<int> order(const Box&, const Ray& r) {
    int mask = 0;
    for (int i = 0; i < 3; ++i)
        if (r.d[i] < 0) mask |= 1 << i;
    std::vector<int> result;
    for (int i = 0; i < 8; ++i) result.push_back(i ^ mask);
    return result;
}
