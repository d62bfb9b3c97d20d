"""A midterm: questions whose numbers are drawn from a seed, and whose answers are computed.

The questions are functions in `solutions/midterm`, which students do not have. Each takes a
generator and returns an `Asked`. A variant draws its own numbers: no question has the same answer
in two variants.
"""

import os
import runpy
from collections.abc import Callable, Sequence
from html import escape
from pathlib import Path
from typing import NamedTuple

import numpy as np

from ..errors import InvalidParameter
from ..messages import get_message
from ..support.whole_files import written_whole
from .release import HOUSE

MOST_DRAWS = 100
STYLE = """\
body { font: 12pt/1.4 Georgia, serif; max-width: 46em; margin: 2em auto; color: #111827; }
section { break-inside: avoid; margin: 1.5em 0; }
h2 { font-size: 1.1em; margin-bottom: .3em; }
p { white-space: pre-line; margin: .4em 0; }
.room { height: 11em; border: 1px solid #9ca3af; }
.answer { border-left: 4px solid #0072b2; padding-left: 1em; }
"""


class Asked(NamedTuple):
    """A question with its numbers: its text, its answer, and how one comes to it."""

    text: str
    answer: str
    solution: str


class MidtermQuestion(NamedTuple):
    """A question before its numbers are drawn."""

    name: str
    lesson: str
    points: int
    draw: Callable[[np.random.Generator], Asked]


class Paper(NamedTuple):
    """A variant: its name, and the questions with their numbers."""

    variant: str
    questions: tuple[tuple[MidtermQuestion, Asked], ...]


def midterm_question(
    lesson: str, points: int
) -> Callable[[Callable[[np.random.Generator], Asked]], MidtermQuestion]:
    """Mark a function as a question of the midterm."""
    return lambda draw: MidtermQuestion(draw.__name__, lesson, points, draw)


def read_midterm(house: Path = HOUSE) -> list[MidtermQuestion]:
    """The questions in `solutions/midterm`, in the order of the lessons.

    Raises
    ------
    InvalidParameter
        Where there are none, as in the kit for students.
    """
    files = sorted((house / "solutions" / "midterm").glob("*.py"))
    found = [one for file in files for one in runpy.run_path(str(file)).values()]
    questions = [one for one in found if isinstance(one, MidtermQuestion)]
    if not questions:
        raise InvalidParameter(
            "there are no questions in solutions/midterm; students' copies of the course have none"
        )
    return sorted(questions, key=lambda one: one.lesson)


def make_papers(
    questions: Sequence[MidtermQuestion], seed: int, variants: Sequence[str]
) -> list[Paper]:
    """Draw the numbers of each variant.

    The same seed gives the same papers. A variant does not change when another is added after it.

    Raises
    ------
    InvalidParameter
        Where two variants have the same name, on a disk that ignores case too, or a question has
        too few different answers.
    """
    if len({one.casefold() for one in variants}) != len(variants) or not variants:
        raise InvalidParameter(
            f"variants need different names, got {', '.join(variants) or 'none'}"
        )
    answers: dict[str, set[str]] = {one.name: set() for one in questions}
    papers = []
    for number, variant in enumerate(variants):
        drawn = []
        for place, question in enumerate(questions):
            rng = np.random.default_rng([seed, number, place])
            asked = draw_other(question, rng, answers[question.name])
            answers[question.name].add(asked.answer)
            drawn.append((question, asked))
        papers.append(Paper(variant, tuple(drawn)))
    return papers


def draw_other(question: MidtermQuestion, rng: np.random.Generator, taken: set[str]) -> Asked:
    """Draw a question until its answer is not taken."""
    for _ in range(MOST_DRAWS):
        asked = question.draw(rng)
        if asked.answer not in taken:
            return asked
    raise InvalidParameter(
        f"{question.name} has only {len(taken)} different answers; use fewer variants"
    )


def write_midterm(
    folder: str | os.PathLike[str],
    seed: int,
    variants: Sequence[str] = ("A", "B"),
    house: Path = HOUSE,
) -> list[Path]:
    """Write each variant and its solutions, as Markdown and as a page to print.

    Returns
    -------
    list of Path
        The files.
    """
    papers = make_papers(read_midterm(house), seed, variants)
    made = []
    Path(folder).mkdir(parents=True, exist_ok=True)
    for paper in papers:
        for name, solved in (("midterm", False), ("solutions", True)):
            for ending, write in (("md", as_markdown), ("html", as_page)):
                made.append(Path(folder) / f"{name}_{paper.variant}.{ending}")
                with written_whole(made[-1]) as part:
                    part.write_text(write(paper, solved), encoding="utf-8")
    return made


def title_of(paper: Paper, solved: bool) -> str:
    """Title of a paper."""
    key = "midterm.solutions" if solved else "midterm.title"
    points = sum(question.points for question, _ in paper.questions)
    return get_message(key, variant=paper.variant, points=points)


def heading_of(number: int, question: MidtermQuestion) -> str:
    """Heading of a question."""
    return get_message("midterm.question", number=number, points=question.points)


def as_markdown(paper: Paper, solved: bool) -> str:
    """A paper as Markdown."""
    parts = [f"# {title_of(paper, solved)}", "" if solved else get_message("midterm.rules")]
    for number, (question, asked) in enumerate(paper.questions, 1):
        parts += [f"## {heading_of(number, question)}", asked.text]
        if solved:
            parts += [get_message("midterm.answer", answer=f"**{asked.answer}**"), asked.solution]
    return "\n\n".join(part for part in parts if part) + "\n"


def as_page(paper: Paper, solved: bool) -> str:
    """A paper as HTML, with room for answers; it needs no network."""
    title = escape(title_of(paper, solved))
    parts = [f"<h1>{title}</h1>"]
    parts += [] if solved else [f"<p>{escape(get_message('midterm.rules'))}</p>"]
    for number, (question, asked) in enumerate(paper.questions, 1):
        below = '<div class="room"></div>'
        if solved:
            answer = get_message("midterm.answer", answer=asked.answer)
            below = f'<div class="answer"><p><b>{escape(answer)}</b></p>'
            below += f"<p>{escape(asked.solution)}</p></div>"
        heading = escape(heading_of(number, question))
        parts.append(f"<section><h2>{heading}</h2><p>{escape(asked.text)}</p>{below}</section>")
    head = f'<meta charset="utf-8"><title>{title}</title><style>{STYLE}</style>'
    body = "\n".join(parts)
    return f'<!doctype html>\n<html lang="en"><head>{head}</head><body>\n{body}\n</body></html>\n'
