"""Tables, pages and exports of graded submissions.

They are safe, equal on every run, and reveal no hidden case.
"""

import csv
import hashlib
import io
import json
import re
import shutil
import sys
import time
import zipfile
from concurrent.futures import Executor, Future, ThreadPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from datetime import UTC, datetime
from pathlib import Path

import pytest

from kinoedu.cli import main
from kinoedu.cli.export import read_back_from_nbgrader
from kinoedu.compiled.store import try_lock
from kinoedu.course.assignments import list_assignments
from kinoedu.course.lessons import EXERCISES, find
from kinoedu.course.release import assignments
from kinoedu.errors import InvalidParameter
from kinoedu.grading import class_grading
from kinoedu.grading.assignments.questions import read_assignment
from kinoedu.grading.collect import handing_in
from kinoedu.grading.collect.found import METADATA
from kinoedu.grading.collect.handing_in import find_functions, hand_in
from kinoedu.grading.collect.marks import count_shared, find_questions
from kinoedu.grading.collect.names import find_name, read_gradescope_names, read_names
from kinoedu.grading.collect.notebook import Cell, UnreadableSubmission
from kinoedu.grading.collect.submissions import Submission, collect
from kinoedu.grading.export import nbgrader_course
from kinoedu.grading.export.freshness import list_old_exports, note_export, renew_export
from kinoedu.grading.export.tables import (
    export_canvas,
    export_csv,
    export_gradescope,
    find_canvas_students,
    make_gradescope_test,
)
from kinoedu.grading.judge import running
from kinoedu.grading.judge.class_list import (
    LOCK,
    Class,
    Entry,
    add_earlier,
    digest_submission,
    locked_class,
    make_entry,
    read_class,
    warn_of_replaced,
    write_class,
)
from kinoedu.grading.judge.running import grade_all, use_local_workers, write_result
from kinoedu.grading.regrading import explain_change, find_changes
from kinoedu.grading.report import writing
from kinoedu.grading.report.decisions import read_decisions
from kinoedu.grading.report.failures import explain_failure
from kinoedu.grading.report.feedback_page import file_name, name_page
from kinoedu.grading.report.rows import Row, list_class_rows
from kinoedu.grading.report.writing import write_all
from kinoedu.grading.sandbox import sandbox
from kinoedu.messages import get_message
from kinoedu.support.csv_cells import escape_formula, unescape_formula

HOUSE = Path(__file__).resolve().parent.parent
NAME, HAND = "01_geometry", "02_bug_algorithms"
QUESTIONS = sum(exercise.lesson == NAME for exercise in EXERCISES.values())
POINTS = {one.exercise.name: one.points for one in read_assignment(NAME).questions}
TOTAL = f"{sum(POINTS.values()):g}"
NO_SANDBOX = sandbox.explain_no_sandbox()
needs_sandbox = pytest.mark.skipif(bool(NO_SANDBOX), reason=NO_SANDBOX or "there is one")
HOSTILE = "</pre></style><script>alert(1)</script>"
COLUMNS = "student,assignment,question,score,comment\n"
ANNS = "ann,01_geometry,exposing_case,{},\n"


def question(name: str, score: float, most: float, **more) -> dict:
    """A question's record, as `grade` makes it."""
    status = "right" if score == most else "partly right" if score else "wrong"
    return {
        "question": name,
        "score": score,
        "max_score": most,
        "status": status,
        "message": "Right.",
        "failure": None,
        "late": False,
    } | more


def record(name: str = NAME, *, share: float = 1.0, message: str = "A rule.") -> dict:
    """The record of a graded notebook with a fraction of each question's points."""
    return {
        "status": "graded",
        "message": "",
        "questions": [
            question(
                one.exercise.name,
                share * one.points,
                one.points,
                message="Right." if share == 1.0 else message,
            )
            for one in read_assignment(name).questions
        ],
        "cells": [],
    }


def a_class(
    out: Path,
    records: dict[str, dict | None],
    name: str = NAME,
    troubles: dict[str, str] | None = None,
) -> Class:
    """A class as `grade_class` leaves it."""
    (out / "results").mkdir(parents=True, exist_ok=True)
    entries = []
    for number, (student, kept) in enumerate(sorted(records.items())):
        entries.append(
            Entry(student, name, f"{student}.ipynb", str(out), "", student, f"key{number}", "")
        )
        if kept is not None:
            write_result(out / "results" / f"key{number}.json", kept)
    entries += [
        Entry(student, name, "x.ipynb", str(out), "", student, "", why)
        for student, why in (troubles or {}).items()
    ]
    of = Class(out, "secret", "mark", False, entries)
    write_class(of)
    return of


def table(file: Path) -> list[dict[str, str]]:
    """A CSV file as rows by column name."""
    return list(csv.DictReader(io.StringIO(file.read_text(encoding="utf-8"))))


def failing() -> dict:
    """A record with a failure that everybody may see, whose texts hold HTML."""
    given = {"q": [2.0, 3.0], "p1": [0.0, 0.0], "p2": [4.0, 0.0]}
    raised = {
        "kind": "Raised",
        "kinds": ["RuntimeError"],
        "message": HOSTILE,
        "lines": [f"line 2: {HOSTILE}"],
        "function": "f",
    }
    failure = {
        "case": {"kind": find("point_line_distance").kinds[0], "given": given},
        "outcome": raised,
        "number": 0,
        "slip": "",
    }
    one = record()
    names = [question["question"] for question in one["questions"]]
    one["questions"][names.index("point_line_distance")] |= {
        "score": 0.0,
        "status": "wrong",
        "message": f"A rule {HOSTILE}",
        "hint": f"A hint {HOSTILE}",
        "failure": failure,
        "reason": "rules.raised",
    }
    one["cells"] = [{"cell": 3, "trouble": raised}]
    return one


def test_a_comment_alone_is_said_beside_what_the_grader_says(tmp_path):
    """It is on the student's page, in the table and in the report, and changes no score."""
    of = a_class(tmp_path, {"ann": failing()})
    lines = f"ann,{NAME},point_line_distance,,see <me>\nann,{NAME},exposing_case,,well done\n"
    (tmp_path / "overrides.csv").write_text(COLUMNS + lines, encoding="utf-8")
    write_all(of)
    page = (tmp_path / name_page("ann", NAME)).read_text(encoding="utf-8")
    assert "see &lt;me&gt;" in page and "A rule" in page and "well done" in page
    report = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert "see &lt;me&gt;" in report and "well done" in report
    rows = {
        row["question"]: (row["score"], row["message"]) for row in table(tmp_path / "grades.csv")
    }
    assert (rows["point_line_distance"], rows["exposing_case"]) == (
        ("0", "see <me>"),
        ("3", "well done"),
    )


def test_late_submissions_are_marked(tmp_path):
    """In the report, which also counts them, and on the student's own page."""
    of = a_class(tmp_path, {"ann": record(), "bob": record()}, troubles={"cy": "the file is empty"})
    of = of._replace(entries=[entry._replace(late=entry.student != "ann") for entry in of.entries])
    write_class(of)
    write_all(read_class(tmp_path))
    report = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert "2 handed in late." in report and report.count("</a> late") == 2
    pages = {
        name: (tmp_path / "feedback" / name / f"{NAME}.html").read_text(encoding="utf-8")
        for name in ("ann", "bob")
    }
    assert "late" not in pages["ann"].partition("</style>")[2]
    assert "late" in pages["bob"].partition("</style>")[2]


def test_cells_of_a_table_are_no_formulas():
    """No spreadsheet computes a cell, and its text can be restored."""
    for text in ("=1+1", "+1", "-1", "@x", "'=x", "\t=x", "\n@x", " =x"):
        assert escape_formula(text)[0] == "'", text
    for text in ("ann", "=ann", "'tis", "O'Hara", "'=x", ""):
        assert unescape_formula(escape_formula(text)) == text


def test_every_question_has_a_row_and_trouble_is_no_zero(tmp_path):
    """Submissions that were not graded have no scores but a reason.

    The number of rows is questions times students.
    """
    of = a_class(tmp_path, {"=ann": record(), "bob": None}, troubles={"cy": "the file is empty"})
    write_all(of)
    rows = table(tmp_path / "grades.csv")
    ann, bob, cy = (
        [row for row in rows if row["student"] == name] for name in ("'=ann", "bob", "cy")
    )
    assert len(ann) == len(bob) == len(cy) == QUESTIONS
    assert {(row["score"], row["status"]) for row in bob} == {("", "not graded")}
    assert {row["score"] for row in cy} == {""}
    assert {(row["status"], row["message"]) for row in cy} == {("unreadable", "the file is empty")}
    assert sum(float(row["score"]) for row in ann) == sum(POINTS.values())


