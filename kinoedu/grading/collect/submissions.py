"""Find whose each file is, in a folder of submissions.

The folder may be laid out by nbgrader, Canvas, Moodle or Gradescope, or by hand:

    student/assignment.ipynb, student/assignment/assignment.ipynb    by hand, nbgrader
    name_12345_67890_file.ipynb, name_LATE_12345_67890_file.ipynb    Canvas
    anon_a1B2c_67890_file.ipynb, LATE_anon_a1B2c_67890_file.ipynb    Canvas, graded anonymously
    Full Name_12345_assignsubmission_file_/file.ipynb                Moodle
    Full Name_12345_assignsubmission_file_file.ipynb                 Moodle, without folders
    submission_12345/file.ipynb beside submission_metadata.yml       Gradescope

Each of these folders may be a zip, and so may a student's file.
"""

import logging
import re
from collections.abc import Iterable, Iterator
from pathlib import Path, PurePosixPath
from typing import NamedTuple

from ...course.release import HOUSE, assignments
from ...errors import InvalidParameter
from ...support.csv_cells import one_line
from .found import METADATA, Found, read_files
from .gradescope import read_submitters
from .marks import choose_most_shared, count_shared, find_assignment, find_questions, strip_zip
from .notebook import UnreadableSubmission

CANVAS = re.compile(
    r"^(?:(?P<late_anonymous>late_)?(?P<anonymous>anon_[^_]+)"
    r"|(?P<student>.+?)_(?P<late>late_)?(?P<id>\d+))_\d+_(?P<file>.+)$",
    re.IGNORECASE,
)
MOODLE = re.compile(
    r"^(?P<student>.+?)_(?P<id>\d+)_assignsubmission_(?:file|onlinetext)(?:_?|_(?P<file>.+))$"
)
GRADESCOPE = re.compile(r"^submission_\d+$")
EXPORTED = re.compile(r"^assignment_\d+_export$")  # Gradescope's folder of all submissions
NAMELESS = "unnamed"  # a folder whose name is of spaces
NO_ANSWERS = "has none of the functions that it asks for"
LONGEST_NAME, MOST_NAMED = 300, 5  # characters of a path, files in a message
SAME = (
    "equal files in several folders of one student count once: %s; if they are of several "
    "students, grade the folder in which each has a folder"
)
Groups = dict[str, list[str]]  # the students of each folder of a Gradescope export
log = logging.getLogger("kinoedu")


class Submission(NamedTuple):
    """What a student handed in: the bytes of a notebook, or the trouble with it.

    file : where it was found, for people to read.
    variants : the student's own contracts, as pairs of a question and a name, if the class has any.
    late : whether Canvas marked it as late.
    letter : the variant of the student's section, such as B, if all of them have one.
    same : its file, and the equal ones that count as this one; empty where they are not merged.
    """

    student: str
    assignment: str
    file: str
    data: bytes
    trouble: str = ""
    variants: tuple[tuple[str, str], ...] = ()
    late: bool = False
    letter: str = ""
    same: tuple[str, ...] = ()


def collect(folder: Path, only: str = "", house: Path = HOUSE) -> list[Submission]:
    """All submissions in a folder or zip, ordered by student and assignment.

    Every file that may be a submission is returned. A file has a `trouble` if it cannot be read,
    was handed in twice, or belongs to no assignment. A student who handed in files but no notebook
    has a submission with that trouble.

    Parameters
    ----------
    only : the one assignment to collect, or "" for all.
    house : the folder of the course.

    Raises
    ------
    InvalidParameter
        Where there is no such folder or no such assignment.
    UnreadableSubmission
        Where `folder` is a file that cannot be read.
    """
    if not folder.exists():
        raise InvalidParameter(f"there is no folder {folder}")
    known = assignments(house)
    if only and only not in known:
        raise InvalidParameter(f"there is no assignment {only!r}; there are: {', '.join(known)}")
    found = remove_outer_folders(list(read_files(folder)), known)
    groups = read_gradescope_groups(found)
    submissions = [
        one
        for file in found
        if is_candidate(file)
        for one in make_submissions(file, groups, known, only, house)
    ]
    have = {one.student for one in submissions}
    submissions += find_missing_notebooks(found, have, groups, known)
    mine = (refuse_unknown(one, known) for one in submissions)
    merged = merge_doubles(select_assignment(only, submissions) if only else mine)
    return sorted(merged, key=lambda one: (one.student, one.assignment, one.file))


