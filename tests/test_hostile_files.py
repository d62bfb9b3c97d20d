"""Files, answers and programs that would break a reader, on purpose or by accident.

The rest of the class is graded, and nobody gains points.
"""

import io
import json
import os
import time
import zipfile

import numpy as np
import pytest

from kinoedu.course.judging import judge_outcomes, run_case
from kinoedu.course.lessons import find
from kinoedu.course.outcomes import Late, Raised
from kinoedu.grading.assignments.questions import read_assignment
from kinoedu.grading.collect.found import MOST_OF_ONE
from kinoedu.grading.collect.handing_in import find_answers
from kinoedu.grading.collect.marks import find_assignment
from kinoedu.grading.collect.notebook import (
    MOST_PARTS,
    Cell,
    UnreadableSubmission,
    parse_notebook,
    read_cells,
)
from kinoedu.grading.collect.submissions import collect
from kinoedu.grading.judge import answers as judge_answers
from kinoedu.grading.judge.answers import USED_UP, Question, run_program
from kinoedu.grading.judge.submission import grade
from kinoedu.grading.sandbox import talk
from kinoedu.grading.sandbox.sandbox import Reply
from kinoedu.grading.sandbox.talk import Talk

CELL = {"cell_type": "code", "source": "check(point_line_distance)"}
NOTEBOOK = json.dumps({"nbformat": 4, "cells": [CELL]}).encode()
EXERCISE = find("point_line_distance")


def packed(way: int, **files: bytes) -> bytes:
    """The bytes of a zip with these files."""
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", way) as archive:
        for name, data in files.items():
            archive.writestr(name, data)
    return stream.getvalue()


def spoilt(data: bytes) -> bytes:
    """The bytes with invalid ones where the compressed data begins."""
    return data[:50] + b"\xff" * 10 + data[60:]


ZIPS = {
    "its bytes are no deflated ones": spoilt(
        packed(zipfile.ZIP_DEFLATED, **{"01_geometry.ipynb": NOTEBOOK * 50})
    ),
    "it asks for 4 GB to be unpacked": packed(
        zipfile.ZIP_LZMA, **{"01_geometry.ipynb": NOTEBOOK * 50}
    ),
    "it is in another zip": packed(
        0, **{"inner.zip": packed(0, **{"01_geometry.ipynb": NOTEBOOK})}
    ),
    "it holds too many": packed(
        zipfile.ZIP_STORED, **{f"{at}.ipynb": NOTEBOOK for at in range(MOST_OF_ONE + 1)}
    ),
}


@pytest.mark.parametrize("data", ZIPS.values(), ids=ZIPS)
def test_a_zip_that_cannot_be_read_is_said_and_costs_nobody_else(data, tmp_path):
    for student, name, content in (("ann", "x.zip", data), ("bob", "01_geometry.ipynb", NOTEBOOK)):
        (tmp_path / student).mkdir()
        (tmp_path / student / name).write_bytes(content)
    ann, bob = collect(tmp_path)
    assert (ann.student, bool(ann.trouble), ann.data) == ("ann", True, b"")
    assert (bob.student, bob.trouble, bob.data) == ("bob", "", NOTEBOOK)


@pytest.mark.parametrize("outer", ["", "class/"])
@pytest.mark.parametrize("is_zip", [False, True], ids=["folder", "zip"])
def test_a_student_whose_files_are_all_hidden_is_named(tmp_path, is_zip, outer):
    """And hidden files of nobody, beside the students' folders or in those, make no student."""
    inner = packed(zipfile.ZIP_STORED, **{"../bob/01_geometry.ipynb": NOTEBOOK})
    files = {
        "ann/.ipynb_checkpoints/01_geometry.ipynb": NOTEBOOK,
        "bob/01_geometry.ipynb": NOTEBOOK,
        "bob/.git/hooks/x": b"",
        "dee/01_geometry.ipynb": NOTEBOOK,
        "cid/01_geometry.zip": inner,
        ".git/hooks/deep/x": b"",
        "__MACOSX/ann/._01_geometry.ipynb": b"",
    }
    files = {f"{outer}{name}": data for name, data in files.items()} | {".git/hooks/deep/x": b""}
    place = tmp_path / "class.zip"
    if is_zip:
        place.write_bytes(packed(zipfile.ZIP_STORED, **files))
    else:
        place = tmp_path / "class"
        for name, data in files.items():
            (place / name).parent.mkdir(parents=True, exist_ok=True)
            (place / name).write_bytes(data)
    found = {one.student: one.trouble for one in collect(place)}
    assert sorted(found) == ["ann", "bob", "cid", "dee"]
    assert found["bob"] == found["dee"] == ""
    assert all("no notebook" in found[one] for one in ("ann", "cid"))


