"""What is kept of a graded class: who handed in what, from where, and which result is whose; in
GRADES/class.json.

class.json        this list                     results/     a file for each notebook graded, named by its content
grades.csv        a row for each question       report.html  the class at a glance
feedback/         a page for each student       pictures/    of cases that failed, each drawn once
overrides.csv     what people decided           by_hand.csv  what people graded in nbgrader
"""

import hashlib
import json
from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

from ...errors import InvalidParameter
from ...support.whole_files import written_whole
from ..collect.submissions import Submission
from .running import Graded, kept, key_of
from .submission import Grade

FILE = "class.json"


class Entry(NamedTuple):
    """One submission of a graded class.

    file : where it was in `folder`, the folder or zip that was collected, of one assignment where
        `only` names it. digest : of its bytes. key : its result's name; "" where it could not be
        read, and then `trouble` says why. Where there is a key and no result, `trouble` is the
        machine's. late : Canvas marked the file so.
    """

    student: str
    assignment: str
    file: str
    folder: str
    only: str
    digest: str
    key: str
    trouble: str
    late: bool = False


class Class(NamedTuple):
    """A graded class: its folder, the secret's file and what tells that secret from others, whether
    the sandbox was left out, the entries, by student and assignment, and whether each student has
    contracts of their own.
    """

    out: Path
    secret_file: str
    secret_mark: str
    trusted: bool
    entries: list[Entry]
    variants: bool = False


def entry_of(one: Graded, folder: Path, only: str, secret: bytes) -> Entry:
    """What is kept of a submission."""
    mine, key = one.submission, "" if one.submission.trouble else key_of(one.submission, secret)
    where = (mine.file, str(folder.resolve()), only)
    trouble = "" if one.grade is not None else one.trouble
    return Entry(mine.student, mine.assignment, *where, digest_of(mine), key, trouble, mine.late)


def digest_of(one: Submission) -> str:
    """What tells a submission from an earlier one of the same student."""
    return hashlib.sha256(one.data).hexdigest()


def mark_of(secret: bytes) -> str:
    """What tells one secret from another, and tells neither."""
    return hashlib.sha256(b"mark" + secret).hexdigest()[:16]


def with_earlier(entries: list[Entry], earlier: Iterable[Entry]) -> list[Entry]:
    """New entries, and the earlier ones of other folders that are not of the same students and
    assignments.
    """
    sources, pairs = (
        {(one.folder, one.only) for one in entries},
        {(one.student, one.assignment) for one in entries},
    )
    others = [
        one
        for one in earlier
        if (one.folder, one.only) not in sources and (one.student, one.assignment) not in pairs
    ]
    return sorted([*entries, *others], key=lambda one: (one.student, one.assignment, one.file))


def write_class(of: Class) -> None:
    """Keep it."""
    data = {**of._asdict(), "entries": [entry._asdict() for entry in of.entries]}
    del data["out"]
    with written_whole(of.out / FILE) as part:
        part.write_text(json.dumps(data, indent=1, sort_keys=True) + "\n", encoding="ascii")


def read_class(out: Path) -> Class:
    """What was kept. Raises InvalidParameter."""
    try:
        data = json.loads((out / FILE).read_text(encoding="ascii"))
        return Class(out, **{**data, "entries": [Entry(**entry) for entry in data["entries"]]})
    except OSError as error:
        raise InvalidParameter(
            f"{out} holds no graded class: there is no {FILE}; grade into it first"
        ) from error
    except (ValueError, TypeError, KeyError) as error:
        raise InvalidParameter(
            f"{out / FILE} is damaged; grade again, which takes the results that are there"
        ) from error


def record_of(entry: Entry, out: Path) -> Grade | None:
    """The result of an entry; None where there is none."""
    return kept(out / "results" / f"{entry.key}.json") if entry.key else None
