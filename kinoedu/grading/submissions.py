"""Which file is whose: a folder of submissions as nbgrader, Canvas, Moodle or Gradescope lay it out, or as a teacher does by hand.

    student/assignment.ipynb, student/assignment/assignment.ipynb    by hand, nbgrader
    name_12345_67890_file.ipynb, name_LATE_12345_67890_file.ipynb    Canvas
    Full Name_12345_assignsubmission_file_/file.ipynb                Moodle
    submission_12345/file.ipynb beside submission_metadata.yml       Gradescope

Any of them may be a zip, and a student's file may be a zip. A zip is read in memory and nothing of it is ever unpacked to the disk.
"""

import io
import re
import zipfile
import zlib
from collections.abc import Iterable, Iterator
from pathlib import Path, PurePosixPath
from typing import NamedTuple

from ..course.release import HOUSE, assignments
from ..errors import InvalidParameter
from .cells_of_csv import one_line
from .notebook import MOST_BYTES, UnreadableSubmission, notebook_in, read_bytes

CANVAS = re.compile(r"^(?P<student>[^_]+)_(?:late_)?(?P<id>\d+)_\d+_(?P<file>.+)$", re.IGNORECASE)
MOODLE = re.compile(r"^(?P<student>.+)_(?P<id>\d+)_assignsubmission_(?:file|onlinetext)_?$")
GRADESCOPE = re.compile(r"^submission_\d+$")
COPIED = re.compile(r"([ _-]?\(\d+\)|-\d+|[ _-]copy\d*)+$", re.IGNORECASE)  # what a download or a second try adds to a name
METADATA = "submission_metadata.yml"
MOST_MEMBERS = 10_000
MOST_UNPACKED = 2 * 2**30  # bytes of all notebooks of a class, and here of one student
MOST_OF_ONE, MOST_UNPACKED_OF_ONE = 100, 4 * MOST_BYTES
PACKED = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)  # others take what memory the file says
LONGEST_NAME, MOST_NAMED = 300, 5  # characters of a file's place, files in a sentence


class Submission(NamedTuple):
    """What a student handed in: the bytes of a notebook, or the trouble with it. `file` is where it was, for people to read.
    `variants` are the student's own contracts, as pairs of a question and a name, where the class has such.
    """

    student: str
    assignment: str
    file: str
    data: bytes
    trouble: str = ""
    variants: tuple[tuple[str, str], ...] = ()


class Found(NamedTuple):
    """A file, its place as names from the top down, and its bytes or the trouble with it."""

    place: tuple[str, ...]
    data: bytes
    trouble: str = ""


def collect(folder: Path, only: str = "", house: Path = HOUSE) -> list[Submission]:
    """All submissions in a folder or zip, ordered by student and assignment; of one assignment where `only` names it.

    Every file that may be a submission comes back: what cannot be read, is handed in twice or belongs to no assignment has its
    trouble with it. Raises InvalidParameter.
    """
    if not folder.exists():
        raise InvalidParameter(f"there is no folder {folder}")
    known = assignments(house)
    if only and only not in known:
        raise InvalidParameter(f"there is no assignment {only!r}; there are: {', '.join(known)}")
    found = unwrapped(list(files_in(folder)), known)
    owners = gradescope_owners(found)
    submissions = [submission_of(file, owners, known, only) for file in found if is_candidate(file)]
    return sorted(without_doubles(submissions), key=lambda one: (one.student, one.assignment, one.file))


def files_in(folder: Path) -> Iterator[Found]:
    """Every file in a folder, also those in its zips; in a stable order. What is no plain file has that trouble."""
    if folder.is_file():
        yield from unpacked(Found((folder.name,), read_bytes(folder)), top=True)
        return
    for file in sorted(folder.rglob("*")):
        place = file.relative_to(folder).parts
        if any(part.startswith(".") or part == "__MACOSX" for part in place) or (file.is_dir() and not file.is_symlink()):
            continue
        try:
            data = read_bytes(file) if is_read(file.name) else b""
        except UnreadableSubmission as trouble:
            yield Found(place, b"", str(trouble))
        else:
            yield from unpacked(Found(place, data))


