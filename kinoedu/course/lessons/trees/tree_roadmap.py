"""The exercise on the incremental tree roadmap. Bullo & Smith, chapter 5."""

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .... import planners
from ....geometry.checks import Array
from ....problems import Tree
from ....problems.protocols import PlanningProblem, ProblemLike
from ...exercise import Axes, Case, Restated, Slip, ValueExercise
from ...expansions import EXPANSIONS, Rule
from ...outcomes import Answer, Outcome
from ...shapes import Record, Together, Value
from ...whole_shapes import Integer, Integers
from ...withheld import withheld
from ..shared.planned import NODES, TRAPS, Fault, ProblemShape, find_tree_fault
from ..shared.planned_pictures import draw_answer
from ..shared.small_problems import box, in_room
from .tree_forms import make_root_its_parent, make_root_parentless, number_backwards

PILLARS = in_room((1, 1), (9, 9), box(3, 3, 5, 5), box(6, 1, 7, 6), box(2, 7, 8, 8))

# a narrow cell round the start, in which most motions are blocked
CELL = in_room(
    (1, 1),
    (9, 9),
    box(0.5, 0.5, 0.8, 1.5),
    box(1.2, 0.5, 1.5, 1.5),
    box(0.8, 0.5, 1.2, 0.8),
    box(0.8, 1.2, 1.2, 1.5),
)

# a pillar among walls that fit between sampled points of a motion
SHEETS = in_room(
    (1, 1),
    (9, 9),
    box(4, 4, 5, 6.5),
    *(box(x, y, x + 0.001, y + 2.5) for x in (2, 7) for y in (0.5, 4, 6.8)),
)


def grow_by(
    problem: PlanningProblem,
    expand: Any,
    iterations: int,
    rng: int,
    *,
    accepts: Callable[..., bool],
) -> tuple[Array, NDArray[np.int64]]:
    """Grow a tree by an expansion, with only those of its edges that are accepted."""
    chance, nodes, parent = np.random.default_rng(rng), [problem.start], [-1]
    for _ in range(iterations):
        node, q = expand(problem, np.array(nodes), chance)
        if accepts(problem, nodes[node], q):
            nodes.append(q)
            parent.append(node)
    return np.array(nodes), np.array(parent)


@withheld
def grow_free_tree(
    problem: PlanningProblem, expand: Any, iterations: int, rng: int
) -> tuple[Array, NDArray[np.int64]]:
    """Grow the tree of all free edges."""
    return grow_by(
        problem, expand, iterations, rng, accepts=lambda problem, a, b: problem.is_free_path(a, b)
    )


def grow_unchecked(*given: Value) -> Value:
    """Add every edge."""
    return grow_by(*given, accepts=lambda problem, a, b: True)


def check_ends_only(*given: Value) -> Value:
    """Check only whether the new node is free."""
    return grow_by(*given, accepts=lambda problem, a, b: problem.is_free(b))


def allow_contact(*given: Value) -> Value:
    """Accept motions that touch obstacles."""
    return grow_by(*given, accepts=lambda problem, a, b: problem.is_semi_free_path(a, b))


def seed_each_time(problem: PlanningProblem, expand: Any, iterations: int, rng: int) -> Value:
    """Make a new generator from the seed in every iteration."""

    def expand_anew(problem: PlanningProblem, nodes: Array, _: np.random.Generator) -> Value:
        return expand(problem, nodes, np.random.default_rng(rng))

    return grow_by(
        problem,
        expand_anew,
        iterations,
        rng,
        accepts=lambda problem, a, b: problem.is_free_path(a, b),
    )


def count_from_one(*given: Value) -> Value:
    """Count parents from 1."""
    nodes, parent = grow_free_tree(*given)
    return nodes, np.where(parent < 0, -1, parent + 1)


def chain_nodes(*given: Value) -> Value:
    """Attach every node to the one before it."""
    nodes, _ = grow_free_tree(*given)
    return nodes, np.arange(len(nodes)) - 1


