"""Shared by the exercises on adjacency matrices. Bullo & Smith, chapters 2 and 5."""

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from ....collision import free_configurations
from ....problems import Problem
from ....robots import Disk
from ...exercise import Case, Verdict
from ...outcomes import Outcome
from ...shapes import Record
from ...tasks import Asked
from ...whole_shapes import Whole, WholeNumbers
from ..graphs.paths import PathExercise
from ..shared.random_graphs import Neighbours, symmetric

CROWD = np.pad(
    1 - np.eye(13, dtype=np.int64), (0, 1)
)  # everyone is joined to everyone, but for the last


LESSON = "11_polygons_in_the_plane"


MATRIX = WholeNumbers(("n", "n"))


def at_rest(robot: Any, world: Any, q: Any) -> Asked:
    """A problem that is no task, for what it can be asked."""
    return Asked(Problem(robot, world, q, q))


def case(kind: str, robot: Any, world: Any, rng: np.random.Generator, n: int) -> Case:
    """A case of n free configurations at random, two decimals."""
    d = 2 if isinstance(robot, type(Disk(1.0))) else 3
    drawn = np.round(rng.uniform((0, 0, -3.1)[:d], (10, 10, 3.1)[:d], (2000, d)), 2)
    nodes = drawn[free_configurations(robot, world, drawn)][:n]
    return Case(kind, {"problem": at_rest(robot, world, nodes[0]), "nodes": nodes})


def lists_of(matrix: Any) -> Neighbours:
    """Adjacency lists, which other exercises have."""
    return [np.flatnonzero(row).tolist() for row in np.asarray(matrix)]


def in_lists(case: Case) -> Case:
    """The same question of adjacency lists."""
    given = dict(case.given)
    matrix = given.pop("matrix", None)
    return case if matrix is None else Case(case.kind, {"neighbours": lists_of(matrix), **given})


def on_matrix(search: Callable[..., Any]) -> Callable[..., Any]:
    """A search of adjacency lists as one of a matrix."""
    return lambda matrix, start, goal: search(lists_of(matrix), start, goal)


class OnMatrix(PathExercise):
    """Lesson 4's question, of an adjacency matrix: a path between two nodes, or None."""

    lesson = LESSON
    kinds = ("small", "cycle", "unreachable", "start_is_goal")
    given = Record(matrix=MATRIX, start=Whole(), goal=Whole())

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Those of lesson 4 whose edges lead both ways; before the larger ones a crowd, of more
        ways than can be tried.
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

    def truth(self, case: Case) -> Any:
        """Of the lists."""
        return super().truth(in_lists(case))

    def value_verdict(self, case: Case, value: Any) -> Verdict:
        """By the edges of the lists."""
        return super().value_verdict(in_lists(case), value)

    def draw(self, case: Case, outcome: Outcome, ax: Any) -> None:
        """The graph, a right path and the student's."""
        super().draw(in_lists(case), outcome, ax)
