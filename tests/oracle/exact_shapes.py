"""The shapes as sets of faces: a point is inside where every face's function F is not positive."""
from dataclasses import dataclass
from typing import Callable

from gmpy2 import mpfr, mpq

from linear_algebra import dot

NO_CURVATURE = [[0, 0, 0], [0, 0, 0], [0, 0, 0]]


@dataclass
class Face:
    """F of one face, along one object-space ray and in space."""

    label: str
    along_ray: list  # F(origin + t·direction) as a polynomial in t, lowest power first
    gradient: Callable  # of F at a point
    hessian: list  # of F; for the torus a bound of its elements near the solid
    is_curved: bool


def flat_face(label, axis, side, offset, o, d):
    """The plane side·p[axis] = offset, outward normal along side."""
    normal = [mpq(0)] * 3
    normal[axis] = mpq(side)
    return Face(label, [side * o[axis] - offset, side * d[axis]], lambda p: normal, NO_CURVATURE, False)


def diagonal(x, y, z):
    """A diagonal Hessian."""
    return [[x, 0, 0], [0, y, 0], [0, 0, z]]


def sphere(o, d):
    """x² + y² + z² = 1."""
    along_ray = [dot(o, o) - 1, 2 * dot(o, d), dot(d, d)]
    return [Face("side", along_ray, lambda p: [2 * x for x in p], diagonal(2, 2, 2), True)]


def plane(o, d):
    """The half space z ≤ 0."""
    return [flat_face("plane", 2, 1, 0, o, d)]


def cylinder(o, d):
    """x² + y² ≤ 1, |z| ≤ 1."""
    along_ray = [o[0] ** 2 + o[1] ** 2 - 1, 2 * dot(o[:2], d[:2]), d[0] ** 2 + d[1] ** 2]
    side = Face("side", along_ray, lambda p: [2 * p[0], 2 * p[1], 0 * p[0]], diagonal(2, 2, 0), True)
    return [side, flat_face("cap+", 2, 1, 1, o, d), flat_face("cap-", 2, -1, 1, o, d)]


def cone(o, d):
    """x² + y² ≤ ((1 − z)/2)², −1 ≤ z ≤ 1. The plane of the apex only cuts the other nappe off."""
    radius, slope = (1 - o[2]) / 2, -d[2] / 2
    along_ray = [o[0] ** 2 + o[1] ** 2 - radius ** 2, 2 * (o[0] * d[0] + o[1] * d[1] - radius * slope),
                 d[0] ** 2 + d[1] ** 2 - slope ** 2]
    side = Face("side", along_ray, lambda p: [2 * p[0], 2 * p[1], (1 - p[2]) / 2],
                diagonal(2, 2, mpq(1, 2)), True)
    return [side, flat_face("apex", 2, 1, 1, o, d), flat_face("cap-", 2, -1, 1, o, d)]


def cube(o, d):
    """[−1, 1]³."""
    return [flat_face(sign + name, axis, side, 1, o, d)
            for axis, name in enumerate("xyz") for sign, side in (("+", 1), ("-", -1))]


def torus(minor_radius, o, d):
    """(|p|² + 1 − r²)² = 4(x² + y²)."""
    offset = 1 - minor_radius * minor_radius
    a, b, c = dot(d, d), 2 * dot(o, d), dot(o, o) + offset
    ring_a, ring_b, ring_c = dot(d[:2], d[:2]), 2 * dot(o[:2], d[:2]), dot(o[:2], o[:2])

    def gradient(p):
        s = p[0] * p[0] + p[1] * p[1] + p[2] * p[2] + mpfr(offset)
        return [4 * p[0] * s - 8 * p[0], 4 * p[1] * s - 8 * p[1], 4 * p[2] * s]

    along_ray = [c * c - 4 * ring_c, 2 * b * c - 4 * ring_b, b * b + 2 * a * c - 4 * ring_a, 2 * a * b, a * a]
    return [Face("torus", along_ray, gradient, [[8, 8, 8], [8, 8, 8], [8, 8, 8]], True)]


def faces_along(shape, o, d):
    """The faces of a shape (a dict with `type`, and `r` for the torus) along an exact object-space ray."""
    if shape["type"] == "torus":
        return torus(mpq(shape["r"]), o, d)
    convex = {"sphere": sphere, "plane": plane, "cylinder": cylinder, "cone": cone, "cube": cube}
    return convex[shape["type"]](o, d)
