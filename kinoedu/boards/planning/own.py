"""A reader's own planner on a board: its questions are recorded and drawn, its path is judged.

It is stopped when it takes too long.
"""

from collections.abc import Callable
from contextlib import nullcontext
from copy import deepcopy
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from ...errors import InvalidPoint
from ...geometry.checks import Array
from ...messages import get_message
from ...planners.own import as_plan, call_planner, find_faults
from ...problems import Plan, ProblemRecord, Question, Recorder
from ...support.faults import describe_exception, describe_timeout
from ...support.time_limit import TimeUp, run_within_processor_time
from ..core.drawing import Drawing, Layer, dots, edges, labels, path
from ..tracing.code_run import CodeRun
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


def judge_answer(answer: Any, problem: ProblemRecord, log: FirstQuestions) -> Attempt:
    """A planner's answer, judged by the original problem, which the planner did not have."""
    tried = Attempt(log[:], log.motions)
    try:
        plan = as_plan(answer, problem)
    except InvalidPoint as error:
        return replace(tried, fault=str(error))
    faults = find_faults(plan, problem)
    if faults.text:
        wrong = sorted(faults.wrong + faults.touching)
        return replace(tried, path=plan.path, wrong=wrong, fault=faults.text)
    return replace(tried, path=plan.path, length=length_of(plan))


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
