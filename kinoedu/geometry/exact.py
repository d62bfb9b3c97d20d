"""Exact signs and accurate values of sums of products.

Every geometric predicate uses this arithmetic. It takes the floating-point result where an error
bound proves its sign, and otherwise computes exactly. The module knows only numbers, no polygons.

Sources: J. R. Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric
predicates", Discrete & Computational Geometry 18 (1997); T. J. Dekker, "A floating-point technique
for extending the available precision" (1971).
"""

import math

import numpy as np

from ..compiled import compiled

SPLITTER = 134217729.0  # 2^27 + 1: splits a 53-bit number into two halves with exact products
# (3 + 16 eps) eps with eps = 2^-53, the bound of a computed cross product's relative error
ROUNDING = 3.3306690738754716e-16
SAFE = 1e-270  # above this, a product's rounding error is a normal number
HUGE = 1e302  # below this, a few products can be added without overflow
WINDOW = 800  # exponents that can be summed at once without underflow
NO_EXPONENT = -100000  # less than every exponent of a product


@compiled
def two_sum(a: float, b: float) -> tuple[float, float]:
    """The rounded sum of a and b and its rounding error; together exactly a + b (Knuth)."""
    total = a + b
    b_part = total - a
    a_part = total - b_part
    return total, (a - a_part) + (b - b_part)


@compiled
def two_product(a: float, b: float) -> tuple[float, float]:
    """The rounded product of a and b and its rounding error; together exactly a * b.

    Dekker's method with Veltkamp's splitting.
    """
    product = a * b
    c = SPLITTER * a
    a_high = c - (c - a)
    a_low = a - a_high
    c = SPLITTER * b
    b_high = c - (c - b)
    b_low = b - b_high
    return product, a_low * b_low - (
        ((product - a_high * b_high) - a_low * b_high) - a_high * b_low
    )


@compiled
def sum_of_products(x: np.ndarray, y: np.ndarray) -> tuple[float, int]:
    """The sum of x[i] * y[i], computed exactly and rounded once.

    Parameters
    ----------
    x, y : (k,) arrays of any finite numbers.

    Returns
    -------
    m, e
        The sum is m * 2^e. The sign of m is exact, and its value is rounded once.
    """
    expansion = np.empty(2 * len(x))
    size = 0
    for i in range(len(x)):
        product, error = two_product(x[i], y[i])
        if not (SAFE < abs(product) < HUGE) and x[i] != 0.0 and y[i] != 0.0:
            return scaled_sum_of_products(x, y)
        size = add_exactly(expansion, size, error)
        size = add_exactly(expansion, size, product)
    return expansion_value(expansion, size), 0


@compiled
def scaled_sum_of_products(x: np.ndarray, y: np.ndarray) -> tuple[float, int]:
    """`sum_of_products` where products overflow or underflow.

    Each product becomes two terms m * 2^e with separate exponents. The largest terms, as many as
    fit one window of exponents, are summed exactly. While the remaining terms could still change
    the result, the sum is put back among them and the step is repeated.
    """
    k = len(x)
    m, e = np.zeros(6 * k), np.zeros(6 * k, np.int64)
    for i in range(k):
        mx, ex = math.frexp(x[i])
        my, ey = math.frexp(y[i])
        high, low = two_product(mx, my)
        m[2 * i], e[2 * i] = normalized(high, ex + ey)
        m[2 * i + 1], e[2 * i + 1] = normalized(low, ex + ey)
    expansion = np.empty(6 * k)
    while True:
        top = largest_exponent(m, e)
        size = 0
        for i in range(len(m)):
            if m[i] != 0.0 and e[i] > top - WINDOW:
                size = add_exactly(expansion, size, math.ldexp(m[i], int(e[i] - top)))
                m[i] = 0.0
        result, rest = expansion_value(expansion, size), largest_exponent(m, e)
        if rest == NO_EXPONENT or abs(result) > math.ldexp(1.0, int(rest - top + 64)):
            return result, top
        free = 0
        for i in range(size):
            while m[free] != 0.0:
                free += 1
            m[free], e[free] = normalized(expansion[i], top)


@compiled
def expansion_value(expansion: np.ndarray, size: int) -> float:
    """The value of an expansion, summed from its smallest component."""
    value = 0.0
    for i in range(size):
        value += expansion[i]
    return value


@compiled
def normalized(m: float, e: int) -> tuple[float, int]:
    """Mantissa and exponent of m * 2^e, with the mantissa in [1/2, 1) or zero."""
    mantissa, shift = math.frexp(m)
    return mantissa, e + shift


@compiled
def largest_exponent(m: np.ndarray, e: np.ndarray) -> int:
    """The largest exponent among the nonzero terms."""
    top = NO_EXPONENT
    for i in range(len(m)):
        if m[i] != 0.0 and e[i] > top:
            top = e[i]
    return top


@compiled
def add_exactly(expansion: np.ndarray, size: int, term: float) -> int:
    """Add a term to an expansion of `size` components, smallest first; returns the new size."""
    new_size = 0
    for i in range(size):
        term, error = two_sum(term, expansion[i])
        if error != 0.0:
            expansion[new_size] = error
            new_size += 1
    if term != 0.0:
        expansion[new_size] = term
        new_size += 1
    return new_size


@compiled
def exact_cross(
    ax: float, ay: float, bx: float, by: float, cx: float, cy: float
) -> tuple[float, int]:
    """The cross product (b - a) x (c - a), exact, as (m, e)."""
    return sum_of_products(
        np.array([ax, -ay, bx, -by, cx, -cy]), np.array([by, bx, cy, cx, ay, ax])
    )


