"""A car that turns, with the one point round which all of it turns: Ackermann's geometry. LaValle, section 13.1.2.1."""

import math

from matplotlib import pyplot as plt
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.patches import Circle, Polygon
from numpy.typing import ArrayLike

from ..errors import InvalidParameter
from ..geometry.checks import Array, shortened
from ..robots.car import CarRobot
from . import palette
from .robots import outline_at, wheels_at


def draw_ackermann(car: CarRobot, pose: ArrayLike, phi: float, ax: Axes | None = None) -> list[Artist]:
    """Draw a car with its wheels turned, each wheel's axis as far as the centre of rotation, and the rear axle's circle round it.

    pose : (x, y, theta) of the rear axle's middle; phi : the steering angle. Returns the artists. Raises InvalidParameter where
    the car cannot steer so far, or drives straight on and so turns round nothing; InvalidPoint.

    >>> from kinoedu import Car
    >>> artists = draw_ackermann(Car(30, 10, 20), (0, 0, 0.3), 0.5)
    >>> plt.close()
    """
    centre = car.turning_centre(pose, phi)
    if math.isinf(centre[0]):
        raise InvalidParameter(f"with phi = {shortened(phi)} the car drives straight on; give a steering angle other than 0")
    if ax is None:
        _, ax = plt.subplots(figsize=(6.5, 6.0), dpi=72, layout="constrained")
    place = car.ahead(pose, 0.0)
    body = ax.add_patch(Polygon(outline_at(car, place), facecolor=f"{palette.ROBOT}33", edgecolor=palette.ROBOT, linewidth=1.8))
    drawn: list[Artist] = [body]
    for wheel in wheels_at(car, place):
        middle = wheel.mean(axis=0)
        across = math.atan2(middle[1] - centre[1], middle[0] - centre[0])
        drawn += ax.plot(*zip(middle, centre), color=palette.TREE, linewidth=1.3, linestyle="--", zorder=2)
        drawn.append(
            ax.add_patch(Polygon(turned(wheel, middle, across + 0.5 * math.pi - place[2]), facecolor=palette.INK, zorder=4))
        )
    radius = math.dist(centre, place[:2])
    drawn.append(ax.add_patch(Circle((centre[0], centre[1]), radius, fill=False, edgecolor=palette.PATH, linewidth=2.4, zorder=1)))
    drawn += ax.plot(*centre, "o", color=palette.GOAL, markersize=9, zorder=5)
    ax.set_aspect("equal")
    ax.autoscale_view()
    ax.tick_params(labelsize=palette.TEXT_SIZE - 1)
    return drawn


def turned(outline: Array, middle: Array, angle: float) -> Array:
    """An outline (n, 2) turned round a point."""
    cos, sin = math.cos(angle), math.sin(angle)
    x, y = (outline - middle).T
    rotated = outline.copy()
    rotated[:, 0], rotated[:, 1] = middle[0] + cos * x - sin * y, middle[1] + sin * x + cos * y
    return rotated
