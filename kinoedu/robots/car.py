"""A car that steers with its front wheels. Its configuration is the pose (x, y, theta) of the middle of its rear axle.

x' = v cos theta, y' = v sin theta, theta' = (v / L) tan phi, with the speed v, the wheelbase L and the steering angle phi.
LaValle, Planning Algorithms, section 13.1.2.1.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ..curves.arcs import driven
from ..curves.curve import as_pose
from ..errors import InvalidParameter, InvalidRobot
from ..geometry.checks import Array, as_array, shortened
from ..geometry.parts import Parts
from .polygon import shape_of


class CarRobot(NamedTuple):
    """What `Car` makes: outline (4, 2) and its shape, round the rear axle's middle, heading along x.

    radius : of the tightest circle that the rear axle's middle can drive, L / tan(max_steering).
    speeds : (k,), those that planners choose from; both_ways : whether one of them is negative.
    """

    outline: Array
    shape: Parts
    wheelbase: float
    max_steering: float
    radius: float
    speeds: Array
    both_ways: bool

    def move(self, pose: ArrayLike, v: float, phi: float, t: float) -> Array:
        """The pose after driving for a time t with the speed v and the steering angle phi, both held; shape (3,). Exact.

        The rear axle's middle drives an arc of curvature tan(phi) / L, or a straight line. Raises InvalidPoint; InvalidParameter
        where phi is more than the car can steer, or t is negative.

        >>> Car(30, 10, 20).move((0, 0, 0), 1, np.pi / 4, 20 * np.pi / 2).round(9)
        array([20.        , 20.        ,  1.57079633])
        """
        start = as_pose(pose, "pose")
        speed, steering, time = (as_number(value, name) for value, name in ((v, "v"), (phi, "phi"), (t, "t")))
        if abs(steering) > self.max_steering:
            raise InvalidParameter(f"this car steers at most {self.max_steering:g} rad either way, got phi = {steering:g}")
        if time < 0.0:
            raise InvalidParameter(f"t must be zero or more, got {time:g}; to drive backwards give a negative v")
        return np.array(driven(start[0], start[1], start[2], speed * time, math.tan(steering) / self.wheelbase))


def Car(
    length: float,
    width: float,
    wheelbase: float,
    *,
    rear_overhang: float | None = None,
    max_steering: float = math.pi / 4,
    speeds: ArrayLike = (-1.0, 1.0),
) -> CarRobot:
    """A car with a rectangular body.

    Parameters
    ----------
    length, width, wheelbase : in the world's unit; the wheelbase L is the distance between the axles.
    rear_overhang : how far the body reaches behind the rear axle; by default as far as before the front axle.
    max_steering : the largest steering angle either way, in radians, below pi / 2.
    speeds : those that planners choose from, in units of length a second; all positive for a car that only goes forward.

    Raises InvalidRobot, InvalidPoint.

    >>> car = Car(30, 10, 20)
    >>> car.radius, car.outline[0]
    (20.000000000000004, array([-5., -5.]))
    """
    size, across, base = (as_size(value, name) for value, name in ((length, "length"), (width, "width"), (wheelbase, "wheelbase")))
    behind = 0.5 * (size - base) if rear_overhang is None else as_number(rear_overhang, "rear_overhang")
    if not 0.0 <= behind <= size - base:
        raise InvalidRobot(f"both axles must be under the body: {behind:g} behind, a wheelbase of {base:g}, {size:g} in all")
    most = as_number(max_steering, "max_steering")
    if not 0.0 < most < 0.5 * math.pi:
        raise InvalidRobot(f"max_steering must be between 0 and pi / 2 radians, got {most:g}")
    chosen = np.atleast_1d(as_array(speeds, "speeds"))
    if chosen.ndim != 1 or not len(chosen) or (chosen == 0.0).any():
        raise InvalidRobot(f"speeds must be one or more numbers, none of them zero, got {shortened(speeds)}")
    front, half = size - behind, 0.5 * across
    outline = np.array([(-behind, -half), (front, -half), (front, half), (-behind, half)])
    return CarRobot(outline, shape_of(outline), base, most, base / math.tan(most), chosen, bool((chosen < 0.0).any()))


def as_number(value: float, name: str) -> float:
    """One number, or InvalidParameter."""
    number = as_array(value, name)
    if number.ndim:
        raise InvalidParameter(f"{name} must be one number, got {shortened(value)}")
    return float(number)


def as_size(value: float, name: str) -> float:
    """One positive length, or InvalidRobot."""
    size = as_number(value, f"the car's {name}")
    if size <= 0.0:
        raise InvalidRobot(f"the car's {name} must be positive, got {size:g}")
    return size
