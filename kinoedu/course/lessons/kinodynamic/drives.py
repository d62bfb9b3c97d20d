"""Shared by the exercises on planners that drive. LaValle, Kuffner, "Randomized kinodynamic
planning" (2001).
"""

from typing import Any

import numpy as np

from ....geometry.checks import Array
from ...shapes import Numbers
from ...whole_shapes import WholeNumbers
from ..shared.planned import Fault
from .driven_trees import (
    GOAL_EVERY,
    REGION_EVERY,
)

TURNS = {"same": 20, "room": 300, "turn": 95, "seam": 300, "thin": 300, "far": 60, "sealed": 100}


CONTROLS, DURATIONS, ROUTE = Numbers(("n", 2)), Numbers(("n",)), WholeNumbers(("k",))


def place_to_go(problem: Any, turn: int, rng: np.random.Generator) -> Array:
    """Every seventh turn a pose near the goal, every fourth the goal, else any."""
    if turn % REGION_EVERY == 0:
        return problem.near_goal(rng)
    return problem.goal if turn % GOAL_EVERY == 0 else problem.sample(rng)


def stopped_early(nodes: Array, iterations: int) -> Fault | None:
    """Far fewer nodes than there were turns: no garage is as narrow as that."""
    return Fault("stopped", nodes[-1:]) if 5 * len(nodes) < iterations else None
