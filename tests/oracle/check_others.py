"""Independent checks of the kinds `refr`, `tri`, `oct` and `cavity`."""
import mpmath as mp

from checks import Line, cross, dot, length, number, vector

ROUNDING = mp.mpf(10) ** -15


def check_refraction(case, log):
    """Snell by sines of cross products; lengths, planes and sides of the new directions; energy."""
    d, n = vector(case["d_hex"]), vector(case["n_hex"])
    d, n = [x / length(d) for x in d], [x / length(n) for x in n]
    c1, c2 = number(case["c1_hex"]), number(case["c2_hex"])
    sine = length(cross(d, n))
    sine_to = sine * c2 / c1
    if abs(sine_to - 1) > mp.mpf(10) ** -60:
        log.expect(case["tir"] == (sine_to > 1), case, "total internal reflection")
    log.expect(case["critical"] == (abs(sine_to - 1) < mp.mpf(10) ** -100), case, "critical")

    mirrored = vector(case["reflect_hex"])
    log.expect(abs(length(mirrored) - 1) <= ROUNDING, case, "length of mirrored direction")
    log.expect(abs(dot(mirrored, n) + dot(d, n)) <= ROUNDING, case, "angle of mirrored direction")
    change = [a - b for a, b in zip(mirrored, d)]
    log.expect(length(cross(change, n)) <= 3 * ROUNDING, case, "plane of mirrored direction")
    log.expect(abs(case["R"] + case["T"] - 1) <= 3e-16 and 0 <= case["R"] <= 1, case, "energy")
    if case["refract"] is None:
        return
    bent = vector(case["refract_hex"])
    log.expect(abs(length(bent) - 1) <= ROUNDING, case, "length of refracted direction")
    log.expect(abs(length(cross(bent, n)) - sine_to) <= ROUNDING, case, "Snell")
    log.expect(dot(bent, n) * dot(d, n) >= 0, case, "side of refracted direction")
    log.expect(length(cross(cross(d, n), cross(bent, n))) <= ROUNDING, case, "plane of refracted direction")
    check_fresnel(case, sine, sine_to, c1 - c2, log)


def check_fresnel(case, sine, sine_to, speed_difference, log):
    """By the angles' sines and tangents, where these don't cancel."""
    theta, theta_to = mp.asin(min(sine, 1)), mp.asin(min(sine_to, 1))
    grazes = theta >= mp.pi / 2 - mp.mpf(10) ** -18
    if sine <= mp.mpf(10) ** -12 or abs(speed_difference) <= 1e-9 or grazes:
        return
    s = (mp.sin(theta - theta_to) / mp.sin(theta + theta_to)) ** 2
    p = (mp.tan(theta - theta_to) / mp.tan(theta + theta_to)) ** 2
    log.expect(abs(s - case["Rs"]) <= 1e-14 and abs(p - case["Rp"]) <= 1e-14, case, "Fresnel")


def check_triangles(case, log):
    """t and the weights as solutions of one linear system."""
    line = Line(case, case["M_hex"])
    tiny = mp.mpf(10) ** -60
    for triangle in case["tris"]:
        a, b, c = [vector(corner) for corner in triangle["v_hex"]]
        system = mp.matrix([[b[k] - a[k], c[k] - a[k], -line.direction[k]] for k in range(3)])
        if triangle["status"] in ("coplanar", "parallel"):
            log.expect(abs(mp.det(system)) <= tiny, case, "parallel triangle")
            continue
        u, v, t = mp.lu_solve(system, mp.matrix([o - x for o, x in zip(line.origin, a)]))
        error = abs(t - mp.mpf(triangle["t_str"]))
        log.expect(error <= mp.mpf(10) ** -50 * (1 + abs(t)), case, "t of triangle")
        weights = (1 - u - v, u, v)
        zeros = sum(1 for w in weights if abs(w) < tiny)
        status = "outside" if min(weights) < -tiny else ("interior", "edge", "vertex")[zeros]
        log.expect(status == triangle["status"], case, "status of triangle")


def check_octree(case, log):
    """Segments join, lie in their cells, and fill the ray's part in the box."""
    o, d, cells = vector(case["o_hex"]), vector(case["d_hex"]), 2 ** case["depth"]
    segments = [(number(s["t0_hex"]), number(s["t1_hex"]), s["alt"]) for s in case["segments"]]
    log.expect(all(a[1] == b[0] for a, b in zip(segments, segments[1:])), case, "gap between segments")
    for start, end, options in segments:
        if end - start <= 1e-12 * (1 + abs(start)):
            continue
        middle = [a + (start + end) / 2 * b for a, b in zip(o, d)]
        log.expect(all(-1e-14 <= x + 1 - mp.mpf(2 * k) / cells <= mp.mpf(2) / cells + mp.mpf(10) ** -14
                       for cell in options for x, k in zip(middle, cell)), case, "cell")
    low, high = mp.mpf(0), mp.mpf("inf")
    for a, b in zip(o, d):
        if b == 0:
            high = high if abs(a) <= 1 else mp.mpf("-inf")
            continue
        near, far = sorted([(-1 - a) / b, (1 - a) / b])
        low, high = max(low, near), min(high, far)
    log.expect((high > low) == bool(segments), case, "box hit")
    if segments and high > low:
        log.expect(abs(segments[0][0] - low) <= 1e-15 * (1 + low) and
                   abs(segments[-1][1] - high) <= 1e-15 * (1 + high), case, "range in the box")


def check_cavity(case, log):
    """One wall after the other instead of unfolding."""
    position, direction = vector(case["o_hex"]), vector(case["d_hex"])
    for _ in range(case["N"]):
        t, axis = min((((1 if d > 0 else -1) - p) / d, k)
                      for k, (p, d) in enumerate(zip(position, direction)))
        position = [p + t * d for p, d in zip(position, direction)]
        position[axis] = mp.mpf(1 if direction[axis] > 0 else -1)
        direction[axis] = -direction[axis]
    log.expect(max(abs(a - b) for a, b in zip(position, vector(case["p_end_hex"]))) <= 1e-15 and
               direction == vector(case["d_end_hex"]), case, "state after the bounces")