def test_the_same_class_is_written_in_the_same_bytes(tmp_path):
    """Also when it is written again, and whether its pictures are kept or drawn."""
    of = a_class(tmp_path, {"ann": failing(), "bob": failing(), "cy": record(share=0.5)})
    write_all(of)
    once = {file: file.read_bytes() for file in tmp_path.rglob("*") if file.is_file()}
    assert len(list((tmp_path / "pictures").iterdir())) == 1
    write_all(of)
    assert {file: file.read_bytes() for file in tmp_path.rglob("*") if file.is_file()} == once


def test_pages_escape_whatever_they_are_told(tmp_path):
    """A program's message, a student's name and a comment are plain text on every page.

    The picture is there as well.
    """
    student = f"<img src=x onerror=alert(1)>{HOSTILE}"
    write_all(a_class(tmp_path, {student: failing(), "\ud800": record()}, troubles={"cy": HOSTILE}))
    pages = [tmp_path / "report.html", *(tmp_path / "feedback").rglob("*.html")]
    assert len(pages) == 4
    for page in pages:
        text = page.read_text(encoding="utf-8")
        assert "<script" not in text and "<img src=x" not in text
        assert text.count("</style>") == 1
    page = (tmp_path / name_page(student, NAME)).read_text(encoding="utf-8")
    assert "data:image/png;base64," in page and "np.array([2.0, 3.0])" in page and "Cell 3" in page


def test_a_failure_names_what_to_read_again():
    """The section, and the hint; only the hint where the case cannot be read."""
    (wrong,) = (one for one in failing()["questions"] if one["failure"])
    section = (get_message("check.read"), find(wrong["question"]).message("section"))
    hint = (get_message("check.hint"), wrong["hint"])
    assert {section, hint} <= {*explain_failure(wrong)}
    wrong["failure"]["case"] = {}
    assert hint in explain_failure(wrong) and section not in explain_failure(wrong)


def test_a_picture_that_cannot_be_drawn_loses_no_page(tmp_path):
    """A record whose case does not have the exercise's shape gives neither case nor picture."""
    broken = failing()
    for one in broken["questions"]:
        if one["failure"]:
            one["failure"]["case"]["given"] = {"q": "?"}
    write_all(a_class(tmp_path, {"ann": broken}))
    assert "data:image" not in (tmp_path / name_page("ann", NAME)).read_text(encoding="utf-8")


def test_file_names_are_safe_and_apart():
    """No two students share a page, even on disks that ignore case; no name leaves the folder."""
    names = ["ann", "Ann", "ANN", "../ann", "a/b", "a\\b", "", ".", "..", "con", "nul.txt"]
    names += ["ann.", "ann ", "Zoë", "Zoe", "x" * 300, "\udcff"]
    names += [file_name(name).lower() for name in names if file_name(name) != name]
    made = [file_name(name).lower() for name in names]
    assert len(set(made)) == len(names)
    for name in made:
        assert 0 < len(name) < 64 and name.isascii()
        assert name[0] not in ".-" and not set(name) & set("/\\: ")


def test_overrides_hold_and_are_never_written(tmp_path):
    """A person's score and comment are in the table, on the page and in exports.

    The file with these decisions stays as it is.
    """
    of = a_class(tmp_path, {"ann": record(share=0.0), "bob": record()})
    text = "\ufeffstudent,assignment,question,score,comment\r\n"
    text += "ann,01_geometry,exposing_case,2.5,seen <b>it</b>\r\n"
    text += "bob,01_geometry,exposing_case,,well done\r\n"
    (tmp_path / "overrides.csv").write_text(text, encoding="utf-8", newline="")
    rows = {row[:3]: row for row in write_all(of)}
    assert rows["ann", NAME, "exposing_case"].score == 2.5
    assert rows["ann", NAME, "exposing_case"].status == "set by hand"
    assert rows["bob", NAME, "exposing_case"].score == POINTS["exposing_case"]
    assert "seen &lt;b&gt;it" in (tmp_path / name_page("ann", NAME)).read_text(encoding="utf-8")
    assert "well done" in (tmp_path / name_page("bob", NAME)).read_text(encoding="utf-8")
    export_csv(list(rows.values()), tmp_path / "totals.csv")
    assert [row[NAME] for row in table(tmp_path / "totals.csv")] == ["2.5", TOTAL]
    by_hand = COLUMNS + "".join(f"{name},{NAME},exposing_case,1,\n" for name in ("ann", "bob"))
    (tmp_path / "by_hand.csv").write_text(by_hand, encoding="utf-8")
    assert [row.score for row in write_all(of) if row.question == "exposing_case"] == [2.5, 1.0]
    assert (tmp_path / "overrides.csv").read_bytes().decode("utf-8") == text


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("student,question,score\n", "no column 'assignment'"),
        (COLUMNS + ANNS.format("much"), "line 2"),
        (COLUMNS + ANNS.format("nan"), "a score is a number"),
        (COLUMNS + ANNS.format("-1"), "a score is a number"),
        (COLUMNS + ANNS.format("1") + ANNS.format("2"), "leave one"),
        (COLUMNS + "ann,01_geometry,exposing,1,\n", "no row for ann"),
    ],
    ids=["no column", "no number", "not finite", "negative", "twice", "no such question"],
)
def test_a_wrong_override_is_refused_by_its_line(tmp_path, text, message):
    """No decision is ignored silently."""
    of = a_class(tmp_path, {"ann": record()})
    (tmp_path / "overrides.csv").write_text(text, encoding="utf-8")
    with pytest.raises(InvalidParameter, match=message):
        write_all(of)


CANVAS = f"""Student,ID,SIS User ID,SIS Login ID,Section,01 Geometry (991),Other (5)
    Points Possible,,,,,{TOTAL},10
"Doe, Ann",11,,ann,S1,,3
"Roe, Bob",12,,bob,S1,7,
"Poe, Cy",13,,cy,S1,6,
"Poe, Dee",14,,same,S1,,
"Moe, Eve",15,,same,S1,,
"""


def test_only_names_and_numbers_of_students_are_names_for_canvas():
    """Bob's section is called like Ann's login, and his grade like her number."""
    lines = [
        ["Student", "ID", "SIS Login ID", "Section", "Other (5)"],
        ["Doe, Ann", "11", "ann", "S1", "3"],
        ["Roe, Bob", "12", "bob", "ann", "11"],
    ]
    found = find_canvas_students(lines)
    assert all(found[name] == lines[1] for name in ("doe, ann", "11", "ann", "doeann_11"))
    assert not {"s1", "3"} & {*found}


def test_canvas_gets_its_own_table_back(tmp_path):
    """Only complete totals are filled in, and all other cells stay as they are.

    A student who is not known, or not unique, gets no score and is listed.
    """
    of = a_class(
        tmp_path,
        {
            "ann": record(),
            "roebob_12": record(share=0.0),
            "x_13": record(),
            "same": record(),
            "cy": None,
        },
    )
    (tmp_path / "template.csv").write_text(CANVAS, encoding="utf-8-sig")
    rows = write_all(of)
    rows.append(rows[0]._replace(assignment="02_bugs"))
    unknown, left_out = export_canvas(rows, tmp_path / "template.csv", tmp_path / "out.csv")
    assert left_out == ["02_bugs"]
    before, after = (
        list(csv.reader(io.StringIO(text)))
        for text in (CANVAS, (tmp_path / "out.csv").read_text(encoding="utf-8"))
    )
    assert [line[5] for line in after] == ["01 Geometry (991)", TOTAL, TOTAL, "0", "6", "", ""]
    assert [line[:5] + line[6:] for line in after] == [line[:5] + line[6:] for line in before]
    assert unknown == ["same", "x_13"]
    (tmp_path / "template.csv").write_text("name,score\nann,1\n", encoding="utf-8")
    with pytest.raises(InvalidParameter, match="no export of Canvas"):
        export_canvas(write_all(of), tmp_path / "template.csv", tmp_path / "out.csv")


def test_two_columns_of_canvas_for_one_assignment_are_refused(tmp_path):
    """Each section may have its own: nobody knows which is meant, until --column says it."""
    rows = write_all(a_class(tmp_path, {"roebob_12": record()}))
    template, out = tmp_path / "template.csv", tmp_path / "out.csv"
    head = "Student,ID,01 Geometry (991),01 Geometry (992)\n"
    template.write_text(f'{head}"Roe, Bob",12,,\n', encoding="utf-8")
    with pytest.raises(InvalidParameter, match=f"2 columns of .* are named like {NAME}"):
        export_canvas(rows, template, out)
    export_canvas(rows, template, out, "01 Geometry (992)")
    assert out.read_text(encoding="utf-8") == f'{head}"Roe, Bob",12,,{TOTAL}\n'


def test_gradescope_results_sum_up(tmp_path):
    """Each file's score is the sum of its tests, of which those with all points have passed."""
    rows = write_all(a_class(tmp_path, {"ann": record(share=0.5), "bob": failing()}))
    assert export_gradescope(rows, tmp_path / "gradescope") == (2, [])
    for file in (tmp_path / "gradescope").iterdir():
        data = json.loads(file.read_text(encoding="utf-8"))
        assert data["score"] == pytest.approx(sum(test["score"] for test in data["tests"]))
        assert len(data["tests"]) == len(read_assignment(NAME).questions)
        for test in data["tests"]:
            is_full = test["score"] == test["max_score"]
            assert test["status"] == ("passed" if is_full else "failed")
    for row in rows:
        output = str(make_gradescope_test(row)["output"])
        assert output.startswith(row.status) and output.endswith(row.message)


