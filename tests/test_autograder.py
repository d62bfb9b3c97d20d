"""Gradescope's autograder, packed, unpacked and run as Gradescope does.

A temporary folder takes the place of /autograder.
"""

import errno
import io
import json
import os
import secrets
import shutil
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

import pytest

from kinoedu.cli import main
from kinoedu.grading.assignments.questions import read_assignment, read_course_secret
from kinoedu.grading.export import autograder_zip
from kinoedu.grading.export.autograder import find_submission
from kinoedu.grading.sandbox import sandbox

HOUSE = Path(__file__).resolve().parent.parent
NAME = "01_geometry"
SOLUTION = HOUSE / "solutions" / f"{NAME}.ipynb"
# compiled code is stored by the path of its source, and that is new each time
QUICK = {"NUMBA_DISABLE_JIT": "1"}
NO_SANDBOX = sandbox.explain_no_sandbox()
needs_sandbox = pytest.mark.skipif(bool(NO_SANDBOX), reason=NO_SANDBOX or "there is one")
on_linux = pytest.mark.skipif(sys.platform != "linux", reason="Gradescope's containers are Linux")


@pytest.fixture(scope="module")
def packed(tmp_path_factory):
    """The zip, written by the command."""
    folder = tmp_path_factory.mktemp("packed")
    command = ["export", "--gradescope-autograder", str(folder / "autograder.zip")]
    assert main([*command, "--assignment", NAME, "--secret", str(folder / "secret")]) == 0
    return folder / "autograder.zip"


@pytest.fixture
def root(packed):
    """A folder laid out as in Gradescope's container; every user can read it, as there."""
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder)
        place.chmod(0o755)
        for below in ("submission", "results"):
            (place / below).mkdir()
        subprocess.run(
            [sys.executable, "-m", "zipfile", "-e", str(packed), str(place / "source")], check=True
        )
        yield place


def run(root: Path, **environment: str) -> subprocess.CompletedProcess:
    """Run run_autograder as Gradescope does, with this Python instead of the installed one."""
    shutil.copy(root / "source" / "run_autograder", root)
    kept = {
        name: os.environ[name] for name in ("PATH", "KINOEDU_CACHE", "HOME") if name in os.environ
    }
    command = ["bash", str(root / "run_autograder"), str(root)]
    return subprocess.run(
        command,
        env={**kept, **QUICK, "KINOEDU_PYTHON": sys.executable, **environment},
        cwd=root,
        capture_output=True,
        text=True,
        check=False,
    )


def results(root: Path) -> dict:
    """The results that it wrote."""
    return json.loads((root / "results" / "results.json").read_text(encoding="ascii"))


def notebook(*sources: str) -> str:
    """A notebook with these code cells."""
    code = {"cell_type": "code", "metadata": {}, "outputs": [], "execution_count": None}
    cells = [{**code, "source": source} for source in sources]
    return json.dumps({"nbformat": 4, "nbformat_minor": 5, "metadata": {}, "cells": cells})


def test_the_zip_asks_what_the_solution_asks_and_tells_no_answer(packed, root):
    """The zip holds the scripts and the same questions, and no answer, no bank and no tests.

    Only its owner can read the zip, since it holds the secret.
    """
    archive = zipfile.ZipFile(packed)
    names = archive.namelist()
    assert {"setup.sh", "run_autograder", "course_secret"} <= set(names)
    assert archive.getinfo("run_autograder").external_attr >> 16 & 0o111
    assert packed.stat().st_mode & 0o077 == 0
    assert not any("/bank/" in name or "/tests/" in name or "__pycache__" in name for name in names)
    mine, course = read_assignment(NAME), read_assignment(NAME, root / "source" / "kinoedu-course")
    assert course.questions == mine.questions
    assert (course.by_hand, course.lent) == (mine.by_hand, mine.lent)
    notebook = archive.read(f"kinoedu-course/solutions/{NAME}.ipynb").decode()
    answers = [
        cell["source"]
        for cell in json.loads(SOLUTION.read_text())["cells"]
        if "BEGIN SOLUTION" in "".join(cell["source"])
    ]
    given = {line for cell in json.loads(notebook)["cells"] for line in cell["source"]}
    assert answers
    assert "BEGIN SOLUTION" not in notebook
    for cell in answers:
        lines = {
            line.strip()
            for line in "".join(cell)
            .split("### BEGIN SOLUTION")[1]
            .split("### END SOLUTION")[0]
            .splitlines()
        } - {""}
        assert not lines & {line.strip() for line in given}


def test_the_scripts_are_bash():
    """setup.sh needs a container and the network to run; here bash only parses it."""
    from kinoedu.grading.export.autograder_zip import RUN, SETUP

    for script in (SETUP, RUN):
        assert subprocess.run(["bash", "-n"], input=script, text=True, check=False).returncode == 0


