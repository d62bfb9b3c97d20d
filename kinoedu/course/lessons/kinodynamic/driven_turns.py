"""The judge of the turns of a planner that drives: targets, nodes and random numbers.

The problem that a student's planner gets logs each random pose and each best drive. So the target
of every turn is known, the node from which it drove, and what `best_drive` returned.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ....geometry.checks import Array
from ....robots.trajectory import DrivenTree
from ...drivable import DrivingProblem
from ...poses import distance_of_poses
from ...shapes import Numbers
from ...watching import DRIVE, NEAR_GOAL, SAMPLE
from .driven_trees import GOAL_EVERY, NOWHERE, REGION_EVERY, TurnFault, find_near_goal

LOG = Numbers(("calls", 11))  # kind, generator, then q, target and drive: three numbers each
SAME = 1e-6  # poses and controls that differ by less are the same
MISSED = {SAMPLE: "chance", NEAR_GOAL: "region"}  # the rule that a wrong target breaks


class Turns(NamedTuple):
    """What a planner was asked for, and what it did.

    Attributes
    ----------
    tree : its nodes, replayed, with parents, controls and durations.
    log : its calls, as `read_drives` returns them.
    k : number of drives in each turn.
    stops : whether the search ends at the goal.
    """

    problem: DrivingProblem
    tree: DrivenTree
    log: Array
    iterations: int
    k: int
    stops: bool

    def away(self, poses: Array, q: Array) -> Array:
        """Distances from poses, shape (n, 3), to q."""
        return np.asarray(distance_of_poses(poses.T, q, self.problem.radian))


def find_turn_fault(run: Turns) -> TurnFault | None:
    """Return the fault of the first turn that breaks a rule, or None."""
    calls = np.flatnonzero(run.log[:, 0] == DRIVE)
    if not len(calls) and len(run.tree.nodes) > 1:
        return TurnFault("unasked", NOWHERE, 0)
    used = np.zeros(len(run.log), bool)
    known, done, last = 1, 0, int(calls[0]) if len(calls) else 0
    arrived = find_near_goal(run.problem, run.tree.nodes, SAME)
    for turn in range(1, run.iterations + 1):
        if run.stops and known == len(run.tree.nodes) and known - 1 in arrived:
            break
        group = calls[done : done + min(run.k, known)]
        if len(group) < min(run.k, known):
            rule = "stopped" if run.stops else "onward"
            return TurnFault(rule, run.tree.nodes[-1:], turn)
        fault = (
            find_target_fault(run, turn, group, used, last)
            or find_node_fault(run, turn, group, known)
            or find_new_node_fault(run, turn, group, known)
        )
        if fault is not None:
            return fault
        known += int(np.isfinite(run.log[group, -1]).sum())
        done, last = done + len(group), int(group[-1])
    if done < len(calls):
        return TurnFault("iterations", NOWHERE, 0)
    return (
        TurnFault("unasked", run.tree.nodes[known : known + 1], 0)
        if known < len(run.tree.nodes)
        else None
    )


def find_target_fault(
    run: Turns, turn: int, group: NDArray[np.int64], used: NDArray[np.bool_], last: int
) -> TurnFault | None:
    """Return a fault of the target of a turn or of its random numbers, or None.

    A pose is a target once. It may be drawn long before its turn, but then one for each turn.

    Parameters
    ----------
    group : indices in the log of this turn's drives.
    used : for each call, whether it has drawn the target of a turn; this turn's is added.
    last : index in the log of the last drive before this turn.
    """
    log, target = run.log, run.log[group[0], 5:8]
    marked = log[group[:1], 2:5]
    if log[: group[-1] + 1, 1].any():
        return TurnFault("generator", marked, turn)
    kinds = [kind for kind, every in ((NEAR_GOAL, REGION_EVERY),) if turn % every == 0]
    if turn % GOAL_EVERY and not kinds:
        kinds = [SAMPLE]
    rule = MISSED[kinds[0]] if kinds else "bias"
    if (run.away(log[group, 5:8], target) > SAME).any():
        again = turn > 1 and run.away(target[None], log[last, 5:8])[0] <= SAME
        return TurnFault("once" if again else "each", marked, turn)
    if turn % GOAL_EVERY == 0 and run.away(target[None], run.problem.goal)[0] <= SAME:
        return None
    for kind in kinds:
        drawn = np.flatnonzero((log[: group[0], 0] == kind) & ~used[: group[0]])
        fits = drawn[run.away(log[drawn, 2:5], target) <= SAME]
        if len(fits):
            used[fits[-1]] = True
            again = last and (log[last : group[0], 0] == kind).sum() > 1
            return TurnFault("redrawn", marked, turn) if again else None
    if turn > 1 and run.away(target[None], log[last, 5:8])[0] <= SAME:
        rule = "once"
    return TurnFault(rule, marked, turn)


def find_node_fault(
    run: Turns, turn: int, group: NDArray[np.int64], known: int
) -> TurnFault | None:
    """Return a fault where a turn does not drive from the nodes nearest to its target, or None."""
    nodes, target = run.tree.nodes, run.log[group[0], 5:8]
    begins = run.log[group, 2:5]
    for q in begins:
        if run.away(nodes[:known], q).min() > SAME:
            later = run.away(nodes, q).min() <= SAME
            return TurnFault("group" if later else "elsewhere", q[None], turn)
    chosen, off = run.away(begins, target), run.away(nodes[:known], target)
    if np.abs(np.sort(chosen) - np.sort(off)[: len(chosen)]).max() > SAME:
        for i, q in enumerate(begins):
            if (run.away(begins[:i], q) <= SAME).any():
                return TurnFault("twice", q[None], turn)
        nearest, worst = nodes[off.argmin()], begins[chosen.argmax()]
        return TurnFault("nearest", np.array([target, nearest, worst]), turn)
    return None


def find_new_node_fault(
    run: Turns, turn: int, group: NDArray[np.int64], known: int
) -> TurnFault | None:
    """Return a fault where the drives of a turn are not those that lead to its new nodes, or None.

    The new nodes of one turn may be in any order.
    """
    found = run.log[group][np.isfinite(run.log[group, -1])]
    new = slice(known, known + len(found))
    if len(run.tree.nodes[new]) < len(found):
        return TurnFault("dropped", found[-1:, 2:5], turn)
    added = np.column_stack([run.tree.controls[new], run.tree.durations[new]])
    order, other = np.lexsort(found[:, 8:].T), np.lexsort(added.T)
    if np.abs(found[order, 8:] - added[other]).max(initial=0.0) > SAME:
        return TurnFault("dropped", found[-1:, 2:5], turn)
    begins = run.tree.nodes[run.tree.parent[new][other]]
    for q, begin in zip(found[order, 2:5], begins):
        if run.away(q[None], begin)[0] > SAME:
            return TurnFault("dropped", q[None], turn)
    return None
