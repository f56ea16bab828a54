"""Independent check of kind `hit`: order, points on the surface, normals, membership along the line."""
import random

import mpmath as mp

from checks import Line, cross, distances, dot, length, number, side_of, vector


def check_hit(case, log):
    """All of it."""
    line = Line(case, case["M_hex"])
    times = [mp.mpf(hit["t_str"]) for hit in case["hits"]]
    log.expect(all(a < b for a, b in zip(times, times[1:])), case, "order")
    for hit, t in zip(case["hits"], times):
        check_time(case, hit, t, log)
        check_on_surface(case, line, t, log)
        for normal, face in zip(hit["normals"], hit["face"]):
            if normal is not None:
                check_normal(case, hit, face, vector(normal["n_hex"]), line, t, log)
    check_membership(case, line, times, log)
    where = {-1: "inside", 0: "on", 1: "outside"}[side_of(case["shape"], line.at(mp.mpf(0)))]
    log.expect(case["origin"] == where, case, "where the origin lies")


def check_time(case, hit, t, log):
    """The double is the nearest one, the low part is the rest."""
    rest = t - number(hit["t_hex"])
    half_unit = abs(t) * mp.mpf(2) ** -53 * (1 + mp.mpf(10) ** -6) + mp.mpf(2) ** -1075
    log.expect(abs(rest) <= half_unit, case, "rounding")
    rest -= number(hit["t_lo_hex"])
    log.expect(abs(rest) <= abs(t) * mp.mpf(2) ** -104 + mp.mpf(2) ** -1074, case, "low part")


def check_on_surface(case, line, t, log):
    """F vanishes at the hit."""
    value = distances(case["shape"], line.at(t))
    nearest = min(abs(x) for x in value)
    if case["shape"]["type"] in ("cylinder", "cone"):
        nearest = abs(max(value))
    scale = 1 + length(line.origin) + abs(t) * length(line.direction)
    log.expect(nearest < mp.mpf(10) ** -40 * scale, case, "not on the surface")


def gradient(shape, face, p):
    """Outward, of any length: known for flat faces, by central differences for curved ones."""
    if face in ("side", "torus"):
        step = mp.mpf(10) ** -50

        def moved(axis, by):
            return distances(shape, [x + (by if k == axis else 0) for k, x in enumerate(p)])[0]

        return [(moved(axis, step) - moved(axis, -step)) / (2 * step) for axis in range(3)]
    axis = 2 if face == "plane" or face.startswith("cap") else "xyz".index(face[1])
    result = [mp.mpf(0)] * 3
    result[axis] = mp.mpf(-1 if "-" in face else 1)
    return result


def check_normal(case, hit, face, normal, line, t, log):
    """Unit; Mᵀn is parallel to the gradient and points outward; it stands against entering rays."""
    log.expect(abs(length(normal) - 1) < 4e-16, case, "length of normal")
    outward = gradient(case["shape"], face, line.at(t))
    pulled = [sum(line.linear[k, i] * normal[k] for k in range(3)) for i in range(3)]
    scale = mp.sqrt(sum(x * x for x in line.linear)) * length(outward)
    log.expect(length(cross(pulled, outward)) <= scale * 1e-14, case, "direction of normal")
    log.expect(dot(pulled, outward) >= -scale * 1e-15, case, "normal points inward")
    direction = vector(case["d_hex"])
    along = dot(normal, direction)
    slack = length(direction) * 1e-15
    log.expect(hit["event"] != "enter" or along <= slack, case, "entering, with the normal")
    log.expect(hit["event"] != "exit" or along >= -slack, case, "leaving, against the normal")


def sample_times(case, line, times):
    """Between and around all hits, at random, densely near the shape: a root that is missing shows up."""
    speed = length(line.direction)
    reach = 10 / speed
    closest = -dot(line.origin, line.direction) / speed ** 2
    samples = [closest + k * mp.mpf("2.3") / 60 / speed for k in range(-60, 61)]
    if not times:
        return samples + [closest + k * reach / 60 for k in range(-20, 21)]
    samples += [(a + b) / 2 for a, b in zip(times, times[1:])]
    samples += [times[0] - reach - abs(times[0]) / 1000, times[-1] + reach + abs(times[-1]) / 1000]
    rng = random.Random(case["id"])
    width = times[-1] - times[0] + reach
    return samples + [times[0] - reach / 4 + width * mp.mpf(rng.random()) for _ in range(24)]


def check_membership(case, line, times, log):
    """The implicit function and the intervals say the same."""

    def is_member(t):
        return any((i is None or times[i] <= t) and (j is None or t <= times[j])
                   for i, j in case["intervals"])

    for t in sample_times(case, line, times):
        side = side_of(case["shape"], line.at(t))
        if side:
            log.expect((side < 0) == is_member(t), case, "membership")
        else:
            log.expect(case["in_surface"] or t in times, case, "a boundary that is no hit")
