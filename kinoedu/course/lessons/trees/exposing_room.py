"""The exercise "break it" of lesson 9: a room in which an RRT returns a path that is not free."""

from collections.abc import Iterator

import numpy as np

from ....errors import KinoeduError
from ....geometry.checks import Array
from ....messages import get_message
from ....problems.protocols import PlanningProblem
from ...exercise import RIGHT, Axes, Case, Exercise, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Numbers, Record, Together, Value
from ...tasks import StudentProblem
from ..shared.planned import find_path_fault
from ..shared.planned_pictures import draw_answer
from ..shared.small_problems import SQUARE, in_room

POINT = Numbers((2,))


class ExposeHastyGoal(Exercise):
    """Give start, goal and a triangle with which `hasty_rrt` goes through a wall.

    The room is 10 x 10.
    """

    name = "exposing_room"
    lesson = "09_trees"
    kinds = ("valid", "exposes", "no_way")
    given = Record()
    answer = Together((POINT, POINT, Numbers((3, 2))))

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield the same question three times; each time the answer must fulfil more."""
        return (Case(kind, {}) for kind in self.kinds)

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Judge that the problem is valid, that the path is not free, and that no path exists."""
        problem = make_problem(*value)
        rule = "valid" if problem is None else ""
        if problem is not None and case.kind != "valid":
            path = hasty_rrt(problem, 1.0, 0.05, 500, 0)
            if path is None:
                rule = "none"
            elif find_path_fault(problem, path) is None:
                rule = "exposes"
            if not rule and case.kind == "no_way" and is_connected(*value):
                rule = "no_way"
        return Verdict(0.0, rule, self.describe_expected(case)) if rule else RIGHT

    def describe_expected(self, case: Case) -> str:
        """Describe what the answer to a case must be."""
        return get_message(f"exposing_room.wanted.{case.kind}")

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the room and the path that the program returns."""
        problem = make_problem(*outcome.value) if isinstance(outcome, Answer) else None
        path = None if problem is None else hasty_rrt(problem, 1.0, 0.05, 500, 0)
        shown = (problem or in_room((1, 1), (9, 9))).problem
        fault = None if problem is None or path is None else find_path_fault(problem, path)
        draw_answer(shown, [], path, fault, get_message("exposing_room.picture"), ax)


def make_problem(start: Array, goal: Array, triangle: Array) -> StudentProblem | None:
    """Return the problem, or None where it is not valid."""
    if not all((np.abs(points) <= 100.0).all() for points in (start, goal, triangle)):
        return None
    try:
        return in_room(start, goal, triangle)
    except KinoeduError:
        return None


def is_connected(start: Array, goal: Array, triangle: Array) -> bool:
    """Whether a path leads from start to goal, both of them free.

    They must lie in one connected part of the room without the triangle.
    """
    import shapely

    parts = shapely.get_parts(shapely.Polygon(SQUARE) - shapely.Polygon(triangle))
    return any(
        part.intersects(shapely.Point(start)) and part.intersects(shapely.Point(goal))
        for part in parts
    )


def hasty_rrt(
    problem: PlanningProblem, step: float, goal_bias: float, iterations: int, rng: int
) -> Array | None:
    """Find a path from start to goal by a rapidly-exploring random tree, or return None.

    The program is wrong somewhere. Where?
    """
    chance, nodes, parent = np.random.default_rng(rng), [problem.start], [-1]
    for _ in range(iterations):
        if problem.distance(nodes[-1], problem.goal) <= step:
            path, node = [problem.goal], len(nodes) - 1
            while node >= 0:
                path.append(nodes[node])
                node = parent[node]
            return np.array(path[::-1])
        q_rand = problem.goal if chance.random() < goal_bias else problem.sample(chance)
        near = int(np.argmin([problem.distance(q, q_rand) for q in nodes]))
        q_new = problem.steer(nodes[near], q_rand, step)
        if problem.is_free_path(nodes[near], q_new):
            nodes.append(q_new)
            parent.append(near)
    return None
