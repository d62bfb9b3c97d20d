"""The exercise `adjacency_matrix`. Bullo & Smith, chapters 2 and 5."""

from collections.abc import Callable, Iterator

import numpy as np
from numpy.typing import NDArray

from ....geometry.checks import Array
from ....problems.protocols import PlanningProblem
from ....robots import Disk, RigidPolygon
from ....worlds import PolygonWorld, scattered
from ...exercise import Axes, Case, Change, Restated, Slip, ValueExercise, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Numbers, Record, Value
from ...tasks import ProblemShape
from ...withheld import withheld
from ..shared.small_problems import SQUARE, box
from .matrices import LESSON, MATRIX, draw_case, make_problem, swap_entries
from .pictures import draw_matrix

Matrix = NDArray[np.int64]

THIN = 0.001  # of a wall; thousands of points of a motion miss it
TOUCHED = PolygonWorld(SQUARE, [box(4, 2, 6, 4.5)])
STICK = RigidPolygon([(-0.8, -0.2), (0.8, -0.2), (0.8, 0.2), (-0.8, 0.2)])
CORRIDOR = PolygonWorld([(0, 0), (10, 0), (10, 1.4), (0, 1.4)], [box(4.9, 0, 5.1, 0.8)])


def relate_pairs(problem: PlanningProblem, nodes: Array, joined: Callable[..., bool]) -> Matrix:
    """Return a symmetric relation between configurations as a matrix, zero on the diagonal."""
    matrix = np.zeros((len(nodes), len(nodes)), np.int64)
    for i, j in zip(*np.triu_indices(len(nodes), 1)):
        matrix[i, j] = matrix[j, i] = joined(problem, nodes[i], nodes[j])
    return matrix


@withheld
def find_free_motions(problem: PlanningProblem, nodes: Array) -> Matrix:
    """Return a matrix with 1 where the motion between two configurations is free."""
    return relate_pairs(problem, nodes, lambda problem, a, b: problem.is_free_path(a, b))


def is_free_at_middle(problem: PlanningProblem, a: Array, b: Array) -> bool:
    """Whether a motion is free at its middle and at its ends."""
    middle = problem.steer(a, b, problem.distance(a, b) / 2)
    return bool(problem.is_free(a) and problem.is_free(b) and problem.is_free(middle))


def draw_far_motion(rng: np.random.Generator) -> Case:
    """Case with a free motion between nodes of which neither is among the other's ten nearest."""
    while True:
        world = scattered(1, side=10.0, radius=1.0, rng=rng)
        case = draw_case("many", Disk(0.2), world, rng, 14)
        problem, nodes = case.given.values()
        off = np.linalg.norm(nodes[:, None] - nodes, axis=2)
        far = off > np.sort(off)[:, 10:11]
        if (find_free_motions(problem.problem, nodes) * far * far.T).any():
            return case


def chain_nodes(problem: PlanningProblem, nodes: Array) -> Matrix:
    """Return a matrix that joins each node only to the next."""
    matrix = find_free_motions(problem, nodes)
    return np.triu(np.tril(matrix, 1), -1)


