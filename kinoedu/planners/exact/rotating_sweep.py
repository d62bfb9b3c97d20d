"""A rotating sweep: the points that are visible from a point.

    VISIBLE-VERTICES(v, S)
     1  sort the corners of S by direction from v, those in one direction by distance
     2  insert into an empty tree T the edges that the first ray crosses, ordered from v outwards
     3  for each direction in turn:
     4      delete from T the edges that end on the ray
     5      for each corner on the ray, from v outwards: it is visible unless the motion has
     6          entered an obstacle at the corner before, or the first edge of T lies between
     7      insert into T the edges that begin on the ray

One sweep is made for each family of edges (corners.py); a point is visible where no family hides
it. All comparisons are exact orientations, so collinear corners, edges along the ray and corners
that touch need no special treatment.

D. T. Lee, "Proximity and reachability in the plane" (1978); M. de Berg, O. Cheong, M. van Kreveld,
M. Overmars, Computational Geometry, section 15.2.
"""

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...compiled import compiled, inlined
from ...decomposition.status import ABOVE, HIGH, LOW, NOBODY, insert_above, remove
from ...geometry.checks import Array
from ...geometry.exact import orientation_sign
from .corners import enters

Numbers = NDArray[np.int64]


@inlined
def visible_from(corners: Any, v: int, status: Numbers) -> NDArray[np.bool_]:
    """Whether the motion from point v to each point is semi-free, (n,). O(n log n) a family."""
    points = corners.points
    order, group = sort_by_direction(points, v)
    visible = np.ones(len(points), np.bool_)
    for family in range(len(corners.after)):
        hide(
            points, corners.before[family], corners.after[family], v, order, group, status, visible
        )
    hide_along_seams(corners.before, corners.after, v, order, group, visible)
    return visible


@compiled
def hide(
    points: Array,
    before: Numbers,
    after: Numbers,
    v: int,
    order: Numbers,
    group: Numbers,
    status: Numbers,
    visible: NDArray[np.bool_],
) -> None:
    """Mark as hidden the points that one family of edges hides from v.

    Edge i leads from point i to after[i]; its row in the status is i + 1.
    """
    sides = sides_of(points, after, v)
    status[:] = NOBODY
    for i in range(len(points)):
        begin, end = (i, after[i]) if sides[i] > 0 else (after[i], i)
        if sides[i] != 0 and group[begin] > group[end]:
            insert(points, after, sides, i, status)
    first = 0
    while first < len(order):
        stop = first + 1
        while stop < len(order) and group[order[stop]] == group[order[first]]:
            stop += 1
        for p in order[first:stop]:
            if after[p] >= 0:
                if sides[before[p]] > 0:
                    remove(status, before[p] + 1)
                if sides[p] < 0:
                    remove(status, p + 1)
        nearest, at, hidden = status[NOBODY, ABOVE] - 1, v, False
        for p in order[first:stop]:
            hidden = hidden or (after[at] >= 0 and enters(points, before[at], at, after[at], p))
            hidden = hidden or (nearest >= 0 and side(points, nearest, after, p) == -sides[nearest])
            visible[p] = visible[p] and not hidden
            at = p if after[p] >= 0 else at
        for p in order[first:stop]:
            if after[p] >= 0:
                if sides[before[p]] < 0:
                    insert(points, after, sides, before[p], status)
                if sides[p] > 0:
                    insert(points, after, sides, p, status)
        first = stop


@compiled
def hide_along_seams(
    before: Numbers,
    after: Numbers,
    v: int,
    order: Numbers,
    group: Numbers,
    visible: NDArray[np.bool_],
) -> None:
    """Mark as hidden the points that a motion reaches only along a seam.

    A seam is the stretch between two neighbouring corners along which two obstacles touch.
    """
    at, hidden = v, False
    for i in range(len(order)):
        p = order[i]
        if i > 0 and group[p] != group[order[i - 1]]:
            at, hidden = v, False
        hidden = hidden or bool(np.any(after[:, at] == p) and np.any(before[:, at] == p))
        visible[p] = visible[p] and not hidden
        at = p


