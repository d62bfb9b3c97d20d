"""Where polygons enter: vertices become a checked ring, counter-clockwise and simple, or a named
error says why they cannot.
"""

import numpy as np
from numpy.typing import ArrayLike

from ..compiled import compiled
from ..errors import InvalidPolygon
from .checks import Array, as_array
from .exact import facing, turn
from .segments import segments_meet


def as_ring(vertices: ArrayLike, name: str = "polygon") -> Array:
    """A simple polygon's vertices, shape (n, 2), counter-clockwise, the first not repeated at the
    end.

    Raises InvalidPolygon where there are fewer than three vertices, one follows itself, or edges
    cross, touch or overlap; InvalidPoint where a coordinate is not finite or beyond 1e150.

    >>> as_ring([(0, 0), (0, 1), (1, 0)])
    array([[1., 0.],
           [0., 1.],
           [0., 0.]])
    """
    ring = as_array(vertices, name)
    if ring.ndim != 2 or ring.shape[1:] != (2,):
        raise InvalidPolygon(f"{name} must be vertices of shape (n, 2), got shape {ring.shape}")
    if len(ring) < 3:
        raise InvalidPolygon(f"{name} must have at least three vertices, got {len(ring)}")
    for i in np.flatnonzero((ring == np.roll(ring, -1, axis=0)).all(axis=1)):
        closing = (
            "; leave out the last vertex, the ring closes itself" if i == len(ring) - 1 else ""
        )
        raise InvalidPolygon(f"{name} repeats vertex {i} {tuple(ring[i].tolist())}{closing}")
    if not ring_turn(ring):
        raise InvalidPolygon(f"{name} has no area or folds back on itself")
    i, j = first_crossing(ring)
    if i >= 0:
        raise InvalidPolygon(
            f"{name} crosses or touches itself: {edge_text(ring, i)} meets {edge_text(ring, j)}"
        )
    return ring if ring_turn(ring) > 0 else ring[::-1].copy()


def edge_text(ring: Array, i: int) -> str:
    """An edge as words: its number and its ends."""
    a, b = ring[i].tolist(), ring[(i + 1) % len(ring)].tolist()
    return f"edge {i} from {tuple(a)} to {tuple(b)}"


def as_convex_ring(vertices: ArrayLike, name: str = "polygon") -> Array:
    """A ring as `as_ring` makes it, refused as InvalidPolygon unless it is convex (straight angles
    are allowed).
    """
    ring = as_ring(vertices, name)
    i = first_reflex(ring)
    if i >= 0:
        raise InvalidPolygon(
            f"{name} must be convex, but turns inward at vertex {tuple(ring[i].tolist())}"
        )
    return ring


@compiled
def ring_turn(ring: Array) -> int:
    """1 for a counter-clockwise ring, -1 for a clockwise one, 0 for one without area: the turn at
    the leftmost lowest vertex.
    """
    low = 0
    for i in range(1, len(ring)):
        if ring[i, 0] < ring[low, 0] or (ring[i, 0] == ring[low, 0] and ring[i, 1] < ring[low, 1]):
            low = i
    before, after = ring[low - 1], ring[(low + 1) % len(ring)]
    return turn(before[0], before[1], ring[low, 0], ring[low, 1], after[0], after[1])


@compiled
def first_reflex(ring: Array) -> int:
    """The first vertex at which a counter-clockwise ring turns right, or -1."""
    for i in range(len(ring)):
        a, b, c = ring[i - 1], ring[i], ring[(i + 1) % len(ring)]
        if turn(a[0], a[1], b[0], b[1], c[0], c[1]) < 0:
            return i
    return -1


@compiled
def first_crossing(ring: Array) -> tuple[int, int]:
    """The first two edges that share more than the vertex between them, or (-1, -1). Edge i leaves
    vertex i. O(n^2), exact.
    """
    n = len(ring)
    for i in range(n):
        a, b = ring[i], ring[(i + 1) % n]
        c = ring[(i + 2) % n]
        if (
            turn(a[0], a[1], b[0], b[1], c[0], c[1]) == 0
            and facing(b[0], b[1], a[0], a[1], c[0], c[1]) > 0
        ):
            return i, (i + 1) % n
        for j in range(i + 2, n if i > 0 else n - 1):
            c, d = ring[j], ring[(j + 1) % n]
            if segments_meet(a[0], a[1], b[0], b[1], c[0], c[1], d[0], d[1]):
                return i, j
    return -1, -1
