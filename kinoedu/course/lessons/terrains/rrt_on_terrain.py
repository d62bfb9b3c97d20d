"""The base class of the exercises on two planners on a bitmap, and the exercise on the RRT.

Both planners are those of the document that lesson 10 examines; `repeated_rows.py` names it.
"""

from collections.abc import Callable, Iterator

import numpy as np
from numpy.typing import ArrayLike

from ....geometry.checks import Array
from ....graphs import extract_path
from ....planners.trees.spaced import grow_spaced
from ....problems import Problem, Tree
from ....problems.protocols import PlanningProblem
from ....robots import Point
from ....worlds import Terrain
from ...exercise import Case, Given
from ...shapes import Maybe, Number, Record, Together, Truth, Value
from ...watching import call_three_times, read_attempts
from ...whole_shapes import Integer, Integers
from ...withheld import withheld
from ..shared.planned import (
    NODES,
    PATH,
    Fault,
    PlannerExercise,
    ProblemShape,
    StudentProblem,
    find_motion_off_tree,
    find_node_off_nearest,
    find_path_fault,
    find_tree_fault,
    find_unreturned_path,
    measure_distances,
    with_other_seed,
)
from .attempts import LOG, find_attempt_fault

STEP, SPACING, FAILURES = 6.0, 3.0, 400
WIDE = 5.0  # a larger spacing
SELDOM = 0.3  # a goal bias that is not one half
KINDS = ("same", "open", "thin", "bag", "sealed")
LEAST = 45  # nodes of a tree that fills the terrain outside the sealed corner: 60 and more
MOST_NODES = 2_000  # far more than find room with the spacing
SMALL = 40  # cells along each side


def make_terrain_problem(blocked: Value, start: ArrayLike, goal: ArrayLike) -> StudentProblem:
    """Return a point's problem on 40 x 40 cells with blocked boxes (x0, y0, x1, y1)."""
    free = np.ones((SMALL, SMALL), np.bool_)
    for x0, y0, x1, y1 in blocked:
        free[y0:y1, x0:x1] = False
    return StudentProblem(Problem(Point(), Terrain(free), start, goal))


TERRAINS = {
    "same": make_terrain_problem([], (20.5, 20.5), (20.5, 20.5)),
    "open": make_terrain_problem([(17, 12, 20, 16)], (5.5, 5.5), (34.5, 33.5)),
    # a wall one cell thick, less than a step from the goal
    "thin": make_terrain_problem([(33, 14, 34, 26)], (6.5, 20.5), (35.5, 20.5)),
    "bag": make_terrain_problem(
        [(26, 10, 28, 30), (14, 10, 28, 12), (14, 28, 28, 30)], (22.5, 20.5), (34.5, 20.5)
    ),
    "sealed": make_terrain_problem([(28, 28, 40, 30), (28, 28, 30, 40)], (5.5, 5.5), (35.5, 35.5)),
}
EMPTY = make_terrain_problem([], (5.5, 5.5), (34.5, 33.5))
LEVEL = make_terrain_problem([], (3.5, 8.5), (35.5, 8.5))
# the last step of the straight way to the goal runs along a rock
GRAZED = make_terrain_problem([(32, 16, 33, 20)], (6.5, 20.0), (34.5, 20.0))
# the last step of the straight way, or the one before it, cuts off a rock's corner, so little that
# the chord fits between sampled points
CUT = [
    make_terrain_problem([(30, 29, 31, 30)], (6.5, 6.5), goal)
    for goal in ((31.5, 31.495), (37.2, 37.193))
]
EXACT = {"step": 4.0, "spacing": 4.0}  # LEVEL is eight steps, all of which floats can hold


