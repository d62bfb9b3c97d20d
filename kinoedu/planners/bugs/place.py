"""The place of a bug, and which of two places is nearer to the goal."""

from typing import NamedTuple

import numpy as np

from ...compiled import compiled, record
from ...geometry.whole_numbers import (
    Digits,
    difference,
    product,
    sign_of,
    sum_of,
    unit_of,
    whole_number,
)

GIVEN, FOOT, CROSSING = 0, 1, 2  # how a position was found
Points = tuple[float, float, float, float, float, float, float, float]


@record
class Place(NamedTuple):
    """The place of a robot; two places are the same where all their fields are.

    x, y : the position.
    distance : from there to the goal.
    on_line : whether it lies on the start-goal line.
    is_open : whether the wall that the robot touches, if any, lets it move towards the goal.
    wall, along : the edge that it touches, -1 for none, and the fraction of the edge, from 0 to 1;
        0 is a corner.
    found, points : how the position was found from four points g, a, b, o. It was GIVEN, or it is
        the FOOT, the point of a-b nearest to the goal g, or the CROSSING of a-b with o-g.
    """

    x: float
    y: float
    distance: float
    on_line: bool
    is_open: bool
    wall: int
    along: float
    found: int
    points: Points

    def is_nearer_than(self, other: "Place") -> bool:
        """Whether this place is nearer to the goal than another; exact.

        Two places may be at one point, on two sides of where obstacles touch. Then the open one
        counts as nearer.
        """
        if abs(self.distance - other.distance) > 1e-12 * (self.distance + other.distance):
            return self.distance < other.distance
        if self == other:
            return False
        sign = compare_distances(self, other)
        return sign < 0 or (sign == 0 and self.is_open and not other.is_open)


@compiled
def compare_distances(p: Place, q: Place) -> int:
    """The exact sign of the distance from p to the goal minus that from q."""
    unit = min(unit_of_place(p), unit_of_place(q))
    p_above, p_below = squared_distance(p, unit)
    q_above, q_below = squared_distance(q, unit)
    return sign_of(difference(product(p_above, q_below), product(q_above, p_below)))


@compiled
def unit_of_place(place: Place) -> int:
    """An exponent e so that all coordinates of a place and its points are multiples of 2^e."""
    unit = min(unit_of(place.x), unit_of(place.y))
    for x in place.points:
        unit = min(unit, unit_of(x))
    return unit


@compiled
def squared_distance(place: Place, unit: int) -> tuple[Digits, Digits]:
    """The squared distance from a place to the goal, a fraction of whole numbers."""
    gx, gy, ax, ay, bx, by, ox, oy = place.points
    if place.found == GIVEN:
        return squared_length(place.x, place.y, gx, gy, unit), np.ones(1, np.int64)
    goal_height = cross(ax, ay, bx, by, gx, gy, unit)
    square = product(goal_height, goal_height)
    if place.found == FOOT:
        return square, squared_length(ax, ay, bx, by, unit)
    apart = difference(goal_height, cross(ax, ay, bx, by, ox, oy, unit))
    return product(square, squared_length(ox, oy, gx, gy, unit)), product(apart, apart)


@compiled
def squared_length(ax: float, ay: float, bx: float, by: float, unit: int) -> Digits:
    """The squared length of a-b."""
    x, y = between(ax, bx, unit), between(ay, by, unit)
    return sum_of(product(x, x), product(y, y))


@compiled
def cross(ax: float, ay: float, bx: float, by: float, px: float, py: float, unit: int) -> Digits:
    """The cross product of a-b and a-p."""
    left = product(between(ax, bx, unit), between(ay, py, unit))
    return difference(left, product(between(ay, by, unit), between(ax, px, unit)))


@compiled
def between(a: float, b: float, unit: int) -> Digits:
    """The difference b - a."""
    return difference(whole_number(b, unit), whole_number(a, unit))
