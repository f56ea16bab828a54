"""Common ground of the independent checks: 120 digits, matrices solved, not inverted, a log of failures."""
import mpmath as mp

mp.mp.dps = DIGITS = 120
DIGITS_WITH_DENORMALS = 800


class Failures:
    """What was wrong, and in which cases."""

    def __init__(self):
        self.cases = {}

    def expect(self, condition, case, what):
        """Notes the case if the condition does not hold."""
        if not condition:
            self.cases.setdefault(what, []).append(case["id"])


def number(text):
    """A hex float, or inf."""
    return mp.mpf(text) if text in ("inf", "-inf") else mp.mpf(float.fromhex(text))


def vector(texts):
    """Hex floats."""
    return [number(text) for text in texts]


def dot(a, b):
    """a·b."""
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    """a × b."""
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def length(a):
    """|a|."""
    return mp.sqrt(dot(a, a))


class Line:
    """A case's world line, moved into the space of a matrix by solving for it."""

    def __init__(self, case, matrix_texts):
        elements = vector(matrix_texts)
        self.linear = mp.matrix([elements[0:3], elements[4:7], elements[8:11]])
        translation = mp.matrix([elements[3], elements[7], elements[11]])
        origin, direction = mp.matrix(vector(case["o_hex"])), mp.matrix(vector(case["d_hex"]))
        has_denormals = any(0 < abs(x) < mp.mpf(10) ** -60 for x in direction)
        mp.mp.dps = DIGITS_WITH_DENORMALS
        self.origin = list(mp.lu_solve(self.linear, origin - translation))
        self.direction = list(mp.lu_solve(self.linear, direction))
        mp.mp.dps = DIGITS_WITH_DENORMALS if has_denormals else DIGITS

    def at(self, t):
        """The object-space point at t."""
        return [o + t * d for o, d in zip(self.origin, self.direction)]


def distances(shape, p):
    """All negative inside a shape; the torus in another form than the generator's quartic."""
    x, y, z = p
    if shape["type"] == "sphere":
        return [dot(p, p) - 1]
    if shape["type"] == "plane":
        return [z]
    if shape["type"] == "cylinder":
        return [x * x + y * y - 1, abs(z) - 1]
    if shape["type"] == "cone":
        return [x * x + y * y - ((1 - z) / 2) ** 2, abs(z) - 1]
    if shape["type"] == "cube":
        return [max(abs(x), abs(y), abs(z)) - 1]
    minor = number(shape["r_hex"])
    return [(mp.sqrt(x * x + y * y) - 1) ** 2 + z * z - minor * minor]


def side_of(shape, p):
    """-1 inside, 0 on the surface, 1 outside."""
    worst, nothing = max(distances(shape, p)), mp.mpf(10) ** (30 - mp.mp.dps)
    return 0 if abs(worst) <= nothing else -1 if worst < 0 else 1
