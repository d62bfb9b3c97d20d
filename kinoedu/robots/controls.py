"""Controls of a robot that is driven: drawing one at random, and the configuration it leads to.

A control is a speed v and a steering angle phi, held for some time. Each kind of robot that is
driven registers its functions in this file.
"""

import math

import numpy as np

from ..compiled import generic
from ..curves.arcs import drive_arc
from ..geometry.checks import Array
from .car import CarRobot
from .kinds import Robot


@generic(1)
def control(robot: Robot, rng: np.random.Generator) -> tuple[float, float]:
    """A random control (v, phi)."""
    raise TypeError("this robot is not driven")


@generic(1)
def curvature(robot: Robot, phi: float) -> float:
    """The curvature of the arc that is driven at a steering angle."""
    raise TypeError("this robot is not driven")


@generic(1)
def drive(robot: Robot, q: Array, v: float, phi: float, t: float, there: Array) -> None:
    """Write into `there` the configuration after driving from q for time t."""
    raise TypeError("this robot is not driven")


@control.register(CarRobot)
def car_control(robot: CarRobot, rng: np.random.Generator) -> tuple[float, float]:
    """One of the car's speeds and a steering angle within its limits, drawn uniformly."""
    v = robot.speeds[int(len(robot.speeds) * rng.random())]
    return v, robot.max_steering * (2.0 * rng.random() - 1.0)


@curvature.register(CarRobot)
def car_curvature(robot: CarRobot, phi: float) -> float:
    """The curvature tan(phi) / L."""
    return math.tan(phi) / robot.wheelbase


@drive.register(CarRobot)
def car_drive(robot: CarRobot, q: Array, v: float, phi: float, t: float, there: Array) -> None:
    """Drive along an arc or a straight line."""
    there[0], there[1], there[2] = drive_arc(
        q[0], q[1], q[2], v * t, math.tan(phi) / robot.wheelbase
    )
