"""Figures of robots: a body at a configuration or along a path, and the path of a motion."""

from __future__ import annotations

from functools import singledispatch
from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.patches import Circle, Polygon

from ..curves.curve import Curve
from ..curves.space import pieces_between
from ..geometry.checks import Array
from ..robots.arm import ArmRobot
from ..robots.car import CarRobot
from ..robots.kinds import Robot
from ..robots.moving import displacement, place_piece
from ..robots.polygon import RigidPolygonRobot, TranslatingPolygonRobot
from ..robots.round import RoundRobot
from ..robots.trajectory import TrajectoryRecord, poses_between
from ..spaces import distance, interpolate
from ..spaces.interface import Space
from . import palette
from .bars import draw_bar
from .palette import Style

Outlined = TranslatingPolygonRobot | RigidPolygonRobot | CarRobot

GHOSTS = 12  # bodies shown along a path
BENDS = 12  # segments that draw the path of an arm's tip
CURVED = 40  # segments that draw a car's curve


@singledispatch
def draw_robot(robot: Robot, q: Array, ax: Axes, colour: str = palette.ROBOT) -> list[Artist]:
    """Draw a robot's body at a configuration.

    Raises
    ------
    TypeError
        Where `robot` is not a robot.
    """
    raise TypeError(f"a figure cannot draw a {type(robot).__name__}")


@draw_robot.register
def _(robot: RoundRobot, q: Array, ax: Axes, colour: str = palette.ROBOT) -> list[Artist]:
    if robot.radius == 0.0:
        return []
    look: Style = {"facecolor": colour, "edgecolor": colour, "alpha": 0.35}
    return [ax.add_patch(Circle((q[0], q[1]), robot.radius, zorder=6, **look))]


@draw_robot.register(TranslatingPolygonRobot)
@draw_robot.register(RigidPolygonRobot)
def _(robot: Outlined, q: Array, ax: Axes, colour: str = palette.ROBOT) -> list[Artist]:
    return [ax.add_patch(make_body(robot, q, colour))]


@draw_robot.register
def _(robot: CarRobot, q: Array, ax: Axes, colour: str = palette.ROBOT) -> list[Artist]:
    wheels = [Polygon(wheel, facecolor=palette.INK, zorder=6.2) for wheel in wheels_at(robot, q)]
    return [ax.add_patch(patch) for patch in (make_body(robot, q, colour), *wheels)]


@draw_robot.register
def _(robot: ArmRobot, q: Array, ax: Axes, colour: str = palette.ROBOT) -> list[Artist]:
    places = np.vstack([robot.base, *robot.joints(q)])
    links = zip(places, places[1:], robot.shape.radius)
    bars = [bar for a, b, r in links for bar in draw_bar(a, b, r, ax, colour, alpha=0.35, zorder=6)]
    look: Style = {"color": colour, "markersize": 6, **palette.RIM}
    return [*bars, *ax.plot(*places[:-1].T, "o", zorder=6.5, **look)]


def make_body(robot: Outlined, q: Array, colour: str) -> Polygon:
    """A polygon robot's body at a configuration, tinted."""
    look: Style = {"facecolor": f"{colour}59", "edgecolor": colour, "linewidth": 1.5}
    return Polygon(outline_at(robot, q), zorder=6, **look)


def make_ghost(robot: Outlined, q: Array, **style: Any) -> Polygon:
    """A polygon robot's outline at a configuration on its way."""
    look: Style = {"facecolor": "none", "edgecolor": palette.ROBOT, "linewidth": 1.2}
    return Polygon(outline_at(robot, q), **look, **style)


def outline_at(robot: Outlined, q: Array) -> Array:
    """A polygon robot's outline at (x, y) or (x, y, theta), shape (n, 2)."""
    cos, sin = (np.cos(q[2]), np.sin(q[2])) if len(q) > 2 else (1.0, 0.0)
    return robot.outline @ np.array([[cos, sin], [-sin, cos]]) + q[:2]


def wheels_at(car: CarRobot, q: Array) -> list[Array]:
    """The outlines of a car's four wheels, steered straight, shape (4, 2) each."""
    half = 0.5 * float(np.ptp(car.outline[:, 1]))
    long, broad = 0.18 * car.wheelbase, 0.16 * half
    wheel = np.array([(-long, -broad), (long, -broad), (long, broad), (-long, broad)])
    cos, sin = np.cos(q[2]), np.sin(q[2])
    places = [(x, y) for x in (0.0, car.wheelbase) for y in (broad - half, half - broad)]
    return [(wheel + place) @ np.array([[cos, sin], [-sin, cos]]) + q[:2] for place in places]


