"""Other libraries' trees for a car. OMPL asks Python to drive and to judge a pose: both are
compiled for one car in one world.
"""

from collections.abc import Callable
from typing import Any

import numpy as np

from kinoedu.collision import is_free
from kinoedu.curves.arcs import drive_arc
from kinoedu.problems import ProblemRecord


class Setup:
    """A car's problem as OMPL's objects. Controls are a sign of the speed and a steering angle,
    held for so many steps of a time; its bindings cannot try more than one in an iteration."""

    def __init__(self, problem: ProblemRecord, seconds: float, steps: int) -> None:
        from ompl import base, control, util

        util.setLogLevel(util.LogLevel.LOG_NONE)
        car, weight = problem.robot, problem.robot.wheelbase / 4.0
        space = base.SE2StateSpace()
        space.setBounds(bounds(base, problem.space.lo[:2], problem.space.hi[:2]))
        space.setSubspaceWeight(1, weight)
        controls = control.RealVectorControlSpace(space, 2)
        controls.setBounds(bounds(base, (-1.0, -car.max_steering), (1.0, car.max_steering)))
        self.information = control.SpaceInformation(space, controls)
        step, free = compiled_for(problem)

        def propagate(state: Any, given: Any, seconds: float, result: Any) -> None:
            x, y, theta = step(
                state.getX(), state.getY(), state.getYaw(), given[0], given[1], seconds
            )
            result.setXY(x, y)
            result.setYaw(theta)

        self.information.setStatePropagator(propagate)
        self.information.setStateValidityChecker(lambda q: free(q.getX(), q.getY(), q.getYaw()))
        self.information.setPropagationStepSize(seconds)
        self.information.setMinMaxControlDuration(1, steps)
        self.information.setup()
        self.definition = base.ProblemDefinition(self.information)
        self.definition.setStartAndGoalStates(
            self.state(problem.start), self.state(problem.goal), 1e-12
        )
        self.planner = control.RRT(self.information)
        self.planner.setGoalBias(0.25)
        self.planner.setProblemDefinition(self.definition)
        self.planner.setup()

    def state(self, q: np.ndarray) -> Any:
        """A pose as OMPL's state."""
        state = self.information.allocState()
        state.setXY(q[0], q[1])
        state.setYaw(q[2])
        return state

    def grow(self, iterations: int) -> Any:
        """The planner, after so many iterations."""
        from ompl import base

        left = [iterations]

        def is_enough() -> bool:
            left[0] -= 1
            return left[0] < 0

        self.planner.solve(base.PlannerTerminationCondition(is_enough))
        return self.planner

    def nodes(self, planner: Any) -> np.ndarray:
        """The poses of its tree, shape (n, 3)."""
        from ompl import base

        data = base.PlannerData(self.information)
        planner.getPlannerData(data)
        states = [data.getVertex(i).getState() for i in range(data.numVertices())]
        return np.array([(q.getX(), q.getY(), q.getYaw()) for q in states])


def bounds(base: Any, low: Any, high: Any) -> Any:
    """OMPL's bounds of two numbers."""
    made = base.RealVectorBounds(2)
    for i in range(2):
        made.setLow(i, float(low[i]))
        made.setHigh(i, float(high[i]))
    return made


def compiled_for(problem: ProblemRecord) -> tuple[Callable[..., Any], Callable[..., bool]]:
    """Where a drive leads, and whether a pose is free, compiled for one car in one world, whose
    arrays become constants.
    """
    from compiling import njit

    robot, world, wheelbase = problem.robot, problem.world, problem.robot.wheelbase

    @njit
    def step(x, y, theta, gear, phi, seconds):  # type: ignore[no-untyped-def]
        return drive_arc(x, y, theta, seconds if gear >= 0.0 else -seconds, np.tan(phi) / wheelbase)

    @njit
    def free(x, y, theta):  # type: ignore[no-untyped-def]
        return is_free(robot, world, np.array([x, y, theta]), 0.0)

    step(0.0, 0.0, 0.0, 1.0, 0.1, 1.0)
    free(*problem.start.tolist())
    return step, free


def toolbox_planner(
    problem: ProblemRecord, solid: list[Any], seed: int, nodes: int
) -> Callable[[], Any]:
    """The Robotics Toolbox's tree, from the goal, among what is solid, all a tenth as large; it
    returns the planner.
    """
    from roboticstoolbox import Bicycle, PolygonMap, RRTPlanner
    from spatialmath import Polygon2

    car, (lo, hi) = problem.robot, (problem.space.lo / 10.0, problem.space.hi / 10.0)
    place = PolygonMap(workspace=[lo[0], hi[0], lo[1], hi[1]])
    for outline in solid:
        place.add([(x / 10.0, y / 10.0) for x, y in outline])
    vehicle = Bicycle(
        steer_max=car.max_steering, L=car.wheelbase / 10.0, polygon=Polygon2(car.outline.T / 10.0)
    )
    root = [*(problem.goal[:2] / 10.0), problem.goal[2]]
    planner = RRTPlanner(
        map=place, vehicle=vehicle, curvature=10.0 / car.radius, npoints=nodes - 1, seed=seed
    )

    def run() -> Any:
        planner.plan(goal=root, showsamples=False, showvalid=False, animate=False)
        return planner

    return run
