"""The program that runs in the sandbox: it runs a student's cells, and their functions on cases.

Students' programs are run nowhere else. `python inside.py SOCKET [MODULE...]` is started by
`sandbox.py`. It loads the library and those modules once, and waits. For each request it forks a
process that shuts itself in, runs what it can, and writes a line of JSON for each cell and each
case as soon as that is done. The grader trusts none of these lines. A request comes as two files,
one to read and one to write lines to. Its first line holds

    cells      the source of each cell, its number in the notebook, and its seconds
    questions  each with its name, the shapes of its arguments and its answer, its seconds, and
               where its own `call` is defined, if it has one
    withheld   functions of the library that the questions ask for, as "module:name"
    lent       functions of the exercises' own modules that the assignment uses, named likewise
    limits     bytes of memory, seconds of processor, bytes of files, and the user to become

and each further line holds cases for each question. It is sent only when everything before is done,
so no earlier output can depend on these cases.
"""

import builtins
import contextlib
import gc
import importlib
import json
import linecache
import os
import signal
import socket
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

PRACTICE = 50
ALARMS = (signal.ITIMER_PROF, signal.ITIMER_REAL)
AGAIN = 0.05  # seconds until an alarm is repeated
HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent.parent.parent)]
sys.path += map(str, HERE.parent.parent.parent.glob("site-packages-*"))

# Both are beside this file. To import them from kinoedu would load all of it too early.
import library  # noqa: E402
import shut_in  # noqa: E402


def main() -> None:
    """Load the library, and serve requests until the grader closes the socket."""
    grader = socket.socket(fileno=int(sys.argv[1]))
    # without numba the library gives the same answers, and starts at once
    sys.modules["numba"] = None  # type: ignore[assignment]
    library.open_library()
    for name in (*library.USUAL, *sys.argv[2:]):
        importlib.import_module(name)
    practise()
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


def practise() -> None:
    """Do once what every request does.

    Python is faster the second time, and messages are read from their files only once.
    """
    import numpy as np

    from kinoedu.course.shapes import Number, Numbers, Record

    def length(q: Any, ring: Any, r: float) -> Any:
        return np.linalg.norm(np.roll(ring, 1, axis=0) @ q) + np.hypot(*q) + (ring - q).min() + r

    exercise = ExerciseShapes(
        Record(q=Numbers((2,)), ring=Numbers(("n", 2)), r=Number()),
        Number(),
        1.0,
        library.load_call(""),
    )
    cases = [{"q": [0.0, 1.0], "ring": [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]], "r": 1.0}] * PRACTICE
    with open(os.devnull, "w", encoding="utf-8") as nowhere:
        # an answer, a result of the wrong shape, an exception
        for function in (length, str, float):
            run_cases("", exercise, cases, {"": 0}, function, Channel(nowhere))


def end_child(child: int, grader: socket.socket) -> int:
    """Wait until the grader has read enough, kill what still runs, and return its exit code."""
    grader.recv(16)
    with contextlib.suppress(ProcessLookupError):
        os.kill(child, signal.SIGKILL)
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])


def serve(requests: int, replies: int) -> None:
    """Run a request in a process of its own. Never returns."""
    nowhere = os.open(os.devnull, os.O_RDWR)
    with contextlib.suppress(BaseException), os.fdopen(replies, "w", encoding="utf-8") as out:
        channel = Channel(out)
        for number in (0, 1, 2):
            os.dup2(nowhere, number)
        try:
            with os.fdopen(requests, encoding="utf-8") as stream:
                run(map(json.loads, iter(stream.readline, "")), channel)
        except BaseException as error:
            channel.send(broken=f"{type(error).__name__}: {error}")
    os._exit(0)  # so functions that a program registered for the exit are not called


class Channel:
    """The only output of a program: lines of JSON. What the program prints is discarded."""

    def __init__(self, stream: Any) -> None:
        self.stream = stream

    def send(self, **line: Any) -> None:
        """Write a line and flush it."""
        self.stream.write(json.dumps(line) + "\n")
        self.stream.flush()


class ExerciseShapes(NamedTuple):
    """The part of an exercise that a call needs."""

    given: Any
    answer: Any
    seconds: float
    call: Callable[..., Any]