class AdjacencyMatrix(ValueExercise):
    """Compute the matrix of free motions between configurations."""

    name = "adjacency_matrix"
    lesson = LESSON
    kinds = ("two", "wall", "turn", "many")
    given = Record(problem=ProblemShape(), nodes=Numbers(("n", "d")))
    answer = MATRIX
    source = staticmethod(find_free_motions)
    slips = (
        Slip(
            "ends_only",
            lambda problem, nodes: relate_pairs(
                problem, nodes, lambda p, a, b: p.is_free(a) and p.is_free(b)
            ),
        ),
        Slip("halfway", lambda problem, nodes: relate_pairs(problem, nodes, is_free_at_middle)),
        Slip(
            "touching",
            lambda problem, nodes: relate_pairs(
                problem, nodes, lambda p, a, b: p.is_semi_free_path(a, b)
            ),
        ),
        Slip("one_side", lambda problem, nodes: np.triu(find_free_motions(problem, nodes))),
        Slip("one_side", lambda problem, nodes: np.tril(find_free_motions(problem, nodes))),
        Slip(
            "loops", lambda problem, nodes: find_free_motions(problem, nodes) + np.eye(len(nodes))
        ),
        Slip(
            "contact",
            lambda problem, nodes: swap_entries(find_free_motions(problem, nodes)),
        ),
        Slip("chained", chain_nodes),
    )
    changes = (
        Change("upper_half", lambda matrix, problem, nodes: np.triu(matrix(problem, nodes))),
        Restated("contact", answer=lambda matrix, *given: swap_entries(matrix)),
    )

    @staticmethod
    @withheld
    def reference(problem: PlanningProblem, nodes: Array) -> Matrix:
        """Return the matrix by the course's own collision check of motions."""
        return find_free_motions(problem, nodes)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield two or three configurations, a thin wall, a corridor, a contact, and roadmaps.

        In the corridor a step to the side is free, and half a turn is not.
        """
        for _ in range(10):
            room = scattered(3, side=10.0, radius=1.5, rng=rng)
            yield draw_case("two", Disk(0.5), room, rng, int(rng.integers(2, 4)))
            wall = float(np.round(rng.uniform(4.0, 6.0), 2))
            end = round(wall + THIN, 3)
            thin = PolygonWorld(
                SQUARE, [box(wall, 0, end, float(np.round(rng.uniform(5.0, 8.0), 1)))]
            )
            yield draw_case("wall", Disk(THIN / 2), thin, rng, 5)
            # a sill is between the three nodes on the left and the two on the right
            x = np.round(np.concatenate([rng.uniform(1.0, 3.8, 3), rng.uniform(6.2, 9.0, 2)]), 2)
            poses = np.column_stack([x, np.full(5, 0.7), rng.choice([0.0, 0.2, 3.0, -3.0], 5)])
            yield Case("turn", {"problem": make_problem(STICK, CORRIDOR, poses[0]), "nodes": poses})
        # the disk touches the box between the first and the second node
        beside = np.array([(2, 5), (8, 5), (5, 8)], float)
        at_one_place = np.array([(2, 5), (2, 5), (5, 8)], float)
        for nodes in (beside, at_one_place):
            problem = make_problem(Disk(0.5), TOUCHED, nodes[0])
            yield Case("two", {"problem": problem, "nodes": nodes})
        for _ in range(10):
            world = scattered(8, side=10.0, radius=1.4, rng=rng)
            robot = (STICK, Disk(0.4))[int(rng.integers(2))]
            yield draw_case("many", robot, world, rng, int(rng.integers(6, 13)))
        yield draw_far_motion(rng)

    def same(self, value: Value, truth: Value) -> bool:
        """Whether the entries are the same."""
        return np.array_equal(value, truth)

    def describe_expected(self, case: Case) -> str:
        """Describe the right matrix, row by row."""
        return str(self.as_asked(self.truth(case), case).tolist())

    def describe_answer(self, case: Case, value: Value) -> str:
        """Describe the student's matrix, row by row."""
        return str(value.tolist())

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Judge the entries; a wrong size and missing ones break rules of their own."""
        verdict = super().value_verdict(case, value)
        if len(value) != len(case.given["nodes"]):
            return verdict._replace(rule="size")
        lacks_ones_only = not verdict.is_right and not value[value != self.truth(case)].any()
        return verdict._replace(rule="missing") if lacks_ones_only else verdict

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the configurations, the free motions, and the entries that are wrong."""
        value = outcome.value if isinstance(outcome, Answer) else None
        text = self.message(f"pictures.{case.kind}")
        draw_matrix(
            case.given["problem"].problem, case.given["nodes"], self.truth(case), value, text, ax
        )
