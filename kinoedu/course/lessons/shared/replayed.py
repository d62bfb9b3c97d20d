"""Judges of planners whose samples are known: was each sample used, once, as it was drawn?

A student's problem records what `problem.sample` drew, and from which generator. With these samples
an RRT or RRT-Connect can be repeated, node by node, on the tree that the student returned.
"""

from typing import NamedTuple

import numpy as np

from ....geometry.checks import Array
from ....problems import Tree
from ...tasks import StudentProblem
from .planned import Fault, Run, find_node_off_nearest, measure_distances, same_configuration

FEW = 5  # from so many samples on, chance must have been used besides them
SIGMAS = 5.5  # a right program is refused less than once in a million runs


class Regrown:
    """A tree that is grown again: its nodes count one by one, in the order in which they came."""

    def __init__(self, problem: StudentProblem, tree: Tree, step: float) -> None:
        self.problem, self.step = problem, step
        self.nodes, self.parent = tree

    def measure_from(self, size: int, q: Array) -> Array:
        """Distances from the first nodes to a configuration."""
        return measure_distances(self.problem, self.nodes[:size], q)

    def leads_on(self, size: int, q: Array) -> bool:
        """Whether the next node is one step from the nearest of the first nodes towards q."""
        if size == len(self.nodes):
            return False
        p, new = self.parent[size], self.nodes[size]
        if not same_configuration(
            self.problem, new, self.problem.problem.steer(self.nodes[p], q, self.step)
        ):
            return False
        apart = self.measure_from(size, q)
        return bool(apart[p] <= apart.min() * (1.0 + 1e-9) + 1e-12)

    def find_free_step(self, size: int, q: Array) -> Array | None:
        """Step from the nearest of the first nodes towards q, both ends of it, if it is free."""
        near = self.nodes[int(self.measure_from(size, q).argmin())]
        new = self.problem.problem.steer(near, q, self.step)
        return np.array([near, new]) if self.problem.problem.is_free_path(near, new) else None

    def edge_to(self, size: int) -> Array:
        """The edge to the next node."""
        return self.nodes[[self.parent[size], size]]


class Explained(NamedTuple):
    """How far samples explain the nodes of a tree.

    Attributes
    ----------
    fault : what cannot be explained, or None.
    aimed, chosen : of the iterations in which the sample would have added a node, if it was drawn
        in each: their number, and in how many of them the goal was taken instead.
    """

    fault: Fault | None
    aimed: int = 0
    chosen: int = 0


def explain_rrt(tree: Regrown, samples: Array, drawn_always: bool, ended: bool) -> Explained:
    """Explain the nodes of an RRT by samples, and by the goal as a sample.

    Iterations in which the goal was the sample and that added nothing leave no trace, so a state is
    the number of samples used and of nodes explained; all states that are possible are visited.

    Parameters
    ----------
    drawn_always : whether a sample was drawn in every iteration, also where the goal was taken.
    ended : whether the search ended before all iterations were made, so that samples may be left.
    """
    goal, todo, seen = tree.problem.goal, [(0, 1, 0, 0)], set[tuple[int, int]]()
    last, fault = (-1, -1), Fault("samples", tree.nodes[:0])
    while todo:
        used, size, aimed, chosen = todo.pop()
        # the last sample may be drawn after the last iteration
        if size == len(tree.nodes) and (ended or used >= len(samples) - 1):
            return Explained(None, aimed, chosen)
        if (used, size) in seen:
            continue
        seen.add((used, size))
        if used + drawn_always <= len(samples) and tree.leads_on(size, goal):
            todo.append((used + drawn_always, size + 1, aimed + drawn_always, chosen + 1))
        if used == len(samples):
            motion = tree.edge_to(size)
        elif tree.leads_on(size, samples[used]):
            motion = None
            todo.append((used + 1, size + 1, aimed + 1, chosen))
        else:
            motion = tree.find_free_step(size, samples[used])
            if motion is None:
                todo.append((used + 1, size, aimed, chosen))
            elif drawn_always and tree.find_free_step(size, goal) is None:
                todo.append((used + 1, size, aimed + 1, chosen + 1))
        if motion is not None and (size, used) > last:
            last, fault = (size, used), Fault("samples", motion)
    return Explained(fault)