def remove_outer_folders(files: list[Found], known: list[str]) -> list[Found]:
    """The files without the outer folders that hold all of them.

    The first name of a place then comes from the instructor. All later names may come from the
    student, so they never decide whose a file is. A zip, a folder that Canvas, Moodle or Gradescope
    named after a submission, and a folder of assignments or of a single other folder belong to one
    student, and are not removed. Gradescope's metadata stands beside the folders and does not
    count.
    """
    places = [file.place for file in files if not file.place[-1].startswith(".")]
    if any(GRADESCOPE.match(place[1]) for place in places if len(place) > 2):
        places = [place for place in places if place[1:] != (METADATA,)]
    while (
        places
        and all(len(place) > 2 for place in places)
        and len({place[0] for place in places}) == 1
    ):
        outer, below = places[0][0], {place[1] for place in places}
        if is_of_one_student(outer) or below <= set(known):
            break
        if len(below) == 1 and not EXPORTED.match(outer):
            break
        places = [place[1:] for place in places]
        files = [file._replace(place=file.place[1:] or file.place) for file in files]
    return files


def is_of_one_student(name: str) -> bool:
    """Whether a file or folder with this name holds what one student handed in."""
    stem = strip_zip(name)
    return stem != name or any(form.match(stem) for form in (CANVAS, MOODLE, GRADESCOPE))


def is_candidate(file: Found) -> bool:
    """Whether a file may be a submission: a notebook, or a file that could not be opened."""
    return file.place[-1].lower().endswith(".ipynb") or (
        bool(file.trouble) and not file.place[-1].startswith(".")
    )


def make_submissions(
    file: Found, groups: Groups, known: list[str], only: str, house: Path
) -> Iterator[Submission]:
    """Yield the submission in a file once for each student who handed it in."""
    one = make_submission(file, known, only, house)
    for student in find_owners(file.place, groups):
        yield one._replace(student=student)


def make_submission(file: Found, known: list[str], only: str, house: Path) -> Submission:
    """The submission in a file, with its student and its assignment ("" if unknown).

    A file is the wrong one if it has no cell of the assignment that it is named like, such as a
    lesson in place of its exercise, unless `only` asks for another assignment whose cells it has.
    """
    student, name = find_owner(file.place)
    try:
        questions, readable = find_questions(file.data), True
    except UnreadableSubmission:
        questions, readable = set(), False
    shared = count_shared(questions, known, house)
    named, best = find_assignment(name, file.place, shared, known), choose_most_shared(shared)
    one = Submission(
        student, named, describe_place(file), file.data, file.trouble, late=is_marked_late(file)
    )
    assignment = named or only
    if not readable or not assignment or shared[assignment]:
        return one
    if best and only == best:
        return one._replace(assignment=best)
    finding = f"its cells are those of {best}" if best else f"it {NO_ANSWERS}"
    trouble = f"it is handed in for {assignment}, but {finding}: is it the wrong file?"
    return one._replace(trouble=trouble)


def is_marked_late(file: Found) -> bool:
    """Whether Canvas marked a file as late, as in doejane_LATE_1234_56789_file.ipynb.

    The other systems do not mark late files.
    """
    canvas = CANVAS.match(strip_zip(file.place[0]))
    return canvas is not None and any((canvas["late"], canvas["late_anonymous"]))


def describe_place(file: Found) -> str:
    """Where a file was found, on one line of limited length."""
    return one_line("/".join(file.place)[-LONGEST_NAME:])


def find_missing_notebooks(
    found: list[Found], have: set[str], groups: Groups, known: list[str]
) -> list[Submission]:
    """One submission with a trouble for each student who handed in files but no notebook."""
    rest: dict[str, list[Found]] = {}
    for file in found:
        if len(file.place) > 1 or any(form.match(file.place[0]) for form in (CANVAS, MOODLE)):
            for student in find_owners(file.place, groups):
                rest.setdefault(student, []).append(file)
    lost = []
    for student, files in rest.items():
        if student not in have:
            named = find_assignment(files[0].place[-1], files[0].place, {}, known)
            finding = list_some(list(dict.fromkeys(map(describe_place, files))))
            late = any(map(is_marked_late, files))
            lost.append(
                Submission(
                    student,
                    named,
                    finding,
                    b"",
                    "there is no notebook in what was handed in",
                    late=late,
                )
            )
    return lost


def refuse_unknown(one: Submission, known: list[str]) -> Submission:
    """The submission, with a trouble if it has no assignment."""
    if one.assignment or one.trouble:
        return one
    names = ", ".join(known)
    trouble = f"it answers no assignment that is known; its name should begin with one of: {names}"
    return one._replace(trouble=trouble)