@needs_sandbox
def test_a_submission_is_graded_in_the_sandbox(root):
    """The solution has all points, also with the receipt of hand-in beside it."""
    shutil.copy(SOLUTION, root / "submission")
    (root / "submission" / "receipt.txt").write_text("a receipt")
    ran = run(root)
    assert ran.returncode == 0, ran.stderr
    output = results(root)
    questions = read_assignment(NAME).questions
    assert output["score"] == sum(one.points for one in questions)
    assert [(one["name"], one["score"], one["max_score"]) for one in output["tests"]] == [
        (one.exercise.name, one.points, one.points) for one in questions
    ]
    assert output["visibility"] == "visible" and output["stdout_visibility"] == "hidden"
    assert {"score", "output", "visibility", "tests"} <= set(output)


def test_the_wrong_file_is_named(tmp_path):
    """Cells of another assignment, or of none, are refused, as `grade` does.

    Cells without any marks are run.
    """
    other = (HOUSE / "solutions" / "02_bug_algorithms.ipynb").read_bytes()
    for data, output in (
        (other, "wrong file"),
        (SOLUTION.read_bytes(), ""),
        (notebook("def point_line_distance(q, a, b): pass").encode(), ""),
        (notebook("x = 1").encode(), "wrong file"),
        ((HOUSE / "notebooks" / f"{NAME}.ipynb").read_bytes(), "wrong file"),
    ):
        (tmp_path / f"{NAME}.ipynb").write_bytes(data)
        trouble = find_submission(tmp_path, NAME).trouble
        assert output in trouble and bool(output) == bool(trouble)


SPY = """
import os
def readable(path):
    try:
        open(path).read()
        return True
    except OSError:
        return False
def writable(path):
    try:
        open(path, "w").close()
        return True
    except OSError:
        return False
def fork():
    try:
        os.fork()
        return True
    except OSError:
        return False
raise RuntimeError((os.getuid() == 0, readable(SECRET), writable(RESULTS), writable(JUDGE), fork()))
"""


@on_linux
@pytest.mark.skipif(
    not hasattr(os, "geteuid") or os.geteuid() != 0,
    reason="only root can become somebody else, as on Gradescope",
)
def test_where_the_container_is_the_wall_it_must_be_said(root, tmp_path):
    """Without bubblewrap nothing is graded unless a flag says that the container is trusted.

    With the flag a program runs as a user without rights, and cannot read the secret.
    """
    tools = tmp_path / "bin"
    tools.mkdir()
    for name in ("bash", "env", "chmod"):
        (tools / name).symlink_to(shutil.which(name))
    places = {
        "SECRET": str(root / "source" / "course_secret"),
        "RESULTS": str(root / "results" / "results.json"),
        "JUDGE": str(root / "source" / "kinoedu-course" / "kinoedu" / "__init__.py"),
    }
    spy = SPY
    for word, place in places.items():
        spy = spy.replace(word, repr(place))
    good = "def point_line_distance(q, p1, p2):\n    if (p1 == p2).all():\n"
    good += "        raise ValueError\n    d = p2 - p1\n"
    good += "    return abs(d[0] * (q - p1)[1] - d[1] * (q - p1)[0]) / (d @ d) ** 0.5"
    (root / "submission" / f"{NAME}.ipynb").write_text(notebook(spy, good))
    refused = run(root, PATH=str(tools))
    assert refused.returncode == 2
    assert "--trust-container" in refused.stderr
    assert not list((root / "results").iterdir())
    script = root / "source" / "run_autograder"
    script.write_text(script.read_text().rstrip() + " --trust-container\n")
    ran = run(root, PATH=str(tools))
    assert ran.returncode == 0, ran.stderr
    output = {one["name"]: one for one in results(root)["tests"]}
    assert output["point_line_distance"]["score"] == 5.0
    assert "1" in results(root)["output"]
    shown = main_record(root, tools)
    assert shown == "(False, False, False, False, False)"


def main_record(root: Path, tools: Path) -> str:
    """The message of the spying cell, from the record of the grade itself."""
    code = (
        "import sys, tempfile; from pathlib import Path\n"
        "from kinoedu.grading.export.autograder import find_submission\n"
        "from kinoedu.grading.judge.running import grade_all, use_local_workers\n"
        "if __name__ == '__main__':\n"
        f"    one = find_submission(Path({str(root / 'submission')!r}), {NAME!r})\n"
        "    place = use_local_workers(1)\n"
        "    found = grade_all([one], Path(tempfile.mkdtemp()), b'x' * 16, place=place, "
        "trusted=True)[0]\n"
        "    print(found.grade['cells'][0]['trouble']['message'])\n"
    )
    script = root / "look.py"
    script.write_text(code)
    environment = {
        **os.environ,
        **QUICK,
        "PATH": str(tools),
        "PYTHONPATH": str(root / "source" / "kinoedu-course"),
    }
    ran = subprocess.run(
        [sys.executable, "-P", str(script)],
        env=environment,
        capture_output=True,
        text=True,
        check=True,
    )
    return ran.stdout.strip()


