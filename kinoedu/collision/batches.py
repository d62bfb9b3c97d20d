"""Collision queries for many configurations or motions at once."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..compiled import algorithm
from ..errors import InvalidPoint
from ..geometry.checks import Array, borrow_array, nonnegative
from ..robots.arm import ArmRobot
from ..robots.car import CarRobot
from ..robots.kinds import Robot
from ..robots.polygon import RigidPolygonRobot, TranslatingPolygonRobot
from ..robots.round import RoundRobot
from ..worlds.checks import World, check_world
from .interface import coordinates, is_free, is_free_path


def free_configurations(
    robot: Robot, world: World, qs: ArrayLike, *, clearance: float = 0.0
) -> NDArray[np.bool_]:
    """Whether the robot keeps more than `clearance` from every obstacle, for many configurations.

    Touching is contact, and nothing is free outside the world. For a point robot among polygons the
    result says which points lie in no polygon.

    Parameters
    ----------
    qs : (n, d).

    Returns
    -------
    (n,) array of bool.

    Raises
    ------
    InvalidPoint
        Where qs does not have that shape.
    InvalidWorld
        Where `world` is not a world.
    InvalidParameter
        Where the robot or the clearance is not valid.

    Examples
    --------
    >>> from kinoedu import Point, PolygonWorld
    >>> wall = [(4, 0), (6, 0), (6, 8), (4, 8)]
    >>> world = PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [wall])
    >>> free_configurations(Point(), world, [(1, 1), (5, 5), (6, 5), (11, 5)])
    array([ True, False, False, False])
    """
    check_world(world)
    return judge_configurations(
        robot, world, as_configurations(qs, robot, "qs"), nonnegative(clearance, "clearance")
    )


def free_motions(
    robot: Robot, world: World, a: ArrayLike, b: ArrayLike, *, clearance: float = 0.0
) -> NDArray[np.bool_]:
    """Whether the robot keeps more than `clearance` from every obstacle on many straight motions.

    Parameters
    ----------
    a, b : (n, d); motion i goes from a[i] to b[i].

    Returns
    -------
    (n,) array of bool.

    Raises
    ------
    InvalidPoint
        Where a and b do not have the same shape (n, d).
    InvalidWorld
        Where `world` is not a world.
    InvalidParameter
        Where the robot or the clearance is not valid.

    Examples
    --------
    >>> from kinoedu import Point, PolygonWorld
    >>> wall = [(4, 0), (6, 0), (6, 8), (4, 8)]
    >>> world = PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [wall])
    >>> free_motions(Point(), world, [(1, 1), (1, 9)], [(9, 1), (9, 9)])
    array([False,  True])
    """
    check_world(world)
    starts, ends = as_configurations(a, robot, "a"), as_configurations(b, robot, "b")
    if len(starts) != len(ends):
        raise InvalidPoint(
            f"a and b must hold equally many configurations, got {len(starts)} and {len(ends)}"
        )
    return judge_motions(robot, world, starts, ends, nonnegative(clearance, "clearance"))


@coordinates.register(RoundRobot)
@coordinates.register(TranslatingPolygonRobot)
def position(robot: Robot) -> int:
    """Two: x and y."""
    return 2


@coordinates.register(RigidPolygonRobot)
@coordinates.register(CarRobot)
def pose(robot: Robot) -> int:
    """Three: x, y and theta."""
    return 3


@coordinates.register(ArmRobot)
def joint_angles(robot: ArmRobot) -> int:
    """One angle for each link."""
    return len(robot.lengths)


@algorithm
def judge_configurations(
    robot: Robot, world: World, qs: Array, clearance: float
) -> NDArray[np.bool_]:
    """The result of `is_free` for each row of qs, shape (n,)."""
    free = np.empty(len(qs), np.bool_)
    for i in range(len(qs)):
        free[i] = is_free(robot, world, qs[i], clearance)
    return free


@algorithm
def judge_motions(
    robot: Robot, world: World, a: Array, b: Array, clearance: float
) -> NDArray[np.bool_]:
    """The result of `is_free_path` for each pair of rows, shape (n,)."""
    free = np.empty(len(a), np.bool_)
    for i in range(len(a)):
        free[i] = is_free_path(robot, world, a[i], b[i], clearance)
    return free


def as_configurations(value: ArrayLike, robot: Robot, name: str) -> Array:
    """Check configurations of a robot, shape (n, d); raise InvalidPoint otherwise.

    An empty list holds no configurations. The result may be the given array: only read it.
    """
    size, qs = coordinates(robot), borrow_array(value, name)
    if qs.shape == (0,):
        return qs.reshape(0, size)
    if qs.ndim != 2 or qs.shape[1] != size:
        raise InvalidPoint(
            f"{name} must hold configurations of {size} numbers each, shape (n, {size}), got "
            f"shape {qs.shape}"
        )
    return qs
