"""Run a student's cells and functions in the sandbox, and read the outcomes.

If a program ends the sandbox, the remaining cells and questions are run in a new one. Nothing that
comes back is trusted. Each line is read by the shapes that the exercise declares; a line that does
not fit counts as no answer, and a line that no question needs is ignored. A request has three
parts: the cells, the cases that everybody has seen, and the hidden cases. So what a student may
read, such as an exception's message, is sent before the program has seen a hidden case.
"""

import time
from typing import Any, NamedTuple

from ...course import drawn, drivable, expansions, shapes, tasks, whole_shapes
from ...course.exercise import Case, Exercise
from ...course.judging import is_unwritten
from ...course.outcomes import Late, Misshapen, Outcome, Raised, decode_outcome
from ...course.plain import WrongShape
from ...course.shapes import Maybe, Shape, Truth
from ...errors import InvalidParameter
from ...messages import get_message
from ...support.json_fields import JsonObject
from ...support.time_limit import MAX_WAIT_FACTOR, slowdown
from ..collect.notebook import Cell
from ..sandbox.sandbox import Reply, Sandbox
from ..sandbox.talk import LONGEST

MEMORY = 2**30  # bytes, beyond those of Python and the library
FILES = 16 * 2**20
CELL_SECONDS = 10.0
GRACE = 2.0  # seconds for inside.py to report what it stopped itself
DRAWING = ("kinoedu.figures.plane", "matplotlib.pyplot")  # loaded once for all programs
BROKEN_CELLS = 3  # cells that could not be stopped, after which no new ones are run
KNOWN = {
    name
    for module in (shapes, whole_shapes, drawn, tasks, drivable, expansions)
    for name in vars(module)
}


class Question(NamedTuple):
    """An exercise and the cases to ask; everybody has seen the first `shown` of them."""

    exercise: Exercise
    cases: list[Case]
    shown: int

    @property
    def name(self) -> str:
        """The name of the function that the exercise asks for."""
        return self.exercise.name


class Answers(NamedTuple):
    """What came back from a program.

    outcomes : for each question the outcomes of its cases in order, or None if there is no such
        function.
    troubles : the outcome of each cell that failed, by its number.
    """

    outcomes: dict[str, list[Outcome] | None]
    troubles: dict[int, Outcome]


CELLS, SHOWN, HIDDEN = range(3)  # the parts of a request


def run_program(
    sandbox: Sandbox,
    cells: list[Cell],
    questions: list[Question],
    lent: tuple[str, ...] = (),
    *,
    patience: float = 1.0,
) -> Answers:
    """Run the cells and ask the questions, in as many sandboxes as it takes.

    Parameters
    ----------
    lent : the functions that the assignment uses from the exercises' modules, as "module:name".
    patience : a factor on every time limit; slow computers raise it further. Questions that are
        left when the total time is over count as late, however often the program broke off.

    Raises
    ------
    NoSandbox
        Where the sandbox does not start or breaks.
    """
    patience *= slowdown()
    found = Answers({}, {})
    cells, questions = list(cells), list(questions)
    until = time.monotonic() + LONGEST * patience
    while questions:
        if time.monotonic() > until:
            found.outcomes.update(
                {question.name: [Late(left_running=False)] for question in questions}
            )
            break
        longest = (
            max([CELL_SECONDS, *(question.exercise.seconds for question in questions)]) * patience
        )
        drawn = any(name_own_call(question.exercise) for question in questions)
        request = make_request(cells, questions, patience)
        request[CELLS]["lent"] = lent
        reply = sandbox.ask(request, MAX_WAIT_FACTOR * longest + GRACE, DRAWING if drawn else ())
        store_reply(reply, questions, found)
        if reply.end == "done":
            break
        cells, questions = find_remaining(reply, cells, questions, found)
    return found


def make_request(cells: list[Cell], questions: list[Question], patience: float) -> list[JsonObject]:
    """The request that inside.py reads, in its three parts."""
    sources = [question.exercise.source for question in questions]
    seconds = sum(CELL_SECONDS for _ in cells) + sum(
        len(q.cases) * q.exercise.seconds for q in questions
    )
    first = {
        "cells": [{**cell._asdict(), "seconds": CELL_SECONDS * patience} for cell in cells],
        "questions": [encode_question(question.exercise, patience) for question in questions],
        "withheld": [
            f"{source.__module__}:{source.__name__}" for source in sources if source is not None
        ],
        "limits": {
            "memory": MEMORY,
            "cpu": int(min(seconds, LONGEST) * patience) + 1,
            "files": FILES,
        },
    }
    return [
        first,
        *(
            {question.name: encode_cases(question, part) for question in questions}
            for part in (SHOWN, HIDDEN)
        ),
    ]


def encode_question(exercise: Exercise, patience: float) -> JsonObject:
    """A question without its cases: its name, shapes, time limit, and how it is called.

    Raises InvalidParameter where a shape is not one of kinoedu.course.
    """
    if not (is_known(exercise.given) and is_known(exercise.answer)):
        raise InvalidParameter(
            f"{exercise.name} has a shape of its own; only those of kinoedu.course are known "
            "where it is graded"
        )
    return {
        "name": exercise.name,
        "call": name_own_call(exercise),
        "given": repr(exercise.given),
        "answer": repr(exercise.answer),
        "seconds": exercise.seconds * patience,
    }


