"""The judge of the attempts of an RRT on a terrain: samples, nearest nodes and failures.

The problem that a student's planner gets logs each sample and each steer. So the target of an
attempt is known, and the node from which it was made.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ....geometry.checks import Array
from ...exercise import Given
from ...shapes import Numbers
from ...tasks import StudentProblem
from ...watching import SAMPLE, STEER
from ..shared.planned import Fault

LOG = Numbers(("calls", 6))  # kind, generator, then two places: the sample twice, or from and to
SAME, FEW, SURE = 1e-7, 5, 5.0  # SURE: standard deviations of a share that chance does not explain
NOWHERE = np.empty((0, 2))


class Attempts(NamedTuple):
    """What a planner drew and from where it steered; `used` tells which samples were targets."""

    samples: Array
    used: NDArray[np.bool_]
    towards_goal: int
    number: int
    in_a_row: int
    nodes: int


def find_attempt_fault(given: Given, nodes: Array, path: Array | None, log: Array) -> Fault | None:
    """Return the first rule that the attempts break, or None.

    A program may steer by code of its own, leave out an attempt that cannot succeed, or steer to
    test whether the goal is within a step: then less is known of it, and less is judged. Which
    steers are such tests is not known, so a program is right where it is so with or without them.
    """
    problem, bias = given["problem"], given["goal_bias"]
    if log[:, 1].any():
        return Fault("generator", NOWHERE)
    samples = log[log[:, 0] == SAMPLE, 2:4]
    if bias < 1.0 and len(samples) >= FEW and is_without_coins(problem, given["rng"], samples):
        return Fault("coin", NOWHERE)
    grown = nodes[: len(nodes) - (path is not None)]
    if not (log[:, 0] == STEER).any():
        return None
    fault = judge_attempts(given, path, replay(given, grown, log))
    if fault is not None and (tests := find_tests(given, grown, log)).any():
        return judge_samples(given, replay(given, grown, log[~tests]))
    return fault


def is_without_coins(problem: StudentProblem, rng: int, samples: Array) -> bool:
    """Whether nothing but these samples was drawn from the generator of this seed."""
    chance = np.random.default_rng(rng)
    return all(np.array_equal(problem.problem.sample(chance), q) for q in samples)


def find_tests(given: Given, nodes: Array, log: Array) -> NDArray[np.bool_]:
    """Which calls may be steers that only test whether the goal is within a step.

    Where every new node was steered to the goal, all steers to the goal may be, but those that
    added a node: the last steer to it before it was tested itself. Elsewhere only the steers that
    arrive at the goal may be.
    """
    problem, goal, begins = given["problem"].problem, given["problem"].goal, log[:, 2:4]
    to_goal = (log[:, 0] == STEER) & is_at(log[:, 4:6], goal)
    tested = [np.flatnonzero(to_goal & is_at(begins, q)) for q in nodes[1:]]
    if not all(map(len, tested)):
        return to_goal & (np.linalg.norm(begins - goal, axis=1) <= given["step"] + SAME)
    ends, tests = np.array([problem.steer(q, goal, given["step"]) for q in begins]), to_goal.copy()
    for q, (first, *_) in zip(nodes[1:], tested):
        arrivals = np.flatnonzero(to_goal[:first] & is_at(ends[:first], q))
        tests[arrivals[-1:]] = False
    return tests


def is_at(places: Array, q: Array) -> NDArray[np.bool_]:
    """Which places are q."""
    return np.abs(places - q).max(axis=1) <= SAME


def replay(given: Given, nodes: Array, log: Array) -> Fault | Attempts:
    """Repeat all attempts, and return the first fault, or what was done."""
    problem, used = given["problem"].problem, np.zeros(len(log), bool)
    known, in_a_row, number, towards_goal = 1, 0, 0, 0
    for row in np.flatnonzero(log[:, 0] == STEER):
        begin, target = log[row, 2:4], log[row, 4:6]
        drawn = np.flatnonzero(np.abs(log[:row, 2:4] - target).max(axis=1) <= SAME)
        drawn = drawn[(log[drawn, 0] == SAMPLE) & ~used[drawn]]
        at_goal = np.abs(target - problem.goal).max() <= SAME
        if not len(drawn) and not at_goal:
            return Fault("target", np.array([target]))
        used[drawn[-1:]] = True
        off = np.linalg.norm(nodes[:known] - target, axis=1)
        if np.linalg.norm(begin - target) > off.min() + SAME:
            return Fault("from_nearest", np.array([nodes[off.argmin()], begin]))
        q = problem.steer(begin, target, given["step"])
        apart = np.linalg.norm(nodes[:known] - q, axis=1).min() - given["spacing"]
        in_a_row, number, towards_goal = in_a_row + 1, number + 1, towards_goal + at_goal
        if known < len(nodes) and np.abs(nodes[known] - q).max() <= SAME:
            known, in_a_row = known + 1, 0
        elif apart > SAME and problem.is_free_path(begin, q):
            return Fault("left_out", np.array([begin, q]))
        if in_a_row > given["failures"]:
            return Fault("went_on", NOWHERE)
    is_sample = log[:, 0] == SAMPLE
    return Attempts(log[is_sample, 2:4], used[is_sample], towards_goal, number, in_a_row, known)


def judge_attempts(given: Given, path: Array | None, done: Fault | Attempts) -> Fault | None:
    """Judge the samples that were not used, the number of failures, and the share of the goal."""
    fault, bias = judge_samples(given, done), given["goal_bias"]
    if isinstance(done, Fault) or fault is not None or not done.used.all():
        return fault
    if path is None and done.in_a_row < given["failures"]:
        return Fault("gave_up", NOWHERE)
    spread = np.sqrt(done.number * bias * (1.0 - bias))
    return (
        Fault("share", NOWHERE)
        if abs(done.towards_goal - bias * done.number) > SURE * spread + 1.0
        else None
    )


def judge_samples(given: Given, done: Fault | Attempts) -> Fault | None:
    """Return the fault that ended the replay, or whether those that are not free were left out."""
    if isinstance(done, Fault):
        return done
    free = np.array([given["problem"].problem.is_free(q) for q in done.samples], bool)
    unused = ~done.used
    is_left_out = unused.sum() >= FEW and not free[unused].any() and free[done.used].all()
    return Fault("unfree", done.samples[unused][:1]) if is_left_out else None
