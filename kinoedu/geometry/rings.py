"""Checks of polygons: simple counter-clockwise rings of vertices, or a named error."""

from __future__ import annotations

from typing import NamedTuple

from numpy.typing import ArrayLike

from ..compiled import compiled
from ..errors import InvalidPolygon
from ..messages import get_message
from .checks import Array, as_array
from .exact import dot_sign, orientation_sign
from .segments import segments_meet

SIMPLE, REPEATS, NO_AREA, CROSSES = 0, 1, 2, 3
FAULTS = ("simple", "repeats", "no_area", "crosses")  # the messages of the kinds


class RingFault(NamedTuple):
    """Why vertices are not a simple polygon: vertex j repeats vertex i, or edges i and j meet.

    Edge i starts at vertex i. The kind is SIMPLE where nothing is wrong.
    """

    kind: int
    i: int
    j: int


def as_ring(vertices: ArrayLike, name: str = "polygon") -> Array:
    """The vertices of a simple polygon in counter-clockwise order.

    Parameters
    ----------
    vertices : (n, 2) points in either order, n >= 3; the first is not repeated at the end.

    Returns
    -------
    (n, 2) array

    Raises
    ------
    InvalidPolygon
        Where there are fewer than three vertices, a vertex repeats the one before it, or edges
        cross, touch or overlap.
    InvalidPoint
        Where a coordinate is not finite or is larger than 1e150.

    Examples
    --------
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
    fault = find_ring_fault(ring)
    if fault.kind != SIMPLE:
        raise InvalidPolygon(describe_ring_fault(ring, fault, name))
    return counter_clockwise(ring)


@compiled
def find_ring_fault(ring: Array) -> RingFault:
    """The first reason why three or more vertices are not a simple polygon."""
    n = len(ring)
    for i in range(n):
        j = (i + 1) % n
        if ring[i, 0] == ring[j, 0] and ring[i, 1] == ring[j, 1]:
            return RingFault(REPEATS, i, j)
    if ring_orientation(ring) == 0:
        return RingFault(NO_AREA, -1, -1)
    i, j = find_crossing(ring)
    return RingFault(CROSSES if i >= 0 else SIMPLE, i, j)


def describe_ring_fault(ring: Array, fault: RingFault, name: str) -> str:
    """What is wrong with a polygon, in words."""
    kind, i, j = fault
    a, b, c, d = (tuple(ring[k % len(ring)].tolist()) for k in (i, i + 1, j, j + 1))
    key = "repeats_first" if kind == REPEATS and j == 0 else FAULTS[kind]
    return get_message(f"ring.{key}", name=name, i=i, j=j, a=a, b=b, c=c, d=d)


@compiled
def counter_clockwise(ring: Array) -> Array:
    """A simple polygon with its vertices counter-clockwise."""
    return ring if ring_orientation(ring) > 0 else ring[::-1].copy()


def as_convex_ring(vertices: ArrayLike, name: str = "polygon") -> Array:
    """The vertices of a convex polygon in counter-clockwise order; straight angles are allowed.

    Parameters and result are those of `as_ring`.

    Raises
    ------
    InvalidPolygon
        Where the polygon is not simple or not convex.
    InvalidPoint
        Where a coordinate is not finite or is larger than 1e150.
    """
    ring = as_ring(vertices, name)
    i = find_reflex_vertex(ring)
    if i >= 0:
        raise InvalidPolygon(
            f"{name} must be convex, but turns inward at vertex {tuple(ring[i].tolist())}"
        )
    return ring


@compiled
def ring_orientation(ring: Array) -> int:
    """1 for a counter-clockwise ring, -1 for a clockwise ring, 0 for a ring without area.

    It is the orientation at the leftmost vertex, the lowest of several.
    """
    low = leftmost_corner(ring)
    before, after = ring[low - 1], ring[(low + 1) % len(ring)]
    return orientation_sign(before[0], before[1], ring[low, 0], ring[low, 1], after[0], after[1])


@compiled
def leftmost_corner(ring: Array) -> int:
    """The number of the leftmost vertex, the lowest of several; it is a corner of the hull too."""
    low = 0
    for i in range(1, len(ring)):
        if ring[i, 0] < ring[low, 0] or (ring[i, 0] == ring[low, 0] and ring[i, 1] < ring[low, 1]):
            low = i
    return low


@compiled
def find_reflex_vertex(ring: Array) -> int:
    """The first vertex at which a counter-clockwise ring turns right, or -1."""
    for i in range(len(ring)):
        a, b, c = ring[i - 1], ring[i], ring[(i + 1) % len(ring)]
        if orientation_sign(a[0], a[1], b[0], b[1], c[0], c[1]) < 0:
            return i
    return -1


@compiled
def find_crossing(ring: Array) -> tuple[int, int]:
    """The first two edges that share more than the vertex between them, or (-1, -1).

    Edge i starts at vertex i. O(n^2), exact.
    """
    n = len(ring)
    for i in range(n):
        a, b = ring[i], ring[(i + 1) % n]
        c = ring[(i + 2) % n]
        if (
            orientation_sign(a[0], a[1], b[0], b[1], c[0], c[1]) == 0
            and dot_sign(b[0], b[1], a[0], a[1], c[0], c[1]) > 0
        ):
            return i, (i + 1) % n
        for j in range(i + 2, n if i > 0 else n - 1):
            c, d = ring[j], ring[(j + 1) % n]
            if segments_meet(a[0], a[1], b[0], b[1], c[0], c[1], d[0], d[1]):
                return i, j
    return -1, -1
