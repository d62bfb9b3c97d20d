"""What GRADES/class.json keeps of a graded class: each submission and the name of its result.

class.json        this list                     results/     a file per notebook, named by its key
grades.csv        a row for each question       report.html  an overview of the class
feedback/         a page for each student       pictures/    of cases that failed, each drawn once
overrides.csv     scores that people decided    by_hand.csv  scores that people gave in nbgrader
pages.json        of what each page was made    exports.json  the tables that were exported
.lock             locked while one command writes these
"""

import hashlib
import json
import logging
import time
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple

from ...compiled.store import try_lock
from ...errors import InvalidParameter
from ...support.csv_cells import one_line
from ...support.whole_files import written_whole
from ..collect.names import Names, find_name
from ..collect.submissions import Submission
from .running import Graded, compute_key, read_result
from .submission import Grade

FILE, LOCK = "class.json", ".lock"
REPLACED = (
    "another notebook of the same student and assignment takes the place of what was graded before "
    "(%d in all, such as that of %s from %s); to keep both, grade each folder into its own grades"
)
log = logging.getLogger("kinoedu")


class Entry(NamedTuple):
    """One submission of a graded class.

    file : where it was in `folder`.
    folder : the folder or zip that was collected.
    only : the one assignment that was collected from it, or "".
    digest : of the file's bytes.
    key : the name of its result; "" where the file could not be read, and `trouble` says why.
    trouble : if there is a key and no result, this is the machine's trouble.
    late : whether Canvas marked the file as late.
    name : the student's name, or "" if it is not known.
    letter : the variant of the student's section, or "".
    variants : whether the student has contracts of their own.
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
    name: str = ""
    letter: str = ""
    variants: bool = False


class Class(NamedTuple):
    """A graded class.

    out : the folder of the grades.
    secret_file, secret_mark : the file of the course's secret, and a mark to recognise that secret.
    trusted : whether programs ran without a sandbox.
    entries : the submissions, ordered by student and assignment.
    """

    out: Path
    secret_file: str
    secret_mark: str
    trusted: bool
    entries: list[Entry]


def make_entry(one: Graded, folder: Path, only: str, secret: bytes) -> Entry:
    """The entry of a graded submission."""
    mine = one.submission
    where = (mine.file, str(folder.resolve()), only)
    key = "" if mine.trouble else compute_key(mine, secret)
    result = (digest_submission(mine), key, "" if one.grade is not None else one.trouble)
    has_own = bool(mine.variants) and not mine.letter
    return Entry(
        mine.student,
        mine.assignment,
        *where,
        *result,
        late=mine.late,
        letter=mine.letter,
        variants=has_own,
    )


def digest_submission(one: Submission) -> str:
    """The digest of a submission's bytes, which differs from that of an earlier file."""
    return hashlib.sha256(one.data).hexdigest()


def list_varied(entries: Iterable[Entry], folder: Path | None = None) -> set[tuple[str, str]]:
    """The folders, and what was collected from them, whose students have contracts of their own.

    folder : where the submissions are now, if they were moved.
    """
    return {
        (str((folder or Path(one.folder)).resolve()), one.only) for one in entries if one.variants
    }


def add_names(entries: list[Entry], earlier: Iterable[Entry], names: Names) -> list[Entry]:
    """The entries with the students' names; those that are not in `names` keep an earlier name."""
    before = {one.student: one.name for one in earlier}
    return [
        one._replace(name=find_name(one.student, names) or before.get(one.student, ""))
        for one in entries
    ]


def mark_secret(secret: bytes) -> str:
    """A mark by which a secret is recognised, and which does not reveal it."""
    return hashlib.sha256(b"mark" + secret).hexdigest()[:16]


def add_earlier(entries: list[Entry], earlier: Iterable[Entry]) -> list[Entry]:
    """The new entries, and earlier ones of other folders with other students or assignments."""
    sources = {(one.folder, one.only) for one in entries}
    pairs = {(one.student, one.assignment) for one in entries}
    others = [
        one
        for one in earlier
        if (one.folder, one.only) not in sources and (one.student, one.assignment) not in pairs
    ]
    return sorted([*entries, *others], key=lambda one: (one.student, one.assignment, one.file))


def warn_of_replaced(entries: list[Entry], earlier: Iterable[Entry]) -> None:
    """Log a warning if submissions take the place of others, which were in another folder."""
    now = {(one.student, one.assignment): one for one in entries}
    folders = {one.folder for one in entries}
    replaced = [
        one
        for one in earlier
        if one.folder not in folders
        and (new := now.get((one.student, one.assignment))) is not None
        and new.digest != one.digest
    ]
    if replaced:
        log.warning(REPLACED, len(replaced), replaced[0].student, replaced[0].folder)


def write_class(of: Class) -> None:
    """Write class.json."""
    data = {**of._asdict(), "entries": [entry._asdict() for entry in of.entries]}
    del data["out"]
    with written_whole(of.out / FILE) as part:
        part.write_text(json.dumps(data, indent=1, sort_keys=True) + "\n", encoding="ascii")


@contextmanager
def locked_class(out: Path) -> Iterator[None]:
    """Let no other command write the list, tables and pages of a class; wait while one does."""
    with open(out / LOCK, "wb") as lock:
        while not try_lock(lock):
            time.sleep(0.1)
        yield


def read_class(out: Path) -> Class:
    """The class that was graded into a folder; names have today's spelling, in older files too.

    Raises
    ------
    InvalidParameter
        Where there is none, or its file is damaged.
    """
    try:
        data = json.loads((out / FILE).read_text(encoding="ascii"))
        variants = data.pop("variants", False)  # of all of them, in older files
        entries = [
            Entry(**{"variants": variants, **entry, "student": one_line(entry["student"])})
            for entry in data["entries"]
        ]
        return Class(out, **{**data, "entries": entries})
    except OSError as error:
        raise InvalidParameter(
            f"{out} holds no graded class: there is no {FILE}; grade into it first"
        ) from error
    except (ValueError, TypeError, KeyError) as error:
        raise InvalidParameter(
            f"{out / FILE} is damaged; remove it and grade every folder of submissions again, "
            "which takes the results that are there"
        ) from error


def read_record(entry: Entry, out: Path) -> Grade | None:
    """The result of an entry, or None where there is none."""
    return read_result(out / "results" / f"{entry.key}.json") if entry.key else None
