"""A car with front-wheel steering; its configuration is the pose (x, y, theta) of its rear axle.

The pose is that of the middle of the rear axle. x' = v cos theta, y' = v sin theta, theta' = (v /
L) tan phi, with the speed v, the wheelbase L and the steering angle phi. LaValle, Planning
Algorithms, section 13.1.2.1.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ..curves.arcs import drive_arc
from ..curves.curve import as_pose
from ..errors import InvalidParameter, InvalidRobot
from ..geometry.checks import Array, as_array, as_number
from ..geometry.parts import Parts
from ..support.constructors import Constructor, with_type_names
from ..support.text import distinct_numbers, shortened
from .polygon import shape_of

ROUNDING = 1e-12  # of a length: where the front axle is at the front end, sums are rounded


@with_type_names
class CarRobot(NamedTuple):
    """The record that `Car` returns.

    outline : (4, 2), the body in the frame of the rear axle's middle, with heading along x; shape
        is the same body as Parts.
    radius : the smallest turning radius of the rear axle's middle, L / tan(max_steering).
    speeds : (k,), the speeds that planners choose from.
    both_ways : whether one of the speeds is negative.
    """

    outline: Array
    shape: Parts
    wheelbase: float
    max_steering: float
    radius: float
    speeds: Array
    both_ways: bool

    def move(
        self, pose: ArrayLike, v: float, phi: float, t: float, *, reference: float = 0.0
    ) -> Array:
        """The pose after driving for time t at constant speed v and steering angle phi; exact.

        The middle of the rear axle moves on an arc of curvature tan(phi) / L, or on a straight
        line.

        Parameters
        ----------
        reference : the distance from the rear axle forward to the point whose pose and speed are
            given, such as the centre of gravity. This point moves at the angle beta to the car's
            axis, with tan(beta) = reference tan(phi) / L, and the rear axle is slower by the factor
            cos(beta).

        Returns
        -------
        (3,) array.

        Raises
        ------
        InvalidPoint
            Where the pose is not three finite numbers, or another value not one.
        InvalidParameter
            Where phi exceeds the largest steering angle, or t is negative.

        Examples
        --------
        >>> Car(30, 10, 20).move((0, 0, 0), 1, np.pi / 4, 20 * np.pi / 2).round(9)
        array([20.        , 20.        ,  1.57079633])
        """
        curvature = self.curvature(phi)
        speed, time, lead = (
            as_number(value, name) for value, name in ((v, "v"), (t, "t"), (reference, "reference"))
        )
        if time < 0.0:
            raise InvalidParameter(
                f"t must be zero or more, got {time:g}; to drive backwards give a negative v"
            )
        axle = self.ahead(pose, -lead)
        distance = speed * time * math.cos(math.atan(lead * curvature))
        return self.ahead(drive_arc(axle[0], axle[1], axle[2], distance, curvature), lead)

    def ahead(self, pose: ArrayLike, distance: float) -> Array:
        """The pose of the point of the car's axis that is `distance` ahead of `pose`, (3,).

        It converts the pose of another point of the axis to the pose of the rear axle's middle, and
        back.

        Raises
        ------
        InvalidPoint
            Where the pose is not three finite numbers, or the distance not one.

        Examples
        --------
        >>> Car(30, 10, 20).ahead((1, 2, 0), 10)
        array([11.,  2.,  0.])
        """
        (x, y, theta), far = as_pose(pose, "pose"), as_number(distance, "distance")
        return np.array([x + far * math.cos(theta), y + far * math.sin(theta), theta])

    def curvature(self, phi: float) -> float:
        """The curvature tan(phi) / L of the path of the rear axle's middle.

        Raises
        ------
        InvalidPoint
            Where phi is not one finite number.
        InvalidParameter
            Where phi exceeds the largest steering angle.
        """
        steering = as_number(phi, "phi")
        if abs(steering) > self.max_steering:
            most, given = distinct_numbers(self.max_steering, abs(steering))
            raise InvalidParameter(
                f"this car steers at most {most} rad either way, got |phi| = {given}"
            )
        return math.tan(steering) / self.wheelbase

    def turning_centre(self, pose: ArrayLike, phi: float) -> Array:
        """The point about which the whole car turns; it lies on the line of the rear axle.

        Returns
        -------
        (2,) array, infinite where the car drives straight.

        Raises
        ------
        InvalidPoint
            Where the pose is not three finite numbers, or phi not one.
        InvalidParameter
            Where phi exceeds the largest steering angle.

        Examples
        --------
        >>> Car(30, 10, 20).turning_centre((0, 0, 0), np.pi / 4).round(9)
        array([ 0., 20.])
        """
        (x, y, theta), curvature = as_pose(pose, "pose"), self.curvature(phi)
        if curvature == 0.0:
            return np.array([np.inf, np.inf])
        return np.array([x - math.sin(theta) / curvature, y + math.cos(theta) / curvature])

    def wheel_angles(self, phi: float) -> tuple[float, float]:
        """The angles of the left and right front wheels, so that all wheels roll about one centre.

        phi is the angle of a single wheel midway between them; the inner wheel turns more
        (Ackermann). The wheels are as far apart as the body is wide.

        Raises
        ------
        InvalidPoint, InvalidParameter
            As for `curvature`.

        Examples
        --------
        >>> left, right = Car(30, 10, 20).wheel_angles(0.5)
        >>> left > 0.5 > right
        True
        """
        curvature, half = self.curvature(phi), 0.5 * float(np.ptp(self.outline[:, 1]))
        left, right = (
            math.atan2(self.wheelbase * curvature, 1.0 - side * curvature) for side in (half, -half)
        )
        return left, right


class Car(CarRobot, metaclass=Constructor):
    """A car with a rectangular body.

    Parameters
    ----------
    length, width, wheelbase : in the world's unit; the wheelbase L is the distance between the
        axles.
    rear_overhang : the distance from the rear axle to the rear end; by default equal to the
        distance from the front axle to the front end.
    max_steering : the largest steering angle to either side, in radians, below pi / 2.
    speeds : the speeds that planners choose from, in lengths per second; all positive for a car
        that only drives forward.

    Returns
    -------
    CarRobot

    Raises
    ------
    InvalidRobot
        Where a size is not positive, an axle is not under the body, or the steering or a speed is
        not valid.
    InvalidPoint
        Where a value is not one finite number.

    Examples
    --------
    >>> car = Car(30, 10, 20)
    >>> car.radius, car.outline[0]
    (20.000000000000004, array([-5., -5.]))
    """

    def __new__(  # type: ignore[misc]  # returns the record
        cls,
        length: float,
        width: float,
        wheelbase: float,
        *,
        rear_overhang: float | None = None,
        max_steering: float = math.pi / 4,
        speeds: ArrayLike = (-1.0, 1.0),
    ) -> CarRobot:
        size, across, base = (
            as_size(value, name)
            for value, name in ((length, "length"), (width, "width"), (wheelbase, "wheelbase"))
        )
        behind = (
            0.5 * (size - base)
            if rear_overhang is None
            else as_number(rear_overhang, "rear_overhang")
        )
        if not 0.0 <= behind <= (size - base) * (1.0 + ROUNDING):
            raise InvalidRobot(
                f"both axles must be under the body: {behind:g} behind, a wheelbase of {base:g}, "
                f"{size:g} in all"
            )
        most = as_number(max_steering, "max_steering")
        if not 0.0 < most < 0.5 * math.pi:
            raise InvalidRobot(f"max_steering must be between 0 and pi / 2 radians, got {most:g}")
        chosen = np.atleast_1d(as_array(speeds, "speeds"))
        if chosen.ndim != 1 or not len(chosen) or (chosen == 0.0).any():
            raise InvalidRobot(
                f"speeds must be one or more numbers, none of them zero, got {shortened(speeds)}"
            )
        front, half = size - behind, 0.5 * across
        outline = np.array([(-behind, -half), (front, -half), (front, half), (-behind, half)])
        return CarRobot(
            outline,
            shape_of(outline),
            base,
            most,
            base / math.tan(most),
            chosen,
            bool((chosen < 0.0).any()),
        )


def as_size(value: float, name: str) -> float:
    """Check one positive length; raise InvalidRobot otherwise."""
    size = as_number(value, f"the car's {name}")
    if size <= 0.0:
        raise InvalidRobot(f"the car's {name} must be positive, got {size:g}")
    return size
