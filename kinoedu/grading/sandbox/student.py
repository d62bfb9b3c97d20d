"""The program of the sandbox in which students' programs run, and nothing else does.

`python student.py SOCKET [MODULE...]` is started by `sandbox.py`. It loads numpy and those modules
once, and waits. For each request of the grader it forks a process, which gives up every right and
its disk, and then does what the runner says, one line for each:

    {"lend": {module: {name: value}}}                 make these names importable
    {"cell": name, "source": ..., "seconds": ...}     run a cell
    {"defined": name}                                 is there such a function?
    {"call": name, "given": [...], "seconds": ...}    call it

Each line is answered by one line. Before the answer the program may ask the runner what was lent:
{"ask": [number, question, given, named]}. Values are written as in `wire.py`. There is nothing here
that a program could find out: no judge, no further case, no library, no file.
"""

import builtins
import contextlib
import gc
import importlib
import io
import linecache
import os
import pickle
import random
import signal
import socket
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

COURSE = Path(__file__).resolve().parents[3]
PACKAGES = (
    *("kinoedu", "kinoedu.course", "kinoedu.geometry", "kinoedu.spaces", "kinoedu.support"),
    *("kinoedu.grading", "kinoedu.grading.sandbox"),
)


def prepare_imports() -> None:
    """Let modules of these packages be imported without the packages' own files.

    Those would load the library.
    """
    sys.path[:0] = [str(COURSE), *map(str, COURSE.glob("site-packages-*"))]
    for package in PACKAGES:
        sys.modules[package] = ModuleType(package)
        sys.modules[package].__path__ = [str(COURSE.joinpath(*package.split(".")))]
    # without numba the library gives the same answers, and starts at once
    sys.modules["numba"] = None  # type: ignore[assignment]


if not __package__:  # it is run as a program, and not read by a tool
    prepare_imports()

import numpy as np  # noqa: E402

from kinoedu.course.exceptions import describe_exception  # noqa: E402
from kinoedu.grading.sandbox import cells, fonts, imports, shut_in, stand_ins, wire  # noqa: E402
from kinoedu.grading.sandbox.cells import TimeUp  # noqa: E402
from kinoedu.grading.sandbox.lent import (  # noqa: E402
    LentModules,
    LentValues,
    take_from_library,
)
from kinoedu.support.text import split_lines  # noqa: E402

# numpy loads these at their first use
USUAL = ("numpy.fft", "numpy.linalg", "numpy.ma", "numpy.polynomial", "numpy.random", "secrets")
ALARMS = {signal.SIGPROF: signal.ITIMER_PROF, signal.SIGALRM: signal.ITIMER_REAL}
MOST_WAITS = 4.0  # times its limit of computing that a program may wait
BUSY_SHARE = 0.1  # a program that computes for less of the time only waits
LONGEST = 12.0  # times its limit, after which every program ends
AGAIN = 0.05  # seconds until an alarm is repeated


def main() -> None:
    """Load what programs use, and serve requests until the grader closes the socket."""
    grader = socket.socket(fileno=int(sys.argv[1]))
    for name in (*USUAL, *sys.argv[2:]):
        importlib.import_module(name)
    imports.keep_libraries()
    fonts.keep_fonts()
    take_from_library()
    forget_library()
    gc.freeze()
    grader.send(b"ready")
    while True:
        message, files, _, _ = socket.recv_fds(grader, 16, 2)
        if not message:
            return
        child = shut_in.fork_alone()
        if child == 0:
            grader.close()
            serve(*files)
        for file in files:
            os.close(file)
        grader.send(str(end_child(child, grader)).encode())


def forget_library() -> None:
    """Let programs find no module of kinoedu but those that are lent."""
    for name in [name for name in sys.modules if name.partition(".")[0] == "kinoedu"]:
        del sys.modules[name]
    del sys.modules["numba"]


def end_child(child: int, grader: socket.socket) -> int:
    """Wait until the grader has read enough, kill what still runs, and return its exit code."""
    grader.recv(16)
    with contextlib.suppress(ProcessLookupError):
        os.kill(child, signal.SIGKILL)
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])


def serve(requests: int, replies: int) -> None:
    """Run a student's program in this process. Never returns."""
    with contextlib.suppress(BaseException):
        replace_standard_files()
        Program(requests, replies).obey()
    os._exit(0)  # so functions that a program registered for the exit are not called


class Nowhere(io.RawIOBase):
    """A file that keeps nothing of what is written into it."""

    def writable(self) -> bool:
        """Whether it can be written: always."""
        return True

    def write(self, data: Any) -> int:
        """Discard the data."""
        return memoryview(data).nbytes


def replace_standard_files() -> None:
    """Put /dev/null in the place of standard input, output and errors.

    After `shut_in.leave_disk` it is a file of this process alone.
    """
    null = os.open(os.devnull, os.O_RDWR)
    for number in (0, 1, 2):
        os.dup2(null, number)
    os.close(null)


def discard_output() -> None:
    """Discard what is printed, and use no file that others have."""
    replace_standard_files()
    sys.stdout = sys.stderr = io.TextIOWrapper(io.BufferedWriter(Nowhere()), encoding="utf-8")


