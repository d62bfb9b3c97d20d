"""Trajectories: what a car is told to do, and for how long. Where it then is follows, exactly."""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..compiled import compiled
from ..curves.arcs import driven
from ..curves.curve import as_pose
from ..errors import InvalidParameter
from ..geometry.checks import Array, as_array
from .car import CarRobot


class TrajectoryRecord(NamedTuple):
    """What `Trajectory` makes: from `start` (3,) by `controls` (n, 2), each a speed v and a
    steering angle phi, held for durations[i]."""

    start: Array
    controls: Array
    durations: Array
    wheelbase: float

    @property
    def duration(self) -> float:
        """How long it takes."""
        return float(self.durations.sum())

    @property
    def length(self) -> float:
        """How far the rear axle's middle is driven, forward and back."""
        return float(np.abs(self.controls[:, 0] * self.durations).sum())

    @property
    def poses(self) -> Array:
        """The pose at the start and after each control, shape (n + 1, 3): the controls replayed."""
        return replayed(self.start, self.controls, self.durations, self.wheelbase)

    @property
    def reversed(self) -> "TrajectoryRecord":
        """The same drive from its end to its start: every control the other way, the last one
        first.
        """
        backwards = self.controls[::-1] * (-1.0, 1.0)
        return TrajectoryRecord(
            self.poses[-1], backwards, self.durations[::-1].copy(), self.wheelbase
        )

    def at(self, t: ArrayLike) -> Array:
        """The pose after a time t, shape (3,); for many, shape (m,), the poses (m, 3). t is kept
        between 0 and the whole duration.

        Raises InvalidPoint where it is not numbers.
        """
        times = np.clip(as_array(t, "t"), 0.0, self.duration)
        begins = np.concatenate([[0.0], np.cumsum(self.durations)])
        which = np.searchsorted(
            begins[1:-1], np.atleast_1d(times)
        )  # the last control is held to the end, however sums are rounded
        poses = on_the_way(
            self.poses, self.controls, self.wheelbase, which, np.atleast_1d(times) - begins[which]
        )
        return poses if times.ndim else poses[0]


class DrivenTree(NamedTuple):
    """A tree grown by driving, in its order: to nodes[i] (x, y, theta) leads the control
    controls[i] (v, phi) from its parent, held for durations[i]. Shapes (n, 3), (n,), (n, 2), (n,).
    """

    nodes: Array
    parent: NDArray[np.int64]
    controls: Array
    durations: Array


class DrivenRoadmap(NamedTuple):
    """A roadmap grown by driving, in its order: along edges[e], from one node to another and never
    back, controls[e] (v, phi) is held for durations[e]. Shapes (n, 3), (m, 2), (m, 2), (m,);
    `goals` are the nodes that count as the goal, (k,)."""

    nodes: Array
    edges: NDArray[np.int64]
    controls: Array
    durations: Array
    goals: NDArray[np.int64]


def Trajectory(
    car: CarRobot, start: ArrayLike, controls: ArrayLike, durations: ArrayLike
) -> TrajectoryRecord:
    """A drive from a pose by controls (v, phi), shape (n, 2), each held for its duration, shape
    (n,); n may be zero.

    Raises InvalidPoint; InvalidParameter where the shapes do not fit, the car cannot steer so far,
    or a duration is negative.

    >>> from kinoedu import Car
    >>> there = Trajectory(Car(30, 10, 20), (0, 0, 0), [(1, 0), (-1, np.pi / 4)], [50, 20 * np.pi / 2])
    >>> there.poses.round(9)[1:]
    array([[50.        ,  0.        ,  0.        ],
           [30.        , 20.        , -1.57079633]])
    >>> there.at(25), bool(80 < there.length < 82)
    (array([25.,  0.,  0.]), True)
    """
    if not isinstance(car, CarRobot):
        raise InvalidParameter(f"a trajectory is driven by a Car, got a {type(car).__name__}")
    told, times = as_array(controls, "controls"), as_array(durations, "durations")
    if told.size == 0:
        told = told.reshape(0, 2)
    if told.ndim != 2 or told.shape[1] != 2 or times.shape != (len(told),):
        raise InvalidParameter(
            f"controls must have shape (n, 2) and durations (n,), got {told.shape} and "
            f"{times.shape}"
        )
    if (times < 0.0).any():
        raise InvalidParameter(
            f"durations must be zero or more, got {times.min():g}; to drive backwards give a "
            "negative speed"
        )
    for phi in told[:, 1]:
        car.curvature(phi)
    return TrajectoryRecord(as_pose(start, "start"), told, times, car.wheelbase)


@compiled
def replayed(start: Array, controls: Array, durations: Array, wheelbase: float) -> Array:
    """The poses at the start and after each control, shape (n + 1, 3)."""
    poses = np.empty((len(controls) + 1, 3))
    poses[0] = start
    for k in range(len(controls)):
        distance, curvature = controls[k, 0] * durations[k], math.tan(controls[k, 1]) / wheelbase
        poses[k + 1, 0], poses[k + 1, 1], poses[k + 1, 2] = driven(
            poses[k, 0], poses[k, 1], poses[k, 2], distance, curvature
        )
    return poses


@compiled
def on_the_way(
    begins: Array, controls: Array, wheelbase: float, which: NDArray[np.int64], times: Array
) -> Array:
    """The poses (m, 3) at each time since the control of that number began; `begins` is where they
    begin.
    """
    poses = np.empty((len(times), 3))
    for i in range(len(times)):
        x, y, theta = begins[which[i]]
        if len(controls) > 0:
            v, phi = controls[which[i]]
            x, y, theta = driven(x, y, theta, v * times[i], math.tan(phi) / wheelbase)
        poses[i, 0], poses[i, 1], poses[i, 2] = x, y, theta
    return poses
