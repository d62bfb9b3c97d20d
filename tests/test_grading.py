"""Grading: programs are shut in, judged outside, and a class is graded once whatever happens."""

import json
from pathlib import Path

import pytest

from kinoedu.grading import sandbox
from kinoedu.grading.grading import grade
from kinoedu.grading.notebook import UnreadableSubmission, cells_in
from kinoedu.grading.questions import assignment, cases_of
from kinoedu.grading.sandbox import Sandbox
from kinoedu.grading.submissions import collect

NO_SANDBOX = sandbox.why_not()
HOUSE = Path(__file__).resolve().parent.parent
SECRET = b"a secret of the tests, no course's"
needs_sandbox = pytest.mark.skipif(bool(NO_SANDBOX), reason=NO_SANDBOX or "there is one")


def notebook(*sources: str) -> bytes:
    """A notebook of cells of code."""
    cells = [{"cell_type": "code", "metadata": {}, "outputs": [], "execution_count": None, "source": source} for source in sources]
    return json.dumps({"nbformat": 4, "nbformat_minor": 5, "metadata": {}, "cells": cells}).encode()


@pytest.fixture(scope="module")
def box():
    """One sandbox for these tests."""
    one = Sandbox()
    yield one
    one.close()


def graded(box: Sandbox, *sources: str) -> dict:
    """The questions of lesson 1 by name, for cells of code."""
    record = grade(notebook(*sources), assignment("01_geometry"), SECRET, box)
    return {question["question"]: question for question in record["questions"]} | {"cells": record["cells"]}


@needs_sandbox
def test_a_right_notebook_has_every_point(box):
    data = (HOUSE / "solutions" / "01_geometry.ipynb").read_bytes()
    record = grade(data, assignment("01_geometry"), SECRET, box)
    assert all(question["score"] == question["max_score"] > 0 for question in record["questions"])
    assert record["cells"] == []


@needs_sandbox
def test_an_exercise_that_nobody_answered_has_none(box):
    data = (HOUSE / "exercises" / "01_geometry.ipynb").read_bytes()
    record = grade(data, assignment("01_geometry"), SECRET, box)
    assert {question["status"] for question in record["questions"]} == {"not answered"}


GOOD = """
import numpy as np
def point_line_distance(q, p1, p2):
    if (p1 == p2).all():
        raise ValueError("one point")
    d = (p2 - p1) / np.linalg.norm(p2 - p1)
    return abs(d[0] * (q - p1)[1] - d[1] * (q - p1)[0])
"""


@needs_sandbox
@pytest.mark.parametrize(
    "bad",
    [
        "1 / 0",
        "def f(:",
        "raise SystemExit",
        "import os\nos._exit(0)",
        "def f(): f()\nf()",
        "check = None\nprint('x' * 10**7)",
    ],
)
def test_a_cell_that_fails_does_not_lose_the_others(box, bad):
    result = graded(box, bad, GOOD)
    assert result["point_line_distance"]["score"] == 5.0
    assert result["point_segment_distance"]["status"] == "not answered"


@needs_sandbox
def test_what_is_asked_for_is_withheld_with_a_message(box):
    result = graded(box, "import kinoedu as ke\ndef point_line_distance(q, a, b): return ke.geometry.point_line_distance(q, a, b)")
    failed = result["point_line_distance"]
    assert failed["score"] == 0.0
    assert "withheld" in failed["failure"]["outcome"]["message"]


@needs_sandbox
def test_hidden_cases_do_not_show():
    known = cases_of("point_line_distance", SECRET)
    assert 0 < sum(known.seen) < len(known.cases)


@pytest.mark.parametrize(
    "data",
    [
        b"",
        b"{",
        b"[]",
        b"null",
        b'{"nbformat": 3, "cells": []}',
        b'{"nbformat": 4, "cells": 7}',
        b"\xff\xfe",
        b"[" * 100_000,
        b"PK\x03\x04",
    ],
)
def test_what_is_no_notebook_is_refused_by_name(data):
    with pytest.raises(UnreadableSubmission):
        cells_in(data)


def test_submissions_are_found_as_they_are_laid_out(tmp_path):
    data = notebook("x = 1")
    for place in (
        "ann/01_geometry.ipynb",
        "bob/01_geometry/01_geometry.ipynb",
        "doecarl_LATE_123_456_01_geometry-2.ipynb",
        "Dora Doe_99_assignsubmission_file_/01_geometry.ipynb",
        "eve/01_geometry.ipynb",
        "eve/again/01_geometry (1).ipynb",
        "fay/notes.txt",
        "gil/lunch.ipynb",
    ):
        (tmp_path / place).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / place).write_bytes(data + b" " * ("again" in place))
    found = {one.student: one for one in collect(tmp_path)}
    assert sorted(found) == ["Dora Doe_99", "ann", "bob", "doecarl_123", "eve", "gil"]
    assert "more than once" in found["eve"].trouble
    assert "no assignment" in found["gil"].trouble
    assert {one.assignment for name, one in found.items() if name != "gil"} == {"01_geometry"}
