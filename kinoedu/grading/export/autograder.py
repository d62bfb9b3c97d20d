"""The program in Gradescope's container: it grades ROOT/submission into ROOT/results/results.json.

The judges are those of `kinoedu grade`, and so is the sandbox if the container allows one. If it
does not, and the instructor trusts the container instead, programs run as a user that the system
does not know. They can neither write what the grader reads nor read the course's secret, but they
see Gradescope's other files and whatever network the container has.
"""

import json
import os
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from ...course.feedback import format_entry
from ...errors import InvalidParameter
from ...messages import get_message
from ...support.whole_files import written_whole
from ..assignments.questions import read_assignment
from ..collect.found import read_files
from ..collect.marks import count_shared, find_assignment, find_questions
from ..collect.notebook import UnreadableSubmission
from ..collect.submissions import Submission, describe_place, is_candidate, list_some
from ..judge.contracts import add_section, set_apart
from ..judge.running import grade_all, use_local_workers
from ..judge.submission import RIGHT, Grade
from ..report.failures import explain_failure
from ..report.rows import Row
from ..sandbox.sandbox import explain_no_sandbox
from .tables import make_gradescope_results

Results = dict[str, Any]  # JSON data in Gradescope's format


def autograde(
    root: Path, name: str, secret: bytes, *, container_is_wall: bool = False, letter: str = ""
) -> Results:
    """Grade the one submission for an assignment, write the results, and return them.

    Errors that the student can correct, such as a file that is no notebook, are reported in the
    results and give no points.

    Parameters
    ----------
    letter : the variant of the section, such as B, or "" for the usual form.

    Raises
    ------
    InvalidParameter
        Where the machine fails. Nothing is written then, so that Gradescope reports a failure and
        gives no score.
    """
    found = find_submission(root / "submission", name)
    one = set_apart(add_section(found, letter, advise_student), advise_student)
    with tempfile.TemporaryDirectory() as results:
        graded = grade_all(
            [one],
            Path(results),
            secret,
            place=use_local_workers(1),
            trusted=is_trusted(container_is_wall),
        )[0]
    if graded.grade is None and not one.trouble:
        raise InvalidParameter(
            f"this could not be graded, and has no score: {graded.trouble}; run it again"
        )
    answer = make_results(name, graded.grade, one.trouble)
    with written_whole(root / "results" / "results.json") as part:
        part.write_text(json.dumps(answer, indent=1) + "\n", encoding="ascii")
    return answer


def advise_student(_: str) -> str:
    """What a student can do about a notebook of another section."""
    return get_message("gradescope.other_section")


def is_trusted(container_is_wall: bool) -> bool:
    """Whether to run without a sandbox: there is none, and the container takes its place.

    Raises InvalidParameter where there is no sandbox and the container may not take its place.
    """
    reason = explain_no_sandbox()
    if not reason:
        return False
    if not container_is_wall:
        raise InvalidParameter(
            f"submissions cannot be shut in here: {reason}. If this container is wall enough, "
            "pack with --trust-container"
        )
    if os.geteuid() != 0:
        raise InvalidParameter(
            "without a sandbox the grader must be root, so that programs can be run as somebody "
            "else"
        )
    return True


def find_submission(folder: Path, name: str) -> Submission:
    """The notebook in a folder: the one with answers and of that name, or else the only one.

    Where there is none, or several, the submission has that trouble.
    """
    found = [file for file in read_files(folder) if is_candidate(file)] if folder.is_dir() else []
    answered = [file for file in found if count_answers(file.data, name)]
    named = [file for file in found if find_assignment(file.place[-1], file.place, {}, [name])]
    mine = [file for file in answered if file in named] or answered or named or found
    if not mine:
        return Submission("", name, "", b"", get_message("gradescope.nothing", name=name))
    if len({file.data for file in mine}) > 1:
        names = list_some([describe_place(file) for file in mine])
        return Submission("", name, names, b"", get_message("gradescope.several", names=names))
    one = Submission("", name, describe_place(mine[0]), mine[0].data, mine[0].trouble)
    if not one.trouble and count_answers(one.data, name) == 0:
        return one._replace(trouble=get_message("gradescope.wrong_file", name=name))
    return one


def count_answers(data: bytes, name: str) -> int | None:
    """How many questions of the assignment a notebook's cells are about; None if unreadable."""
    try:
        return count_shared(find_questions(data), [name])[name]
    except UnreadableSubmission:
        return None


def make_results(name: str, record: Grade | None, trouble: str) -> Results:
    """The results as Gradescope shows them, with a test for each question.

    A submission that cannot be read has no tests, and the reason as its output.
    """
    if record is None or record["status"] == "unreadable":
        why = trouble if record is None else record["message"]
        return {
            "score": 0.0,
            "visibility": "visible",
            "output": get_message("gradescope.unreadable", why=why),
            "tests": [],
        }
    results = make_gradescope_results(make_row(name, question) for question in record["questions"])
    by_hand = read_assignment(name).by_hand
    output = [get_message("gradescope.by_hand", names=", ".join(by_hand))] if by_hand else []
    if record["cells"]:
        numbers = ", ".join(str(one["cell"]) for one in record["cells"])
        output.append(get_message("gradescope.cells", numbers=numbers))
    return {**results, "output": "\n".join(output), "stdout_visibility": "hidden"}


def make_row(name: str, question: Grade) -> Row:
    """A question's row, whose message holds all that its student may know."""
    message = "\n".join([question["message"], *list_messages(question)])
    scores = (question["score"], question["max_score"])
    return Row("", name, question["question"], *scores, question["status"], message)


def list_messages(question: Grade) -> Iterator[str]:
    """Yield the smallest case that failed, unless it is hidden, and the hint."""
    if question["status"] != RIGHT:
        for title, text in explain_failure(question):
            yield format_entry(title, text)
