"""The record of one case of kind `oct`: the cells that a ray passes, in order."""
import itertools

from gmpy2 import mpfr, mpq

from json_fields import header, number, scalar_fields, vector_fields


def clipped(origin, direction):
    """Exact range of t ≥ 0 in [−1, 1]³; low > high if there is none."""
    low, high = mpq(0), None
    for o, d in zip(origin, direction):
        if d == 0:
            if not -1 <= o <= 1:
                return mpq(0), mpq(-1)
            continue
        near, far = sorted(((-1 - o) / d, (1 - o) / d))
        low = max(low, near)
        high = far if high is None else min(high, far)
    return low, high


def cell_plane_times(origin, direction, cells):
    """All t at which the line crosses a plane between cells."""
    return {(-1 + mpq(2 * k, cells) - o) / d
            for o, d in zip(origin, direction) if d != 0 for k in range(cells + 1)}


def indices_at(x, cells):
    """Index of the cell that holds a coordinate; two where it lies between cells."""
    position = (x + 1) * cells / 2
    floor = position.numerator // position.denominator
    options = [int(min(max(floor, 0), cells - 1))]
    if position == floor and 0 < floor < cells:
        options.append(int(floor - 1))
    return options


def segment_fields(start, end, origin, direction, cells):
    """The part of the ray between two cell planes, with every cell that it may be counted to."""
    middle = (start + end) / 2
    options = [indices_at(o + middle * d, cells) for o, d in zip(origin, direction)]
    return {**scalar_fields("t0", mpfr(start)), **scalar_fields("t1", mpfr(end)),
            "cell": [axis[0] for axis in options],
            "alt": [list(cell) for cell in itertools.product(*options)],
            "len": number(mpfr(end - start))}


def octree_record(table, family, eps, seed, variant, rng):
    """One ray through one grid."""
    depth, origin, direction = table.inputs(family, eps, variant, rng)
    cells = 2 ** depth
    o, d = [mpq(x) for x in origin], [mpq(x) for x in direction]
    low, high = clipped(o, d)
    segments = []
    if low < high:
        times = [low] + sorted(t for t in cell_plane_times(o, d, cells) if low < t < high) + [high]
        segments = [segment_fields(a, b, o, d, cells) for a, b in zip(times, times[1:])]
    return {**header("oct", family, eps, seed), "depth": depth, **vector_fields("o", origin),
            **vector_fields("d", direction), "touch_only": low == high, "segments": segments}
