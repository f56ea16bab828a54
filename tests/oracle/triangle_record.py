"""The record of one case of kind `tri`."""
import gmpy2
from gmpy2 import mpfr, mpq

from error_model import ObjectRay
from exact_numbers import Surd
from json_fields import header, hexadecimal, time_fields, upper_bound, vector_fields
from linear_algebra import add, cross, dot, subtract
from precision import unit


def length(vector):
    """|v| of an exact vector, to 1200 bits."""
    return gmpy2.sqrt(mpfr(dot(vector, vector)))


def barycentric(corners, normal, point):
    """Exact weights of the corners at a point of their plane."""
    weights = []
    for k in range(3):
        start, end = corners[(k + 1) % 3], corners[(k + 2) % 3]
        weights.append(dot(normal, cross(subtract(end, start), subtract(point, start))) / dot(normal, normal))
    return weights


def status_of(weights):
    """Where a point of the plane lies."""
    if any(x < 0 for x in weights):
        return "outside"
    return ("interior", "edge", "vertex")[weights.count(0)]


def triangle_fields(triangle, ray):
    """One triangle: where the line meets its plane, and how sure that is."""
    corners = [[mpq(x) for x in corner] for corner in triangle]
    edges = [subtract(corners[i], corners[k]) for i, k in ((1, 0), (2, 0), (2, 1))]
    normal = cross(edges[0], edges[1])
    determinant = dot(normal, ray.direction)
    offset = dot(normal, subtract(corners[0], ray.origin))
    fields = {"v": triangle, "v_hex": [[hexadecimal(x) for x in corner] for corner in triangle]}
    if determinant == 0:
        return {**fields, "status": "coplanar" if offset == 0 else "parallel"}
    t = offset / determinant
    weights = barycentric(corners, normal, add(ray.origin, ray.direction, t))

    size_of_corners = [max(abs(mpfr(corner[axis])) for corner in corners) for axis in range(3)]
    error = add(ray.loose_error(mpfr(t)), size_of_corners, 1)
    condition = dot([abs(mpfr(x)) for x in normal], error) / abs(mpfr(determinant))
    least_height = length(normal) / max(length(edge) for edge in edges)
    obliqueness = length(ray.direction) * length(normal) / abs(mpfr(determinant))
    tolerance = gmpy2.sqrt(dot(error, error)) * unit() * (1 + obliqueness) / least_height
    return {**fields, "status": status_of(weights), **time_fields(Surd(t)), "w": [float(x) for x in weights],
            "cond": upper_bound(condition), "tol64": upper_bound(condition * unit()),
            "decidable": bool(min(abs(mpfr(x)) for x in weights) > tolerance),
            "w_tol64": upper_bound(tolerance)}


def triangle_record(table, family, eps, seed, variant, rng):
    """One line against one or more triangles."""
    triangles, matrix, origin, direction = table.inputs(family, eps, variant, rng)
    ray = ObjectRay(matrix, origin, direction)
    rows = [triangle_fields(triangle, ray) for triangle in triangles]
    must_hit = any(row["status"] in ("interior", "edge", "vertex") for row in rows)
    return {**header("tri", family, eps, seed), "tris": rows, **vector_fields("M", matrix),
            **vector_fields("o", origin), **vector_fields("d", direction), "must_hit": must_hit}
