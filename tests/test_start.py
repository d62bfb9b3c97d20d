"""start.py: sets up once, heals what an interruption leaves, says every failure in one line, then
steps aside.

Nothing here needs the network: a course of three files is set up by a uv that only pretends.
"""

import ast
import importlib.util
import io
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
import tomllib
from pathlib import Path

import pytest
from children import ctrl_c_is_heard
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

ROOT = Path(__file__).resolve().parent.parent
WINDOWS = os.name == "nt"
needs_signals = pytest.mark.skipif(WINDOWS, reason="the signals of POSIX")
needs_symlinks = pytest.mark.skipif(WINDOWS, reason="links need rights on Windows")
needs_proc = pytest.mark.skipif(
    sys.platform != "linux", reason="only Linux lists who runs from a folder"
)

STUB = """
import json, os, random, sys
output = dict(arguments=sys.argv[1:], folder=os.getcwd(), prefix=sys.prefix, file=__file__,
            pid=os.getpid(), path=sys.path, variables=dict(os.environ))
print(json.dumps(output))
sys.exit(int(sys.argv[2]) if sys.argv[1:2] == ["exit"] else 0)
"""

# "half" leaves a package half-written and fails, "kill" does so and takes start.py with it, "wait"
# waits for a file.
FAKE_UV = """
import os, pathlib, sys, time
here, python = pathlib.Path(__file__).parent, pathlib.Path(sys.argv[4])
role = os.environ.get("FAKE_UV", "install")
with open(here / "calls", "a") as calls:
    calls.write(sys.argv[-1] + " again" * ("--force-reinstall" in sys.argv) + "\\n")
limit = time.monotonic() + 60
while role == "wait" and not (here / "go").exists() and time.monotonic() < limit:
    time.sleep(0.02)
if role in ("half", "kill"):
    next(python.parent.parent.glob("[Ll]ib/**/site-packages")).joinpath("half").touch()
if role == "kill":
    os.kill(os.getppid(), 9)
sys.exit(role in ("half", "refuse"))
"""


class Course:
    """A kinoedu of three files in a folder with a difficult name, beside a pretended uv."""

    def __init__(self, folder: Path) -> None:
        folder.mkdir(exist_ok=True)
        self.home, self.bin = folder / "my cöurse [1]", folder / "bin"
        self.venv = self.home / ".venv"
        for name, text in {
            "environment.txt": "# nothing\n",
            "solutions/environment.txt": "# nothing\n",
            "tests/environment.txt": "# nothing\n",
            "docs/environment.txt": "# nothing\n",
            "kinoedu/__init__.py": "",
            "kinoedu/__main__.py": STUB,
            "pytest.py": STUB,
            "sphinx.py": STUB,
        }.items():
            (self.home / name).parent.mkdir(parents=True, exist_ok=True)
            (self.home / name).write_text(text)
        shutil.copy(ROOT / "start.py", self.home)
        self.bin.mkdir()
        (self.bin / "uv.py").write_text(FAKE_UV)
        line = f'"{sys.executable}" "{self.bin / "uv.py"}"'
        uv = self.bin / ("uv.cmd" if WINDOWS else "uv")
        uv.write_text(f"@{line} %*\n" if WINDOWS else f'#!/bin/sh\nexec {line} "$@"\n')
        uv.chmod(0o755)

    def begin(
        self, *arguments: str, uv: str = "install", cwd: Path | None = None, **variables: str
    ) -> subprocess.Popen:
        kept = {
            name: value
            for name, value in os.environ.items()
            if not name.startswith(("PIP_", "UV_"))
        }
        kept |= {
            "PATH": f"{self.bin}{os.pathsep}{os.defpath}",
            "FAKE_UV": uv,
            "PYTHONUTF8": "1",
        } | variables
        with ctrl_c_is_heard():
            return subprocess.Popen(
                [sys.executable, str(self.home / "start.py"), *arguments],
                env=kept,
                text=True,
                cwd=cwd,
                encoding="utf-8",
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
            )

    def run(self, *arguments: str, **how: object) -> "Ended":
        return Ended(self.begin(*arguments, **how))  # type: ignore[arg-type]  # passed on as it came

    def calls(self) -> list[str]:
        """What uv was asked to install, or to install again, in order."""
        return (
            (self.bin / "calls").read_text().splitlines() if (self.bin / "calls").exists() else []
        )

    def package(self) -> Path:
        """A file among the installed packages; it is gone when the environment is cleared."""
        file = next(self.venv.glob("[Ll]ib/**/site-packages")) / "package.py"
        file.touch()
        return file

    def change_python(self) -> None:
        """Let the packages be of another Python, as after an upgrade of the system under the same
        path.
        """
        stamp = self.venv / "installed.json"
        stamp.write_text(json.dumps(json.loads(stamp.read_text()) | {"python": ".cpython-310.so"}))

    def await_uv(self) -> None:
        """Return when a waiting uv has begun."""
        deadline = time.monotonic() + 30
        while not self.calls():
            assert time.monotonic() < deadline
            time.sleep(0.02)


