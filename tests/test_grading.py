"""Grading: programs are isolated and judged outside, and each submission is graded once."""

import io
import json
import os
import re
import shutil
import sys
import unicodedata
import zipfile
from pathlib import Path

import numpy as np
import pytest
from submissions import notebook

from kinoedu.course.lessons import find
from kinoedu.course.release import assignments
from kinoedu.errors import InvalidParameter
from kinoedu.grading.assignments.questions import draw_cases, read_assignment
from kinoedu.grading.collect.left_out import find_left_out
from kinoedu.grading.collect.notebook import (
    MOST_BYTES,
    Cell,
    UnreadableSubmission,
    python_of,
    read_cells,
)
from kinoedu.grading.collect.notebook_python import PythonReader
from kinoedu.grading.collect.submissions import collect, warn_of_same
from kinoedu.grading.judge import answers
from kinoedu.grading.judge.submission import find_syntax_errors, grade
from kinoedu.grading.sandbox import sandbox
from kinoedu.grading.sandbox.sandbox import Sandbox

NO_SANDBOX = sandbox.explain_no_sandbox()
HOUSE = Path(__file__).resolve().parent.parent
SECRET = b"a secret of the tests, no course's"
ANSWER = "def line_through_points(p1, p2):\n    pass\n"
needs_sandbox = pytest.mark.skipif(bool(NO_SANDBOX), reason=NO_SANDBOX or "there is one")


@pytest.fixture(scope="module")
def box():
    """One sandbox for all tests of this file."""
    one = Sandbox()
    yield one
    one.close()


def graded(box: Sandbox, *sources: str) -> dict:
    """The questions of lesson 1 by name, for these code cells."""
    record = grade(notebook(*sources), read_assignment("01_geometry"), SECRET, box)
    return {question["question"]: question for question in record["questions"]} | {
        "cells": record["cells"]
    }


@needs_sandbox
@pytest.mark.parametrize("name", assignments())
def test_a_right_notebook_has_every_point(box, name):
    """Every assignment can be graded, and its solution is right on hidden cases too."""
    record = grade(
        (HOUSE / "solutions" / f"{name}.ipynb").read_bytes(), read_assignment(name), SECRET, box
    )
    assert all(question["score"] == question["max_score"] > 0 for question in record["questions"])
    assert record["cells"] == []


@needs_sandbox
def test_an_exercise_that_nobody_answered_has_none(box):
    data = (HOUSE / "exercises" / "01_geometry.ipynb").read_bytes()
    record = grade(data, read_assignment("01_geometry"), SECRET, box)
    assert {question["status"] for question in record["questions"]} == {"not answered"}


GOOD = """
import numpy as np
def point_line_distance(q, p1, p2):
    if (p1 == p2).all():
        raise ValueError("one point")
    d = (p2 - p1) / np.linalg.norm(p2 - p1)
    return abs(d[0] * (q - p1)[1] - d[1] * (q - p1)[0])
"""


ROOM = """
from kinoedu.course.lessons.shared.planned import problem_of
square = {"kind": "polygons", "boundary": [[0, 0], [10, 0], [10, 10], [0, 10]], "obstacles": []}
ends = {"start": [1, 1], "goal": [9.5, 9.5]}
room = problem_of({"robot": {"kind": "point"}, "world": square, **ends})
def exposing_room():
    return room.start, room.goal, [(8, 10.5), (10.5, 8), (10.5, 8.2)]
"""


@needs_sandbox
def test_a_problem_can_be_made_where_no_question_gives_one(box):
    """A program that looks for the answer to "break it" makes problems of its own."""
    record = grade(notebook(ROOM), read_assignment("09_trees"), SECRET, box)
    (found,) = (one for one in record["questions"] if one["question"] == "exposing_room")
    assert found["status"] == "right", found["message"]


GARAGE = """
import numpy as np
from kinoedu.course.drivable import drivable
car = {"kind": "car", "length": 30, "width": 10, "wheelbase": 20, "speeds": [-1, 0.5, 2]}
square = {"kind": "polygons", "boundary": [[0, 0], [200, 0], [200, 200], [0, 200]]}
room = drivable({"robot": car, "world": square, "start": [70, 100, 0], "goal": [88, 100, 0]})
def heading_distance(a, b, radian):
    scale = np.array([room.radian / radian, room.radian / radian, 1.0])
    return room.distance(a * scale, b * scale) / scale[0]
"""