class TerrainPlanner(PlannerExercise):
    """An exercise on a planner on small terrains that are traps."""

    lesson = "10_terrains"
    kinds = KINDS

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield each terrain twice, and random rocks."""
        for _ in range(2):
            for kind, problem in TERRAINS.items():
                yield self.make_case(kind, problem, int(rng.integers(1000)))
        for _ in range(2):
            corners = rng.integers(8, 28, (5, 2))
            rocks = [(x, y, x + 4, y + 4) for x, y in corners.tolist()]
            yield self.make_case(
                "open",
                make_terrain_problem(rocks, (3.5, 3.5), (36.5, 36.5)),
                int(rng.integers(1000)),
            )

    def make_case(self, kind: str, problem: StudentProblem, rng: int) -> Case:
        """Return the case of a problem with a seed."""
        raise NotImplementedError

    def fault_of_end(self, case: Case, path: Array | None) -> Fault | None:
        """Judge the path, or that none is returned only where none exists."""
        if path is None:
            return None if case.kind == "sealed" else Fault("missed", np.empty((0, 2)))
        return find_path_fault(case.given["problem"], path)


@withheld
def grow_tree(
    problem: PlanningProblem, step: float, spacing: float, goal_bias: float, failures: int, rng: int
) -> Value:
    """Grow the RRT as the exercise demands, and return nodes, parents and path."""
    chance, nodes, parent, in_a_row = np.random.default_rng(rng), [problem.start], [-1], 0

    def reached(q: Array) -> bool:
        return problem.distance(q, problem.goal) <= step and problem.is_free_path(q, problem.goal)

    while in_a_row < failures and not reached(nodes[-1]):
        q_rand = problem.goal if chance.random() < goal_bias else problem.sample(chance)
        near = int(np.argmin([problem.distance(q, q_rand) for q in nodes]))
        q_new = problem.steer(nodes[near], q_rand, step)
        in_a_row += 1
        apart = min(problem.distance(q, q_new) for q in nodes) >= spacing
        if apart and problem.is_free_path(nodes[near], q_new):
            nodes.append(q_new)
            parent.append(near)
            in_a_row = 0
    if in_a_row == failures:
        return nodes, parent, None
    nodes.append(problem.goal)
    parent.append(len(nodes) - 2)
    return nodes, parent, np.array(nodes)[extract_path(np.array(parent), len(nodes) - 1)]


class RrtOnTerrain(TerrainPlanner):
    """Grow one tree with a goal bias, until too many attempts in a row fail."""

    name = "rrt_on_terrain"
    given = Record(
        problem=ProblemShape(),
        step=Number(),
        spacing=Number(),
        goal_bias=Number(),
        failures=Integer(),
        rng=Integer(),
    )
    result = Together((NODES, Integers(("n",)), Maybe(PATH)))
    answer = Together((result, result, result, Truth(), LOG, LOG), is_returned=False)
    source = staticmethod(grow_tree)
    shown = staticmethod(grow_spaced)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield the cases of both planners, then open ground and touched rocks with goal bias 1.

        The second case without a path has a smaller goal bias. On level ground every node is
        exactly the spacing from the one before it.
        """
        sealed = 0
        for case in super().cases(rng):
            sealed += case.kind == "sealed"
            seldom = case.kind == "sealed" and sealed == 2
            yield case._replace(given={**case.given, "goal_bias": SELDOM}) if seldom else case
        always = self.make_case("open", EMPTY, int(rng.integers(1000)))
        yield Case("open", {**always.given, "goal_bias": 1.0})
        yield Case("open", {**always.given, "problem": LEVEL, "goal_bias": 1.0, **EXACT})
        for problem in (GRAZED, *CUT):
            yield Case("sealed", {**always.given, "problem": problem, "goal_bias": 1.0})
        # the spacing is not half a step
        yield Case("open", {**always.given, "spacing": WIDE})

    def make_case(self, kind: str, problem: StudentProblem, rng: int) -> Case:
        """Return a case, with fewer failures where no path exists, to end the tree's growth."""
        failures = 80 if kind == "sealed" else FAILURES
        tuning = {"step": STEP, "spacing": SPACING, "goal_bias": 0.5, "failures": failures}
        return Case(kind, {"problem": problem, **tuning, "rng": rng})

    def call(self, function: Callable[..., object], given: Given) -> Value:
        """Call the planner three times, and read the attempts of the first and the third call."""
        return call_three_times(function, given, read_attempts)

    def fault_of_three(self, case: Case, value: Value) -> Fault | None:
        """What is wrong with the answers, with their attempts or with their randomness, or None."""
        log, other_log = value[4:]
        fault = super().fault_of_three(case, value[:4])
        if fault is not None:
            return fault
        nodes, _, path = value[0]
        fault = find_attempt_fault(case.given, nodes, path, log)
        if fault is not None:
            return fault
        nodes, _, path = value[2]
        fault = find_attempt_fault(with_other_seed(case).given, nodes, path, other_log)
        return None if fault is None else fault._replace(call=2)

    def uses_chance(self, case: Case) -> bool:
        """Whether another seed gives another answer: not with goal bias 1."""
        return super().uses_chance(case) and case.given["goal_bias"] < 1.0

    def fault(self, case: Case, answer: Value) -> Fault | None:
        """Judge the path, the tree and its rule, and where the search gave up.

        The path must also belong to the tree.
        """
        nodes, parent, path = answer
        problem = case.given["problem"]
        fault = None if path is None else self.fault_of_end(case, path)
        fault = (
            fault
            or find_tree_fault(problem, nodes, parent, case.given["step"])
            or find_unreturned_path(problem, nodes, path)
            or find_node_off_nearest(problem, nodes, parent)
        )
        fault = (
            fault
            or find_close_node(problem, nodes, case.given["spacing"])
            or find_missed_goal(problem, nodes, path, case.given["step"])
        )
        fault = fault or (
            find_stray_node(problem, nodes) if case.given["goal_bias"] == 1.0 else None
        )
        if fault is None and path is not None:
            fault = find_motion_off_tree(path, nodes, parent)
        fills = case.kind == "sealed" and case.given["goal_bias"] < 1.0
        if fault is None and fills and len(nodes) < LEAST:
            fault = Fault("gave_up", nodes[:0])
        return fault or self.fault_of_end(case, path)

    def size_limit(self, case: Case) -> int:
        """The most rows: no nodes are closer than the spacing, so that few are possible."""
        return MOST_NODES

    def drawn(self, answer: Value) -> tuple[list[Tree], Array | None]:
        """Return the tree and the path."""
        nodes, parent, path = answer
        return [Tree(nodes, parent)], path