class Ended:
    """How a run of start.py ended: its status, the lines it complained in, what the stub of kinoedu
    saw.
    """

    def __init__(self, process: subprocess.Popen) -> None:
        self.pid = process.pid
        self.output, self.complaints = process.communicate(timeout=120)
        self.status = process.returncode
        self.seen = [json.loads(line) for line in self.output.splitlines() if line.startswith("{")]


@pytest.fixture
def course(tmp_path):
    return Course(tmp_path)


def load(path: Path):
    """start.py as a module, to try its functions by themselves."""
    spec = importlib.util.spec_from_file_location("start_under_test", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


# --- any Python can read it


def test_it_parses_on_python_2_and_early_3():
    """Only then can a Python that is too old say so."""
    source = (ROOT / "start.py").read_bytes().decode("ascii")
    newer = (
        ast.JoinedStr,
        ast.NamedExpr,
        ast.AnnAssign,
        ast.Nonlocal,
        ast.YieldFrom,
        ast.AsyncFunctionDef,
        ast.Match,
    )
    for node in ast.walk(ast.parse(source, feature_version=(3, 4))):
        assert not isinstance(node, newer), ast.unparse(node)
        assert getattr(node, "annotation", None) is None and getattr(node, "returns", None) is None
        assert not getattr(node, "kwonlyargs", None) and not getattr(node, "cause", None)
        if isinstance(node, (ast.List, ast.Tuple)):
            assert not any(isinstance(item, ast.Starred) for item in node.elts)


@pytest.mark.parametrize("version", [(2, 7, 18), (3, 5, 0), (3, 10, 13)])
def test_an_old_python_is_refused_in_one_line_with_both_versions(version, monkeypatch, capsys):
    start = load(ROOT / "start.py")
    monkeypatch.setattr(sys, "version_info", version)
    assert start.main(["lab"]) == 2
    output = capsys.readouterr().err
    assert output.count("\n") == 1 and "3.11" in output and f"{version[0]}.{version[1]}" in output


def test_help_needs_no_set_up(course):
    ended = course.run("--help")
    assert ended.status == 0 and "start.py test" in ended.output and not course.venv.exists()


# --- set up, and step aside


def test_arguments_folder_and_status_pass_through(course, tmp_path):
    """A relative path means what it means where the user stands, and no module that lies there is
    imported.
    """
    (tmp_path / "random.py").write_text("raise SystemExit('a file beside the user got in the way')")
    ended = course.run("exit", "7", "två ord", cwd=tmp_path)
    assert ended.status == 7
    assert ended.seen[0]["arguments"] == ["exit", "7", "två ord"]
    assert os.path.samefile(ended.seen[0]["folder"], tmp_path)
    assert os.path.samefile(ended.seen[0]["prefix"], course.venv)
    assert os.path.samefile(Path(ended.seen[0]["file"]).parent, course.home / "kinoedu")
    assert WINDOWS or ended.seen[0]["pid"] == ended.pid, (
        "signals sent to start.py reach the command"
    )


def test_alone_it_opens_the_course_at_once(course):
    """Nothing is compiled before: the lab has that done beside it."""
    assert [run["arguments"] for run in course.run().seen] == [["lab"]]


def test_what_is_installed_is_not_installed_again(course):
    course.run("plan")
    ended = course.run("plan")
    assert ended.status == 0 and ended.complaints == "" and course.calls() == ["environment.txt"]


def test_changed_pins_are_installed(course):
    course.run("plan")
    (course.home / "environment.txt").write_text("# something else\n")
    assert course.run("plan").status == 0
    assert course.calls() == ["environment.txt"] * 2


def test_tests_run_at_the_root_with_their_own_tools(course, tmp_path):
    """Once: the course's own stamp is left as it was."""
    course.run("plan")
    ended = course.run("test", "-k", "one", cwd=tmp_path)
    assert ended.seen[0]["arguments"] == ["--rootdir", str(course.home), "-k", "one"]
    assert os.path.samefile(ended.seen[0]["folder"], course.home)
    course.run("test")
    course.run("plan")
    assert course.calls() == [
        "environment.txt",
        "solutions/environment.txt",
        "tests/environment.txt",
        "docs/environment.txt",
    ]


def test_the_site_is_written_into_build(course, tmp_path):
    """From anywhere; it brings what writes pages, and no tests."""
    course.run("plan")
    ended = course.run("site", "-W", cwd=tmp_path)
    assert ended.seen[0]["arguments"][-3:] == [".", "build/site", "-W"]
    assert os.path.samefile(ended.seen[0]["folder"], course.home)
    assert course.calls() == ["environment.txt", "docs/environment.txt"]


def test_an_instructors_command_brings_its_tools(course):
    """Releasing needs what a student does not; a student's copy says that it is one."""
    course.run("plan")
    course.run("release")
    assert course.calls() == ["environment.txt", "solutions/environment.txt"]
    (course.home / "solutions" / "environment.txt").unlink()
    ended = course.run("release")
    assert (
        ended.status == 2
        and "for students" in ended.complaints
        and "Traceback" not in ended.complaints
    )


def test_the_callers_environment_does_not_leak_in(course, tmp_path):
    """Called from within conda or another .venv, by a user who has set PYTHONPATH, or by an editor
    that draws figures itself.
    """
    foreign = str(tmp_path / "foreign")
    names = ("PYTHONPATH", "VIRTUAL_ENV", "CONDA_PREFIX", "PIP_TARGET", "MPLBACKEND")
    ended = course.run("plan", **dict.fromkeys(names, foreign))
    assert ended.status == 0 and foreign not in ended.seen[0]["path"] + list(
        ended.seen[0]["variables"].values()
    )
    assert os.path.samefile(ended.seen[0]["variables"]["VIRTUAL_ENV"], course.venv)


# --- what an interruption or a move leaves


@needs_signals
def test_a_kill_while_installing_is_repaired(course):
    """A half-written package may look installed, so all are installed again; nothing is cleared."""
    assert course.run("plan", uv="kill").status == -signal.SIGKILL
    package = course.package()
    assert course.run("plan").status == course.run("plan").status == 0
    assert package.exists() and course.calls() == ["environment.txt", "environment.txt again"]


@needs_signals
def test_a_kill_while_adding_tools_leaves_the_course_whole(course):
    """What the course needs is not installed again; what was interrupted is, when it is asked
    for.
    """
    course.run("plan")
    course.run("test", uv="kill")
    assert course.run("plan").status == course.run("release").status == 0
    tools = "solutions/environment.txt"
    assert course.calls() == ["environment.txt", tools, f"{tools} again"]


def test_a_repair_that_fails_at_once_costs_nothing(course):
    """Without network the tools stay in doubt, and the course whole."""
    course.run("plan")
    stamp = course.venv / "installed.json"
    doubtful = json.loads(stamp.read_text()) | {"solutions/environment.txt": None}
    stamp.write_text(json.dumps(doubtful))
    (course.home / "solutions" / "environment.txt").write_text("nothing-of-this-name==1.0\n")
    assert course.run("release", uv="refuse", PIP_NO_INDEX="1").status == 2
    assert json.loads(stamp.read_text()) == doubtful


def test_a_kill_while_making_the_environment_is_healed(course):
    course.venv.mkdir()
    (course.venv / "pyvenv.cfg").write_text("home = ")
    (course.venv / "installed.json").write_text('{"pyth')
    assert course.run("plan").status == 0


@pytest.mark.parametrize("left", [None, "", '{"pyth', "[1]", "{}", "\xff"])
def test_a_stamp_that_is_lost_or_damaged_clears_nothing(course, left):
    """The packages are installed again over what is there, and all is well after that."""
    course.run("plan")
    package, stamp = course.package(), course.venv / "installed.json"
    stamp.unlink()
    if left is not None:
        stamp.write_bytes(left.encode("latin-1"))
    assert course.run("plan").status == course.run("plan").status == 0
    assert package.exists() and course.calls() == ["environment.txt", "environment.txt again"]


def test_an_environment_that_somebody_made_is_used(course):
    """python -m venv .venv, and nothing more."""
    subprocess.run([sys.executable, "-m", "venv", "--without-pip", course.venv], check=True)
    package = course.package()
    ended = course.run("plan")
    assert ended.status == 0 and package.exists()
    assert os.path.samefile(Path(ended.seen[0]["file"]).parent, course.home / "kinoedu")


def test_a_python_that_is_gone_is_replaced(course):
    course.run("plan")
    package = course.package()
    Path(load(course.home / "start.py").PYTHON).unlink()
    assert course.run("plan").status == 0 and not package.exists()
    assert course.calls() == ["environment.txt"] * 2


def test_packages_of_another_python_are_replaced(course):
    course.run("plan")
    package = course.package()
    course.change_python()
    assert course.run("plan").status == 0 and not package.exists()
    assert course.calls() == ["environment.txt"] * 2


@needs_proc
@pytest.mark.parametrize(
    "called",
    ["by its path", "from its folder", "from an activated shell", "and its Python is gone"],
)
def test_an_environment_in_use_is_not_cleared(course, called):
    """It is refused in a line that names the process; when that has ended, all goes on."""
    course.run("plan")
    package, python = course.package(), Path(load(course.home / "start.py").PYTHON)
    words = {
        "from its folder": os.path.relpath(python, course.home),
        "from an activated shell": "python",
    }
    path = {"PATH": f"{python.parent}{os.pathsep}{os.defpath}"}
    shell = [
        "/bin/sh",
        "-c",
        'exec "$0" -c "print(1, flush=True); input()"',
        str(words.get(called, python)),
    ]
    pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE}
    with subprocess.Popen(shell, cwd=course.home, env=path, **pipes) as user:
        assert user.stdout.readline() == b"1\n"
        if called == "and its Python is gone":
            python.unlink()
        else:
            course.change_python()
        assert f"in use by process {user.pid};" in complaint(course.run("plan"))
        assert package.exists() and course.calls() == ["environment.txt"]
        user.communicate(b"\n")
    assert course.run("plan").status == 0 and not package.exists()


