"""What planners rely on, as laws of single motions: each says what is wrong with one, in words."""

from __future__ import annotations

import pickle
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from ..geometry.checks import Array
from ..problems import ProblemRecord
from ..support.text import shortened

ROUNDING = 1e-9  # of a distance
BETWEEN = 8  # configurations that are looked at on each motion


class Case(NamedTuple):
    """A motion from a to b of a problem, whose start and goal mean nothing."""

    problem: ProblemRecord
    a: Array
    b: Array

    def __str__(self) -> str:
        a, b = (", ".join(f"{x:.4g}" for x in q) for q in (self.a, self.b))
        return f"from ({a}) to ({b})"


Law = Callable[[Case], str | None]  # what is wrong, "" where nothing is, None where it says nothing


def draw_case(problem: ProblemRecord, rng: np.random.Generator) -> Case:
    """A random motion; half of them are short, so that more of them are free."""
    a, b = problem.sample(rng), problem.sample(rng)
    short = rng.random() < 0.5
    return Case(problem, a, problem.steer(a, b, 0.1 * problem.distance(a, b)) if short else b)


def in_space(case: Case) -> str:
    """Samples lie between lo and hi."""
    space, q = case.problem.space, case.a
    is_inside = q.shape == space.lo.shape and ((q >= space.lo) & (q <= space.hi)).all()
    return "" if is_inside else f"between {space.lo} and {space.hi} it draws {q}"


def is_distance(case: Case) -> str:
    """The laws of a distance, with the middle of the two as a third point."""
    problem, a, b = case
    far, self_far = problem.distance(a, b), problem.distance(a, a)
    middle = problem.steer(b, a, 0.3 * far)
    way = problem.distance(a, middle) + problem.distance(middle, b)
    if self_far != 0.0 or not 0.0 <= far < np.inf:
        return f"the distance is {far:.4g}, and to itself {self_far:.4g}"
    return f"{far:.6g} is longer than by a third point, {way:.6g}" if far > way * (1 + 1e-6) else ""


def goes_both_ways(case: Case) -> str | None:
    """The way back is as long, and free where the way there is."""
    problem, a, b = case
    if not getattr(problem.space, "both_ways", True):
        return None
    there, back = problem.distance(a, b), problem.distance(b, a)
    if abs(there - back) > ROUNDING * max(there, back):
        return f"the distance is {there:.6g}, back it is {back:.6g}"
    free = problem.is_free_path(a, b), problem.is_free_path(b, a)
    return (
        "" if free[0] == free[1] else f"it is {describe(free[0])}, back it is {describe(free[1])}"
    )


def steers(case: Case) -> str:
    """Steering ends after the given distance, or at b."""
    problem, a, b = case
    far = problem.distance(a, b)
    for step in (0.25 * far, 0.75 * far):
        gone = problem.distance(a, problem.steer(a, b, step))
        if abs(gone - step) > 1e-6 * far:
            return f"told to go {step:.6g}, it goes {gone:.6g}"
    end = problem.steer(a, b, 2.0 * far)
    return "" if np.array_equal(end, b) else f"told to go twice as far as b, it ends at {end}"


def answers(case: Case) -> str:
    """True or False."""
    problem, a, b = case
    for answer in (problem.is_free_path(a, b), problem.is_free(a), problem.is_free(b)):
        if not isinstance(answer, bool | np.bool_):
            return f"the answer is {shortened(answer)}"
    return ""


def answers_again(case: Case) -> str:
    """The same answer three times."""
    free = {bool(case.problem.is_free_path(case.a, case.b)) for _ in range(3)}
    return "" if len(free) == 1 else "once it is free, once it is not"


def changes_nothing(case: Case) -> str:
    """All bytes are the same afterwards."""
    problem, a, b = case

    def all_bytes() -> bytes:
        return pickle.dumps((problem.robot, problem.world, a.tobytes(), b.tobytes()))

    before = all_bytes()
    problem.is_free_path(a, b)
    problem.is_free(a)
    problem.distance(a, b)
    problem.steer(a, b, 1.0)
    return "" if all_bytes() == before else "something is different afterwards"


