"""Run a student's cells and functions in the sandbox, and read the outcomes.

A program runs twice: on the cases that everybody has seen, and in a new sandbox on the hidden ones.
A student may read what the first run says, such as an exception's message. Of the second one only
the judgement remains. Where a program ends its sandbox, what it did so in is not run again; the
remaining cells and questions are run in a new one. Hidden cases come in a random order, so where a
program takes too long for one of them, those of other kinds are asked in a further run.
"""

import ast
import builtins
import time
from collections.abc import Iterator
from typing import NamedTuple

from ...course.drawn import Drawn
from ...course.exercise import Case, Exercise
from ...course.judging import ends_a_run
from ...course.outcomes import Late, Misshapen, Outcome, Raised, decode_outcome
from ...course.plain import WrongShape
from ...course.shapes import Maybe, Shape, Truth
from ...course.tasks import ProblemShape, problem_of
from ...messages import get_message
from ...support.json_fields import JsonObject
from ...support.text import split_lines
from ...support.time_limit import slowdown
from ..collect.notebook import Cell
from ..sandbox.cells import DEFINITIONS, parse_cell
from ..sandbox.sandbox import Reply, Sandbox
from ..sandbox.talk import LONGEST

MEMORY = 2**30  # bytes, beyond those of Python and numpy
FILES = 16 * 2**20
CELL_SECONDS = 10.0
GRACE = 10.0  # seconds for runner.py to report what it stopped itself
MOST_TIMES = 15.0  # times the limit of a call, for the call and for all its questions
# what programs that draw or plan need, loaded once for all of them
DRAWING = (
    "matplotlib.pyplot",
    "matplotlib.backends.backend_agg",
    "kinoedu.course.axes_contents",
)
PLANNING = ("kinoedu.course.lent_problem",)
# lent, it makes problems; those of `drivable` would answer heading_distance
MAKER = f":{problem_of.__name__}"
BROKEN_CELLS = 3  # cells that could not be stopped, after which no new ones are run
HIDDEN_RUNS = 4  # runs on hidden cases: each but the last may break off in another kind
NO_VALUE = Maybe(Truth())
# of what was running, or not yet begun, when the time of the whole notebook was over
USED_UP = Late(False, passed=LONGEST)
DEFINES = (*DEFINITIONS, ast.Import, ast.ImportFrom)


class Question(NamedTuple):
    """An exercise and the cases to ask; everybody has seen the first `shown` of them."""

    exercise: Exercise
    cases: list[Case]
    shown: int

    @property
    def name(self) -> str:
        """The name of the function that the exercise asks for."""
        return self.exercise.name


class Trouble(NamedTuple):
    """What failed in a cell, and its line there."""

    outcome: Outcome
    line: int


