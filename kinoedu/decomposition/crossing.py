"""One event of the sweep: edges and cells that end at the line are replaced by those that begin.

Steps 4 to 7 of the algorithm in sweep.py, for vertices in any position. At a point p of the line,
three sets of edges matter (de Berg et al., section 2.1, HandleEventPoint):

| set | edges |
|---|---|
| L(p) | that end at p: it is their right end |
| C(p) | that contain p in their interior |
| U(p) | that begin at p: it is their left end |

Left of the line lie L(p) and C(p), which the status holds; right of it lie C(p) and U(p).

One call of `handle_event` handles the points of one x from one place where both sides of the line
are solid up to the next such place. Each point on the way is a *level* of the line, and so is each
edge that passes between two points. On either side of the line the edges are alternately floors and
ceilings: those on the left bound the cells that end, those on the right the cells that begin, and
two of these cells share a wall where their ranges of levels overlap. A vertical edge needs no
special case: between its levels one side of the line is solid and the other is free.

All comparisons are exact, so the order of the status is always correct. Input that has no
trapezoidation is detected: a vertex on the wrong side of a neighbouring edge shows that two edges
cross (M. I. Shamos, D. Hoey, "Geometric intersection problems", 1976); edges overlap; or floors and
ceilings do not alternate, because one obstacle lies in another.
"""

from typing import Any

import numpy as np

from ..compiled import compiled, inlined
from ..geometry.checks import Array
from ..geometry.exact import orientation_sign
from .cells import CEILING, EDGE, FLOOR, LEVEL, NODE, replace_cells
from .slopes import sort_by_slope
from .status import CELL, HIGH, LOW, NOBODY, next_above, next_below

CROSSED = -1  # returned where edges cross or overlap, or one obstacle lies in another


