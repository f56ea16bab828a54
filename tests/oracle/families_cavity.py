"""The family of kind `cavity`: a ray in a mirror cube [−1, 1]³. It gives (bounces, origin, direction)."""
from family_table import FamilyTable
from sampling import uniform_vector

CAVITY = FamilyTable()


@CAVITY.family([1, 2, 3, 4], 6)
def cavity_cube(rng, eps, variant):
    """1/eps bounces."""
    origin = uniform_vector(rng, -.9, .9)
    return int(round(1 / eps)), origin, [rng.uniform(.2, 1) * rng.choice([-1, 1]) for _ in range(3)]
