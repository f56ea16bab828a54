"""Independent check of kind `csg`: by membership of points, leaf by leaf."""
import random

import mpmath as mp

from checks import Line, length, side_of, vector


def is_inside(case, leaves, t):
    """By the postfix program on the leaves' membership; None on a leaf's surface."""
    sides = [side_of(shape, line.at(t)) for shape, line in leaves]
    if 0 in sides:
        return None
    stack = []
    for token in case["rpn"]:
        if token == "~":
            stack.append(not stack.pop())
        elif token in ("&", "|", "-"):
            right, left = stack.pop(), stack.pop()
            stack.append((left and right) if token == "&" else (left or right) if token == "|"
                         else (left and not right))
        else:
            stack.append(sides[token] < 0)
    (result,) = stack
    return result


def sample_times(case, times):
    """Between all bounds, just before and after each, around them and at random."""
    reach = 3 / length(vector(case["d_hex"]))
    low, high = (times[0] - reach, times[-1] + reach) if times else (-4 * reach, 4 * reach)
    rng = random.Random(case["id"])
    samples = [low, high] + [(a + b) / 2 for a, b in zip(times, times[1:])]
    for t in times:
        step = mp.mpf(10) ** -45 * (1 + abs(t))
        samples += [t - step, t + step]
    count = 20 if len(case["rpn"]) < 2000 else 6
    return samples + [low + (high - low) * mp.mpf(rng.random()) for _ in range(count)]


def check_csg(case, log):
    """Bounds ascend, and the intervals hold the points that the program holds."""
    leaves = [(leaf["shape"], Line(case, leaf["M_hex"])) for leaf in case["leaves"]]
    times = [mp.mpf(bound["t_str"]) for bound in case["bounds"]]
    log.expect(all(a < b for a, b in zip(times, times[1:])), case, "order of bounds")
    for t in sample_times(case, times):
        inside = is_inside(case, leaves, t)
        if inside is None:
            continue
        listed = any((i is None or times[i] < t) and (j is None or t < times[j])
                     for i, j in case["intervals"])
        log.expect(inside == listed, case, "membership of the compound")
