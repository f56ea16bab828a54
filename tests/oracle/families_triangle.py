"""Families of kind `tri`: one line and triangles. Each gives (triangles, matrix, origin, direction)."""
from family_table import ALL_LEVELS, COARSE_LEVELS, ONE_LEVEL, FamilyTable
from linear_algebra import add, dot, subtract
from sampling import IDENTITY, mild_matrix, perpendicular, ray_towards, uniform_vector, unit_vector

TRIANGLE = FamilyTable()


def any_triangle(rng):
    """Three points in the unit cube."""
    return [uniform_vector(rng, -1, 1) for _ in range(3)]


def centroid(triangle):
    """The mean of the corners."""
    return [(x + y + z) / 3 for x, y, z in zip(*triangle)]


@TRIANGLE.family(ONE_LEVEL, 20)
def tri_generic(rng, eps, variant):
    """Through the inside."""
    triangle = any_triangle(rng)
    weights = [rng.random() for _ in range(3)]
    total = dot(weights, (1, 1, 1))
    shares = [w / total for w in weights]
    target = [dot(shares, [corner[axis] for corner in triangle]) for axis in range(3)]
    matrix = mild_matrix(rng)
    return [triangle], matrix, *ray_towards(matrix, target, unit_vector(rng), 3.)


@TRIANGLE.family(ALL_LEVELS, 3)
def tri_shared_edge(rng, eps, variant):
    """At the edge of two triangles: as exactly as doubles allow (variant 0), or eps beside it."""
    a, b, c = any_triangle(rng)
    aside = perpendicular(rng, subtract(b, a))
    opposite = [x + y - z for x, y, z in zip(a, b, c)]
    share = rng.uniform(.1, .9)
    target = [x * share + y * (1 - share) for x, y in zip(a, b)]
    if variant:
        target = add(target, aside, eps * rng.choice([-1, 1]))
    triangles = [[a, b, c], [b, a, opposite]]
    return triangles, IDENTITY, *ray_towards(IDENTITY, target, unit_vector(rng), 3.)


@TRIANGLE.family(ONE_LEVEL, 30)
def tri_edge_exact(rng, eps, variant):
    """Dyadic numbers: exactly through a spoke or the hub of a closed fan."""
    outline = [(2., 0.), (1., 2.), (-1., 2.), (-2., 0.), (-1., -2.), (1., -2.)]
    ring = [[x, y, rng.randint(-1, 1) / 2.] for x, y in outline]
    hub = [0., 0., rng.randint(-2, 2) / 4.]
    triangles = [[hub, ring[k], ring[(k + 1) % 6]] for k in range(6)]
    spoke = ring[rng.randrange(6)]
    share = (0., .5, .25, .75)[variant % 4]
    target = [x + (y - x) * share for x, y in zip(hub, spoke)]
    direction = [rng.randint(-3, 3) / 8., rng.randint(-3, 3) / 8., rng.choice([-1., 1.])]
    return triangles, IDENTITY, *ray_towards(IDENTITY, target, direction, 4.)


@TRIANGLE.family(COARSE_LEVELS, 2)
def tri_sliver(rng, eps, variant):
    """Only eps high."""
    a, b, _ = any_triangle(rng)
    middle = [(x + y) / 2 for x, y in zip(a, b)]
    triangle = [a, b, add(middle, unit_vector(rng), eps)]
    return [triangle], IDENTITY, *ray_towards(IDENTITY, centroid(triangle), unit_vector(rng), 3.)


@TRIANGLE.family(COARSE_LEVELS, 2)
def tri_far(rng, eps, variant):
    """From 1/eps away."""
    triangle = any_triangle(rng)
    return [triangle], IDENTITY, *ray_towards(IDENTITY, centroid(triangle), unit_vector(rng), 1 / eps)


@TRIANGLE.family(ONE_LEVEL, 10)
def tri_coplanar(rng, eps, variant):
    """In the triangle's plane, or parallel just above it."""
    triangle = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.]]
    return [triangle], IDENTITY, [-2., .25, (0., 2. ** -30)[variant % 2]], [1., rng.choice([0., .125]), 0.]
