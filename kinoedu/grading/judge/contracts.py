"""Contracts of each student's own, such as which way a bug turns or which parent a node takes.

A program that is right for one student is wrong for another, so a copy does not pass. A student's
contract follows from the course's secret and the student's id, both at release and at grading.
"""

import hashlib
import hmac
import logging
from collections.abc import Callable, Iterable
from string import ascii_uppercase

from ...course.exercise import Exercise
from ...course.lessons import find
from ...course.section import Choices, choose_for_section
from ...errors import InvalidParameter
from ...support.csv_cells import one_line
from ..assignments.questions import Assignment, read_assignment
from ..collect.marks import find_contracts
from ..collect.notebook import UnreadableSubmission
from ..collect.submissions import Submission

MARK = b"variant="  # stands in a notebook with contracts of its student
OTHER_VARIANTS = (
    "the checks of %d of %d notebooks ask for other variants than those of their students, such as "
    "that of %s; an answer that is right for another variant gets no points. Were they copied? Or "
    "were ids spelled otherwise, or another secret used, when the variants were released?"
)
log = logging.getLogger("kinoedu")


def choose_contract(exercise: Exercise, secret: bytes, student: str) -> str:
    """The contract of a student; upper case, spaces and the spelling of accents do not matter."""
    text = f"variant:{exercise.name}:{one_line(student).casefold()}"
    digest = hmac.digest(secret, text.encode("utf-8", "surrogatepass"), hashlib.sha256)
    return exercise.variants[int.from_bytes(digest) % len(exercise.variants)]


def choose_contracts(task: Assignment, secret: bytes, student: str) -> Choices:
    """A student's contracts for those questions of an assignment that have any."""
    exercises = [one.exercise for one in task.questions if one.exercise.variants]
    return tuple(
        (exercise.name, choose_contract(exercise, secret, student)) for exercise in exercises
    )


def apply_contracts(task: Assignment, chosen: Choices) -> Assignment:
    """The assignment with a student's contracts."""
    mine = dict(chosen)
    named = ((one, one.exercise.name) for one in task.questions)
    return task._replace(
        questions=tuple(
            one._replace(exercise=find(name, mine.get(name, ""))) for one, name in named
        )
    )


def leave_usual(found: list[Submission]) -> list[Submission]:
    """The submissions of a folder, to be graded in the usual form or in that of their section.

    Raises
    ------
    InvalidParameter
        Where most of the notebooks ask for variants.
    """
    refuse_forgotten(one for one in found if not one.letter)
    return [set_apart(one) for one in found]


def vary(found: list[Submission], secret: bytes) -> list[Submission]:
    """The submissions of a folder with each student's contracts; those of a section keep theirs.

    Raises
    ------
    InvalidParameter
        Where no notebook of an assignment asks for variants.
    """
    varied = [one if one.letter else add_contracts(one, secret) for one in found]
    refuse_usual(one for one in varied if not one.letter)
    warn_of_other_variants(one for one in varied if not one.letter)
    return varied


def add_contracts(one: Submission, secret: bytes) -> Submission:
    """The submission with its student's contracts."""
    return (
        one._replace(
            variants=choose_contracts(read_assignment(one.assignment), secret, one.student)
        )
        if one.assignment
        else one
    )


def warn_of_other_variants(submissions: Iterable[Submission]) -> None:
    """Log a warning if checks ask for other contracts than those that their students have.

    What a check asks for changes no score, but the student has read it.
    """
    varied = [one for one in submissions if one.variants and not one.trouble]
    others = [one for one in varied if not asks_for_its_own(one)]
    if others:
        log.warning(OTHER_VARIANTS, len(others), len(varied), others[0].student)


def asks_for_its_own(one: Submission) -> bool:
    """Whether the checks in a notebook ask for the contracts of its student."""
    try:
        return agree(find_contracts(one.data), one.variants)
    except UnreadableSubmission:
        return True  # it is listed with this trouble


def agree(asked: set[tuple[str, str]], chosen: Choices) -> bool:
    """Whether checks ask for some of the contracts, and for no others."""
    return bool(asked) and asked <= set(chosen)


