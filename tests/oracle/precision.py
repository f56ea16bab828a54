"""The precision that a case is about: which numbers its inputs may be, and the ε of its tolerances."""
import struct
from typing import Callable, NamedTuple

from gmpy2 import mpfr

BACKWARD_ERROR = 64  # tolerances are stated for inputs perturbed by 64 ε


def to_binary32(x):
    """The nearest number of binary32; OverflowError if it has none, ValueError if a number would become zero."""
    (rounded,) = struct.unpack("<f", struct.pack("<f", x))
    if x != 0 and rounded == 0:
        raise ValueError(f"{x} is below the range of binary32")
    return rounded


class Precision(NamedTuple):
    """One floating-point format."""

    suffix: str  # of the names of its families
    epsilon: float
    hardest_level: int
    nearest: Callable

    def rounded(self, inputs):
        """The inputs of a case with every float in them made a number of this format."""
        if isinstance(inputs, dict):
            return {key: self.rounded(value) for key, value in inputs.items()}
        if isinstance(inputs, (list, tuple)):
            return type(inputs)(self.rounded(value) for value in inputs)
        return self.nearest(inputs) if isinstance(inputs, float) else inputs

    def header(self):
        """What tells a case's reader which precision it is about; nothing says double."""
        return {} if self is BINARY64 else {"epsilon": self.epsilon}


BINARY64 = Precision("", 2.0 ** -52, 15, lambda x: x)
BINARY32 = Precision("_f32", 2.0 ** -23, 7, to_binary32)

_chosen = [BINARY64]


def choose(precision):
    """From now on, cases are about this precision."""
    _chosen[0] = precision


def chosen():
    """The precision that cases are about at present."""
    return _chosen[0]


def unit():
    """BACKWARD_ERROR·ε."""
    return mpfr(BACKWARD_ERROR) * mpfr(_chosen[0].epsilon)