def test_gradescope_has_no_zero_for_what_has_no_score(tmp_path):
    """No file for a submission that could not be read; and none is left from an earlier export."""
    folder = tmp_path / "gradescope"
    export_gradescope(write_all(a_class(tmp_path, {"ann": record(), "cut": record()})), folder)
    of = a_class(tmp_path, {"ann": record()}, troubles={"cut": "the file is empty"})
    assert export_gradescope(write_all(of), folder) == (1, [f"cut {NAME}"])
    assert [file.name for file in folder.iterdir()] == [f"ann.{NAME}.json"]
    by_hand = write_all(a_class(tmp_path / "hand", {"ann": record(HAND)}, HAND))
    (test,) = (make_gradescope_test(row) for row in by_hand if row.question == "flowchart_bug1")
    assert test["output"] == "to grade by hand" and not {"score", "status"} & {*test}


def test_regrading_says_whose_score_changed_and_why(tmp_path):
    """Reasons are a new verdict, other points, another file, and a student who is new or gone."""
    light = record()
    for one in light["questions"]:
        one |= {"score": 1.0, "max_score": 1.0}
    wrong = record(share=0.0)
    before = a_class(
        tmp_path / "old",
        {"ann": wrong, "bob": record(), "cy": record(), "eve": wrong, "fay": light},
    )
    new = dict.fromkeys(("ann", "bob", "dee", "eve", "fay"), record())
    after = a_class(tmp_path / "new", {**new, "gus": None})
    entries = [
        entry._replace(digest="another" if entry.student == "eve" else entry.digest)
        for entry in after.entries
    ]
    (tmp_path / "new" / "overrides.csv").write_text(
        "student,assignment,question,score\nann,01_geometry,exposing_case,1\n"
    )
    found = list(
        find_changes(before, after._replace(entries=entries), read_decisions(tmp_path / "new"))
    )
    why = {change.student: change.why for change in found}
    assert why["ann"] == "right; before: wrong: A rule."
    assert re.fullmatch(r"worth \d points now; before: 1", why["fay"])
    assert (why["cy"], why["dee"], why["eve"]) == (
        "the submission is no longer there",
        "handed in since",
        "another file was handed in since",
    )
    assert "bob" not in why and "gus" not in why  # who has no score before and after
    assert [change.question for change in found if change.decided] == ["exposing_case"]


def test_regrading_names_questions_that_came_or_went():
    """The assignment asks for other questions than before; the file is the same."""
    file = Entry("ann", NAME, "f", "one", "", "d", "k", "")
    row = Row("ann", NAME, "line_through_points", 3.0, 3.0, "right", "Right.")
    assert explain_change(None, row, file, file) == "the assignment asks for this now"
    assert explain_change(row, None, file, file) == "the assignment no longer asks for this"


def test_grades_of_other_folders_stay():
    """One folder of grades holds several assignments; a student's new file replaces the old one."""
    old = [
        Entry(name, lesson, "f", "one", "", "d", "k", "")
        for name in ("ann", "bob")
        for lesson in (NAME, HAND)
    ]
    new = [Entry("ann", NAME, "g", "two", "", "d", "k", "")]
    kept = add_earlier(new, old)
    assert [(one.student, one.assignment, one.file) for one in kept] == [
        ("ann", NAME, "g"),
        ("ann", HAND, "f"),
        ("bob", NAME, "f"),
        ("bob", HAND, "f"),
    ]
    assert add_earlier(new, [one._replace(folder="two") for one in old]) == new


def test_a_file_that_takes_the_place_of_another_folders_is_told(caplog):
    """Such as an empty one, handed in late, in the place of a right one; the same file is none."""
    old = Entry("ann", NAME, "f", "one", "", "d", "k", "")
    warn_of_replaced([old._replace(folder="two")], [old])
    warn_of_replaced([old._replace(digest="e")], [old])
    assert not caplog.text
    warn_of_replaced([old._replace(folder="two", digest="e")], [old])
    assert "such as that of ann from one" in caplog.text


LINKS = """[a](javascript:alert(1)) [b][1] ![c](http://evil/x.png) $\\href{javascript:alert(4)}{d}$

[1]: javascript:alert(2)
<javascript:alert(3)> [e](&#106;avascript:alert(5)) [1]
"""


@pytest.mark.parametrize(
    "text",
    [
        r"$\\href{javascript:alert(1)}{x}$",
        r"\\\\(\\\\href{javascript:alert(1)}{x}\\\\)",
        "&#36;&#92;href{javascript:alert(1)}{x}&#36;",
        "&dollar;&bsol;href{javascript:alert(1)}{x}&dollar;",
        r"$\style{position: fixed}{x}$",
    ],
)
def test_no_formula_makes_a_link_however_it_is_written(text):
    """MathJax reads the text of the page, in which a browser has resolved every other spelling."""
    pytest.importorskip("nbgrader")
    import html

    import nbformat
    from nbconvert import HTMLExporter

    cell = {"cell_type": "markdown", "metadata": {}, "source": text}
    book = nbformat.from_dict(nbgrader_course.clean_notebook({"nbformat": 4, "cells": [cell]}, {}))
    page = html.unescape(HTMLExporter(template_name="classic").from_notebook_node(book)[0])
    assert not re.search(r"\\(href|style)\{", page.partition("<body")[2])


def test_hand_grading_goes_to_nbgrader_and_back(tmp_path):
    """The gradebook holds the judge's scores, and answers in prose wait there.

    A person's score and comment come back into the table.
    """
    pytest.importorskip("nbgrader")
    import nbformat
    from nbconvert import HTMLExporter
    from nbgrader.api import Gradebook

    from kinoedu.grading.export.nbgrader_course import (
        export_nbgrader,
        import_nbgrader_scores,
        name_database,
    )
    from kinoedu.grading.judge.class_list import digest_submission

    submissions, out = tmp_path / "in" / "ann", tmp_path / "out"
    submissions.mkdir(parents=True)
    book = json.loads((HOUSE / "solutions" / f"{HAND}.ipynb").read_text(encoding="utf-8"))
    dangerous = {
        "output_type": "display_data",
        "metadata": {},
        "data": {"text/html": HOSTILE, "text/plain": "plain"},
    }
    for cell in book["cells"]:
        if cell["cell_type"] == "code":
            cell["outputs"] = [dangerous, 7, {"data": []}]
    book["cells"].append({"cell_type": "markdown", "metadata": {}, "source": f"1 < 2 {HOSTILE}"})
    book["cells"].append({"cell_type": "markdown", "metadata": {}, "source": LINKS})
    book["cells"].append(
        dict(
            book["cells"][-2],
            metadata={"nbgrader": {"grade_id": "bug1", "grade": True, "points": 99}},
        )
    )
    (submissions / f"{HAND}.ipynb").write_text(json.dumps(book), encoding="utf-8")
    (one,) = collect(tmp_path / "in")
    of = a_class(out, {"ann": record(HAND)}, HAND)
    of = of._replace(
        entries=[
            entry._replace(folder=str(tmp_path / "in"), digest=digest_submission(one))
            for entry in of.entries
        ]
    )
    write_class(of)
    assert export_nbgrader(of, write_all(of), tmp_path / "course") == 1
    page = out / "feedback" / "ann" / f"{HAND}.html"
    assert "points; answers that have no score yet: 1" in page.read_text(encoding="utf-8")
    shown = (tmp_path / "course" / "autograded" / "ann" / HAND / f"{HAND}.ipynb").read_text(
        encoding="utf-8"
    )
    assert (tmp_path / "course" / "source" / HAND).is_dir()  # else formgrader lists nothing
    assert "<script" not in shown and "1 < 2 &lt;/pre" in shown
    pages = [
        HTMLExporter(template_name=name).from_notebook_node(nbformat.reads(shown, 4))[0]
        for name in ("lab", "classic")
    ]
    assert all("alert(4)" in page for page in pages)
    assert not any(re.search(r"""href=["'][^"']*script:|src=[^>]*evil""", page) for page in pages)
    assert not any("\\href" in page.partition("<main")[2] for page in pages)
    assert "plain" in shown and '"points": 99' not in shown
    whose = ("flowchart_bug1", HAND, HAND, "ann")
    with Gradebook(name_database(tmp_path / "course")) as gradebook:
        grade = gradebook.find_grade(*whose)
        assert grade.needs_manual_grade
        assert gradebook.find_grade("check_bug1", HAND, HAND, "ann").auto_score > 0
        assert gradebook.find_student("ann").first_name == ""  # else formgrader shows no name
        grade.manual_score, grade.needs_manual_grade = 3.0, False
        gradebook.find_comment(*whose).manual_comment = "neat"
        gradebook.find_comment("bug1", HAND, HAND, "ann").manual_comment = "short"
        gradebook.db.commit()
    for course in ("course", "another"):  # what was given is kept, also in another gradebook
        export_nbgrader(of, write_all(of), tmp_path / course)
        assert import_nbgrader_scores(of, tmp_path / course) == 1
        (row,) = [row for row in write_all(of) if row.question == "flowchart_bug1"]
        assert (row.score, row.status, row.message) == (3.0, "set by hand", "neat")
        (program,) = [row for row in write_all(of) if row.question == "bug1"]
        assert (program.status, program.message) == ("right", "short")
    assert "short" in page.read_text(encoding="utf-8")


