"""A place from which a program can do no harm.

bubblewrap shuts Python in: there is no network, nothing of the machine but Python and the library (both read-only), and no secret:
judges, answers, grades and other students are never there. Inside, `inside.py` loads the library once, and for each request forks
a process that sees no other, and whose few megabytes of files vanish with it. So every program has a sandbox of its own, and none
waits for a library to load. Linux only; where it cannot be had, `why_not` says how to get it.
"""

import contextlib
import functools
import json
import os
import selectors
import shutil
import socket
import subprocess
import sys
import sysconfig
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

PACKAGE = Path(__file__).resolve().parent.parent
INSIDE = Path(__file__).resolve().parent / "inside.py"
NOBODY = 61_184  # a user that no system has
MOST_OUTPUT = 32 * 2**20  # bytes
GRACE = 2.0  # seconds in which what inside.py stops itself must be heard of
START = 60.0  # seconds for a start on a slow machine, compiled code and all
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
    """The sandbox is not to be had, or broke: the machine's trouble, and nobody's fault."""


class Reply(NamedTuple):
    """What came out: the lines, and how it ended: "done", "late" (a line did not come in time), "flood", or "died" with the status
    of its end, negative for a signal.
    """

    lines: list[dict[str, Any]]
    end: str
    status: int = 0


def why_not() -> str:
    """Why programs cannot be shut in on this machine, and what to do; "" where they can."""
    if sys.platform != "linux":
        return "only Linux can shut programs in; on Windows use WSL2, on macOS the container of the instructor's guide"
    if shutil.which("bwrap") is None:
        return "bubblewrap is not installed (Debian, Ubuntu: sudo apt install bubblewrap; Fedora: sudo dnf install bubblewrap)"
    trial = subprocess.run([*walls(), *python(), "-c", "print(6 * 7)"], capture_output=True, text=True, timeout=START, check=False)
    if trial.stdout.strip() == "42":
        return ""
    said = " ".join(trial.stderr.split())[-300:]
    return f"bubblewrap cannot make a sandbox here ({said}); user namespaces must be allowed: see the instructor's guide"


def python() -> list[str]:
    """This Python, seeing nothing of the user's."""
    return [sys.executable, "-I", "-B"]


@functools.cache
def walls() -> tuple[str, ...]:
    """bubblewrap's arguments: what there is inside."""
    command = ["bwrap", "--unshare-pid", "--unshare-net", "--unshare-ipc", "--unshare-uts", "--unshare-cgroup-try"]
    command += ["--die-with-parent", "--new-session", "--clearenv", "--cap-drop", "ALL"]
    if os.geteuid() == 0:  # inside.py becomes a user whose processes the kernel counts, as root's are not
        command += ["--cap-add", "CAP_SETUID", "--cap-add", "CAP_SETGID"]
    else:
        command += ["--unshare-user"]
    command += ["--cap-add", "CAP_SYS_ADMIN"]  # to shut each request in; gone before a program runs
    for folder in ("/etc", *{str(above): None for path in readable() for above in reversed(path.parents[:-1])}):
        command += ["--perms", "0755", "--dir", folder]
    for path in ("/usr", "/lib", "/lib64", "/bin", "/etc/ld.so.cache", "/etc/alternatives"):
        command += ["--symlink", os.readlink(path), path] if os.path.islink(path) else ["--ro-bind-try", path, path]
    for path in map(str, readable()):
        command += ["--ro-bind", path, path]
    command += ["--proc", "/proc", "--dev", "/dev"]
    for path, most in (("/dev/shm", 2**20), ("/tmp", 64 * 2**20)):
        command += ["--perms", "1777", "--size", str(most), "--tmpfs", path]
    for name, value in ENVIRONMENT.items():
        command += ["--setenv", name, value]
    return (*command, "--remount-ro", "/", "--chdir", "/tmp", "--hostname", "sandbox", "--")


