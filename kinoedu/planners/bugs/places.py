"""The places of interest round the walls, in the order in which a robot meets them.

They are the corners, the points inside an edge that are nearest to the goal or on the start-goal
line, and the points where a wall was hit.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...compiled import compiled
from ...errors import InvalidWorld
from ...geometry.checks import Array
from ...geometry.exact import length, orientation_sign
from ...geometry.segments import proper_crossing
from .contact import BLOCKED, WallReadings, crossing_fraction
from .place import CROSSING, FOOT, GIVEN, Place
from .walls import Walls

START, GOAL = 0, 1  # the numbers of the places off the walls


class Places(NamedTuple):
    """The fields of `Place` as arrays, one row for each place.

    points : (n, 8), the coordinates of g, a, b and o.
    ahead, behind : the next place and the one before, along a wall with the obstacle on the left.
    first : for each edge the place at the corner where it begins.
    size : (1,), the number of places.
    """

    at: Array
    distance: Array
    on_line: NDArray[np.bool_]
    is_open: NDArray[np.bool_]
    wall: NDArray[np.int64]
    along: Array
    found: NDArray[np.int64]
    points: Array
    ahead: NDArray[np.int64]
    behind: NDArray[np.int64]
    first: NDArray[np.int64]
    size: NDArray[np.int64]


@compiled
def lay_places(walls: Walls, readings: WallReadings, start: Array, goal: Array) -> Places:
    """The places of interest before a robot starts."""
    edges = len(walls.points)
    places = empty_places(6 * edges + 8, edges)  # a hit comes after a leave from another place
    for at in (start, goal):
        add_place(places, at, (True, True), (-1, 0.0), GIVEN, (goal, at, at, at))
    for i in range(edges):
        a, b = walls.points[i], walls.points[walls.after[i]]
        known, crosses = (goal, a, b, start), readings.crossing[i] > 0.0
        foot_at, crossing_at = readings.foot_at[i], readings.crossing_at[i]
        foot, crossing, open_edge = readings.foot[i], readings.crossing[i], readings.faces[i]
        has_foot = foot > 0.0 and foot != crossing
        can_leave = (readings.on_line[i], readings.opens[i] != BLOCKED)
        places.first[i] = add_place(places, a, can_leave, (i, 0.0), GIVEN, known)
        if has_foot and not crossing < foot:
            add_place(places, foot_at, (False, open_edge), (i, foot), FOOT, known)
        if crosses:
            add_place(places, crossing_at, (True, open_edge), (i, crossing), CROSSING, known)
        if has_foot and crossing < foot:
            add_place(places, foot_at, (False, open_edge), (i, foot), FOOT, known)
    for k in range(GOAL + 1, places.size[0]):
        is_last = k + 1 == places.size[0] or places.wall[k + 1] != places.wall[k]
        link_places(places, k, places.first[walls.after[places.wall[k]]] if is_last else k + 1)
    return places


@compiled
def empty_places(most: int, edges: int) -> Places:
    """Room for places."""
    return Places(
        np.empty((most, 2)),
        np.empty(most),
        np.empty(most, np.bool_),
        np.empty(most, np.bool_),
        np.empty(most, np.int64),
        np.empty(most),
        np.empty(most, np.int64),
        np.empty((most, 8)),
        np.empty(most, np.int64),
        np.empty(most, np.int64),
        np.empty(edges, np.int64),
        np.zeros(1, np.int64),
    )


@compiled
def add_place(
    places: Places,
    at: Array,
    can_leave: tuple[bool, bool],
    where: tuple[int, float],
    found: int,
    points: tuple[Array, Array, Array, Array],
) -> int:
    """Add a place, and return its number.

    Parameters
    ----------
    can_leave : whether it is on the start-goal line, and whether it is open.
    where : the edge and the fraction of it.
    points : g, a, b, o.
    """
    k = places.size[0]
    if k == len(places.at):
        raise InvalidWorld(
            "the walls lie closer together than floats of their size can represent; move them apart"
        )
    places.size[0] = k + 1
    goal = points[0]
    places.at[k] = at
    places.distance[k] = length(goal[0] - at[0], goal[1] - at[1])
    places.on_line[k], places.is_open[k] = can_leave
    places.wall[k], places.along[k] = where
    places.found[k] = found
    for i in range(4):
        places.points[k, 2 * i], places.points[k, 2 * i + 1] = points[i][0], points[i][1]
    return int(k)


@compiled
def link_places(places: Places, k: int, ahead: int) -> None:
    """Make a place the next one ahead of another."""
    places.ahead[k], places.behind[ahead] = ahead, k


@compiled
def place_at(places: Places, k: int) -> Place:
    """The place of a number."""
    p = places.points[k]
    return Place(
        float(places.at[k, 0]),
        float(places.at[k, 1]),
        float(places.distance[k]),
        bool(places.on_line[k]),
        bool(places.is_open[k]),
        int(places.wall[k]),
        float(places.along[k]),
        int(places.found[k]),
        (
            float(p[0]),
            float(p[1]),
            float(p[2]),
            float(p[3]),
            float(p[4]),
            float(p[5]),
            float(p[6]),
            float(p[7]),
        ),
    )


@compiled
def place_of_hit(
    places: Places, walls: Walls, wall: int, is_open: bool, origin: Array, goal: Array
) -> int:
    """The place where the line from origin to goal meets an edge, from now on of interest.

    It is a place already where an earlier line to the goal met the edge at the same point: where
    the two lines are the same, exactly.
    """
    a, b = walls.points[wall], walls.points[walls.after[wall]]
    along = crossing_fraction(a[0], a[1], b[0], b[1], origin[0], origin[1], goal[0], goal[1])
    k = places.first[wall]
    ahead = places.ahead[k]
    while places.wall[ahead] == wall:
        ox, oy = places.points[ahead, 6], places.points[ahead, 7]
        is_same_line = orientation_sign(ox, oy, goal[0], goal[1], origin[0], origin[1]) == 0
        if places.found[ahead] == CROSSING and is_same_line:
            return int(ahead)
        if places.along[ahead] <= along:
            k = ahead
        ahead = places.ahead[ahead]
    ahead = places.ahead[k]
    if places.along[k] == along:
        return int(k)
    at = proper_crossing(a, b, origin, goal)
    hit = add_place(places, at, (False, is_open), (wall, along), CROSSING, (goal, a, b, origin))
    link_places(places, k, hit)
    link_places(places, hit, ahead)
    return hit