def select_assignment(only: str, submissions: list[Submission]) -> Iterator[Submission]:
    """The submissions that answer, or may answer, one assignment.

    A student who handed in other assignments only gets a submission with that trouble.
    """
    answered = {one.student for one in submissions if one.assignment in ("", only)}
    for one in submissions:
        if one.assignment in ("", only):
            yield one._replace(assignment=only)
        elif one.student not in answered:
            yield one._replace(
                assignment=only,
                data=b"",
                trouble=f"it is for {one.assignment}, and {only} is what is graded",
            )


def find_owners(place: tuple[str, ...], groups: Groups) -> list[str]:
    """The students whose file this is, several for a group on Gradescope."""
    return groups.get(strip_zip(place[0])) or [find_owner(place)[0]]


def find_owner(place: tuple[str, ...]) -> tuple[str, str]:
    """The student named by a place, and the file's own name without the system's prefix.

    The student's name is on one line and has no two spaces in a row, as in every table.

    >>> find_owner(("doejane_LATE_1234_56789_01_geometry-1.ipynb",))
    ('doejane_1234', '01_geometry-1.ipynb')
    >>> find_owner(("Jane Doe_4711_assignsubmission_file_", "01_geometry.ipynb"))
    ('Jane Doe_4711', '01_geometry.ipynb')
    >>> find_owner(("Jane Doe_4711_assignsubmission_file_01_geometry.ipynb",))
    ('Jane Doe_4711', '01_geometry.ipynb')
    >>> find_owner(("jane", "01_geometry", "01_geometry.ipynb"))
    ('jane', '01_geometry.ipynb')
    """
    first, name = strip_zip(place[0]), place[-1]
    student = first if len(place) > 1 else PurePosixPath(first).stem
    if (moodle := MOODLE.match(first)) is not None:
        student = f"{moodle['student']}_{moodle['id']}"
        name = (moodle["file"] or name) if len(place) == 1 else name
    elif (canvas := CANVAS.match(first)) is not None:
        student = canvas["anonymous"] or f"{canvas['student']}_{canvas['id']}"
        name = canvas["file"] if len(place) == 1 else name
    return one_line(student) or NAMELESS, name


def read_gradescope_groups(files: Iterable[Found]) -> Groups:
    """The ids of the submitters for each folder of a Gradescope export.

    Only the submission_metadata.yml beside the folders is read, since a student may hand in a file
    of that name too.
    """
    lists = [file.data for file in files if file.place == (METADATA,)]
    return {
        folder: [one_line(submitter.id) or NAMELESS for submitter in group]
        for data in lists
        for folder, group in read_submitters(data).items()
    }


def merge_doubles(submissions: Iterable[Submission]) -> Iterator[Submission]:
    """Merge equal files of one student for one assignment; refuse different ones.

    Where the files differ, none is chosen: one submission has a trouble that lists all of them.
    Files without answers, such as lessons, do not count beside others.
    """
    groups: dict[tuple[str, str], list[Submission]] = {}
    for one in submissions:
        groups.setdefault((one.student, one.assignment), []).append(one)
    for files in groups.values():
        group = [one for one in files if NO_ANSWERS not in one.trouble] or files
        if not group[0].assignment:
            yield from group
        elif len({one.data for one in group}) == 1:
            yield group[0]._replace(same=tuple(one.file for one in group))
        else:
            names = list_some([one.file for one in group])
            wrong = (
                f"handed in more than once, with differences: {names}; leave one, or, if they are "
                "of several students, grade the folder in which each has a folder"
            )
            yield group[0]._replace(
                data=b"", file=names, trouble=wrong, late=any(one.late for one in group)
            )


def warn_of_same(submissions: Iterable[Submission]) -> None:
    """Log a warning for students whose equal files lie in several folders.

    Each of these may be a student's, if the class lies deeper than it should. The folders in what
    Canvas, Moodle or Gradescope named, and those in a zip, are of one student.
    """
    for one in submissions:
        above = {PurePosixPath(file).parent for file in one.same}
        if len(above) > 1 and not is_of_one_student(one.file.partition("/")[0]):
            log.warning(SAME, list_some(list(one.same)))


def list_some(names: list[str]) -> str:
    """The first few names, as one text."""
    return ", ".join(names[:MOST_NAMED] + ["..."] * (len(names) > MOST_NAMED))
