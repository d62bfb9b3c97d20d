"""A new exercise is complete from the start: in a copy of the project it passes all tests."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from kinoedu.cli import main
from kinoedu.course.new_exercise import LIST, new_exercise
from kinoedu.errors import InvalidParameter

HOUSE = Path(__file__).resolve().parent.parent
NAME, LESSON = "halfway_there", "77_midpoints"
ROOM = "kinoedu/course/lessons/midpoints"
COPIED_TESTS = (
    *("test_course.py", "test_bank.py", "test_release.py"),
    *("judged_programs.py", "nbval.cfg"),
)
# called without the fixture of its file, which compiles everything
WORDS = "import test_course as t; t.test_every_word_is_there_and_used()"
MARKS = (
    "from kinoedu.grading.assignments.questions import read_assignment as a; "
    "print([one.points for one in a({!r}).questions])"
)


@pytest.fixture(scope="module")
def house(tmp_path_factory):
    """A copy of the project, without what takes long."""
    copy = tmp_path_factory.mktemp("house")
    shutil.copytree(
        HOUSE / "kinoedu", copy / "kinoedu", ignore=shutil.ignore_patterns("__pycache__")
    )
    shutil.copytree(  # with the notebooks, whose text the banks change
        HOUSE / "solutions", copy / "solutions", ignore=shutil.ignore_patterns("__pycache__")
    )
    for room in ("tests/lessons", "exercises", "docs"):
        (copy / room).mkdir(parents=True)
    tests = [f"tests/{name}" for name in COPIED_TESTS]
    for name in ("pyproject.toml", "docs/rendering.py", *tests):
        shutil.copy(HOUSE / name, copy / name)
    return copy


def run(house: Path, *command: str) -> subprocess.CompletedProcess:
    """Run Python in a copy of the project, with that copy's kinoedu."""
    # without numba, which would compile everything anew for this copy
    environment = {**os.environ, "PYTHONPATH": str(house), "NUMBA_DISABLE_JIT": "1"}
    return subprocess.run(
        [sys.executable, "-P", *command],
        cwd=house,
        env=environment,
        capture_output=True,
        text=True,
        encoding="utf-8",
        check=False,
    )


def lint(house: Path, files: list[str]) -> None:
    """Run the linters on the files of a new exercise."""
    programs = [file for file in files if file.endswith(".py")]
    for tool in (["check", *files], ["format", "--check", *programs]):
        ruff = run(house, "-m", "ruff", *tool)
        assert ruff.returncode == 0, ruff.stdout


def sources(file: Path) -> list[str]:
    """Sources of a notebook's cells."""
    return [
        "".join(cell["source"]) for cell in json.loads(file.read_text(encoding="utf-8"))["cells"]
    ]


@pytest.fixture(scope="module")
def listed(house):
    """The files of an exercise that was made in the house, as the command lists them."""
    made = run(house, "-m", "kinoedu", "new-exercise", NAME, "--lesson", LESSON)
    assert made.returncode == 0, made.stderr
    return [line.strip() for line in made.stdout.splitlines()]


def test_a_new_exercise_passes_the_tests_of_the_house(house, listed):
    """Its own test, those of all exercises, banks and solutions, and the linters pass.

    Then it is released.
    """
    assert {
        f"solutions/{LESSON}.ipynb",
        f"{ROOM}/{NAME}.py",
        f"tests/lessons/test_{NAME}.py",
        f"{ROOM}/__init__.py",
    } <= set(listed)
    assert "right, for all" in (house / "solutions" / f"{LESSON}.ipynb").read_text(encoding="utf-8")
    released = run(house, "-m", "kinoedu", "release", LESSON)
    assert released.returncode == 0, released.stderr
    assert not any(
        "p1 + p2" in source for source in sources(house / "exercises" / f"{LESSON}.ipynb")
    )
    files = [f"tests/lessons/test_{NAME}.py", "tests/test_bank.py", "tests/test_release.py"]
    chosen = f"{NAME} or {LESSON}"
    tests = run(
        house,
        "-m",
        "pytest",
        "-q",
        "-n0",
        "-p",
        "no:cacheprovider",
        "--rootdir",
        str(house),
        *files,
        "-k",
        chosen,
    )
    assert tests.returncode == 0, tests.stdout + tests.stderr
    assert "skipped" not in tests.stdout
    mine = [line for line in listed if line.endswith((".py", ".ipynb"))]
    lint(house, mine)


@pytest.mark.usefixtures("listed")
def test_a_second_exercise_goes_to_the_end_of_its_lesson(house):
    """Existing files are unchanged, the cells have nbgrader's metadata, every message exists."""
    before = sources(house / "solutions" / f"{LESSON}.ipynb")
    assert (
        run(house, "-m", "kinoedu", "new-exercise", "second_try", "--lesson", LESSON).returncode
        == 0
    )
    assert sources(house / "solutions" / f"{LESSON}.ipynb")[: len(before)] == before
    code = f"import sys; sys.path.insert(0, 'tests'); {WORDS}; {MARKS.format(LESSON)}"
    ran = run(house, "-c", code)
    assert ran.stdout.strip() == "[3.0, 3.0]", ran.stderr


