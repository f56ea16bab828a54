"""A whole line against one closed solid: every hit with its multiplicity, normals and tolerances."""
from dataclasses import dataclass

import gmpy2
from gmpy2 import mpfr, mpq

from error_model import displacement, normal_error, shift_of_face
from exact_numbers import MINUS_INFINITY, PLUS_INFINITY, Surd, Unbounded, compare, sign
from exact_shapes import faces_along
from linear_algebra import dot, to_floats, transform, transposed
from polynomials import derivative, real_roots, value_at


@dataclass
class Hit:
    """One point where the line meets the boundary. Tolerances and conditions are the worst of its faces'."""

    t: object
    faces: list  # labels of all faces that meet there
    event: str  # enter, exit or touch
    multiplicity: int
    normals: list  # unit outward world normal of each face; None at the apex
    condition: object
    componentwise_condition: object
    tight_condition: object
    tolerance: object
    tight_tolerance: object
    normal_tolerance: object
    stays_real: bool


@dataclass
class Intersection:
    """What the oracle knows of one line and one solid."""

    hits: list
    intervals: list  # pairs of indices into hits; None is unbounded, (k, k) a point
    decidable: bool  # the topology survives the perturbation of the error model
    origin: str  # inside, on or outside
    in_surface: bool


def describe_hit(faces, ray, t, event, multiplicity):
    """The hit at t where `faces` meet."""
    value = t.value
    point = ray.at(value)
    rows = [describe_face(face, ray, value, point) for face in faces]
    worst = {key: max(row[key] for row in rows) for key in rows[0] if key not in ("normal", "stays_real")}
    return Hit(t=t, faces=[face.label for face in faces], event=event, multiplicity=multiplicity,
               normals=[row["normal"] for row in rows],
               stays_real=all(row["stays_real"] for row in rows), **worst)


def describe_face(face, ray, t, point):
    """One face's share of a hit: conditions, tolerances, normal."""
    gradient = to_floats(face.gradient(point))
    size = [abs(x) for x in gradient]
    speed = abs(dot(gradient, ray.direction_value))

    def condition(error):
        return dot(size, error) / speed if speed > 0 else mpfr("inf")

    tolerance, stays_real = displacement(face.along_ray, t, shift_of_face(face, ray, t))
    tight_tolerance, _ = displacement(face.along_ray, t, shift_of_face(face, ray, t, tight=True))
    normal, normal_tolerance = world_normal(face, ray, t, gradient, tolerance)
    return {"normal": normal, "stays_real": stays_real, "condition": condition(ray.loose_error(t)),
            "componentwise_condition": condition(ray.componentwise_error(t, point)),
            "tight_condition": condition(ray.tight_error(t)), "tolerance": tolerance,
            "tight_tolerance": tight_tolerance, "normal_tolerance": normal_tolerance}


def world_normal(face, ray, t, gradient, tolerance):
    """Unit outward normal M⁻ᵀ∇F and its tolerance; None and infinity where there is no normal."""
    normal = transform([to_floats(row) for row in transposed(ray.inverse)], gradient)
    length = gmpy2.sqrt(dot(normal, normal))
    if length == 0 or face.label == "apex" or (face.is_curved and length < mpfr(10) ** -200):
        return None, mpfr("inf")
    return [x / length for x in normal], normal_error(face, ray, t, tolerance, length)


def not_positive(polynomial):
    """{t : polynomial(t) ≤ 0} for degree ≤ 2, as exact intervals."""
    c, b, a = (list(polynomial) + [mpq(0)] * 2)[:3]
    if a == 0:
        if b == 0:
            return [(MINUS_INFINITY, PLUS_INFINITY)] if c <= 0 else []
        root = Surd(-c / b)
        return [(MINUS_INFINITY, root)] if b > 0 else [(root, PLUS_INFINITY)]
    half = b / 2
    radicand = half * half - a * c
    if a > 0:
        if radicand < 0:
            return []
        return [(Surd(-half / a, -1 / a, radicand), Surd(-half / a, 1 / a, radicand))]
    if radicand <= 0:
        return [(MINUS_INFINITY, PLUS_INFINITY)]
    low, high = Surd(-half / a, 1 / a, radicand), Surd(-half / a, -1 / a, radicand)
    return [(MINUS_INFINITY, low), (high, PLUS_INFINITY)]