def is_read(name: str) -> bool:
    """Whether a file is opened at all: what else lies beside a notebook takes no memory and is no trouble, whatever it is."""
    return name.lower().endswith((".ipynb", ".zip")) or name == METADATA


def unwrapped(files: list[Found], known: list[str]) -> list[Found]:
    """Files without the folders that hold all of them: what stands first in a place then is the instructor's, and all after that
    may be a student's own, who is not asked there whose it is. A folder of assignments, or of one zip, is a lone student's.
    """
    places = [file.place for file in files if not file.place[-1].startswith(".")]
    while places and all(len(place) > 2 for place in places) and len({place[0] for place in places}) == 1:
        below = {place[1] for place in places}
        if below <= set(known) or (len(below) == 1 and min(below).lower().endswith(".zip")):
            break
        places = [place[1:] for place in places]
        files = [file._replace(place=file.place[1:] or file.place) for file in files]
    return files


def unpacked(file: Found, *, top: bool = False) -> Iterator[Found]:
    """A file, or what is in it where it is a zip; a zip in a zip only where the first is a whole class."""
    if not file.place[-1].lower().endswith(".zip"):
        yield file
        return
    above = () if top else file.place
    try:
        with zipfile.ZipFile(io.BytesIO(file.data)) as archive:
            for member in members_of(archive, top=top):
                place = (*above, *PurePosixPath(member.filename.replace("\\", "/")).parts)
                inner = member_of(archive, member, place)
                yield from unpacked(inner) if top and not inner.trouble else [inner]
    except (*UNREADABLE, UnreadableSubmission) as error:
        yield Found(file.place, b"", f"the zip cannot be read: {error}")


UNREADABLE = (zipfile.BadZipFile, zlib.error, OSError, ValueError, NotImplementedError, RuntimeError, EOFError)


def members_of(archive: zipfile.ZipFile, *, top: bool) -> list[zipfile.ZipInfo]:
    """The files of a class's zip, or the notebooks of a student's. Raises UnreadableSubmission."""
    most, most_bytes = (MOST_MEMBERS, MOST_UNPACKED) if top else (MOST_OF_ONE, MOST_UNPACKED_OF_ONE)
    members = [one for one in archive.infolist() if not one.is_dir() and (top or one.filename.lower().endswith(".ipynb"))]
    if len(members) > most or sum(one.file_size for one in members if is_read(one.filename)) > most_bytes:
        raise UnreadableSubmission("the zip holds too much")
    if not (members or top):
        raise UnreadableSubmission("it holds no notebook, unless that is in another zip; hand in the notebook itself")
    return members


def member_of(archive: zipfile.ZipFile, member: zipfile.ZipInfo, place: tuple[str, ...]) -> Found:
    """One file of a zip, read no further than it may be long."""
    if any(part.startswith(".") or part == "__MACOSX" for part in place):
        return Found((*place[:-1], ".skipped"), b"")
    if not is_read(place[-1]):
        return Found(place, b"")
    if member.compress_type not in PACKED:
        return Found(place, b"", "it was packed in an unusual way; pack it with an ordinary zip")
    with archive.open(member) as stream:
        data = stream.read(MOST_BYTES + 1)
    return Found(place, data) if len(data) <= MOST_BYTES else Found(place, b"", "the file is too large")


def is_candidate(file: Found) -> bool:
    """Whether a file may be a submission: a notebook, or what could not be opened."""
    return file.place[-1].lower().endswith(".ipynb") or (bool(file.trouble) and not file.place[-1].startswith("."))


def submission_of(file: Found, owners: dict[str, str], known: list[str], only: str) -> Submission:
    """Whose a file is, and which assignment it answers."""
    student, name = owner(file.place, owners)
    where = one_line("/".join(file.place)[-LONGEST_NAME:])
    assignment = only or assignment_of(name, file, known)
    trouble = file.trouble or (
        "" if assignment else f"it answers no assignment that is known; its name should begin with one of: {', '.join(known)}"
    )
    return Submission(student, assignment, where, file.data, trouble)


