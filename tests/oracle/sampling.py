"""Random matrices, points and rays in plain doubles: the inputs of the cases."""
import math

from gmpy2 import mpq

from linear_algebra import add, cross, dot, product

IDENTITY = [1., 0., 0., 0., 0., 1., 0., 0., 0., 0., 1., 0., 0., 0., 0., 1.]

SPHERE, PLANE, CYLINDER, CONE, CUBE = (
    {"type": name} for name in ("sphere", "plane", "cylinder", "cone", "cube"))


def torus(minor_radius):
    """The torus of major radius 1."""
    return {"type": "torus", "r": minor_radius}


def unit_vector(rng):
    """Uniform on the sphere."""
    while True:
        v = [rng.gauss(0, 1) for _ in range(3)]
        length = math.sqrt(dot(v, v))
        if length > 1e-3:
            return [x / length for x in v]


def perpendicular(rng, v):
    """A random unit vector across v."""
    while True:
        w = cross(v, unit_vector(rng))
        length = math.sqrt(dot(w, w))
        if length > 1e-2:
            return [x / length for x in w]


def frame(rng):
    """A unit normal and a unit tangent."""
    normal = unit_vector(rng)
    return normal, perpendicular(rng, normal)


def uniform_vector(rng, low, high):
    """Three independent uniform numbers."""
    return [rng.uniform(low, high) for _ in range(3)]


def rotation(rng):
    """A random rotation, from a random quaternion."""
    while True:
        q = [rng.gauss(0, 1) for _ in range(4)]
        length = math.sqrt(dot(q, q))
        if length > 1e-3:
            break
    w, x, y, z = [a / length for a in q]
    return [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]


def scaling(x, y, z):
    """A diagonal matrix."""
    return [[x, 0., 0.], [0., y, 0.], [0., 0., z]]


def affine(linear, translation):
    """Row-major 4x4 matrix of a linear part and a translation."""
    rows = [list(row) + [offset] for row, offset in zip(linear, translation)]
    return rows[0] + rows[1] + rows[2] + [0., 0., 0., 1.]


def placed(x, y, z, scale_x=1., scale_y=None, scale_z=None):
    """Scaled along the axes (all alike unless said otherwise), then moved."""
    scale = scaling(scale_x, scale_x if scale_y is None else scale_y, scale_x if scale_z is None else scale_z)
    return affine(scale, [float(x), float(y), float(z)])


def mild_matrix(rng):
    """Rotated, stretched by 0.5 to 2, moved by up to 2."""
    linear = product(rotation(rng), scaling(*uniform_vector(rng, 0.5, 2)))
    return affine(linear, uniform_vector(rng, -2, 2))


def exact_matrix(rng):
    """Signed permutation times a power of two, dyadic translation: nothing rounds."""
    axes = [0, 1, 2]
    rng.shuffle(axes)
    linear = [[0.] * 3 for _ in range(3)]
    scale = 2.0 ** rng.randint(-3, 3)
    for i in range(3):
        linear[i][axes[i]] = rng.choice([-1., 1.]) * scale
    return affine(linear, [rng.randint(-16, 16) / 4. for _ in range(3)])


def image(matrix, vector, weight):
    """matrix · (vector, weight), exact and then cut to doubles; weight 1 for points, 0 for directions."""
    terms = [dot([mpq(x) for x in matrix[4 * i:4 * i + 3]], [mpq(x) for x in vector]) for i in range(3)]
    return [float(terms[i] + (mpq(matrix[4 * i + 3]) if weight else 0)) for i in range(3)]


def world_ray(matrix, origin, direction):
    """An object-space ray as a world ray."""
    return image(matrix, origin, 1), image(matrix, direction, 0)


def ray_towards(matrix, target, direction, distance):
    """World ray that meets an object-space point after `distance` directions."""
    return world_ray(matrix, add(target, direction, -distance), direction)


def far_ray(rng, shape, matrix, distance):
    """World ray from `distance` away that meets a random point of the shape from outside."""
    point, normal = surface_point(rng, shape)
    direction = unit_vector(rng)
    if dot(direction, normal) > 0:
        direction = [-x for x in direction]
    return ray_towards(matrix, point, direction, distance)


def any_shape(rng):
    """One of the six shapes."""
    round_one = torus(rng.choice([0.125, 0.25, 0.5, rng.uniform(0.1, 0.9)]))
    return rng.choice([SPHERE, PLANE, CYLINDER, CONE, CUBE, round_one])


def surface_point(rng, shape):
    """A point on the surface (rounded) and its outward normal."""
    angle = rng.uniform(0, 2 * math.pi)
    c, s = math.cos(angle), math.sin(angle)
    kind = shape["type"]
    if kind == "sphere":
        normal = unit_vector(rng)
        return normal, normal
    if kind == "plane":
        return [rng.uniform(-3, 3), rng.uniform(-3, 3), 0.], [0., 0., 1.]
    if kind == "cylinder":
        if rng.random() < .6:
            return [c, s, rng.uniform(-.9, .9)], [c, s, 0.]
        radius, side = rng.uniform(0, .9), rng.choice([-1., 1.])
        return [radius * c, radius * s, side], [0., 0., side]
    if kind == "cone":
        return surface_point_of_cone(rng, c, s)
    if kind == "cube":
        axis, side = rng.randrange(3), rng.choice([-1., 1.])
        point, normal = uniform_vector(rng, -.9, .9), [0.] * 3
        point[axis] = normal[axis] = side
        return point, normal
    tube = rng.uniform(0, 2 * math.pi)
    cos_tube, sin_tube = math.cos(tube), math.sin(tube)
    minor = shape["r"]
    point = [(1 + minor * cos_tube) * c, (1 + minor * cos_tube) * s, minor * sin_tube]
    return point, [c * cos_tube, s * cos_tube, sin_tube]


def surface_point_of_cone(rng, c, s):
    """On the side, or on the base in three cases of ten."""
    if rng.random() < .7:
        z = rng.uniform(-.9, .8)
        radius, length = (1 - z) / 2, math.sqrt(1.25)
        return [radius * c, radius * s, z], [x / length for x in (c, s, .5)]
    radius = rng.uniform(0, .9)
    return [radius * c, radius * s, -1.], [0., 0., -1.]
