"""A car's wheels when it turns, and the centre of rotation: Ackermann's geometry.

LaValle, section 13.1.2.1.
"""

from __future__ import annotations

import math

from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.patches import Circle, Polygon
from numpy.typing import ArrayLike

from ..errors import InvalidParameter
from ..geometry.checks import Array
from ..robots.car import CarRobot
from ..support.text import shortened
from . import palette
from .robots import outline_at, wheels_at


def draw_ackermann(
    car: CarRobot, pose: ArrayLike, phi: float, ax: Axes | None = None
) -> list[Artist]:
    """Draw a car with turned wheels, the centre of rotation, and each wheel's axis to it.

    A circle is the path of the rear axle's midpoint.

    Parameters
    ----------
    pose : (x, y, theta) of the rear axle's midpoint.
    phi : the steering angle.

    Returns
    -------
    list of artists

    Raises
    ------
    InvalidParameter
        Where the car cannot steer so far, or drives straight on and has no centre of rotation.
    InvalidPoint

    Examples
    --------
    >>> from kinoedu import Car
    >>> from matplotlib import pyplot as plt
    >>> artists = draw_ackermann(Car(30, 10, 20), (0, 0, 0.3), 0.5)
    >>> plt.close()
    """
    centre = car.turning_centre(pose, phi)
    if math.isinf(centre[0]):
        raise InvalidParameter(
            f"with phi = {shortened(phi)} the car drives straight on; give a steering angle other "
            "than 0"
        )
    ax = palette.axes_or_new(ax, (6.5, 6.0))
    place = car.ahead(pose, 0.0)
    tint: palette.Style = {"facecolor": f"{palette.ROBOT}33", "edgecolor": palette.ROBOT}
    axis: palette.Style = {"color": palette.TREE, "linewidth": 1.3, "linestyle": "--"}
    line: palette.Style = {"fill": False, "edgecolor": palette.PATH, "linewidth": 2.4}
    drawn: list[Artist] = [ax.add_patch(Polygon(outline_at(car, place), linewidth=1.8, **tint))]
    for wheel in steered_wheels(car, place, phi):
        drawn += ax.plot(*zip(wheel.mean(axis=0), centre), zorder=2, **axis)
        drawn.append(ax.add_patch(Polygon(wheel, facecolor=palette.INK, zorder=4)))
    circle = Circle((centre[0], centre[1]), math.dist(centre, place[:2]), zorder=1, **line)
    drawn.append(ax.add_patch(circle))
    drawn += ax.plot(*centre, "o", color=palette.CUT, markersize=9, zorder=5)
    ax.set_aspect("equal")
    ax.autoscale_view()
    ax.tick_params(labelsize=palette.TEXT_SIZE - 1)
    return drawn


def steered_wheels(car: CarRobot, pose: ArrayLike, phi: float) -> list[Array]:
    """The outlines of a car's four wheels, (4, 2) each, the rear two first.

    Each wheel stands across its line to the centre of rotation.

    Raises
    ------
    InvalidPoint, InvalidParameter

    Examples
    --------
    >>> from kinoedu import Car
    >>> rear, _, front, _ = steered_wheels(Car(30, 10, 20), (0, 0, 0), 0.5)
    >>> along, across = front[1] - front[0]
    >>> bool(rear[0, 1] == rear[1, 1]), 0.4 < math.atan2(across, along) < 0.5
    (True, True)
    """
    place, centre = car.ahead(pose, 0.0), car.turning_centre(pose, phi)
    wheels = wheels_at(car, place)
    if math.isinf(centre[0]):
        return wheels
    middles = [wheel.mean(axis=0) for wheel in wheels]
    across = [
        math.atan2(y - centre[1], x - centre[0]) + math.copysign(0.5 * math.pi, phi)
        for x, y in middles
    ]
    return [
        turn_outline(wheel, middle, angle - place[2])
        for wheel, middle, angle in zip(wheels, middles, across)
    ]


def turn_outline(outline: Array, middle: Array, angle: float) -> Array:
    """An outline (n, 2) turned about a point."""
    cos, sin = math.cos(angle), math.sin(angle)
    x, y = (outline - middle).T
    rotated = outline.copy()
    rotated[:, 0], rotated[:, 1] = middle[0] + cos * x - sin * y, middle[1] + sin * x + cos * y
    return rotated