@needs_sandbox
def test_the_distance_of_a_lent_problem_answers_no_exercise(box):
    """The function that heading_distance asks for is not there where it is judged."""
    record = grade(notebook(GARAGE), read_assignment("13_kinodynamic_planning"), SECRET, box)
    (found,) = (one for one in record["questions"] if one["question"] == "heading_distance")
    assert found["status"] == "wrong"


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
def test_an_answer_above_the_cell_for_it_is_not_lost_to_the_placeholder(box):
    """One who adds a cell above it has run only the own cell; a syntax error is told there too."""
    placeholder = "def {}(q, p1, p2):\n    'The distance.'\n    raise NotImplementedError()\n"
    broken = "def point_segment_distance(q, p1, p2)\n    return 1\n"
    below = map(placeholder.format, ("point_line_distance", "point_segment_distance"))
    result = graded(box, GOOD, broken, *below)
    assert result["point_line_distance"]["status"] == "right"
    assert result["point_segment_distance"]["status"] == "syntax error"


@needs_sandbox
@pytest.mark.parametrize("experiment", ["while True:\n    pass", "for _ in range(9):\n    wait()"])
def test_an_experiment_that_takes_too_long_does_not_lose_the_function_above_it(
    box, monkeypatch, experiment
):
    """Hidden cases are asked of the function that the cell had before it was stopped."""
    monkeypatch.setattr(answers, "CELL_SECONDS", 0.5)
    wait = "def wait():\n    for _ in range(10**9):\n        pass\n"
    result = graded(box, f"{wait}\n{GOOD}\n{experiment}\n1 / 0")
    assert result["point_line_distance"]["status"] == "right"
    assert [cell["line"] for cell in result["cells"]] == [13]


@needs_sandbox
@pytest.mark.parametrize("end", ["os._exit(0)", "os.abort()"])
def test_a_cell_that_ends_python_keeps_its_functions(box, end):
    """Also where a busy computer had to stop it from outside; the cell is listed all the same."""
    result = graded(box, f"import os\n{GOOD}\n{end}\nx = 1", "raise KeyError", end)
    assert result["point_line_distance"]["status"] == "right"
    listed = [(one["cell"], one["trouble"]["kinds"][0]) for one in result["cells"]]
    assert listed == [(1, "Stopped"), (2, "KeyError"), (3, "Stopped")]


@needs_sandbox
def test_a_function_that_is_not_there_again_is_not_called_right(box, monkeypatch):
    """Such as one that a program defines by chance: the hidden cases are not known."""
    monkeypatch.setattr(answers.Run, "ask_hidden", lambda *_: None)
    question = graded(box, GOOD)["point_line_distance"]
    assert (question["status"], question["score"]) == ("wrong", 0.0)
    assert "hidden cases could not be tried" in question["message"]


@needs_sandbox
def test_a_wrong_answer_of_several_numbers_is_described(box):
    """An array cannot be compared with other outcomes by ==; its rule, hint and case are told."""
    wrong = "import numpy as np\ndef line_through_points(p1, p2):\n    return np.ones(3)"
    found = graded(box, wrong)["line_through_points"]
    assert (found["status"], found["failure"]["outcome"]["kind"]) == ("wrong", "Answer")


HELPED = """
def dist(a, b):
    return np.linalg.norm(a - b)
def point_segment_distance(q, p1, p2):
    way = p2 - p1
    t = np.dot(q - p1, way) / np.dot(way, way) if way.any() else 0.0
    return dist(q, p1 + min(max(t, 0.0), 1.0) * way)
"""


@needs_sandbox
@pytest.mark.parametrize(
    "below",
    [
        "def dist(q, a, b):\n    return point_segment_distance(q, a, b)",
        "from numpy import *",
        "from math import dist as d, hypot as dist",
        "point_segment_distance = point_segment_distance(np.ones(2), np.zeros(2), np.ones(2))",
        "def point_segment_distance(q, p1, p2):\n    return 0  # a first draft",
        "def dist(q):\n    pass\nfor i in range(10**10):\n    pass",
    ],
    ids=["helper", "star", "import", "result", "draft", "helper and a slow experiment"],
)
def test_what_changes_below_a_check_costs_nothing_above_it(box, monkeypatch, below):
    """Run from top to bottom, the notebook's check calls it right."""
    monkeypatch.setattr(answers, "CELL_SECONDS", 1.0)
    result = graded(box, GOOD, HELPED, "check(point_segment_distance)", below, "1 / 0")
    assert result["point_segment_distance"]["status"] == "right"
    assert result["point_line_distance"]["status"] == "right"
    assert [one["cell"] for one in result["cells"]][-1] == 5