class Answers(NamedTuple):
    """What came back from a program.

    outcomes : for each question the outcomes of its cases in order, or None if there is no such
        function.
    troubles : what failed in each cell, by its number.
    cases : the cases of each question in the order of the outcomes; those that were not asked are
        last.
    """

    outcomes: dict[str, list[Outcome] | None]
    troubles: dict[int, list[Trouble]]
    cases: dict[str, list[Case]]

    def stopped(self) -> set[int]:
        """The numbers of the cells that could not be stopped."""
        return {
            number for number, troubles in self.troubles.items() if any(map(ends_a_cell, troubles))
        }


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
    lent : what the assignment lends of the library, as "module:name".
    patience : a factor on every time limit; slow computers raise it further. Questions that are
        left when the total time is over count as late, however often the program broke off.

    Raises
    ------
    NoSandbox
        Where the sandbox does not start or breaks.
    """
    patience *= slowdown()
    empty = Answers({}, {}, {one.name: one.cases for one in questions})
    run = Run(sandbox, lent, patience, time.monotonic() + LONGEST * patience, empty)
    shown = [Question(one.exercise, one.cases[: one.shown], one.shown) for one in questions]
    run.ask_apart(cells, shown)
    hidden = [
        Question(one.exercise, one.cases[one.shown :], 0)
        for one in questions
        if is_open(one, run.found.outcomes.get(one.name, []))
    ]
    run.ask_hidden(list(leave_out_stopped(cells, run.found)), hidden)
    return run.found


def leave_out_stopped(cells: list[Cell], found: Answers) -> Iterator[Cell]:
    """Yield the cells as the first run had them.

    Of a cell that took too long what is above that statement; of one that ended the process, where
    the statement is not known, its definitions.
    """
    for cell in cells:
        stopped = [one for one in found.troubles.get(cell.number, []) if ends_a_cell(one)]
        if not stopped:
            yield cell
        elif stopped[0].line:
            above = split_lines(cell.source)[: stopped[0].line - 1]
            yield cell._replace(source="".join(above))
        else:
            yield keep_definitions(cell)


def keep_definitions(cell: Cell) -> Cell:
    """The imports, functions and classes of a cell, in their lines.

    >>> keep_definitions(Cell(1, "import os\\nos.abort()\\ndef f():\\n    pass")).source
    'import os\\n\\ndef f():\\n    pass'
    """
    lines = split_lines(cell.source)
    kept = ["\n"] * len(lines)
    for part in parse_cell(cell.source, ""):
        if isinstance(part, DEFINES):
            first = min([part, *getattr(part, "decorator_list", [])], key=lambda one: one.lineno)
            inside = slice(first.lineno - 1, part.end_lineno)
            kept[inside] = lines[inside]
    return cell._replace(source="".join(kept))


class Run(NamedTuple):
    """One run of a program: on the shown cases, or on the hidden ones.

    until : the time at which it must have ended.
    """

    sandbox: Sandbox
    lent: tuple[str, ...]
    patience: float
    until: float
    found: Answers

    def ask_hidden(self, cells: list[Cell], questions: list[Question]) -> None:
        """Ask hidden cases. Where a program breaks off, ask those of other kinds in a new run."""
        asked = {one.name: list[tuple[Case, Outcome]]() for one in questions}
        left = questions
        for _ in range(HIDDEN_RUNS):
            later = self._replace(found=Answers({}, {}, {}))
            later.ask_apart(cells, left)
            for one in left:
                outcomes = map(forget_words, later.found.outcomes.get(one.name) or [])
                asked[one.name] += zip(one.cases, outcomes, strict=False)
            left = [rest for one in left if (rest := leave_kind(one, asked[one.name])).cases]
            if not left:
                break
        for one in questions:
            store_hidden(one, asked[one.name], self.found)

    def ask_apart(self, cells: list[Cell], questions: list[Question]) -> None:
        """Ask the questions, those that need other modules each in sandboxes of their own.

        So matplotlib, which can do much of what is asked for, is there only where it is to draw.
        """
        needed = {one.name: list_modules([one], self.lent) for one in questions}
        for modules in sorted(set(needed.values())):
            self.ask(cells, [one for one in questions if needed[one.name] == modules])

    def ask(self, cells: list[Cell], questions: list[Question]) -> None:
        """Run the cells and ask the questions, and store what is found."""
        while questions:
            if self.is_over():
                self.found.outcomes.update({one.name: [USED_UP] for one in questions})
                return
            longest = max([CELL_SECONDS, *(one.exercise.seconds for one in questions)])
            reply = self.sandbox.ask(
                make_request(cells, questions, self.lent, self.patience),
                MOST_TIMES * longest * self.patience + GRACE,
                list_modules(questions, self.lent),
            )
            store_reply(reply, questions, self.found)
            if reply.end == "done":
                return
            end = USED_UP if self.is_over() else describe_end(reply)
            cells, questions = find_remaining(reply, end, cells, questions, self.found)

    def is_over(self) -> bool:
        """Whether the time of the whole notebook is over."""
        return time.monotonic() > self.until


def make_request(
    cells: list[Cell], questions: list[Question], lent: tuple[str, ...], patience: float
) -> list[JsonObject]:
    """The request that runner.py reads, in its two parts."""
    seconds = sum(CELL_SECONDS for _ in cells) + sum(
        len(one.cases) * one.exercise.seconds for one in questions
    )
    first = {
        "cells": [{**cell._asdict(), "seconds": CELL_SECONDS} for cell in cells],
        "questions": [{"name": one.name, "variant": one.exercise.variant} for one in questions],
        "lent": lent,
        "drawing": DRAWING[0] in list_modules(questions, lent),
        "patience": patience,
        "limits": {
            "memory": MEMORY,
            "cpu": int(min(seconds, LONGEST) * patience) + 1,
            "files": FILES,
        },
    }
    given = {
        one.name: [one.exercise.given.encode(case.given) for case in one.cases] for one in questions
    }
    return [first, given]


def list_modules(questions: list[Question], lent: tuple[str, ...]) -> tuple[str, ...]:
    """The modules that the student's process needs for some questions, and for what is lent."""
    draws = any(isinstance(one.exercise.answer, Drawn) for one in questions)
    plans = any(place.endswith(MAKER) for place in lent) or any(
        isinstance(shape, ProblemShape)
        for one in questions
        for shape in one.exercise.given.fields.values()
    )
    return DRAWING * draws + PLANNING * plans


def store_reply(reply: Reply, questions: list[Question], found: Answers) -> None:
    """Store the outcomes of the cells and questions in a reply."""
    by_name = {question.name: question for question in questions}
    for line in (line for lines in reply.parts for line in lines):
        if "cell" in line:
            now = [
                Trouble(decode_line(one["outcome"], NO_VALUE), one["line"])
                for one in line["troubles"]
            ]
            # of a cell whose definitions are run again, what ended it stays
            before = filter(ends_a_cell, found.troubles.get(line["cell"], []))
            found.troubles[line["cell"]] = now if any(map(ends_a_cell, now)) else [*before, *now]
        elif line.get("missing"):
            found.outcomes[line["question"]] = None
        elif "question" in line:
            question = by_name[line["question"]]
            outcome = decode_line(line["outcome"], question.exercise.answer)
            found.outcomes.setdefault(question.name, []).append(outcome)  # type: ignore[union-attr]


