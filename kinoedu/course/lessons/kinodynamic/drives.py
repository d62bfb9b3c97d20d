"""Targets and shapes of the exercises on planners that drive.

S. M. LaValle, J. J. Kuffner, "Randomized kinodynamic planning" (2001).
"""

import numpy as np

from ....geometry.checks import Array
from ...drivable import DrivingProblem
from ...shapes import Numbers
from ...whole_shapes import Integers
from .driven_trees import GOAL_EVERY, REGION_EVERY

ITERATIONS = {
    "same": 20,
    "room": 300,
    "turn": 95,
    "seam": 300,
    "thin": 300,
    "far": 60,
    "sealed": 100,
}
CONTROLS, DURATIONS, ROUTE = Numbers(("n", 2)), Numbers(("n",)), Integers(("k",))


def choose_target(problem: DrivingProblem, turn: int, rng: np.random.Generator) -> Array:
    """Return the target of an iteration.

    Every seventh is a pose near the goal, every other fourth is the goal, the rest are random.
    """
    if turn % REGION_EVERY == 0:
        return problem.near_goal(rng)
    return problem.goal if turn % GOAL_EVERY == 0 else problem.sample(rng)
