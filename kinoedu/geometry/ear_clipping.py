"""A simple polygon as convex parts: ears are cut off, and then joined again where that is convex.

    CONVEX-PARTS(ring)
     1  while the ring has more than three corners:
     2      find an ear: a corner that turns left, with no other corner in its triangle
     3      cut its triangle off along the diagonal
     4  for each diagonal:
     5      if both its ends still turn left or go straight without it:
     6          remove it

A ring of n corners is cut by n - 3 diagonals, in O(n^2) for most rings and O(n^3) at worst. At most
four times as many parts are left as needed. All signs are exact.

The parts are kept as half-edges, one for each side of each edge. Half-edge h leads from the corner
`origin[h]` along the part to its left, and is followed by `after[h]`.

G. H. Meisters, "Polygons have ears" (1975); S. Hertel, K. Mehlhorn, "Fast triangulation of simple
polygons" (1983).
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..compiled import compiled
from .checks import Array
from .exact import orientation_sign
from .parts import Parts

Numbers = NDArray[np.int64]


class HalfEdges(NamedTuple):
    """Parts of a polygon; the half-edges of a diagonal have the numbers n + 2 k and n + 2 k + 1."""

    origin: Numbers
    after: Numbers
    before: Numbers


@compiled
def cut_into_convex_parts(ring: Array) -> Parts:
    """Convex polygons whose union is exactly a ring, for a ring as `as_ring` returns it."""
    mesh = cut_ears(ring)
    kept = join_convex_parts(ring, mesh)
    points, first, size, parts = np.empty((len(kept), 2)), np.zeros(len(ring), np.int64), 0, 0
    for begin in range(len(kept)):
        edge = begin
        while kept[edge]:
            points[size] = ring[mesh.origin[edge]]
            kept[edge] = False
            size, edge = size + 1, mesh.after[edge]
        if size > first[parts]:
            parts += 1
            first[parts] = size
    return Parts(points[:size].copy(), first[: parts + 1].copy(), np.zeros(parts))


@compiled
def cut_ears(ring: Array) -> HalfEdges:
    """Triangulate a ring: lines 1 to 3."""
    n = len(ring)
    size = 3 * n - 6
    mesh = HalfEdges(np.empty(size, np.int64), np.empty(size, np.int64), np.empty(size, np.int64))
    for i in range(n):
        mesh.origin[i] = i
        follow(mesh, i, (i + 1) % n)
    edge = 0
    for inner in range(n, size, 2):
        edge = find_ear(ring, mesh, edge)
        outer, last = inner + 1, mesh.after[edge]
        mesh.origin[inner], mesh.origin[outer] = mesh.origin[mesh.after[last]], mesh.origin[edge]
        follow(mesh, mesh.before[edge], outer)
        follow(mesh, outer, mesh.after[last])
        follow(mesh, last, inner)
        follow(mesh, inner, edge)
        edge = mesh.after[outer]
    return mesh


@compiled
def find_ear(ring: Array, mesh: HalfEdges, begin: int) -> int:
    """The first half-edge, from `begin` on, that is followed by an ear; a simple ring has two."""
    edge = begin
    while not is_ear(ring, mesh, edge):
        edge = mesh.after[edge]
        if edge == begin:  # the ring is not simple
            break
    return edge


@compiled
def is_ear(ring: Array, mesh: HalfEdges, edge: int) -> bool:
    """Whether the corner after a half-edge is an ear: its triangle can be cut off."""
    end = mesh.after[mesh.after[edge]]
    a, b, c = ring[mesh.origin[edge]], ring[mesh.origin[mesh.after[edge]]], ring[mesh.origin[end]]
    if orientation_sign(a[0], a[1], b[0], b[1], c[0], c[1]) <= 0:
        return False
    other = mesh.after[end]
    while other != edge:
        x, y = ring[mesh.origin[other], 0], ring[mesh.origin[other], 1]
        if (
            orientation_sign(a[0], a[1], b[0], b[1], x, y) >= 0
            and orientation_sign(b[0], b[1], c[0], c[1], x, y) >= 0
            and orientation_sign(c[0], c[1], a[0], a[1], x, y) >= 0
        ):
            return False
        other = mesh.after[other]
    return True


@compiled
def join_convex_parts(ring: Array, mesh: HalfEdges) -> NDArray[np.bool_]:
    """Remove diagonals: lines 4 to 6. Returns which half-edges are left."""
    kept = np.ones(len(mesh.origin), np.bool_)
    for edge in range(len(ring), len(mesh.origin), 2):
        twin = edge + 1
        if is_convex_without(ring, mesh, edge, twin) and is_convex_without(ring, mesh, twin, edge):
            kept[edge] = kept[twin] = False
            follow(mesh, mesh.before[edge], mesh.after[twin])
            follow(mesh, mesh.before[twin], mesh.after[edge])
    return kept


@compiled
def is_convex_without(ring: Array, mesh: HalfEdges, edge: int, twin: int) -> bool:
    """Whether the parts on both sides of a diagonal, joined, do not turn right where it begins."""
    a, b = ring[mesh.origin[mesh.before[edge]]], ring[mesh.origin[edge]]
    c = ring[mesh.origin[mesh.after[mesh.after[twin]]]]
    return orientation_sign(a[0], a[1], b[0], b[1], c[0], c[1]) >= 0


@compiled
def follow(mesh: HalfEdges, edge: int, following: int) -> None:
    """Let one half-edge follow another."""
    mesh.after[edge] = following
    mesh.before[following] = edge