def test_a_student_whose_folder_is_empty_is_named(tmp_path):
    """And an empty folder beside a notebook is no trouble."""
    for place in ("ann/01_geometry", "bob/old", ".git/refs"):
        (tmp_path / place).mkdir(parents=True)
    (tmp_path / "bob" / "01_geometry.ipynb").write_bytes(NOTEBOOK)
    found = {one.student: one.trouble for one in collect(tmp_path)}
    assert found == {"ann": "there is no notebook in what was handed in", "bob": ""}


def test_what_lies_beside_a_notebook_is_not_read_and_no_trouble(tmp_path):
    home = tmp_path / "ann" / "01_geometry"
    home.mkdir(parents=True)
    (home / "01_geometry.ipynb").write_bytes(NOTEBOOK)
    with open(home / "film.mp4", "wb") as file:
        file.truncate(2**30)
    (home / "link.txt").symlink_to("/etc/passwd")
    (tmp_path / "bob.zip").write_bytes(
        packed(zipfile.ZIP_DEFLATED, **{"01_geometry.ipynb": NOTEBOOK, "zeros": bytes(2**28)})
    )
    assert [(one.student, one.trouble) for one in collect(tmp_path)] == [("ann", ""), ("bob", "")]


def test_names_without_end_are_cut(tmp_path):
    (tmp_path / "ann").mkdir()
    files = {"a/" * 20_000 + f"{at}/01_geometry.ipynb": NOTEBOOK + b" " * at for at in range(50)}
    (tmp_path / "ann" / "x.zip").write_bytes(packed(zipfile.ZIP_STORED, **files))
    (one,) = collect(tmp_path)
    assert "more than once" in one.trouble and len(one.trouble) + len(one.file) < 4000


def test_names_that_are_none_cost_nobody_a_grade(tmp_path):
    """A member whose name begins with a NUL, one that is a point, and one from the root."""
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w") as archive:
        archive.writestr("01_geometry.ipynb", "{}")
        archive.writestr("X", "")
    work = bytearray(packed.getvalue())
    for mark, offset in ((b"PK\x03\x04", 30), (b"PK\x01\x02", 46)):
        at = work.rfind(mark) + offset
        assert work[at : at + 1] == b"X"
        work[at] = 0
    with zipfile.ZipFile(tmp_path / "class.zip", "w") as archive:
        archive.writestr("ann.zip", bytes(work))
        archive.writestr("bob/01_geometry.ipynb", "{}")
        archive.writestr("/cy/01_geometry.ipynb", "{}")
        archive.writestr(".", "")
    found = collect(tmp_path / "class.zip")
    assert [(one.student, one.trouble) for one in found] == [("ann", ""), ("bob", ""), ("cy", "")]


def test_a_damaged_file_in_the_zip_of_a_class_costs_only_its_student_a_grade(tmp_path):
    """A byte that was changed on the way does not keep the others from being graded."""
    members = {f"{name}/01_geometry.ipynb": NOTEBOOK + name.encode() for name in ("ann", "bob")}
    data = packed(zipfile.ZIP_STORED, **members)
    (tmp_path / "class.zip").write_bytes(data.replace(NOTEBOOK + b"ann", NOTEBOOK + b"and"))
    ann, bob = collect(tmp_path / "class.zip")
    assert (ann.student, bob.student, bob.trouble) == ("ann", "bob", "")
    assert "it cannot be read in its zip: Bad CRC-32" in ann.trouble


def test_a_long_name_in_a_zip_is_read_at_once():
    """What copies add to names is looked for in as many letters as a name in a folder may have."""
    assert find_assignment("-1" * 2**20 + "x.ipynb", (), {}, ["01_geometry"]) == ""
    assert find_assignment("01_geometry (1)-2.ipynb", (), {}, ["01_geometry"]) == "01_geometry"