def name_own_call(exercise: Exercise) -> str:
    """Where an exercise's own `call` is defined, as "module:name"; "" where it has none."""
    call = type(exercise).call
    return "" if call is Exercise.call else f"{call.__module__}:{call.__qualname__}"


def encode_cases(question: Question, part: int) -> list[Any]:
    """The encoded cases of one part of the request."""
    cases = question.cases[: question.shown] if part == SHOWN else question.cases[question.shown :]
    return [question.exercise.given.encode(case.given) for case in cases]


def is_known(shape: Any) -> bool:
    """Whether a shape is made of shapes that all exercises share, so that its repr is complete."""
    if isinstance(shape, shapes.Record):
        parts = tuple(shape.fields.values())
    elif isinstance(shape, tuple):
        parts = shape
    else:
        parts = ()
    return type(shape).__name__ in KNOWN and all(
        is_known(part) for part in parts if hasattr(part, "encode")
    )


def store_reply(reply: Reply, questions: list[Question], found: Answers) -> None:
    """Store the outcomes of the cells and questions in a reply.

    Only lines for these questions are read, each in its part of the reply and in order.
    """
    by_name = {question.name: question for question in questions}
    for part, lines in enumerate(reply.parts):
        for line in lines:
            name = line.get("question")
            if part == CELLS:
                if type(line.get("cell")) is int and line.get("trouble") is not None:
                    found.troubles[line["cell"]] = decode_line(line["trouble"], Maybe(Truth()))
            elif isinstance(name, str) and name in by_name:
                store_outcome(line, by_name[name], part, found)
    if reply.end == "done":
        found.outcomes.update({name: found.outcomes.get(name) for name in by_name})
        for outcomes in (
            found.outcomes[question.name]
            for question in questions
            if is_open(question, found, HIDDEN)
        ):
            if outcomes is not None:  # the program ended its reply before all cases
                outcomes.append(Misshapen(get_message("grading.no_outcome")))


def store_outcome(line: JsonObject, question: Question, part: int, found: Answers) -> None:
    """Store the outcome of a case, if it is the next case and belongs to this part."""
    outcomes = found.outcomes.setdefault(question.name, [])
    if outcomes is None:
        return
    first, end = (0, question.shown) if part == SHOWN else (question.shown, len(question.cases))
    if line.get("missing") is True and not outcomes:
        found.outcomes[question.name] = None
    elif line.get("case") == len(outcomes) and first <= len(outcomes) < end:
        outcomes.append(decode_line(line.get("outcome"), question.exercise.answer))


def decode_line(data: object, shape: Shape) -> Outcome:
    """The outcome in a line; an answer of the wrong shape if the line holds none."""
    try:
        return decode_outcome(data, shape)
    except (WrongShape, TypeError, ValueError, RecursionError):
        return Misshapen(get_message("grading.no_outcome"))


def find_remaining(
    reply: Reply, cells: list[Cell], questions: list[Question], found: Answers
) -> tuple[list[Cell], list[Question]]:
    """The cells and questions to run again, after a program ended the sandbox.

    The cell or question that did so gets that outcome and is left out.
    """
    end = describe_end(reply)
    part = len(reply.parts) - 1
    if part == CELLS:
        done = {line["cell"] for line in reply.parts[CELLS] if type(line.get("cell")) is int}
        culprit = next((cell for cell in cells if cell.number not in done), None)
        if culprit is not None:
            found.troubles[culprit.number] = end
            return drop_cell(culprit, cells, done, found), questions
    at = next((question for question in questions if is_open(question, found, part)), questions[0])
    if is_open(at, found, HIDDEN):
        found.outcomes[at.name] = [*(found.outcomes.get(at.name) or []), end]
    left = [
        question
        for question in questions
        if question is not at and is_open(question, found, HIDDEN)
    ]
    for question in left:
        found.outcomes.pop(question.name, None)
    return cells, left


def drop_cell(culprit: Cell, cells: list[Cell], done: set[int], found: Answers) -> list[Cell]:
    """The cells to run again, without the one that could not be stopped.

    After BROKEN_CELLS such cells only those that finished before are run.
    """
    broken = sum(
        isinstance(trouble, Late) or is_stopped(trouble) for trouble in found.troubles.values()
    )
    return [
        cell for cell in cells if cell != culprit and (broken < BROKEN_CELLS or cell.number in done)
    ]


def is_open(question: Question, found: Answers, part: int) -> bool:
    """Whether a question has more cases to ask, up to the end of a part."""
    outcomes = found.outcomes.get(question.name, [])
    if outcomes is None or (
        outcomes and (isinstance(outcomes[-1], Late) or is_unwritten(outcomes[-1]))
    ):
        return False
    return len(outcomes) < (len(question.cases) if part == HIDDEN else question.shown)


def describe_end(reply: Reply) -> Outcome:
    """The outcome of the running cell or case when the sandbox ended."""
    if reply.end == "late":
        return Late(left_running=False)
    key = "grading.ended" if reply.status >= 0 else "grading.stopped"
    if reply.end == "flood":
        key = "grading.flood"
    return Raised([STOPPED], get_message(key, status=reply.status), [], "")


STOPPED = "Stopped"


def is_stopped(outcome: Outcome) -> bool:
    """Whether a program ended the process that ran it."""
    return isinstance(outcome, Raised) and outcome.kinds == [STOPPED]
