"""Worker processes that run cells one after another.

Each process can be stopped at any time and may crash without affecting the others. A watchdog
inside the process ends it when a run takes too long. The watchdog is a C thread that does not need
Python's global interpreter lock. So compiled code cannot block it, and it works even if the parent
process is gone.
"""

import faulthandler
import logging
import os
import pickle
import signal
import struct
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from typing import Any, BinaryIO

from ..compiled.tiers import BEGUN, DONE
from ..errors import InvalidParameter
from .cells import NOT_RUN, Cell, Outcome, kind_of, out_of_time, run_cell
from .digests import version

START = (
    "import sys; sys.path[:] = {path!r}; sys.dont_write_bytecode = True; "
    "from kinoedu.experiments.children import serve; serve()"
)
LENGTH = struct.Struct("<Q")
LOADING, COMPILING = 10.0, 300.0  # extra seconds for the first run, and for a compilation
IDLE = 60.0  # seconds for which a process waits for work
SLICE = 1.0  # seconds after which a batch comes back, so that its outcomes are stored
ENDING = 1.0  # seconds that a process has to end after it closed its pipes
STOPPED, EXIT_OF_WATCHDOG = b"Timeout (", 1  # what the watchdog prints, and its status


class ProcessEnded(Exception):
    """A process ended before its run did."""


Batch = tuple[Cell, ...]
Answer = Outcome | BaseException  # of a cell: what it gave, or how its worker was lost


