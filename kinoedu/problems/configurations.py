"""Configuration spaces of the robots, checks of configurations, and reasons for collisions."""

from functools import singledispatch
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..collision import link_in_contact
from ..curves.curve import as_pose
from ..curves.space import CurveSpace
from ..errors import InvalidParameter, InvalidPoint
from ..geometry.checks import Array, as_array
from ..geometry.polygons import point_polygon_distance
from ..messages import get_message
from ..robots.arm import ArmRobot
from ..robots.car import CarRobot
from ..robots.kinds import Robot
from ..robots.polygon import RigidPolygonRobot, TranslatingPolygonRobot
from ..robots.round import RoundRobot
from ..spaces import RealSpace, WrappingSpace
from ..spaces.interface import Space
from ..spaces.wrapping import wrapped_configuration
from ..support.text import shortened
from ..worlds.checks import World


@singledispatch
def space_of(robot: Robot, world: World) -> Any:
    """The configuration space of a robot in a world.

    Returns
    -------
    RealSpace, WrappingSpace or CurveSpace, depending on the kind of robot.

    Raises
    ------
    InvalidParameter
        Where `robot` is not a robot.
    """
    raise InvalidParameter(f"expected a robot such as Point() or Disk(1), got {shortened(robot)}")


@space_of.register
def _(robot: RoundRobot, world: World) -> RealSpace:
    return RealSpace(world.lo, world.hi)


@space_of.register
def _(robot: TranslatingPolygonRobot, world: World) -> RealSpace:
    lo, hi = robot.outline.min(axis=0), robot.outline.max(axis=0)
    # a reference point outside the body may lie outside the world
    return RealSpace(world.lo - np.maximum(lo, 0.0), world.hi - np.minimum(hi, 0.0))


@space_of.register
def _(robot: RigidPolygonRobot, world: World) -> WrappingSpace:
    off = point_polygon_distance((0.0, 0.0), robot.outline)
    lo, hi = np.append(world.lo - off, -np.pi), np.append(world.hi + off, np.pi)
    weight = np.array([1.0, 1.0, robot.turn_weight])
    return WrappingSpace(lo, hi, np.array([False, False, True]), weight)


@space_of.register
def _(robot: CarRobot, world: World) -> CurveSpace:
    return CurveSpace(
        np.append(world.lo, -np.pi), np.append(world.hi, np.pi), robot.radius, robot.both_ways
    )


@space_of.register
def _(robot: ArmRobot, world: World) -> WrappingSpace:
    n = len(robot.lengths)
    return WrappingSpace(np.full(n, -np.pi), np.full(n, np.pi), np.full(n, True), np.ones(n))


def as_configuration(value: ArrayLike, space: Space, name: str) -> Array:
    """Check a configuration of a space.

    Returns
    -------
    (d,) array, with its angles in [-pi, pi).

    Raises
    ------
    InvalidPoint
        Where the value is not d finite numbers.
    """
    q = as_array(value, name)
    if q.shape != space.lo.shape:
        raise InvalidPoint(f"{name} must be {len(space.lo)} numbers, got {shortened(value)}")
    if isinstance(space, CurveSpace):
        return as_pose(q, name)
    return wrapped_configuration(space, q) if isinstance(space, WrappingSpace) else q


@singledispatch
def explain_not_free(robot: Robot, world: World, q: Array, clearance: float) -> str:
    """Explain why a configuration is not free, and say what to change."""
    return get_message("not_free.touches", margin=margin_text(clearance))


@explain_not_free.register
def _(robot: RoundRobot, world: World, q: Array, clearance: float) -> str:
    if (q <= world.lo).any() or (q >= world.hi).any():
        lo, hi = tuple(world.lo.tolist()), tuple(world.hi.tolist())
        return get_message("not_free.outside", lo=lo, hi=hi)
    return explain_not_free.dispatch(object)(robot, world, q, clearance)


@explain_not_free.register
def _(robot: ArmRobot, world: World, q: Array, clearance: float) -> str:
    link = link_in_contact(robot, q, world)
    if not link:
        return (
            f"the arm{margin_text(clearance)} is too near to an obstacle or the boundary of the "
            "world there; choose other angles"
        )
    return (
        f"link {link} touches an obstacle or the boundary of the world there; choose other angles"
    )


def margin_text(clearance: float) -> str:
    """The clearance as text for a message; empty where the clearance is 0."""
    return get_message("not_free.margin", clearance=f"{clearance:g}") if clearance else ""
