"""The problems that exercises on driving hand out: a car that is asked where controls lead; and how
such problems travel.
"""

import math
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from ..curves.arcs import driven
from ..files.scenes import problem_from
from ..geometry.checks import Array
from ..problems import ProblemRecord
from ..support.json_fields import Field
from .plain import WrongShape
from .tasks import Asked, Task, scene_of

TRIALS, STEPS, BATCHES = 20, 30, 4
REGION = 2.5  # wheelbases round the goal


class Drivable(Asked):
    """A car's problem as a student's planner meets it. What it answers beyond `start`, `goal` and
    `sample(rng)` stands here.

    distance(a, b) : of two poses, a radian counting `radian` units of length, a quarter of the
    wheelbase.
    longest : for how long a control is held at most. tolerance, turn_tolerance : how near the goal
    is near enough.
    """

    def __init__(self, problem: ProblemRecord) -> None:
        super().__init__(problem)
        car = problem.robot
        self.radian = self.tolerance = 0.25 * car.wheelbase
        self.turn_tolerance = math.radians(15.0)
        self.longest = 0.75 * car.wheelbase / float(np.abs(car.speeds).max())
        self.distance = partial(apart, radian=self.radian)

    def __repr__(self) -> str:
        return f"drivable({scene_of(self.problem)})"

    def move(self, q: Any, v: float, phi: float, t: float) -> Array:
        """The pose after the control (v, phi) has been held for a time t, from q."""
        return np.array(
            driven(
                float(q[0]),
                float(q[1]),
                float(q[2]),
                v * t,
                math.tan(phi) / self.problem.robot.wheelbase,
            )
        )

    def is_free_drive(self, q: Any, v: float, phi: float, t: float) -> bool:
        """Whether the car touches nothing all the way, driven from q by the control (v, phi) for a
        time t.
        """
        return self.problem.is_free_drive(np.asarray(q, float), float(v), float(phi), float(t))

    def near_goal(self, rng: np.random.Generator) -> Array:
        """A pose by chance from the region round the goal: at most 2.5 wheelbases away, at most 90
        degrees askew.
        """
        off, towards, askew = (
            REGION * self.problem.robot.wheelbase * rng.random(),
            *rng.uniform(-1.0, 1.0, 2),
        )
        x, y, theta = self.problem.goal
        towards *= math.pi
        return np.array(
            [
                x + off * math.cos(towards),
                y + off * math.sin(towards),
                theta + 0.5 * math.pi * askew,
            ]
        )

    def best_drive(
        self, q: Any, target: Any, rng: np.random.Generator
    ) -> tuple[float, float, float] | None:
        """The best of twenty random controls, (v, phi, t), cut where it comes closest to the
        target. Where it is not free twenty others are tried, four times in all; then None."""
        for _ in range(BATCHES):
            controls = np.array([self.problem.control(rng) for _ in range(TRIALS)])
            times = self.longest * np.arange(1, STEPS + 1) / STEPS
            off = apart(
                self.poses_after(np.asarray(q, float), controls, times),
                np.asarray(target, float),
                self.radian,
            )
            i, k = np.unravel_index(int(np.argmin(off)), off.shape)
            v, phi, t = float(controls[i, 0]), float(controls[i, 1]), float(times[k])
            if self.is_free_drive(q, v, phi, t):
                return v, phi, t
        return None

    def poses_after(self, q: Array, controls: Array, times: Array) -> Array:
        """Where each of some controls (m, 2) has led from q after each of some times (n,): x, y and
        theta, shape (3, m, n).
        """
        far = controls[:, :1] * times
        half = 0.5 * far * np.tan(controls[:, 1:]) / self.problem.robot.wheelbase
        chord = far * np.sinc(half / np.pi)
        return np.array(
            [
                q[0] + chord * np.cos(q[2] + half),
                q[1] + chord * np.sin(q[2] + half),
                q[2] + 2.0 * half,
            ]
        )


def apart(a: Any, b: Any, radian: float) -> Any:
    """How far two poses are apart, their headings the short way; the three numbers may be
    arrays.
    """
    turn = (b[2] - a[2] + math.pi) % (2.0 * math.pi) - math.pi
    return ((b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2 + (radian * turn) ** 2) ** 0.5


def drivable(scene: dict[str, Any]) -> Drivable:
    """The problem in a scene, as an exercise on driving hands it out.

    >>> square = {"kind": "polygons", "boundary": [[0, 0], [40, 0], [40, 40], [0, 40]]}
    >>> car = {"kind": "car", "length": 3, "width": 1, "wheelbase": 2}
    >>> problem = drivable({"robot": car, "world": square, "start": [10, 10, 0], "goal": [30, 30, 3]})
    >>> problem.move(problem.start, 1, 0, 5), problem.is_free_drive(problem.start, -1, 0, 15)
    (array([15., 10.,  0.]), False)
    >>> v, phi, t = problem.best_drive(problem.start, (11, 10, 0), np.random.default_rng(0))
    >>> bool(problem.distance(problem.move(problem.start, v, phi, t), (11, 10, 0)) < 0.2)
    True
    """
    return Drivable(problem_from(Field("scene", {"version": 1, **scene}, Path())))


class DrivenTask(Task):
    """The shape of a car's problem: it travels as a scene."""

    def decode(self, data: Any) -> Drivable:
        """A new problem, of which nothing has been asked."""
        try:
            return drivable(data)
        except Exception:
            raise WrongShape(self.words) from None
