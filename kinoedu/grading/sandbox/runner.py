"""Runs the cases of exercises: here is the library, and the student's program is elsewhere.

`python runner.py SOCKET` is started by `sandbox.py` in a sandbox of its own. For each request of
the grader it forks a process, which gets four files: the grader's requests and the replies to it,
and the line to the student's program, of which student.py tells. The first request is

    cells      the source of each cell, its number in the notebook, and its seconds
    questions  each with its name and its variant
    lent       what the assignment lends, as "module:name"
    drawing    whether matplotlib is lent
    patience   a factor on every time limit
    limits     of the student's process; see shut_in.py

and each further request holds cases for each question. Each cell and each case is answered by a
line of JSON as soon as it is done. An exercise's own `call` runs here. It calls the student's
function, which asks what it needs to know, and nobody else can be asked.
"""

import importlib
import json
import os
import signal
import socket
import sys
import time
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any

COURSE = Path(__file__).resolve().parents[3]
if not __package__:  # it is run as a program, and not read by a tool
    sys.path[:0] = [str(COURSE), *map(str, COURSE.glob("site-packages-*"))]
    # without numba the library gives the same answers, and starts at once
    sys.modules["numba"] = None  # type: ignore[assignment]

from kinoedu.course.exercise import Exercise  # noqa: E402
from kinoedu.course.judging import ends_a_run, run_called  # noqa: E402
from kinoedu.course.lessons import find  # noqa: E402
from kinoedu.course.outcomes import Outcome, encode_outcome  # noqa: E402
from kinoedu.grading.sandbox.remote import (  # noqa: E402
    GRACE,
    NO_VALUE,
    Ended,
    RemoteFunction,
    Student,
    read_late,
    read_raised,
)
from kinoedu.support.memory import bounded_memory  # noqa: E402

MEMORY = 2**31  # bytes that the cases of a request may take here
SELDOM = 0.05  # seconds between outcomes that are sent one by one
MOST_TROUBLES = 50  # of one cell
MOST_LINES = 10**6  # of one cell


def main() -> None:
    """Serve requests until the grader closes the socket."""
    grader = socket.socket(fileno=int(sys.argv[1]))
    grader.send(b"ready")
    while True:
        message, files, _, _ = socket.recv_fds(grader, 16, 4)
        if not message:
            return
        child = os.fork()
        if child == 0:
            grader.close()
            serve(*files)
        for file in files:
            os.close(file)
        grader.recv(16)
        os.kill(child, signal.SIGKILL)
        grader.send(str(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])).encode())


def serve(requests: int, replies: int, to_student: int, from_student: int) -> None:
    """Serve one request in this process. Never returns."""
    os.dup2(1, 2)  # to nowhere: nobody reads the warnings of numpy
    with os.fdopen(replies, "w", encoding="utf-8") as out:
        grader = Grader(out)
        try:
            with os.fdopen(requests, encoding="utf-8") as stream, bounded_memory(MEMORY):
                Session(grader, Student(to_student, from_student)).run(
                    map(json.loads, iter(stream.readline, ""))
                )
            out.flush()
        except Ended as end:
            grader.send(ended=end.reason)
        except MemoryError:
            grader.send(ended="flood")
        except BaseException as error:
            grader.send(broken=f"{type(error).__name__}: {error}")
    os._exit(0)


class Grader:
    """The line to the grader."""

    def __init__(self, stream: Any) -> None:
        self.stream = stream
        self.flushed = 0.0

    def send(self, **line: Any) -> None:
        """Write a line; it is sent at once where the last one was sent a while ago."""
        self.stream.write(json.dumps(line) + "\n")
        if time.monotonic() - self.flushed > SELDOM or "case" not in line:
            self.stream.flush()
            self.flushed = time.monotonic()


class Session:
    """The cells and the cases of one request."""

    def __init__(self, grader: Grader, student: Student) -> None:
        self.grader, self.student = grader, student

    def run(self, requests: Iterator[dict[str, Any]]) -> None:
        """Run the cells, then the cases as they come."""
        first = next(requests)
        self.student.start(first["limits"])
        self.grader.send(ready=True)
        patience = first["patience"]
        names = self.student.encode_names(read_names(first["lent"]))
        self.student.converse(GRACE * patience, lend=names, drawing=first["drawing"])
        for cell in first["cells"]:
            self.run_cell(cell, patience)
        self.grader.send(done=True)
        questions = {one["name"]: find(one["name"], one["variant"]) for one in first["questions"]}
        open_ones = dict.fromkeys(questions, True)
        for part in requests:
            for name, cases in part.items():
                if open_ones[name]:
                    open_ones[name] = self.run_cases(questions[name], cases, patience)
            self.grader.send(done=True)

    def run_cell(self, cell: dict[str, Any], patience: float) -> None:
        """Run a cell, and tell the grader what failed in it."""
        seconds = cell["seconds"] * patience
        name = f"cell {cell['number']}"
        reply = self.student.converse(seconds, cell=name, source=cell["source"])
        troubles = [
            {"line": line, "outcome": encode_outcome(outcome, NO_VALUE)}
            for line, outcome in read_troubles(reply)
        ]
        self.grader.send(cell=cell["number"], troubles=troubles)

    def run_cases(self, exercise: Exercise, cases: list[Any], patience: float) -> bool:
        """Run a function on some cases, and return whether it may get more cases.

        It stops at a case that takes too long, and at a function that is not written.
        """
        seconds = exercise.seconds * patience
        if self.student.converse(seconds, defined=exercise.name).get("defined") is not True:
            self.grader.send(question=exercise.name, missing=True)
            return False
        function = RemoteFunction(self.student, exercise.name, seconds)
        self.student.module = type(exercise).__module__
        for number, case in enumerate(cases):
            outcome = run_called(exercise, function, case, run_unlimited)
            if self.student.end:
                raise Ended(self.student.end)
            encoded = encode_outcome(outcome, exercise.answer)
            self.grader.send(question=exercise.name, case=number, outcome=encoded)
            if ends_a_run(outcome):
                return False
        return True


def read_names(lent: Iterable[str]) -> dict[str, dict[str, Any]]:
    """What an assignment lends, by module and name."""
    names: dict[str, dict[str, Any]] = {}
    for place in lent:
        home, name = place.split(":")
        names.setdefault(home, {})[name] = getattr(importlib.import_module(home), name)
    return names


def read_troubles(reply: dict[str, Any]) -> Iterator[tuple[int, Outcome]]:
    """Yield the line of each failure in a cell, and what it was.

    Raises
    ------
    Ended
        Where these are not such data.
    """
    troubles, line = reply.get("troubles"), reply.get("line", 0)
    for trouble in troubles[:MOST_TROUBLES] if isinstance(troubles, list) else [None]:
        if not isinstance(trouble, list) or [type(one) for one in trouble[:1]] != [int]:
            raise Ended("unasked")
        yield trouble[0] % MOST_LINES, read_raised(trouble[1:])
    if "late" in reply:
        if type(line) is not int:
            raise Ended("unasked")
        yield line % MOST_LINES, read_late(reply["late"])


def run_unlimited(seconds: float, work: Callable[[], Any]) -> Any:
    """Run work; the limits of a student's function are those of its line."""
    return work()


if __name__ == "__main__":
    main()
