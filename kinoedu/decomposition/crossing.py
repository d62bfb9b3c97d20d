"""What happens on the sweep line at one x: what ends there is merged with what begins there, from
the bottom upwards.

The line is walked in *stretches*: from a place where both its left and its right side are solid to
the next such place. On the way there are points, at which edges end and begin, and edges that pass;
each point and each passing edge is a level. Edges that end or pass bound the cells to the left,
those that begin or pass the cells to the right, and two cells share a wall where their levels
overlap. So a vertical edge needs no treatment: it is where one side is solid and the other free.

Every comparison is exact, so the order on the line is never wrong: either all edges are apart, or a
vertex is found on the wrong side of an edge next to it, and then two have crossed (M. I. Shamos, D.
Hoey, "Geometric intersection problems", 1976); or edges overlap; or floors and ceilings do not take
turns, because one obstacle lies in another.
"""

from typing import Any

import numpy as np

from ..compiled import compiled, inlined
from ..geometry.checks import Array
from ..geometry.exact import turn
from .cells import settle
from .slopes import line_up
from .status import ABOVE, BELOW, CELL, HIGH, LOW, NOBODY

CROSSED = -1  # instead of an answer: edges cross or overlap, or one obstacle lies in another
# where Sweep.walk is: the next vertex; the next edge, as a node's floor or ceiling; cells ended,
# edges begun, levels passed
MET, NODE, ON_CEILING, ENDED, BEGUN, LEVEL = range(6)


@inlined
def cross(sweep: Any, met: int, stop: int) -> int:
    """Cross the lowest stretch that holds vertices order[met:stop], all of one x; returns how many
    are met then, or CROSSED.
    """
    node, walk, x = lowest_touched(sweep, met), sweep.walk, sweep.vertices[sweep.order[met], 0]
    if node == CROSSED:
        return CROSSED
    below = sweep.nodes[node, BELOW]
    walk[MET], walk[NODE], walk[ON_CEILING], walk[ENDED], walk[BEGUN], walk[LEVEL] = (
        met,
        node,
        0,
        0,
        0,
        0,
    )
    while walk[MET] == met or walk[ON_CEILING] == 1 or walk[BEGUN] % 2 == 1:
        y = sweep.vertices[sweep.order[walk[MET]], 1] if walk[MET] < stop else np.inf
        edge = next_edge(sweep)
        if edge >= 0 and (walk[MET] == stop or side(sweep.ends, edge, x, y) > 0):
            ordered = pass_edge(sweep, edge, x, y) and not (
                walk[MET] == met and walk[ON_CEILING] == 0
            )
        else:
            ordered = walk[MET] < stop and meet_point(sweep, x, y, stop)
        if not ordered:
            return CROSSED
        walk[LEVEL] += 1
    return walk[MET] if settle(sweep, x, below, walk[ENDED], walk[BEGUN] // 2) else CROSSED


@inlined
def next_edge(sweep: Any) -> int:
    """The next edge of the status on the walk up the line, -1 above the last."""
    return (
        border(sweep, sweep.walk[NODE], sweep.walk[ON_CEILING])
        if sweep.walk[NODE] != NOBODY
        else -1
    )


@inlined
def pass_edge(sweep: Any, edge: int, x: float, y: float) -> bool:
    """Take an edge that goes on beyond x, below the point (x, y); False where it does not go on."""
    level = sweep.walk[LEVEL]
    lowest = sweep.heights[level - 1] if level > 0 else -np.inf
    sweep.heights[level] = min(max(height_at(sweep.ends, edge, x), lowest), y)
    leave_edge(sweep)
    begin_edge(sweep, edge)
    return sweep.ends[edge, 2] > x


@inlined
def meet_point(sweep: Any, x: float, y: float, stop: int) -> bool:
    """Take all that ends in a point, passes through it or begins at it; False where that does not
    fit what is below and above.
    """
    walk, ends = sweep.walk, sweep.ends
    first, through, unfound = walk[BEGUN], 0, 0
    sweep.heights[walk[LEVEL]] = y
    edge = next_edge(sweep)
    while edge >= 0 and side(ends, edge, x, y) == 0:
        if ends[edge, 2] == x:
            unfound -= 1
        else:
            through += 1
            begin_edge(sweep, edge)
        leave_edge(sweep)
        edge = next_edge(sweep)
    while walk[MET] < stop and sweep.vertices[sweep.order[walk[MET]], 1] == y:
        vertex = sweep.order[walk[MET]]
        for leg in (vertex, sweep.incoming[vertex]):
            if ends[leg, 0] < ends[leg, 2]:
                unfound += ends[leg, 2] == x
                if ends[leg, 0] == x:
                    begin_edge(sweep, leg)
        walk[MET] += 1
    apart = line_up(sweep.begun, ends, first, walk[BEGUN], x, y)
    return apart and through <= 1 and unfound == 0 and (edge < 0 or side(ends, edge, x, y) < 0)


@inlined
def leave_edge(sweep: Any) -> None:
    """Go on from an edge of the status: from a floor to its ceiling, from a ceiling to the floor of
    the next cell.
    """
    walk, ended = sweep.walk, sweep.ended
    if walk[ON_CEILING] == 0:
        ended[walk[ENDED], 0], ended[walk[ENDED], 1] = walk[NODE], walk[LEVEL]
        walk[ON_CEILING] = 1
    else:
        ended[walk[ENDED], 2] = walk[LEVEL]
        walk[NODE], walk[ON_CEILING] = sweep.nodes[walk[NODE], ABOVE], 0
        walk[ENDED] += 1


@inlined
def begin_edge(sweep: Any, edge: int) -> None:
    """Note an edge that leads on to the right, at this level."""
    sweep.begun[sweep.walk[BEGUN], 0], sweep.begun[sweep.walk[BEGUN], 1] = edge, sweep.walk[LEVEL]
    sweep.walk[BEGUN] += 1


@inlined
def lowest_touched(sweep: Any, met: int) -> int:
    """The lowest node whose cell has vertex order[met] on it or below its ceiling, NOBODY where all
    are below; or CROSSED.

    An edge that ends at the vertex leads there at once; otherwise it is found in O(log n).
    """
    nodes, ends = sweep.nodes, sweep.ends
    v = sweep.order[met]
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
        below = nodes[node, BELOW]
        where = 1 if below == NOBODY else side(ends, border(sweep, below, 1), x, y)
        if where != 0:
            return node if where > 0 else CROSSED
        node = below


@inlined
def border(sweep: Any, node: int, on_ceiling: int) -> int:
    """The floor (0) or the ceiling (1) of the open cell at a node of the status."""
    return sweep.sides[sweep.nodes[node, CELL], on_ceiling]


@compiled
def side(ends: Array, edge: int, x: float, y: float) -> int:
    """1 where a point is above an edge, 0 on it, -1 below. Exact."""
    return turn(ends[edge, 0], ends[edge, 1], ends[edge, 2], ends[edge, 3], x, y)


@compiled
def height_at(ends: Array, edge: int, x: float) -> float:
    """The height of an edge at x, reckoned from its nearer end."""
    slope = (ends[edge, 3] - ends[edge, 1]) / (ends[edge, 2] - ends[edge, 0])
    from_left, from_right = x - ends[edge, 0], ends[edge, 2] - x
    return (
        ends[edge, 1] + from_left * slope
        if from_left <= from_right
        else ends[edge, 3] - from_right * slope
    )