def find_close_node(problem: PlanningProblem, nodes: Array, spacing: float) -> Fault | None:
    """Return the fault of a node nearer than the spacing to an earlier one, or None.

    The goal is excepted.
    """
    for i in range(1, len(nodes)):
        apart = measure_distances(problem, nodes[:i], nodes[i])
        if apart.min() < spacing * (1.0 - 1e-9) and not np.array_equal(nodes[i], problem.goal):
            return Fault("too_near", nodes[[int(np.argmin(apart)), i]])
    return None


def find_missed_goal(
    problem: StudentProblem, nodes: Array, path: Array | None, step: float
) -> Fault | None:
    """Return the fault of a tree that grew on although the goal could be added, or None.

    With a path, only the goal and its parent may be within free reach of the goal.
    """
    for q in nodes[: len(nodes) - (0 if path is None else 2)]:
        near = problem.distance(q, problem.goal) <= step
        if near and problem.problem.is_free_path(q, problem.goal):
            return Fault("went_past", np.array([q, problem.goal]))
    return None


def find_stray_node(problem: PlanningProblem, nodes: Array) -> Fault | None:
    """Return the fault of a node that is off the segment from start to goal, or None.

    With goal bias 1 on open ground every node lies on that segment.
    """
    straight_length = problem.distance(problem.start, problem.goal)
    for q in nodes:
        if problem.distance(problem.start, q) + problem.distance(
            q, problem.goal
        ) > straight_length + 1e-6 * (1.0 + straight_length):
            return Fault("always_the_goal", q[None])
    return None
