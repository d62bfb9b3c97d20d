"""A reader's own planner: call it, make a Plan of what it returns, and find what is wrong with it.

A planner is `f(problem)` or `f(problem, rng)`; it returns a path, a Plan or None. Boards,
experiments, the command line and `check_planner` all use these functions.
"""

import inspect
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from ..errors import InvalidPoint, KinoeduError
from ..geometry.checks import Array, as_array
from ..messages import get_message
from ..problems import Plan, ProblemRecord
from ..problems.protocols import ProblemLike
from ..support.text import shortened
from .answers import path_cost
from .driving.common import is_near
from .driving.parameters import GoalRegion, as_goal_region
from .problem_input import world_size

PACKAGE = __name__.partition(".")[0]
NO_PATH = "the planner returned None"
ROUNDING = 1e-9  # of the world's size: how far a path's end may be from the goal


class Faults(NamedTuple):
    """What is wrong with a plan's path.

    Attributes
    ----------
    ends : that it begins or ends elsewhere, in words; "" where it does not.
    motion : the first motion that is not free, or that touches an obstacle, in words; or "".
    wrong : the indices of the motions that enter an obstacle or leave the world, from 0.
    touching : the indices of those that only touch an obstacle.
    """

    ends: str = ""
    motion: str = ""
    wrong: tuple[int, ...] = ()
    touching: tuple[int, ...] = ()

    @property
    def text(self) -> str:
        """The first fault in words; "" where there is none."""
        return self.ends or self.motion

    @property
    def is_wrong(self) -> bool:
        """Whether it is more than a contact."""
        return bool(self.ends or self.wrong)


def is_own(planner: Callable[..., object]) -> bool:
    """Whether a planner is a reader's own, and not one of this package.

    Examples
    --------
    >>> from kinoedu import rrt
    >>> is_own(rrt), is_own(sorted)
    (False, True)
    """
    function = getattr(planner, "func", planner)
    return str(getattr(function, "__module__", "")).partition(".")[0] != PACKAGE


def name_of(planner: Callable[..., object]) -> str:
    """The name of a planner, for messages."""
    function = getattr(planner, "func", planner)
    return str(getattr(function, "__name__", type(function).__name__))


def rng_argument(planner: Callable[..., object]) -> str:
    """How a planner takes a generator: "keyword", "second" for a second argument, or "".

    Examples
    --------
    >>> rng_argument(lambda problem, rng: None), rng_argument(lambda p, r: None)
    ('keyword', 'second')
    >>> rng_argument(lambda problem, k=3: None)
    ''
    """
    try:
        parameters = inspect.signature(planner).parameters
    except (TypeError, ValueError):
        return ""
    positional = (inspect.Parameter.POSITIONAL_ONLY, inspect.Parameter.POSITIONAL_OR_KEYWORD)
    places = [p for p in parameters.values() if p.kind in positional]
    if "rng" in parameters and parameters["rng"].kind is not inspect.Parameter.POSITIONAL_ONLY:
        return "keyword"
    has_second = len(places) > 1 and places[1].default is inspect.Parameter.empty
    return "second" if has_second else ""


def call_planner(planner: Callable[..., object], problem: ProblemLike, seed: int | None) -> Any:
    """Call planner(problem), with a generator where it takes one.

    A generator is passed to an argument called rng, or as a required second argument.
    """
    how, rng = rng_argument(planner), np.random.default_rng(seed)
    if how == "keyword":
        return planner(problem, rng=rng)
    return planner(problem, rng) if how == "second" else planner(problem)