def test_scores_given_by_hand_stay_with_another_gradebook(tmp_path):
    """As after a class was graded again: the new gradebook has them, and gives them back.

    A gradebook without a student's answer takes nothing from that student.
    """
    pytest.importorskip("nbgrader")
    from nbgrader.api import Gradebook

    from kinoedu.grading.export.nbgrader_course import (
        export_nbgrader,
        import_nbgrader_scores,
        name_database,
    )

    book = (HOUSE / "exercises" / f"{HAND}.ipynb").read_bytes()
    records = {"ann": record(HAND), "bob": record(HAND)}
    for student in records:
        (tmp_path / "in" / student).mkdir(parents=True)
        (tmp_path / "in" / student / f"{HAND}.ipynb").write_bytes(book)
    digest = hashlib.sha256(book).hexdigest()
    of = a_class(tmp_path / "out", records, HAND)
    entries = [one._replace(folder=str(tmp_path / "in"), digest=digest) for one in of.entries]
    of = of._replace(entries=entries)
    lines = [f"{name},{HAND},flowchart_bug1,3,neat" for name in records]
    text = "\n".join(["student,assignment,question,score,comment", *lines, ""])
    (of.out / "by_hand.csv").write_text(text, encoding="utf-8")
    export_nbgrader(of, write_all(of), tmp_path / "new")
    with Gradebook(name_database(tmp_path / "new")) as gradebook:
        total = sum(one.points for one in read_assignment(HAND).questions)
        assert gradebook.find_submission(HAND, "ann").score == total + 3.0
    assert import_nbgrader_scores(of, tmp_path / "new") == 2
    assert (of.out / "by_hand.csv").read_text(encoding="utf-8") == text
    with Gradebook(name_database(tmp_path / "new")) as gradebook:
        gradebook.find_grade("flowchart_bug1", HAND, HAND, "bob").manual_score = None
        gradebook.db.commit()
    assert import_nbgrader_scores(of, tmp_path / "new") == 1
    text = text.replace(f"bob,{HAND},flowchart_bug1,3,", f"bob,{HAND},flowchart_bug1,,")
    assert (of.out / "by_hand.csv").read_text(encoding="utf-8") == text  # a comment alone, too
    with Gradebook(name_database(tmp_path / "new")) as gradebook:
        gradebook.find_comment("flowchart_bug1", HAND, HAND, "bob").manual_comment = "newer"
        gradebook.db.commit()
    export_nbgrader(of, write_all(of), tmp_path / "new")
    assert import_nbgrader_scores(of, tmp_path / "new") == 1
    text = text.replace("flowchart_bug1,,neat", "flowchart_bug1,,newer")
    assert (of.out / "by_hand.csv").read_text(encoding="utf-8") == text
    for change in ({"extra_credit": 2.0}, {"manual_score": None}):  # 3 and 2
        with Gradebook(name_database(tmp_path / "new")) as gradebook:
            grade = gradebook.find_grade("flowchart_bug1", HAND, HAND, "ann")
            for name, value in change.items():
                setattr(grade, name, value)
            gradebook.db.commit()
        export_nbgrader(of, write_all(of), tmp_path / "new")
        assert import_nbgrader_scores(of, tmp_path / "new") == 1
        text = text.replace("flowchart_bug1,3,neat", "flowchart_bug1,5,neat")
        assert (of.out / "by_hand.csv").read_text(encoding="utf-8") == text
    with Gradebook(name_database(tmp_path / "new")) as gradebook:
        grade = gradebook.find_grade("flowchart_bug1", HAND, HAND, "ann")
        assert (grade.manual_score, grade.extra_credit, grade.max_score) == (4.0, 1.0, 4.0)
    alone = of._replace(entries=[one for one in of.entries if one.student == "ann"])
    rows = [row for row in write_all(of) if row.student == "ann"]
    export_nbgrader(alone, rows, tmp_path / "alone")
    assert import_nbgrader_scores(of, tmp_path / "alone") == 1
    assert (of.out / "by_hand.csv").read_text(encoding="utf-8") == text


def save_in_jupyter(file: Path) -> None:
    """Write a notebook as JupyterLab does: with a list of lines for a cell, in UTF-8."""
    if file.exists():
        book = json.loads(file.read_text(encoding="utf-8"))
        for cell in book["cells"]:
            cell["source"] = cell["source"].splitlines(keepends=True)
        book["metadata"]["title"] = "Übung"
        file.write_text(json.dumps(book, ensure_ascii=False), encoding="utf-8")


def test_an_answer_that_was_handed_in_anew_waits_for_a_person_again(tmp_path):
    """Its score was for the earlier one; an equal answer in another notebook keeps its score.

    It does so too where somebody opened and saved the notebook that was exported.
    """
    pytest.importorskip("nbgrader")
    from kinoedu.grading.export.nbgrader_course import export_nbgrader, import_nbgrader_scores

    book = json.loads((HOUSE / "exercises" / f"{HAND}.ipynb").read_text(encoding="utf-8"))
    marks = [cell["metadata"].get("nbgrader", {}) for cell in book["cells"]]
    names = [mark.get("grade_id") for mark in marks]
    flowchart = book["cells"][names.index("flowchart_bug1")]
    file = tmp_path / "in" / "ann" / f"{HAND}.ipynb"
    file.parent.mkdir(parents=True)

    def hand_in_anew() -> Class:
        file.write_text(json.dumps(book), encoding="utf-8")
        of = a_class(tmp_path / "out", {"ann": record(HAND)}, HAND)
        digest = hashlib.sha256(file.read_bytes()).hexdigest()
        (entry,) = of.entries
        return of._replace(entries=[entry._replace(folder=str(tmp_path / "in"), digest=digest)])

    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "by_hand.csv").write_text(f"{COLUMNS}ann,{HAND},flowchart_bug1,3,neat\n")
    counts = []
    for text in (None, None, "Go round the obstacle.", None):
        flowchart["source"] = text or flowchart["source"]
        book["cells"].append({**flowchart, "metadata": {}})
        save_in_jupyter(tmp_path / "course" / "autograded" / "ann" / HAND / f"{HAND}.ipynb")
        of = hand_in_anew()
        export_nbgrader(of, write_all(of), tmp_path / "course")
        counts.append(import_nbgrader_scores(of, tmp_path / "course"))
    assert counts == [1, 1, 0, 0]
    (row,) = (row for row in write_all(of) if row.question == "flowchart_bug1")
    assert (row.score, row.status) == (None, "to grade by hand")


def test_a_gradebook_that_was_read_back_is_not_called_old(tmp_path):
    """The scores that changed came from it; one that was old before stays so."""
    of, place = a_class(tmp_path / "out", {"ann": record(HAND)}, HAND), tmp_path / "course"
    place.mkdir()
    before = write_all(of)
    note_export(of, before, "nbgrader", place)
    line = f"ann,{HAND},flowchart_bug1,3,neat\n"
    (of.out / "by_hand.csv").write_text(COLUMNS + line, encoding="utf-8")
    rows = write_all(of)
    assert list_old_exports(of, rows) == [str(place)]
    renew_export(of, rows, rows, place)
    assert list_old_exports(of, rows) == [str(place)]
    renew_export(of, before, rows, place)
    assert list_old_exports(of, rows) == []


@pytest.mark.filterwarnings("ignore:Object of type")  # how nbgrader uses SQLAlchemy
def test_a_score_for_a_program_in_formgrader_is_named(tmp_path, capsys):
    """It is not read back, and would be lost without a word; an equal one changes nothing."""
    pytest.importorskip("nbgrader")
    from nbgrader.api import Gradebook

    from kinoedu.grading.export.nbgrader_course import add_assignment, name_database

    of = a_class(tmp_path / "out", {"ann": record(HAND)}, HAND)
    with Gradebook(name_database(tmp_path)) as gradebook:
        add_assignment(gradebook, HAND)
        gradebook.update_or_create_student("ann")
        gradebook.update_or_create_submission(HAND, "ann")
        for name, score in (("bug2", 1.5), ("bug1", 3.0)):
            gradebook.find_grade(f"check_{name}", HAND, HAND, "ann").manual_score = score
        gradebook.db.commit()
    assert main(["export", str(of.out), "--from-nbgrader", str(tmp_path)]) == 0
    warning = capsys.readouterr().err
    assert f"overrides.csv: ann {HAND} bug2: 1.5\n" in warning