def find_rrt_fault(
    tree: Regrown, run: Run, goal_bias: float, iterations: int, ended: bool
) -> Fault | None:
    """What is wrong with the samples of an RRT, or None: each is used once, unchanged, in order.

    The goal must be the sample by chance, with the probability `goal_bias`; this is tested where
    all iterations were made.
    """
    nowhere = tree.nodes[:0]
    if run.generators > 1:
        return Fault("generator", nowhere)
    number = len(run.samples)
    found = explain_rrt(tree, run.samples, False, ended)
    always = found.fault is not None and (ended or number >= iterations)
    if always:
        found = explain_rrt(tree, run.samples, True, ended)
    if found.fault is not None:
        return find_node_off_nearest(tree.problem, tree.nodes, tree.parent) or found.fault
    if 0.0 < goal_bias < 1.0 and number >= FEW and not run.others:
        return Fault("coin", nowhere)
    if goal_bias == 0.0 and not ended and not iterations <= number <= iterations + 1:
        return Fault("all_made", nowhere)  # one sample more may be drawn after the last iteration
    tried, chosen = (found.aimed, found.chosen) if always else (iterations, iterations - number)
    spread = SIGMAS * np.sqrt(tried * goal_bias * (1.0 - goal_bias)) + 1.0
    if not ended and abs(chosen - tried * goal_bias) > spread:
        return Fault("share", nowhere)
    return None


def find_connect_fault(
    trees: tuple[Regrown, Regrown], run: Run, iterations: int, ended: bool
) -> Fault | None:
    """What is wrong with the samples, turns or runs of RRT-Connect, or None.

    Either tree may take the first turn.
    """
    nowhere = trees[0].nodes[:0]
    if run.generators > 1:
        return Fault("generator", nowhere)
    tries = [repeat_connect(trees, run.samples, first) for first in (0, 1)]
    if all(fault is not None for _, fault in tries):
        off = [find_node_off_nearest(tree.problem, tree.nodes, tree.parent) for tree in trees]
        return off[0] or off[1] or max(tries, key=lambda one: one[0])[1]
    return None if ended or len(run.samples) == iterations else Fault("turns_made", nowhere)


def repeat_connect(
    trees: tuple[Regrown, Regrown], samples: Array, first: int
) -> tuple[int, Fault | None]:
    """Repeat RRT-Connect.

    Returns
    -------
    The number of nodes that are explained, and what is wrong with the next one, or None.
    """
    sizes = [1, 1]
    for turn, q in enumerate(samples):
        here, there = (turn + first) % 2, (turn + first + 1) % 2
        if not trees[here].leads_on(sizes[here], q):
            if trees[there].leads_on(sizes[there], q):
                return sum(sizes), Fault("turns", trees[there].edge_to(sizes[there]))
            motion = trees[here].find_free_step(sizes[here], q)
            if motion is not None:
                return sum(sizes), Fault("samples", motion)
            continue
        q_new = trees[here].nodes[sizes[here]]
        sizes[here] += 1
        met = False
        while trees[there].leads_on(sizes[there], q_new):  # once more, where it is rounding away
            q = trees[there].nodes[sizes[there]]
            sizes[there] += 1
            met = same_configuration(trees[0].problem, q, q_new)
        if met:
            return find_rest(trees, sizes, "met")  # samples may be left: drawn in advance
        motion = trees[there].find_free_step(sizes[there], q_new)
        if motion is not None:
            return sum(sizes), Fault("greedy", motion)
    return find_rest(trees, sizes, "samples")


def find_rest(
    trees: tuple[Regrown, Regrown], sizes: list[int], rule: str
) -> tuple[int, Fault | None]:
    """Number of explained nodes, and the fault of a node that comes after them, or None."""
    for tree, size in zip(trees, sizes):
        if size < len(tree.nodes):
            return sum(sizes), Fault(rule, tree.edge_to(size))
    return sum(sizes), None
