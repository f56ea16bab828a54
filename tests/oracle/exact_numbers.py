"""Numbers of the oracle: rationals and a + b·√D decide, 1200-bit floats give the values that are written."""
import gmpy2
from gmpy2 import mpfr, mpq

PRECISION = 1200
gmpy2.get_context().precision = PRECISION


class Surd:
    """rational + factor·√radicand, exact; `value` is the same to 1200 bits."""

    __slots__ = ("rational", "factor", "radicand", "value")

    def __init__(self, rational, factor=0, radicand=0):
        self.rational, self.factor, self.radicand = mpq(rational), mpq(factor), mpq(radicand)
        if self.factor == 0 or self.radicand == 0:
            self.factor = self.radicand = mpq(0)
        self.value = self._evaluated()

    def _evaluated(self):
        if not self.factor:
            return mpfr(self.rational)
        root = mpfr(self.factor) * gmpy2.sqrt(mpfr(self.radicand))
        if self.rational and (self.rational > 0) != (self.factor > 0):
            # The sum would cancel; its conjugate does not.
            norm = self.rational * self.rational - self.factor * self.factor * self.radicand
            return mpfr(norm) / (mpfr(self.rational) - root)
        return mpfr(self.rational) + root


class NumericRoot:
    """A root that is known to 1200 bits only (torus); roots closer than 2^-900 are the same."""

    __slots__ = ("value",)

    def __init__(self, value):
        self.value = value


class Unbounded:
    """An end at infinity."""

    __slots__ = ("value", "sign")

    def __init__(self, direction):
        self.sign = direction
        self.value = mpfr("inf") * direction


MINUS_INFINITY, PLUS_INFINITY = Unbounded(-1), Unbounded(1)
ZERO = Surd(0)


def sign(x):
    """-1, 0 or 1."""
    return (x > 0) - (x < 0)


def sign_with_root(a, b, radicand):
    """Sign of a + b·√radicand, by squaring."""
    of_a, of_b = sign(a), (sign(b) if radicand else 0)
    if of_a == 0 or of_b == 0 or of_a == of_b:
        return of_a or of_b
    return of_a * sign(a * a - b * b * radicand)


def compare_surds(x, y):
    """Sign of x - y = a + b·√D + c·√E, by squaring twice."""
    a, b, c = x.rational - y.rational, x.factor, -y.factor
    first = sign_with_root(a, b, x.radicand)
    second = sign(c) if y.radicand else 0
    if first == 0 or second == 0 or first == second:
        return first or second
    squares = a * a + b * b * x.radicand - c * c * y.radicand
    return first * sign_with_root(squares, 2 * a * b, x.radicand)


def compare(x, y):
    """Sign of x - y: exact for surds and infinities, to 2^-900 where a numeric root takes part."""
    if isinstance(x, Unbounded) or isinstance(y, Unbounded):
        return sign(getattr(x, "sign", 0) - getattr(y, "sign", 0))
    if isinstance(x, Surd) and isinstance(y, Surd):
        return compare_surds(x, y)
    difference = x.value - y.value
    if abs(difference) <= (abs(x.value) + abs(y.value) + mpfr(1)) * mpfr(2) ** -900:
        return 0
    return sign(difference)
