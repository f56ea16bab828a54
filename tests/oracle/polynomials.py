"""Polynomials with rational coefficients, lowest power first: their distinct real roots, counted exactly."""
import functools

import mpmath
from gmpy2 import mpfr, mpq

from exact_numbers import PRECISION, NumericRoot, Surd, compare, sign


def trimmed(p):
    """Without leading zeros; the zero polynomial is []."""
    p = list(p)
    while p and p[-1] == 0:
        p.pop()
    return p


def derivative(p):
    """dp/dt."""
    return trimmed([i * p[i] for i in range(1, len(p))])


def difference(a, b):
    """a - b."""
    length = max(len(a), len(b))
    padded = [list(p) + [mpq(0)] * (length - len(p)) for p in (a, b)]
    return trimmed([x - y for x, y in zip(*padded)])


def divided(dividend, divisor):
    """Quotient and remainder."""
    remainder = trimmed(dividend)
    quotient = [mpq(0)] * max(1, len(remainder) - len(divisor) + 1)
    while len(remainder) >= len(divisor):
        shift = len(remainder) - len(divisor)
        factor = remainder[-1] / divisor[-1]
        quotient[shift] = factor
        for i, coefficient in enumerate(divisor):
            remainder[i + shift] -= factor * coefficient
        remainder = trimmed(remainder)
    return trimmed(quotient), remainder


def monic(p):
    """Divided by its leading coefficient."""
    return [x / p[-1] for x in p]


def greatest_common_divisor(a, b):
    """Monic."""
    a, b = trimmed(a), trimmed(b)
    while b:
        a, b = b, divided(a, b)[1]
    return monic(a) if a else a


def square_free(p):
    """Yun's algorithm: [(factor, multiplicity)], every factor with simple roots only."""
    p = trimmed(p)
    factors = []
    if len(p) <= 1:
        return factors
    common = greatest_common_divisor(p, derivative(p))
    b = divided(p, common)[0]
    d = difference(divided(derivative(p), common)[0], derivative(b))
    multiplicity = 1
    while len(b) > 1:
        factor = greatest_common_divisor(b, d) if d else monic(b)
        if len(factor) > 1:
            factors.append((factor, multiplicity))
        b = divided(b, factor)[0]
        c = divided(d, factor)[0] if d else []
        d = difference(c, derivative(b))
        multiplicity += 1
    return factors


def count_real_roots(p):
    """Distinct real roots of p, by Sturm's chain: exact."""
    chain = [trimmed(p), derivative(p)]
    while chain[-1]:
        chain.append([-x for x in divided(chain[-2], chain[-1])[1]])
    chain.pop()

    def sign_changes(end):
        signs = [sign(q[-1]) * (1 if end > 0 or len(q) % 2 == 1 else -1) for q in chain]
        return sum(1 for a, b in zip(signs, signs[1:]) if a != b)

    return sign_changes(-1) - sign_changes(1)


def numeric_roots(p):
    """All complex roots of a square-free polynomial as (real, imaginary), to 1200 bits."""
    mpmath.mp.prec = PRECISION
    coefficients = [mpmath.mpf(int(x.numerator)) / mpmath.mpf(int(x.denominator)) for x in p]
    found = mpmath.polyroots(coefficients[::-1], maxsteps=400, extraprec=1200)

    def converted(x):
        return mpfr(mpmath.nstr(x, 370, strip_zeros=False, min_fixed=1, max_fixed=0))

    return [(converted(mpmath.re(root)), converted(mpmath.im(root))) for root in found]


def roots_of_factor(p, count):
    """The `count` real roots of a square-free polynomial, in any order."""
    if len(p) == 2:
        return [Surd(-p[0] / p[1])]
    if len(p) == 3:
        a, b, c = p[2], p[1] / 2, p[0]
        radicand = b * b - a * c
        return [Surd(-b / a, -1 / a, radicand), Surd(-b / a, 1 / a, radicand)]
    roots = sorted(numeric_roots(p), key=lambda root: abs(root[1]))
    scale = max(abs(root[0]) for root in roots)
    if max(abs(root[1]) for root in roots[:count]) > scale * mpfr(10) ** -150:
        raise ArithmeticError("a real root of Sturm's count is missing")
    if count < len(roots) and abs(roots[count][1]) < scale * mpfr(10) ** -140:
        raise ArithmeticError("a complex pair can't be told from a real root")
    return [NumericRoot(root[0]) for root in roots[:count]]


def real_roots(p):
    """[(root, multiplicity)], ascending."""
    roots = []
    for factor, multiplicity in square_free(p):
        count = count_real_roots(factor)
        if count:
            roots += [(root, multiplicity) for root in roots_of_factor(factor, count)]
    return sorted(roots, key=functools.cmp_to_key(lambda a, b: compare(a[0], b[0])))


def value_at(p, t):
    """p(t) to 1200 bits."""
    total = mpfr(0)
    for coefficient in reversed(p):
        total = total * t + mpfr(coefficient)
    return total


def taylor_coefficients(p, t):
    """p(t + h) as coefficients of h, by repeated synthetic division."""
    coefficients = []
    rest = list(p)
    while rest:
        total = mpfr(0)
        partial = []
        for coefficient in reversed(rest):
            total = total * t + coefficient
            partial.append(total)
        coefficients.append(total)
        rest = list(reversed(partial[:-1]))
    return coefficients