def test_a_name_steers_no_terminal(tmp_path, capsys):
    from kinoedu.cli.grade import sum_up
    from kinoedu.grading.judge.class_list import Class, Entry
    from kinoedu.grading.report.rows import UNREADABLE, Row

    (tmp_path / "ann").mkdir()
    (tmp_path / "ann" / "01_geometry\x1b[2J\u202e.ipynb").write_bytes(b"")
    (one,) = collect(tmp_path)
    assert one.file.isprintable()
    entry = Entry("bob\x1b]0;mine\x07", "01_geometry", "x", "", "", "", "", "")
    row = Row(entry.student, entry.assignment, "", None, 0.0, UNREADABLE, "no\x1b[31m notebook")
    assert sum_up(Class(tmp_path, "", "", False, [entry]), [row]) == 1
    assert capsys.readouterr().out.replace("\n", "").isprintable()


def test_a_class_without_similar_programs_has_a_page(tmp_path):
    from kinoedu.grading.report.similar import Similar
    from kinoedu.grading.report.similar_page import write_similar

    assert write_similar([Similar("01_geometry", [], [], [])], tmp_path / "new") == 0
    assert (tmp_path / "new" / "similar.html").exists()


@pytest.mark.parametrize(
    "part", ['{"a":' * 500 + "1" + "}" * 500, "[]", '{"a":{}}'], ids=["deep", "lists", "tables"]
)
def test_a_notebook_that_would_fill_the_memory_is_refused_before_it_is_read(part):
    many = ",".join([part] * (MOST_PARTS // part.count(part[0]) + 1))
    data = f'{{"nbformat": 4, "cells": [], "more": [{many}]}}'.encode()
    with pytest.raises(UnreadableSubmission, match="more numbers and words"):
        parse_notebook(data)


@pytest.mark.parametrize(
    ("source", "wanted"),
    [
        ("x = (\n    7\n    % 4\n)\n", "x = (\n    7\n    % 4\n)\n"),
        ('t = """\n%a\n!b\n"""', 't = """\n%a\n!b\n"""'),
        ("%%time\nx = 1\n", "# %%time\nx = 1\n"),
        ("%%bash\nx = 1\n", "get_ipython().run_cell_magic('bash', '', 'x = 1\\n')\n"),
        (None, None),
        (7, None),
        (["x = 1\n", 7, None, "y = 2\ud800"], "x = 1\ny = 2?\n"),
    ],
)
def test_a_cell_of_any_kind_is_read_as_python(source, wanted):
    data = json.dumps({"nbformat": 4, "cells": [{"cell_type": "code", "source": source}]}).encode()
    assert read_cells(data) == [Cell(1, wanted)] * (wanted is not None)


ODD = [None, 7, "text", [], [None]]
ODD += [{"nbgrader": None}, {"nbgrader": [1]}, {"data": {"text/plain": 7}}]


@pytest.mark.parametrize("odd", ODD, ids=str)
def test_handing_in_reads_any_notebook(odd):
    cells = [
        {"cell_type": "code", "source": "check(bug1)", "metadata": odd, "outputs": odd},
        {"source": odd, "outputs": [odd]},
        odd,
    ]
    data = json.dumps({"nbformat": 4, "cells": cells}).encode()
    assert not any(answered for answered, _ in find_answers(data, "01_geometry").values())


@pytest.mark.parametrize(
    "end",
    [
        Late(False),
        Raised(["NotImplementedError"], "", [], ""),
        Raised(["Stopped"], "", [], ""),
        None,
    ],
)
def test_kinds_that_were_not_finished_count_as_failed(end):
    cases = list(EXERCISE.cases(np.random.default_rng(0)))
    every_one = [run_case(EXERCISE, EXERCISE.reference, case) for case in cases]
    assert judge_outcomes(EXERCISE, cases, every_one).score == 1.0
    for at in range(len(cases)):
        report = judge_outcomes(EXERCISE, iter(cases), every_one[:at] + [end] * (end is not None))
        assert set(report.failed) >= {case.kind for case in cases[at:]}


class Liar:
    """A sandbox whose program returned these lines and ended this way."""

    def __init__(self, parts: list[list[dict]], end: str) -> None:
        self.reply, self.requests = Reply(parts, end), 0

    def ask(self, *_: object) -> Reply:
        """Return the same reply each time, and count the requests."""
        self.requests += 1
        return self.reply


def question(name: str) -> Question:
    """A question with its cases."""
    return Question(find(name), list(find(name).cases(np.random.default_rng(0))), 2)


def test_breaking_off_again_and_again_takes_no_more_time_than_once(monkeypatch):
    monkeypatch.setattr(judge_answers, "LONGEST", -1.0)
    liar = Liar([[{"ready": True}]], "late")
    found = run_program(
        liar, [Cell(1, "")], [question(EXERCISE.name), question("point_segment_distance")]
    ).outcomes
    assert liar.requests == 0 and list(found.values()) == [[USED_UP]] * 2


class Sleeper(Liar):
    """A sandbox that needs a moment for each request."""

    def ask(self, *_: object) -> Reply:
        """Return the reply after a moment."""
        time.sleep(0.1)
        return super().ask()


@pytest.mark.parametrize(
    "ready", [[{"ready": True}], [{"ready": True}, {"cell": 1, "troubles": []}]]
)
def test_where_the_time_of_the_notebook_was_over_no_answer_is_blamed(monkeypatch, ready):
    """Its cells may have used it up, in which the exchange ended, or before a function's case."""
    monkeypatch.setattr(judge_answers, "LONGEST", 0.05)
    monkeypatch.setattr(judge_answers, "slowdown", lambda: 1.0)
    parts = [ready, []][: len(ready)]
    record = grade(NOTEBOOK, read_assignment("01_geometry"), b"secret", Sleeper(parts, "late"))
    for one in record["questions"]:
        assert (one["status"], one["late"], one["failure"]) == ("too late", True, None)
        assert "The time for the whole notebook was over" in one["message"]
        assert "Which cells compute for seconds?" in one["hint"]


def test_lines_that_would_fill_the_memory_are_a_flood(monkeypatch):
    monkeypatch.setattr(talk, "MOST_PARTS", 1000)
    ends = []
    for line in (b'{"cell": 1}\n' * 3, b'{"a": [' + b"{}," * 500 + b"{}]}\n"):
        reply_end, replies = os.pipe()
        os.write(replies, line)
        os.close(replies)
        conversation = Talk(os.open(os.devnull, os.O_WRONLY), reply_end, 1.0)
        list(conversation.lines())
        ends.append(conversation.end)
        os.close(reply_end)
        os.close(conversation.requests)
    assert ends == ["died", "flood"]


ESCAPES = "\x1b]0;mine\x07 \u202eevil \x9b2J \u2066hidden\u2069 \u200b \x00"
SHOWN = r"\x1b]0;mine\x07 \u202eevil \x9b2J \u2066hidden\u2069 \u200b \x00"


def test_control_characters_are_shown_as_text(tmp_path):
    """In pages, tables, on the terminal and in Gradescope's results; line ends stay."""
    from kinoedu.grading.export.tables import make_gradescope_results
    from kinoedu.grading.report.pages import page, paragraph, write_page
    from kinoedu.grading.report.rows import Row, write_grades
    from kinoedu.support.csv_cells import one_line

    write_page(tmp_path / "page.html", page("x", [paragraph(f"{ESCAPES}\n\tend \ud800")]))
    text = (tmp_path / "page.html").read_text(encoding="utf-8")
    assert f"{SHOWN}\n\tend \\ud800" in text
    row = Row(ESCAPES, "01_geometry", "q", 1.0, 2.0, "wrong", f"ValueError: {ESCAPES}")
    write_grades([row], tmp_path / "grades.csv")
    table = (tmp_path / "grades.csv").read_text(encoding="utf-8")
    assert table.count(SHOWN) == 2
    assert not any(c in table for c in "\x1b\u202e\x9b\u2066\u200b\x00")
    assert one_line(ESCAPES) == SHOWN
    assert SHOWN in make_gradescope_results([row])["tests"][0]["output"]
