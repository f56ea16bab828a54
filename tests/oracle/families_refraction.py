"""Families of kind `refr`: a ray at the boundary of two media. Each gives (direction, normal, c1, c2)."""
import math

from family_table import ALL_LEVELS, ONE_LEVEL, FamilyTable
from sampling import frame

REFRACTION = FamilyTable()


def arriving(normal, tangent, theta):
    """The unit direction that meets the surface at theta to its normal."""
    return [-math.cos(theta) * a + math.sin(theta) * b for a, b in zip(normal, tangent)]


@REFRACTION.family(ONE_LEVEL, 40)
def refr_generic(rng, eps, variant):
    """Nothing special."""
    normal, tangent = frame(rng)
    return arriving(normal, tangent, rng.uniform(0, 1.5)), normal, rng.uniform(.3, 1), rng.uniform(.3, 1)


@REFRACTION.family(ALL_LEVELS, 4)
def refr_near_critical(rng, eps, variant):
    """eps beside the critical angle."""
    normal, tangent = frame(rng)
    c1, c2 = ((.7519, 1.), (1 / 1.5, 1.), (.4, 1.), (.5, .75))[variant]
    critical = math.asin(c1 / c2)
    return arriving(normal, tangent, critical + rng.choice([-1, 1]) * eps), normal, c1, c2


@REFRACTION.family(ONE_LEVEL, 12)
def refr_exact_critical(rng, eps, variant):
    """At the critical angle exactly: Pythagorean triples."""
    direction, c1, c2 = (([3., -4., 0.], 3., 5.), ([4., -3., 0.], 4., 5.), ([5., -12., 0.], 5., 13.),
                         ([8., -15., 0.], 8., 17.), ([0., -24., 7.], 7., 25.),
                         ([20., -21., 0.], 20., 29.))[variant % 6]
    scale = 2. ** rng.randint(-3, 3)
    return [x * scale for x in direction], [0., 1., 0.] if variant < 6 else [0., 4., 0.], c1, c2


@REFRACTION.family(ONE_LEVEL, 16)
def refr_eta1(rng, eps, variant):
    """Equal speeds: the ray goes straight on."""
    normal, tangent = frame(rng)
    speed = rng.uniform(.3, 1)
    return arriving(normal, tangent, rng.uniform(0, 1.57)), normal, speed, speed


@REFRACTION.family([1, 2, 3, 4, 5, 6], 4)
def refr_eta_extreme(rng, eps, variant):
    """Speeds in the ratio eps."""
    normal, tangent = frame(rng)
    c1, c2 = (eps, 1.) if variant % 2 else (1., eps)
    steepest = math.asin(min(1., c1 / c2))
    theta = rng.uniform(.1, .9) * steepest if variant < 2 else rng.uniform(0, 1.5)
    return arriving(normal, tangent, theta), normal, c1, c2


@REFRACTION.family(ALL_LEVELS, 2)
def refr_grazing(rng, eps, variant):
    """eps off the tangent plane."""
    normal, tangent = frame(rng)
    return arriving(normal, tangent, math.pi / 2 - eps), normal, *((1., .66), (.9, .9000001))[variant]


@REFRACTION.family(ALL_LEVELS, 2)
def refr_near_normal(rng, eps, variant):
    """eps off the normal."""
    normal, tangent = frame(rng)
    return arriving(normal, tangent, eps), normal, *((1., .66), (.66, 1.))[variant]


@REFRACTION.family(ONE_LEVEL, 16)
def refr_inside(rng, eps, variant):
    """The normal points along the ray and must be turned."""
    normal, tangent = frame(rng)
    direction = [-x for x in arriving(normal, tangent, rng.uniform(0, 1.4))]
    return direction, normal, rng.uniform(.3, 1), rng.uniform(.3, 1)


@REFRACTION.family([1, 3, 6, 9, 12, 15], 4)
def refr_nonunit(rng, eps, variant):
    """Direction and normal of any length."""
    normal, tangent = frame(rng)
    scale, scale_of_normal = (eps, 1 / eps, 1e-150, 1e150)[variant], (1., 1., 1e-100, 1.)[variant]
    direction = arriving(normal, tangent, rng.uniform(0, 1.4))
    return [x * scale for x in direction], [x * scale_of_normal for x in normal], 1., .66