class TreeRoadmap(ValueExercise):
    """Grow a tree with a given expansion function."""

    name = "tree_roadmap"
    lesson = "09_trees"
    kinds = ("few", "room", "pillars")
    given = Record(problem=ProblemShape(), expand=Rule(), iterations=Integer(), rng=Integer())
    answer = Together((NODES, Integers(("n",))))
    source = staticmethod(grow_free_tree)
    shown = staticmethod(planners.tree_roadmap)
    slips = (
        Slip("unchecked", grow_unchecked),
        Slip("ends_only", check_ends_only),
        Slip("touching", allow_contact),
        Slip("seeded_again", seed_each_time),
        Slip("from_one", count_from_one),
        Slip("chained", chain_nodes),
    )

    changes = (
        Restated("own_parent", answer=make_root_its_parent, usual_answer=make_root_parentless),
        Restated("newest_first", answer=number_backwards),
    )

    @staticmethod
    @withheld
    def reference(*given: Value) -> Value:
        """Return the tree of all free edges."""
        return grow_free_tree(*given)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield no iteration, one and a few; then many, with every expansion."""
        for iterations in (0, 1, 2, 3, 4, 5):
            for trap in ("room", "wall"):
                yield make_case("few", TRAPS[trap], "reach_out", iterations, rng)
        for _ in range(4):
            for name in EXPANSIONS:
                yield make_case("room", TRAPS["room"], name, int(rng.integers(10, 40)), rng)
                problem = (PILLARS, TRAPS["passage"])[int(rng.integers(2))]
                yield make_case("pillars", problem, name, int(rng.integers(20, 80)), rng)
        for name in EXPANSIONS:
            yield make_case("pillars", CELL, name, 80, rng)
        yield make_case("pillars", SHEETS, "leap", 60, rng)

    def same(self, value: Value, truth: Value) -> bool:
        """Whether the nodes are the same, in the same order, with the same parents."""
        return all(
            np.shape(a) == np.shape(b) and np.allclose(a, b, rtol=0, atol=1e-9)
            for a, b in zip(value, truth)
        )

    def describe_expected(self, case: Case) -> str:
        """Describe the size of the right tree."""
        nodes, _ = self.truth(case)
        return self.message("wanted", nodes=len(nodes), iterations=case.given["iterations"])

    def describe_answer(self, case: Case, value: Value) -> str:
        """Describe the size of the student's tree and its first wrong node."""
        at = find_first_difference(value, self.truth(case))
        return self.message("answered", nodes=len(value[0]), node=at)

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the student's tree and its first fault."""
        problem = case.given["problem"]
        trees, fault, seen = [], None, "begins"
        if isinstance(outcome, Answer):
            trees = [Tree(*outcome.value)]
            fault = self.find_fault(case, trees[0])
            seen = "ends" if fault is None else case.kind
        if fault is not None and fault.marked.shape[1] != len(problem.start):
            fault = None
        draw_answer(problem.problem, trees, None, fault, self.message(f"pictures.{seen}"), ax)

    def find_fault(self, case: Case, tree: Tree) -> Fault | None:
        """The first fault of a tree, or node that differs; None if it only ends early."""
        fault = find_tree_fault(case.given["problem"], *tree, step=np.inf)
        at = find_first_difference(tree, self.truth(case))
        if fault is None and at < len(tree.nodes):
            return Fault("other", tree.nodes[at : at + 1])
        return fault


def find_first_difference(value: Value, truth: Value) -> int:
    """Return the index of the first node that differs in position or parent."""
    for i, (p, q, a, b) in enumerate(zip(value[0], truth[0], value[1], truth[1])):
        if np.shape(p) != np.shape(q) or not np.allclose(p, q, rtol=0, atol=1e-9) or a != b:
            return i
    return min(len(value[0]), len(truth[0]))


def make_case(
    kind: str, problem: ProblemLike, name: str, iterations: int, rng: np.random.Generator
) -> Case:
    """Return a case with a random seed."""
    seed = int(rng.integers(1000))
    return Case(
        kind,
        {"problem": problem, "expand": EXPANSIONS[name], "iterations": iterations, "rng": seed},
    )
