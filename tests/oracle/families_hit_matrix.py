"""Families of kind `hit` whose matrix is the difficulty."""
from family_table import ALL_LEVELS, ONE_LEVEL, FamilyTable
from linear_algebra import add, product
from sampling import (affine, any_shape, far_ray, image, rotation, scaling, surface_point, uniform_vector,
                      unit_vector)

HIT_MATRIX = FamilyTable()


def ray_from_world(rng, shape, matrix, distance):
    """World ray from `distance` away to a random point of the shape; distance may depend on that point."""
    target = image(matrix, surface_point(rng, shape)[0], 1)
    direction = unit_vector(rng)
    return add(target, direction, -distance(target)), direction


@HIT_MATRIX.family(ALL_LEVELS, 4)
def mat_near_singular(rng, eps, variant):
    """Flattened by eps."""
    shape = any_shape(rng)
    linear = scaling(1., 1., eps)
    if variant % 2:
        linear = product(product(rotation(rng), linear), rotation(rng))
    matrix = affine(linear, uniform_vector(rng, -1, 1))
    return shape, matrix, *ray_from_world(rng, shape, matrix, lambda target: 3.)


@HIT_MATRIX.family([3, 6, 9, 12], 8)
def mat_translation(rng, eps, variant):
    """Moved by 1/eps."""
    shape = any_shape(rng)
    offset = [x / eps for x in uniform_vector(rng, -1, 1)]
    matrix = affine(rotation(rng) if variant % 2 else scaling(1., 1., 1.), offset)
    return shape, matrix, *far_ray(rng, shape, matrix, 4)


@HIT_MATRIX.family([1, 2, 3, 4, 5, 6], 6)
def mat_nonuniform(rng, eps, variant):
    """Scaled by eps, 1/eps and 1."""
    shape = any_shape(rng)
    factors = [eps, 1 / eps, 1.]
    rng.shuffle(factors)
    linear = product(rotation(rng), scaling(*factors)) if variant % 2 else scaling(*factors)
    matrix = affine(linear, uniform_vector(rng, -1, 1))
    return shape, matrix, *ray_from_world(rng, shape, matrix, lambda target: max(abs(x) for x in target) + 1)


@HIT_MATRIX.family([1, 2, 3, 4, 6, 8], 5)
def mat_shear(rng, eps, variant):
    """Sheared by 1/eps."""
    shape = any_shape(rng)
    shear = [[1., 1 / eps, 0.], [0., 1., rng.choice([0., 1 / eps])], [0., 0., 1.]]
    matrix = affine(product(rotation(rng), shear) if variant % 2 else shear, uniform_vector(rng, -1, 1))
    return shape, matrix, *ray_from_world(rng, shape, matrix, lambda target: 3.)


@HIT_MATRIX.family(ONE_LEVEL, 30)
def mat_mirror(rng, eps, variant):
    """Mirrored along one axis, or along all three."""
    shape = any_shape(rng)
    factors = uniform_vector(rng, .5, 2)
    factors[variant % 3] *= -1
    if variant % 5 == 0:
        factors = [-abs(x) for x in factors]
    matrix = affine(product(rotation(rng), scaling(*factors)), uniform_vector(rng, -2, 2))
    return shape, matrix, *far_ray(rng, shape, matrix, 4)
