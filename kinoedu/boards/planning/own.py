"""A reader's own planner on a board: what it asked is recorded and drawn, its path is judged motion
by motion, and it is stopped when it hangs.
"""

import inspect
import linecache
from collections.abc import Callable, Iterable
from copy import deepcopy
from dataclasses import dataclass, field, replace
from pathlib import Path
from traceback import walk_tb
from typing import Any

import numpy as np

from ...errors import KinoeduError
from ...geometry.checks import Array, as_array
from ...planners.problem_input import world_size
from ...problems import Plan, ProblemRecord, Question, Recorder
from ...support.text import shortened
from ...support.time_limit import TimeUp, within_processor_time
from ...words import say
from ..core.drawing import Drawing, Layer, dots, edges, labels, path

SECONDS = 2.0
MOST = 20_000  # questions kept and drawn; the others are counted
MOTIONS = ("is_free_path", "is_semi_free_path")
PACKAGE = Path(__file__).resolve().parent.parent.parent


class FirstQuestions(list[Question]):
    """A recorder's log that keeps the first questions about what is free, and counts the motions
    among all.
    """

    motions = 0

    def append(self, question: Question) -> None:
        """Count and keep."""
        self.motions += question.name in MOTIONS
        if len(self) < MOST and question.name in (*MOTIONS, "is_free"):
            super().append(question)


@dataclass(frozen=True, eq=False)
class Attempt:
    """What a reader's planner did with a problem.

    path : what it returned, or None; wrong : the numbers of its motions that are not free, from 0;
        length : of a faultless path.
    fault : what is wrong, in words; still_running : it could not be stopped.
    """

    asked: list[Question]
    motions: int
    path: Array | None = None
    wrong: list[int] = field(default_factory=list)
    length: float | None = None
    fault: str = ""
    still_running: bool = False


def attempt(
    planner: Callable[..., Any], problem: ProblemRecord, seed: int, *, seconds: float = SECONDS
) -> Attempt:
    """Let a reader's planner try a problem, with a copy of it and for a bounded time."""
    recorder = Recorder(deepcopy(problem))
    recorder.log = log = FirstQuestions()

    def work() -> tuple[Any, BaseException | None]:
        try:
            return called(planner, recorder, seed), None
        except TimeUp:
            raise
        except BaseException as error:  # also SystemExit: whatever it is, it is the reader's to see
            return None, error

    try:
        answer, error = within_processor_time(seconds, work)
    except TimeUp as over:
        return Attempt(log[:], log.motions, fault=time_up(over), still_running=over.left_running)
    if error is not None:
        return Attempt(log[:], log.motions, fault=raised(error))
    return judged(answer, problem, log)


def time_up(over: TimeUp) -> str:
    """Why a planner was stopped: how long it computed, and for how long it was allowed to."""
    why = "time_up" if over.used > over.allowed else "waited"
    seconds = {"used": over.used, "allowed": over.allowed, "passed": over.passed}
    words = say(f"board.own.{why}", **{name: f"{value:.1f}" for name, value in seconds.items()})
    return f"{words} {say('board.own.left_running' if over.left_running else 'board.own.stopped')}"


def called(planner: Callable[..., Any], problem: Any, seed: int) -> Any:
    """planner(problem), or with a generator where it takes one: an argument called rng, or a second
    one that it needs.
    """
    rng = np.random.default_rng(seed)
    try:
        parameters = inspect.signature(planner).parameters
    except (TypeError, ValueError):
        return planner(problem)
    if "rng" in parameters:
        return planner(problem, rng=rng)
    places = [
        p for p in parameters.values() if p.kind in (p.POSITIONAL_ONLY, p.POSITIONAL_OR_KEYWORD)
    ]
    return (
        planner(problem, rng)
        if len(places) > 1 and places[1].default is inspect.Parameter.empty
        else planner(problem)
    )


def raised(error: BaseException) -> str:
    """An exception in words, with the reader's own line and none of ours."""
    name = type(error).__name__
    text = f"{name}: {shortened_text(error)}" if str(error) else name
    frames = [(frame.f_code.co_filename, line) for frame, line in walk_tb(error.__traceback__)]
    own = [(file, line) for file, line in frames if is_readers(file)]
    if not own:
        return say("board.own.raised", error=text)
    return say(
        "board.own.raised_in",
        error=text,
        number=own[-1][1],
        line=linecache.getline(*own[-1]).strip(),
    )


def is_readers(file: str) -> bool:
    """Whether code is a reader's: neither this package's nor a library's."""
    return (
        PACKAGE not in Path(file).parents
        and "site-packages" not in file
        and not file.startswith("<frozen")
    )


def shortened_text(error: BaseException) -> str:
    """What an exception says, in one line."""
    text = " ".join(str(error).split())
    return text if len(text) <= 200 else text[:197] + "..."


