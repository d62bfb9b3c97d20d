"""Rules that join nodes, and the answers of programs that misunderstand them."""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ....geometry.checks import Array
from ....problems.protocols import PlanningProblem, ProblemLike
from ...tasks import StudentProblem
from .halls import is_arm, measure_distances

Pairs = NDArray[np.int64]
SAMPLES = 50  # points of a motion that a mistaken program checks


def keep_free(problem: ProblemLike, nodes: Array, pairs: Pairs) -> Pairs:
    """Return the pairs whose motion is free, (m, 2)."""
    return pairs[[bool(problem.is_free_path(nodes[i], nodes[j])) for i, j in pairs]].reshape(-1, 2)


def keep_semi_free(problem: Any, nodes: Array, pairs: Pairs) -> Pairs:
    """Return the pairs whose motion is free or touches obstacles, (m, 2)."""
    return pairs[[bool(problem.is_semi_free_path(nodes[i], nodes[j])) for i, j in pairs]].reshape(
        -1, 2
    )


def remove_duplicates(rows: Pairs) -> Pairs:
    """Return each pair once, with the smaller index first."""
    return np.unique(np.sort(rows, axis=1), axis=0).reshape(-1, 2)


def are_pairs(pairs: Pairs, n: int) -> bool:
    """Whether the rows are distinct pairs (i, j) of indices below n with i < j."""
    return bool(
        ((pairs >= 0) & (pairs < n)).all()
        and (pairs[:, 0] < pairs[:, 1]).all()
        and len(remove_duplicates(pairs)) == len(pairs)
    )


def renumber_pairs(pairs: Pairs, numbers: Pairs) -> Pairs:
    """Return pairs of renumbered nodes: node i becomes numbers[i].

    Rows whose smaller index was first have it first again, and the others have it last. A row
    without a node of a number stays as it is.
    """
    found = np.reshape(pairs, (-1, 2)).astype(np.int64)
    valid = ((found >= 0) & (found < len(numbers))).all(axis=1)
    ordered = found[:, 0] < found[:, 1]
    found[valid] = np.sort(numbers[found[valid]], axis=1)
    found[valid & ~ordered] = found[valid & ~ordered, ::-1]
    return found


def order_others(apart: Array) -> list[list[int]]:
    """Return for each node the other nodes by their distance; ties go to the lower index."""
    orders = np.argsort(apart, axis=1, kind="stable").tolist()
    return [[j for j in order if j != i] for i, order in enumerate(orders)]


def take_first(orders: list[list[int]], k: int) -> Pairs:
    """Return rows (i, j) where j is one of the first k nodes in the order of i."""
    rows = [(i, j) for i, order in enumerate(orders) for j in order[: max(k, 0)]]
    return np.array(rows, np.int64).reshape(-1, 2)


def find_closest(problem: Any, nodes: Array, k: int) -> Pairs:
    """Return rows (i, j) where j is one of the k closest nodes of i."""
    return take_first(order_others(measure_distances(problem, nodes)), k)


def find_farthest(problem: Any, nodes: Array, k: int) -> Pairs:
    """Return rows (i, j) where j is one of the k farthest nodes of i."""
    return take_first(order_others(-measure_distances(problem, nodes)), k)


def find_closest_free(problem: Any, nodes: Array, k: int) -> Pairs:
    """Return rows (i, j) where j is one of the k closest nodes of i with a free motion."""
    orders = order_others(measure_distances(problem, nodes))
    free = [
        [j for j in order if problem.is_free_path(nodes[i], nodes[j])]
        for i, order in enumerate(orders)
    ]
    return take_first(free, k)


def find_closest_later(problem: Any, nodes: Array, k: int) -> Pairs:
    """Return rows (i, j) where j is one of the k closest nodes of i among those after i."""
    orders = order_others(measure_distances(problem, nodes))
    return take_first([[j for j in order if j > i] for i, order in enumerate(orders)], k)


# for a node i and lists of nodes, one for each component: the nodes to which i is joined
Choose = Callable[[Any, Array, int, list[list[int]]], list[int]]


def join_every_component(
    problem: Any, nodes: Array, i: int, components: list[list[int]]
) -> list[int]:
    """Return the first node of each component with a free motion: the right rule."""
    free = [
        [j for j in closest if problem.is_free_path(nodes[j], nodes[i])] for closest in components
    ]
    return [j for some in free for j in some[:1]]


def join_unchecked(problem: Any, nodes: Array, i: int, components: list[list[int]]) -> list[int]:
    """Return the first node of each component, without a check of the motion."""
    return [j for closest in components for j in closest[:1]]


def join_all_free(problem: Any, nodes: Array, i: int, components: list[list[int]]) -> list[int]:
    """Return all nodes of all components with a free motion."""
    return [
        j for closest in components for j in closest if problem.is_free_path(nodes[j], nodes[i])
    ]


def join_one_component(
    problem: Any, nodes: Array, i: int, components: list[list[int]]
) -> list[int]:
    """Return a node of the first component that can be joined."""
    return join_every_component(problem, nodes, i, components)[:1]


def join_components(
    problem: Any, nodes: Array, k: int, choose: Choose = join_every_component
) -> Pairs:
    """Join each node to the components of the nodes before it.

    Of each component, `choose` is given the k nodes closest to the new one, closest first.
    """
    apart, part, pairs = measure_distances(problem, nodes), list(range(len(nodes))), []
    for i in range(1, len(nodes)):
        order = np.argsort(apart[i, :i], kind="stable").tolist()
        components = [
            [j for j in order if part[j] == component][:k]
            for component in dict.fromkeys(part[j] for j in order)
        ]
        joined = choose(problem, nodes, i, components)
        pairs += [(j, i) for j in joined]
        merged = {part[j] for j in joined}
        part = [i if name in merged else name for name in part]
    return np.array(pairs, np.int64).reshape(-1, 2)


class MistakenProblem(NamedTuple):
    """A problem seen by a program that uses a wrong distance or a wrong collision check."""

    distance: Callable[[Array, Array], float]
    is_free_path: Callable[[Array, Array], bool]


def ignore_wrap(problem: PlanningProblem) -> Any:
    """Return the arm's problem with angles that do not wrap; other problems unchanged."""
    return (
        MistakenProblem(lambda a, b: float(np.hypot(*(a - b))), problem.is_free_path)
        if is_arm(problem)
        else problem
    )


def allow_contact(problem: StudentProblem) -> MistakenProblem:
    """Return a problem in which motions may touch obstacles."""
    return MistakenProblem(problem.distance, problem.is_semi_free_path)


def check_samples(problem: StudentProblem) -> MistakenProblem:
    """Return a problem in which only sampled points of a motion are checked."""
    is_free = problem.problem.is_free
    shares = np.linspace(0.0, 1.0, SAMPLES)
    return MistakenProblem(
        problem.distance, lambda a, b: all(is_free(a + share * (b - a)) for share in shares)
    )
