"""A student's page: the score of each answer and the reasons.

It shows the smallest case that failed, as code and as a picture, and the cells that failed. It
cannot show a hidden case, since the record of a grade holds none.
"""

import base64
from collections.abc import Iterator, Mapping
from html import escape
from pathlib import Path
from typing import Any

from ...course.outcomes import Raised, decode_outcome
from ...course.plain import WrongShape
from ...course.shapes import Maybe, Truth
from ...messages import get_message
from ...support.csv_cells import number
from ...support.file_names import file_name
from ...support.text import show_controls, with_code
from ..judge.answers import is_stopped
from ..judge.submission import RIGHT, Grade
from .failures import explain_failure, find_picture
from .pages import heading, page, paragraph
from .rows import BY_HAND, DECIDED, Row, sum_totals


def name_page(student: str, assignment: str) -> str:
    """The path of a page in the folder of the grades."""
    return f"feedback/{file_name(student)}/{file_name(assignment or 'unknown')}.html"


def render_feedback(
    rows: list[Row], record: Grade | None, trouble: str, pictures: Path, name: str = ""
) -> str:
    """The page for the rows of one submission.

    pictures : the folder in which pictures are kept.
    name : the student's name beside the id, or "".
    """
    student, assignment = rows[0].student, rows[0].assignment
    total = sum_totals(rows)[student, assignment]
    body = [paragraph(add_name(student, name), "quiet")]
    if rows[0].late:
        body.append(paragraph(get_message("grades.late")))
    if trouble:
        body += [heading(get_message("grades.trouble")), paragraph(trouble)]
    if assignment:
        waiting = get_message("grades.waiting", count=total.waiting) if total.waiting else ""
        score, most = number(total.score), number(total.max_score)
        body.append(paragraph(get_message("grades.total", score=score, most=most) + waiting))
    records = {one["question"]: one for one in record["questions"]} if record is not None else {}
    for row in rows:
        if row.question:
            body += render_question(row, records.get(row.question), pictures)
    if record is not None and record["cells"]:
        body += render_cells(record["cells"])
    if record is not None and record.get("left_out"):
        body += render_left_out(record["left_out"])
    return page(assignment or get_message("grades.unknown"), body)


def add_name(student: str, name: str) -> str:
    """A student's name and id; the id alone if the name is not known.

    >>> add_name("ann", "Ann Lee"), add_name("ann", "")
    ('Ann Lee (ann)', 'ann')
    """
    return f"{name} ({student})" if name and name != student else student


def render_question(row: Row, question: Grade | None, pictures: Path) -> Iterator[str]:
    """The lines of one question."""
    share = 0.0 if row.score is None else row.score / (row.max_score or 1.0)
    kind = "" if row.score is None else "all" if share >= 1.0 else "some" if share > 0.0 else "none"
    score = (
        get_message("grades.no_score", most=number(row.max_score))
        if row.score is None
        else f"{number(row.score)} / {number(row.max_score)}"
    )
    yield (
        f'<section class="{kind}"><h2><span>{escape(row.question)}</span>'
        f'<span class="n">{score}</span></h2>'
    )
    if row.score is None or row.status in (BY_HAND, DECIDED):
        yield paragraph(
            get_message(f"grades.status.{row.status.replace(' ', '_')}")
            + (f": {row.message}" if row.message else ".")
        )
    if question is not None and question["status"] != RIGHT:
        if row.status != DECIDED:
            yield paragraph(question["message"])
            if row.comment:
                yield paragraph(get_message("grades.comment", comment=row.comment))
        yield from render_failure(question, pictures)
    elif row.status == RIGHT:
        yield paragraph(row.message)
    yield "</section>"


def render_failure(question: Grade, pictures: Path) -> Iterator[str]:
    """Why an answer is wrong: the case if everybody has seen it, its picture, and the hint."""
    entries = explain_failure(question)
    if entries:
        kinds = ("passed", "failed", "untried", "points")
        plain = {get_message(f"check.{key}") for key in ("contract", "wanted", "hint", "read")}
        plain |= {get_message(f"grades.kinds.{key}") for key in kinds}
        pairs = [
            (title, with_code(text) if title in plain else f"<code>{escape(text)}</code>")
            for title, text in entries
        ]
        yield (
            "<dl>"
            + "".join(f"<dt>{escape(title)}</dt><dd>{text}</dd>" for title, text in pairs)
            + "</dl>"
        )
    picture = find_picture(question, pictures)
    if picture is not None:
        alt = escape(get_message("check.picture", name=question["question"]))
        yield f'<img alt="{alt}" src="data:image/png;base64,{base64.b64encode(picture).decode()}">'


def render_cells(troubles: list[Grade]) -> Iterator[str]:
    """The cells that failed, with the student's own lines."""
    yield heading(get_message("grades.cells"))
    yield paragraph(get_message("grades.cells_about"), "quiet")
    for trouble in troubles:
        text, lines = describe_cell(trouble["trouble"])
        yield paragraph(get_message("grades.cell", number=trouble["cell"], words=text))
        if lines:
            yield f"<pre>{escape(chr(10).join(lines))}</pre>"


def render_left_out(commands: list[Grade]) -> Iterator[str]:
    """The commands of the notebook that were not run; what a command would have given is empty."""
    yield heading(get_message("grades.left_out"))
    yield paragraph(get_message("grades.left_out_about"), "quiet")
    for one in commands:
        place = get_message("grades.left_out_place", cell=one["cell"], line=one["line"])
        yield f"<p>{escape(place)} <code>{escape(show_controls(one['command']))}</code></p>"


def describe_cell(data: Mapping[str, Any]) -> tuple[str, list[str]]:
    """The message of a cell that failed, and the lines where it failed."""
    try:
        outcome = decode_outcome(data, Maybe(Truth()))
    except WrongShape:
        return get_message("grading.no_outcome"), []
    if not isinstance(outcome, Raised):
        return get_message("grades.cell_late"), []
    if is_stopped(outcome):
        return outcome.message, []
    kind = outcome.kinds[0] if outcome.kinds else ""
    return f"{kind}: {outcome.message}" if outcome.message else kind, outcome.lines