def decode_line(data: object, shape: Shape) -> Outcome:
    """The outcome in a line; an answer of the wrong shape if the line holds none."""
    try:
        return decode_outcome(data, shape)
    except (WrongShape, TypeError, ValueError, RecursionError):
        return Misshapen(get_message("grading.no_outcome"))


def find_remaining(
    reply: Reply, end: Outcome, cells: list[Cell], questions: list[Question], found: Answers
) -> tuple[list[Cell], list[Question]]:
    """The cells and questions to run again, after a program ended the sandbox.

    The cell or question that did so gets the outcome `end` and is not run again.
    """
    if len(reply.parts) == 1:  # it ended while the cells were run
        done = {line["cell"] for line in reply.parts[0] if "cell" in line}
        culprit = next((cell for cell in cells if cell.number not in done), None)
        if culprit is not None:
            found.troubles[culprit.number] = [Trouble(end, 0)]
            return drop_cell(culprit, cells, done, found), questions
    left = [one for one in questions if is_open(one, found.outcomes.get(one.name, []))]
    if left:
        found.outcomes.setdefault(left[0].name, []).append(end)  # type: ignore[union-attr]
    return cells, left[1:]


def drop_cell(culprit: Cell, cells: list[Cell], done: set[int], found: Answers) -> list[Cell]:
    """The cells to run again, of the one that could not be stopped only the definitions.

    If that is all it had, it is left out. After BROKEN_CELLS such cells only those that finished
    before are run.
    """
    is_broken = len(found.stopped()) >= BROKEN_CELLS
    again = [keep_definitions(cell) if cell == culprit else cell for cell in cells]
    return [
        cell
        for cell in again
        if cell != culprit and (not is_broken or cell.number in {*done, culprit.number})
    ]


def is_open(question: Question, outcomes: list[Outcome] | None) -> bool:
    """Whether a question has more cases to ask."""
    if outcomes is None:
        return False
    if outcomes and (ends_a_run(outcomes[-1]) or is_stopped(outcomes[-1])):
        return False
    return len(outcomes) < len(question.cases)


def leave_kind(question: Question, asked: list[tuple[Case, Outcome]]) -> Question:
    """The cases that were not asked, without those of the kind of the last one that was."""
    known = {id(case) for case, _ in asked}
    left = [case for case in question.cases if id(case) not in known]
    last = {case.kind for case, _ in asked[-1:]}
    return question._replace(cases=[case for case in left if last and case.kind not in last])


def store_hidden(question: Question, asked: list[tuple[Case, Outcome]], found: Answers) -> None:
    """Store the outcomes of hidden cases, last those that came too late: they end the judging."""
    before = found.outcomes.setdefault(question.name, [])
    if before is None:
        return
    ordered = sorted(asked, key=lambda one: ends_a_run(one[1]))
    cases, known = found.cases[question.name], {id(case) for case, _ in asked}
    shown = cases[: len(before)]
    rest = [case for case in cases[len(before) :] if id(case) not in known]
    found.cases[question.name] = [*shown, *(case for case, _ in ordered), *rest]
    before += [outcome for _, outcome in ordered]


def describe_end(reply: Reply) -> Outcome:
    """The outcome of the running cell or case when the sandbox ended."""
    if reply.end == "late":
        return Late(left_running=False)
    key = "grading.ended" if reply.status >= 0 else "grading.stopped"
    if reply.end in ("flood", "unasked"):
        key = f"grading.{reply.end}"
    return Raised([STOPPED], get_message(key, status=reply.status), [], "")


def is_used_up(outcome: Outcome) -> bool:
    """Whether the time of the whole notebook was over."""
    return isinstance(outcome, Late) and outcome == USED_UP


STOPPED = "Stopped"


def ends_a_cell(trouble: Trouble) -> bool:
    """Whether a cell could not be stopped, or ended the process that ran it."""
    return isinstance(trouble.outcome, Late) or is_stopped(trouble.outcome)


def is_stopped(outcome: Outcome) -> bool:
    """Whether a program ended the process that ran it."""
    return isinstance(outcome, Raised) and outcome.kinds == [STOPPED]


def forget_words(outcome: Outcome) -> Outcome:
    """An outcome without the text in which a program could reveal a hidden case.

    Answers remain, since they are judged. Exceptions keep the names of Python's own classes.
    """
    if isinstance(outcome, Raised) and not is_stopped(outcome):
        known = [kind for kind in outcome.kinds if hasattr(builtins, kind)]
        return Raised(known, "", [], "")
    if isinstance(outcome, Misshapen):
        return Misshapen(get_message("grading.misshapen"))
    return Late(left_running=False) if isinstance(outcome, Late) else outcome
