"""Problems for the exercises on driving, which add a car's motion to a student's problem."""

import math
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..curves.arcs import drive_arc
from ..geometry.checks import Array
from ..problems import ProblemRecord
from ..problems.recorder import Question
from .poses import distance_of_poses
from .tasks import ProblemShape, StudentProblem, read_problem, scene_of

TRIALS, STEPS, BATCHES = 20, 30, 4
REGION = 2.5  # radius of the region around the goal, in wheelbases


class DrivingProblem(StudentProblem):
    """A car's problem as a student's planner sees it.

    It adds the following to `start`, `goal` and `sample(rng)`. It logs every random pose and every
    best drive.

    Attributes
    ----------
    distance : Callable
        Distance between two poses; a radian of heading counts as `radian` units of length.
    radian : float
        A quarter of the wheelbase.
    longest : float
        The longest time for which a control is held.
    tolerance, turn_tolerance : float
        A pose this near to the goal, in length and in radians, counts as the goal.
    """

    QUESTIONS = (
        *StudentProblem.QUESTIONS,
        *("control", "move", "is_free_drive", "near_goal", "best_drive"),
    )
    NUMBERS = ("radian", "longest", "tolerance", "turn_tolerance")

    def __init__(self, problem: ProblemRecord) -> None:
        super().__init__(problem)
        car = problem.robot
        self.radian = self.tolerance = 0.25 * car.wheelbase
        self.turn_tolerance = math.radians(15.0)
        self.longest = 0.75 * car.wheelbase / float(np.abs(car.speeds).max())
        self.metric = self.radian
        self.distance = partial(distance_of_poses, radian=self.radian)

    def __repr__(self) -> str:
        return f"drivable({scene_of(self.problem)})"

    def move(self, q: Any, v: float, phi: float, t: float) -> Array:
        """Pose after the control (v, phi) was held for a time t, starting at q."""
        curvature = math.tan(phi) / self.problem.robot.wheelbase
        return np.array(drive_arc(float(q[0]), float(q[1]), float(q[2]), v * t, curvature))

    def is_free_drive(self, q: ArrayLike, v: float, phi: float, t: float) -> bool:
        """Whether the car stays collision-free while the control (v, phi) is held for a time t."""
        return self.problem.is_free_drive(np.asarray(q, float), float(v), float(phi), float(t))

    def near_goal(self, rng: np.random.Generator) -> Array:
        """Random pose at most 2.5 wheelbases from the goal and at most 90 degrees off its angle."""
        radius = REGION * self.problem.robot.wheelbase * rng.random()
        direction, turn = rng.uniform(-1.0, 1.0, 2)
        direction *= math.pi
        x, y, theta = self.problem.goal
        pose = (
            x + radius * math.cos(direction),
            y + radius * math.sin(direction),
            theta + 0.5 * math.pi * turn,
        )
        self.log.append(Question("near_goal", (rng,), pose))
        return np.array(pose)

    def best_drive(
        self, q: ArrayLike, target: ArrayLike, rng: np.random.Generator
    ) -> tuple[float, float, float] | None:
        """Best of twenty random controls, cut off where it comes closest to the target.

        Where the best control is not collision-free, twenty others are drawn; at most four such
        batches are tried.

        Returns
        -------
        (v, phi, t), or None where no free control was found.
        """
        asked = np.array(q, float), np.array(target, float), rng
        drive = self.search_drive(*asked)
        self.log.append(Question("best_drive", asked, drive))
        return drive

    def search_drive(
        self, q: Array, target: Array, rng: np.random.Generator
    ) -> tuple[float, float, float] | None:
        """Best drive, without an entry in the log."""
        for _ in range(BATCHES):
            controls = np.array([self.problem.control(rng) for _ in range(TRIALS)])
            times = self.longest * np.arange(1, STEPS + 1) / STEPS
            poses = self.poses_after(q, controls, times)
            distances = distance_of_poses(poses, target, self.radian)
            i, k = np.unravel_index(int(np.argmin(distances)), distances.shape)
            v, phi, t = float(controls[i, 0]), float(controls[i, 1]), float(times[k])
            if self.is_free_drive(q, v, phi, t):
                return v, phi, t
        return None

    def poses_after(self, q: Array, controls: Array, times: Array) -> Array:
        """Poses that controls reach from q after the given times.

        Parameters
        ----------
        controls : (m, 2) array of v and phi.
        times : (n,) array.

        Returns
        -------
        (3, m, n) array of x, y and theta.
        """
        length = controls[:, :1] * times
        half = 0.5 * length * np.tan(controls[:, 1:]) / self.problem.robot.wheelbase
        chord = length * np.sinc(half / np.pi)
        return np.array(
            [
                q[0] + chord * np.cos(q[2] + half),
                q[1] + chord * np.sin(q[2] + half),
                q[2] + 2.0 * half,
            ]
        )


def drivable(scene: dict[str, Any]) -> DrivingProblem:
    """Problem of a scene, as an exercise on driving gives it to a student.

    >>> square = {"kind": "polygons", "boundary": [[0, 0], [40, 0], [40, 40], [0, 40]]}
    >>> car = {"kind": "car", "length": 3, "width": 1, "wheelbase": 2}
    >>> ends = {"start": [10, 10, 0], "goal": [30, 30, 3]}
    >>> problem = drivable({"robot": car, "world": square, **ends})
    >>> problem.move(problem.start, 1, 0, 5), problem.is_free_drive(problem.start, -1, 0, 15)
    (array([15., 10.,  0.]), False)
    >>> v, phi, t = problem.best_drive(problem.start, (11, 10, 0), np.random.default_rng(0))
    >>> bool(problem.distance(problem.move(problem.start, v, phi, t), (11, 10, 0)) < 0.2)
    True
    """
    return DrivingProblem(read_problem(scene))


class DrivenProblemShape(ProblemShape):
    """The shape of a car's problem, encoded as a scene."""

    def wrap(self, problem: ProblemRecord) -> DrivingProblem:
        """The problem as a student's program sees it."""
        return DrivingProblem(problem)
