"""Families of kind `hit` that only a torus has."""
from family_table import ALL_LEVELS, COARSE_LEVELS, ONE_LEVEL, FamilyTable
from sampling import IDENTITY, exact_matrix, far_ray, mild_matrix, torus, world_ray

HIT_TORUS = FamilyTable()


@HIT_TORUS.family(COARSE_LEVELS, 3)
def torus_far(rng, eps, variant):
    """From 1/eps away."""
    shape = torus((.25, .5, rng.uniform(.1, .9))[variant])
    matrix = IDENTITY if variant % 2 else mild_matrix(rng)
    return shape, matrix, *far_ray(rng, shape, matrix, 1 / eps)


@HIT_TORUS.family(ALL_LEVELS, 4)
def torus_top_quad(rng, eps, variant):
    """Tangent to the top circle: a root of multiplicity 4 (variant 0), or eps inside or outside of it."""
    radius = .25
    matrix = exact_matrix(rng) if variant == 0 else (IDENTITY, mild_matrix(rng))[variant % 2]
    height = (radius, radius * (1 - eps), radius * (1 - eps), radius * (1 + eps))[variant]
    return torus(radius), matrix, *world_ray(matrix, [1., -4., height], [0., 1., 0.])


@HIT_TORUS.family(ALL_LEVELS, 4)
def torus_double(rng, eps, variant):
    """Tangent to the outer or inner equator, exactly or eps off."""
    radius = .25
    matrix = (exact_matrix(rng), IDENTITY, mild_matrix(rng), IDENTITY)[variant]
    x = (rng.choice([1.25, .75]), .75 + rng.choice([-eps, eps]), 1.25 - eps, 1.25 + eps)[variant]
    return torus(radius), matrix, *world_ray(matrix, [x, -4., 0.], [0., 1., 0.])


@HIT_TORUS.family(ONE_LEVEL, 24)
def torus_symmetry(rng, eps, variant):
    """In a plane of symmetry or along the axis: the quartic is biquadratic."""
    radius = rng.choice([.25, .5, .125])
    matrix = exact_matrix(rng) if variant % 2 else IDENTITY
    origin, direction = (([0., 0., 4.], [0., 0., -1.]), ([-4., 0., 0.], [1., 0., 0.]),
                         ([-4., 0., radius / 2], [1., 0., 0.]), ([1., 0., 4.], [0., 0., -1.]),
                         ([-4., -4., 0.], [1., 1., 0.]), ([-4., 0., 1.], [1., 0., -.25]))[variant % 6]
    return torus(radius), matrix, *world_ray(matrix, origin, direction)


@HIT_TORUS.family([1, 2, 3, 4, 5, 6], 4)
def torus_thin(rng, eps, variant):
    """Minor radius eps."""
    shape = torus(eps)
    matrix = IDENTITY if variant % 2 else mild_matrix(rng)
    return shape, matrix, *far_ray(rng, shape, matrix, 3)
