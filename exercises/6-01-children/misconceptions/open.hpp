unsigned children(const Box& cell, const Box& obj) {
    std::array<std::array<bool, 2>, 3> meets{};
    for (int i = 0; i < 3; ++i) {
        const double middle = (cell.lo[i] + cell.hi[i]) / 2;
        meets[std::size_t(i)] = {obj.lo[i] < middle && obj.hi[i] > cell.lo[i],
                                 obj.lo[i] < cell.hi[i] && obj.hi[i] > middle};
    }
    unsigned mask = 0;
    for (unsigned i = 0; i < 8; ++i)
        if (meets[0][i & 1U] && meets[1][(i >> 1U) & 1U] && meets[2][i >> 2U]) mask |= 1U << i;
    return mask;
}