def clipped_end(end, faces, candidate, face, outward):
    """The inner one of two interval ends, with all faces that meet there."""
    order = outward * compare(candidate, end)
    if order < 0:
        return candidate, [face]
    if order == 0 and not isinstance(candidate, Unbounded):
        return end, faces + [face]
    return end, faces


def convex_intervals(faces, shifts=None):
    """Where all F ≤ shift: [(low, its faces, high, its faces)], faces as indices, touching pieces merged."""
    pieces = [(MINUS_INFINITY, [], PLUS_INFINITY, [])]
    for j, face in enumerate(faces):
        polynomial = list(face.along_ray)
        if shifts is not None:
            polynomial[0] -= shifts[j]
        clipped = []
        for low, low_faces, high, high_faces in pieces:
            for start, end in not_positive(polynomial):
                new_low = clipped_end(low, low_faces, start, j, -1)
                new_high = clipped_end(high, high_faces, end, j, 1)
                if compare(new_low[0], new_high[0]) <= 0:
                    clipped.append(new_low + new_high)
        pieces = clipped
    merged = []
    for piece in pieces:
        if merged and compare(merged[-1][2], piece[0]) >= 0:
            merged[-1] = merged[-1][:2] + piece[2:]
        else:
            merged.append(piece)
    return merged


def intersect_torus(faces, ray):
    """Hits, intervals and decidability: roots of the quartic, by multiplicity."""
    quartic = faces[0].along_ray
    hits, intervals = [], []
    start = None
    for t, multiplicity in real_roots(quartic):
        crosses = multiplicity % 2 == 1
        event = "touch" if not crosses else "enter" if start is None else "exit"
        hits.append(describe_hit(faces, ray, t, event, multiplicity))
        if event == "exit":
            intervals.append((start, len(hits) - 1))
            start = None
        elif event == "enter":
            start = len(hits) - 1
    extrema = [root.value for root, _ in real_roots(derivative(quartic))]
    decidable = all(hit.stays_real for hit in hits) and all(
        abs(value_at(quartic, t)) > shift_of_face(faces[0], ray, t) for t in extrema)
    return hits, intervals, decidable


def intersect_convex(faces, ray):
    """Hits, intervals and decidability: the faces' intervals, intersected."""
    hits, intervals = [], []
    exact = convex_intervals(faces)
    for low, low_faces, high, high_faces in exact:
        if compare(low, high) == 0:
            meeting = [faces[j] for j in sorted(set(low_faces + high_faces))]
            hits.append(describe_hit(meeting, ray, low, "touch", 2))
            intervals.append((len(hits) - 1, len(hits) - 1))
            continue
        ends = [None, None]
        for k, (t, meeting, event) in enumerate(((low, low_faces, "enter"), (high, high_faces, "exit"))):
            if not isinstance(t, Unbounded):
                hits.append(describe_hit([faces[j] for j in meeting], ray, t, event, 1))
                ends[k] = len(hits) - 1
        intervals.append(tuple(ends))
    return hits, intervals, topology_is_stable(faces, ray, exact, [hit.t.value for hit in hits])


def topology_is_stable(faces, ray, exact, times):
    """True if growing and shrinking every face by its error leaves hit or miss as it is."""
    if times:
        middle = sum(times) / len(times)
    else:
        middle = mpfr(-dot(ray.origin, ray.direction) / dot(ray.direction, ray.direction))
    shifts = [mpq(max(shift_of_face(face, ray, t) for t in [middle] + times)) for face in faces]

    def has_length(pieces):
        return any(compare(piece[0], piece[2]) < 0 for piece in pieces)

    shrunk = has_length(convex_intervals(faces, [-x for x in shifts]))
    return bool(convex_intervals(faces, shifts)) == shrunk and has_length(exact) == shrunk


def where_origin_lies(faces):
    """inside, on or outside: the worst sign of all faces at t = 0."""
    return {1: "outside", 0: "on", -1: "inside"}[max(sign(face.along_ray[0]) for face in faces)]


def intersect(shape, ray):
    """The line of an ObjectRay against a shape."""
    faces = faces_along(shape, ray.origin, ray.direction)
    find = intersect_torus if shape["type"] == "torus" else intersect_convex
    hits, intervals, decidable = find(faces, ray)
    lies_in_face = any(all(x == 0 for x in face.along_ray) for face in faces if face.label != "apex")
    in_surface = lies_in_face and bool(intervals)
    return Intersection(hits, intervals, bool(decidable), where_origin_lies(faces), in_surface)