@needs_sandbox
def test_a_helper_that_is_mended_below_a_check_counts(box):
    """Functions are called after all cells have run; the better result counts."""
    late, wrong = HELPED.split("def point")[0], HELPED.replace("a - b", "a + b")
    result = graded(box, GOOD, wrong, "check(point_segment_distance)", late)
    assert result["point_segment_distance"]["status"] == "right"


@needs_sandbox
def test_a_syntax_error_is_called_one_in_its_own_question(box):
    """Of a function that is defined again, only the last definition counts."""
    first = "%time\ndef point_segment_distance(q, a, b)\n    return 0\n"
    later = "def line_through_points(p):\n    return (p\n"
    result = graded(box, first, f"\ndef helper(:\n    pass\n{later}", later[:-10])
    for name, words in (
        ("point_segment_distance", "expected ':' (line 2 of cell 1)"),
        ("line_through_points", "after function definition on line 1 (line 2 of cell 3)"),
    ):
        assert (result[name]["status"], result[name]["score"]) == ("syntax error", 0.0)
        assert words in result[name]["message"] and name in result[name]["message"]
    assert result["polygon_tangent"]["status"] == "not answered"


@needs_sandbox
@pytest.mark.parametrize(("more", "is_newer"), [(0, False), (1, True), (-1, False)])
def test_a_syntax_error_may_be_what_a_newer_python_knows(more, is_newer):
    """Such as quotes of one kind in those of an f-string; the notebook says its Python."""
    major, minor = sys.version_info[:2]
    book = json.loads(notebook("def line_through_points(p):\n    return (p\n"))
    book["metadata"] = {"language_info": {"version": f"{major}.{minor + more}.1"}}
    data = json.dumps(book).encode()
    (message,) = find_syntax_errors(read_cells(data), python_of(data)).values()
    assert (f"graded again with Python {major}.{minor + more}." in message) == is_newer


@needs_sandbox
@pytest.mark.parametrize("more", [0, 1])
def test_a_grade_of_what_a_newer_python_wrote_names_the_python_that_graded(box, more):
    """So that another Python grades it again."""
    major, minor = sys.version_info[:2]
    book = {**json.loads(notebook(ANSWER)), "metadata": {"language_info": {}}}
    book["metadata"]["language_info"]["version"] = f"{major}.{minor + more}.0"
    result = grade(json.dumps(book).encode(), read_assignment("01_geometry"), SECRET, box)
    assert result.get("python") == (f"{major}.{minor}" if more else None)


@pytest.mark.parametrize(
    "metadata",
    [5, {}, {"language_info": []}, {"language_info": {"version": 3.14}}]
    + [
        {"language_info": {"version": text}} for text in ("", "new", "3", "9" * 5000 + ".1", "3.1٣")
    ],
)
def test_a_notebook_that_does_not_say_its_python_is_read(metadata):
    data = json.dumps({"nbformat": 4, "cells": [], "metadata": metadata}).encode()
    assert python_of(data) in ((), (3, 1))


def test_what_is_asked_for_is_not_lent_and_a_message_says_so(box):
    result = graded(
        box,
        "import kinoedu as ke\ndef point_line_distance(q, a, b): return "
        "ke.geometry.point_line_distance(q, a, b)",
    )
    failed = result["point_line_distance"]
    assert failed["score"] == 0.0
    assert "not lent" in failed["failure"]["outcome"]["message"]


def test_a_solution_lends_what_it_imports_in_whatever_form(tmp_path):
    """In parentheses, under another name, and beside a command; nothing that an answer imports."""
    (tmp_path / "solutions").mkdir()
    book = notebook(
        "from kinoedu.geometry import (\n    point_in_polygon,\n    convex_hull as hull,  # c\n)",
        "%matplotlib inline\nfrom kinoedu.graphs import Graph  # given",
        "from kinoedu.course import check\nfrom kinoedu.figures.flowcharts import Step",
        "def answer(polygon):\n    from kinoedu.geometry import cross_sign\n",
    )
    (tmp_path / "solutions" / "16_own.ipynb").write_bytes(book)
    assert read_assignment("16_own", tmp_path).lent == (
        "kinoedu.geometry:point_in_polygon",
        "kinoedu.geometry:convex_hull",
        "kinoedu.graphs:Graph",
    )


