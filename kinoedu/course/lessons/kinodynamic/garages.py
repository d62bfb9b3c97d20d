"""Small problems for a car, some of them traps.

The car has three speeds, so that the shortest path is not always the fastest.
"""

import math

from numpy.typing import ArrayLike

from ....problems import Problem
from ....robots import Car
from ....worlds import PolygonWorld
from ...drivable import DrivingProblem
from ...shapes import Value
from ..shared.small_problems import box

CAR = Car(30, 10, 20, speeds=(-1, 0.5, 2))


def make_garage(
    start: ArrayLike, goal: ArrayLike, *obstacles: Value, size: float = 200.0
) -> DrivingProblem:
    """Return the problem of the car among obstacles in a square garage."""
    return DrivingProblem(Problem(CAR, PolygonWorld(box(0, 0, size, size), obstacles), start, goal))


POSTS = [box(x, y, x + 0.5, y + 0.5) for x in range(20, 200, 40) for y in range(20, 200, 40)]
GARAGES = {
    "same": make_garage((60, 60, 0.5), (60, 60, 0.5)),
    "room": make_garage((70, 100, 0), (88, 100, 0)),
    # no wall can be reached
    "turn": make_garage((1500, 1500, 0), (1500, 1500, 1.2), size=3000.0),
    "seam": make_garage((96, 100, 2.92), (80, 103.5, math.pi)),
    "thin": make_garage((35, 40, 0), (115, 80, 0), *POSTS),
    # the goal cannot be reached in the given number of iterations
    "far": make_garage((1500, 1500, 0), (2700, 2400, 1), size=3000.0),
    "sealed": make_garage(
        (50, 50, 0), (165, 165, 0.8), box(130, 130, 200, 131), box(130, 130, 131, 200)
    ),
}
# at the start the car points nearly the opposite way
TURNED = {**GARAGES, "turn": make_garage((1500, 1500, -1.9), (1500, 1500, 1.2), size=3000.0)}
# the goal is far for so few iterations, and its heading is on the other side of pi
BEYOND_PI, FEW = make_garage((1500, 1500, 3.0), (1400, 1500, -3.0), size=3000.0), 20
# the start is just near enough to the goal, in place and heading, and just not near enough
JUST_THERE = make_garage((60, 60, 0.5), (62.99, 63.99, 0.76))
NOT_THERE = make_garage((60, 60, 0.5), (63.03, 64.04, 0.5))
KINDS = tuple(GARAGES)
OPEN = ("turn", "far")  # every drive is free, because no wall can be reached
