"""Traps: small problems in which planners with a known kind of mistake give themselves away."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ..errors import InvalidParameter
from ..geometry.checks import Array
from ..problems import Problem, ProblemRecord
from ..problems.configurations import space_of
from ..robots import Disk, Point
from ..robots.kinds import Robot
from ..robots.round import RoundRobot
from ..support.text import shortened
from ..worlds import PolygonWorld, Terrain
from ..worlds.checks import World

SIDE = 10.0  # of the room, in units of the trap
ROOM = ((0, 0), (SIDE, 0), (SIDE, SIDE), (0, SIDE))
LEFT, RIGHT = (2.0, 5.0), (8.0, 5.0)
PILLAR = ((4, 3), (6, 3), (6, 7), (4, 7))
CLOSED = ((6.5, 3.5), (9.5, 3.5), (9.5, 6.5), (6.5, 6.5))
CELL = ((6.7, 3.7), (9.3, 3.7), (9.3, 6.3), (6.7, 6.3))
NOTCHED = ((0, 0), (SIDE, 0), (SIDE, SIDE), (7, SIDE), (7, 4), (3, 4), (3, SIDE), (0, SIDE))
THIN = 1e-6


class Trap(NamedTuple):
    """A problem with what is known of it.

    Attributes
    ----------
    name : in words.
    solvable : whether there is a path. Where there is none, every path is wrong.
    must_find : whether every planner should find the path.
    """

    name: str
    problem: ProblemRecord
    solvable: bool
    must_find: bool = False


def wall(width: float, door: float) -> list[Any]:
    """A wall across the room with a door in the middle, or without one."""
    left, right = 5.0 - width / 2.0, 5.0 + width / 2.0
    stretches = ((0.0, SIDE),) if door == 0 else ((0.0, 5.0 - door / 2), (5.0 + door / 2, SIDE))
    return [[(left, a), (right, a), (right, b), (left, b)] for a, b in stretches]


def traps_for(robot: Robot | None = None) -> tuple[Trap, ...]:
    """The traps for a robot of the plane: the same rooms, in units that fit its size.

    Parameters
    ----------
    robot : Point() by default; a Disk, a polygon or a Car. Only a point has the traps of narrow
        doors, of bitmaps, and of a disc and a clearance that do not fit.

    Returns
    -------
    tuple of Trap

    Raises
    ------
    InvalidParameter
        For a robot that does not move about the plane, such as an arm.

    Examples
    --------
    >>> [trap.name for trap in traps_for() if not trap.solvable][:3]
    ['a goal that is walled in', 'a thin wall', 'a start in an obstacle']
    """
    given: Any = Point() if robot is None else robot
    unit = unit_for(given)

    def trap(
        name: str,
        obstacles: list[Any],
        solvable: bool,
        *,
        room: ArrayLike = ROOM,
        ends: tuple[ArrayLike, ArrayLike] = (LEFT, RIGHT),
        must_find: bool = False,
    ) -> Trap:
        scaled = [scale_obstacle(obstacle, unit) for obstacle in obstacles]
        world = PolygonWorld(unit * np.asarray(room, float), scaled)
        return Trap(name, problem_between(given, world, unit, ends), solvable, must_find)

    common = (
        trap("an empty room", [], True, must_find=True),
        trap("a start at the goal", [PILLAR], True, ends=(LEFT, LEFT), must_find=True),
        trap("a pillar in the way", [PILLAR], True),
        trap("a goal that is walled in", [(CLOSED, [CELL])], False),
        trap("a thin wall", wall(THIN, 0.0), False),
        trap("a thin wall with a door", wall(THIN, 2.5), True, ends=((2, 9), (8, 9))),
        trap("a room with a notch", [], True, room=NOTCHED, ends=((1.5, 8), (8.5, 8))),
        trap("a start in an obstacle", [PILLAR], False, ends=((5, 5), RIGHT)),
        trap("a goal in an obstacle", [PILLAR], False, ends=(LEFT, (5, 5))),
        trap("a start outside the world", [PILLAR], False, ends=((-2, 5), RIGHT)),
        trap("a goal outside the world", [PILLAR], False, ends=(LEFT, (12, 5))),
        trap("many obstacles", columns(), True, ends=((1, 1), (9, 9))),
    )
    is_point = isinstance(given, RoundRobot) and given.radius == 0.0
    return (*common, *traps_for_a_point()) if is_point else common


def traps_for_a_point() -> tuple[Trap, ...]:
    """Traps whose robot or world is special."""
    narrow = PolygonWorld(ROOM, wall(2.0, 0.8))
    small = [1e-3 * np.array(PILLAR) + 1000.0]
    far = PolygonWorld(1e-3 * np.array(ROOM) + 1000.0, small)
    near_end, far_end = (1e-3 * np.array(q) + 1000.0 for q in (LEFT, RIGHT))
    return (
        Trap("a narrow door", Problem(Point(), narrow, (2, 3), (8, 7)), True),
        Trap("a disc wider than the door", Problem(Disk(0.5), narrow, LEFT, RIGHT), False),
        Trap(
            "a clearance wider than the door",
            Problem(Point(), narrow, LEFT, RIGHT, clearance=0.5),
            False,
        ),
        Trap("a disc and a pillar", disc_and_pillar(), True),
        Trap("a small room far away", Problem(Point(), far, near_end, far_end), True),
        Trap(
            "cells that meet at a corner",
            Problem(Point(), Terrain([[1, 0], [0, 1]]), (0.5, 0.5), (1.5, 1.5)),
            False,
        ),
        Trap("a bitmap with a door", Problem(Point(), bitmap(), (1.5, 5.5), (8.5, 5.5)), True),
    )


def disc_and_pillar() -> ProblemRecord:
    """A disc that must go round a pillar, where a point could pass nearer."""
    return Problem(Disk(0.8), PolygonWorld(ROOM, [PILLAR]), LEFT, RIGHT)


def bitmap() -> Any:
    """A wall of cells with a door at its upper end."""
    free = np.ones((10, 10), bool)
    free[:8, 5] = False
    return Terrain(free)


def columns() -> list[Any]:
    """Triangles in rows, between which there are many ways."""
    return [
        [(x, y), (x + 0.9, y + 0.2), (x + 0.3, y + 0.8)]
        for i, x in enumerate((2.0, 4.0, 6.0, 8.0))
        for y in np.arange(1.0 + 0.7 * (i % 2), 9.0, 2.2)
    ]


def scale_obstacle(obstacle: Any, unit: float) -> Any:
    """An obstacle, or one with a room, in the world's unit of length."""
    if len(obstacle) == 2:
        return unit * np.array(obstacle[0]), [unit * np.array(room) for room in obstacle[1]]
    return unit * np.array(obstacle)


def unit_for(robot: Any) -> float:
    """The length of a trap's unit: 1 for a point, else three to four times the robot's radius."""
    if isinstance(robot, RoundRobot):
        return 4.0 * robot.radius or 1.0
    outline = getattr(robot, "outline", None)
    if outline is None:
        raise InvalidParameter(
            "there are traps for a Point, a Disk, a polygon or a Car; for another robot give "
            f"traps=, a list of kinoedu.contracts.Trap, got {shortened(robot)}"
        )
    return float(3.0 * np.sqrt((np.asarray(outline) ** 2).sum(axis=1)).max())


def problem_between(
    robot: Any, world: World, unit: float, ends: tuple[ArrayLike, ArrayLike]
) -> ProblemRecord:
    """A problem whose start and goal need not be free, as those of a `Problem` must."""
    space = space_of(robot, world)
    start, goal = (posed(unit * np.asarray(q, float), len(space.lo)) for q in ends)
    return ProblemRecord(robot, world, space, start, goal, 0.0, np.zeros(2, np.int64))


def posed(place: Array, d: int) -> Array:
    """A place as a configuration of d numbers, with heading 0."""
    return np.append(place, np.zeros(d - 2))
