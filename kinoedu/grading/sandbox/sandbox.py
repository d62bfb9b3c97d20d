"""The sandbox: students' programs run in it and can do no harm.

There are two sandboxes of bubblewrap, without network and without a secret. In one, `student.py`
has loaded numpy. For each request it forks a process that sees no other process and has an empty
disk, and runs the student's program there. In the other, `runner.py` has loaded the library. It
sends that process one call at a time, and answers its questions about what the exercise lends. So
the library is not where the program is, every program has a sandbox of its own, and none waits for
a library to load. Linux only; elsewhere `explain_no_sandbox` says how to get a sandbox.
"""

import contextlib
import functools
import json
import os
import platform
import shutil
import socket
import subprocess
import sys
import sysconfig
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

from ...compiled.store import user_cache
from .forbidden import REFUSED
from .talk import START, Talk

PACKAGE = Path(__file__).resolve().parent.parent.parent
LIBRARY = "/course/kinoedu"  # where the library is inside
HERE = Path(__file__).resolve().parent
NOBODY = 61_184  # a user id that no system uses
ENVIRONMENT = {
    "HOME": "/tmp",
    "TMPDIR": "/tmp",
    "LANG": "C.UTF-8",
    "PATH": "/usr/bin:/bin",
    "MPLBACKEND": "agg",
    "MPLCONFIGDIR": "/tmp/matplotlib",
    "OPENBLAS_NUM_THREADS": "1",
    "OMP_NUM_THREADS": "1",
    "MKL_NUM_THREADS": "1",
    "NUMBA_NUM_THREADS": "1",
    "PYTHONDONTWRITEBYTECODE": "1",
    "PYTHONHASHSEED": "0",
}


class NoSandbox(RuntimeError):
    """The sandbox is not available, or broke; no submission is at fault."""


class Reply(NamedTuple):
    """What the sandbox returned.

    parts : the lines after each part of the request.
    end : "done", "late" (a line did not come in time), "flood", "unasked" (a line came that nobody
        had asked for), or "died".
    status : the exit code of the student's process, negative for a signal.
    """

    parts: list[list[dict[str, Any]]]
    end: str
    status: int = 0


