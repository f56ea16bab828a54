"""Families of kind `oct`: a ray through a uniform grid on [−1, 1]³. Each gives (depth, origin, direction)."""
from family_table import ALL_LEVELS, ONE_LEVEL, FamilyTable
from linear_algebra import add
from sampling import perpendicular, uniform_vector, unit_vector

OCTREE = FamilyTable()


def any_cell_plane(rng, cells):
    """A coordinate at which cells meet."""
    return -1 + 2. * rng.randint(0, cells) / cells


@OCTREE.family(ONE_LEVEL, 24)
def oct_generic(rng, eps, variant):
    """Nothing special."""
    target, direction = uniform_vector(rng, -1, 1), unit_vector(rng)
    return 2 + variant % 4, add(target, direction, -rng.uniform(0, 4)), direction


@OCTREE.family(ONE_LEVEL, 24)
def oct_face_edge(rng, eps, variant):
    """In a plane of cell faces, or along a cell edge."""
    depth = 2 + variant % 3
    axis, second, third = variant % 3, (variant % 3 + 1) % 3, (variant % 3 + 2) % 3
    origin, direction = uniform_vector(rng, -.9, .9), unit_vector(rng)
    direction[second] = rng.choice([0., -0.])
    origin[second] = any_cell_plane(rng, 2 ** depth)
    if variant % 2:
        direction[third] = 0.
        origin[third] = any_cell_plane(rng, 2 ** depth)
        direction[axis] = rng.choice([-1., 1.])
        origin[axis] = rng.choice([-2., 2., 0., .3])
    return depth, origin, direction


@OCTREE.family(ONE_LEVEL, 20)
def oct_corner(rng, eps, variant):
    """An exact diagonal: several cell planes at one t."""
    direction = [rng.choice([-1., 1.]) for _ in range(3)]
    return 2 + variant % 3, [x * -2 + (2. if variant % 4 == 3 else 0) for x in direction], direction


@OCTREE.family(ALL_LEVELS, 2)
def oct_near_corner(rng, eps, variant):
    """A diagonal that is eps off."""
    diagonal = [rng.choice([-1., 1.]) for _ in range(3)]
    origin = [-2 * x + eps * rng.uniform(-1, 1) for x in diagonal]
    return 3, origin, add(diagonal, unit_vector(rng), eps if variant else 0.)


@OCTREE.family(ONE_LEVEL, 20)
def oct_origin_on_face(rng, eps, variant):
    """Starts at a corner of cells."""
    origin = [any_cell_plane(rng, 8) for _ in range(3)]
    if variant % 2:
        return 3, origin, unit_vector(rng)
    return 3, origin, [rng.choice([-1., 1., 0.]), rng.choice([-1., .5]), rng.choice([1., 0.])]


@OCTREE.family(ONE_LEVEL, 20)
def oct_miss(rng, eps, variant):
    """Passes the box."""
    outwards = unit_vector(rng)
    distance = rng.uniform(1.75, 3)
    direction = perpendicular(rng, outwards)
    return 3, add([x * distance for x in outwards], direction, -2.), direction
