"""Vectors and 3x3 matrices as lists of any number type; sums run from left to right."""
from gmpy2 import mpfr, mpq


def dot(a, b):
    """a·b. Not by sum(), which rounds floats differently from Python 3.12 on."""
    total = 0
    for x, y in zip(a, b):
        total = total + x * y
    return total


def cross(a, b):
    """a × b."""
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def add(a, b, factor=1.0):
    """a + factor·b."""
    return [x + factor * y for x, y in zip(a, b)]


def subtract(a, b):
    """a - b."""
    return [x - y for x, y in zip(a, b)]


def transform(matrix, vector):
    """matrix · vector."""
    return [dot(row, vector) for row in matrix]


def transposed(matrix):
    """Rows become columns."""
    return [list(column) for column in zip(*matrix)]


def product(a, b):
    """a · b."""
    columns = transposed(b)
    return [[dot(row, column) for column in columns] for row in a]


def magnitudes(matrix):
    """|m| element by element."""
    return [[abs(x) for x in row] for row in matrix]


def to_floats(values):
    """Exact numbers as 1200-bit floats."""
    return [mpfr(x) for x in values]


def affine_parts(matrix):
    """Linear part and translation of a row-major affine 4x4 matrix, as exact rationals."""
    assert list(matrix[12:]) == [0, 0, 0, 1]
    linear = [[mpq(matrix[4 * i + j]) for j in range(3)] for i in range(3)]
    return linear, [mpq(matrix[4 * i + 3]) for i in range(3)]


def determinant_and_inverse(m):
    """Exact determinant and inverse of a 3x3 matrix; the inverse is None where the determinant is 0."""
    rows = [cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])]  # the cofactors
    determinant = dot(m[0], rows[0])
    if determinant == 0:
        return determinant, None
    return determinant, [[x / determinant for x in row] for row in transposed(rows)]
