"""nbgrader's gradebook, for the answers that people grade.

Scores are written to it, formgrader shows the answers, and formgrader's scores are read back. The
course folder holds gradebook.db, nbgrader_config.py, an empty folder in source/ for each
assignment, as formgrader lists no others, and the notebooks in autograded/. The notebooks are
cleaned first: text and pictures remain, and no HTML tag does.
"""

import json
import re
import warnings
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

from ...course.release import solution_path
from ...support.csv_cells import escape_formula, number, write_rows
from ...support.file_names import file_name
from ...support.json_fields import JsonObject
from ...support.notebooks import read_notebook
from ...support.whole_files import written_whole
from ..assignments.questions import read_assignment
from ..collect.notebook import UnreadableSubmission, join_text, parse_notebook
from ..collect.submissions import collect
from ..judge.class_list import Class, Entry, digest_submission
from ..report.decisions import BY_HAND, COLUMNS, Decision, read_table
from ..report.rows import BY_HAND as TO_GRADE
from ..report.rows import DECIDED, Row, list_questions

CONFIG = """\
# Written by kinoedu export --to nbgrader. In this folder: jupyter lab, then Nbgrader, Formgrader.
import os

c = get_config()
c.CourseDirectory.root = os.path.dirname(os.path.abspath(__file__))
"""
SHOWN = ("text/plain", "image/png", "image/jpeg")
TAG = re.compile(r"<(?=[A-Za-z/!?])")
LINK = re.compile(r"\](?=[(:])")  # before an address: a program to run, or a picture to fetch
# of formulas: they make links, or change the page around them
COMMAND = re.compile(r"\\+(?=href|csname|style|class|cssId)")
ENTITY = re.compile(r"&(?=#?\w+;)")  # another way to write any sign, such as the one of a command
NOTHING = Decision(None, "", "nbgrader")
NO_ANSWER = "(There is no such cell in the notebook that was handed in.)"
Marks = dict[str, dict[str, Any]]  # nbgrader's metadata of a cell, by its name


def export_nbgrader(of: Class, rows: Iterable[Row], folder: Path) -> int:
    """Write scores into the gradebook and notebooks beside it.

    Scores and comments that people gave there are kept; where the answer is another one since, it
    waits for them again. Those that they gave elsewhere, such as before the class was graded again,
    are added.

    Returns
    -------
    int
        The number of notebooks.

    Raises
    ------
    InvalidParameter
        Where a folder of submissions is gone.
    """
    from nbgrader.api import Gradebook

    folder.mkdir(parents=True, exist_ok=True)
    with written_whole(folder / "nbgrader_config.py") as part:
        part.write_text(CONFIG, encoding="utf-8")
    mine: dict[tuple[str, str], list[Row]] = {}
    for row in rows:
        mine.setdefault((row.student, row.assignment), []).append(row)
    given, count = read_table(of.out / BY_HAND), 0
    with warnings.catch_warnings(), Gradebook(name_database(folder)) as gradebook:
        warnings.simplefilter("ignore")  # SQLAlchemy's warnings about how nbgrader uses it
        for name in sorted({entry.assignment for entry in of.entries if entry.assignment}):
            add_assignment(gradebook, name)
        for entry, data in read_unchanged(of.entries):
            file = locate_notebook(entry, folder)
            before = read_answers(file)
            count += add_notebook(gradebook, entry, data, folder)
            now, by_hand = read_answers(file), read_assignment(entry.assignment).by_hand
            for row in mine[entry.student, entry.assignment]:
                if row.question in by_hand:
                    text = now.get(row.question)
                    is_other = before.get(row.question, text) != text
                    add_answer(gradebook, row, given.get(row[:3]), is_other=is_other)
                else:
                    add_score(gradebook, row, given.get(row[:3]))
        gradebook.db.commit()
    return count


def name_database(folder: Path) -> str:
    """The gradebook's address for its database."""
    return f"sqlite:///{(folder / 'gradebook.db').resolve()}"


def read_unchanged(entries: list[Entry]) -> Iterator[tuple[Entry, bytes]]:
    """Yield the entries whose files still are what was graded, and their bytes."""
    found = {
        (where, one.student, one.assignment): one
        for where in dict.fromkeys((entry.folder, entry.only) for entry in entries)
        for one in collect(Path(where[0]), where[1])
    }
    for entry in entries:
        one = found.get(((entry.folder, entry.only), entry.student, entry.assignment))
        if entry.key and one is not None and digest_submission(one) == entry.digest:
            yield entry, one.data


def read_marks(name: str) -> Marks:
    """nbgrader's metadata of an assignment's cells, from its solution."""
    book = read_notebook(solution_path(name))
    marked = [
        (cell, cell["metadata"]["nbgrader"])
        for cell in book["cells"]
        if "nbgrader" in cell["metadata"]
    ]
    return {mark["grade_id"]: {**mark, "cell_type": cell["cell_type"]} for cell, mark in marked}


