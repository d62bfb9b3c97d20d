"""A class that is graded again has each submission once, and each student under one name."""

import csv
import json
import unicodedata

import pytest
from submissions import notebook

from kinoedu.cli import main
from kinoedu.grading import class_grading
from kinoedu.grading.judge.running import Graded
from kinoedu.grading.judge.variants import write_variants

SECRET = b"a secret of the tests, no course's"
LINE, BUG = "def line_through_points(p1, p2):\n    pass\n", "def bug1(*given):\n    pass\n"


@pytest.fixture
def start(tmp_path, monkeypatch):
    """Run a command on folders within `tmp_path`; nothing is run, and no submission has a result.

    Returns the lines of a table of a folder of grades.
    """
    monkeypatch.setattr(
        class_grading,
        "grade_all",
        lambda submissions, *_, **__: [Graded(one, None, one.trouble) for one in submissions],
    )
    monkeypatch.setattr(class_grading, "require_sandbox", lambda trusted: None)
    monkeypatch.chdir(tmp_path)
    (tmp_path / "secret").write_text(SECRET.hex())

    def run(*command, out, table="grades.csv"):
        assert main([*command, "--secret", "secret", "--out", out]) in (0, 1)
        with (tmp_path / out / table).open(encoding="utf-8", newline="") as stream:
            return list(csv.reader(stream))[1:]

    return run


def hand_in(folder, student, **sources):
    """Write a student's notebooks."""
    (folder / student).mkdir(parents=True, exist_ok=True)
    for name, source in sources.items():
        (folder / student / f"{name.strip('_')}.ipynb").write_bytes(notebook(source))


def test_a_folder_that_was_graded_whole_and_in_part_has_each_submission_once(tmp_path, start):
    """Also those that were handed in since."""
    hand_in(tmp_path / "in", "ann", _01_geometry=LINE, _02_bug_algorithms=BUG)
    start("grade", "in", out="out")
    before = start("grade", "in", "--assignment", "01_geometry", out="out")
    hand_in(tmp_path / "in", "bob", _01_geometry=LINE, _02_bug_algorithms=BUG)
    after = start("regrade", "out", out="new")
    asked = [row[:3] for row in before]
    assert [row[:3] for row in after] == asked + [["bob", *row[1:]] for row in asked]


@pytest.mark.parametrize("command", [["in", "--assignment", "01_geometry"], ["again"]])
def test_what_was_graded_again_from_elsewhere_has_not_changed(tmp_path, start, capsys, command):
    """Such as work that was handed in again, in a folder of its own."""
    hand_in(tmp_path / "in", "ann", _01_geometry=LINE, _02_bug_algorithms=BUG)
    hand_in(tmp_path / "again", "ann", _01_geometry=f"{LINE}x = 1\n")
    start("grade", "in", out="out")
    start("grade", *command, out="out")
    capsys.readouterr()
    assert main(["export", "out", "--to", "csv", "--out", "table.csv"]) == 0
    assert "changed" not in capsys.readouterr().err
    hand_in(tmp_path / command[0], "ann", _01_geometry=f"{LINE}x = 2\n")
    assert main(["export", "out", "--to", "csv", "--out", "table.csv"]) == 0
    assert "came or went since they were graded: ann 01_geometry" in capsys.readouterr().err


def test_a_name_that_an_older_version_spelled_otherwise_is_the_same_student(tmp_path, start):
    """It kept an accent as macOS writes it; decisions and pages are those of one student."""
    name, apart = (unicodedata.normalize(form, "zoë") for form in ("NFC", "NFD"))
    hand_in(tmp_path / "in", apart, _01_geometry=LINE)
    start("grade", "in", out="out")
    file = tmp_path / "out" / "class.json"
    file.write_text(file.read_text(encoding="ascii").replace(json.dumps(name), json.dumps(apart)))
    (tmp_path / "out" / "overrides.csv").write_text(
        f"student,assignment,question,score,comment\n{apart},01_geometry,exposing_case,1,\n",
        encoding="utf-8",
    )
    assert start("regrade", "out", out="new", table="changes.csv") == []
    hand_in(tmp_path / "more", "ann", _01_geometry=LINE)
    assert {row[0] for row in start("grade", "more", out="out")} == {"ann", name}