@compiled
def exact_dot(
    ax: float, ay: float, bx: float, by: float, cx: float, cy: float
) -> tuple[float, int]:
    """The dot product (b - a) . (c - a), exact, as (m, e)."""
    return sum_of_products(
        np.array([bx, -bx, -ax, ax, by, -by, -ay, ay]), np.array([cx, ax, cx, ax, cy, ay, cy, ay])
    )


@compiled
def orientation_sign(ax: float, ay: float, bx: float, by: float, cx: float, cy: float) -> int:
    """The exact sign of (b - a) x (c - a) = (a - c) x (b - c).

    1 where a, b, c turn left, -1 where they turn right, 0 where they lie on one line.

    There are three stages, each for inputs that the one before cannot decide: the floating-point
    value with an error bound; the exact difference of the two products, if the coordinate
    differences are exact (points on a lattice); the exact value.
    """
    left, right = (ax - cx) * (by - cy), (ay - cy) * (bx - cx)
    det = left - right
    size = abs(left) + abs(right)
    if abs(det) > ROUNDING * size and abs(det) > SAFE:
        return 1 if det > 0.0 else -1
    return orientation_sign_exactly(ax, ay, bx, by, cx, cy)


@compiled
def orientation_sign_exactly(
    ax: float, ay: float, bx: float, by: float, cx: float, cy: float
) -> int:
    """The sign of (b - a) x (c - a), computed without rounding."""
    acx, e1 = two_sum(ax, -cx)
    bcy, e2 = two_sum(by, -cy)
    acy, e3 = two_sum(ay, -cy)
    bcx, e4 = two_sum(bx, -cx)
    if e1 == 0.0 and e2 == 0.0 and e3 == 0.0 and e4 == 0.0:
        left, left_error = two_product(acx, bcy)
        right, right_error = two_product(acy, bcx)
        if abs(left) > SAFE and abs(right) > SAFE:
            # rounding is monotonic: rounded products decide unless equal, then their errors do
            difference = left - right if left != right else left_error - right_error
            return int(difference > 0.0) - int(difference < 0.0)
        if (acx == 0.0 or bcy == 0.0) and (acy == 0.0 or bcx == 0.0):
            return 0
    m, _ = exact_cross(ax, ay, bx, by, cx, cy)
    return int(m > 0.0) - int(m < 0.0)


@compiled
def height(ax: float, ay: float, bx: float, by: float, px: float, py: float) -> float:
    """The signed distance of p from the line a-b, positive on the left.

    The relative error is at most 1e-12, however near p is to the line.
    """
    left, right = (ax - px) * (by - py), (ay - py) * (bx - px)
    det, base = left - right, length(bx - ax, by - ay)
    # where the terms cancel so little, the relative error of det is below 1000 ROUNDING = 4e-13
    if abs(det) > 1e-3 * (abs(left) + abs(right)) and abs(det) > SAFE and base > SAFE:
        return det / base
    m, e = exact_cross(ax, ay, bx, by, px, py)
    return over_length(m, e, bx - ax, by - ay)


@compiled
def over_length(m: float, e: int, x: float, y: float) -> float:
    """The value of m * 2^e over the length of a vector, however short that is."""
    x, y, shift = scaled_vector(x, y)
    return math.ldexp(m / length(x, y), int(e - shift))


@compiled
def unit_vector(x: float, y: float) -> tuple[float, float]:
    """The vector of length 1 in the direction of (x, y), which is not (0, 0)."""
    x, y, _ = scaled_vector(x, y)
    size = length(x, y)
    return x / size, y / size


@compiled
def scaled_vector(x: float, y: float) -> tuple[float, float, int]:
    """The x, y and exponent of a vector (x, y) * 2^exponent, whose larger number is in [1/2, 1)."""
    _, shift = math.frexp(max(abs(x), abs(y)))
    return math.ldexp(x, -shift), math.ldexp(y, -shift), shift


@compiled
def length(x: float, y: float) -> float:
    """The length of a vector, without overflow or underflow of the squares."""
    size = max(abs(x), abs(y))
    if 1e-140 < size < 1e150:
        return math.sqrt(x * x + y * y)
    if size == 0.0:
        return 0.0
    x, y = x / size, y / size
    return size * math.sqrt(x * x + y * y)


@compiled
def dot_sign(ax: float, ay: float, bx: float, by: float, cx: float, cy: float) -> int:
    """The exact sign of (b - a) . (c - a).

    1 where the angle at a between b and c is less than a right angle, -1 where it is more, 0 where
    it is a right angle.
    """
    along, across = (bx - ax) * (cx - ax), (by - ay) * (cy - ay)
    dot = along + across
    if abs(dot) > ROUNDING * (abs(along) + abs(across)) and abs(dot) > SAFE:
        return 1 if dot > 0.0 else -1
    m, _ = exact_dot(ax, ay, bx, by, cx, cy)
    return int(m > 0.0) - int(m < 0.0)


@compiled
def cross_sign(
    ax: float, ay: float, bx: float, by: float, cx: float, cy: float, dx: float, dy: float
) -> int:
    """The exact sign of (b - a) x (d - c).

    1 where the direction from c to d is left of the direction from a to b, -1 where it is right, 0
    where the directions are parallel.
    """
    left, right = (bx - ax) * (dy - cy), (by - ay) * (dx - cx)
    det = left - right
    if abs(det) > ROUNDING * (abs(left) + abs(right)) and abs(det) > SAFE:
        return 1 if det > 0.0 else -1
    x = np.array([bx, -bx, -ax, ax, -by, by, ay, -ay])
    m, _ = sum_of_products(x, np.array([dy, cy, dy, cy, dx, cx, dx, cx]))
    return int(m > 0.0) - int(m < 0.0)
