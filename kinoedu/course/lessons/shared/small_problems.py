"""Small problems for planner exercises; some of them trap wrong programs."""

from numpy.typing import ArrayLike

from ....problems import Problem
from ....robots import Point
from ....worlds import PolygonWorld
from ...shapes import Value
from ...tasks import StudentProblem

SQUARE = [(0, 0), (10, 0), (10, 10), (0, 10)]


def in_room(start: ArrayLike, goal: ArrayLike, *obstacles: Value) -> StudentProblem:
    """Problem of a point among obstacles, in a room of 10 x 10."""
    return StudentProblem(Problem(Point(), PolygonWorld(SQUARE, obstacles), start, goal))


def box(x0: float, y0: float, x1: float, y1: float) -> list[tuple[float, float]]:
    """Vertices of a box, counter-clockwise."""
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


ROOM = in_room((2, 3), (8, 7))
SAME = in_room((4, 5), (4, 5))
WALL = in_room((2, 2), (8, 2), box(4.5, 0, 5.5, 7))
# a wall near the goal that is thinner than any step
THIN = in_room((2, 5), (8.4, 5), box(7.9, 3, 7.91, 7))
PASSAGE = in_room((2, 8), (8, 2), box(4, 0, 6, 4.3), box(4, 5.7, 6, 10))
SEALED = in_room((2, 2), (8, 8), box(6, 6, 10, 6.4), box(6, 6, 6.4, 10))
TRAPS = {
    "room": ROOM,
    "same": SAME,
    "wall": WALL,
    "thin": THIN,
    "passage": PASSAGE,
    "sealed": SEALED,
}