@compiled
def sides_of(points: Array, after: Numbers, v: int) -> Numbers:
    """How each edge turns round v: 1 counter-clockwise, -1 clockwise, 0 in line or no edge."""
    sides = np.zeros(len(points), np.int64)
    for i in range(len(points)):
        if after[i] >= 0:
            sides[i] = side(points, i, after, v)
    return sides


@compiled
def side(points: Array, edge: int, after: Numbers, p: int) -> int:
    """1 where a point is to the left of an edge, -1 to its right, 0 on its line; exact."""
    end = after[edge]
    return orientation_sign(
        points[edge, 0], points[edge, 1], points[end, 0], points[end, 1], points[p, 0], points[p, 1]
    )


@compiled
def insert(points: Array, after: Numbers, sides: Numbers, edge: int, status: Numbers) -> None:
    """Insert an edge among those that the ray crosses, ordered from its origin v outwards.

    `sides` says how each edge turns round v.
    """
    below, here = NOBODY, status[NOBODY, HIGH]
    while here != NOBODY:
        if is_nearer(points, after, sides, here - 1, edge):
            below, here = here, status[here, HIGH]
        else:
            here = status[here, LOW]
    insert_above(status, below, edge + 1)


@compiled
def is_nearer(points: Array, after: Numbers, sides: Numbers, edge: int, other: int) -> bool:
    """Whether a ray from v that crosses both edges crosses `edge` first.

    The edges may share an end, but do not cross.
    """
    first = side(points, edge, after, other) * sides[edge]
    second = side(points, edge, after, after[other]) * sides[edge]
    if first * second >= 0:
        return first + second < 0  # the other edge lies behind the line of this one
    first = side(points, other, after, edge) * sides[other]
    second = side(points, other, after, after[edge]) * sides[other]
    return first + second > 0


@compiled
def sort_by_direction(points: Array, v: int) -> tuple[Numbers, Numbers]:
    """Sort the other points counter-clockwise round v from the left, near before far.

    They are sorted by rounded angles first, and then by exact comparisons, which change
    little.

    Returns
    -------
    The sorted points, and the number of each point's direction, (n,).
    """
    angles = np.empty(len(points))
    for i in range(len(points)):
        angles[i] = math.atan2(points[i, 1] - points[v, 1], points[i, 0] - points[v, 0])
    order = np.argsort(angles, kind="mergesort")
    order = order[order != v]
    for i in range(1, len(order)):
        p, at = order[i], i
        while at > 0 and comes_before(points, v, p, order[at - 1]):
            order[at] = order[at - 1]
            at -= 1
        order[at] = p
    group, number = np.full(len(points), -1), 0
    for i in range(len(order)):
        if i > 0 and direction_order(points, v, order[i - 1], order[i]) != 0:
            number += 1
        group[order[i]] = number
    return order, group


@compiled
def comes_before(points: Array, v: int, p: int, q: int) -> bool:
    """Whether the ray meets p before q: in an earlier direction, or nearer in the same one."""
    earlier = direction_order(points, v, p, q)
    if earlier != 0:
        return earlier < 0
    if points[p, 0] != points[q, 0]:
        return (points[p, 0] < points[q, 0]) == (points[p, 0] > points[v, 0])
    return (points[p, 1] < points[q, 1]) == (points[p, 1] > points[v, 1])


@compiled
def direction_order(points: Array, v: int, p: int, q: int) -> int:
    """-1 where p's direction from v comes before q's, 1 after, 0 the same; from the left on."""
    half, other = half_plane(points, v, p), half_plane(points, v, q)
    if half != other:
        return -1 if half < other else 1
    return -orientation_sign(
        points[v, 0], points[v, 1], points[p, 0], points[p, 1], points[q, 0], points[q, 1]
    )


@compiled
def half_plane(points: Array, v: int, p: int) -> int:
    """0 below v, 1 level with it on the right or above, 2 level with it on the left."""
    if points[p, 1] == points[v, 1]:
        return 1 if points[p, 0] > points[v, 0] else 2
    return 0 if points[p, 1] < points[v, 1] else 1
