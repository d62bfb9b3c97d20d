"""Motions in time among obstacles that move. A configuration is (x, y, t); a motion is straight, at
a constant speed.

Between two of a mover's times both move straight: seen from the mover, the robot moves straight
past a piece that stands. So each such stretch is judged whole, by the same test as among obstacles
that stand still.
"""

from typing import Any

from ..compiled import inlined
from ..geometry.checks import Array
from ..robots.polygon import TranslatingPolygonRobot
from ..robots.round import RoundRobot
from ..worlds.moving import MovingWorldRecord, place_at
from .asks import is_free_path
from .passing import touches


@is_free_path.register(RoundRobot, MovingWorldRecord)
@is_free_path.register(TranslatingPolygonRobot, MovingWorldRecord)
def free_in_time(
    robot: Any, world: MovingWorldRecord, a: Array, b: Array, clearance: float
) -> bool:
    """Off all that stands and all that moves, at every moment; never back in time, nor anywhere in
    no time.
    """
    if b[2] < a[2] or (b[2] == a[2] and (b[0] != a[0] or b[1] != a[1])):
        return False
    if not is_free_path(robot, world.still, a[:2], b[:2], clearance):
        return False
    for i in range(len(world.shapes.radius)):
        if is_met(robot, world, i, a, b, clearance):
            return False
    return True


@inlined
def is_met(
    robot: Any, world: MovingWorldRecord, i: int, a: Array, b: Array, clearance: float
) -> bool:
    """Whether moving piece i touches the robot on its way from a to b, stretch by stretch between
    the mover's times.
    """
    k, end = world.knots[i, 0], world.knots[i, 1]
    while k < end and world.times[k] <= a[2]:
        k += 1
    x, y = place_at(world.times, world.places, world.knots[i, 0], end, a[2])
    ax, ay = a[0] - x, a[1] - y
    while True:
        then = world.times[k] if k < end and world.times[k] < b[2] else b[2]
        x, y = place_at(world.times, world.places, world.knots[i, 0], end, then)
        share = (then - a[2]) / (b[2] - a[2]) if then < b[2] else 1.0
        bx, by = a[0] + share * (b[0] - a[0]) - x, a[1] + share * (b[1] - a[1]) - y
        if touches(robot, ax, ay, bx, by, world.shapes, i, clearance):
            return True
        if then >= b[2]:
            return False
        ax, ay, k = bx, by, k + 1
