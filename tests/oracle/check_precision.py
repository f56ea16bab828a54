"""Independent check of the precision that a case says it is about."""
import struct

INPUTS = ("o_hex", "d_hex", "n_hex", "M_hex", "c1_hex", "c2_hex", "r_hex", "v_hex", "leaves", "shape",
          "tris")


def inputs_of(value):
    """All hex floats among the inputs."""
    if isinstance(value, dict):
        for key in INPUTS:
            yield from inputs_of(value.get(key))
    elif isinstance(value, list):
        for element in value:
            yield from inputs_of(element)
    elif isinstance(value, str):
        yield float.fromhex(value)


def fits_binary32(x):
    """Whether nothing of x is lost there."""
    return struct.unpack("<f", struct.pack("<f", x)) == (x,)


def check_precision(case, log):
    """A case with another epsilon than a double's is about binary32, and has such inputs alone."""
    epsilon = case.get("epsilon", 2.0 ** -52)
    log.expect(epsilon in (2.0 ** -52, 2.0 ** -23), case, "epsilon")
    log.expect(case["family"].endswith("_f32") == (epsilon == 2.0 ** -23), case, "name of the family")
    if epsilon == 2.0 ** -23:
        log.expect(all(fits_binary32(x) for x in inputs_of(case)), case, "inputs in binary32")
