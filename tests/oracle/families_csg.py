"""Families of kind `csg`: one line through a compound. Each gives (leaves, postfix, origin, direction).

A leaf is (shape, matrix). The postfix program has leaf indices, & | - (two operands) and ~ (one)."""
import math

from family_table import ALL_LEVELS, ONE_LEVEL, FamilyTable
from linear_algebra import add, product, subtract, transform
from sampling import (CONE, CUBE, CYLINDER, PLANE, SPHERE, affine, image, placed, rotation, scaling, torus,
                      uniform_vector, unit_vector)

CSG = FamilyTable()


def any_leaf(rng):
    """A shape in a mild place."""
    shape = rng.choice([SPHERE, CYLINDER, CONE, CUBE, torus(.25), SPHERE, CUBE, PLANE])
    linear = product(rotation(rng), scaling(*uniform_vector(rng, .4, 1.5)))
    return shape, affine(linear, uniform_vector(rng, -1, 1))


def any_program(rng, count):
    """A random tree in which each of `count` leaves stands once."""
    parts = [[k] for k in range(count)]
    while len(parts) > 1:
        left = parts.pop(rng.randrange(len(parts)))
        right = parts.pop(rng.randrange(len(parts)))
        if rng.random() < .15:
            left = left + ["~"]
        parts.append(left + right + [rng.choice(["&", "|", "-"])])
    return parts[0]


@CSG.family(ONE_LEVEL, 40)
def csg_generic(rng, eps, variant):
    """Two to eight leaves, nothing special."""
    count = rng.randint(2, 8)
    leaves = [any_leaf(rng) for _ in range(count)]
    origin = [x * 5 for x in unit_vector(rng)]
    target = uniform_vector(rng, -.5, .5)
    return leaves, any_program(rng, count), origin, subtract(target, origin)


@CSG.family(ONE_LEVEL, 24)
def csg_same_leaf(rng, eps, variant):
    """One leaf twice: A − A, A ∩ ¬A, A ∪ ¬A, A ∩ A, A ∪ A, ¬¬A hold without any tolerance."""
    leaves = [any_leaf(rng)]
    program = ([0, 0, "-"], [0, 0, "~", "&"], [0, 0, "~", "|"], [0, 0, "&"], [0, 0, "|"],
               [0, "~", "~"])[variant % 6]
    origin = [x * 4 for x in unit_vector(rng)]
    return leaves, program, origin, [a * -1 + rng.uniform(-.2, .2) for a in origin]


@CSG.family(ONE_LEVEL, 24)
def csg_same_solid(rng, eps, variant):
    """One solid written with two matrices (cube mirrored, sphere turned): all surfaces coincide."""
    centre = [.5, .25, -.5]
    if variant % 2:
        shape, turned = CUBE, [[0., -.75, 0.], [.75, 0., 0.], [0., 0., -.75]]
    else:
        shape, turned = SPHERE, [[0., .75, 0.], [0., 0., .75], [.75, 0., 0.]]
    leaves = [(shape, placed(*centre, .75)), (shape, affine(turned, centre))]
    program = ([0, 1, "-"], [0, 1, "&"], [0, 1, "|"], [1, 0, "-"])[variant % 4]
    origin = [x * 4 for x in unit_vector(rng)]
    return leaves, program, origin, [x + rng.uniform(-.2, .2) for x in subtract(centre, origin)]


@CSG.family(ALL_LEVELS, 3)
def csg_touching_spheres(rng, eps, variant):
    """Two unit spheres that touch, or are eps apart or in each other; along their axis or across it."""
    gap = (0., eps, -eps)[variant]
    leaves = [(SPHERE, placed(-1, 0, 0)), (SPHERE, placed(1 + gap, 0, 0))]
    program = rng.choice([[0, 1, "|"], [0, 1, "&"], [0, 1, "-"]])
    if rng.random() < .6:
        return leaves, program, [-4., 0., 0.], [1., 0., 0.]
    return leaves, program, [rng.choice([0., gap / 2]), -3., 0.], [0., 1., 0.]


def drilled_cylinder(variant_of_union):
    """D − A − B − C, or D − (A ∪ B ∪ C)."""
    return [0, 1, 2, "|", 3, "|", "-"] if variant_of_union else [0, 1, "-", 2, "-", 3, "-"]


def hole_centre(k):
    """The axis of hole k of three, in the plane z = 0."""
    angle = 2 * math.pi * k / 3
    return .5 * math.cos(angle), .5 * math.sin(angle)


def downwards(rng):
    """A direction that points into the upper cap."""
    direction = unit_vector(rng)
    direction[2] = -abs(direction[2]) - .3
    return direction


