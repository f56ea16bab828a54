"""The record of one case of kind `refr`: Snell's law and Fresnel's formulas, decided exactly."""
import gmpy2
from gmpy2 import mpfr, mpq

from json_fields import digits, header, hexadecimal, number, scalar_fields, upper_bound, vector_fields
from linear_algebra import dot
from precision import unit


class Boundary:
    """A ray at a boundary: exact cosine, sine and radicand, values to 1200 bits."""

    def __init__(self, direction, normal, c1, c2):
        d, n = [mpq(x) for x in direction], [mpq(x) for x in normal]
        self.speed_from, self.speed_to = mpq(c1), mpq(c2)
        along, dd, nn = dot(d, n), dot(d, d), dot(n, n)
        self.normal_along_ray = along > 0
        squared_cosine = along * along / (dd * nn)
        squared_sine = 1 - squared_cosine
        exact_eta = self.speed_to / self.speed_from
        self.radicand = 1 - exact_eta * exact_eta * squared_sine
        self.eta = mpfr(exact_eta)
        self.cosine = gmpy2.sqrt(mpfr(squared_cosine))
        self.direction = [mpfr(x) / gmpy2.sqrt(mpfr(dd)) for x in d]
        turn = -1 if self.normal_along_ray else 1
        self.facing = [turn * mpfr(x) / gmpy2.sqrt(mpfr(nn)) for x in n]
        sine = gmpy2.sqrt(mpfr(squared_sine))
        self.radicand_tolerance = (2 * self.eta ** 2 * (mpfr(squared_sine) + sine) + mpfr(1)) * unit()

    def reflected(self):
        """Unit mirrored direction."""
        return [d + 2 * self.cosine * n for d, n in zip(self.direction, self.facing)]

    def refracted(self):
        """Unit refracted direction; the radicand must not be negative."""
        along = self.eta * self.cosine - gmpy2.sqrt(mpfr(self.radicand))
        return [self.eta * d + along * n for d, n in zip(self.direction, self.facing)]

    def refracted_tolerance(self):
        """By the radicand's error through the square root, and by rounding."""
        k = mpfr(self.radicand)
        root = gmpy2.sqrt(k)
        if self.radicand < self.radicand_tolerance:
            by_root = gmpy2.sqrt(k + self.radicand_tolerance) - root
        else:
            by_root = self.radicand_tolerance / root
        return by_root + unit() * (1 + self.eta)

    def reflectances(self, radicand):
        """Fresnel's reflectance for s- and p-polarized light."""
        if radicand <= 0 or self.cosine == 0:
            return mpfr(1), mpfr(1)
        cosine_to = gmpy2.sqrt(radicand)
        c1, c2 = mpfr(self.speed_from), mpfr(self.speed_to)
        s = (c2 * self.cosine - c1 * cosine_to) / (c2 * self.cosine + c1 * cosine_to)
        p = (c1 * self.cosine - c2 * cosine_to) / (c1 * self.cosine + c2 * cosine_to)
        return s ** 2, p ** 2

    def reflectance_tolerance(self):
        """By the errors of the radicand and of the cosine, whose absolute error acts where the ray grazes."""
        k = mpfr(self.radicand)
        exact = self.reflectances(k)
        by_radicand = mpfr(0)
        for side in (1, -1):
            moved = self.reflectances(k + side * self.radicand_tolerance)
            by_radicand = max([by_radicand] + [abs(a - b) for a, b in zip(moved, exact)])
        error = unit() * (self.cosine + mpfr(1))
        ratio = mpfr(min(self.speed_from, self.speed_to) / max(self.speed_from, self.speed_to))
        slowest = max(self.cosine, mpfr(10) ** -300) + gmpy2.sqrt(max(k, mpfr(0))) * ratio + error
        return by_radicand + min(mpfr(1), 8 * error / slowest) + unit()


def refraction_record(table, family, eps, seed, variant, rng):
    """One ray at one boundary."""
    direction, normal, c1, c2 = table.inputs(family, eps, variant, rng)
    at = Boundary(direction, normal, c1, c2)
    k = mpfr(at.radicand)
    s, p = at.reflectances(k)
    record = {**header("refr", family, eps, seed),
              **vector_fields("d", direction), **vector_fields("n", normal),
              **scalar_fields("c1", c1), **scalar_fields("c2", c2), "inside": at.normal_along_ray,
              "tir": at.radicand < 0, "critical": at.radicand == 0,
              "decidable": bool(abs(k) > at.radicand_tolerance), **scalar_fields("k", k), "k_str": digits(k),
              "k_tol64": upper_bound(at.radicand_tolerance), "cos1": number(at.cosine),
              **vector_fields("reflect", at.reflected()), "Rs": number(s), "Rp": number(p),
              "R": number((s + p) / 2), "T": number(1 - (s + p) / 2), "R_hex": hexadecimal((s + p) / 2),
              "R_tol64": upper_bound(at.reflectance_tolerance())}
    if at.radicand < 0:
        return {**record, "refract": None}
    return {**record, **vector_fields("refract", at.refracted()),
            "refract_tol64": upper_bound(at.refracted_tolerance())}