NOW = datetime(2026, 1, 2, 3, 4, 5, tzinfo=UTC)


def test_a_receipt_says_what_is_answered(tmp_path):
    """An untouched exercise has no answers, a solution has all; `collect` reads the zip."""
    for room, done in (("exercises", 0), ("solutions", QUESTIONS)):
        folder = tmp_path / room / "ann"
        folder.mkdir(parents=True)
        receipt = hand_in(HOUSE / room / f"{NAME}.ipynb", folder / "mine.zip", NOW)
        assert sum(answered for answered, _ in receipt.answers.values()) == done
        assert f"Answered: {done} of {QUESTIONS}" in str(receipt)
        (one,) = collect(tmp_path / room)
        assert (one.student, one.assignment, one.trouble) == ("ann", NAME, "")
        assert one.data == (HOUSE / room / f"{NAME}.ipynb").read_bytes()
    with zipfile.ZipFile(tmp_path / "solutions" / "ann" / "mine.zip") as archive:
        assert receipt.sha256 in archive.read("receipt.txt").decode()


def test_a_receipt_has_the_order_of_the_notebook(tmp_path):
    """Also for an answer that people grade, such as the flowchart between the programs."""
    receipt = hand_in(HOUSE / "exercises" / f"{HAND}.ipynb", tmp_path / "z.zip", NOW)
    assert [*receipt.answers] == list_assignments()[HAND]
    assert [*receipt.answers].index("flowchart_bug1") == len(receipt.answers) - 2


def test_what_cannot_be_graded_is_not_packed(tmp_path):
    """An empty file, or one with the name of no exercise, is refused."""
    empty = '{"nbformat": 4, "cells": []}'
    for name, text, wrong in (
        (f"{NAME}.ipynb", "", UnreadableSubmission),
        (f"{NAME}.ipynb", empty, InvalidParameter),
        ("lunch.ipynb", empty, InvalidParameter),
        (f"{NAME}.txt", empty, InvalidParameter),
    ):
        (tmp_path / name).write_text(text)
        with pytest.raises(wrong):
            hand_in(tmp_path / name, tmp_path / "z.zip", NOW)
    assert not (tmp_path / "z.zip").exists()


def test_an_assignment_may_have_exercises_of_several_lessons(tmp_path, monkeypatch):
    """It is handed in under its own name, with its own exercises; one without exercises too."""
    asked = {NAME: ["exposing_case"], "homework": ["exposing_case", "bfs_tree"], "essay": ["why"]}
    monkeypatch.setattr(handing_in, "list_assignments", lambda: asked)
    for name, notebook_name in (("homework", "Homework-1"), ("homework", "mine"), (NAME, NAME)):
        cells = [{"cell_type": "code", "source": f"check({one})"} for one in asked[name]]
        file = tmp_path / f"{notebook_name}.ipynb"
        file.write_text(json.dumps({"nbformat": 4, "cells": cells}), encoding="utf-8")
        receipt = hand_in(file, tmp_path / "z.zip", NOW)
        assert (receipt.assignment, [*receipt.answers]) == (name, asked[name])
        assert zipfile.ZipFile(tmp_path / "z.zip").namelist()[0] == f"{name}.ipynb"
    mark = {"grade_id": "why", "grade": True, "solution": True}
    cell = {"cell_type": "markdown", "source": "PRM", "metadata": {"nbgrader": mark}}
    file.write_text(json.dumps({"nbformat": 4, "cells": [cell]}), encoding="utf-8")
    essay = file.rename(tmp_path / "essay.ipynb")
    assert hand_in(essay, tmp_path / "z.zip", NOW).answers == {"why": (True, "")}


def test_assignments_are_known_with_and_without_solutions(tmp_path):
    """By the solutions; else by the list of a kit; else each lesson is one."""
    known, by_lesson = list_assignments(), list_assignments(tmp_path)
    assert list(known) == list(by_lesson) == assignments()
    for name in known:
        assert {*known[name]} & {*EXERCISES} == {*by_lesson[name]}
    (tmp_path / "list.json").write_text('{"homework": ["bug1"]}')
    assert list_assignments(HOUSE, tmp_path / "list.json") == {"homework": ["bug1"]}


def test_a_receipt_says_what_python_cannot_read_and_what_was_never_checked(tmp_path):
    """An answer whose check was never run, and one with a syntax error."""
    book = json.loads((HOUSE / "exercises" / f"{NAME}.ipynb").read_text(encoding="utf-8"))
    typed = {
        "line_through_points": "def line_through_points(p1, p2):\n    return 1",
        "exposing_case": "def exposing_case()\n    pass\ndef polygon_tangent(q, p):\n    return 1",
    }
    for cell in book["cells"]:
        cell["source"] = typed.get(
            cell["metadata"].get("nbgrader", {}).get("grade_id"), cell["source"]
        )
    (tmp_path / f"{NAME}.ipynb").write_text(json.dumps(book), encoding="utf-8")
    answers = hand_in(tmp_path / f"{NAME}.ipynb", tmp_path / "z.zip", NOW).answers
    is_answered, remark = answers["line_through_points"]
    assert is_answered and "has not been run" in remark
    is_answered, remark = answers["exposing_case"]
    assert not is_answered and "expected ':' (line 1)" in remark
    assert answers["polygon_tangent"][0]


def test_an_answer_in_a_cell_of_its_own_counts_where_the_placeholder_is_below():
    """As for the grader."""
    placeholder = "def f(x):\n    raise NotImplementedError()"
    for sources, is_answered in (([placeholder], False), (["f = abs", placeholder], True)):
        written, _ = find_functions([Cell(1, source) for source in sources])
        assert written == {"f": is_answered}


def test_a_notebook_under_anothers_name_is_the_wrong_file(tmp_path):
    """It cannot be handed in, and has no score, unless its own assignment is graded."""
    (tmp_path / "ann").mkdir()
    wrong = tmp_path / "ann" / f"{NAME}.ipynb"
    wrong.write_bytes((HOUSE / "exercises" / f"{HAND}.ipynb").read_bytes())
    with pytest.raises(InvalidParameter, match=f"cells are those of {HAND}"):
        hand_in(wrong, tmp_path / "z.zip", NOW)
    (one,) = collect(tmp_path)
    assert one.assignment == NAME and f"cells are those of {HAND}" in one.trouble
    (one,) = collect(tmp_path, HAND)
    assert (one.assignment, one.trouble) == (HAND, "")


def strip_metadata(data: bytes) -> bytes:
    """A notebook as some editors save it: without what nbgrader wrote into its cells."""
    book = json.loads(data)
    for cell in book["cells"]:
        cell["metadata"] = {}
    return json.dumps(book).encode()


EXERCISE = (HOUSE / "exercises" / f"{NAME}.ipynb").read_bytes()
LESSON = (HOUSE / "notebooks" / f"{NAME}.ipynb").read_bytes()


@pytest.mark.parametrize(
    "lesson", sorted((HOUSE / "notebooks").glob("*.ipynb")), ids=lambda f: f.stem
)
def test_a_lesson_is_no_exercise_of_any_assignment(lesson):
    assert not any(count_shared(find_questions(lesson.read_bytes()), assignments()).values())


@pytest.mark.parametrize("exercise", assignments())
def test_an_exercise_is_known_by_its_cells(exercise, tmp_path):
    """Under any name, with nbgrader's metadata and without; it need not be answered."""
    data = (HOUSE / "exercises" / f"{exercise}.ipynb").read_bytes()
    for whose, cells in (("ann", data), ("bob", strip_metadata(data))):
        (tmp_path / "in" / whose).mkdir(parents=True)
        (tmp_path / "in" / whose / "Untitled3.ipynb").write_bytes(cells)
        receipt = hand_in(tmp_path / "in" / whose / "Untitled3.ipynb", tmp_path / "z.zip", NOW)
        assert receipt.assignment == exercise
    assert [(one.assignment, one.trouble) for one in collect(tmp_path / "in")] == [
        (exercise, "")
    ] * 2


def test_a_lesson_in_place_of_its_exercise_has_no_score(tmp_path):
    """It is listed with the reason, it cannot be handed in, and other tables get no zero."""
    (tmp_path / "in" / "ann").mkdir(parents=True)
    wrong = tmp_path / "in" / "ann" / f"{NAME}.ipynb"
    wrong.write_bytes(LESSON)
    with pytest.raises(InvalidParameter, match="none of its functions: is it the wrong file"):
        hand_in(wrong, tmp_path / "z.zip", NOW)
    (one,) = collect(tmp_path / "in")
    assert one.assignment == NAME and "none of the functions" in one.trouble
    (graded,) = grade_all([one], tmp_path / "out", b"a secret")
    entry = make_entry(graded, tmp_path / "in", "", b"a secret")
    rows = write_all(Class(tmp_path / "out", "", "", False, [entry]))
    assert {(row.score, row.status) for row in rows} == {(None, "unreadable")}
    assert "is it the wrong file?" in rows[0].message
    (tmp_path / "template.csv").write_text(CANVAS, encoding="utf-8-sig")
    export_canvas(rows, tmp_path / "template.csv", tmp_path / "out.csv")
    assert (tmp_path / "out.csv").read_text(encoding="utf-8") == CANVAS