@inlined
def handle_event(sweep: Any, handled: int, stop: int) -> int:
    """Handle the event points order[handled:stop], all of one x, up to the first solid place.

    Returns the number of vertices that have been handled then, or CROSSED.
    """
    x, ends = sweep.vertices[sweep.order[handled], 0], sweep.ends
    node = lowest_touched(sweep, handled)  # 4: the lowest cell that the walls may reach
    if node == CROSSED:
        return CROSSED
    below, now, left, right, level = next_below(sweep.nodes, node), handled, 0, 0, 0
    while now == handled or is_ceiling(left) or is_ceiling(right):
        y = sweep.vertices[sweep.order[now], 1] if now < stop else np.inf
        edge = edge_of(sweep, node, left)
        if edge >= 0 and (now == stop or side(ends, edge, x, y) > 0):  # 5: it bounds a wall
            if ends[edge, 2] <= x or (now == handled and is_ceiling(left)):
                return CROSSED
            sweep.heights[level] = height_between(sweep, edge, x, level, y)
            node = leave_edge(sweep, node, left, level)
            enter_edge(sweep, edge, right, level)
            left, right = left + 1, right + 1
        elif now < stop:
            now, node, left, right = meet_point(sweep, x, y, now, stop, node, left, right, level)
            if now == CROSSED:
                return CROSSED
        else:
            return CROSSED
        level += 1
    return now if replace_cells(sweep, x, below, left // 2, right // 2) else CROSSED  # 6, 7


@inlined
def meet_point(
    sweep: Any,
    x: float,
    y: float,
    now: int,
    stop: int,
    node: int,
    left: int,
    right: int,
    level: int,
) -> tuple[int, int, int, int]:
    """Handle the event point p = (x, y): L(p) and C(p) on the left, C(p) and U(p) on the right.

    Returns the number of vertices that have been handled, the next node, and how many edges there
    are on the left and on the right; first CROSSED where the edges at p do not fit the status.
    """
    ends, first, passing, missing = sweep.ends, right, 0, 0
    sweep.heights[level] = y
    edge = edge_of(sweep, node, left)
    while edge >= 0 and side(ends, edge, x, y) == 0:
        if ends[edge, 2] == x:  # in L(p)
            missing -= 1
        else:  # in C(p)
            passing += 1
            enter_edge(sweep, edge, right, level)
            right += 1
        node = leave_edge(sweep, node, left, level)
        left += 1
        edge = edge_of(sweep, node, left)
    while now < stop and sweep.vertices[sweep.order[now], 1] == y:
        vertex = sweep.order[now]
        for leg in (vertex, sweep.incoming[vertex]):
            if ends[leg, 0] < ends[leg, 2]:
                missing += ends[leg, 2] == x
                if ends[leg, 0] == x:  # in U(p)
                    enter_edge(sweep, leg, right, level)
                    right += 1
        now += 1
    apart = sort_by_slope(sweep.begun, ends, first, right, x, y)
    fits = passing <= 1 and missing == 0 and (edge < 0 or side(ends, edge, x, y) < 0)
    return (now if apart and fits else CROSSED), node, left, right


@inlined
def edge_of(sweep: Any, node: int, left: int) -> int:
    """The edge of the status that comes after `left` others, at a node; -1 above the last one."""
    return border(sweep, node, left % 2) if node != NOBODY else -1


@inlined
def leave_edge(sweep: Any, node: int, left: int, level: int) -> int:
    """Put edge number `left` of the left side at a level; returns the node of the edge after it."""
    cell = left // 2
    if is_ceiling(left):
        sweep.ended[cell, CEILING] = level
        return next_above(sweep.nodes, node)
    sweep.ended[cell, NODE], sweep.ended[cell, FLOOR] = node, level
    return node


@inlined
def enter_edge(sweep: Any, edge: int, right: int, level: int) -> None:
    """Put an edge at a level of the right side, as number `right`."""
    sweep.begun[right, EDGE], sweep.begun[right, LEVEL] = edge, level


@compiled
def is_ceiling(number: int) -> bool:
    """Whether the edge of this number on one side of the line is a ceiling: 0 is a floor."""
    return number % 2 == 1


@inlined
def height_between(sweep: Any, edge: int, x: float, level: int, y: float) -> float:
    """The height of an edge at x, rounded so that it lies between the level below and y."""
    lowest = sweep.heights[level - 1] if level > 0 else -np.inf
    return min(max(height_at(sweep.ends, edge, x), lowest), y)


@inlined
def lowest_touched(sweep: Any, handled: int) -> int:
    """The node of the lowest cell whose ceiling is not below vertex order[handled]; or CROSSED.

    NOBODY where all cells are below. An edge that ends at the vertex is looked up directly;
    otherwise the cell is found by a binary search, in O(log n).
    """
    nodes, ends = sweep.nodes, sweep.ends
    v = sweep.order[handled]
    x, y, node = sweep.vertices[v, 0], sweep.vertices[v, 1], NOBODY
    for leg in (v, sweep.incoming[v]):
        if ends[leg, 0] < ends[leg, 2] == x:
            node = sweep.place[leg]
    if node == NOBODY:
        descent = nodes[NOBODY, HIGH]
        while descent != NOBODY:
            if side(ends, border(sweep, descent, 1), x, y) > 0:
                descent = nodes[descent, HIGH]
            else:
                node, descent = descent, nodes[descent, LOW]
    while True:
        below = next_below(nodes, node)
        where = 1 if below == NOBODY else side(ends, border(sweep, below, 1), x, y)
        if where != 0:
            return node if where > 0 else CROSSED
        node = below


@inlined
def border(sweep: Any, node: int, which: int) -> int:
    """The floor (0) or the ceiling (1) of the open cell at a node of the status."""
    return sweep.sides[sweep.nodes[node, CELL], which]


@compiled
def side(ends: Array, edge: int, x: float, y: float) -> int:
    """1 where a point is above an edge, 0 on it, -1 below. Exact."""
    return orientation_sign(ends[edge, 0], ends[edge, 1], ends[edge, 2], ends[edge, 3], x, y)


@compiled
def height_at(ends: Array, edge: int, x: float) -> float:
    """The height of an edge at x, computed from its nearer end."""
    slope = (ends[edge, 3] - ends[edge, 1]) / (ends[edge, 2] - ends[edge, 0])
    from_left, from_right = x - ends[edge, 0], ends[edge, 2] - x
    return (
        ends[edge, 1] + from_left * slope
        if from_left <= from_right
        else ends[edge, 3] - from_right * slope
    )
