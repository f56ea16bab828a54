int rays(const std::vector<double>& kr, int k, double eps) {
    int count = 0;
    while (count < k) {
        const double next = kr[std::size_t(count) % kr.size()];
        if (!(next > 0 && next >= eps)) break;
        ++count;
    }
    return count;
}