def test_a_lesson_beside_the_exercise_is_no_second_answer(tmp_path):
    """A student may hand in the whole folder of the course; a name is no proof."""
    for folder, data in (("notebooks", LESSON), ("exercises", EXERCISE)):
        (tmp_path / "ann" / folder).mkdir(parents=True)
        (tmp_path / "ann" / folder / f"{NAME}.ipynb").write_bytes(data)
    (tmp_path / "bob").mkdir()
    (tmp_path / "bob" / "mine.ipynb").write_bytes(LESSON)
    ann, bob = collect(tmp_path, NAME)
    assert (ann.data, ann.trouble) == (EXERCISE, "")
    assert bob.assignment == NAME and "none of the functions" in bob.trouble


def test_an_empty_answer_in_the_right_notebook_is_no_wrong_file(tmp_path):
    """Also where only a check or a cell's name is left of it."""
    for at, cell in enumerate(
        (
            {"cell_type": "code", "source": "check(line_through_points)"},
            {
                "cell_type": "code",
                "source": "",
                "metadata": {"nbgrader": {"grade_id": "exposing_case"}},
            },
            {"cell_type": "code", "source": "%%time\ndef exposing_case(:\n    pass"},
        )
    ):
        (tmp_path / f"student{at}").mkdir()
        book = {"nbformat": 4, "cells": [cell]}
        (tmp_path / f"student{at}" / f"{NAME}.ipynb").write_text(json.dumps(book))
    assert [one.trouble for one in collect(tmp_path)] == [""] * 3


@pytest.mark.parametrize("place", ["in/grades", "in", "in/ann/grades"])
def test_grades_are_not_put_among_submissions(tmp_path, capsys, place):
    """They would be a student's at the next grading; nothing is written."""
    (tmp_path / "in" / "ann").mkdir(parents=True)
    (tmp_path / "in" / "ann" / f"{NAME}.ipynb").write_bytes(b"")
    command = ["grade", str(tmp_path / "in"), "--out", str(tmp_path / place), "--trust"]
    assert main([*command, "--secret", str(tmp_path / "secret")]) == 2
    assert "name a folder outside" in capsys.readouterr().err
    assert [one.name for one in (tmp_path / "in").rglob("*")] == ["ann", f"{NAME}.ipynb"]


def test_two_folders_that_are_graded_at_once_are_both_kept(tmp_path, monkeypatch):
    """One command ends while the other grades; lists, tables and pages hold both sections."""
    for section, student in ("A", "ann"), ("B", "bob"):
        (tmp_path / section / student).mkdir(parents=True)
        (tmp_path / section / student / f"{NAME}.ipynb").write_bytes(b"")
    out, run = tmp_path / "out", class_grading.Run(tmp_path / "secret", trusted=True)

    def grade_beside_another(*given, **options):
        monkeypatch.undo()
        class_grading.grade_class(tmp_path / "B", "", out, run)
        return grade_all(*given, **options)

    monkeypatch.setattr(class_grading, "grade_all", grade_beside_another)
    class_grading.grade_class(tmp_path / "A", "", out, run)
    assert [entry.student for entry in read_class(out).entries] == ["ann", "bob"]
    assert {row["student"] for row in table(out / "grades.csv")} == {"ann", "bob"}
    assert sorted(page.name for page in (out / "feedback").iterdir()) == ["ann", "bob"]


def test_only_one_command_writes_a_class_at_a_time(tmp_path):
    """Another one waits until the first has written."""
    with ThreadPoolExecutor(1) as other:
        with locked_class(tmp_path):
            write = other.submit(lambda: locked_class(tmp_path).__enter__())
            with pytest.raises(TimeoutError):
                write.result(timeout=0.5)
        write.result(timeout=10)


@needs_sandbox
def test_a_class_is_graded_from_the_command_line(tmp_path, capsys):
    """Grading from kept results, and regrading without a sandbox, change no score."""
    for student in ("ann", "bob"):
        (tmp_path / "in" / student).mkdir(parents=True)
    (tmp_path / "in" / "ann" / f"{NAME}.ipynb").write_bytes(
        (HOUSE / "solutions" / f"{NAME}.ipynb").read_bytes()
    )
    (tmp_path / "in" / "bob" / f"{NAME}.ipynb").write_bytes(b"")
    secret = tmp_path / "secret"
    secret.write_text("11" * 32)
    command = ["grade", str(tmp_path / "in"), "--out", str(tmp_path / "out")]
    command += ["--secret", str(secret), "--workers", "1"]
    assert main(command) == 1
    out, _ = capsys.readouterr()
    assert out.startswith("1 graded, 0 not graded, 1 unreadable") and "bob" in out
    first = (tmp_path / "out" / "grades.csv").read_bytes()
    assert main(command) == 1
    assert (tmp_path / "out" / "grades.csv").read_bytes() == first
    assert main(["export", str(tmp_path / "out"), "--to", "csv"]) == 0
    assert table(tmp_path / "out" / "totals.csv") == [
        {"student": "ann", NAME: TOTAL},
        {"student": "bob", NAME: ""},
    ]
    regrade = ["regrade", str(tmp_path / "out"), "--out", str(tmp_path / "new")]
    assert main([*regrade, "--trust", "--workers", "1"]) == 1
    printed = capsys.readouterr()
    assert "0 scores changed" in printed.out and "WITHOUT A SANDBOX" in printed.err
    assert (tmp_path / "new" / "grades.csv").read_bytes() == first
    decisions = tmp_path / "out" / "overrides.csv"
    decisions.write_text(f"student,assignment,question,score,comment\nann,{NAME},gone,1,\n")
    assert main([*regrade[:-1], str(tmp_path / "other")]) == 2
    assert "'gone'" in capsys.readouterr().err
    assert not (tmp_path / "other").exists()  # a copy of the wrong line would be read next time
    decisions.unlink()
    (tmp_path / "out" / "class.json").write_text("")
    assert main(command) == 2
    assert "class.json is damaged; remove it and grade" in capsys.readouterr().err
    (tmp_path / "out" / "class.json").unlink()
    assert main(command) == 1
    assert (tmp_path / "out" / "grades.csv").read_bytes() == first
    secret.write_text("22" * 32)
    assert main(command) == 2
    message = capsys.readouterr().err
    assert "another secret" in message and "--secret" in message


def test_ctrl_c_does_not_wait_for_the_notebooks_that_were_submitted():
    """Their processes end, and no other notebook is begun."""
    jobs = list[Future[None]]()

    def submit_and_stop():
        with use_local_workers(2)(None) as pool:
            jobs.extend(pool.submit(time.sleep, 60.0) for _ in range(9))
            while not jobs[0].running():
                time.sleep(0.01)
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        submit_and_stop()
    assert all(job.cancelled() or job.exception() for job in jobs)


def test_without_a_sandbox_nothing_is_graded(tmp_path, monkeypatch, capsys):
    """The command is refused, says how to go on, and writes nothing."""
    monkeypatch.setattr(sys, "platform", "darwin")
    (tmp_path / "in" / "ann").mkdir(parents=True)
    (tmp_path / "in" / "ann" / f"{NAME}.ipynb").write_text("{}")
    command = ["grade", str(tmp_path / "in"), "--out", str(tmp_path / "out")]
    assert main([*command, "--secret", str(tmp_path / "s")]) == 2
    assert "--trust" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("line", "why"),
    [
        ("anne,01_geometry,exposing_case,2,", r"line 3: .*no student 'anne'; did you mean 'ann'"),
        ("ann,1_geometry,exposing_case,2,", r"line 3: .*of ann '1_geometry'; did you mean '01"),
        ("ann,01_geometry,exposing_cas,2,", r"line 3: .*01_geometry 'exposing_cas'; did you mean"),
        (
            "bob,01_geometry,exposing_case,2,",
            "names. If this work is gone, delete the line",
        ),
        ("ann,01_geometry,exposing_case,two,", "line 3: a score is a number"),
        ("ann,01_geometry,exposing_case,-1,", "line 3: a score is a number"),
        ("ann,01_geometry,exposing_case,nan,", "line 3: a score is a number"),
        ("ann,01_geometry,exposing_case,inf,", "line 3: a score is a number"),
        ("ann,01_geometry,exposing_case,2,5,late", "line 3 has more cells"),
    ],
)
def test_a_wrong_override_stops_a_class_before_anything_runs(tmp_path, monkeypatch, line, why):
    """Its line is named, and the most similar name."""
    folder, out = tmp_path / "in", tmp_path / "out"
    (folder / "ann").mkdir(parents=True)
    notebook = HOUSE / "exercises" / f"{NAME}.ipynb"
    (folder / "ann" / notebook.name).write_bytes(notebook.read_bytes())
    out.mkdir()
    good = "ann,01_geometry,point_line_distance,1,\n"
    (out / "overrides.csv").write_text(f"{COLUMNS}{good}{line}\n", encoding="utf-8")
    monkeypatch.setattr(class_grading, "require_sandbox", lambda trusted: None)
    monkeypatch.setattr(class_grading, "grade_all", lambda *_, **__: pytest.fail("it ran"))
    with pytest.raises(InvalidParameter, match=why):
        class_grading.grade_class(folder, "", out, class_grading.Run(tmp_path / "secret"))