@CSG.family(ALL_LEVELS, 4)
def csg_flush_caps(rng, eps, variant):
    """A cylinder with three through holes whose caps are flush with its own (variant even), or eps off."""
    overhang = (0., eps, 0., -eps)[variant]
    leaves = [(CYLINDER, placed(0, 0, 0))]
    leaves += [(CYLINDER, placed(*hole_centre(k), 0, .25, .25, 1 + overhang)) for k in range(3)]
    k = rng.randrange(4)
    target = [0., 0., 1.]
    if k < 3:
        target = [x + rng.uniform(-.2, .2) for x in hole_centre(k)] + [1.]
    direction = downwards(rng)
    return leaves, drilled_cylinder(variant >= 2), add(target, direction, -3.), direction


@CSG.family(ALL_LEVELS, 4)
def csg_flush_scaled(rng, eps, variant):
    """Blind holes of half-length h centred at 1 − h: caps that reach z = 1 by other arithmetic than the body.

    Variants 0, 1: h is dyadic, the caps are exactly flush. 2, 3: decimal h, and in 3 all of it rotated: flush
    up to rounding only."""
    turn = rotation(rng) if variant == 3 else scaling(1., 1., 1.)

    def turned(scale, centre):
        return affine(product(turn, scale), transform(turn, centre))

    body = turned(scaling(1., 1., 1.), [0., 0., 0.])
    leaves = [(CYLINDER, body)]
    for k in range(3):
        half = rng.choice([.375, .3125, .21875] if variant < 2 else [.3, .35, .1, .7])
        height = 1 - half if variant < 2 else round(1 - half, 2)
        leaves.append((CYLINDER, turned(scaling(.25, .25, half), [*hole_centre(k), height])))
    k = rng.randrange(3)
    target = [x + rng.uniform(-.15, .15) for x in hole_centre(k)] + [1.]
    direction = downwards(rng)
    origin = image(body, add(target, direction, -3.), 1)
    return leaves, drilled_cylinder(variant % 2 == 0), origin, image(body, direction, 0)


@CSG.family(ONE_LEVEL, 24)
def csg_origin_inside(rng, eps, variant):
    """The ray starts among the leaves."""
    leaves = [any_leaf(rng) for _ in range(3)]
    return leaves, any_program(rng, 3), uniform_vector(rng, -.3, .3), unit_vector(rng)


@CSG.family(ONE_LEVEL, 24)
def csg_half_space(rng, eps, variant):
    """Half spaces and a complement at the root: unbounded intervals."""
    leaves = [(PLANE, affine(rotation(rng), uniform_vector(rng, -1, 1))) for _ in range(rng.randint(1, 5))]
    leaves.append(any_leaf(rng))
    program = any_program(rng, len(leaves))
    if variant % 2:
        program = program + ["~"]
    return leaves, program, uniform_vector(rng, -2, 2), unit_vector(rng)


@CSG.family(ALL_LEVELS, 3)
def csg_zero_length(rng, eps, variant):
    """Cubes in a row that share a face (variant 0), have a gap of eps (1) or overlap by eps (2)."""
    gap = (0., eps, -eps)[variant]
    leaves = [(CUBE, placed(0, 0, 0)), (CUBE, placed(2 + gap, 0, 0)), (CUBE, placed(4 + 2 * gap, 0, 0))]
    program = rng.choice([[0, 1, "|", 2, "|"], [0, 1, "&"], [0, 1, "-"], [0, 1, "|", "~"]])
    direction = [1., 0., 0.] if rng.random() < .5 else [1., rng.uniform(-.1, .1), rng.uniform(-.1, .1)]
    return leaves, program, [-3., rng.uniform(-.3, .3), rng.uniform(-.3, .3)], direction


def balanced(operands, operations):
    """A balanced tree over the operands, level by level."""
    parts = [[k] for k in operands]
    used = 0
    while len(parts) > 1:
        level = []
        for k in range(0, len(parts) - 1, 2):
            level.append(parts[k] + parts[k + 1] + [operations[used % len(operations)]])
            used += 1
        if len(parts) % 2:
            level.append(parts[-1])
        parts = level
    return parts[0]


@CSG.family([1, 2, 3, 4], 4)
def csg_deep(rng, eps, variant):
    """1/eps operations on eight leaves: chained to the left, to the right, or balanced."""
    size = int(round(1 / eps))
    leaves = [(rng.choice([SPHERE, CUBE]), placed(.5 * k, 0, 0, .4)) for k in range(8)]
    operands = [rng.randrange(8) for _ in range(size + 1)]
    operations = [rng.choice(["|", "|", "-", "|"]) for _ in range(size)]
    if variant % 3 == 0:
        program = operands[:1] + [token for pair in zip(operands[1:], operations) for token in pair]
    elif variant % 3 == 1:
        program = operands + operations
    else:
        program = balanced(operands, operations)
    return leaves, program, [-3., .05, .02], [1., .001 * rng.uniform(-1, 1), 0.]
