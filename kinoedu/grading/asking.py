"""From a student's cells to the outcomes of their functions: ask the sandbox, and where a program broke off, again for the rest.

What comes back is a stranger's word. Each line is read by the shapes that the exercise declares; a line that does not fit counts as
no answer, and one that was not asked for as nothing at all.
"""

from typing import Any, NamedTuple

from ..course import drawn, shapes, whole_shapes
from ..course.exercise import Case, Exercise
from ..course.outcomes import Late, Misshapen, Outcome, Raised, decode_outcome
from ..course.plain import WrongShape
from ..course.shapes import Maybe, Shape, Truth
from ..words import say
from .sandbox import GRACE, Reply, Sandbox

MEMORY = 2**30  # bytes beyond what Python and the library take
FILES = 16 * 2**20
CELL_SECONDS = 10.0
BROKEN_CELLS = 3  # after so many cells that could not even be stopped the others are not run
KNOWN = {name for module in (shapes, whole_shapes, drawn) for name in vars(module)}


class Cell(NamedTuple):
    """A cell of code: its number in the notebook, from 1, and its source."""

    number: int
    source: str


class Question(NamedTuple):
    """An exercise and the cases to ask."""

    exercise: Exercise
    cases: list[Case]


class Answers(NamedTuple):
    """What came of each question, its outcomes in the order of its cases, or None where there is no such function; and of each cell
    that failed.
    """

    outcomes: dict[str, list[Outcome] | None]
    troubles: dict[int, Outcome]


def answers(sandbox: Sandbox, cells: list[Cell], questions: list[Question], *, patience: float = 1.0) -> Answers:
    """Run the cells and ask the questions, as many times as it takes. Raises NoSandbox.

    patience : how many times its usual time everything is given; then the library is compiled as well.
    """
    found = Answers({}, {})
    cells, questions = list(cells), list(questions)
    while questions:
        request = request_for(cells, questions, patience)
        longest = max([CELL_SECONDS, *(question.exercise.seconds for question in questions)]) * patience
        compiled = any(question["home"] for question in request["questions"]) or patience > 1.0
        reply = sandbox.ask(request, longest + GRACE, "compiled" if compiled else "plain")
        take(reply, questions, found)
        if reply.end == "done":
            found.outcomes.update({q.exercise.name: found.outcomes.get(q.exercise.name) for q in questions})
            break
        cells, questions = what_remains(reply, cells, questions, found)
    return found


def request_for(cells: list[Cell], questions: list[Question], patience: float) -> dict[str, Any]:
    """What inside.py reads."""
    asked = [question_for(question, patience) for question in questions]
    sources = [question.exercise.source for question in questions]
    seconds = sum(CELL_SECONDS for _ in cells) + sum(len(q.cases) * q.exercise.seconds for q in questions)
    return {
        "cells": [{**cell._asdict(), "seconds": CELL_SECONDS * patience} for cell in cells],
        "questions": asked,
        "withheld": [f"{source.__module__}:{source.__name__}" for source in sources if source is not None],
        "limits": {"memory": MEMORY, "cpu": int(seconds * patience) + 1, "files": FILES},
    }


def question_for(question: Question, patience: float) -> dict[str, Any]:
    """One question: an exercise that calls in its own way is made anew inside, of any other only the shapes go there."""
    exercise, kind = question.exercise, type(question.exercise)
    plain = kind.call is Exercise.call and is_known(exercise.given) and is_known(exercise.answer)
    return {
        "name": exercise.name,
        "home": "" if plain else f"{kind.__module__}:{kind.__qualname__}",
        "given": repr(exercise.given) if plain else "",
        "answer": repr(exercise.answer) if plain else "",
        "seconds": exercise.seconds * patience,
        "cases": [exercise.given.encode(case.given) for case in question.cases],
    }


def is_known(shape: Any) -> bool:
    """Whether a shape is made of those that every exercise shares, so that its repr says all of it."""
    parts = shape.fields.values() if isinstance(shape, shapes.Record) else shape if isinstance(shape, tuple) else ()
    return type(shape).__name__ in KNOWN and all(is_known(part) for part in parts if hasattr(part, "encode"))


def take(reply: Reply, questions: list[Question], found: Answers) -> None:
    """Keep what a reply says of the cells and questions that were asked, in their order."""
    asked = {question.exercise.name: question for question in questions}
    for line in reply.lines:
        question, number = asked.get(str(line.get("question"))), line.get("case")
        if question is not None:
            outcomes = found.outcomes.setdefault(question.exercise.name, [])
            if outcomes is not None and line.get("missing") is True and not outcomes:
                found.outcomes[question.exercise.name] = None
            elif outcomes is not None and number == len(outcomes) < len(question.cases):
                outcomes.append(outcome_in(line.get("outcome"), question.exercise.answer))
        elif isinstance(line.get("cell"), int) and line.get("trouble") is not None:
            found.troubles[line["cell"]] = outcome_in(line["trouble"], Maybe(Truth()))


def outcome_in(data: Any, shape: Shape) -> Outcome:
    """The outcome that a line tells of; what tells of none is an answer of the wrong shape."""
    try:
        return decode_outcome(data, shape)
    except (WrongShape, TypeError, ValueError, RecursionError):
        return Misshapen(say("grading.no_outcome"))


def what_remains(reply: Reply, cells: list[Cell], questions: list[Question], found: Answers) -> tuple[list[Cell], list[Question]]:
    """After a program broke a sandbox off: which it was is said, and left out; the rest is asked again."""
    end = ending(reply)
    begun = [question for question in questions if question.exercise.name in found.outcomes]
    if begun:
        at = begun[-1]
        outcomes = found.outcomes[at.exercise.name]
        if outcomes is not None and len(outcomes) < len(at.cases) and not (outcomes and isinstance(outcomes[-1], Late)):
            outcomes.append(end)
        return cells, [question for question in questions if question.exercise.name not in found.outcomes]
    done = {line["cell"] for line in reply.lines if isinstance(line.get("cell"), int)}
    culprit = next((cell for cell in cells if cell.number not in done), None)
    if culprit is None:  # all cells were run, the first function was not heard of
        found.outcomes[questions[0].exercise.name] = [end]
        return cells, questions[1:]
    found.troubles[culprit.number] = end
    broken = sum(isinstance(trouble, Late) or is_stopped(trouble) for trouble in found.troubles.values())
    left = [cell for cell in cells if cell != culprit]
    return (left, questions) if broken < BROKEN_CELLS else ([cell for cell in left if cell.number in done], questions)


def ending(reply: Reply) -> Outcome:
    """How a sandbox ended, as the outcome of what was running then."""
    if reply.end == "late":
        return Late(left_running=False)
    key = "grading.flood" if reply.end == "flood" else "grading.ended" if reply.status >= 0 else "grading.stopped"
    return Raised([STOPPED], say(key, status=reply.status), [], "")


STOPPED = "Stopped"


def is_stopped(outcome: Outcome) -> bool:
    """Whether a program ended the very process that ran it."""
    return isinstance(outcome, Raised) and outcome.kinds == [STOPPED]