def judged(answer: Any, problem: ProblemRecord, log: FirstQuestions) -> Attempt:
    """What a planner returned, judged by the problem that it was not given."""
    tried = Attempt(log[:], log.motions)
    if isinstance(answer, Plan):
        answer = answer.path
    if answer is None:
        return tried
    d = len(problem.start)
    try:
        points = as_array(answer, "path")
    except KinoeduError:
        points = np.empty(0)
    if points.ndim != 2 or points.shape[1] != d or len(points) == 0:
        return replace(tried, fault=say("board.own.wrong_shape", d=d, given=shortened(answer)))
    wrong = [
        i for i in range(len(points) - 1) if not problem.is_free_path(points[i], points[i + 1])
    ]
    fault = wrong_end(points, problem)
    if wrong and not fault:
        fault = say(
            "board.own.wrong",
            number=wrong[0] + 1,
            a=place(points[wrong[0]]),
            b=place(points[wrong[0] + 1]),
        )
    if fault:
        return replace(tried, path=points, wrong=wrong, fault=fault)
    length = sum(problem.distance(a, b) for a, b in zip(points[:-1], points[1:], strict=True))
    return replace(tried, path=points, length=float(length))


def wrong_end(points: Array, problem: ProblemRecord) -> str:
    """What is wrong with a path's ends, or nothing."""
    near = 1e-9 * world_size(problem)
    for name, here, there in (
        ("wrong_start", points[0], problem.start),
        ("wrong_end", points[-1], problem.goal),
    ):
        if problem.distance(here, there) > near:
            return say(f"board.own.{name}", there=place(there), here=place(here))
    return ""


def place(q: Array) -> str:
    """A configuration in words."""
    return f"({', '.join(f'{x:.4g}' for x in q)})"


def race(tried: Attempt, ours: Plan) -> str:
    """How a reader's planner did beside ours."""
    return say(
        "board.own.race",
        yours=result(tried.length, tried.motions),
        ours=result(length_of(ours), ours.stats.get("checks", 0)),
    )


def length_of(plan: Plan) -> float | None:
    """A plan's length, or None."""
    return plan.cost if plan.path is not None else None


def result(length: float | None, motions: int) -> str:
    """Length and effort in words."""
    count = f"{motions:,}"
    return (
        say("board.own.no_path", motions=count)
        if length is None
        else say("board.own.length", length=f"{length:.4g}", motions=count)
    )


def drawing_of_attempt(tried: Attempt, ours: Plan | None) -> Drawing:
    """What was asked, in the order it was asked, blocked motions dashed; then the path, its wrong
    motions, and ours.
    """
    layers = questions(tried.asked)
    if ours is not None and ours.path is not None:
        layers.append(path(ours.path[:, :2], "ink", width=1.5, dash=(2, 4), casing=False))
        middle = ours.path[len(ours.path) // 2, :2]
        layers.append(labels([middle], [say("board.own.ours")], "ink")._replace(last=True))
    if tried.path is not None:
        layers.append(path(tried.path[:, :2], "path"))
        segments = np.stack([tried.path[:-1, :2], tried.path[1:, :2]], axis=1)[tried.wrong]
        layers.append(edges(segments, "contact", width=4.0, dash=(3, 6))._replace(last=True))
        layers.append(dots(segments.mean(axis=1), "contact", radius=5.0)._replace(last=True))
    text = "" if ours is None else race(tried, ours)
    return Drawing(
        layers,
        text=text,
        warning=tried.fault,
        total=len(tried.asked),
        unit=say("board.own.questions"),
    )


def questions(asked: list[Question]) -> list[Layer]:
    """Questions as layers that grow."""
    kinds: dict[tuple[bool, bool], list[tuple[int, Any]]] = {
        (motion, free): [] for motion in (True, False) for free in (True, False)
    }
    for number, question in enumerate(asked, start=1):
        points = plane_points(question.given)
        if points is not None:
            kinds[len(points) == 2, bool(question.answer)].append((number, points))
    layers = []
    for (motion, free), found in kinds.items():
        rows, when = [points for _, points in found], [number for number, _ in found]
        if motion:
            look: dict[str, Any] = (
                {"colour": "tree", "width": 1.2}
                if free
                else {"colour": "contact", "width": 1.0, "dash": (4, 4)}
            )
            layers.append(edges(rows, when=when, **look))
        else:
            layers.append(dots(rows, "tree" if free else "contact", when=when))
    return layers


def plane_points(given: Iterable[Any]) -> list[Array] | None:
    """The configurations of a question as points of the plane, or None where they are none."""
    try:
        points = [as_array(q, "q") for q in given]
    except KinoeduError:
        return None
    return (
        [q[:2] for q in points]
        if points and all(q.ndim == 1 and len(q) >= 2 for q in points)
        else None
    )
