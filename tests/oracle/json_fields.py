"""Numbers as they stand in the case files: JSON numbers for people, hex floats for programs."""
import math

import gmpy2

from exact_numbers import Unbounded
from precision import chosen


def hexadecimal(x):
    """C99 hex float of the nearest double."""
    return float(x).hex()


def number(x):
    """A JSON number; what JSON lacks is the string inf, -inf or nan."""
    x = float(x)
    if math.isfinite(x):
        return x
    return "nan" if math.isnan(x) else "inf" if x > 0 else "-inf"


def upper_bound(x):
    """A bound, rounded upwards."""
    x = float(x)
    return number(math.nextafter(x, math.inf) if math.isfinite(x) else x)


def digits(value):
    """70 significant digits."""
    return "{0:.69e}".format(value)


def scalar_fields(name, x):
    """{name, name_hex} of one double."""
    return {name: number(x), name + "_hex": hexadecimal(x)}


def vector_fields(name, vector):
    """{name, name_hex} of doubles."""
    doubles = [float(x) for x in vector]
    return {name: [number(x) for x in doubles], name + "_hex": [hexadecimal(x) for x in doubles]}


def time_fields(t):
    """t as nearest double, what that double lacks, and 70 digits."""
    if isinstance(t, Unbounded):
        name = "inf" if t.sign > 0 else "-inf"
        return {"t": name, "t_hex": name}
    nearest = float(t.value)
    rest = float(t.value - gmpy2.mpfr(nearest)) if math.isfinite(nearest) else 0.0
    return {**scalar_fields("t", nearest), "t_lo_hex": hexadecimal(rest), "t_str": digits(t.value)}


def shape_fields(shape):
    """A shape with its radius in hex."""
    fields = dict(shape)
    if "r" in fields:
        fields["r_hex"] = hexadecimal(fields["r"])
    return fields


def header(kind, family, eps, seed):
    """What every case starts with; the id is filled in by the generator."""
    return {"id": "", "kind": kind, "family": family, "eps": eps, "seed": seed, **chosen().header()}