class Child:
    """A process that runs one cell after another."""

    def __init__(self) -> None:
        self.errors = tempfile.TemporaryFile()  # noqa: SIM115 (closed by end)
        self.process = subprocess.Popen(
            [sys.executable, "-c", START.format(path=sys.path)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=self.errors,
            start_new_session=True,  # so that what a planner starts can be ended with it
        )

    def run(self, cell: Cell) -> Outcome:
        """Run a cell in the process.

        Raises
        ------
        ProcessEnded
            Where the process ended before the run did.
        """
        assert self.process.stdin is not None and self.process.stdout is not None
        try:
            send_message(pickle.dumps(cell), self.process.stdin)
            return Outcome(*receive_message(self.process.stdout))
        except (EOFError, OSError):
            with suppress(subprocess.TimeoutExpired):
                self.process.wait(ENDING)  # so that the status is its own
            status = self.kill()
            self.errors.seek(0)
            if status == EXIT_OF_WATCHDOG and STOPPED in self.errors.read():
                return out_of_time(cell)
            raise ProcessEnded(f"the process of the run ended with status {status}") from None

    def end(self) -> None:
        """End the process immediately, and do not wait for others that hold its pipes."""
        self.kill()
        for pipe in (self.process.stdin, self.process.stdout, self.errors):
            with suppress(OSError):  # what was written last has no reader
                pipe.close()  # type: ignore[union-attr]

    def kill(self) -> int:
        """Kill the process, and the processes that it started; the status with which it ended."""
        self.process.kill()
        status = self.process.wait()
        if hasattr(os, "killpg"):
            with suppress(OSError):  # there is no other
                os.killpg(self.process.pid, signal.SIGKILL)
        return status


class Children:
    """A pool with one process for each concurrent caller, kept for later runs."""

    def __init__(self) -> None:
        self.all: set[Child] = set()
        self.idle: list[Child] = []
        self.open, self.lock = True, threading.Lock()

    def run(self, cell: Cell) -> Outcome:
        """Run a cell in an idle process.

        Raises
        ------
        ProcessEnded
        """
        child = self.take()
        try:
            return child.run(cell)
        finally:
            self.put(child)

    def take(self) -> Child:
        """An idle process, or a new one."""
        with self.lock:
            if not self.open:
                raise ProcessEnded("the experiment was stopped")
            child = self.idle.pop() if self.idle else Child()
            self.all.add(child)
        if child.process.poll() is None:
            return child
        self.put(child)
        return self.take()

    def put(self, child: Child) -> None:
        """Keep a process for the next run; remove it where it has ended."""
        with self.lock:
            alive = self.open and child.process.poll() is None
            if alive:
                self.idle.append(child)
            else:
                self.all.discard(child)
        if not alive:
            child.end()

    def close(self) -> None:
        """End all processes."""
        with self.lock:
            self.open = False
            for child in self.all:
                child.process.kill()
            waiting, self.idle = self.idle, []
        for child in waiting:
            child.end()


OWN_CHILDREN = Children()  # of this process, which may be a cluster's worker


def run_in_children(pickled: bytes) -> list[Answer]:
    """Run a batch in a process beside this one; called by an executor's workers.

    A batch is pickled by its sender: Dask would look into each of its tuples.
    """
    return run_batch(pickle.loads(pickled), OWN_CHILDREN.run)


def run_batch(batch: Batch, run: Callable[[Cell], Outcome]) -> list[Answer]:
    """Answers to the first cells of a batch, as many as are run in a second, at least one."""
    answers: list[Answer] = []
    end = time.monotonic() + SLICE
    for cell in batch:
        try:
            answers.append(run(cell))
        except ProcessEnded as lost:
            answers.append(lost)
        if time.monotonic() > end:
            break
    return answers


def send_message(message: bytes, stream: Any) -> None:
    """Write a message, preceded by its length."""
    stream.write(LENGTH.pack(len(message)) + message)
    stream.flush()


def receive_message(stream: object) -> Any:
    """Read a message.

    Raises
    ------
    EOFError
        Where the other side has closed the stream.
    """
    (length,) = LENGTH.unpack(read_exactly(stream, LENGTH.size))
    return pickle.loads(read_exactly(stream, length))


def read_exactly(stream: Any, length: int) -> bytes:
    """Read exactly this many bytes. Raises EOFError where there are fewer."""
    message: bytes = stream.read(length)
    if len(message) < length:
        raise EOFError
    return message


def serve() -> None:
    """Main loop of a child: read cells from standard input, write outcomes to standard output."""
    tasks, answers = os.fdopen(os.dup(0), "rb"), os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # a planner's own output goes to standard error
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the parent handles Ctrl-C
    faulthandler.enable()
    warmed_up: set[str] = set()
    with open(os.devnull, "rb") as nothing, open(os.devnull, "wb") as nowhere:
        os.dup2(nothing.fileno(), 0)  # a planner that asks for input gets none
        while True:
            faulthandler.dump_traceback_later(IDLE, exit=True, file=nowhere)
            try:
                outcome = run_next_cell(tasks, warmed_up)
            except EOFError:
                return
            send_message(pickle.dumps(tuple(outcome)), answers)


def run_next_cell(tasks: BinaryIO, warmed_up: set[str]) -> Outcome:
    """Run the next cell, and return its outcome.

    The first cell of each kind is run once before, untimed, to load and compile what it needs.
    """
    (length,) = LENGTH.unpack(read_exactly(tasks, LENGTH.size))
    message = read_exactly(tasks, length)
    faulthandler.cancel_dump_traceback_later()
    try:
        cell = pickle.loads(message)
    except Exception as error:  # unpickling a user's planner can raise anything
        failure = f"{type(error).__name__}: {error}"
        reason = f"the planner cannot be loaded in another process: {failure}"
        return Outcome(NOT_RUN, reason=reason)
    if cell.version != version():
        return Outcome(NOT_RUN, reason="the worker has another version of kinoedu")
    if cell.kind not in warmed_up:
        if difference := find_difference(cell):
            return Outcome(NOT_RUN, reason=difference)
        with Watch(cell.time_limit + LOADING):
            first = run_cell(cell._replace(repeat=1))
        if first.status == NOT_RUN:
            return first
        warmed_up.add(cell.kind)
    with Watch(cell.time_limit * cell.repeat):
        return run_cell(cell)


def find_difference(cell: Cell) -> str:
    """Why this process would not run what the cell means, or ""."""
    try:
        same = kind_of(cell.problem, cell.planner, cell.repeat) == cell.kind
    except InvalidParameter as error:
        return str(error)
    return "" if same else "the worker has another version of your planner, robot or world"


class Watch(logging.Handler):
    """Ends the process when a run takes too long; compilation extends the limit."""

    def __init__(self, seconds: float) -> None:
        super().__init__(logging.INFO)
        self.seconds, self.log = seconds, logging.getLogger("kinoedu")

    def __enter__(self) -> None:
        self.log.setLevel(logging.INFO)
        self.log.addHandler(self)
        faulthandler.dump_traceback_later(self.seconds, exit=True)

    def __exit__(self, *_: object) -> None:
        faulthandler.cancel_dump_traceback_later()
        self.log.removeHandler(self)

    def emit(self, record: logging.LogRecord) -> None:
        """Extend the limit while something is compiled; only the planner's own time counts."""
        patience = {BEGUN: COMPILING, DONE: 0.0}.get(record.msg)
        if patience is not None:
            faulthandler.dump_traceback_later(self.seconds + patience, exit=True)
