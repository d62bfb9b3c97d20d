"""Attacks: a submission gets no undeserved points, leaves no trace, and harms nobody."""

import json
import os
import shutil
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest
from submissions import notebook

from kinoedu.grading.assignments.questions import draw_cases, read_assignment, spell_case
from kinoedu.grading.judge.submission import grade
from kinoedu.grading.sandbox import sandbox
from kinoedu.grading.sandbox.sandbox import Sandbox

NO_SANDBOX = sandbox.explain_no_sandbox()
HOUSE = Path(__file__).resolve().parent.parent
SECRET = b"a secret of the tests, no course's"
ATTACKS = sorted((HOUSE / "tests" / "attacks").glob("*.cells"))
HASTE = 0.2  # factor on all time limits: 2 s a cell, 1 s a call
needs_sandbox = pytest.mark.skipif(bool(NO_SANDBOX), reason=NO_SANDBOX or "there is one")

PRELUDE = """
HARM = []
def fails(words, action):
    try:
        action()
    except Exception:
        return
    HARM.append(words)
"""
HONEST = """
import numpy as np
def point_line_distance(q, p1, p2):
    if HARM:  # within the function, since a cell goes on after a statement that fails
        raise RuntimeError(f"harm was done: {HARM}")
    if (p1 == p2).all():
        raise ValueError("one point")
    d = (p2 - p1) / np.linalg.norm(p2 - p1)
    return abs(d[0] * (q - p1)[1] - d[1] * (q - p1)[0])
"""


def submission(file: Path) -> tuple[bytes, float, str]:
    """An attack as a notebook, the points that it deserves, and the assignment that it attacks."""
    text = file.read_text(encoding="utf-8")
    _, points, _, on, name = text.split(maxsplit=5)[:5]
    cells = [PRELUDE, *text.split("# %%\n"), *[HONEST] * (float(points) > 0)]
    return notebook(*cells), float(points), name.rstrip(":") if on == "in" else "01_geometry"


def traces() -> set[str]:
    """The files that attacks would leave."""
    files = {
        str(file)
        for folder in (Path.cwd(), Path("/tmp"), Path("/dev/shm"), HOUSE)
        for file in folder.glob("*attack_trace*")
    }
    return files | {
        str(file)
        for file in (Path("/tmp"), Path("/dev/shm"), Path.cwd())
        for file in file.glob("hoard*")
    }


def insiders(box: Sandbox) -> int:
    """The number of processes below a sandbox."""
    found, unseen = 0, [inside.process.pid for inside in box.started.values()]
    while unseen:
        try:
            below = [
                int(child)
                for task in Path(f"/proc/{unseen.pop()}/task").iterdir()
                for child in (task / "children").read_text().split()
            ]
        except OSError:
            continue
        found += len(below)
        unseen += below
    return found


@pytest.fixture(scope="module")
def box():
    """One sandbox for all tests of this file."""
    one = Sandbox()
    yield one
    one.close()


@pytest.fixture(scope="module")
def neighbour():
    """Scores of another student's notebook, which is graded again and again beside the attacks."""
    scores: list[float] = []
    over = threading.Event()

    def work() -> None:
        box = Sandbox()
        while not over.is_set():
            record = grade(notebook(PRELUDE, HONEST), read_assignment("01_geometry"), SECRET, box)
            scores.append(sum(question["score"] for question in record["questions"]))
            time.sleep(0.1)
        box.close()

    thread = threading.Thread(target=work)
    thread.start()
    yield scores
    over.set()
    thread.join()


@needs_sandbox
@pytest.mark.parametrize("file", ATTACKS, ids=lambda file: file.stem)
def test_an_attack_has_what_it_deserves_and_harms_nobody(file, box, neighbour):
    data, points, name = submission(file)
    record = grade(data, read_assignment(name), SECRET, box, patience=HASTE)
    assert sum(question["score"] for question in record["questions"]) == points, str(record)[-1900:]
    grade(notebook(""), read_assignment("01_geometry"), SECRET, box)
    assert insiders(box) <= 2 * len(box.started)  # bubblewrap and the Python that waits
    assert traces() == set()
    assert set(neighbour) <= {5.0}