def readable() -> list[Path]:
    """What of this machine a program may read, beside the system: Python, its packages, and the library."""
    prefixes = [Path(sys.prefix), Path(sys.base_prefix), Path(sysconfig.get_path("purelib"))]
    chosen: list[Path] = []
    for path in [*dict.fromkeys(prefixes), PACKAGE]:
        if not path.is_relative_to("/usr") and not any(path.is_relative_to(other) for other in chosen):
            chosen.append(path)
    return chosen


class Sandbox:
    """Runs requests one after another, each shut in alone."""

    def __init__(self) -> None:
        self.user = NOBODY if os.geteuid() == 0 else 0
        self.started: dict[str, Started] = {}

    def ask(self, request: dict[str, Any], patience: float, mode: str = "plain") -> Reply:
        """Run a request; after its start a line must come at least every `patience` seconds. Raises NoSandbox."""
        request = {**request, "limits": {**request["limits"], "user": self.user}}
        inside = self.started.get(mode) or self.started.setdefault(mode, start(mode))
        try:
            lines, end = exchange(inside.grader, json.dumps(request).encode(), patience)
            status = int(inside.grader.recv(16) or b"-1")
        except OSError as error:
            self.close()
            raise NoSandbox(f"the sandbox broke: {error}") from error
        return Reply(lines, end, status)

    def close(self) -> None:
        """End what was started."""
        for inside in self.started.values():
            inside.grader.close()
            inside.process.kill()
            inside.process.communicate()
        self.started.clear()


class Started(NamedTuple):
    """inside.py, ready, and the socket by which it is asked."""

    process: "subprocess.Popen[bytes]"
    grader: socket.socket


def start(mode: str) -> Started:
    """Start inside.py with the library "plain" or "compiled". Raises NoSandbox."""
    ours, theirs = socket.socketpair()
    command = [*walls(), *python(), str(INSIDE), str(theirs.fileno()), mode]
    process = subprocess.Popen(
        command, pass_fds=[theirs.fileno()], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE
    )
    theirs.close()
    if ours.recv(16) != b"ready":
        _, said = process.communicate()
        raise NoSandbox(f"the sandbox did not start: {' '.join(said.decode(errors='replace').split())[-300:]}")
    return Started(process, ours)


def exchange(grader: socket.socket, request: bytes, patience: float) -> tuple[list[dict[str, Any]], str]:
    """Hand a request over, and hear the lines that come of it; what is not done then is stopped."""
    with contextlib.ExitStack() as files:
        (asking, request_end), (answer_end, answering) = (
            [files.enter_context(os.fdopen(end, mode, buffering=0)) for end, mode in zip(os.pipe(), ("rb", "wb"), strict=True)]
            for _ in range(2)
        )
        socket.send_fds(grader, [b"ask"], [asking.fileno(), answering.fileno()])
        asking.close()
        answering.close()
        with contextlib.suppress(BrokenPipeError):
            while request:
                request = request[request_end.write(request) :]
        request_end.close()
        lines, end = heard(answer_end.fileno(), patience)
    grader.send(b"end")
    return lines, end


def heard(answering: int, patience: float) -> tuple[list[dict[str, Any]], str]:
    """The lines that came, up to one that is none, and how that ended."""
    lines: list[dict[str, Any]] = []
    for line in spoken(answering, patience):
        if isinstance(line, str):
            return lines, line
        try:
            said = json.loads(line)
        except (ValueError, RecursionError):
            return lines, "died"
        if not isinstance(said, dict):
            return lines, "died"
        if said == {"done": True}:
            return lines, "done"
        if said != {"ready": True}:
            lines.append(said)
    return lines, "died"


def spoken(answering: int, patience: float) -> Iterator[bytes | str]:
    """Each line as it comes; last "late" or "flood" where that was so."""
    kept, total, last = b"", 0, time.monotonic() + START
    with selectors.DefaultSelector() as ready:
        ready.register(answering, selectors.EVENT_READ)
        while True:
            if not ready.select(max(0.0, last - time.monotonic())):
                yield "late"
                return
            data = os.read(answering, 2**16)
            if not data:
                return
            total += len(data)
            if total > MOST_OUTPUT:
                yield "flood"
                return
            *whole, kept = (kept + data).split(b"\n")
            if whole:
                last = time.monotonic() + patience
            yield from whole
