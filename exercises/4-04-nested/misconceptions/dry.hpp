std::vector<dvec2> speeds(const std::vector<Cross>& p, std::vector<int>, const std::vector<double>& c,
                          const std::vector<int>& priority) {
    std::vector<int> in;
    const auto speed = [&] {
        int ruler = -1;
        for (const int i : in)
            if (ruler < 0 ||
                std::pair(priority[std::size_t(i)], i) > std::pair(priority[std::size_t(ruler)], ruler))
                ruler = i;
        return ruler < 0 ? 1.0 : c[std::size_t(ruler)];
    };
    std::vector<dvec2> result;
    for (const Cross& cross : p) {
        const double before = speed();
        if (cross.enter)
            in.push_back(cross.obj);
        else
            std::erase(in, cross.obj);
        result.push_back({before, speed()});
    }
    return result;
}