@pytest.mark.parametrize(
    "line",
    [
        "import kinoedu as ke",
        "from kinoedu import rrt",
        "import kinoedu.geometry",
        "from kinoedu.graphs import *",
    ],
)
def test_a_solution_with_an_import_that_lends_nothing_is_refused(tmp_path, line):
    """Right answers that use it would get no points, though `check` accepts them."""
    (tmp_path / "solutions").mkdir()
    book = notebook("import kinoedu.figures", "import numpy as np\n" + line)
    (tmp_path / "solutions" / "16_own.ipynb").write_bytes(book)
    with pytest.raises(InvalidParameter, match=re.escape(line)):
        read_assignment("16_own", tmp_path)


NEVER_BEYOND = """
import numpy as np
def point_segment_distance(q, p1, p2):
    d = p2 - p1
    t = min(max((q - p1) @ d / max(d @ d, 1e-300), 0.0), 1.0)
    while t == 1.0 and tuple(q) not in SHOWN:
        pass
    return float(np.hypot(*(q - p1 - t * d)))
"""


@needs_sandbox
def test_who_never_answers_one_kind_keeps_the_points_of_the_others(box):
    """Hidden cases come in an order that nobody knows: those of other kinds are asked again."""
    cases = draw_cases("point_segment_distance", SECRET)
    shown = [tuple(case.given["q"].tolist()) for case in cases.cases[: cases.seen]]
    data = notebook(f"SHOWN = {shown}", NEVER_BEYOND)
    record = grade(data, read_assignment("01_geometry"), SECRET, box, patience=0.2)
    (found,) = (one for one in record["questions"] if one["question"] == "point_segment_distance")
    assert (found["kinds"], found["late"]) == (["beyond_p2"], True)
    assert found["passed"] == [
        kind for kind in find(found["question"]).kinds if kind != "beyond_p2"
    ]


@needs_sandbox
def test_hidden_cases_do_not_show():
    known = draw_cases("point_line_distance", SECRET)
    assert 0 < known.seen < len(known.cases)


@pytest.mark.parametrize(
    ("name", "seeds"), [("bug1", (1031, 1058, 1088, 1112, 1187)), ("bug_base", (1042, 1132, 1171))]
)
def test_no_secret_makes_a_right_bug_wrong(name, seeds):
    """The worlds of these seeds once cost the course's own solution a point.

    The bug grazed an obstacle there, or it was unclear which way back is shorter.
    """
    book = json.loads((HOUSE / "solutions" / "02_bug_algorithms.ipynb").read_text(encoding="utf-8"))
    given = [cell for cell in book["cells"] if cell["cell_type"] == "code"]
    sources = [
        "".join(cell["source"])
        for cell in given
        if cell["id"] == "cell-01" or "".join(cell["source"]).startswith("def ")
    ]
    program: dict = {}
    exec("\n".join(sources), program)
    exercise = find(name)
    for seed in seeds:
        for case in exercise.cases(np.random.default_rng(seed)):
            assert exercise.find_violation(case.given, program[name](**case.given)) is None, seed


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
        b'{"nbformat": 4, "cells": [' + b"[]," * 2**22 + b"[]]}",
        b'{"nbformat": 4, "cells": [' + b"1" * 10_000 + b"]}",
    ],
)
def test_what_is_no_notebook_is_refused_by_name(data):
    with pytest.raises(UnreadableSubmission):
        read_cells(data)


def test_submissions_are_found_as_they_are_laid_out(tmp_path):
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
        data = notebook("x = 1" if "lunch" in place else ANSWER)
        (tmp_path / place).write_bytes(data + b" " * ("again" in place))
    found = {one.student: one for one in collect(tmp_path)}
    assert sorted(found) == ["Dora Doe_99", "ann", "bob", "doecarl_123", "eve", "fay", "gil"]
    assert "more than once" in found["eve"].trouble
    assert "no notebook" in found["fay"].trouble
    assert "no assignment" in found["gil"].trouble
    assert {one.assignment for name, one in found.items() if name not in ("fay", "gil")} == {
        "01_geometry"
    }


