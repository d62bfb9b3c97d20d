"""Rules that join nodes, and the answers of programs that misunderstand them."""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ....geometry.checks import Array
from .halls import is_arm, measure_distances

Pairs = NDArray[np.int64]
SAMPLES = 50  # points of a motion that a mistaken program checks


def keep_free(problem: Any, nodes: Array, pairs: Pairs) -> Pairs:
    """Return the pairs whose motion is free, (m, 2)."""
    return pairs[[bool(problem.is_free_path(nodes[i], nodes[j])) for i, j in pairs]].reshape(-1, 2)


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


def find_closest(
    problem: Any,
    nodes: Array,
    k: int,
    *,
    farthest: bool = False,
    only_free: bool = False,
    only_later: bool = False,
) -> Pairs:
    """Return rows (i, j) where j is one of the k closest nodes of i.

    Ties go to the lower index.

    Parameters
    ----------
    farthest : take the k farthest nodes instead.
    only_free : leave out nodes whose motion is not free before taking k.
    only_later : leave out nodes j < i before taking k.
    """
    apart, rows = measure_distances(problem, nodes), []
    for i in range(len(nodes)):
        order = np.argsort(-apart[i] if farthest else apart[i], kind="stable").tolist()
        others = [j for j in order if j != i and (j > i or not only_later)]
        if only_free:
            others = [j for j in others if problem.is_free_path(nodes[i], nodes[j])]
        rows += [(i, j) for j in others[: max(k, 0)]]
    return np.array(rows, np.int64).reshape(-1, 2)


def join_components(
    problem: Any,
    nodes: Array,
    k: int,
    *,
    blind: bool = False,
    goes_on: bool = False,
    one: bool = False,
) -> Pairs:
    """Join each node to every component of the nodes before it.

    It is joined by the first free motion to one of the component's k closest nodes.

    Parameters
    ----------
    blind : do not check motions.
    goes_on : join all free ones of the k.
    one : join only the first component that can be joined.
    """
    apart, part, pairs = measure_distances(problem, nodes), list(range(len(nodes))), []
    for i in range(1, len(nodes)):
        order = np.argsort(apart[i, :i], kind="stable").tolist()
        joined: list[int] = []
        for component in dict.fromkeys(part[j] for j in order):
            closest = [j for j in order if part[j] == component][:k]
            free = [j for j in closest if blind or problem.is_free_path(nodes[j], nodes[i])]
            joined += free if goes_on else free[:1]
            if one and joined:
                break
        pairs += [(j, i) for j in joined]
        merged = {part[j] for j in joined}
        part = [i if name in merged else name for name in part]
    return np.array(pairs, np.int64).reshape(-1, 2)


class MistakenProblem(NamedTuple):
    """A problem seen by a program that uses a wrong distance or a wrong collision check."""

    distance: Callable[[Array, Array], float]
    is_free_path: Callable[[Array, Array], bool]


def ignore_wrap(problem: Any) -> Any:
    """Return the arm's problem with angles that do not wrap; other problems unchanged."""
    return (
        MistakenProblem(lambda a, b: float(np.hypot(*(a - b))), problem.is_free_path)
        if is_arm(problem)
        else problem
    )


def allow_contact(problem: Any) -> MistakenProblem:
    """Return a problem in which motions may touch obstacles."""
    return MistakenProblem(problem.distance, problem.is_semi_free_path)


def check_samples(problem: Any) -> MistakenProblem:
    """Return a problem in which only sampled points of a motion are checked."""
    is_free = problem.problem.is_free
    shares = np.linspace(0.0, 1.0, SAMPLES)
    return MistakenProblem(
        problem.distance, lambda a, b: all(is_free(a + share * (b - a)) for share in shares)
    )
