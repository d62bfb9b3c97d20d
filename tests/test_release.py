"""Exercises are made from solutions, hold no answers, and are what is committed."""

import json
import os
import shutil
from pathlib import Path

import nbformat
import numpy as np
import pytest

from kinoedu.cli import main
from kinoedu.course import EXERCISES
from kinoedu.course import release as release_module
from kinoedu.course.assignments import list_assignments
from kinoedu.course.release import (
    assignments,
    exercises_without_solution,
    files_for_students,
    release,
    remove_answers,
    require_released,
    run_notebook,
)
from kinoedu.errors import InvalidParameter, UnreadableScene
from kinoedu.grading.assignments import questions
from kinoedu.grading.assignments.questions import read_assignment
from kinoedu.grading.judge.variants import write_section
from kinoedu.slides import make_slides

HOUSE = Path(__file__).resolve().parent.parent


def sources(book):
    """The sources and kinds of the cells, without what running them added."""
    return [
        (cell["cell_type"], cell["source"], cell["metadata"], cell["id"]) for cell in book["cells"]
    ]


@pytest.mark.parametrize("name", assignments())
def test_the_committed_exercise_is_what_its_solution_makes(name):
    """Else it was edited by hand, or not released again: python start.py release."""
    made = remove_answers(HOUSE / "solutions" / f"{name}.ipynb")
    committed = nbformat.read(HOUSE / "exercises" / f"{name}.ipynb", as_version=4)
    assert sources(committed) == sources(made)


@pytest.mark.parametrize("name", assignments())
def test_an_exercise_tells_no_answer(name):
    """No line of a solution, no mark of one, and no output that an answered notebook has."""
    solution = nbformat.read(HOUSE / "solutions" / f"{name}.ipynb", as_version=4)
    text = (HOUSE / "exercises" / f"{name}.ipynb").read_text(encoding="utf-8")
    exercise = json.loads(text)
    assert "BEGIN SOLUTION" not in text
    assert "right, for all" not in text
    sources = {"".join(cell["source"]) for cell in exercise["cells"]}
    given = {line.strip() for cell in solution.cells for line in outside_answers(cell.source)}
    for cell in solution.cells:
        if "BEGIN SOLUTION" in cell.source:
            secret = cell.source.split("### BEGIN SOLUTION")[1].split("### END SOLUTION")[0]
            for line in {*map(str.strip, secret.splitlines())} - given - {""}:
                assert not any(line in other for other in sources), line


def outside_answers(source):
    """The lines of a solution's cell that students get as well."""
    before, *rest = source.split("### BEGIN SOLUTION")
    return "\n".join([before, *(part.split("### END SOLUTION")[-1] for part in rest)]).splitlines()


@pytest.mark.parametrize("name", assignments())
def test_points_are_the_kinds_of_input(name):
    """What nbgrader counts for a check is what the judge counts."""
    for cell in nbformat.read(HOUSE / "solutions" / f"{name}.ipynb", as_version=4).cells:
        mark = cell.metadata.get("nbgrader", {})
        if mark.get("grade") and cell.cell_type == "code":
            exercise = EXERCISES[mark["grade_id"].removeprefix("check_")]
            assert mark["points"] == len(exercise.kinds)
            assert exercise.lesson == name


@pytest.mark.parametrize("name", assignments())
def test_the_solutions_answers_are_right_for_another_seed(name):
    """What the solution says is right on cases that nobody has seen; grading asks with one seed
    more.
    """
    from kinoedu.course.judging import judge_outcomes, run_case

    names = {}
    for cell in nbformat.read(HOUSE / "solutions" / f"{name}.ipynb", as_version=4).cells:
        if (
            cell.cell_type == "code"
            and not cell.source.startswith("check(")
            and "show(" not in cell.source
        ):
            exec(compile(cell.source, "solution.py", "exec"), names)
    exercises = [exercise for exercise in EXERCISES.values() if exercise.lesson == name]
    assert exercises
    for exercise in exercises:
        cases = list(exercise.cases(np.random.default_rng(1)))
        exercise.describe_expected(cases[0])
        outcomes = (run_case(exercise, names[exercise.name], case) for case in cases)
        report = judge_outcomes(exercise, cases, outcomes)
        assert report.is_right, (exercise.name, report.failure)


@pytest.fixture
def house(tmp_path):
    """A small house with one assignment."""
    for room in ("solutions", "exercises"):
        (tmp_path / room).mkdir()
    shutil.copy(HOUSE / "solutions" / "01_geometry.ipynb", tmp_path / "solutions")
    return tmp_path


