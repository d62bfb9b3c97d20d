"""From a path of curves to what the car is told to do."""

import numpy as np

from ..curves.space import pieces_between
from ..errors import InvalidParameter
from ..geometry.checks import shortened
from ..problems import Plan, ProblemRecord, Recorder
from ..robots.car import CarRobot
from ..robots.trajectory import Trajectory, TrajectoryRecord


def trajectory_along(plan: Plan) -> TrajectoryRecord:
    """The controls that drive a car along a plan's path of Dubins' or Reeds and Shepp's curves: full steering, or none.

    Forward at the fastest of the car's speeds, backwards at the fastest of those. A plan that has a trajectory keeps it.
    Raises InvalidParameter for a plan without a path, or of another robot.

    >>> from kinoedu import Car, PolygonWorld, Problem, rrt
    >>> world = PolygonWorld([(0, 0), (20, 0), (20, 20), (0, 20)], [[(9, 0), (11, 0), (11, 10), (9, 10)]])
    >>> plan = rrt(Problem(Car(3, 1, 2), world, (4, 4, 0), (16, 4, 0)), rng=0)
    >>> drive = trajectory_along(plan)
    >>> np.allclose(drive.poses[-1], plan.path[-1]), abs(drive.length - plan.cost) < 1e-9
    (True, True)
    """
    if not isinstance(plan, Plan) or plan.path is None:
        raise InvalidParameter(f"expected a plan with a path, got {shortened(plan)}")
    if plan.trajectory is not None:
        return plan.trajectory
    inner = plan.problem.problem if isinstance(plan.problem, Recorder) else plan.problem
    if not isinstance(inner, ProblemRecord) or not isinstance(inner.robot, CarRobot):
        raise InvalidParameter("only a car is driven along a path; plan for a Problem(Car(...), world, start, goal)")
    car = inner.robot
    controls, durations = [], []
    for a, b in zip(plan.path, plan.path[1:]):
        turns, lengths = pieces_between(a, b, car.radius, car.both_ways)
        for turn, length in zip(turns.tolist(), lengths.tolist()):
            if length != 0.0:
                speed = float(car.speeds.max() if length > 0.0 else car.speeds.min())
                controls.append((speed, turn * car.max_steering))
                durations.append(length / speed)
    return Trajectory(car, plan.path[0], np.array(controls).reshape(-1, 2), durations)
