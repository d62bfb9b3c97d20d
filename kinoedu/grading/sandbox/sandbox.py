"""The sandbox: students' programs run in it and can do no harm.

bubblewrap isolates Python. There is no network, nothing of the machine but Python and the library
(both read-only), and no secret: judges, answers, grades and other students' files are never there.
Inside, `inside.py` loads the library once. For each request it forks a process that sees no other
process, and whose few megabytes of files vanish with it. So every program has a sandbox of its own,
and none waits for the library to load. Linux only; elsewhere `explain_no_sandbox` says how to get a
sandbox.
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
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

from .forbidden import REFUSED
from .talk import START, Talk

PACKAGE = Path(__file__).resolve().parent.parent.parent
LIBRARY = "/course/kinoedu"  # where the library is inside
INSIDE = f"{LIBRARY}/grading/sandbox/inside.py"
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
    end : "done", "late" (a line did not come in time), "flood", or "died".
    status : the exit code of the program, negative for a signal.
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
    trial = subprocess.run(
        sandbox_command("-c", "print(6 * 7)"),
        capture_output=True,
        text=True,
        timeout=START,
        check=False,
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
        # inside.py becomes another user, since the kernel does not count root's processes
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
    """Runs requests one after another, each isolated from the others."""

    def __init__(self, program: Callable[[], list[str]] | None = None) -> None:
        self.program = program or functools.partial(sandbox_command, INSIDE)
        self.user = NOBODY if os.geteuid() == 0 else 0
        self.started: dict[tuple[str, ...], Started] = {}

    def ask(
        self, parts: list[dict[str, Any]], patience: float, modules: tuple[str, ...] = ()
    ) -> Reply:
        """Run a request; each part is sent only when the one before it is done.

        Parameters
        ----------
        patience : the seconds within which each line must come, once the program has started.
        modules : modules to load in advance.

        Raises
        ------
        NoSandbox
            Where the sandbox does not start or breaks.
        """
        first = {**parts[0], "limits": {**parts[0]["limits"], "user": self.user}}
        inside = self.started.get(modules) or self.started.setdefault(
            modules, start(self.program(), modules)
        )
        try:
            received, end = exchange(
                inside.grader, [encode_part(part) for part in (first, *parts[1:])], patience
            )
            status = inside.grader.recv(16)
        except OSError as error:
            self.close()
            raise NoSandbox(f"the sandbox broke: {error}") from error
        if not status or not received or received[0][:1] != [{"ready": True}]:
            # no program was run yet, so none is at fault
            self.close()
            raise NoSandbox(f"the sandbox broke before a program was run: {str(received)[:300]}")
        return Reply(received, end, int(status))

    def close(self) -> None:
        """End all processes that were started."""
        for inside in self.started.values():
            inside.grader.close()
            inside.process.kill()
            inside.process.communicate()
        self.started.clear()


class Started(NamedTuple):
    """A running inside.py, and the grader's end of its socket."""

    process: "subprocess.Popen[bytes]"
    grader: socket.socket


def sandbox_command(*program: str) -> list[str]:
    """The command that runs a Python program in the sandbox; arguments may be appended."""
    # the Python of a virtual environment may be a copy, which is not inside
    base = getattr(sys, "_base_executable", None) or sys.executable
    return [*bubblewrap_arguments(), *python_command(os.path.realpath(base)), *program]


def trusted_command() -> list[str]:
    """The command that runs trusted.py, inside.py without walls; arguments may be appended."""
    return [
        "env",
        "-i",
        *(f"{name}={value}" for name, value in ENVIRONMENT.items()),
        *python_command(sys.executable),
        str(PACKAGE / "grading" / "sandbox" / "trusted.py"),
    ]


def start(program: list[str], modules: tuple[str, ...]) -> Started:
    """Start inside.py with some more modules loaded. Raises NoSandbox."""
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
    """A part of a request as a line that inside.py reads."""
    return json.dumps(part).encode() + b"\n"


def exchange(
    grader: socket.socket, parts: list[bytes], patience: float
) -> tuple[list[list[dict[str, Any]]], str]:
    """Send a request part by part, return the lines after each part, and stop what still runs."""
    with contextlib.ExitStack() as files:
        (requests, request_end), (answer_end, replies) = (
            [
                files.enter_context(os.fdopen(end, mode, buffering=0))
                for end, mode in zip(os.pipe(), ("rb", "wb"), strict=True)
            ]
            for _ in range(2)
        )
        socket.send_fds(grader, [b"ask"], [requests.fileno(), replies.fileno()])
        requests.close()
        replies.close()
        received, end = exchange_lines(
            Talk(request_end.fileno(), answer_end.fileno(), patience), parts
        )
    grader.send(b"end")
    return received, end


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
            received[-1].append(answer)
        else:
            return received, talk.end
    return received, "done"
