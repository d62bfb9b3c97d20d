"""What runs in the sandbox: a student's cells, and then their functions on cases. Nothing else ever runs a student's program.

`python -I inside.py SOCKET MODE`, started by `sandbox.py`, loads the library once, "compiled" or "plain", and waits. For each
request it forks a process that shuts itself in, runs what it can, and writes a line of JSON for each cell and each case as soon as
it is done; whoever reads believes none of it. A request comes as two files, one to read and one to write lines to:

    cells      the source of each cell, its number in the notebook, and its seconds
    questions  each with its name, the shapes of what is given and answered, its seconds, its cases, and where it has a call of its
               own the module and the class that make it
    withheld   functions of the library that the questions ask for, as "module:name"
    limits     bytes of memory, seconds of processor, bytes of files, and the user to become
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
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent.parent)]

import library  # noqa: E402  (beside this file: to import them from kinoedu would load all of it, before the mode is known)
import shut_in  # noqa: E402


def main() -> None:
    """Load the library, and serve requests until nobody asks any more."""
    grader, mode = socket.socket(fileno=int(sys.argv[1])), sys.argv[2]
    if mode == "plain":
        sys.modules["numba"] = None  # type: ignore[assignment]  # not there: the library answers the same, and starts at once
    library.open_library()
    for name in library.USUAL:
        importlib.import_module(name)
    gc.freeze()
    grader.send(b"ready")
    while True:
        message, files, _, _ = socket.recv_fds(grader, 16, 2)
        if not message:
            return
        child = os.fork()
        if child == 0:
            grader.close()
            serve(*files)
        for file in files:
            os.close(file)
        grader.send(str(ended(child, grader)).encode())


def ended(child: int, grader: socket.socket) -> int:
    """Wait until the grader has heard enough, and end what still runs; how it ended."""
    grader.recv(16)
    with contextlib.suppress(ProcessLookupError):
        os.kill(child, signal.SIGKILL)
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])


def serve(asking: int, answering: int) -> None:
    """Shut in, run a request. Never returns."""
    shut_in.alone()
    nowhere = os.open(os.devnull, os.O_RDWR)
    with contextlib.suppress(BaseException), os.fdopen(answering, "w", encoding="utf-8") as out:
        with os.fdopen(asking, encoding="utf-8") as stream:
            request = json.load(stream)
        for number in (0, 1, 2):
            os.dup2(nowhere, number)
        run(request, Channel(out))
    os._exit(0)  # what a program left behind, such as functions to be called at the end, has no say


class Channel:
    """The one way out: lines of JSON. What a program prints goes nowhere."""

    def __init__(self, stream: Any) -> None:
        self.stream = stream

    def say(self, **line: Any) -> None:
        """Write a line, and see to it that it is on its way."""
        self.stream.write(json.dumps(line) + "\n")
        self.stream.flush()


class Asked(NamedTuple):
    """As much of an exercise as a call needs."""

    given: Any
    answer: Any
    seconds: float
    call: Callable[..., Any]


def run(request: dict[str, Any], channel: Channel) -> None:
    """Give up every right, then run the cells and ask the questions."""
    library.withhold(request["withheld"])
    questions = [(question, asked(question)) for question in request["questions"]]
    names = {cell["number"]: f"cell {cell['number']}" for cell in request["cells"]}
    for cell in request["cells"]:
        linecache.cache[names[cell["number"]]] = (len(cell["source"]), None, cell["source"].splitlines(True), names[cell["number"]])
    shut_in.without_rights(**request["limits"])
    channel.say(ready=True)
    space: dict[str, Any] = {"__name__": "__main__", "__builtins__": builtins, "display": silent, "get_ipython": silent}
    for cell in request["cells"]:
        run_cell(cell, names[cell["number"]], space, channel)
    for question, exercise in questions:
        answer(question, exercise, space.get(question["name"]), channel)
    channel.say(done=True)


def asked(question: dict[str, Any]) -> Asked:
    """What a question's calls need: shapes that stand in the request as Python writes them, and its way to call."""
    from kinoedu.course import drawn, shapes, whole_shapes

    if question["home"]:
        module, _, name = question["home"].partition(":")
        own = getattr(importlib.import_module(module), name)()
        return Asked(own.given, own.answer, question["seconds"], own.call)
    known = {name: thing for module in (shapes, whole_shapes, drawn) for name, thing in vars(module).items()}
    given, wanted = (eval(question[part], known) for part in ("given", "answer"))
    return Asked(given, wanted, question["seconds"], lambda function, arguments: function(*arguments.values()))


def run_cell(cell: dict[str, Any], name: str, space: dict[str, Any], channel: Channel) -> None:
    """Run one cell; one that fails does not lose the others."""
    from kinoedu.course.outcomes import Answer, encode_outcome, outcome_of
    from kinoedu.course.shapes import Maybe, Truth

    nothing = Maybe(Truth())
    outcome = outcome_of(lambda: exec(compile(cell["source"], name, "exec"), space), nothing, cell["seconds"], by_alarm)
    trouble = None if isinstance(outcome, Answer) else encode_outcome(outcome, nothing)
    channel.say(cell=cell["number"], trouble=trouble)


def answer(question: dict[str, Any], exercise: Asked, function: Any, channel: Channel) -> None:
    """Run a function on its cases, until one takes too long."""
    from kinoedu.course.exercise import Case
    from kinoedu.course.judging import attempt, is_unwritten
    from kinoedu.course.outcomes import Late, encode_outcome

    if not callable(function):
        channel.say(question=question["name"], missing=True)
        return
    for number, case in enumerate(question["cases"]):
        outcome = attempt(exercise, function, Case("", exercise.given.decode(case)), by_alarm)  # type: ignore[arg-type]
        channel.say(question=question["name"], case=number, outcome=encode_outcome(outcome, exercise.answer))
        if isinstance(outcome, Late) or is_unwritten(outcome):
            return


def silent(*_: Any, **__: Any) -> None:
    """Stands for what only a notebook can do."""


def by_alarm(seconds: float, work: Callable[[], Any]) -> Any:
    """What work() returns or raises; TimeUp where that takes longer. No thread may be started here, so an alarm rings, again and
    again until Python code stops; what does not hear it is ended from outside.
    """
    from kinoedu.time_limit import TimeUp

    def ring(*_: Any) -> None:
        raise TimeUp

    signal.signal(signal.SIGALRM, ring)
    try:
        signal.setitimer(signal.ITIMER_REAL, seconds, 0.05)
        return work()
    finally:
        while signal.getitimer(signal.ITIMER_REAL)[1]:
            try:
                signal.setitimer(signal.ITIMER_REAL, 0.0)
            except TimeUp:  # it rang just now
                continue


if __name__ == "__main__":
    main()