def as_plan(answer: Any, problem: ProblemRecord) -> Plan:
    """The Plan of what a planner returned: a path (n, d), a Plan or None.

    The cost is that of its path in the problem, whatever the planner says; that of a drive is its
    own.

    Raises
    ------
    InvalidPoint
        Where the answer is none of these.

    Examples
    --------
    >>> from kinoedu import Point, Problem, Terrain
    >>> problem = Problem(Point(), Terrain([[1] * 9] * 9), (1, 1), (8, 1))
    >>> as_plan([(1, 1), (8, 1)], problem).cost
    7.0
    """
    plan = answer if isinstance(answer, Plan) else Plan(answer, np.inf, reason=NO_PATH)
    if plan.path is None:
        return replace(plan, problem=problem, cost=np.inf)
    try:
        points = np.array(as_array(plan.path, "path"))
    except KinoeduError:
        points = np.empty(0)
    if points.ndim != 2 or points.shape[1:] != problem.start.shape or len(points) == 0:
        raise InvalidPoint(
            get_message(
                "board.own.wrong_shape", d=len(problem.start), given=shortened(given_path(answer))
            )
        )
    cost = plan.cost if plan.trajectory is not None else path_cost(problem, points)
    reason = "" if plan is not answer else plan.reason
    return replace(plan, path=points, cost=float(cost), problem=problem, reason=reason)


def given_path(answer: object) -> object:
    """The path of an answer, as it was returned."""
    return answer.path if isinstance(answer, Plan) else answer


def find_faults(plan: Plan, problem: ProblemRecord) -> Faults:
    """What is wrong with a plan's path; the problem must be one that the planner did not have.

    Every motion is checked, also between the points. A path of drives is checked along its drives,
    and must end in the default goal region.
    """
    if plan.path is None:
        return Faults()
    if plan.trajectory is not None:
        return find_faults_of_drives(plan, problem)
    points = plan.path
    motions = list(zip(points[:-1], points[1:], strict=True))
    blocked = [i for i, (a, b) in enumerate(motions) if not problem.is_free_path(a, b)]
    touching = [i for i in blocked if only_touches(problem, *motions[i])]
    wrong = [i for i in blocked if i not in touching]
    kind, first = ("wrong", wrong) if wrong else ("touching", touching)
    motion = describe_motion(kind, points, first[0]) if first else ""
    return Faults(check_ends(points, problem), motion, tuple(wrong), tuple(touching))


def only_touches(problem: ProblemRecord, a: Array, b: Array) -> bool:
    """Whether a motion that is not free touches obstacles and enters none."""
    try:
        return bool(problem.is_semi_free_path(a, b))
    except TypeError:  # this robot has no sliding motions in this world
        return False


def find_faults_of_drives(plan: Plan, problem: ProblemRecord) -> Faults:
    """What is wrong with a plan that a car drives."""
    drive: Any = plan.trajectory
    poses = drive.poses
    wrong = [
        i
        for i, ((v, phi), t) in enumerate(zip(drive.controls, drive.durations, strict=True))
        if not problem.is_free_drive(poses[i], v, phi, t)
    ]
    ends = check_ends(poses[:1], problem, ("start",))
    if not ends and not is_near(poses[-1], problem.goal, as_goal_region(problem, GoalRegion())):
        ends = describe_end("goal", poses[-1], problem.goal)
    return Faults(ends, describe_motion("wrong", poses, wrong[0]) if wrong else "", tuple(wrong))


def check_ends(
    points: Array, problem: ProblemRecord, ends: Sequence[str] = ("start", "goal")
) -> str:
    """What is wrong with a path's ends, or ""."""
    near = ROUNDING * world_size(problem)
    for name in ends:
        here = points[0] if name == "start" else points[-1]
        there = getattr(problem, name)
        if not problem.distance(here, there) <= near:
            return describe_end(name, here, there)
    return ""


def describe_end(name: str, here: Array, there: Array) -> str:
    """That a path does not begin at the start, or does not end at the goal."""
    key = "board.own.wrong_start" if name == "start" else "board.own.wrong_end"
    return get_message(key, there=format_configuration(there), here=format_configuration(here))


def describe_motion(kind: str, points: Array, i: int) -> str:
    """That a motion of a path is not free, or touches an obstacle."""
    a, b = (format_configuration(q) for q in points[i : i + 2])
    return get_message(f"board.own.{kind}", number=i + 1, a=a, b=b)


def format_configuration(q: Array) -> str:
    """A configuration in words."""
    return f"({', '.join(f'{x:.4g}' for x in q)})"