def advise_instructor(options: str) -> str:
    """What an instructor can do about a notebook of another section."""
    return f"grade it apart, {options}" if options else "grade it apart"


def add_section(
    one: Submission, letter: str, advise: Callable[[str], str] = advise_instructor
) -> Submission:
    """The submission with the contracts of a section, "" for the usual form.

    One that is no notebook, or whose checks ask for other contracts, has that trouble and no score.

    Parameters
    ----------
    advise : what the reader of that trouble can do, from the options that grade the notebook.

    Raises
    ------
    InvalidParameter
        Where an exercise has no variant of that letter.
    """
    if not letter or not one.assignment or one.trouble:
        return one._replace(letter=letter)
    exercises = [question.exercise for question in read_assignment(one.assignment).questions]
    chosen = choose_for_section(exercises, letter)
    try:
        asked = find_contracts(one.data)
    except UnreadableSubmission as error:
        return one._replace(letter=letter, trouble=str(error))
    if chosen and not agree(asked, chosen):
        one = one._replace(trouble=explain_other_section(asked, exercises, letter, advise))
    return one._replace(letter=letter, variants=chosen)


def set_apart(one: Submission, advise: Callable[[str], str] = advise_instructor) -> Submission:
    """The submission, to be graded in the usual form.

    A section's or a student's own notebook, whose checks all ask for contracts, has that trouble
    and no score; `advise` as in `add_section`.
    """
    if one.letter or not one.assignment or one.trouble or MARK not in one.data:
        return one
    exercises = [question.exercise for question in read_assignment(one.assignment).questions]
    try:
        asked = find_contracts(one.data)
    except UnreadableSubmission as error:
        return one._replace(trouble=str(error))
    varied = {each.name for each in exercises if each.variants}
    if varied and varied <= {question for question, _ in asked}:
        return one._replace(trouble=explain_other_section(asked, exercises, "", advise))
    return one


def explain_other_section(
    asked: set[tuple[str, str]],
    exercises: list[Exercise],
    letter: str,
    advise: Callable[[str], str],
) -> str:
    """Why a notebook of another section has no score; the letter is "" for the usual form."""
    if not asked:
        return (
            f"its checks ask for the usual form, and this section has variant {letter}: "
            f"{advise('without --variant')}"
        )
    theirs = {
        ascii_uppercase[one.variants.index(name)]
        for one in exercises
        for question, name in asked
        if question == one.name and name in one.variants
    }
    which = theirs.pop() if len(theirs) == 1 else ""
    names = ", ".join(f"{question}: {name}" for question, name in sorted(asked))
    options = f"with --variant {which}" if which else "" if letter else "with --variants"
    return (
        f"its checks ask for {f'variant {which}' if which else 'other variants'} ({names}), and "
        f"this section has {f'variant {letter}' if letter else 'the usual form'}: {advise(options)}"
    )


def refuse_usual(submissions: Iterable[Submission]) -> None:
    """Raise InvalidParameter if none of several notebooks of an assignment asks for a variant.

    Call it where each student has contracts of their own.
    """
    asks: dict[str, list[bool]] = {}
    for one in submissions:
        if one.variants and not one.trouble:
            asks.setdefault(one.assignment, []).append(MARK in one.data)
    usual = sorted(name for name, marks in asks.items() if len(marks) > 1 and not any(marks))
    if usual:
        raise InvalidParameter(
            f"no notebook of {' and of '.join(usual)} asks for variants, so right answers would "
            "get no points: grade what was handed out in the usual form without --variants, each "
            "with its --assignment; all may go into the same folder of grades"
        )


def refuse_forgotten(submissions: Iterable[Submission]) -> None:
    """Raise InvalidParameter if most notebooks hold contracts.

    Call it where notebooks are graded without `--variants` and `--variant`.
    """
    readable = [one for one in submissions if not one.trouble]
    if 2 * sum(MARK in one.data for one in readable) > len(readable):
        raise InvalidParameter(
            "these notebooks ask for variants of exercises: grade them with --variants if each "
            "student has their own, or with --variant and the letter of their section"
        )
