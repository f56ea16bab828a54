"""How far rounding may move a root: the ray in object space, bounds to second order (see README.md)."""
import gmpy2
from gmpy2 import mpfr, mpq

from linear_algebra import (add, affine_parts, determinant_and_inverse, dot, magnitudes, product, subtract,
                            to_floats, transform, transposed)
from polynomials import taylor_coefficients, trimmed
from precision import unit


def absolute(vector):
    """|v| element by element."""
    return [abs(x) for x in vector]


class ObjectRay:
    """A world ray moved into object space, exactly, with the errors that a program in doubles makes."""

    def __init__(self, matrix, origin, direction):
        self.linear, self.translation = affine_parts(matrix)
        self.determinant, self.inverse = determinant_and_inverse(self.linear)
        self.world_origin, self.world_direction = [mpq(x) for x in origin], [mpq(x) for x in direction]
        offset = subtract(self.world_origin, self.translation)
        self.origin = transform(self.inverse, offset)
        self.direction = transform(self.inverse, self.world_direction)
        self.origin_value, self.direction_value = to_floats(self.origin), to_floats(self.direction)

        size_of_inverse = magnitudes(self.inverse)
        self.spread = product(product(size_of_inverse, magnitudes(self.linear)), size_of_inverse)
        size_of_terms = add(absolute(self.world_origin), absolute(self.translation), 1)
        size_of_direction = absolute(self.world_direction)
        self._loose = (to_floats(transform(self.spread, size_of_terms)),
                       to_floats(transform(self.spread, size_of_direction)))
        self._tight = (to_floats(transform(size_of_inverse, absolute(offset))),
                       to_floats(transform(size_of_inverse, size_of_direction)))
        self._size_of_inverse = size_of_inverse

    def at(self, t):
        """The point at t, to 1200 bits."""
        return add(self.origin_value, self.direction_value, t)

    def loose_error(self, t):
        """Error of the point per epsilon: the inverse in plain doubles, M⁻¹o + column."""
        return add(self._loose[0], self._loose[1], abs(t))

    def tight_error(self, t):
        """Error of the point per epsilon: the inverse correctly rounded, o − T formed first."""
        return add(self._tight[0], self._tight[1], abs(t))

    def componentwise_error(self, t, point):
        """Error of the point per epsilon for perturbed elements of origin, direction and matrix."""
        terms = [abs(mpfr(a)) + abs(t) * abs(mpfr(b)) + abs(mpfr(c))
                 for a, b, c in zip(self.world_origin, self.world_direction, self.translation)]
        image = transform([to_floats(row) for row in magnitudes(self.linear)], absolute(point))
        return transform([to_floats(row) for row in self._size_of_inverse], add(terms, image, 1))


def shift_of_face(face, ray, t, tight=False):
    """Change of a face's F at t under 64 ε relative errors, first plus second order."""
    error = ray.tight_error(t) if tight else ray.loose_error(t)
    gradient = face.gradient(ray.at(t))
    first = dot([abs(mpfr(x)) for x in gradient], error) * unit()
    curvature = [[abs(mpfr(x)) for x in row] for row in face.hessian]
    second = dot(error, transform(curvature, error)) * unit() * unit() / 2
    return first + second


def displacement(polynomial, t, shift):
    """How far the root t moves if the polynomial is shifted by ±shift, and whether it stays real."""
    coefficients = to_floats(trimmed(polynomial))
    if len(coefficients) <= 1:
        return mpfr("inf"), False
    if len(coefficients) == 2:
        return shift / abs(coefficients[1]), True
    if len(coefficients) == 3:
        return displacement_of_quadratic(coefficients, t, shift)
    return displacement_of_quartic(coefficients, t, shift)


def displacement_of_quadratic(coefficients, t, shift):
    """Exact: the root lies at distance s from the vertex, s² becomes s² ± shift/A."""
    leading = coefficients[2]
    from_vertex = t + coefficients[1] / 2 / leading
    largest, stays_real = mpfr(0), True
    for side in (1, -1):
        square = from_vertex * from_vertex + side * shift / leading
        if square < 0:
            stays_real = False
            moved = gmpy2.sqrt(from_vertex * from_vertex - square)
        elif square or from_vertex:
            moved = abs(square - from_vertex * from_vertex) / (gmpy2.sqrt(square) + abs(from_vertex))
        else:
            moved = mpfr(0)
        largest = max(largest, moved)
    return largest, stays_real


def displacement_of_quartic(coefficients, t, shift):
    """Some root of Σ aₖhᵏ = ∓shift has |h| ≤ (C(4,k)·shift/|aₖ|)^(1/k) for every k: the least of these."""
    taylor = taylor_coefficients(coefficients, t)
    least = mpfr("inf")
    for k, choices in ((1, 4), (2, 6), (3, 4), (4, 1)):
        if taylor[k] != 0:
            ratio = choices * shift / abs(taylor[k])
            least = min(least, gmpy2.rootn(ratio, k) if k > 1 else ratio)
    slope_dominates = taylor[1] * taylor[1] > 4 * shift * max(abs(taylor[2]), mpfr(10) ** -300)
    return least, bool(taylor[1] != 0 and slope_dominates)


def normal_error(face, ray, t, tolerance, normal_length):
    """Angle by which the world normal may be off, given that t is off by tolerance."""
    gradient = to_floats(face.gradient(ray.at(t)))
    moved = [tolerance * abs(d) + unit() * e for d, e in zip(ray.direction_value, ray.loose_error(t))]
    turned = transform([[abs(mpfr(x)) for x in row] for row in face.hessian], moved)
    by_point = transform([to_floats(row) for row in transposed(magnitudes(ray.inverse))], turned)
    by_matrix = transform([to_floats(row) for row in transposed(ray.spread)], absolute(gradient))
    error = add(by_point, by_matrix, unit())
    return gmpy2.sqrt(dot(error, error)) / normal_length + unit()