class Program:
    """A student's program, and its line to the runner."""

    def __init__(self, requests: int, replies: int) -> None:
        self.requests, self.replies = os.fdopen(requests, "rb"), os.fdopen(replies, "wb", 0)
        self.lent = LentValues(self.ask)
        self.space = make_main_module(__builtins__=builtins)
        self.compiler = cells.Compiler()
        self.is_asking, self.asked = False, 0.0  # seconds in which the runner answered

    def obey(self) -> None:
        """Do what each line says."""
        limits = self.receive()
        shut_in.give_up_rights(**limits)
        discard_output()
        self.send(ready=True)
        random.seed(0)
        np.random.seed(0)
        for request in iter(self.receive, None):
            if "lend" in request:
                reply = self.lend(request["lend"], request["drawing"])
            elif "cell" in request:
                reply = self.run_cell(request)
            elif "defined" in request:
                reply = {"defined": callable(self.space.get(request["defined"]))}
            else:
                reply = self.call(request)
            self.send(**reply)

    def receive(self) -> Any:
        """The next line of the runner; None where it has ended."""
        line = self.requests.readline()
        return wire.read_line(line) if line else None

    def send(self, **message: Any) -> None:
        """Write a line."""
        self.replies.write(wire.write_line(message))

    def ask(self, number: int, question: str, given: tuple[Any, ...], named: Any = None) -> Any:
        """Ask the runner about what it has lent, and return or raise what it answers."""
        began, self.is_asking = time.monotonic(), True
        try:
            encoded = [self.lent.encode(part) for part in (given, dict(named or {}))]
            self.send(ask=[number, question, *encoded])
            reply = self.receive()
        finally:
            self.asked += time.monotonic() - began
            self.is_asking = False
        return self.lent.take(reply)

    def lend(self, names: dict[str, dict[str, Any]], drawing: bool) -> dict[str, Any]:
        """Make names importable, and everything else that a notebook has."""
        modules = {
            module: {name: self.lent.decode(value) for name, value in values.items()}
            for module, values in names.items()
        }
        sys.meta_path.insert(0, LentModules(modules))
        stand_ins.install(self.space, has_pictures=drawing)
        if drawing:
            fonts.install_fonts()
        return {"lent": True}

    def run_cell(self, request: dict[str, Any]) -> dict[str, Any]:
        """Run a cell, and say what failed in it."""
        name, source = request["cell"], request["source"]
        linecache.cache[name] = (len(source), None, split_lines(source), name)
        troubles: list[Any] = []

        def work() -> None:
            for failure in cells.run_cell(source, name, self.space, self.compiler):
                described = describe_exception(failure.error, is_students)
                troubles.append([failure.line, *described])

        try:
            self.run_with_alarm(request["seconds"], work)
        except TimeUp as over:
            return {"troubles": troubles, "late": over.args, "line": over.line}
        return {"troubles": troubles}

    def call(self, request: dict[str, Any]) -> dict[str, Any]:
        """Call a function; what it returns, and which arguments it has changed."""
        function, chance = self.space.get(request["call"]), generators_state()
        given = [self.lent.decode(value) for value in request["given"]]

        def work() -> dict[str, Any]:
            try:
                return {"value": self.lent.encode(function(*given))}  # type: ignore[misc]
            except TimeUp:
                raise
            except BaseException as error:
                return {"raised": describe_exception(error, is_students)}

        try:
            reply = self.run_with_alarm(request["seconds"], work)
        except TimeUp as over:
            return {"late": over.args}
        changed = dict(self.find_changed(given, request["given"]))
        return {**reply, "changed": changed, "chance": generators_state() != chance}

    def find_changed(self, given: list[Any], sent: list[Any]) -> Iterator[tuple[int, Any]]:
        """Yield the number of each argument that is not as it was sent, and how it is now."""
        for number, (value, before) in enumerate(zip(given, sent, strict=True)):
            if isinstance(value, list | dict | np.ndarray) or self.lent.is_axes(value):
                now = self.lent.encode(self.lent.read(value))
                if now != before:
                    yield number, now

    def run_with_alarm(self, seconds: float, work: Callable[[], Any]) -> Any:
        """Run `work`, and return what it returns or raise what it raises.

        Raises TimeUp if it computes for more than `seconds`, or only waits for MOST_WAITS times
        that. A busy computer gives more time, up to LONGEST times the limit. The time in which the
        runner answers does not count. No thread may be started here, so signals are used. They are
        sent again and again until Python code stops; code that never handles them is killed from
        outside.
        """
        wall, processor, self.asked = time.monotonic(), time.process_time(), 0.0

        def ring(*_: object) -> None:
            used, passed = time.process_time() - processor, time.monotonic() - wall - self.asked
            waits = passed >= MOST_WAITS * seconds and used < BUSY_SHARE * passed
            is_over = used >= seconds or waits or passed >= LONGEST * seconds
            if is_over and not self.is_asking:
                raise TimeUp(used, seconds, passed)

        for alarm, limit in ((signal.SIGPROF, seconds), (signal.SIGALRM, MOST_WAITS * seconds)):
            signal.signal(alarm, ring)
            signal.setitimer(ALARMS[alarm], limit, AGAIN)
        try:
            return work()
        finally:
            while any(signal.getitimer(timer)[1] for timer in ALARMS.values()):
                try:
                    for timer in ALARMS.values():
                        signal.setitimer(timer, 0.0)
                except TimeUp:  # the alarm rang just now
                    continue


def make_main_module(**names: Any) -> dict[str, Any]:
    """The names of a new module __main__, in which Python finds a notebook's classes again.

    Pickle and dataclasses look for them there.
    """
    module = sys.modules["__main__"] = ModuleType("__main__")
    vars(module).update(names)
    return vars(module)


def generators_state() -> Any:
    """The state of the generators that all of Python and of numpy share, of whatever kind."""
    return random.getstate(), pickle.dumps(np.random.get_state(legacy=False))


def is_students(file: str) -> bool:
    """Whether a file is a cell of the notebook."""
    return file.startswith("cell ")


if __name__ == "__main__":
    main()
