"""Scores that people decide: those that overrule the grader's, and those that only people can give.

They stand in two tables, GRADES/overrides.csv and GRADES/by_hand.csv, with the columns student,
assignment, question, score, comment. No command of kinoedu writes the first; the second holds the
scores of nbgrader's gradebook. Where both have a score, the first holds.
"""

import csv
import io
import math
from pathlib import Path
from typing import NamedTuple

from ...errors import InvalidParameter
from ...support.csv_cells import one_line, unescape_formula

OVERRIDES, BY_HAND = "overrides.csv", "by_hand.csv"
COLUMNS = ("student", "assignment", "question", "score", "comment")


class Decision(NamedTuple):
    """What a person decided about a question.

    score : None where only a comment is given.
    source : where it stands, such as "overrides.csv, line 2".
    """

    score: float | None
    comment: str
    source: str


Decisions = dict[tuple[str, str, str], Decision]  # by student, assignment, question


def read_decisions(out: Path) -> Decisions:
    """All decisions about a class, from both tables.

    Raises
    ------
    InvalidParameter
        Where a table cannot be read; the message names the line.
    """
    found, over = read_table(out / BY_HAND), read_table(out / OVERRIDES)
    for whose, decision in over.items():
        below = found.get(whose, decision)
        score = below.score if decision.score is None else decision.score
        found[whose] = decision._replace(score=score, comment=decision.comment or below.comment)
    return found


def read_table(file: Path) -> Decisions:
    """The decisions in one table; none if there is no such file."""
    if not file.exists():
        return {}
    try:
        reader = csv.DictReader(io.StringIO(file.read_text(encoding="utf-8-sig"), newline=""))
        missing = [name for name in COLUMNS[:4] if name not in (reader.fieldnames or ())]
        if missing:
            raise InvalidParameter(
                f"{file} has no column {missing[0]!r}; its first line should be {','.join(COLUMNS)}"
            )
        rows = [
            (
                reader.line_num,
                {name: unescape_formula((row.get(name) or "").strip()) for name in COLUMNS},
                row.get(None),
            )
            for row in reader
        ]
    except (UnicodeDecodeError, csv.Error) as error:
        raise InvalidParameter(
            f"{file} cannot be read: {error}; save it as CSV in UTF-8"
        ) from error
    found: Decisions = {}
    for number, row, extra in rows:
        source = f"{file.name}, line {number}"
        if extra:
            raise InvalidParameter(
                f"{source} has more cells than the first line; write 2.5 with a point, and a "
                "comment with commas in quotation marks"
            )
        whose = (one_line(row["student"]), row["assignment"], row["question"])
        if not any(row.values()):
            continue
        if whose in found:
            raise InvalidParameter(
                f"{source}: {' '.join(whose)} has a line already, in {found[whose].source}; "
                "leave one"
            )
        found[whose] = Decision(parse_score(row["score"], source), row["comment"], source)
    return found


def parse_score(text: str, source: str) -> float | None:
    """The score in a cell, or None if the cell is empty. Raises InvalidParameter."""
    if not text:
        return None
    try:
        score = float(text)
    except ValueError:
        score = math.nan
    if not 0.0 <= score < math.inf:
        raise InvalidParameter(
            f"{source}: a score is a number from 0, with a point and no comma, or empty; got "
            f"{text[:40]!r}"
        )
    return score