def test_names_come_from_a_table_or_from_gradescope(tmp_path):
    """With the columns student and name, or as Canvas exports them; Gradescope's list beside the
    folders, but not one that a student handed in.
    """
    plain, canvas = tmp_path / "plain.csv", tmp_path / "canvas.csv"
    plain.write_text("student,name\nann,Ann Lee\n'=x,Mallory\n", encoding="utf-8")
    assert read_names(plain) == {"ann": "Ann Lee", "=x": "Mallory"}
    canvas.write_text(CANVAS, encoding="utf-8")
    found = read_names(canvas)
    assert {find_name(one, found) for one in ("doeann_11", "11", "ann", "ANN")} == {"Ann Doe"}
    canvas.write_text(CANVAS.replace("Doe, Ann", "Ñoë-Li, Ann"), encoding="utf-8")
    assert find_name("ñoëliann_11", read_names(canvas)) == "Ann Ñoë-Li"
    with pytest.raises(InvalidParameter, match="neither the columns student and name"):
        read_names(write(tmp_path / "other.csv", "a,b\n1,2\n"))
    listed = "submission_1:\n  :submitters:\n  - :name: Bo\n    :sid: 's7'\n"
    folder = tmp_path / "class" / "submission_1"
    folder.mkdir(parents=True)
    (tmp_path / "class" / "submission_2").mkdir()
    write(folder / METADATA, listed)
    assert read_gradescope_names(tmp_path / "class") == {}
    write(tmp_path / "class" / METADATA, listed)
    assert read_gradescope_names(tmp_path / "class") == {"s7": "Bo"}
    with zipfile.ZipFile(tmp_path / "class.zip", "w") as archive:
        archive.writestr(f"export/{METADATA}", listed)
        archive.writestr("export/submission_1/a.ipynb", "")
    assert read_gradescope_names(tmp_path / "class.zip") == {"s7": "Bo"}


LISTED = """
submission_1:
  :submitters: []
submission_2:
  :submitters:
  - :name: Ann
    :sid: 0012
  :created_at: 2024-99-99
submission_3:
  :submitters:
  - :name: Bo
    :sid:
    :email: bo@example.org
submission_4: of nobody
"""


def test_each_entry_of_gradescopes_list_stands_for_itself(tmp_path):
    """One without a student costs no other one the name; an id keeps its zeros, a bad date is no
    matter, and a list that is no YAML names nobody.
    """
    for number in range(1, 5):
        (tmp_path / f"submission_{number}").mkdir()
        write(tmp_path / f"submission_{number}" / f"{NAME}.ipynb", "{}")
    write(tmp_path / METADATA, LISTED)
    students = {one.student for one in collect(tmp_path)}
    assert students == {"submission_1", "0012", "bo@example.org", "submission_4"}
    assert read_gradescope_names(tmp_path) == {"0012": "Ann", "bo@example.org": "Bo"}
    write(tmp_path / METADATA, "a: [")
    assert {one.student for one in collect(tmp_path)} == {f"submission_{k}" for k in range(1, 5)}


def test_everybody_of_a_group_has_what_it_handed_in(tmp_path):
    """Gradescope lists all of them beside one folder; each has a name, and a row of the grades."""
    for number, name in ((1, f"{NAME}.ipynb"), (2, "notes.txt")):
        (tmp_path / f"submission_{number}").mkdir()
        write(tmp_path / f"submission_{number}" / name, "{}")
    entry = (
        "submission_{}:\n  :submitters:\n  - :name: {}\n    :sid: {}\n  - :name: {}\n    :sid: {}\n"
    )
    listed = entry.format(1, "Ann", 11, "Bo", 12) + entry.format(2, "Cy", 13, "Di", 14)
    write(tmp_path / METADATA, listed)
    found = {one.student: (one.data, one.trouble) for one in collect(tmp_path)}
    assert [*found] == ["11", "12", "13", "14"]
    assert found["11"] == found["12"] == (b"{}", "")
    assert found["13"] == found["14"] and "no notebook" in found["13"][1]
    assert read_gradescope_names(tmp_path) == {"11": "Ann", "12": "Bo", "13": "Cy", "14": "Di"}


def test_what_one_of_a_group_handed_in_elsewhere_is_not_the_groups(tmp_path):
    """A student in two groups shares with each what was handed in for that group."""
    for number, text in ((1, "{}"), (2, "{ }"), (3, "notes")):
        (tmp_path / f"submission_{number}").mkdir()
        name = f"{NAME}.ipynb" if number < 3 else "notes.txt"
        write(tmp_path / f"submission_{number}" / name, text)
    groups = {1: ("Ann", "Bo"), 2: ("Ann", "Cy"), 3: ("Bo", "Di")}
    lines = [
        f"submission_{number}:\n  :submitters:\n" + "".join(f"  - :sid: {one}\n" for one in group)
        for number, group in groups.items()
    ]
    write(tmp_path / METADATA, "".join(lines))
    found = {one.student: one for one in collect(tmp_path)}
    assert [*found] == ["Ann", "Bo", "Cy", "Di"]
    assert (found["Bo"].data, found["Cy"].data) == (b"{}", b"{ }")
    assert "handed in more than once" in found["Ann"].trouble
    assert "no notebook" in found["Di"].trouble


def test_students_have_the_names_that_tables_show(tmp_path):
    """Two names that look the same are one student, who handed in twice; a decision about a name
    counts however many spaces it is written with.
    """
    for folder, text in (
        ("ann", "{}"),
        ("ann ", "{ }"),
        ("Jane  Doe_4711_assignsubmission_file_", "{}"),
    ):
        (tmp_path / "class" / folder).mkdir(parents=True)
        write(tmp_path / "class" / folder / f"{NAME}.ipynb", text)
    ann, jane = sorted(collect(tmp_path / "class"), key=lambda one: one.student.casefold())
    assert (ann.student, jane.student) == ("ann", "Jane Doe_4711")
    assert "more than once, with differences" in ann.trouble
    assert all(one.student == escape_formula(one.student) for one in (ann, jane))
    question = next(iter(POINTS))
    write(
        tmp_path / "overrides.csv",
        f"student,assignment,question,score,comment\nJane  Doe_4711 ,{NAME},{question},2,\n",
    )
    assert set(read_decisions(tmp_path)) == {("Jane Doe_4711", NAME, question)}
    short = write(tmp_path / "names.csv", "student,name\nJane  Doe_4711,Jane\nbob\n")
    assert find_name("Jane Doe_4711", read_names(short)) == "Jane"


def write(file: Path, text: str) -> Path:
    """The file with that text."""
    file.write_text(text, encoding="utf-8")
    return file


def test_the_report_has_names_spread_and_unreadable_students(tmp_path):
    """Names beside ids, median and quartiles of totals, and a mark where a file cannot be read."""
    kept = {name: record(share=share) for name, share in (("ann", 1.0), ("bob", 0.5), ("cy", 0.0))}
    of = a_class(tmp_path, kept, troubles={"dee": "it is no notebook"})
    named = [one._replace(name="Ann Lee" if one.student == "ann" else "") for one in of.entries]
    of = of._replace(entries=[*named, of.entries[0]._replace(student="eve", assignment="", key="")])
    write_all(of)
    report = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert "Ann Lee (ann)" in report
    assert "Median 50 %; half of the students have 25 to 75 %, all have 0 to 100 %." in report
    assert report.count("unreadable</a>") == 1
    assert " unreadable</td>" in report
    assert "Unknown assignment" in report
    assert "Ann Lee (ann)" in (tmp_path / name_page("ann", NAME)).read_text(encoding="utf-8")


