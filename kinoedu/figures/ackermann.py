"""A car that turns, with the one point round which all of it turns: Ackermann's geometry. LaValle,
section 13.1.2.1.
"""

import math

from matplotlib import pyplot as plt
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
    """Draw a car with its wheels turned, each wheel's axis as far as the centre of rotation, and
    the rear axle's circle round it.

    pose : (x, y, theta) of the rear axle's middle; phi : the steering angle. Returns the artists.
        Raises InvalidParameter where the car cannot steer so far, or drives straight on and so
        turns round nothing; InvalidPoint.

    >>> from kinoedu import Car
    >>> artists = draw_ackermann(Car(30, 10, 20), (0, 0, 0.3), 0.5)
    >>> plt.close()
    """
    centre = car.turning_centre(pose, phi)
    if math.isinf(centre[0]):
        raise InvalidParameter(
            f"with phi = {shortened(phi)} the car drives straight on; give a steering angle other "
            "than 0"
        )
    if ax is None:
        _, ax = plt.subplots(figsize=(6.5, 6.0), dpi=72, layout="constrained")
    place = car.ahead(pose, 0.0)
    body = ax.add_patch(
        Polygon(
            outline_at(car, place),
            facecolor=f"{palette.ROBOT}33",
            edgecolor=palette.ROBOT,
            linewidth=1.8,
        )
    )
    drawn: list[Artist] = [body]
    for wheel in steered_wheels(car, place, phi):
        drawn += ax.plot(
            *zip(wheel.mean(axis=0), centre),
            color=palette.TREE,
            linewidth=1.3,
            linestyle="--",
            zorder=2,
        )
        drawn.append(ax.add_patch(Polygon(wheel, facecolor=palette.INK, zorder=4)))
    radius = math.dist(centre, place[:2])
    drawn.append(
        ax.add_patch(
            Circle(
                (centre[0], centre[1]),
                radius,
                fill=False,
                edgecolor=palette.PATH,
                linewidth=2.4,
                zorder=1,
            )
        )
    )
    drawn += ax.plot(*centre, "o", color=palette.GOAL, markersize=9, zorder=5)
    ax.set_aspect("equal")
    ax.autoscale_view()
    ax.tick_params(labelsize=palette.TEXT_SIZE - 1)
    return drawn


def steered_wheels(car: CarRobot, pose: ArrayLike, phi: float) -> list[Array]:
    """The outlines of a car's four wheels, shape (4, 2) each, the rear two first, each across the
    line to the centre of rotation.

    Raises InvalidPoint, InvalidParameter.

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
        turned(wheel, middle, angle - place[2])
        for wheel, middle, angle in zip(wheels, middles, across)
    ]


def turned(outline: Array, middle: Array, angle: float) -> Array:
    """An outline (n, 2) turned round a point."""
    cos, sin = math.cos(angle), math.sin(angle)
    x, y = (outline - middle).T
    rotated = outline.copy()
    rotated[:, 0], rotated[:, 1] = middle[0] + cos * x - sin * y, middle[1] + sin * x + cos * y
    return rotated
