"""A reader's own planner on a board: its questions are recorded and drawn, its path is judged.

It is stopped when it takes too long.
"""

import inspect
from collections.abc import Callable
from contextlib import nullcontext
from copy import deepcopy
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from ...errors import KinoeduError
from ...geometry.checks import Array, as_array
from ...messages import get_message
from ...planners.problem_input import world_size
from ...problems import Plan, ProblemRecord, Question, Recorder
from ...problems.protocols import ProblemLike
from ...support.text import shortened
from ...support.time_limit import TimeUp, run_within_processor_time
from ..core.drawing import Drawing, Layer, dots, edges, labels, path
from ..tracing.code_run import CodeRun
from ..tracing.faults import describe_exception, describe_timeout
from ..tracing.questions import FirstQuestions, draw_questions

SECONDS = 2.0


@dataclass(frozen=True, eq=False)
class Attempt:
    """The result of a reader's planner on a problem.

    Attributes
    ----------
    questions : the questions kept.
    motions : the number of motions checked.
    path : the path that it returned, or None.
    wrong : the indices of the path's motions that are not free, from 0.
    length : the length of a correct path.
    fault : what is wrong, in words.
    still_running : whether it could not be stopped.
    """

    questions: list[Question]
    motions: int
    path: Array | None = None
    wrong: list[int] = field(default_factory=list)
    length: float | None = None
    fault: str = ""
    still_running: bool = False


def try_planner(
    planner: Callable[..., object],
    problem: ProblemRecord,
    seed: int,
    *,
    seconds: float = SECONDS,
    run: CodeRun | None = None,
) -> Attempt:
    """Run a reader's planner on a copy of a problem, for a bounded time.

    Its lines are traced where a `run` is given.
    """
    recorder = Recorder(deepcopy(problem))
    recorder.log = log = FirstQuestions() if run is None else run.log

    def work() -> tuple[Any, BaseException | None]:
        try:
            with nullcontext() if run is None else run.trace:
                return call_planner(planner, recorder, seed), None
        except TimeUp:
            raise
        except BaseException as error:  # SystemExit too: the reader should see every exception
            return None, error

    try:
        answer, error = run_within_processor_time(seconds, work)
    except TimeUp as over:
        return Attempt(
            log[:],
            log.motions,
            fault=describe_timeout(over, get_message("board.own.who")),
            still_running=over.left_running,
        )
    if error is not None:
        return Attempt(
            log[:], log.motions, fault=describe_exception(error, get_message("board.own.who"))
        )
    return judge_answer(answer, problem, log)


def call_planner(planner: Callable[..., object], problem: ProblemLike, seed: int) -> Any:
    """Call planner(problem), with a generator where it takes one.

    A generator is passed to an argument called rng, or as a required second argument.
    """
    rng = np.random.default_rng(seed)
    try:
        parameters = inspect.signature(planner).parameters
    except (TypeError, ValueError):
        return planner(problem)
    if "rng" in parameters:
        return planner(problem, rng=rng)
    positional = (inspect.Parameter.POSITIONAL_ONLY, inspect.Parameter.POSITIONAL_OR_KEYWORD)
    places = [p for p in parameters.values() if p.kind in positional]
    if len(places) > 1 and places[1].default is inspect.Parameter.empty:
        return planner(problem, rng)
    return planner(problem)


def judge_answer(answer: Any, problem: ProblemRecord, log: FirstQuestions) -> Attempt:
    """A planner's answer, judged by the original problem, which the planner did not have."""
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
        return replace(
            tried, fault=get_message("board.own.wrong_shape", d=d, given=shortened(answer))
        )
    motions = zip(points[:-1], points[1:], strict=True)
    wrong = [i for i, (a, b) in enumerate(motions) if not problem.is_free_path(a, b)]
    fault = check_ends(points, problem)
    if wrong and not fault:
        a, b = (format_configuration(q) for q in points[wrong[0] : wrong[0] + 2])
        fault = get_message("board.own.wrong", number=wrong[0] + 1, a=a, b=b)
    if fault:
        return replace(tried, path=points, wrong=wrong, fault=fault)
    length = sum(problem.distance(a, b) for a, b in zip(points[:-1], points[1:], strict=True))
    return replace(tried, path=points, length=float(length))


def check_ends(points: Array, problem: ProblemRecord) -> str:
    """What is wrong with a path's ends, or ""."""
    near = 1e-9 * world_size(problem)
    ends = ("wrong_start", points[0], problem.start), ("wrong_end", points[-1], problem.goal)
    for name, here, there in ends:
        if problem.distance(here, there) > near:
            return get_message(
                f"board.own.{name}",
                there=format_configuration(there),
                here=format_configuration(here),
            )
    return ""


def format_configuration(q: Array) -> str:
    """A configuration in words."""
    return f"({', '.join(f'{x:.4g}' for x in q)})"


def describe_race(tried: Attempt, ours: Plan) -> str:
    """The result of a reader's planner beside ours, in words."""
    return get_message(
        "board.own.race",
        yours=describe_result(tried.length, tried.motions),
        ours=describe_result(length_of(ours), ours.stats.get("checks", 0)),
    )


def length_of(plan: Plan) -> float | None:
    """A plan's length, or None."""
    return plan.cost if plan.path is not None else None


def describe_result(length: float | None, motions: int) -> str:
    """Length and effort in words."""
    count = f"{motions:,}"
    if length is None:
        return get_message("board.own.no_path", motions=count)
    return get_message("board.own.length", length=f"{length:.4g}", motions=count)


def draw_attempt(tried: Attempt, ours: Plan | None, run: CodeRun | None = None) -> Drawing:
    """Draw the questions in order, the path with its wrong motions, and our path.

    Blocked motions are dashed. With a `run`, the steps are its lines, which are shown too.
    """
    text = "" if ours is None else describe_race(tried, ours)
    if run is not None:
        drawing = run.draw(fault=tried.fault)
        layers = [*drawing.layers, *draw_paths(tried, ours)]
        return replace(drawing, layers=layers, text=text or drawing.text)
    layers = [*draw_questions(tried.questions), *draw_paths(tried, ours)]
    total, unit = len(tried.questions), get_message("board.own.questions")
    return Drawing(layers, text=text, warning=tried.fault, total=total, unit=unit)


def draw_paths(tried: Attempt, ours: Plan | None) -> list[Layer]:
    """The reader's path with its wrong motions, and ours."""
    layers = list[Layer]()
    if ours is not None and ours.path is not None:
        layers.append(path(ours.path[:, :2], "ink", width=1.5, dash=(2, 4), casing=False))
        middle = ours.path[len(ours.path) // 2, :2]
        layers.append(labels([middle], [get_message("board.own.ours")], "ink")._replace(last=True))
    if tried.path is not None:
        layers.append(path(tried.path[:, :2], "path"))
        segments = np.stack([tried.path[:-1, :2], tried.path[1:, :2]], axis=1)[tried.wrong]
        layers.append(edges(segments, "contact", width=4.0, dash=(3, 6))._replace(last=True))
        layers.append(dots(segments.mean(axis=1), "contact", radius=5.0)._replace(last=True))
    return layers