def add_assignment(gradebook: Any, name: str) -> None:
    """Add an assignment and its cells to the gradebook."""
    gradebook.update_or_create_assignment(name)
    gradebook.update_or_create_notebook(name, name)
    for cell, mark in read_marks(name).items():
        if mark["grade"]:
            gradebook.update_or_create_grade_cell(
                cell, name, name, max_score=mark["points"], cell_type=mark["cell_type"]
            )
        if mark["solution"]:
            gradebook.update_or_create_solution_cell(cell, name, name)


def add_notebook(gradebook: Any, entry: Entry, data: bytes, folder: Path) -> bool:
    """Add a student's notebook for formgrader to show; return whether it can be read."""
    try:
        book = clean_notebook(parse_notebook(data), read_marks(entry.assignment))
    except UnreadableSubmission:
        return False
    student, name = file_name(entry.student), entry.assignment
    # formgrader shows no name at all where one of both is missing
    gradebook.update_or_create_student(
        student, last_name=make_printable(entry.student), first_name=""
    )
    gradebook.update_or_create_submission(name, student)
    file = locate_notebook(entry, folder)
    file.parent.mkdir(parents=True, exist_ok=True)
    (folder / "source" / name).mkdir(parents=True, exist_ok=True)
    with written_whole(file) as part:
        part.write_text(json.dumps(book, indent=1) + "\n", encoding="ascii")
    return True


def locate_notebook(entry: Entry, folder: Path) -> Path:
    """The file of a student's notebook in nbgrader's folder."""
    name = entry.assignment
    return folder / "autograded" / file_name(entry.student) / name / f"{name}.ipynb"


def read_answers(file: Path) -> dict[str, str]:
    """The text of each marked cell of an exported notebook; none where it cannot be read.

    Somebody may have opened and saved it since, or it may not be there.
    """
    try:
        cells = parse_notebook(file.read_bytes())["cells"]
        marked = [(cell["metadata"].get("nbgrader", {}), cell["source"]) for cell in cells]
        return {mark["grade_id"]: join_text(text) for mark, text in marked if mark}
    except (OSError, UnreadableSubmission, AttributeError, KeyError, TypeError):
        return {}


def make_printable(text: str) -> str:
    """Text that a database accepts."""
    return text.encode("utf-8", "replace").decode("utf-8")


def extract_text(text: Any) -> str:
    """The text of a cell, as a database accepts it."""
    return make_printable(join_text(text))


def add_score(gradebook: Any, row: Row, given: Decision | None) -> None:
    """Add a program's score, of the grader or of the person who overruled it, and a comment.

    Parameters
    ----------
    given : as for `add_answer`.
    """
    grade = find_grade(gradebook, f"check_{row.question}", row)
    if grade is None:
        return
    grade.auto_score = row.score
    grade.manual_score = row.score if row.status == DECIDED else None
    grade.needs_manual_grade = False
    if given is not None:
        add_comment(gradebook, row, given)


def add_answer(gradebook: Any, row: Row, given: Decision | None, *, is_other: bool) -> None:
    """Add what a person gave for an answer that people grade, or mark it as waiting for a score.

    Parameters
    ----------
    given : what stands in by_hand.csv, for a gradebook that has no score for this answer.
    is_other : whether the answer is another one than that in the gradebook.
    """
    grade = find_grade(gradebook, row.question, row)
    if grade is None:
        return
    if given is not None and grade.manual_score is None:
        grade.needs_manual_grade = False
        add_comment(gradebook, row, given)
        if given.score is not None:  # formgrader takes no more than all points, and extra credit
            grade.manual_score = min(given.score, row.max_score)
            grade.extra_credit = given.score - grade.manual_score or None
    if grade.manual_score is None:
        grade.needs_manual_grade = row.status == TO_GRADE
    elif is_other:
        grade.needs_manual_grade = True


def add_comment(gradebook: Any, row: Row, given: Decision) -> None:
    """Add the comment that a person gave, unless the gradebook has another one."""
    comment = gradebook.find_comment(*list_names(row.question, row))
    comment.manual_comment = comment.manual_comment or given.comment or None


def find_grade(gradebook: Any, cell: str, of: Row | Entry) -> Any:
    """A student's grade for a cell.

    None where the file could not be read, or the assignment no longer asks for this.
    """
    from nbgrader.api import MissingEntry

    try:
        return gradebook.find_grade(*list_names(cell, of))
    except MissingEntry:
        return None


def list_names(cell: str, of: Row | Entry) -> tuple[str, str, str, str]:
    """The names under which the gradebook has a student's cell."""
    return cell, of.assignment, of.assignment, file_name(of.student)


