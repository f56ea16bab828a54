"""Families of kind `hit`: where one line meets one solid. Each gives (shape, matrix, origin, direction).

Where a tuple is indexed by the variant, all of its alternatives are drawn on purpose: what a case takes from
the random numbers must not depend on which of them it uses."""
import math

from family_table import ALL_LEVELS, COARSE_LEVELS, ONE_LEVEL, FamilyTable
from linear_algebra import add
from sampling import (CONE, CUBE, CYLINDER, IDENTITY, PLANE, SPHERE, any_shape, exact_matrix, far_ray, image,
                      mild_matrix, perpendicular, ray_towards, surface_point, torus, unit_vector, world_ray)

HIT = FamilyTable()
ROUND_ANGLE = 6.28


@HIT.family(ONE_LEVEL, 40)
def generic(rng, eps, variant):
    """Nothing special."""
    shape = (SPHERE, PLANE, CYLINDER, CONE, CUBE, torus(rng.uniform(.1, .9)))[variant % 6]
    matrix = mild_matrix(rng)
    return shape, matrix, *far_ray(rng, shape, matrix, rng.uniform(1, 6))


@HIT.family(COARSE_LEVELS, 4)
def sphere_far(rng, eps, variant):
    """From 1/eps away."""
    matrix = IDENTITY if variant % 2 else mild_matrix(rng)
    return SPHERE, matrix, *far_ray(rng, SPHERE, matrix, 1 / eps)


@HIT.family(COARSE_LEVELS, 4)
def sphere_huge(rng, eps, variant):
    """A sphere of radius 1/eps as the ground, the eye about a unit above it."""
    radius = 1 / eps
    matrix = [radius, 0., 0., 0., 0., radius, 0., 0., 0., 0., radius, -radius, 0., 0., 0., 1.]
    direction = unit_vector(rng)
    direction[2] = -abs(direction[2]) - .05 if variant % 4 else -eps ** .5
    return SPHERE, matrix, [rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(.5, 2)], direction


@HIT.family(ALL_LEVELS, 6)
def sphere_grazing(rng, eps, variant):
    """Passes the centre at 1 − eps, at 1 + eps, or (variant 5) at 1 exactly."""
    if variant == 5:
        matrix = exact_matrix(rng)
        speed = 2. ** rng.randint(-2, 3)
        return SPHERE, matrix, *world_ray(matrix, [1., -3. * rng.randint(1, 9), 0.], [0., speed, 0.])
    matrix = IDENTITY if variant < 3 else mild_matrix(rng)
    direction = unit_vector(rng)
    across = perpendicular(rng, direction)
    reach = 1 - eps if variant in (0, 1, 3) else 1 + eps
    start = add([x * reach for x in across], direction, -rng.uniform(2, 6))
    return SPHERE, matrix, *world_ray(matrix, start, direction)


@HIT.family(ALL_LEVELS, 6)
def origin_on_surface(rng, eps, variant):
    """The origin on the surface or eps off it; leaving, entering or skimming."""
    shape = any_shape(rng)
    matrix = IDENTITY if rng.random() < .4 else mild_matrix(rng)
    point, normal = surface_point(rng, shape)
    direction = unit_vector(rng)
    if variant >= 3:
        tangent = perpendicular(rng, normal)
        direction = add(tangent, normal, rng.choice([-1, 1]) * eps ** .5)
    return shape, matrix, *world_ray(matrix, add(point, normal, (0., eps, -eps)[variant % 3]), direction)


@HIT.family([1, 2, 4, 6, 8, 10, 12], 4)
def direction_scale(rng, eps, variant):
    """A direction of length eps or 1/eps."""
    shape = any_shape(rng)
    matrix = mild_matrix(rng)
    origin, direction = far_ray(rng, shape, matrix, 3)
    return shape, matrix, origin, [x * (eps if variant % 2 else 1 / eps) for x in direction]


@HIT.family(ONE_LEVEL, 30)
def direction_zero_denormal(rng, eps, variant):
    """Along an axis, the other components ±0 or denormal."""
    shape = any_shape(rng)
    matrix = exact_matrix(rng) if variant % 2 else IDENTITY
    point, _ = surface_point(rng, shape)
    direction = [0., 0., 0.]
    axis = rng.randrange(3)
    direction[axis] = rng.choice([-1., 1.])
    if shape is PLANE:
        direction = [0., 0., rng.choice([-1., 1.])]
    origin = add(point, direction, -4.)
    tiny = rng.choice([0., -0., 5e-324, -5e-324, 1e-310, -1e-310, 1e-300])
    return shape, matrix, *world_ray(matrix, origin, [x if x else tiny for x in direction])


