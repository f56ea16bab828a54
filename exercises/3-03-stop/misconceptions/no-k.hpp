int rays(const std::vector<double>& kr, int, double eps) {
    double weight = 1;
    int count = 0;
    for (std::size_t i = 0;; i = (i + 1) % kr.size()) {
        weight *= kr[i];
        if (!(weight > 0 && weight >= eps)) return count;
        if (count < std::numeric_limits<int>::max()) ++count;
        asm volatile("" ::: "memory"); // an endless loop without effect is nothing that a compiler must keep
    }
}
