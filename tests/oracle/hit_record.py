"""The record of one case of kind `hit`."""
from error_model import ObjectRay
from exact_numbers import ZERO, compare, sign
from json_fields import header, shape_fields, time_fields, upper_bound, vector_fields
from line_and_solid import intersect


def hit_record(table, family, eps, seed, variant, rng):
    """One line against one solid."""
    shape, matrix, origin, direction = table.inputs(family, eps, variant, rng)
    if all(x == 0 for x in direction):
        raise ValueError("the direction is zero")
    ray = ObjectRay(matrix, origin, direction)
    found = intersect(shape, ray)
    ahead = [k for k, hit in enumerate(found.hits) if compare(hit.t, ZERO) > 0]
    return {**header("hit", family, eps, seed), "shape": shape_fields(shape), **vector_fields("M", matrix),
            **vector_fields("o", origin), **vector_fields("d", direction), "det_sign": sign(ray.determinant),
            "origin": found.origin, "in_surface": found.in_surface, "decidable": found.decidable,
            "hits": [hit_fields(hit) for hit in found.hits],
            "intervals": [list(pair) for pair in found.intervals],
            "first_hit": ahead[0] if ahead else None}


def hit_fields(hit):
    """One hit with its normals and tolerances."""
    normals = [None if n is None else vector_fields("n", n) for n in hit.normals]
    return {**time_fields(hit.t), "mult": hit.multiplicity, "event": hit.event, "face": hit.faces,
            "normals": normals, "cond": upper_bound(hit.condition),
            "cond_bs": upper_bound(hit.componentwise_condition), "tol64": upper_bound(hit.tolerance),
            "cond_tight": upper_bound(hit.tight_condition), "tol64_tight": upper_bound(hit.tight_tolerance),
            "ntol64": upper_bound(hit.normal_tolerance)}