def run(requests: Iterator[dict[str, Any]], channel: Channel) -> None:
    """Give up every right, then run the cells and the questions, part by part."""
    request = next(requests)
    library.withhold(request["withheld"])
    questions = {question["name"]: read_question(question) for question in request["questions"]}
    names = {cell["number"]: f"cell {cell['number']}" for cell in request["cells"]}
    for cell in request["cells"]:
        linecache.cache[names[cell["number"]]] = (
            len(cell["source"]),
            None,
            cell["source"].splitlines(True),
            names[cell["number"]],
        )
    shut_in.give_up_rights(**request["limits"], hidden=library.remove_judges(request["lent"]))
    channel.send(ready=True)
    space: dict[str, Any] = {
        "__name__": "__main__",
        "__builtins__": builtins,
        "display": do_nothing,
        "get_ipython": do_nothing,
    }
    for cell in request["cells"]:
        run_cell(cell, names[cell["number"]], space, channel)
    channel.send(done=True)
    counts = dict.fromkeys(questions, 0)
    for part in requests:
        for name, cases in part.items():
            if name in counts and not run_cases(
                name, questions[name], cases, counts, space.get(name), channel
            ):
                del counts[name]
        channel.send(done=True)


def read_question(question: dict[str, Any]) -> ExerciseShapes:
    """The shapes and the `call` of a question; the request spells the shapes as Python source."""
    shape_names: dict[str, Any] = {}
    planning = ("tasks", "drivable", "expansions") if "ProblemShape()" in question["given"] else ()
    for name in ("shapes", "whole_shapes", "drawn", *planning):
        shape_names |= vars(importlib.import_module(f"kinoedu.course.{name}"))
    given, wanted = (eval(question[part], shape_names) for part in ("given", "answer"))
    return ExerciseShapes(given, wanted, question["seconds"], library.load_call(question["call"]))


def run_cell(cell: dict[str, Any], name: str, space: dict[str, Any], channel: Channel) -> None:
    """Run one cell; its failure does not end the others."""
    from kinoedu.course.outcomes import Answer, encode_outcome, outcome_of
    from kinoedu.course.shapes import Maybe, Truth

    no_value = Maybe(Truth())
    outcome = outcome_of(
        lambda: exec(compile(cell["source"], name, "exec"), space),
        no_value,
        cell["seconds"],
        run_with_alarm,
    )
    trouble = None if isinstance(outcome, Answer) else encode_outcome(outcome, no_value)
    channel.send(cell=cell["number"], trouble=trouble)


def run_cases(
    name: str,
    exercise: ExerciseShapes,
    cases: list[Any],
    counts: dict[str, int],
    function: Any,
    channel: Channel,
) -> bool:
    """Run a function on some cases, and return whether it may get more cases.

    It stops at a case that takes too long, and at a function that is not written.
    """
    from kinoedu.course.judging import is_unwritten, run_encoded_case
    from kinoedu.course.outcomes import Late, encode_outcome

    if not callable(function):
        channel.send(question=name, missing=True)
        return False
    for case in cases:
        outcome = run_encoded_case(exercise, function, case, run_with_alarm)  # type: ignore[arg-type]
        channel.send(
            question=name, case=counts[name], outcome=encode_outcome(outcome, exercise.answer)
        )
        counts[name] += 1
        if isinstance(outcome, Late) or is_unwritten(outcome):
            return False
    return True


def do_nothing(*_: Any, **__: Any) -> None:
    """Stand in for functions that only a notebook has; it does nothing."""


def run_with_alarm(seconds: float, work: Callable[[], Any]) -> Any:
    """Run `work` with a time limit, and return what it returns or raise what it raises.

    Raises TimeUp if it computes for more than `seconds` of processor time, or waits for
    MAX_WAIT_FACTOR times that on the clock. No thread may be started here, so signals are used.
    They are sent again and again until Python code stops; code that never handles them is killed
    from outside.
    """
    from kinoedu.support.time_limit import MAX_WAIT_FACTOR, TimeUp

    wall, processor = time.monotonic(), time.process_time()

    def ring(*_: object) -> None:
        raise TimeUp(time.process_time() - processor, seconds, time.monotonic() - wall)

    signal.signal(signal.SIGPROF, ring)
    signal.signal(signal.SIGALRM, ring)
    try:
        signal.setitimer(signal.ITIMER_PROF, seconds, AGAIN)
        signal.setitimer(signal.ITIMER_REAL, seconds * MAX_WAIT_FACTOR, AGAIN)
        return work()
    finally:
        while any(signal.getitimer(which)[1] for which in ALARMS):
            try:
                for which in ALARMS:
                    signal.setitimer(which, 0.0)
            except TimeUp:  # the alarm rang just now
                continue


if __name__ == "__main__":
    main()