def stands(case: Case) -> str:
    """is_free is the motion from a configuration to itself."""
    free = case.problem.is_free(case.a), case.problem.is_free_path(case.a, case.a)
    if bool(free[0]) == bool(free[1]):
        return ""
    return f"where it begins it is {describe(free[0])}, the motion to itself {describe(free[1])}"


def free_between(case: Case) -> str | None:
    """Nothing on a free motion is in an obstacle."""
    problem, a, b = case
    if not problem.is_free_path(a, b):
        return None
    far = problem.distance(a, b)
    for k in range(BETWEEN + 1):
        q = problem.steer(a, b, k / BETWEEN * far)
        if not problem.is_free(q):
            return f"it is free, but not at {q.round(4)}, {k}/{BETWEEN} of the way"
    return ""


def free_in_halves(case: Case) -> str | None:
    """Two free halves are a free motion."""
    problem, a, b = case
    middle = problem.steer(a, b, 0.5 * problem.distance(a, b))
    if not (problem.is_free_path(a, middle) and problem.is_free_path(middle, b)):
        return None
    return "" if problem.is_free_path(a, b) else "both halves are free, and it is not"


def keeps_clearance(case: Case) -> str | None:
    """What is free with a clearance is free with less, and some need less."""
    problem, a, b = case
    size = float(np.max(problem.world.hi - problem.world.lo))
    free = [
        bool(problem._replace(clearance=c * size).is_free_path(a, b)) for c in (0.0, 0.02, 0.1, 2.0)
    ]
    if not free[0]:
        return None
    if free[-1]:
        return "it is free with a clearance of twice the world's size"
    return (
        ""
        if free == sorted(free, reverse=True)
        else "it is free with more clearance, not with less"
    )


def allows_contact(case: Case) -> str | None:
    """Free is semi-free; a robot need not have motions in contact."""
    problem, a, b = case
    if not problem.is_free_path(a, b):
        return None
    try:
        if problem.is_semi_free_path(a, b):
            return ""
    except TypeError:
        return None
    return "it is free, but not where contact is allowed"


def blocked_outside(case: Case) -> str | None:
    """Positions outside the world; a robot whose first coordinate is an angle has none."""
    problem, a, _ = case
    wraps = getattr(problem.space, "wraps", np.zeros(2, bool))
    if len(a) < 2 or wraps[:2].any():
        return None
    size = problem.world.hi - problem.world.lo
    for sign in (-2.0, 2.0):
        q = a.copy()
        q[:2] += sign * size
        if problem.is_free(q) or problem.is_free_path(a, q):
            return f"{q.round(4)} is outside, and free"
    return ""


def costs(case: Case) -> str:
    """A cost is at least the length."""
    problem, a, b = case
    cost, far = problem.motion_cost(a, b), problem.distance(a, b)
    return "" if cost >= far * (1.0 - ROUNDING) else f"it costs {cost:.6g} and is {far:.6g} long"


def describe(free: object) -> str:
    """Free or not, in words."""
    return "free" if free else "not free"


LAWS: dict[str, tuple[str, Law]] = {
    "space": (
        "Its samples lie in the box of its space.",
        in_space,
    ),
    "distance": (
        "Distances are positive, and no way round is shorter.",
        is_distance,
    ),
    "both_ways": ("The distance and the motion back are those there.", goes_both_ways),
    "steer": ("On the way from a to b it steers as far as it is told, from a up to b.", steers),
    "answers": ("Every question about a motion has the answer True or False.", answers),
    "same": ("The same question has the same answer.", answers_again),
    "unchanged": (
        "No question changes the robot, the world or a configuration.",
        changes_nothing,
    ),
    "standing": ("A configuration is free where the motion from it to itself is.", stands),
    "between": ("On a free motion every configuration is free.", free_between),
    "halves": ("A motion is free where both of its halves are.", free_in_halves),
    "clearance": ("What keeps a clearance is free without it.", keeps_clearance),
    "contact": ("A free motion is free where contact is allowed.", allows_contact),
    "outside": ("Nothing is free outside the world.", blocked_outside),
    "cost": ("The cost of a motion is a number, at least its length.", costs),
}