def test_release_runs_every_cell_and_stores_no_times(house):
    """The same twice; every check says that nothing is answered yet."""
    first = release("01_geometry", house).read_text(encoding="utf-8")
    assert release("01_geometry", house).read_text(encoding="utf-8") == first
    exercises = [one for one in EXERCISES.values() if one.lesson == "01_geometry"]
    assert first.count("not answered yet") == 2 * len(exercises)  # as text and as HTML
    assert '"execution"' not in first
    assert "iopub" not in first


def test_a_model_answer_is_left_out_as_a_whole(house):
    """A code cell that is nothing but a solution, unmarked; one that says more than that, students
    would get in part: refused.
    """
    file = house / "solutions" / "01_geometry.ipynb"
    book = nbformat.read(file, as_version=4)
    whole = sources(remove_answers(file))
    book.cells.append(nbformat.v4.new_code_cell("### BEGIN SOLUTION\n1 / 0\n### END SOLUTION"))
    nbformat.write(book, file)
    assert sources(remove_answers(file)) == whole
    book.cells[-1].source += "\n2 / 0"
    nbformat.write(book, file)
    with pytest.raises(InvalidParameter, match="01_geometry"):
        remove_answers(file)


def test_a_notebook_without_solution_is_not_packed(house, monkeypatch):
    """A copy of an exercise, in which the teacher has written answers, stays with the teacher."""
    places = [house / "exercises" / name for name in ("01_geometry.ipynb", "README.md")]
    copies = [
        house / "exercises" / name
        for name in ("01_geometry-Copy1.ipynb", "01_geometry.zip", "old/a.ipynb")
    ]
    (house / "exercises" / "old").mkdir()
    for place in places + copies:
        place.write_text("{}")
    monkeypatch.setattr(release_module, "FOR_STUDENTS", ())
    monkeypatch.setattr(release_module, "FOLDERS_FOR_STUDENTS", ("exercises",))
    monkeypatch.setattr(release_module, "students_readme", lambda house: "")
    packed = [house / name for name in files_for_students(house) if name != "README.md"]
    assert packed == places
    assert exercises_without_solution(house) == copies


def test_an_exercise_with_answers_in_it_is_not_packed(house):
    """A teacher who tries an exercise, saves it, and releases another one with --zip."""
    name, exercise = "01_geometry", house / "exercises" / "01_geometry.ipynb"
    require_released(name, house)  # there is none
    nbformat.write(remove_answers(house / "solutions" / f"{name}.ipynb"), exercise)
    require_released(name, house)
    shutil.copy(house / "solutions" / f"{name}.ipynb", exercise)
    with pytest.raises(InvalidParameter, match="may have answers in it: release 01_geometry again"):
        require_released(name, house)


def test_a_zip_of_one_exercise_is_refused_where_another_has_answers(tmp_path, monkeypatch, capsys):
    """Before anything is released."""

    def refuse(name):
        raise InvalidParameter(f"{name} may have answers in it")

    monkeypatch.setattr(release_module, "assignments", lambda: ["01_a", "02_b"])
    monkeypatch.setattr(release_module, "require_released", refuse)
    assert main(["release", "01_a", "--zip", str(tmp_path / "course.zip")]) == 2
    assert "02_b may have answers in it" in capsys.readouterr().err


def test_release_refuses_what_could_not_be_graded(monkeypatch, capsys):
    """Such as a solution with imports that lend nothing to graded programs."""

    def refuse(name):
        raise InvalidParameter(f"{name} has an import that lends nothing")

    monkeypatch.setattr(questions, "read_assignment", refuse)
    monkeypatch.setattr(release_module, "release", lambda name: Path(name))
    assert main(["release", "01_geometry"]) == 2
    assert "01_geometry has an import that lends nothing" in capsys.readouterr().err


def test_release_refuses_what_it_cannot_make(house):
    """An unknown name, an answer without its end, a notebook that fails: nothing is written."""
    with pytest.raises(InvalidParameter, match="01_geometry"):
        release("99_nothing", house)
    file = house / "solutions" / "01_geometry.ipynb"
    whole = file.read_text(encoding="utf-8")
    file.write_text(whole.replace("### END SOLUTION", ""), encoding="utf-8")
    with pytest.raises(InvalidParameter, match="01_geometry"):
        release("01_geometry", house)
    file.write_text(
        whole.replace("check(line_through_points)", "check(no_such_function)"), encoding="utf-8"
    )
    with pytest.raises(InvalidParameter, match="no_such_function"):
        release("01_geometry", house)
    assert not list((house / "exercises").iterdir())


