"""Processes in which runs are made, one after another. Each can be stopped whatever it is doing,
and may crash: the others go on.

A watchdog inside the process ends it when a run takes too long. It is a thread of C that needs no
lock of Python's, so compiled code cannot keep it from its work, and it works as well where nobody
is left to watch from outside.
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
from typing import Any, BinaryIO

from ..compiled.tiers import BEGUN, DONE
from .cells import NOT_RUN, Cell, Outcome, out_of_time, run_cell
from .digests import version

START = (
    "import sys; sys.path[:] = {path!r}; from kinoedu.experiments.children import serve; serve()"
)
LENGTH = struct.Struct("<Q")
LOADING, COMPILING = 10.0, 300.0  # seconds that the first run may take longer, and a compiled one
IDLE = 60.0  # seconds that a process waits for work
STOPPED = b"Timeout ("  # the watchdog's last word


class Ended(Exception):
    """A process ended before its run did."""


class Child:
    """A process that answers one cell after another."""

    def __init__(self) -> None:
        self.complaints = tempfile.TemporaryFile()  # noqa: SIM115 (closed by end)
        self.process = subprocess.Popen(
            [sys.executable, "-c", START.format(path=sys.path)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=self.complaints,
        )

    def ask(self, cell: Cell) -> Outcome:
        """The outcome of one run. Raises Ended."""
        assert self.process.stdin is not None and self.process.stdout is not None
        question = pickle.dumps((version(), cell))
        try:
            send(question, self.process.stdin)
            return Outcome(*receive(self.process.stdout))
        except (EOFError, OSError):
            self.process.kill()
            status = self.process.wait()
            self.complaints.seek(0)
            if STOPPED in self.complaints.read():
                return out_of_time(cell)
            raise Ended(f"the process of the run ended with status {status}") from None

    def end(self) -> None:
        """End it, whatever it is doing."""
        self.process.kill()
        self.process.communicate()
        self.complaints.close()


class Children:
    """As many processes as there are callers at a time, kept for the next."""

    def __init__(self) -> None:
        self.all: set[Child] = set()
        self.idle: list[Child] = []
        self.open, self.lock = True, threading.Lock()

    def ask(self, cell: Cell) -> Outcome:
        """The outcome of one run, in a process that is free. Raises Ended."""
        child = self.take()
        try:
            return child.ask(cell)
        finally:
            self.put(child)

    def take(self) -> Child:
        """A process that waits, or a new one."""
        with self.lock:
            if not self.open:
                raise Ended("the experiment was stopped")
            child = self.idle.pop() if self.idle else Child()
            self.all.add(child)
        if child.process.poll() is None:
            return child
        self.put(child)
        return self.take()

    def put(self, child: Child) -> None:
        """Keep a process for the next run, or bury it."""
        with self.lock:
            alive = self.open and child.process.poll() is None
            if alive:
                self.idle.append(child)
            else:
                self.all.discard(child)
        if not alive:
            child.end()

    def close(self) -> None:
        """End them all."""
        with self.lock:
            self.open = False
            for child in self.all:
                child.process.kill()
            waiting, self.idle = self.idle, []
        for child in waiting:
            child.end()


HERE = Children()  # of this process; where it is a cluster's worker, nobody else could keep them


def in_child(cell: Cell) -> Outcome:
    """The outcome of one run in a process beside this one: what an executor's worker calls. Raises
    Ended.
    """
    return HERE.ask(cell)


def send(message: bytes, stream: Any) -> None:
    """Write a message with its length before it."""
    stream.write(LENGTH.pack(len(message)) + message)
    stream.flush()


def receive(stream: Any) -> Any:
    """What was sent. Raises EOFError where the other side is gone."""
    (length,) = LENGTH.unpack(read(stream, LENGTH.size))
    return pickle.loads(read(stream, length))


def read(stream: Any, length: int) -> bytes:
    """So many bytes."""
    message: bytes = stream.read(length)
    if len(message) < length:
        raise EOFError
    return message


def serve() -> None:
    """Answer cells from standard input on standard output until it closes: what a child does."""
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what a planner prints is no answer
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is the parent's to hear
    faulthandler.enable()
    known: set[str] = set()
    with open(os.devnull, "wb") as nowhere:
        while True:
            faulthandler.dump_traceback_later(IDLE, exit=True, file=nowhere)
            try:
                outcome = answer(sys.stdin.buffer, known)
            except EOFError:
                return
            send(pickle.dumps(tuple(outcome)), answers)


def answer(questions: BinaryIO, known: set[str]) -> Outcome:
    """The outcome of the next cell; the first of its kind is run once more before, untimed, to load
    and compile what it needs.
    """
    (length,) = LENGTH.unpack(read(questions, LENGTH.size))
    message = read(questions, length)
    faulthandler.cancel_dump_traceback_later()
    try:
        theirs, cell = pickle.loads(message)
    except (
        Exception
    ) as error:  # a planner of the reader's own in a module that is not there raises anything
        return Outcome(
            NOT_RUN,
            reason=f"the planner cannot be loaded in another process: {type(error).__name__}: {error}",
        )
    if theirs != version():
        return Outcome(NOT_RUN, reason="the worker has another version of kinoedu")
    if cell.kind not in known:
        with Watch(cell.time_limit + LOADING):
            first = run_cell(cell)
        if first.status == NOT_RUN:
            return first
        known.add(cell.kind)
    with Watch(cell.time_limit * cell.repeat):
        return run_cell(cell)


class Watch(logging.Handler):
    """Ends the process when a run takes too long; while something is compiled it has patience."""

    def __init__(self, seconds: float) -> None:
        super().__init__(logging.INFO)
        self.seconds, self.log = seconds, logging.getLogger("kinoedu")

    def __enter__(self) -> None:
        self.log.setLevel(logging.INFO)
        self.log.addHandler(self)
        faulthandler.dump_traceback_later(self.seconds, exit=True)

    def __exit__(self, *_: Any) -> None:
        faulthandler.cancel_dump_traceback_later()
        self.log.removeHandler(self)

    def emit(self, record: logging.LogRecord) -> None:
        """While something is compiled, the planner's own time does not run."""
        patience = {BEGUN: COMPILING, DONE: 0.0}.get(record.msg)
        if patience is not None:
            faulthandler.dump_traceback_later(self.seconds + patience, exit=True)
