"""The checks of a robot and of a world: what planners rely on, for random motions of one pair."""

from __future__ import annotations

import pickle
from collections.abc import Iterator
from typing import Any

import numpy as np

from ..geometry.checks import integer
from ..problems import ProblemRecord
from ..problems.configurations import space_of
from ..robots import Point
from ..support.faults import describe_exception
from ..support.text import shortened
from ..worlds import PolygonWorld, checks
from .motions import LAWS, Case, Law, answers, draw_case
from .report import Finding, Report

STAND_IN: Any = PolygonWorld(
    [(0, 0), (20, 0), (20, 20), (0, 20)],
    [[(4, 4), (8, 5), (6, 9)], [(12, 10), (16, 10), (16, 16), (12, 16)], ((14, 4), 1.5)],
)

RECORD = "It is a record that another process can read."
NO_SPACE = "it has no space: register a function for its kind with @space_of.register"
UNCHECKED = "its motions were not checked"
CORNERS = "Its corners lo and hi are two finite points (2,), lo below hi."


def check_robot(robot: Any, world: Any = None, *, motions: int = 200, seed: int = 0) -> Report:
    """Check a robot of one's own: ask about random motions, and say what it promises and breaks.

    A robot is a record (a NamedTuple) with a space, registered for
    `kinoedu.problems.configurations.space_of`, and with motions in a kind of world, registered for
    `kinoedu.collision.interface.is_free_path`.

    Parameters
    ----------
    robot : the robot.
    world : a world in which it moves; by default a room of 20 x 20 with three obstacles.
    motions : the number of random motions.
    seed : of the random motions.

    Returns
    -------
    Report
        Its repr says all in words; `passed`, `broken` and `findings` are for programs.

    Raises
    ------
    InvalidParameter
        Where `motions` or `seed` is not valid.
    InvalidWorld
        Where `world` is no world, or has moving obstacles.

    Examples
    --------
    >>> from kinoedu import Disk
    >>> check_robot(Disk(1.0)).passed
    True
    """
    place = STAND_IN if world is None else world
    checks.check_world(place)
    findings = [check_record(robot)]
    checked, notes = check_pair(robot, place, motions, seed)
    return Report(type(robot).__name__, (*findings, *checked), tuple(notes))


def check_world(world: Any, robot: Any = None, *, motions: int = 200, seed: int = 0) -> Report:
    """Check a world of one's own: ask about random motions of a robot, and say what it breaks.

    A world is a record (a NamedTuple) with the corners `lo` and `hi`, and with motions of a kind of
    robot, registered for `kinoedu.collision.interface.is_free_path`.

    Parameters
    ----------
    world : the world.
    robot : a robot that moves in it; by default Point().
    motions : the number of random motions.
    seed : of the random motions.

    Returns
    -------
    Report
        As that of `check_robot`.

    Raises
    ------
    InvalidParameter
        Where `motions` or `seed` is not valid.
    InvalidWorld
        Where the world has moving obstacles, as a MovingWorld has.

    Examples
    --------
    >>> from kinoedu import Terrain
    >>> check_world(Terrain([[1, 1, 0], [1, 0, 1], [1, 1, 1]])).passed
    True
    """
    corners = Finding("corners", CORNERS, 1, tuple(wrong_corners(world)))
    findings = [check_record(world), corners]
    if not corners.kept:
        return Report(type(world).__name__, tuple(findings), (UNCHECKED,))
    checks.check_world(world)
    checked, notes = check_pair(Point() if robot is None else robot, world, motions, seed)
    return Report(type(world).__name__, (*findings, *checked), tuple(notes))


def check_record(thing: Any) -> Finding:
    """Whether a robot or a world is a record that can be pickled."""
    where = []
    if not (isinstance(thing, tuple) and hasattr(thing, "_fields")):
        where.append(f"it is of the type {type(thing).__name__}, not a NamedTuple")
    try:
        pickle.loads(pickle.dumps(thing))
    except Exception as error:  # pickling can raise anything
        where.append(f"it cannot be pickled: {error}")
    return Finding("record", RECORD, 1, tuple(where))


def wrong_corners(world: Any) -> Iterator[str]:
    """What is wrong with the corners of a world."""
    corners = [getattr(world, name, None) for name in ("lo", "hi")]
    wrong = [
        f"{name} is {shortened(corner)}"
        for name, corner in zip(("lo", "hi"), corners)
        if not is_corner(corner)
    ]
    yield from wrong
    if not wrong and not (np.asarray(corners[0]) < np.asarray(corners[1])).all():
        yield f"lo is {shortened(corners[0])}, hi {shortened(corners[1])}"


def is_corner(corner: Any) -> bool:
    """Whether a value is a point as an array of two finite numbers."""
    if not isinstance(corner, np.ndarray) or corner.dtype != np.float64:
        return False
    return corner.shape == (2,) and bool(np.isfinite(corner).all())


def check_pair(robot: Any, world: Any, motions: int, seed: int) -> tuple[list[Finding], list[str]]:
    """Check the motions of a robot in a world."""
    number = integer(motions, "motions", least=1)
    rng = np.random.default_rng(integer(seed, "seed", least=0))
    if space_of.dispatch(type(robot)) is space_of.dispatch(object):
        return [Finding("space", LAWS["space"][0], 1, (NO_SPACE,))], [UNCHECKED]
    try:
        space = space_of(robot, world)
        problem = ProblemRecord(robot, world, space, space.lo, space.lo, 0.0, np.zeros(2, np.int64))
        cases = [draw_case(problem, rng) for _ in range(number)]
    except Exception as error:  # a reader's own functions can raise anything
        where = (describe_exception(error, "it"),)
        return [Finding("space", LAWS["space"][0], 1, where)], [UNCHECKED]
    answered = [case for case in cases if is_answered(case)]
    findings = [
        Finding(name, promise, *try_law(law, cases if name == "answers" else answered))
        for name, (promise, law) in LAWS.items()
    ]
    free = sum(is_free_or_not(case) for case in answered)
    notes = [f"{free} of {number} random motions were free"]
    if len(answered) < number:
        notes.append(f"{number - len(answered)} motions without an answer were not checked further")
    elif free in (0, number):
        notes.append("so the others were not tried: give a world with more or fewer obstacles")
    return findings, notes


def is_answered(case: Case) -> bool:
    """Whether the questions about a motion have answers."""
    try:
        answers(case)
    except Exception:  # a reader's own functions can raise anything
        return False
    return True


def is_free_or_not(case: Case) -> bool:
    """Whether a motion is free; False where the question fails."""
    try:
        return bool(case.problem.is_free_path(case.a, case.b))
    except Exception:
        return False


def try_law(law: Law, cases: list[Case]) -> tuple[int, tuple[str, ...]]:
    """In how many cases a law was tried, and where it was broken."""
    tried, where = 0, []
    for case in cases:
        try:
            text = law(case)
        except Exception as error:  # a reader's own functions can raise anything
            text = describe_exception(error, "it")
        tried += text is not None
        if text:
            where.append(f"{case}: {text}")
    return tried, tuple(where)