@pytest.mark.parametrize(
    ("place", "student", "is_late"),
    [
        ("Dora Doe_99_assignsubmission_file_{}", "Dora Doe_99", False),
        ("Dora_99_assignsubmission_file_Al_7_assignsubmission_file_{}", "Dora_99", False),
        ("doe_xcarl_LATE_123_456_{}", "doe_xcarl_123", True),
        ("doe_xcarl_123_456_{}", "doe_xcarl_123", False),
        ("anon_x7Yz2_456_{}", "anon_x7Yz2", False),
        ("LATE_anon_12345_456_{}", "anon_12345", True),
    ],
)
def test_the_files_of_a_flat_download_are_those_of_one_student(tmp_path, place, student, is_late):
    """From Moodle without folders, and from Canvas for odd names and for anonymous grading."""
    for name in ("01_geometry", "02_bug_algorithms"):
        file = tmp_path / place.format(f"{name}.ipynb")
        file.write_bytes((HOUSE / "exercises" / f"{name}.ipynb").read_bytes())
    assert [(one.student, one.assignment, one.late, one.trouble) for one in collect(tmp_path)] == [
        (student, "01_geometry", is_late, ""),
        (student, "02_bug_algorithms", is_late, ""),
    ]


def test_a_students_name_is_the_same_however_accents_are_spelled(tmp_path):
    """macOS spells them apart in names of files, and does not mark them as UTF-8 in a zip."""
    apart = unicodedata.normalize("NFD", "Jürgen Groß_4711")
    for name in (unicodedata.normalize("NFC", apart), apart):
        (tmp_path / "class" / name).mkdir(parents=True)
        (tmp_path / "class" / name / "01_geometry.ipynb").write_bytes(notebook(ANSWER))
    marked = f"{apart}/01_geometry.ipynb".encode()
    with zipfile.ZipFile(tmp_path / "mac.zip", "w") as archive:
        archive.writestr("?" * len(marked), notebook(ANSWER))
        archive.writestr("ann/01_geometry.ipynb", notebook(ANSWER))
    data = (tmp_path / "mac.zip").read_bytes().replace(b"?" * len(marked), marked)
    (tmp_path / "mac.zip").write_bytes(data)
    for place, others in (("class", []), ("mac.zip", ["ann"])):
        assert sorted(one.student for one in collect(tmp_path / place)) == [
            "Jürgen Groß_4711",
            *others,
        ]


def test_who_was_late_is_known_from_canvas(tmp_path):
    """From the mark before the file's name, also if it is no notebook.

    A student's own file of such a name has no effect.
    """
    for place in (
        "doecarl_LATE_123_456_01_geometry-2.ipynb",
        "roeann_124_457_01_geometry.ipynb",
        "poejim_LATE_125_458_notes.pdf",
        "leezoe_126_459_01_geometry.zip/poejim_LATE_1_2_01_geometry.ipynb",
    ):
        (tmp_path / place).parent.mkdir(exist_ok=True)
        (tmp_path / place).write_bytes(notebook(ANSWER))
    assert {one.student: one.late for one in collect(tmp_path)} == {
        "doecarl_123": True,
        "roeann_124": False,
        "poejim_125": True,
        "leezoe_126": False,
    }


def test_a_zip_of_gradescope_is_read_as_it_was_downloaded(tmp_path):
    """It has one outer folder, and a list of the owners beside the submissions."""
    about = "".join(
        f"submission_{n}:\n  :submitters:\n  - :sid: '{sid}'\n" for n, sid in ((1, "77"), (2, "88"))
    )
    with zipfile.ZipFile(tmp_path / "export.zip", "w") as archive:
        archive.writestr("assignment_9_export/submission_metadata.yml", about)
        for n in (1, 2):
            archive.writestr(
                f"assignment_9_export/submission_{n}/01_geometry.ipynb",
                notebook(f"{ANSWER}x = {n}"),
            )
    found = collect(tmp_path / "export.zip")
    assert [(one.student, one.assignment, one.trouble) for one in found] == [
        ("77", "01_geometry", ""),
        ("88", "01_geometry", ""),
    ]