def explain_no_sandbox() -> str:
    """Why there is no sandbox on this machine, and what to do; "" if there is one."""
    if sys.platform != "linux":
        return (
            "only Linux can shut programs in; on Windows use WSL2, on macOS the container of the "
            "instructor's guide"
        )
    if not REFUSED:
        return (
            "programs can be shut in on x86_64 and aarch64, and this machine is "
            f"{platform.machine()}"
        )
    if shutil.which("bwrap") is None:
        return (
            "bubblewrap is not installed (Debian, Ubuntu: sudo apt install bubblewrap; Fedora: "
            "sudo dnf install bubblewrap)"
        )
    try:
        trial = subprocess.run(
            [*sandboxed_python(), "-c", "print(6 * 7)"],
            capture_output=True,
            text=True,
            timeout=START,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return (
            f"a sandbox did not start within {START:.0f} seconds, perhaps because the computer is "
            "busy; try again"
        )
    if trial.stdout.strip() == "42":
        return ""
    message = " ".join(trial.stderr.split())[-300:]
    return (
        f"bubblewrap cannot make a sandbox here ({message}); user namespaces must be allowed: see "
        "the instructor's guide"
    )


def python_command(executable: str) -> list[str]:
    """The command of a Python that ignores the user's own packages.

    `-I` is not used: it would ignore PYTHONHASHSEED too, and the order of a set would vary.
    """
    return [executable, "-s", "-P", "-B"]


@functools.cache
def bubblewrap_arguments() -> tuple[str, ...]:
    """bubblewrap's arguments, which define what exists inside."""
    command = ["bwrap", "--unshare-pid", "--unshare-net", "--unshare-ipc", "--unshare-uts"]
    command += ["--unshare-cgroup-try", "--die-with-parent", "--new-session", "--clearenv"]
    command += ["--cap-drop", "ALL"]
    if os.geteuid() == 0:
        # student.py becomes another user, since the kernel does not count root's processes
        for right in ("CAP_SETUID", "CAP_SETGID", "CAP_KILL"):
            command += ["--cap-add", right]
    else:
        command += ["--unshare-user"]
    # to isolate each request; given up before a program runs
    command += ["--cap-add", "CAP_SYS_ADMIN"]
    above = {
        str(folder): None
        for place in list_readable_places().values()
        for folder in reversed(Path(place).parents[:-1])
    }
    for folder in ("/etc", *above):
        command += ["--perms", "0755", "--dir", folder]
    for path in ("/usr", "/lib", "/lib64", "/bin", "/etc/ld.so.cache", "/etc/alternatives"):
        command += (
            ["--symlink", os.readlink(path), path]
            if os.path.islink(path)
            else ["--ro-bind-try", path, path]
        )
    for source, place in list_readable_places().items():
        command += ["--ro-bind", str(source), place]
    command += ["--proc", "/proc", "--dev", "/dev"]
    for path, most in (("/dev/shm", 2**20), ("/tmp", 64 * 2**20)):
        command += ["--perms", "1777", "--size", str(most), "--tmpfs", path]
    for name, value in ENVIRONMENT.items():
        command += ["--setenv", name, value]
    command += ["--remount-ro", "/dev", "--remount-ro", "/"]
    return (*command, "--chdir", "/tmp", "--hostname", "sandbox", "--")


def list_readable_places() -> dict[Path, str]:
    """What a program may read of this machine, beside the system, and its place inside.

    Python itself keeps its place. The library and Python's packages get fixed places, wherever the
    course is kept.
    """
    places = {
        Path(sysconfig.get_path(kind)): f"/course/site-packages-{kind}"
        for kind in ("purelib", "platlib")
    }
    home = Path(sys.base_prefix)
    return {PACKAGE: LIBRARY, **places} | ({} if home.is_relative_to("/usr") else {home: str(home)})


class Sandbox:
    """Runs requests one after another, each isolated from the others.

    is_trusted : run students' programs without walls, for `kinoedu grade --trust`.
    """

    def __init__(self, is_trusted: bool = False) -> None:
        self.is_trusted = is_trusted
        self.user = NOBODY if os.geteuid() == 0 else 0
        self.started: dict[tuple[str, ...], Started] = {}

    def ask(
        self, parts: list[dict[str, Any]], patience: float, modules: tuple[str, ...] = ()
    ) -> Reply:
        """Run a request; each part is sent only when the one before it is done.

        Parameters
        ----------
        patience : the seconds within which each line must come, once the program has started.
        modules : modules to load in advance where the student's program is.

        Raises
        ------
        NoSandbox
            Where the sandbox does not start or breaks.
        """
        first = {**parts[0], "limits": {**parts[0]["limits"], "user": self.user}}
        try:
            runner, student = self.start("runner.py"), self.start(self.student, *modules)
            with join_processes(runner.grader, student.grader) as pipes:
                received, end = exchange_lines(
                    Talk(*pipes, patience), [encode_part(part) for part in (first, *parts[1:])]
                )
            end_status = [one.grader.recv(16) for one in (runner, student)]
        except OSError as error:
            self.close()
            raise NoSandbox(f"the sandbox broke: {error}") from error
        is_broken = any("broken" in line for lines in received for line in lines)
        if is_broken or not all(end_status) or received[0][:1] != [{"ready": True}]:
            # no program is at fault
            self.close()
            raise NoSandbox(f"the sandbox broke: {str(received)[-300:]}")
        return Reply(received, end, int(end_status[1]))

    @property
    def student(self) -> str:
        """The program that runs students' programs."""
        return "trusted.py" if self.is_trusted else "student.py"

    def start(self, program: str, *modules: str) -> "Started":
        """A program of this folder, started if it does not run yet. Raises NoSandbox."""
        key = (program, *modules)
        if key not in self.started:
            command = trusted_command if self.is_trusted else sandbox_command
            self.started[key] = start(command(program), modules)
        return self.started[key]

    def close(self) -> None:
        """End all processes that were started."""
        for inside in self.started.values():
            inside.grader.close()
            inside.process.kill()
            inside.process.communicate()
        self.started.clear()


class Started(NamedTuple):
    """A running program, and the grader's end of its socket."""

    process: "subprocess.Popen[bytes]"
    grader: socket.socket


@contextlib.contextmanager
def join_processes(runner: socket.socket, student: socket.socket) -> Iterator[tuple[int, int]]:
    """Give a runner and a student's process their pipes, and stop what still runs at the end.

    Yields the grader's ends of its own two pipes to the runner: for requests, and for replies.
    """
    (from_grader, requests), (replies, to_grader) = os.pipe(), os.pipe()
    (from_runner, to_student), (from_student, to_runner) = os.pipe(), os.pipe()
    theirs = {
        runner: [from_grader, to_grader, to_student, from_student],
        student: [from_runner, to_runner],
    }
    try:
        for one, ends in theirs.items():
            socket.send_fds(one, [b"ask"], ends)
            for end in ends:
                os.close(end)
        yield requests, replies
    finally:
        os.close(requests)
        os.close(replies)
        for one in theirs:
            one.send(b"end")


def sandbox_command(program: str) -> list[str]:
    """The command that runs a program of this folder in a sandbox; arguments may be appended."""
    return [*sandboxed_python(), f"{LIBRARY}/grading/sandbox/{program}"]


def sandboxed_python() -> list[str]:
    """The command of Python in a sandbox."""
    # the Python of a virtual environment may be a copy, which is not inside
    base = getattr(sys, "_base_executable", None) or sys.executable
    return [*bubblewrap_arguments(), *python_command(os.path.realpath(base))]


def trusted_command(program: str) -> list[str]:
    """The command that runs a program of this folder without a sandbox.

    What matplotlib reads is where no student's program can write: in some versions it is code.
    """
    environment = {**ENVIRONMENT, "MPLCONFIGDIR": str(user_cache().resolve() / "matplotlib")}
    return [
        "env",
        "-i",
        *(f"{name}={value}" for name, value in environment.items()),
        *python_command(sys.executable),
        str(HERE / program),
    ]


def start(program: list[str], modules: Iterable[str]) -> Started:
    """Start a program with its end of a socket, and some more modules. Raises NoSandbox."""
    ours, theirs = socket.socketpair()
    command = [*program, str(theirs.fileno()), *modules]
    process = subprocess.Popen(
        command,
        pass_fds=[theirs.fileno()],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
    )
    theirs.close()
    ours.settimeout(START)
    try:
        is_ready = ours.recv(16) == b"ready"
    except OSError:
        is_ready = False
    if not is_ready:
        ours.close()
        process.kill()
        _, output = process.communicate()
        raise NoSandbox(
            f"the sandbox did not start: {' '.join(output.decode(errors='replace').split())[-300:]}"
        )
    return Started(process, ours)


def encode_part(part: dict[str, Any]) -> bytes:
    """A part of a request as a line that runner.py reads."""
    return json.dumps(part).encode() + b"\n"


def exchange_lines(talk: Talk, parts: list[bytes]) -> tuple[list[list[dict[str, Any]]], str]:
    """The lines after each part, up to the first that is not JSON, and how it ended."""
    received: list[list[dict[str, Any]]] = []
    for part in parts:
        received.append([])
        talk.send(part)
        for line in talk.lines():
            try:
                answer = json.loads(line)
            except (ValueError, RecursionError):
                return received, "died"
            if not isinstance(answer, dict):
                return received, "died"
            if answer == {"done": True}:
                break
            if "ended" in answer:
                return received, str(answer["ended"])
            received[-1].append(answer)
        else:
            return received, talk.end
    return received, "done"