def clean_notebook(book: JsonObject, marks: Marks) -> JsonObject:
    """A notebook that is safe to open, with only the solution's marks, each once."""
    left = dict(marks)
    cells = (
        [clean_cell(cell, left) for cell in book["cells"] if isinstance(cell, dict)]
        if isinstance(book["cells"], list)
        else []
    )
    cells += [
        make_text_cell(NO_ANSWER, mark)
        for mark in left.values()
        if mark["grade"] and mark["solution"]
    ]
    return {"nbformat": 4, "nbformat_minor": 4, "metadata": {}, "cells": cells}


def clean_cell(cell: JsonObject, left: Marks) -> JsonObject:
    """One cell, with its mark unless an earlier cell has that mark."""
    metadata = cell.get("metadata")
    mine = metadata.get("nbgrader") if isinstance(metadata, dict) else None
    name = mine.get("grade_id") if isinstance(mine, dict) else None
    mark = left.pop(name, None) if isinstance(name, str) else None
    source = extract_text(cell.get("source"))
    if cell.get("cell_type") != "code":
        return make_text_cell(defuse(source), mark)
    return {
        **make_text_cell(source, mark),
        "cell_type": "code",
        "execution_count": None,
        "outputs": list(clean_outputs(cell)),
    }


def defuse(text: str) -> str:
    """A text in Markdown without tags, links and pictures; their words and addresses stay."""
    return COMMAND.sub("", LINK.sub("] ", TAG.sub("&lt;", ENTITY.sub("&amp;", text))))


def make_text_cell(source: str, mark: JsonObject | None) -> JsonObject:
    """A cell of text."""
    fields = {key: value for key, value in (mark or {}).items() if key != "cell_type"}
    return {
        "cell_type": "markdown",
        "metadata": {"nbgrader": fields} if mark else {},
        "source": source,
    }


def clean_outputs(cell: JsonObject) -> Iterator[JsonObject]:
    """Yield the text and the pictures among a cell's outputs."""
    outputs = cell.get("outputs")
    for output in outputs if isinstance(outputs, list) else ():
        if not isinstance(output, dict):
            continue
        if output.get("output_type") == "stream":
            yield {
                "output_type": "stream",
                "name": "stdout",
                "text": extract_text(output.get("text")),
            }
        data = output.get("data")
        shown = (
            {kind: extract_text(value) for kind, value in data.items() if kind in SHOWN}
            if isinstance(data, dict)
            else {}
        )
        if shown:
            yield {"output_type": "display_data", "metadata": {}, "data": shown}


def import_nbgrader_scores(of: Class, folder: Path) -> int:
    """Write the scores and comments that people gave in formgrader to GRADES/by_hand.csv.

    Of a program only the comment. Lines there about answers that this gradebook does not have are
    kept.

    Returns
    -------
    int
        The number of scores.
    """
    from nbgrader.api import Gradebook

    before, lines, count = read_table(of.out / BY_HAND), list[list[str]](), 0
    with Gradebook(name_database(folder)) as gradebook:
        for entry in of.entries:
            for question in list_questions(entry.assignment) if entry.assignment else ():
                whose = (entry.student, entry.assignment, question)
                given = read_given(gradebook, question, entry)
                count += given is not None and given.score is not None
                kept = before.get(whose, NOTHING) if given is None else given
                if kept.score is not None or kept.comment:
                    lines.append(format_line(whose, kept))
    write_rows(of.out / BY_HAND, [COLUMNS, *lines])
    return count


def read_given(gradebook: Any, question: str, entry: Entry) -> Decision | None:
    """What a person gave for an answer; None where this gradebook does not have it."""
    is_program = question not in read_assignment(entry.assignment).by_hand
    grade = find_grade(gradebook, f"check_{question}" if is_program else question, entry)
    if grade is None:
        return None
    comment = gradebook.find_comment(*list_names(question, entry)).manual_comment or ""
    if is_program or grade.manual_score is None:
        return NOTHING._replace(comment=comment)
    if grade.needs_manual_grade:  # the score is that of an earlier answer
        return NOTHING
    return Decision(grade.manual_score + (grade.extra_credit or 0.0), comment, "nbgrader")


def list_scores_of_programs(rows: Iterable[Row], folder: Path) -> list[str]:
    """The scores that people gave in formgrader for programs, where the table has others.

    They are not read back, since the grader's scores are overruled in overrides.csv.
    """
    from nbgrader.api import Gradebook

    found = []
    with Gradebook(name_database(folder)) as gradebook:
        for row in rows:
            grade = find_grade(gradebook, f"check_{row.question}", row)
            is_given = grade is not None and (grade.manual_score is not None or grade.extra_credit)
            if is_given and grade.score != row.score:
                found.append(f"{' '.join(row[:3])}: {number(grade.score)}")
    return found


def format_line(whose: tuple[str, str, str], given: Decision) -> list[str]:
    """A line of by_hand.csv."""
    return [*map(escape_formula, whose), number(given.score), escape_formula(given.comment)]
