"""The place of a bug, and which of two places is nearer to the goal."""

from fractions import Fraction
from typing import NamedTuple

Position = tuple[float, float]


class Place(NamedTuple):
    """The place of a robot; two places are the same where all their fields are.

    x, y : the position.
    distance : from there to the goal.
    on_line : whether it lies on the start-goal line.
    is_open : whether the wall that the robot touches, if any, lets it move towards the goal.
    wall, along : the edge that it touches, -1 for none, and the fraction of the edge, from 0 to 1;
        0 is a corner.
    made_of : the points from which x and y were computed: the goal g for a point that was given;
        g, a, b for the point of a-b nearest to g; g, a, b, o for the crossing of a-b with o-g.
    """

    x: float
    y: float
    distance: float
    on_line: bool
    is_open: bool
    wall: int
    along: float
    made_of: tuple[Position, ...]

    def is_nearer_than(self, other: "Place") -> bool:
        """Whether this place is nearer to the goal than another; exact, by fractions if needed.

        Two places may be at one point, on two sides of where obstacles touch. Then the open one
        counts as nearer.
        """
        if abs(self.distance - other.distance) > 1e-12 * (self.distance + other.distance):
            return self.distance < other.distance
        if self == other:
            return False
        return (exact_squared_distance(self), not self.is_open) < (
            exact_squared_distance(other),
            not other.is_open,
        )


def exact_squared_distance(place: Place) -> Fraction:
    """The squared distance from a place to the goal, without rounding."""
    (gx, gy), *others = [(Fraction(x), Fraction(y)) for x, y in place.made_of]
    if not others:
        return (Fraction(place.x) - gx) ** 2 + (Fraction(place.y) - gy) ** 2
    (ax, ay), (bx, by), *origin = others
    ux, uy = bx - ax, by - ay
    goal_height = ux * (gy - ay) - uy * (gx - ax)
    if not origin:
        return goal_height**2 / (ux**2 + uy**2)
    ((ox, oy),) = origin
    origin_height = ux * (oy - ay) - uy * (ox - ax)
    fraction_left = goal_height / (goal_height - origin_height)
    return fraction_left**2 * ((gx - ox) ** 2 + (gy - oy) ** 2)