@HIT.family(ALL_LEVELS, 3)
def plane_grazing(rng, eps, variant):
    """The angle to the plane is about eps."""
    matrix = (IDENTITY, mild_matrix(rng), exact_matrix(rng))[variant % 3]
    origin = [rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(.1, 3) * rng.choice([-1, 1])]
    direction = [rng.uniform(.3, 1), rng.uniform(-1, 1), rng.choice([-eps, eps])]
    return PLANE, matrix, *world_ray(matrix, origin, direction)


@HIT.family(ONE_LEVEL, 12)
def plane_parallel(rng, eps, variant):
    """In the plane or beside it."""
    matrix = exact_matrix(rng) if variant % 2 else IDENTITY
    height = (0., 2. ** -40, -2. ** -40, 1., -1.)[variant % 5]
    return PLANE, matrix, *world_ray(matrix, [.5, .25, height], [1., rng.choice([0., .5]), 0.])


@HIT.family(ALL_LEVELS, 4)
def cylinder_parallel_axis(rng, eps, variant):
    """Along the axis, or tilted by eps, well inside or eps beside the side."""
    matrix = (IDENTITY, exact_matrix(rng), mild_matrix(rng), IDENTITY)[variant]
    angle = rng.uniform(0, ROUND_ANGLE)
    radius = (rng.uniform(0, .95), 1 - eps, 1 + eps, rng.uniform(0, .9))[variant]
    tilt = 0. if variant < 2 else eps
    origin = [radius * math.cos(angle), radius * math.sin(angle), 3.]
    direction = [tilt * rng.uniform(-1, 1), tilt * rng.uniform(-1, 1), -1.]
    return CYLINDER, matrix, *world_ray(matrix, origin, direction)


@HIT.family(ALL_LEVELS, 3)
def cap_plane(rng, eps, variant):
    """In the plane of a cap or eps beside it."""
    shape = CYLINDER if variant % 2 else CONE
    matrix = exact_matrix(rng) if variant == 0 else IDENTITY
    height = (-1., -1 + eps, -1 - eps)[variant]
    origin = [-3., rng.uniform(-.7, .7), height]
    return shape, matrix, *world_ray(matrix, origin, [1., 0., 0.] if variant % 2 else [1., 2. ** -3, 0.])


@HIT.family(ALL_LEVELS, 4)
def cylinder_grazing(rng, eps, variant):
    """Passes the axis at 1 ± eps."""
    matrix = IDENTITY if variant < 2 else mild_matrix(rng)
    angle = rng.uniform(0, ROUND_ANGLE)
    c, s = math.cos(angle), math.sin(angle)
    reach = 1 - eps if variant % 2 else 1 + eps
    height = rng.uniform(-.5, .5)
    direction = [-s, c, rng.uniform(-.2, .2)]
    start = add([reach * c, reach * s, height], direction, -2.5)
    return CYLINDER, matrix, *world_ray(matrix, start, direction)


@HIT.family(ALL_LEVELS, 3)
def rim(rng, eps, variant):
    """Through the edge between cap and side, eps off."""
    shape = CYLINDER if variant % 2 else CONE
    matrix = IDENTITY if variant < 2 else mild_matrix(rng)
    angle = rng.uniform(0, ROUND_ANGLE)
    c, s = math.cos(angle), math.sin(angle)
    target = [c * (1 + rng.choice([-eps, eps])), s * (1 - eps if variant == 0 else 1.), -1.]
    direction = add([-c, -s, 0.], unit_vector(rng), .5)
    return shape, matrix, *ray_towards(matrix, target, direction, 3.)


@HIT.family(COARSE_LEVELS, 3)
def cylinder_far(rng, eps, variant):
    """From 1/eps away."""
    matrix = IDENTITY if variant % 3 else mild_matrix(rng)
    return CYLINDER, matrix, *far_ray(rng, CYLINDER, matrix, 1 / eps)


@HIT.family(COARSE_LEVELS, 3)
def cone_far(rng, eps, variant):
    """From 1/eps away."""
    matrix = IDENTITY if variant % 3 else mild_matrix(rng)
    return CONE, matrix, *far_ray(rng, CONE, matrix, 1 / eps)