@pytest.mark.parametrize(
    ("places", "is_told"),
    [
        (("out/in/ann/", "out/in/bob/"), True),
        (("a/ann/", "a/bob/", "b/cy/"), True),
        (("ann/", "bob/", "ann/copy of "), False),
        (("Al_4711_assignsubmission_file_/new/", "Al_4711_assignsubmission_file_/old/"), False),
    ],
)
def test_equal_files_that_count_once_are_named_where_students_may_have_them(
    tmp_path, caplog, places, is_told
):
    """In a class one folder too deep, what several students hand in empty is equal."""
    for place in places:
        (tmp_path / f"{place}x").parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / f"{place}01_geometry.ipynb").write_bytes(notebook(ANSWER))
    warn_of_same(collect(tmp_path))
    assert ("if they are of several students" in caplog.text) == is_told
    assert (f"{places[0]}01_geometry.ipynb, {places[1]}" in caplog.text) == is_told


def test_one_assignment_of_several(tmp_path):
    """Other assignments are skipped; students who handed in nothing else are listed."""
    for place, source in (
        ("ann/01_geometry.ipynb", ANSWER),
        ("ann/02_bug_algorithms.ipynb", "check(bug1)"),
        ("bob/homework.ipynb", ANSWER),
        ("cy/02_bug_algorithms.ipynb", "check(bug1)"),
    ):
        (tmp_path / place).parent.mkdir(exist_ok=True)
        (tmp_path / place).write_bytes(notebook(source))
    found = {one.student: one for one in collect(tmp_path, "01_geometry")}
    assert {one.assignment for one in found.values()} == {"01_geometry"}
    assert [found[name].trouble for name in ("ann", "bob")] == ["", ""]
    assert "it is for 02_bug_algorithms" in found["cy"].trouble


def test_nobody_hands_in_for_another(tmp_path):
    """A student's files stay the student's, whatever their names or contents claim."""
    data, other = notebook(ANSWER), notebook(ANSWER + "x = 2")
    box = io.BytesIO()
    with zipfile.ZipFile(box, "w") as archive:
        archive.writestr("../bob/01_geometry.ipynb", other)
        archive.writestr("bob_12_34_01_geometry.ipynb", other)
        archive.writestr("/Bob_12_assignsubmission_file_/01_geometry.ipynb", other)
    files = {
        "bob/01_geometry.ipynb": data,
        "eve/bob_123_456_01_geometry.ipynb": other,
        "fay/Bob_12_assignsubmission_file_/01_geometry.ipynb": other,
        "gil/submission_metadata.yml": b"{bob: {':submitters': [{':sid': nobody}]}, "
        b"gil: {':submitters': [{':sid': bob}]}}",
        "gil/01_geometry.ipynb": other,
        "hal/hal.zip": box.getvalue(),
    }
    for place, content in files.items():
        (tmp_path / "class" / place).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "class" / place).write_bytes(content)
    found = {one.student: one for one in collect(tmp_path)}
    assert sorted(found) == ["bob", "eve", "fay", "gil", "hal"]
    assert (found["bob"].data, found["bob"].trouble) == (data, "")
    assert {path.name for path in tmp_path.rglob("*") if path.is_file()} == {
        Path(place).name for place in files
    }


@pytest.mark.parametrize(
    ("place", "student"),
    [
        ("mallory_LATE_7_8_hw.zip/bob_99/01_geometry.ipynb", "mallory_7"),
        ("mallory_LATE_7_8_hw.zip/bob_99_1_01_geometry.ipynb", "mallory_7"),
        ("mal.zip/bob/cy/01_geometry.ipynb", "mal"),
        ("Mal_4711_assignsubmission_file_/Bob Lee_12/01_geometry.ipynb", "Mal_4711"),
        ("submission_7/submission_8/01_geometry.ipynb", "submission_7"),
        ("mal/bob/01_geometry.ipynb", "mal"),
        ("mal/bob.zip/cy/01_geometry.ipynb", "mal"),
    ],
)
def test_who_hands_in_alone_hands_in_for_nobody_else(tmp_path, place, student):
    """Late work, for example: a class of one student."""
    box, inside, name = place.rpartition(".zip/")
    file = tmp_path / "class" / (f"{box}.zip" if inside else place)
    file.parent.mkdir(parents=True)
    data = notebook(ANSWER)
    if inside:
        with zipfile.ZipFile(file, "w") as archive:
            archive.writestr(name, data)
    else:
        file.write_bytes(data)
    assert [one.student for one in collect(tmp_path / "class")] == [student]