@needs_sandbox
def test_what_a_student_can_mend_is_told(root):
    """No file, no notebook or two of them give no points and the reason.

    A wrong answer gets its smallest case and a hint.
    """
    submission = root / "submission"
    for files, words in (
        ({}, "there is no notebook"),
        ({f"{NAME}.ipynb": "{"}, "not a whole notebook"),
        (
            {f"{NAME}.ipynb": notebook("x = 1"), f"{NAME} (1).ipynb": notebook("x = 2")},
            "Keep only the one",
        ),
    ):
        shutil.rmtree(submission)
        submission.mkdir()
        for name, text in files.items():
            (submission / name).write_text(text)
        assert run(root).returncode == 0
        assert results(root)["score"] == 0.0
        assert words in results(root)["output"]
        assert "grade the folder" not in results(root)["output"]  # this is for instructors
    shutil.rmtree(submission)
    submission.mkdir()
    (submission / "mine.ipynb").write_text(
        notebook("def point_line_distance(q, p1, p2):\n    return 0.0")
    )
    assert run(root).returncode == 0
    output = {one["name"]: one for one in results(root)["tests"]}["point_line_distance"]
    assert output["score"] < output["max_score"]
    assert "smallest case" in output["output"] and "Hint" in output["output"]


def test_an_autograder_is_for_one_assignment(tmp_path, capsys):
    """The command is refused without an assignment, and with an unknown one."""
    command = ["export", "--gradescope-autograder", str(tmp_path / "a.zip")]
    command += ["--secret", str(tmp_path / "secret")]
    assert main(command) == 2
    assert main([*command, "--assignment", "99_nothing"]) == 2
    assert "99_nothing" in capsys.readouterr().err
    assert not (tmp_path / "a.zip").exists()


def test_two_commands_that_begin_at_once_have_one_secret(tmp_path, monkeypatch):
    """The one that comes second takes the secret of the first, or its grades would have none."""
    file, token, first = tmp_path / "new" / "secret", secrets.token_hex, []

    def draw(size):
        if not first:
            first.append(b"")
            first[0] = read_course_secret(file)  # meanwhile, by the other command
        return token(size)

    monkeypatch.setattr(secrets, "token_hex", draw)
    assert read_course_secret(file) == first[0] == read_course_secret(file)
    assert os.name == "nt" or file.stat().st_mode & 0o777 == 0o600


def test_a_new_secret_is_announced_when_it_is_made(tmp_path, caplog):
    """A command that stops before it needs the secret says nothing of one."""
    command = ["grade", str(tmp_path / "nothing"), "--out", str(tmp_path / "grades")]
    file = tmp_path / "secret"
    assert main([*command, "--secret", str(file)]) == 2
    assert not file.exists()
    assert "course's secret" not in caplog.text
    read_course_secret(file)
    read_course_secret(file)
    assert caplog.text.count(f"secret was made, once, in {file};") == 1


def test_a_secret_that_cannot_be_written_is_named(tmp_path, monkeypatch):
    """No half-written secret is left on a full disk."""
    full = OSError(errno.ENOSPC, "No space left on device")

    class Full(io.StringIO):
        def write(self, text):
            raise full

    monkeypatch.setattr(os, "fdopen", lambda handle, *_, **__: os.close(handle) or Full())
    with pytest.raises(OSError, match="No space left") as error:
        read_course_secret(tmp_path / "secret")
    assert error.value.filename == str(tmp_path / "secret")
    assert not (tmp_path / "secret").exists()


@pytest.mark.skipif(os.name == "nt", reason="Windows has no such permissions")
def test_the_zip_with_the_secret_is_never_readable_by_others(tmp_path, monkeypatch):
    """Not even for the moment in which it is put in place."""
    modes, replace = [], os.replace

    def look(part, file):
        modes.append(Path(part).stat().st_mode & 0o777)
        replace(part, file)

    monkeypatch.setattr(os, "replace", look)
    monkeypatch.setattr(autograder_zip, "pack_library", lambda house: ())
    autograder_zip.pack_autograder(tmp_path / "a.zip", "01_geometry", bytes(32))
    assert modes == [0o600]