@singledispatch
def place_of(robot: Robot, q: Array) -> Array:
    """The point of the plane that shows a configuration: the reference point, or an arm's tip."""
    return q[:2]


@place_of.register
def _(robot: ArmRobot, q: Array) -> Array:
    return robot.joints(q)[-1]


@singledispatch
def tracks(robot: Robot, a: Array, b: Array) -> Array:
    """The paths of that point on motions between configurations (m, d), as polylines (m, k, 2)."""
    return np.stack([a, b], axis=1)[:, :, :2]


@tracks.register
def _(robot: ArmRobot, a: Array, b: Array) -> Array:
    corners, lines = np.empty((2 * len(robot.lengths), 5)), np.empty((len(a), BENDS + 1, 2))
    for line, p, q in zip(lines, a, b):
        change = displacement(robot, p, q)
        for k in range(BENDS + 1):
            place_piece(robot, len(robot.lengths) - 1, p, change, k / BENDS, corners)
            line[k] = corners[-1, :2]
    return lines


@tracks.register
def _(robot: CarRobot, a: Array, b: Array) -> Array:
    fractions, r = np.linspace(0.0, 1.0, CURVED + 1), robot.radius
    curves = [Curve(p, r, *pieces_between(p, q, r, robot.both_ways)) for p, q in zip(a, b)]
    lines = [curve.at(fractions * curve.length)[:, :2] for curve in curves]
    return np.array(lines).reshape(-1, CURVED + 1, 2)


def driven_tracks(
    car: CarRobot, begins: Array, controls: Array, durations: Array, bends: int = BENDS
) -> Array:
    """The paths (m, bends + 1, 2) of drives from poses (m, 3) by controls (m, 2), as polylines."""
    times = durations[:, None] * np.linspace(0.0, 1.0, bends + 1)
    which = np.repeat(np.arange(len(begins)), bends + 1)
    poses = poses_between(begins, controls, car.wheelbase, which, times.ravel())
    return poses[:, :2].reshape(-1, bends + 1, 2)


def even_times(trajectory: TrajectoryRecord) -> Array:
    """Times at which a trajectory is drawn as a polyline: a dozen per control, and both ends."""
    return np.linspace(0.0, trajectory.duration, BENDS * len(trajectory.durations) + 2)


def track_of(robot: Robot, path: Array) -> Array:
    """The path of that point along a path of shape (n, d), as one polyline (k, 2)."""
    lines = tracks(robot, path[:-1], path[1:])
    return np.vstack([place_of(robot, path[0]), *(line[1:] for line in lines)])


@singledispatch
def draw_along(robot: Robot, space: Space, path: Array, ax: Axes) -> list[Artist]:
    """Draw equally spaced bodies along a path; none for a robot that looks the same everywhere."""
    return []


@draw_along.register(TranslatingPolygonRobot)
@draw_along.register(RigidPolygonRobot)
@draw_along.register(CarRobot)
def _(robot: Outlined, space: Space, path: Array, ax: Axes) -> list[Artist]:
    return [ax.add_patch(make_ghost(robot, q)) for q in spread_configurations(space, path)]


@draw_along.register
def _(robot: ArmRobot, space: Space, path: Array, ax: Axes) -> list[Artist]:
    drawn: list[Artist] = []
    for q in spread_configurations(space, path):
        places = np.vstack([robot.base, *robot.joints(q)])
        for a, b, r in zip(places, places[1:], robot.shape.radius):
            drawn += draw_bar(a, b, r, ax, palette.ROBOT, alpha=0.12, zorder=2.5)
    return drawn


def draw_driven(car: Any, trajectory: TrajectoryRecord, ax: Axes) -> list[Artist]:
    """Draw a car's bodies along a trajectory, at equal time steps."""
    poses = trajectory.at(np.linspace(0.0, trajectory.duration, GHOSTS + 2)[1:-1])
    return [ax.add_patch(make_ghost(car, q)) for q in poses]


def spread_configurations(space: Space, path: Array, n: int = GHOSTS) -> list[Array]:
    """n equally spaced configurations along a path, without its ends."""
    passed = np.cumsum([0.0, *(distance(space, a, b) for a, b in zip(path, path[1:]))])
    if passed[-1] == 0.0:
        return []
    found = []
    for target in np.linspace(0.0, passed[-1], n + 2)[1:-1]:
        k = min(int(np.searchsorted(passed, target, side="right")), len(path) - 1)
        t = (target - passed[k - 1]) / (passed[k] - passed[k - 1])
        found.append(interpolate(space, path[k - 1], path[k], t))
    return found