def test_pages_of_unchanged_results_are_kept(tmp_path, monkeypatch):
    """A page is made again only if its rows changed, or the page itself."""
    of = a_class(tmp_path, {"ann": record(), "bob": record(share=0.5), "cy": record()})
    made = []
    render = writing.render_page
    monkeypatch.setattr(
        writing, "render_page", lambda rows, *rest: made.append(rows[0][0]) or render(rows, *rest)
    )
    write_all(of)
    before = {file: file.read_bytes() for file in tmp_path.rglob("*.html")}
    write_all(of)
    assert made == ["ann", "bob", "cy"]
    write(tmp_path / name_page("ann", NAME), "changed")
    write(tmp_path / "overrides.csv", f"{COLUMNS}bob,{NAME},exposing_case,1,\n")
    write_all(of)
    assert made[3:] == ["ann", "bob"]
    (tmp_path / "overrides.csv").unlink()
    (tmp_path / "pages.json").write_text("[", encoding="utf-8")
    write_all(of)
    assert made[5:] == ["ann", "bob", "cy"]
    assert {file: file.read_bytes() for file in tmp_path.rglob("*.html")} == before
    write(tmp_path / "feedback" / "ann" / "half.part", "<p")  # of a command that was killed
    write_all(of)
    assert not list(tmp_path.rglob("*.part"))


def test_a_worker_with_other_sources_grades_nothing():
    """A judge was repaired since a worker of a cluster began: its grade would have a wrong name."""
    one = Submission("ann", NAME, "a.ipynb", b"{}")
    job = running.make_job(one, "0" * 40, bytes(32), trusted=True, patience=1.0)
    with pytest.raises(RuntimeError, match="another version of kinoedu"):
        running.grade_job(job)


def test_more_patience_grades_again_what_took_too_long(tmp_path, monkeypatch):
    """And nothing else; with less patience the result is kept."""

    @contextmanager
    def place(most):
        with ThreadPoolExecutor(1) as executor:
            yield executor

    asked = []

    def late(job):
        asked.append(job.patience)
        return record() | {"questions": [question("exposing_case", 0.0, 1.0, late=True)]}

    monkeypatch.setattr(running, "grade_job", late)
    one = Submission("ann", NAME, "a.ipynb", b"{}")

    def grade_with(patience):
        running.grade_all([one], tmp_path, bytes(32), place=place, patience=patience)
        return [*asked], asked.clear()

    assert [grade_with(patience)[0] for patience in (1.0, 1.0, 2.0, 1.5)] == [
        [1, 3],
        [],
        [2, 6],
        [],
    ]
    monkeypatch.setattr(running, "grade_job", lambda job: asked.append(job.patience) or record())
    assert [grade_with(patience)[0] for patience in (4.0, 8.0)] == [[4], []]
    for bad in ("0.5", "nan", "1e9"):
        assert main(["grade", str(tmp_path), "--out", str(tmp_path), "--patience", bad]) == 2


class Counting(Executor):
    """An executor that breaks once, at its fifth notebook, and counts results not yet taken."""

    waiting, most, taken = 0, 0, 0

    def submit(self, function, job):
        """A future that is done; asking it whether it failed takes its result."""
        self.taken += 1
        if self.taken == 5:
            raise BrokenProcessPool("a worker ended")
        future = Asked(self)
        future.set_result(function(job))
        self.waiting += 1
        self.most = max(self.most, self.waiting)
        return future


class Asked(Future):
    """A future of Counting."""

    def __init__(self, executor):
        super().__init__()
        self.executor = executor

    def result(self, timeout=None):
        """The result."""
        self.executor.waiting -= 1
        return super().result(timeout)


def test_few_notebooks_of_a_large_class_wait_at_a_time(tmp_path, monkeypatch):
    """And a pool that breaks while they are submitted loses none, and counts against none."""

    executor = Counting()

    @contextmanager
    def place(most):
        yield executor

    monkeypatch.setattr(running, "AHEAD", 3)
    monkeypatch.setattr(running, "grade_job", lambda job: record())
    several = [Submission(f"{i}", NAME, "a.ipynb", f"{{{i}}}".encode()) for i in range(20)]
    graded = running.grade_all(several, tmp_path, bytes(32), place=place)
    assert all(one.grade is not None for one in graded) and len(graded) == 20
    assert (executor.most, executor.waiting, executor.taken) == (4, 0, 21)


class Breaking(Executor):
    """Workers that all end when one is given a notebook of eve's."""

    def __init__(self, started):
        started.append(self)
        assert len(started) < 50, "a notebook is tried for ever"
        self.is_broken = False

    def submit(self, function, job):
        """Grade a notebook now, or lose all workers."""
        future = Future()
        self.is_broken = self.is_broken or b"eve" in job.data
        if self.is_broken:
            future.set_exception(BrokenProcessPool("a worker ended"))
        else:
            future.set_result(record())
        return future


@pytest.mark.parametrize("students", [["eve"], ["ann", "eve"], ["eve", "ann", "bob"]])
def test_a_notebook_that_ends_every_worker_is_given_up(tmp_path, students):
    """Also where it is the only one that is left, and nothing was completed beside it."""
    started = []

    @contextmanager
    def place(most):
        yield Breaking(started)

    class_of = [Submission(one, NAME, "a.ipynb", b'"%s"' % one.encode()) for one in students]
    for one in running.grade_all(class_of, tmp_path, bytes(32), place=place):
        assert (one.grade is None) == (one.submission.student == "eve")
        assert ("a worker ended" in one.trouble) == (one.submission.student == "eve")


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["--to", "csv", "--column", "x"], "--column is for --to canvas, not for --to csv"),
        (["--to", "gradescope", "--template", "x.csv"], "--template is for --to canvas"),
        (["--to", "canvas", "--variant", "A"], "--variant is for --gradescope-autograder"),
        (["--to", "nbgrader", "--trust-container"], "--trust-container is for"),
        (["--from-nbgrader", "x", "--secret", "y"], "not for --from-nbgrader"),
        (["--gradescope-autograder", "x.zip", "--out", "y"], "--out is for --to, not for"),
    ],
)
def test_an_option_without_effect_is_refused(tmp_path, capsys, options, said):
    """It would be taken for one that was heard."""
    assert main(["export", str(tmp_path), *options]) == 2
    assert said in capsys.readouterr().err


def test_an_export_of_grades_that_can_only_be_read_is_whole(tmp_path, capsys):
    """It cannot be noted beside the grades, which is no failure of the export."""
    out, totals = tmp_path / "out", tmp_path / "totals.csv"
    of = a_class(out, {"ann": record()})
    write_class(of)
    write_all(of)
    (out / ".lock").unlink(missing_ok=True)
    (out / ".lock").mkdir()  # like a folder that cannot be written, for every user
    assert main(["export", str(out), "--to", "csv", "--out", str(totals)]) == 0
    assert "ann" in totals.read_text(encoding="utf-8")
    assert "cannot note this export" in capsys.readouterr().err


def test_exports_and_tables_that_no_longer_agree_are_named(tmp_path, capsys):
    """Decisions after grading, submissions that changed, and exports of other grades."""
    folder, out = tmp_path / "in", tmp_path / "out"
    folder.mkdir()
    for name in ("ann", "bob"):
        (folder / name).mkdir()
        (folder / name / f"{NAME}.ipynb").write_bytes(name.encode())
    of = a_class(out, {"ann": record(), "bob": record(share=0.5)})
    found = {one.student: one for one in collect(folder)}
    entries = [
        one._replace(folder=str(folder), digest=digest_submission(found[one.student]))
        for one in of.entries
    ]
    of = of._replace(entries=entries)
    write_class(of)
    rows = write_all(of)

    def export():
        assert main(["export", str(out), "--to", "csv"]) == 0
        return capsys.readouterr().err

    assert export() == ""
    assert list_old_exports(of, rows) == []
    write(out / "overrides.csv", f"{COLUMNS}bob,{NAME},exposing_case,1,\n")
    rows = list_class_rows(of, read_decisions(out))
    assert list_old_exports(of, rows) == [str(out / "totals.csv")]
    assert "grades.csv, the report and the pages are older" in export()
    assert list_old_exports(of, rows) == []
    write_all(of)
    (folder / "bob" / f"{NAME}.ipynb").write_bytes(b"changed")
    (folder / "cy").mkdir()
    (folder / "cy" / f"{NAME}.ipynb").write_bytes(b"new")
    said = export()
    assert "older" not in said
    assert f"changed, came or went since they were graded: bob {NAME}, cy {NAME}; grade" in said
    shutil.rmtree(folder)
    assert "no longer in" in export()
    write(out / "exports.json", "[]")
    (out / "grades.csv").unlink()
    assert list_old_exports(of, rows) == []
    assert "older" in export()


def test_scores_come_back_from_nbgrader_while_no_other_command_writes(tmp_path, monkeypatch):
    """Students whom another command has just added keep their rows and pages."""
    out, seen = tmp_path / "grades", []
    old = a_class(out, {"ann": record()})
    write_class(a_class(out, {"ann": record(), "bob": record()}))
    (tmp_path / "gradebook.db").touch()

    def bring(of, folder):
        with open(out / LOCK, "wb") as lock:
            seen.append((len(of.entries), try_lock(lock)))
        return 0

    monkeypatch.setattr(nbgrader_course, "import_nbgrader_scores", bring)
    assert read_back_from_nbgrader(old, tmp_path) == 0
    assert seen == [(2, False)]
    assert "bob" in (out / "grades.csv").read_text("utf-8")