def test_variants_are_remembered_where_a_moved_folder_has_left_a_link(tmp_path, start):
    """The folder is found under both names."""
    write_variants(["04_graph_search"], ["ann", "bob"], SECRET, tmp_path / "in")
    (tmp_path / "in" / "variants.csv").unlink()
    start("grade", "in", "--variants", out="out")
    (tmp_path / "in").rename(tmp_path / "moved")
    (tmp_path / "in").symlink_to(tmp_path / "moved")
    for out in ("new", "newer"):
        assert start("regrade", "out", out=out, table="changes.csv") == []
    for command in (["grade", "in"], ["grade", "moved"]):
        assert {row[5] for row in start(*command, out="out")} == {"not graded"}


def test_decisions_go_along_and_what_was_decided_since_stays(tmp_path, start):
    """Scores by hand are those of the new folder too, until it has a file of its own."""
    lines = {
        "overrides.csv": "ann,01_geometry,exposing_case,{},\n",
        "by_hand.csv": "ann,02_bug_algorithms,flowchart_bug1,{},\n",
    }

    def decide(folder, score):
        for name, line in lines.items():
            text = f"student,assignment,question,score,comment\n{line.format(score)}"
            (tmp_path / folder / name).write_text(text, encoding="utf-8")

    hand_in(tmp_path / "in", "ann", _01_geometry=LINE, _02_bug_algorithms=BUG)
    start("grade", "in", out="out")
    decide("out", 1)
    for score in (1, 2):
        rows = start("regrade", "out", out="new")
        scores = {row[2]: row[3] for row in rows if row[3]}
        assert scores == dict.fromkeys(("exposing_case", "flowchart_bug1"), str(score))
        decide("new", 2)


def test_a_class_of_several_folders_is_graded_again_where_each_was(tmp_path, start, capsys):
    """Without a folder; with one it is not known whose work lies there."""
    for name in ("ann", "bob"):
        hand_in(tmp_path / f"in_{name}", name, _01_geometry=LINE)
        start("grade", f"in_{name}", out="out")
    assert {row[0] for row in start("regrade", "out", out="new")} == {"ann", "bob"}
    command = ["regrade", "out", "--submissions", "in_ann", "--secret", "secret", "--out", "other"]
    assert main(command) == 2
    assert "put each where it was: " in capsys.readouterr().err


def test_regrading_refuses_another_secret(tmp_path, start, capsys):
    """Hidden inputs would differ, and scores with them; the message says where the right one is."""
    hand_in(tmp_path / "in", "ann", _01_geometry=LINE)
    start("grade", "in", out="out")
    (tmp_path / "another").write_text((b"!" + SECRET).hex())
    capsys.readouterr()
    assert main(["regrade", "out", "--secret", "another", "--out", "new"]) == 2
    assert f"the secret that was in {tmp_path / 'secret'}; give it with" in capsys.readouterr().err


def test_a_decision_about_nobody_is_mended_in_the_new_folder(tmp_path, start, capsys):
    """It is refused before it is copied; a file that is there already is read in its place."""
    hand_in(tmp_path / "in", "ann", _01_geometry=LINE)
    start("grade", "in", out="out")
    lines = "student,assignment,question,score,comment\n{},01_geometry,exposing_case,1,\n"
    (tmp_path / "out" / "overrides.csv").write_text(lines.format("anne"))
    capsys.readouterr()
    assert main(["regrade", "out", "--secret", "secret", "--out", "new"]) == 2
    assert "anne" in capsys.readouterr().err
    assert not (tmp_path / "new").exists()
    (tmp_path / "new").mkdir()
    (tmp_path / "new" / "overrides.csv").write_text(lines.format("ann"))
    rows = start("regrade", "out", out="new")
    assert {row[2]: row[3] for row in rows if row[3]} == {"exposing_case": "1"}
