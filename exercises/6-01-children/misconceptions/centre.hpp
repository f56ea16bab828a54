unsigned children(const Box& cell, const Box& obj) {
    for (int i = 0; i < 3; ++i)
        if (obj.lo[i] > cell.hi[i] || obj.hi[i] < cell.lo[i]) return 0;
    unsigned child = 0;
    for (int i = 0; i < 3; ++i)
        if (obj.lo[i] + obj.hi[i] >= cell.lo[i] + cell.hi[i]) child |= 1U << unsigned(i);
    return 1U << child;
}
