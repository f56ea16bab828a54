std::vector<dvec2> speeds(const std::vector<Cross>& p, std::vector<int> in, const std::vector<double>& c,
                          const std::vector<int>&) {
    const auto speed = [&] { return in.empty() ? 1.0 : c[std::size_t(in.back())]; };
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
