"""The base class of the exercises on adjacency matrices. Bullo & Smith, chapters 2 and 5."""

from collections.abc import Callable, Iterator

import numpy as np

from ....collision import free_configurations
from ....problems import Problem
from ....robots.round import RoundRobot
from ...exercise import Axes, Case, Restated, Verdict
from ...outcomes import Outcome
from ...shapes import Record, Value
from ...tasks import StudentProblem
from ...whole_shapes import Integer, Integers
from ..graphs.paths import PathExercise
from ..shared.random_graphs import Neighbours, symmetric

# a complete graph, and a node without edges
CROWD = np.pad(1 - np.eye(13, dtype=np.int64), (0, 1))
LESSON = "11_polygons_in_the_plane"
MATRIX = Integers(("n", "n"))


def make_problem(robot: Value, world: Value, q: Value) -> StudentProblem:
    """Return a problem whose start and goal are the same, for its collision checks alone."""
    return StudentProblem(Problem(robot, world, q, q))


def draw_case(kind: str, robot: Value, world: Value, rng: np.random.Generator, n: int) -> Case:
    """Draw a case with n random free configurations, rounded to two decimals."""
    d = 2 if isinstance(robot, RoundRobot) else 3  # a heading makes no difference to a disk
    drawn = np.round(rng.uniform((0, 0, -3.1)[:d], (10, 10, 3.1)[:d], (2000, d)), 2)
    nodes = drawn[free_configurations(robot, world, drawn)][:n]
    return Case(kind, {"problem": make_problem(robot, world, nodes[0]), "nodes": nodes})


def swap_entries(matrix: Value) -> Value:
    """Swap ones and zeros outside the diagonal."""
    return 1 - np.eye(len(matrix), dtype=np.int64) - matrix


def list_neighbours(matrix: Value) -> Neighbours:
    """Convert an adjacency matrix to adjacency lists."""
    return [np.flatnonzero(row).tolist() for row in np.asarray(matrix)]


def convert_case(case: Case) -> Case:
    """Return the same case with adjacency lists."""
    given = dict(case.given)
    matrix = given.pop("matrix", None)
    return (
        case
        if matrix is None
        else Case(case.kind, {"neighbours": list_neighbours(matrix), **given})
    )


def search_matrix_by(search: Callable[..., object]) -> Callable[..., Value]:
    """Convert a search on adjacency lists to a search on an adjacency matrix."""
    return lambda matrix, start, goal: search(list_neighbours(matrix), start, goal)


class MatrixExercise(PathExercise):
    """An exercise on a path between two nodes of an adjacency matrix."""

    lesson = LESSON
    kinds = ("small", "cycle", "unreachable", "start_is_goal")
    given = Record(matrix=MATRIX, start=Integer(), goal=Integer())
    changes = (
        Restated("from_goal", answer=lambda path, *given: path[::-1]),
        Restated("contact", given=lambda matrix, *ends: (swap_entries(matrix), *ends)),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield the cases of lesson 4 whose edges lead both ways.

        Before the larger ones comes a dense graph that has more paths than can be tried.
        """
        found = []
        for case in super().cases(rng):
            neighbours, start, goal = case.given.values()
            if case.kind != "directed" and symmetric(neighbours):
                matrix = np.array(
                    [[int(v in row) for v in range(len(neighbours))] for row in neighbours]
                )
                found.append(Case(case.kind, {"matrix": matrix, "start": start, "goal": goal}))
        at = next(i for i, case in enumerate(found) if len(case.given["matrix"]) > len(CROWD))
        yield from found[:at]
        yield Case("unreachable", {"matrix": CROWD, "start": 0, "goal": len(CROWD) - 1})
        yield from found[at:]

    def truth(self, case: Case) -> Value:
        """Return the right answer on the adjacency lists."""
        return super().truth(convert_case(case))

    def value_verdict(self, case: Case, value: object) -> Verdict:
        """Judge the path on the adjacency lists; where start is goal there is a rule of its own."""
        verdict = super().value_verdict(convert_case(case), value)
        there = case.kind == "start_is_goal" and not verdict.is_right
        return verdict._replace(rule="there") if there else verdict

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the graph, a right path and the student's."""
        super().draw(convert_case(case), outcome, ax)