@needs_sandbox
def test_hidden_cases_are_never_told(box):
    data, *_ = submission(HOUSE / "tests" / "attacks" / "hidden_cases_told.cells")
    record = json.dumps(grade(data, read_assignment("01_geometry"), SECRET, box, patience=HASTE))
    for question in read_assignment("01_geometry").questions:
        cases = draw_cases(question.exercise.name, SECRET)
        hidden = [question.exercise.given.encode(case.given) for case in cases.cases[cases.seen :]]
        shown = [spell_case(question.exercise, case) for case in cases.cases[: cases.seen]]
        points = [
            json.dumps(value)
            for case in hidden
            for value in case.values()
            if json.dumps(value) not in str(shown)
        ]
        assert not any(point in record for point in points if len(point) > 12)


@needs_sandbox
def test_one_request_sees_nothing_of_another(box):
    writes = """
import os
for place in ("/tmp/left", "/dev/shm/left", "/dev/left", "/left"):
    try:
        open(place, "w").write("here")
    except OSError:
        pass
os.environ["LEFT"] = "here"
import kinoedu, builtins
builtins.left = kinoedu.left = 1
"""
    looks = """
import os, builtins, kinoedu
places = ("/tmp/left", "/dev/shm/left", "/dev/left", "/left")
HARM += [place for place in places if os.path.exists(place)]
HARM += os.listdir("/tmp")
HARM += ["environment"] * ("LEFT" in os.environ)
HARM += ["modules"] * (hasattr(builtins, "left") or "left" in vars(kinoedu))
"""
    for source in (writes, looks):
        record = grade(
            notebook(PRELUDE, source, HONEST), read_assignment("01_geometry"), SECRET, box
        )
        assert record["cells"] == []
        assert sum(question["score"] for question in record["questions"]) == 5.0


@needs_sandbox
def test_marks_and_points_in_a_submission_are_ignored(box):
    """Questions and points come from the solution, not from the submission.

    Its test cells are edited and marked as right, and their points are raised.
    """
    book = json.loads((HOUSE / "exercises" / "01_geometry.ipynb").read_text(encoding="utf-8"))
    for cell in book["cells"]:
        cell["outputs"] = [
            {"output_type": "stream", "name": "stdout", "text": ["Right. 5 of 5 points"]}
        ]
        mark = cell["metadata"].get("nbgrader", {})
        mark.update(points=1000, grade=True, locked=False, solution=False)
        if str(mark.get("grade_id", "")).startswith("check_"):
            cell["source"] = "check = lambda *_: True"
    record = grade(json.dumps(book).encode(), read_assignment("01_geometry"), SECRET, box)
    assert [question["score"] for question in record["questions"]] == [0.0] * len(
        record["questions"]
    )
    assert {question["max_score"] for question in record["questions"]} == {
        question.points for question in read_assignment("01_geometry").questions
    }


@needs_sandbox
@pytest.mark.skipif(
    os.geteuid() != 0 or shutil.which("setpriv") is None,
    reason="only root can become somebody else to try it",
)
def test_an_ordinary_user_is_as_safe():
    """The same tests as an ordinary user, with user namespaces in the place of root's rights."""
    python = ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups", sys.executable]
    trial = subprocess.run(
        [*python, "-c", "import sys; print(sys.base_prefix)"], capture_output=True, text=True
    )
    if trial.stdout.strip() != sys.base_prefix:
        pytest.skip("another user may not run root's Python here")
    command = [*python, "-m", "pytest", "-q", "-n0", "-p", "no:cacheprovider", "-p", "no:nbval"]
    command += ["-o", "addopts=", "--basetemp", "/tmp/kinoedu_nobody", __file__]
    command += [
        "-k",
        "rights or processes or memory or disk or signals or network or without_alarm or given or "
        "one_request",
    ]
    environment = os.environ | {"HOME": "/tmp", "KINOEDU_CACHE": "/tmp/kinoedu_nobody_cache"}
    run = subprocess.run(
        command, cwd=HOUSE, env=environment, capture_output=True, text=True, timeout=500
    )
    for folder in ("/tmp/kinoedu_nobody", "/tmp/kinoedu_nobody_cache"):
        shutil.rmtree(folder, ignore_errors=True)
    assert run.returncode == 0, run.stdout[-3000:] + run.stderr[-1000:]
    assert "skipped" not in run.stdout.splitlines()[-1], run.stdout[-500:]