PLAIN = '''
import numpy as np

def closest_point_on_polygon(q: "point", polygon: "polygon") -> "point":
    """The point of a polygon's boundary that is nearest to q.

    >>> closest_point_on_polygon((2, -1), [(0, 0), (4, 0), (4, 3), (0, 3)])
    (2, 0)
    """
    best, least = polygon[0], np.inf
    for a, b in zip(polygon, np.roll(polygon, -1, axis=0)):
        p = a + np.clip((q - a) @ (b - a) / ((b - a) @ (b - a)), 0, 1) * (b - a)
        if np.hypot(*(q - p)) < least - 1e-9:
            best, least = p, np.hypot(*(q - p))
    return best
'''


def test_an_exercise_from_a_plain_function_passes_the_tests_of_the_house(house, tmp_path):
    """Its own test, those of all exercises, banks and messages, and the linters pass."""
    name = "closest_point_on_polygon"
    (tmp_path / "mine.py").write_text(PLAIN)
    command = ["new-exercise", name, "--lesson", "78_walls", "--from", str(tmp_path / "mine.py")]
    made = run(house, "-m", "kinoedu", *command)
    assert made.returncode == 0, made.stderr
    book = sources(house / "solutions" / "78_walls.ipynb")
    assert any("nearest to q" in source and "`(2, 0)`" in source for source in book)
    tests = [f"tests/lessons/test_{name}.py", "tests/test_course.py", "tests/test_bank.py"]
    options = ["-q", "-n0", "-p", "no:cacheprovider", "--rootdir", str(house), "-k", name]
    ran = run(house, "-m", "pytest", *tests, *options)
    assert ran.returncode == 0, ran.stdout + ran.stderr
    worded = run(house, "-c", f"import sys; sys.path.insert(0, 'tests'); {WORDS}")
    assert worded.returncode == 0, worded.stderr
    made_files = [line.strip() for line in made.stdout.splitlines()]
    mine = [line for line in made_files if line.endswith((".py", ".ipynb"))]
    lint(house, mine)


def test_an_exercise_without_a_lesson_is_refused(capsys):
    """The message is the right command."""
    assert main(["new-exercise", "closest_wall"]) == 2
    assert "start.py new-exercise closest_wall --lesson 15_walls" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("name", "lesson", "words"),
    [
        ("Halfway", LESSON, "name of its function"),
        ("lambda", LESSON, "name of its function"),
        ("../x", LESSON, "name of its function"),
        ("halton", LESSON, "exists already"),
        ("check", LESSON, "exists already"),
        ("pictures", "06_sampling", "exists already"),
        ("planner", LESSON, "exists already"),
        ("halfway", "walls", "15_walls"),
        ("halfway", "../15_walls", "15_walls"),
        ("halfway", "15_while", "Python reserves"),
        ("halfway", "15_3d", "15_walls"),
        ("halfway", "15_shared", "nor shared"),
        ("case", "15_walls", "choose another name"),
        ("answer", "15_walls", "choose another name"),
    ],
)
def test_impossible_names_are_refused(name, lesson, words, capsys):
    """The error names the problem, and nothing is written."""
    before = sorted((HOUSE / "kinoedu" / "course").rglob("*.py"))
    assert main(["new-exercise", name, "--lesson", lesson]) == 2
    assert words in capsys.readouterr().err
    assert sorted((HOUSE / "kinoedu" / "course").rglob("*.py")) == before


@pytest.mark.parametrize("lesson", [LESSON, "09_trees"])
def test_what_fails_half_way_leaves_nothing(tmp_path, lesson):
    """If the notebook does not run, all changes are undone and no file remains."""
    for folder in ("kinoedu/course/lessons/trees", "solutions/bank", "tests/lessons"):
        (tmp_path / folder).mkdir(parents=True)
    shutil.copy(HOUSE / LIST.format(room="trees"), tmp_path / LIST.format(room="trees"))
    shutil.copytree(HOUSE / "solutions" / "new_exercise", tmp_path / "solutions" / "new_exercise")
    cells = [
        {
            "cell_type": "code",
            "id": "a",
            "metadata": {},
            "outputs": [],
            "execution_count": None,
            "source": "1 / 0",
        }
    ]
    kernel = {
        "kernelspec": {
            "display_name": "Python 3 (ipykernel)",
            "language": "python",
            "name": "python3",
        }
    }
    book = tmp_path / "solutions" / f"{lesson}.ipynb"
    book.write_text(
        json.dumps({"nbformat": 4, "nbformat_minor": 5, "metadata": kernel, "cells": cells})
    )
    there = {file: file.is_file() and file.read_bytes() for file in tmp_path.rglob("*")}
    with pytest.raises(InvalidParameter, match="ZeroDivisionError"):
        new_exercise(NAME, lesson, tmp_path)
    assert {file: file.is_file() and file.read_bytes() for file in tmp_path.rglob("*")} == there


def test_students_have_no_solutions_to_add_to(tmp_path):
    """A student's copy of the course raises an error."""
    with pytest.raises(InvalidParameter, match="for students"):
        new_exercise(NAME, LESSON, tmp_path)