@needs_proc
def test_who_has_loaded_a_file_of_the_environment_runs_from_it(course):
    """Whatever it was called by."""
    course.run("plan")
    course.package().write_bytes(b"loaded")
    start, ours = load(course.home / "start.py"), str(os.getpid())
    code = "import mmap, sys; file = open(sys.argv[1]); print(1, flush=True); input()"
    code = code.replace(
        "print", "held = mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ); print"
    )
    line = [sys.executable, "-c", code, str(next(course.venv.rglob("package.py")))]
    with subprocess.Popen(line, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as user:
        user.stdout.readline()
        assert start.runs_from(str(course.venv), str(user.pid))
        user.communicate(b"\n")
    assert not start.runs_from(str(course.venv), ours) and not start.runs_from(
        str(course.venv), str(user.pid)
    )


def test_where_nobody_lists_who_runs_a_folder_in_use_cannot_be_moved(course, monkeypatch, capsys):
    """As on Windows. Where it can be, it is deleted, with what a killed run left of another."""
    course.run("plan")
    package, start = course.package(), load(course.home / "start.py")
    (course.home / ".venv.old" / "left").mkdir(parents=True)
    monkeypatch.setattr(sys, "platform", "darwin")
    with monkeypatch.context() as inside:
        inside.setattr(start, "binary_interface", lambda: None)
        inside.setattr(
            os, "rename", lambda *_: (_ for _ in ()).throw(PermissionError("Access is denied"))
        )
        assert start.main(["plan"]) == 2
    output = capsys.readouterr().err
    assert output.count("\n") == 1 and "in use by programs; close" in output and package.exists()
    start.make_way()
    assert not list(course.home.glob(".venv*/"))


def test_a_python_that_cannot_be_asked_now_clears_nothing(course, monkeypatch, capsys):
    """Where there is no memory, for example, a message says so, and the environment stays."""
    course.run("plan")
    package, start = course.package(), load(course.home / "start.py")

    def ask(_):
        raise OSError(12, "Cannot allocate memory")

    monkeypatch.setattr(start, "ask", ask)
    assert start.main(["plan"]) == 2 and package.exists()
    assert "Cannot allocate memory" in capsys.readouterr().err


def test_a_moved_folder_works_without_installing(course):
    course.run("plan")
    course.home = course.home.rename(course.home.with_name("elsewhere ü"))
    ended = course.run("plan")
    assert os.path.samefile(Path(ended.seen[0]["file"]).parent, course.home / "kinoedu")
    assert course.calls() == ["environment.txt"]


@needs_signals
def test_an_interrupt_while_downloading_is_quiet_and_costs_nothing(course):
    """Status 130, no child left behind, and what was whole before still is."""
    course.run("plan")
    (course.bin / "calls").unlink()
    process = course.begin("test", uv="wait")
    course.await_uv()
    process.send_signal(signal.SIGINT)
    ended = Ended(process)
    assert ended.status == 130 and "Traceback" not in ended.complaints
    assert course.run("plan").status == 0 and course.calls() == ["solutions/environment.txt"]


def test_two_at_once_install_once(course):
    first = course.begin("plan", uv="wait")
    course.await_uv()
    second = course.begin("plan")
    assert "waiting" in second.stderr.readline()
    (course.bin / "go").touch()
    assert Ended(first).status == Ended(second).status == 0
    assert course.calls() == ["environment.txt"]


@needs_symlinks
def test_two_copies_that_share_an_environment_set_it_up_one_after_the_other(tmp_path):
    """It is the environment that is guarded; each copy runs its own kinoedu."""
    copies = [Course(tmp_path / name) for name in ("one", "two")]
    for copy in copies:
        copy.venv.symlink_to(tmp_path / "shared")
    first = copies[0].begin("plan", uv="wait")
    copies[0].await_uv()
    second = copies[1].begin("plan")
    assert "waiting" in second.stderr.readline()
    (copies[0].bin / "go").touch()
    for copy, ended in zip(copies, (Ended(first), Ended(second))):
        assert ended.status == 0
        assert os.path.samefile(Path(ended.seen[0]["file"]).parent, copy.home / "kinoedu")
    assert copies[0].calls() == ["environment.txt"] and copies[1].calls() == []


def test_two_copies_with_their_own_environments_do_not_wait(tmp_path):
    copies = [Course(tmp_path / name) for name in ("one", "two")]
    first = copies[0].begin("plan", uv="wait")
    copies[0].await_uv()
    assert copies[1].run("plan").status == 0 and first.poll() is None
    (copies[0].bin / "go").touch()
    assert Ended(first).status == 0


def test_where_nothing_is_missing_nothing_is_written(course):
    """Not even a lock: the folder may be one that is only read."""
    course.run("plan")
    (course.home / ".venv.lock").unlink()
    before = {file: file.stat().st_mtime_ns for file in course.home.rglob("*")}
    assert course.run("plan").status == 0
    assert {file: file.stat().st_mtime_ns for file in course.home.rglob("*")} == before


def test_modules_are_translated_once_where_the_caller_writes_no_bytecode(course):
    """Many containers forbid it; each process would spend seconds on what it imports."""
    course.run("plan", PYTHONDONTWRITEBYTECODE="1")
    assert list((course.home / "kinoedu" / "__pycache__").glob("__init__*.pyc"))


@needs_signals
def test_an_installer_that_outlives_a_killed_start_is_waited_for(course):
    """Else the next run would write to the folder that the orphan still writes to."""
    first = course.begin("plan", uv="wait")
    course.await_uv()
    first.kill()
    second = course.begin("plan")
    assert "waiting" in second.stderr.readline()
    (course.bin / "go").touch()
    assert Ended(second).status == 0 and first.wait() == -signal.SIGKILL
    first.communicate()
    assert course.calls() == ["environment.txt", "environment.txt again"]


# --- failures


def complaint(ended: Ended) -> str:
    """The one line after those that tell what is being done."""
    lines = [line for line in ended.complaints.splitlines() if not line.startswith("installing ")]
    assert ended.status == 2 and len(lines) == 1 and "Traceback" not in ended.complaints, (
        ended.complaints
    )
    return lines[0]


def test_without_network_one_line_and_pip_takes_over_when_uv_fails(course):
    """First both fail and say why; then pip succeeds where uv still fails."""
    pins, nowhere = (
        course.home / "environment.txt",
        {"PIP_INDEX_URL": "http://127.0.0.1:9", "PIP_CONFIG_FILE": os.devnull},
    )
    pins.write_text("nothing-of-this-name==1.0\n")
    assert "connect to the network" in complaint(course.run("plan", uv="refuse", **nowhere))
    pins.write_text("# nothing\n")
    ended = course.run("plan", uv="refuse", **nowhere)
    assert ended.status == 0 and "with pip" in ended.complaints


def test_what_a_failing_uv_left_is_not_trusted(course, monkeypatch):
    """pip would take a half-copied package for an installed one, so it is told to install all
    again.
    """
    start = load(course.home / "start.py")
    monkeypatch.setenv("PATH", f"{course.bin}{os.pathsep}{os.defpath}")
    monkeypatch.setenv("FAKE_UV", "half")
    options = []

    def with_pip(*given):
        options.append(given[-1])
        return True

    monkeypatch.setattr(start, "with_pip", with_pip)
    start.set_up([start.COURSE])
    assert options == [["--force-reinstall"]]


def test_a_full_disk_is_told_before_installing(course, monkeypatch, capsys):
    start = load(course.home / "start.py")
    full = shutil.disk_usage(course.home)._replace(free=10**6)
    monkeypatch.setattr(shutil, "disk_usage", lambda _: full)
    assert start.main(["plan"]) == 2
    output = capsys.readouterr().err
    assert output.count("\n") == 1 and "make room" in output


@pytest.mark.skipif(
    WINDOWS or os.geteuid() == 0, reason="root may write anywhere, and Windows ignores the mode"
)
def test_a_folder_that_cannot_be_written_is_told(course):
    course.home.chmod(0o500)
    output = complaint(course.run("plan"))
    course.home.chmod(0o700)
    assert "cannot write" in output


@pytest.mark.parametrize(
    ("message", "advice"),
    [
        ("OSError: [Errno 28] No space left on device", "make room"),
        ("There is not enough space on the disk. (os error 112)", "make room"),
        ("[Errno 122] Disk quota exceeded", "make room"),
        ("/usr/bin/python3: No module named venv", "python3-venv"),
        (
            "The virtual environment was not created successfully because ensurepip is not "
            "available.",
            "python3-venv",
        ),
        (
            "after connection broken by 'NewConnectionError(...)'\nERROR: No matching "
            "distribution found for x",
            "network",
        ),
        ("  Caused by: dns error: failed to lookup address information", "network"),
        ("ERROR: No matching distribution found for llvmlite==0.50.0", "64 bits"),
        ("because x==1 has no wheels with a matching Python ABI tag", "64 bits"),
        ("[Errno 13] Permission denied: '/opt/course/.venv'", "cannot write"),
        ("[WinError 5] Access is denied", "cannot write"),
        ("[Errno 30] Read-only file system", "cannot write"),
        ("first line\nsomething new", "something new"),
        ("", "failed"),
    ],
)
def test_each_cause_has_its_advice_in_one_line(message, advice):
    output = load(ROOT / "start.py").explain(message)
    assert advice in output and "\n" not in output


# --- the pins

PLATFORMS = [
    {"sys_platform": "linux", "platform_system": "Linux", "os_name": "posix"},
    {"sys_platform": "darwin", "platform_system": "Darwin", "os_name": "posix"},
    {"sys_platform": "win32", "platform_system": "Windows", "os_name": "nt"},
]
MACHINES = [
    platform
    | {
        "python_version": python,
        "python_full_version": f"{python}.7",
        "implementation_name": "cpython",
        "platform_python_implementation": "CPython",
    }
    for platform in PLATFORMS
    for python in ("3.11", "3.12", "3.13", "3.14")
]


def requirements(name: str) -> list[Requirement]:
    lines = (line.split("#")[0].strip() for line in (ROOT / name).read_text("utf-8").splitlines())
    return [Requirement(line) for line in lines if line]


def pins(name: str, machine: dict[str, str]) -> dict[str, str]:
    """What a file pins on a machine, version by name; a name pinned twice is an error."""
    found: dict[str, str] = {}
    for pin in requirements(name):
        if pin.marker is None or pin.marker.evaluate(machine):
            assert canonicalize_name(pin.name) not in found, (
                f"{pin.name} is pinned twice in {name} on {machine}"
            )
            found[canonicalize_name(pin.name)] = next(iter(pin.specifier)).version
    return found


@pytest.mark.parametrize(
    "name",
    [
        "environment.txt",
        "solutions/environment.txt",
        "tests/environment.txt",
        "docs/environment.txt",
    ],
)
def test_every_line_is_an_exact_pin_from_the_index_of_the_user(name):
    for pin in requirements(name):
        assert re.fullmatch(r"==[^*,]+", str(pin.specifier)) and pin.url is None, pin


@pytest.mark.parametrize(
    "machine", MACHINES, ids=lambda m: f"{m['sys_platform']}-{m['python_version']}"
)
def test_pins_satisfy_pyproject_on_every_platform(machine):
    """What a student installs has every dependency; the other files add their extras and contradict
    nothing.
    """
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    course, tests = pins("environment.txt", machine), pins("tests/environment.txt", machine)
    teaching, extras = pins("solutions/environment.txt", machine), project["optional-dependencies"]
    assert (
        not course.keys() & teaching.keys()
        and not (course | teaching).keys() & tests.keys() - course.keys()
    )
    assert all(course[name] == tests[name] for name in course.keys() & tests.keys())
    site, others = pins("docs/environment.txt", machine), teaching | tests
    assert not course.keys() & site.keys() and all(
        others[name] == site[name] for name in others.keys() & site.keys()
    )
    held_by = {
        "course": course,
        "teach": course | teaching,
        "test": course | tests,
        "cluster": course | tests,
        "site": course | site,
    }
    for wanted, held in (
        (project["dependencies"], course),
        *((extras[name], held) for name, held in held_by.items()),
    ):
        for requirement in map(Requirement, wanted):
            if requirement.marker is None or requirement.marker.evaluate(machine):
                version = held.get(canonicalize_name(requirement.name))
                assert version is not None and requirement.specifier.contains(version), requirement


def test_old_pythons_can_read_the_script_that_refuses_them():
    """They know no comma after ** in a call."""
    text = (ROOT / "start.py").read_text(encoding="utf-8")
    assert re.findall(r"\*\*\w+(?:\([^()]*\))?,\s*\)", text) == []


def test_the_seconds_of_the_set_up_never_go_back(monkeypatch):
    """Also where the computer's clock is set back meanwhile."""
    spec = importlib.util.spec_from_file_location("start_of_the_course", ROOT / "start.py")
    start = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(start)
    terminal, clock = io.StringIO(), [5000.0]
    terminal.isatty = lambda: True
    monkeypatch.setattr(sys, "stderr", terminal)
    monkeypatch.setattr(time, "time", lambda: clock.pop() if clock else 0.0)
    start.progress("setting up")()
    assert terminal.getvalue() == "\rsetting up: 0 s"
