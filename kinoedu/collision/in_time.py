"""Collision detection among moving obstacles, for straight motions in (x, y, t).

The speed of the robot is constant. Between two times of a moving obstacle both it and the robot
move along straight lines: relative to the obstacle, the robot moves along a straight line past a
fixed piece. So each such stretch is tested as a whole, by the same test as for fixed obstacles.
"""

from ..compiled import inlined
from ..geometry.checks import Array
from ..robots.kinds import Robot
from ..robots.polygon import TranslatingPolygonRobot
from ..robots.round import RoundRobot
from ..worlds.moving import MovingWorldRecord, position_at
from .interface import is_free_path
from .passing import touches


@is_free_path.register(RoundRobot, MovingWorldRecord)
@is_free_path.register(TranslatingPolygonRobot, MovingWorldRecord)
def is_free_in_time(
    robot: Robot, world: MovingWorldRecord, a: Array, b: Array, clearance: float
) -> bool:
    """Whether the motion touches no fixed and no moving obstacle at any moment.

    It must not go back in time, and must not change the position in no time.
    """
    if b[2] < a[2] or (b[2] == a[2] and (b[0] != a[0] or b[1] != a[1])):
        return False
    if not is_free_path(robot, world.still, a[:2], b[:2], clearance):
        return False
    for i in range(len(world.shapes.radius)):
        if touches_mover(robot, world, i, a, b, clearance):
            return False
    return True


@inlined
def touches_mover(
    robot: Robot, world: MovingWorldRecord, i: int, a: Array, b: Array, clearance: float
) -> bool:
    """Whether moving piece i touches the robot on its way from a to b."""
    k, end = world.knots[i, 0], world.knots[i, 1]
    while k < end and world.times[k] <= a[2]:
        k += 1
    x, y = position_at(world.times, world.places, world.knots[i, 0], end, a[2])
    ax, ay = a[0] - x, a[1] - y
    while True:
        then = world.times[k] if k < end and world.times[k] < b[2] else b[2]
        x, y = position_at(world.times, world.places, world.knots[i, 0], end, then)
        fraction = (then - a[2]) / (b[2] - a[2]) if then < b[2] else 1.0
        bx, by = a[0] + fraction * (b[0] - a[0]) - x, a[1] + fraction * (b[1] - a[1]) - y
        if touches(robot, ax, ay, bx, by, world.shapes, i, clearance):
            return True
        if then >= b[2]:
            return False
        ax, ay, k = bx, by, k + 1
