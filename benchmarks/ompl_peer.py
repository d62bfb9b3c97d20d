"""OMPL at its best from Python: its validators ask kinoedu's own exact test of a motion, compiled
for four numbers, which costs a quarter of a microsecond a call; and they stop the planner
themselves, so that it asks Python nothing else.
"""

from collections.abc import Callable
from typing import Any

import numpy as np

from kinoedu.collision import is_free_path
from kinoedu.problems import ProblemRecord

FreeMotion = Callable[[float, float, float, float], bool]


def compiled_test(problem: ProblemRecord) -> FreeMotion:
    """Whether the motion from (ax, ay) to (bx, by) is free, compiled for one world, whose arrays
    become constants.
    """
    from compiling import njit

    robot, world, clearance = problem.robot, problem.world, problem.clearance

    @njit
    def free(ax, ay, bx, by):  # type: ignore[no-untyped-def]
        return is_free_path(robot, world, np.array([ax, ay]), np.array([bx, by]), clearance)

    free(0.0, 0.0, 0.0, 0.0)
    return free


class Setup:
    """A problem as OMPL's objects: `information` and `definition`; `motions` and `places` stop a
    planner after so many yeses.
    """

    def __init__(self, problem: ProblemRecord, free: FreeMotion) -> None:
        from ompl import base, util

        util.setLogLevel(util.LogLevel.LOG_NONE)
        bounds = base.RealVectorBounds(2)
        for i in range(2):
            bounds.setLow(i, problem.space.lo[i])
            bounds.setHigh(i, problem.space.hi[i])
        self.space = base.RealVectorStateSpace(2)
        self.space.setBounds(bounds)
        self.information = base.SpaceInformation(self.space)
        self.motions, self.places = Countdown(), Countdown()
        self.validator = motion_validator(self.information, free, self.motions)
        self.information.setMotionValidator(self.validator)
        self.information.setStateValidityChecker(
            lambda q: self.places.count(free(q[0], q[1], q[0], q[1]))
        )
        self.information.setup()
        self.definition = base.ProblemDefinition(self.information)
        self.definition.setStartAndGoalStates(self.state(problem.start), self.state(problem.goal))

    def state(self, q: np.ndarray) -> Any:
        """A configuration as OMPL's state."""
        state = self.information.allocState()
        state[0], state[1] = q
        return state

    def data(self, planner: Any) -> Any:
        """What a planner has built."""
        from ompl import base

        data = base.PlannerData(self.information)
        planner.getPlannerData(data)
        return data


class Countdown:
    """Tells a planner to stop after so many yeses."""

    def __init__(self) -> None:
        self.left, self.condition = 0, None

    def start(self, yeses: int) -> Any:
        """The condition on which the planner stops."""
        from ompl import base

        self.left, self.condition = yeses, base.plannerNonTerminatingCondition()
        return self.condition

    def count(self, yes: bool) -> bool:
        """The same answer, counted."""
        if yes:
            self.left -= 1
            if self.left == 0:
                self.condition.terminate()
        return yes


def motion_validator(information: Any, free: FreeMotion, motions: Countdown) -> Any:
    """OMPL's question about a motion, answered by the compiled test."""
    from ompl import base

    class Validator(base.MotionValidator):
        def checkMotion(self, a: Any, b: Any) -> bool:
            return motions.count(free(a[0], a[1], b[0], b[1]))

    return Validator(information)
