"""The record of one case of kind `cavity`: the exact state after N reflections, by unfolding the cube."""
import heapq

from gmpy2 import mpfr, mpq

from exact_numbers import sign
from json_fields import header, scalar_fields, upper_bound, vector_fields
from precision import unit


def bounce(origin, direction, bounces):
    """t of the last bounce and the number of bounces on each pair of walls."""
    walls = [((sign(d) - o) / d, axis) for axis, (o, d) in enumerate(zip(origin, direction))]
    heapq.heapify(walls)
    counts = [0, 0, 0]
    for _ in range(bounces):
        t, axis = heapq.heappop(walls)
        counts[axis] += 1
        heapq.heappush(walls, (t + 2 / abs(direction[axis]), axis))
    return t, counts


def folded(x):
    """An unfolded coordinate back in [−1, 1]: a triangle wave of period 4."""
    quarter = (x + 1) / 4
    phase = x + 1 - 4 * (quarter.numerator // quarter.denominator)
    return (phase if phase <= 2 else 4 - phase) - 1


def cavity_record(table, family, eps, seed, variant, rng):
    """One ray after N bounces."""
    bounces, origin, direction = table.inputs(family, eps, variant, rng)
    o, d = [mpq(x) for x in origin], [mpq(x) for x in direction]
    t, counts = bounce(o, d, bounces)
    position = [mpfr(folded(a + t * b)) for a, b in zip(o, d)]
    heading = [x * (-1) ** count for x, count in zip(d, counts)]
    return {**header("cavity", family, eps, seed), "N": bounces, **vector_fields("o", origin),
            **vector_fields("d", direction), "wall_counts": counts, **scalar_fields("t_total", mpfr(t)),
            **vector_fields("p_end", position), **vector_fields("d_end", heading),
            "p_tol64": upper_bound(unit() * (mpfr(bounces) + 1) * 4),
            "energy": "with reflectance R the throughput after N bounces is R**N; must never exceed 1"}
