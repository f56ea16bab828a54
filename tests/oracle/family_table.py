"""Families of cases: named functions with their levels of difficulty."""
from typing import Callable, NamedTuple

from precision import chosen

ONE_LEVEL = [1]
ALL_LEVELS = list(range(1, 16))
COARSE_LEVELS = [1, 2, 3, 4, 6, 8, 10, 12, 14, 15]


class Family(NamedTuple):
    """`make(rng, eps, variant)` gives the inputs of one case: eps = 10^-level, variant counts repetitions."""

    make: Callable
    levels: list
    repetitions: int


class FamilyTable(dict):
    """Families of one kind, by name, in the order of definition."""

    def family(self, levels, repetitions):
        """Registers the decorated function under its name."""

        def register(make):
            self[make.__name__] = Family(make, levels, repetitions)
            return make

        return register

    def inputs(self, name, eps, variant, rng):
        """The inputs of one case, in numbers of the chosen precision."""
        return chosen().rounded(self[name.removesuffix(chosen().suffix)].make(rng, eps, variant))
