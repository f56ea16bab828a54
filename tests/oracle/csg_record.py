"""The record of one case of kind `csg`: the leaves' intervals, combined exactly."""
import functools
from typing import NamedTuple

from gmpy2 import mpfr

from error_model import ObjectRay
from exact_numbers import ZERO, compare
from json_fields import header, shape_fields, time_fields, upper_bound, vector_fields
from line_and_solid import Hit, intersect

# Of gap to tolerance: below the first a sliver surely vanishes, above the second it surely stays.
SURELY_MERGED, SURELY_APART = 1 / 64, 8


class LeafHit(NamedTuple):
    """A hit and the leaf that it belongs to."""

    leaf: int
    hit: Hit


class Place(list):
    """All LeafHits at one t, by exact comparison."""

    @property
    def t(self):
        """The common t."""
        return self[0].hit.t

    def worst(self, name):
        """The largest of a tolerance or condition."""
        return max(getattr(item.hit, name) for item in self)


class Bound(NamedTuple):
    """A place where the result begins or ends."""

    place: Place
    event: str


def places_of(intersections):
    """All crossings of all leaves, ascending; equal ones in one place. Touches are no crossings."""
    crossings = [LeafHit(leaf, hit) for leaf, found in enumerate(intersections)
                 for hit in found.hits if hit.event != "touch"]
    crossings.sort(key=functools.cmp_to_key(lambda a, b: compare(a.hit.t, b.hit.t)))
    places = []
    for crossing in crossings:
        if not places or compare(places[-1].t, crossing.hit.t) != 0:
            places.append(Place())
        places[-1].append(crossing)
    return places


def segments_inside(found, place_of, segments):
    """Bit k is set where the line's k-th segment (between places) lies inside the leaf."""
    mask = 0
    for start, end in found.intervals:
        if start is not None and start == end:
            continue
        first = 0 if start is None else place_of[id(found.hits[start])] + 1
        last = segments if end is None else place_of[id(found.hits[end])] + 1
        mask |= ((1 << last) - 1) & ~((1 << first) - 1)
    return mask


def evaluate(program, masks, everything):
    """The postfix program on bit masks."""
    stack = []
    for token in program:
        if token == "~":
            stack.append(everything & ~stack.pop())
        elif token in ("&", "|", "-"):
            right, left = stack.pop(), stack.pop()
            stack.append(left & right if token == "&" else left | right if token == "|" else left & ~right)
        else:
            stack.append(masks[token])
    (result,) = stack
    return result


def bounds_of(result, places):
    """Where the result's membership changes."""
    bounds = []
    for k, place in enumerate(places):
        before, after = (result >> k) & 1, (result >> (k + 1)) & 1
        if before != after:
            bounds.append(Bound(place, "enter" if after else "exit"))
    return bounds


def intervals_of(bounds, starts_inside):
    """Pairs of indices into the bounds; None is unbounded."""
    intervals = []
    start, inside = None, starts_inside
    for k, bound in enumerate(bounds):
        inside = bound.event == "enter"
        if inside:
            start = k
        else:
            intervals.append([start, k])
            start = None
    if inside:
        intervals.append([start, None])
    return intervals


def cleaned(intervals, bounds):
    """First the slivers, then the gaps that are shorter than the tolerances of their two ends vanish."""

    def negligible(a, b):
        if a is None or b is None:
            return False
        width = bounds[b].place.t.value - bounds[a].place.t.value
        return width <= bounds[a].place.worst("tolerance") + bounds[b].place.worst("tolerance")

    kept = []
    for start, end in intervals:
        if negligible(start, end):
            continue
        if kept and negligible(kept[-1][1], start):
            kept[-1] = [kept[-1][0], end]
        else:
            kept.append([start, end])
    return kept


def gap_ratios(places):
    """Distance of neighbouring places over the sum of their tolerances."""
    ratios = []
    for a, b in zip(places, places[1:]):
        tolerance = a.worst("tolerance") + b.worst("tolerance")
        ratios.append(float((b.t.value - a.t.value) / max(tolerance, mpfr(10) ** -300)))
    return ratios


def bound_fields(bound):
    """A bound with all surfaces that coincide there, their normals already turned for the result."""
    place = bound.place
    surfaces = []
    for leaf, hit in place:
        flip = hit.event != bound.event
        for normal, face in zip(hit.normals, hit.faces):
            outward = None if normal is None else [float(-x if flip else x) for x in normal]
            surfaces.append({"leaf": leaf, "face": face, "flip": flip, "n": outward})
    return {**time_fields(place.t), "event": bound.event, "tol64": upper_bound(place.worst("tolerance")),
            "tol64_tight": upper_bound(place.worst("tight_tolerance")),
            "cond_tight": upper_bound(place.worst("tight_condition")),
            "cond": upper_bound(place.worst("condition")), "surfaces": surfaces}


def inside_at_origin(result, places):
    """True, False, or None where the origin lies on a surface."""
    sides = [compare(place.t, ZERO) for place in places]
    return None if 0 in sides else bool((result >> sides.count(-1)) & 1)


def csg_record(table, family, eps, seed, variant, rng):
    """One line through a compound."""
    leaves, program, origin, direction = table.inputs(family, eps, variant, rng)
    found = [intersect(shape, ObjectRay(matrix, origin, direction)) for shape, matrix in leaves]
    places = places_of(found)
    place_of = {id(item.hit): k for k, place in enumerate(places) for item in place}
    segments = len(places) + 1
    masks = [segments_inside(leaf, place_of, segments) for leaf in found]
    result = evaluate(program, masks, (1 << segments) - 1)

    bounds = bounds_of(result, places)
    intervals = intervals_of(bounds, bool(result & 1))
    in_surface = any(leaf.in_surface for leaf in found)
    leaves_decidable = all(leaf.decidable for leaf in found) and not in_surface
    ratios = gap_ratios(places)
    least = min(ratios, default=None)
    return {
        **header("csg", family, eps, seed),
        "leaves": [{"shape": shape_fields(shape), **vector_fields("M", matrix)} for shape, matrix in leaves],
        "rpn": program, **vector_fields("o", origin), **vector_fields("d", direction),
        "bounds": [bound_fields(bound) for bound in bounds], "intervals": intervals,
        "intervals_clean": cleaned(intervals, bounds),
        "clean_decidable": leaves_decidable and all(x < SURELY_MERGED or x > SURELY_APART for x in ratios),
        "coincident": any(len({item.leaf for item in place}) > 1 for place in places),
        "min_gap_over_tol": "inf" if least is None else upper_bound(least),
        "decidable": leaves_decidable and (least is None or least > 1), "in_surface": in_surface,
        "sum_tol64": upper_bound(sum(place.worst("tolerance") for place in places)) if places else 0.0,
        "inside_at_0": inside_at_origin(result, places)}