BUSY = """from kinoedu.support import time_limit

def run_late(clock, work):
    raise time_limit.TimeUp(used=9.0, allowed=5.0, passed=9.0)

time_limit.run_bounded = run_late"""


def test_release_on_a_busy_computer_stores_no_time_out(house):
    """A check that ran out of time ends the release, and the cell is named."""
    file = house / "solutions" / "01_geometry.ipynb"
    book = nbformat.read(file, as_version=4)
    book.cells.insert(1, nbformat.v4.new_code_cell(BUSY))
    nbformat.write(book, file)
    with pytest.raises(
        InvalidParameter, match=r"cell \d+, check\(line_through_points\).*9\.0"
    ) as error:
        release("01_geometry", house)
    assert "not answered" not in str(error.value)
    assert not list((house / "exercises").iterdir())


def test_release_stores_no_check_that_was_answered(house):
    """Such as one of an answer that is not marked as a solution."""
    file = house / "solutions" / "01_geometry.ipynb"
    book = nbformat.read(file, as_version=4)
    given = "from kinoedu.geometry import line_through_points\ncheck(line_through_points)"
    for cell in book.cells:
        cell.source = cell.source.replace("check(line_through_points)", given)
    nbformat.write(book, file)
    with pytest.raises(InvalidParameter, match="must say that nothing is answered yet"):
        release("01_geometry", house)


def test_a_zip_that_cannot_be_written_is_refused_before_anything_is_released(
    tmp_path, monkeypatch, capsys
):
    """A release takes minutes."""

    def refuse(name):
        raise AssertionError(f"{name} is released")

    monkeypatch.setattr(release_module, "release", refuse)
    assert main(["release", "--zip", str(tmp_path)]) == 2
    assert "cannot be written: it is a folder" in capsys.readouterr().err
    monkeypatch.setattr(os, "access", lambda place, mode: False)
    assert main(["release", "--zip", str(tmp_path / "course.zip")]) == 2
    assert "nothing can be written in" in capsys.readouterr().err


DAMAGED = {
    "merge": b'<<<<<<< HEAD\n{"cells": []}\n',
    "cut off": b'{"cells": [{"cell_type": "code", "sour',
    "empty": b"",
    "a list": b"[]",
    "no cells": b"{}",
    "half a cell": b'{"cells": [{"cell_type": "code", "metadata": {}}]}',
    "UTF-16": '{"cells": []}'.encode("utf-16"),
}


@pytest.mark.parametrize("damage", DAMAGED)
def test_a_damaged_notebook_of_the_course_is_named(house, damage):
    """Every command reads all solutions, so one damaged file must not end them without its name."""
    for room in ("solutions", "exercises"):
        (house / room / "09_cut.ipynb").write_bytes(DAMAGED[damage])
    readers = [
        lambda: list_assignments(house, house / "no_list"),
        lambda: read_assignment("09_cut", house),
        lambda: remove_answers(house / "solutions" / "09_cut.ipynb"),
        lambda: require_released("09_cut", house),
        lambda: write_section(["09_cut"], "B", house / "out", house),
        lambda: make_slides("09_cut", house / "slides", house / "solutions"),
    ]
    for read in readers:
        with pytest.raises(UnreadableScene, match=r"09_cut\.ipynb: expected"):
            read()
    assert read_assignment("01_geometry", house).questions


@pytest.mark.skipif(os.name == "nt", reason="a process cannot send Ctrl-C to one other there")
def test_ctrl_c_ends_a_notebook(tmp_path, capfd):
    """And its kernel, without a traceback."""
    code = (
        "import os, signal, time\nopen('pid', 'w').write(str(os.getpid()))\n"
        "os.kill(os.getppid(), signal.SIGINT)\ntime.sleep(60)"
    )
    book = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(code)])
    with pytest.raises(KeyboardInterrupt):
        run_notebook(book, tmp_path)
    with pytest.raises(ProcessLookupError):
        os.kill(int((tmp_path / "pid").read_text()), 0)
    assert capfd.readouterr().err == ""


def test_no_warning_of_the_teachers_computer_is_stored(tmp_path):
    """Such as matplotlib's that it builds its list of fonts; it may name the teacher's folders."""
    code = "import sys\nprint('kept')\nprint('/home/somebody', file=sys.stderr)"
    book = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(code)])
    book.metadata = {"kernelspec": {"name": "python3", "display_name": "Python 3"}}
    (cell,) = run_notebook(book, tmp_path).cells
    assert [output.text for output in cell.outputs] == ["kept\n"]