@HIT.family(ALL_LEVELS, 5)
def cone_apex(rng, eps, variant):
    """Through the apex exactly (variant 0), or eps beside it."""
    if variant == 0:
        matrix = exact_matrix(rng)
        direction = [rng.randint(-4, 4) / 8., rng.randint(-4, 4) / 8., rng.choice([-1., 1., -.5, .25])]
        return CONE, matrix, *ray_towards(matrix, [0., 0., 1.], direction, 4.)
    matrix = (IDENTITY, mild_matrix(rng))[variant % 2]
    direction = unit_vector(rng)
    target = add([0., 0., 1.], unit_vector(rng), eps)
    return CONE, matrix, *ray_towards(matrix, target, direction, rng.uniform(1, 5))


@HIT.family(ALL_LEVELS, 5)
def cone_generator(rng, eps, variant):
    """Along a generator, where the coefficient of t² vanishes: exactly (variant 0), or eps off."""
    if variant == 0:
        matrix = exact_matrix(rng)
        direction = rng.choice([[3., 4., -10.], [1., 0., -2.], [0., -1., -2.], [-4., 3., -10.]])
        offset = rng.choice([[0., 0., 0.], [.0625, 0., 0.], [0., 0., -.25], [-.125, .25, 0.]])
    else:
        matrix = (IDENTITY, mild_matrix(rng))[variant % 2]
        angle = rng.uniform(0, ROUND_ANGLE)
        direction = add([math.cos(angle), math.sin(angle), -2.], unit_vector(rng), eps)
        offset = [rng.uniform(-.4, .4), rng.uniform(-.4, .4), rng.uniform(-.5, .2)]
    return CONE, matrix, *ray_towards(matrix, add([0., 0., 1.], offset), direction, 1.5)


@HIT.family(ONE_LEVEL, 20)
def cone_other_nappe(rng, eps, variant):
    """Past the mirrored nappe above the apex, which is not there."""
    matrix = mild_matrix(rng)
    origin = [rng.uniform(-4, -2), 0., rng.uniform(1.2, 3)]
    return CONE, matrix, *world_ray(matrix, origin, [1., rng.uniform(-.2, .2), rng.uniform(-.3, .3)])


@HIT.family(ALL_LEVELS, 4)
def cube_edge_corner(rng, eps, variant):
    """Through an edge or a corner exactly (variant 0), or eps off."""
    matrix = (exact_matrix(rng), IDENTITY, IDENTITY, mild_matrix(rng))[variant]
    if variant == 0:
        target = [1., 1., rng.choice([1., .5, -.25])]
        direction = [-1., rng.choice([-1., 1., -.5, .25]), rng.choice([-1., .5, 0.])]
        return CUBE, matrix, *ray_towards(matrix, target, direction, 4.)
    target = [1 + rng.choice([-eps, eps]), 1 - eps, rng.choice([1. - eps, 1., rng.uniform(-.8, .8)])]
    return CUBE, matrix, *ray_towards(matrix, target, unit_vector(rng), rng.uniform(3, 6))


@HIT.family(ONE_LEVEL, 40)
def cube_face_plane(rng, eps, variant):
    """Direction components ±0, the origin in the planes of faces: 0·∞ in a careless slab test."""
    matrix = IDENTITY if variant % 2 else exact_matrix(rng)
    axis = variant % 3
    direction = [0., 0., 0.]
    direction[axis] = rng.choice([-1., 1.])
    origin = [rng.choice([-1., 1., .5, -.5, 1.5]) for _ in range(3)]
    origin[axis] = rng.choice([-3., 3., -1., 1., 0.])
    if variant % 4 == 0:
        direction[(axis + 1) % 3] = rng.choice([.5, -.5])
    direction = [x if x else rng.choice([0., -0.]) for x in direction]
    if matrix is not IDENTITY:  # which would turn −0 into 0
        direction = image(matrix, direction, 0)
    return CUBE, matrix, image(matrix, origin, 1), direction


@HIT.family(ALL_LEVELS, 3)
def cube_grazing(rng, eps, variant):
    """Nearly parallel to a face, eps inside or outside of it."""
    matrix = IDENTITY if variant < 2 else mild_matrix(rng)
    height = 1 + rng.choice([-eps, eps])
    origin = [-3., rng.uniform(-.8, .8), height]
    return CUBE, matrix, *world_ray(
        matrix, origin, [1., rng.uniform(-.1, .1), rng.uniform(-eps, eps) if variant else 0.])


@HIT.family(COARSE_LEVELS, 2)
def cube_far(rng, eps, variant):
    """From 1/eps away."""
    matrix = IDENTITY if variant % 2 else mild_matrix(rng)
    return CUBE, matrix, *far_ray(rng, CUBE, matrix, 1 / eps)
