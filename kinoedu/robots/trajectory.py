"""Trajectories of a car: a sequence of controls with durations, and the exact poses along it."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..compiled import algorithm, compiled
from ..curves.arcs import drive_arc
from ..curves.curve import as_pose
from ..errors import InvalidParameter
from ..geometry.checks import Array, as_array, as_row
from ..support.constructors import Constructor, with_type_names
from .car import CarRobot


@with_type_names
class TrajectoryRecord(NamedTuple):
    """The record that `Trajectory` returns.

    start : (3,), the first pose.
    controls : (n, 2), each a speed v and a steering angle phi.
    durations : (n,), the time for which each control is held.
    wheelbase : of the car.
    """

    start: Array
    controls: Array
    durations: Array
    wheelbase: float

    @property
    def duration(self) -> float:
        """The total time."""
        return float(self.durations.sum())

    @property
    def length(self) -> float:
        """The distance that the rear axle's middle drives, forward and backward."""
        return float(np.abs(self.controls[:, 0] * self.durations).sum())

    @property
    def poses(self) -> Array:
        """The pose at the start and after each control, shape (n + 1, 3)."""
        return replay_controls(self.start, self.controls, self.durations, self.wheelbase)

    @property
    def reversed(self) -> TrajectoryRecord:
        """The same drive backwards: from the last pose to the first."""
        backwards = self.controls[::-1] * (-1.0, 1.0)
        return TrajectoryRecord(
            self.poses[-1], backwards, self.durations[::-1].copy(), self.wheelbase
        )

    def at(self, t: ArrayLike) -> Array:
        """The pose at time t, clipped to 0 <= t <= duration.

        Parameters
        ----------
        t : a number, or (m,) times.

        Returns
        -------
        (3,) array, or (m, 3) for many times.

        Raises
        ------
        InvalidPoint
            Where t is not a number or a row of numbers.
        """
        times = np.clip(as_row(t, "t"), 0.0, self.duration)
        begins = np.concatenate([[0.0], np.cumsum(self.durations)])
        # without begins[-1], so that the last control is held to the end in spite of rounding
        which = np.searchsorted(begins[1:-1], np.atleast_1d(times))
        since = np.atleast_1d(times) - begins[which]
        poses = poses_between(self.poses, self.controls, self.wheelbase, which, since)
        return poses if times.ndim else poses[0]


@with_type_names
class DrivenTree(NamedTuple):
    """A tree that was grown by driving, in the order it grew.

    nodes : (n, 3), poses (x, y, theta), the root first.
    parent : (n,), -1 for the root.
    controls : (n, 2), the control (v, phi) that leads from the parent to each node.
    durations : (n,), the time for which each control is held.
    """

    nodes: Array
    parent: NDArray[np.int64]
    controls: Array
    durations: Array


@with_type_names
class DrivenRoadmap(NamedTuple):
    """A directed roadmap that was grown by driving, in the order it grew.

    nodes : (n, 3), poses. edges : (m, 2), from the first node to the second only.
    controls : (m, 2), the control (v, phi) along each edge. durations : (m,), its time.
    goals : (k,), the numbers of the nodes that count as the goal.
    """

    nodes: Array
    edges: NDArray[np.int64]
    controls: Array
    durations: Array
    goals: NDArray[np.int64]


class Trajectory(TrajectoryRecord, metaclass=Constructor):
    """A drive of a car from a pose by controls that are held one after another.

    Parameters
    ----------
    controls : (n, 2), rows (v, phi); n may be 0.
    durations : (n,), zero or more each.

    Returns
    -------
    TrajectoryRecord

    Raises
    ------
    InvalidPoint
        Where an array is not finite numbers.
    InvalidParameter
        Where the shapes do not fit, phi exceeds the car's largest steering angle, or a duration is
        negative.

    Examples
    --------
    >>> from kinoedu import Car
    >>> controls = [(1, 0), (-1, np.pi / 4)]
    >>> there = Trajectory(Car(30, 10, 20), (0, 0, 0), controls, [50, 20 * np.pi / 2])
    >>> there.poses.round(9)[1:]
    array([[50.        ,  0.        ,  0.        ],
           [30.        , 20.        , -1.57079633]])
    >>> there.at(25), bool(80 < there.length < 82)
    (array([25.,  0.,  0.]), True)
    """

    def __new__(  # type: ignore[misc]  # returns the record
        cls,
        car: CarRobot,
        start: ArrayLike,
        controls: ArrayLike,
        durations: ArrayLike,
    ) -> TrajectoryRecord:
        if not isinstance(car, CarRobot):
            raise InvalidParameter(f"a trajectory is driven by a Car, got a {type(car).__name__}")
        rows, times = as_array(controls, "controls"), as_array(durations, "durations")
        if rows.size == 0:
            rows = rows.reshape(0, 2)
        if rows.ndim != 2 or rows.shape[1] != 2 or times.shape != (len(rows),):
            raise InvalidParameter(
                f"controls must have shape (n, 2) and durations (n,), got {rows.shape} and "
                f"{times.shape}"
            )
        if (times < 0.0).any():
            raise InvalidParameter(
                f"durations must be zero or more, got {times.min():g}; to drive backwards give a "
                "negative speed"
            )
        for phi in rows[:, 1]:
            car.curvature(phi)
        return TrajectoryRecord(as_pose(start, "start"), rows, times, car.wheelbase)


@compiled
def replay_controls(start: Array, controls: Array, durations: Array, wheelbase: float) -> Array:
    """The poses at the start and after each control, shape (n + 1, 3)."""
    poses = np.empty((len(controls) + 1, 3))
    poses[0] = start
    for k in range(len(controls)):
        distance, curvature = controls[k, 0] * durations[k], math.tan(controls[k, 1]) / wheelbase
        poses[k + 1, 0], poses[k + 1, 1], poses[k + 1, 2] = drive_arc(
            poses[k, 0], poses[k, 1], poses[k, 2], distance, curvature
        )
    return poses


@algorithm
def poses_between(
    begins: Array, controls: Array, wheelbase: float, which: NDArray[np.int64], times: Array
) -> Array:
    """The poses (m, 3) at times[i] after control which[i] began, at pose begins[which[i]]."""
    poses = np.empty((len(times), 3))
    for i in range(len(times)):
        x, y, theta = begins[which[i]]
        if len(controls) > 0:
            v, phi = controls[which[i]]
            x, y, theta = drive_arc(x, y, theta, v * times[i], math.tan(phi) / wheelbase)
        poses[i, 0], poses[i, 1], poses[i, 2] = x, y, theta
    return poses