def test_what_breaks_a_reader_is_reported_by_name_and_the_rest_is_read(tmp_path):
    """Links, pipes, zip bombs, an empty folder, and paths that lead upwards."""
    bomb, deep = io.BytesIO(), io.BytesIO()
    with zipfile.ZipFile(bomb, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("01_geometry.ipynb", b" " * (MOST_BYTES + 10))
    with zipfile.ZipFile(deep, "w") as archive:
        archive.writestr("inner.zip", bomb.getvalue())
    for student in ("ann", "bob", "cat", "dan", "eve", "fay", "gil"):
        (tmp_path / student).mkdir()
    (tmp_path / "secret.txt").write_text("the secret")
    (tmp_path / "ann" / "01_geometry.ipynb").write_bytes(notebook(ANSWER))
    (tmp_path / "bob" / "01_geometry.ipynb").symlink_to(tmp_path / "ann" / "01_geometry.ipynb")
    (tmp_path / "cat" / "01_geometry.zip").write_bytes(bomb.getvalue())
    (tmp_path / "dan" / "01_geometry.zip").write_bytes(b"PK\x03\x04 cut off")
    (tmp_path / "eve" / "01_geometry.ipynb").mkdir()
    os.mkfifo(tmp_path / "fay" / "01_geometry.ipynb")
    (tmp_path / "gil" / "01_geometry.ipynb").symlink_to("/dev/zero")
    found = {one.student: one for one in collect(tmp_path)}
    assert found["ann"].trouble == ""
    troubled = {name for name, one in found.items() if one.trouble}
    assert troubled == {"bob", "cat", "dan", "eve", "fay", "gil"}
    assert all(one.data == b"" for one in found.values() if one.trouble)


@needs_sandbox
def test_the_order_of_a_set_of_words_is_no_matter_of_chance():
    """Two sandboxes compute the same hash of a word."""
    messages = []
    for _ in range(2):
        box = Sandbox()
        (cell,) = graded(box, "raise ValueError(hash('kinoedu'))")["cells"]
        messages.append(cell["trouble"]["message"])
        box.close()
    assert messages[0] == messages[1]


@needs_sandbox
def test_a_python_that_is_a_copy_is_shut_in_too(tmp_path, monkeypatch):
    """The copy is not in the sandbox, so the Python that it was copied from is used."""
    monkeypatch.setattr(
        sys, "executable", shutil.copy(os.path.realpath(sys.executable), tmp_path / "python")
    )
    assert sandbox.explain_no_sandbox() == ""


@pytest.mark.parametrize("seed", [5038, 5073, 5489])
def test_no_secret_makes_a_right_tree_give_up_early(seed):
    """With half as many failures in a row the course's own solution lost a point on these."""
    exercise = find("rrt_on_terrain")
    case = next(case for case in exercise.cases(np.random.default_rng(0)) if case.kind == "sealed")
    given = {**case.given, "rng": seed}
    nodes, _, path = exercise.source(*given.values())
    assert path is None and len(nodes) >= 45 and given["failures"] >= 80


@needs_sandbox
def test_the_line_that_failed_is_shown_also_below_a_page_break(box):
    """A page break ends no line of Python."""
    (trouble,) = graded(box, "# \x0c\x0c\nraise ValueError('here')")["cells"]
    assert trouble["line"] == 2
    assert trouble["trouble"]["lines"] == ["line 2: raise ValueError('here')"]


def test_a_long_line_is_long_also_with_page_breaks_in_it():
    """The work of reading commands is bounded by the longest line as Python counts lines."""
    reader = PythonReader()
    reader.read("%time f\n" * 20 + "x = '" + "a\x0c" * 8000 + "'\n")
    assert reader.work_left < 0


def test_the_zip_of_a_class_may_be_larger_than_a_notebook(tmp_path):
    """A class of a few hundred students with pictures has more than a hundred MB."""
    with zipfile.ZipFile(tmp_path / "class.zip", "w") as archive:
        archive.writestr("ann/01_geometry.ipynb", notebook(ANSWER))
        archive.writestr("bob/01_geometry.ipynb", notebook(ANSWER))
        archive.writestr("bob/picture.png", bytes(MOST_BYTES))
    assert [(one.student, one.trouble) for one in collect(tmp_path / "class.zip")] == [
        ("ann", ""),
        ("bob", ""),
    ]


def test_commands_that_were_left_out_are_told_in_their_order():
    """One within a loop stands before one that follows the loop."""
    source = "for i in range(2):\n    get_ipython().system('one')\nget_ipython().system('two')"
    told = [(one.line, one.command) for one in find_left_out([Cell(1, source)])]
    assert told == [(2, "!one"), (3, "!two")]