def owner(place: tuple[str, ...], owners: dict[str, str]) -> tuple[str, str]:
    """The student whom a place belongs to, and the name of the file without what was put before it.

    >>> owner(("doejane_LATE_1234_56789_01_geometry-1.ipynb",), {})
    ('doejane_1234', '01_geometry-1.ipynb')
    >>> owner(("Jane Doe_4711_assignsubmission_file_", "01_geometry.ipynb"), {})
    ('Jane Doe_4711', '01_geometry.ipynb')
    >>> owner(("jane", "01_geometry", "01_geometry.ipynb"), {})
    ('jane', '01_geometry.ipynb')
    """
    first, name = unzipped(place[0]), place[-1]
    if first in owners:
        return owners[first], name
    if (moodle := MOODLE.match(first)) is not None:
        return f"{moodle['student']}_{moodle['id']}", name
    if (canvas := CANVAS.match(first)) is not None:
        return f"{canvas['student']}_{canvas['id']}", canvas["file"] if len(place) == 1 else name
    return (first if len(place) > 1 else PurePosixPath(first).stem), name


def unzipped(name: str) -> str:
    """A name without the ending of a zip."""
    return name[: -len(".zip")] if name.lower().endswith(".zip") else name


def assignment_of(name: str, file: Found, known: list[str]) -> str:
    """The assignment that a file answers: by its name, by its folder, else by the marks of its cells; "" where none fits."""
    stem = COPIED.sub("", PurePosixPath(name).stem)
    for candidate in (stem, *map(unzipped, reversed(file.place[:-1]))):
        if candidate in known:
            return candidate
    starts = [candidate for candidate in known if stem.lower().startswith(candidate.lower())]
    if starts:
        return max(starts, key=len)
    return by_marks(file.data, known)


def by_marks(data: bytes, known: list[str]) -> str:
    """The assignment most of whose questions stand in a notebook's marks."""
    from .questions import assignment

    try:
        cells = notebook_in(data)["cells"]
        marks = {cell["metadata"]["nbgrader"]["grade_id"] for cell in cells if "nbgrader" in cell.get("metadata", {})}
    except (UnreadableSubmission, KeyError, TypeError, AttributeError):
        return ""
    shared = {name: sum(asked.exercise.name in marks for asked in assignment(name).questions) for name in known}
    best = max(known, key=lambda name: shared[name], default="")
    return best if best and shared[best] else ""


def gradescope_owners(files: Iterable[Found]) -> dict[str, str]:
    """Whose each folder of a Gradescope export is, by the submission_metadata.yml beside them and no other, since a student may
    hand in one too: submission_12345 -> the first submitter's id.
    """
    import yaml

    owners: dict[str, str] = {}
    for file in files:
        if file.place == (METADATA,) and len(file.data) < MOST_BYTES:
            try:
                about = yaml.safe_load(file.data)
                entries = {str(key): value[":submitters"][0] for key, value in about.items()}
                owners |= {key: str(one.get(":sid") or one.get(":email") or one[":name"]) for key, one in entries.items()}
            except (yaml.YAMLError, AttributeError, KeyError, TypeError, IndexError, RecursionError):
                continue
    return owners


def without_doubles(submissions: list[Submission]) -> Iterator[Submission]:
    """Two files of one student for one assignment: neither is chosen, both are named; the same bytes twice are one."""
    groups: dict[tuple[str, str], list[Submission]] = {}
    for one in submissions:
        groups.setdefault((one.student, one.assignment), []).append(one)
    for group in groups.values():
        if len({one.data for one in group}) == 1 or not group[0].assignment:
            yield from group[: 1 if group[0].assignment else None]
        else:
            files = ", ".join([*(one.file for one in group[:MOST_NAMED]), *["..."] * (len(group) > MOST_NAMED)])
            yield group[0]._replace(data=b"", file=files, trouble=f"handed in more than once, with differences: {files}; leave one")
