"""A student's program in its own process, as the runner calls it and answers its questions.

What is not plain data is lent to the program: it gets a number, and asks about it. Nothing that
comes from the program is run or trusted; see `wire.py`.
"""

import contextlib
import operator
import os
import random
import select
import signal
from collections.abc import Callable, Iterator
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from ...course.drawn import Canvas
from ...course.exceptions import class_name, message_of
from ...course.lent_problem import LentProblem
from ...course.outcomes import Elsewhere, Late, Outcome, Raised, decode_outcome
from ...course.plain import WrongShape
from ...course.shapes import Maybe, Truth
from ...support.time_limit import MAX_WAIT_FACTOR
from . import wire

GRACE = 2.0  # seconds that a program has to report what stopped it
LESSONS = "kinoedu.course.lessons."
SHARED = LESSONS + "shared."
START = 60.0  # seconds until the student's process is ready, on a slow computer
ANSWERING = 4.0  # times the limit of a call that all its questions may take
MOST_LINE = 4 * 2**20  # bytes
MOST_OUTPUT = 64 * 2**20  # bytes of a whole run
MOST_LENT = 100_000  # things lent in a whole run
NO_VALUE = Maybe(Truth())
COLLECTION: dict[str, Callable[..., Any]] = {
    "__len__": len,
    "__iter__": list,
    "__contains__": operator.contains,
}


class Ended(Exception):
    """The student's program can go on no more.

    reason : "late", "flood", "died", or "unasked" where it wrote what no line asked for.
    """

    def __init__(self, reason: str) -> None:
        super().__init__(reason)
        self.reason = reason


class NotLentError(Exception):
    """A program asks something that is not lent to the exercise whose case is run."""


class RemoteFunction:
    """A student's function. What a call changes there, it changes here as well."""

    def __init__(self, student: "Student", name: str, seconds: float) -> None:
        self.student, self.name, self.seconds = student, name, seconds

    def __call__(self, *given: Any) -> Any:
        """Call it, and return its value.

        Raises
        ------
        Elsewhere
            Where it did not return one.
        """
        try:
            encoded = [self.student.encode(value) for value in given]
            reply = self.student.converse(self.seconds, call=self.name, given=encoded)
            outcome = read_outcome(reply)
            if outcome is None:
                self.follow(given, reply)
                return self.student.decode(reply["value"])
        except Ended as end:
            self.student.end = end.reason
            outcome = Late(False)
        except (wire.Unfit, LookupError, TypeError, ValueError, AttributeError, ArithmeticError):
            self.student.end = "unasked"
            outcome = Late(False)
        raise Elsewhere(outcome)

    def follow(self, given: tuple[Any, ...], reply: dict[str, Any]) -> None:
        """Change the arguments and the shared generators as the call has changed them there."""
        for number, data in reply["changed"].items():
            put(self.student.decode(data), given[int(number)])
        if reply["chance"]:
            random.random()
            np.random.random()


def read_outcome(reply: dict[str, Any]) -> Outcome | None:
    """The outcome of a call that returned nothing; None where it returned a value.

    Raises
    ------
    Ended
        Where it is no outcome.
    """
    if "late" in reply:
        return read_late(reply["late"])
    return read_raised(reply["raised"]) if "raised" in reply else None


def read_late(data: Any) -> Outcome:
    """The outcome of a program that took too long. Raises Ended."""
    try:
        used, allowed, passed = data
        return as_outcome(
            Late, left_running=False, used=used, allowed=allowed, passed=passed, lines=[]
        )
    except (TypeError, ValueError):
        raise Ended("unasked") from None


def read_raised(data: Any) -> Outcome:
    """The outcome of a program that raised an exception. Raises Ended."""
    try:
        return as_outcome(Raised, **dict(zip(Raised._fields, data, strict=True)))
    except (TypeError, ValueError):
        raise Ended("unasked") from None


def as_outcome(kind: Any, **fields: Any) -> Outcome:
    """An outcome with fields of the right shapes. Raises Ended."""
    data = {"kind": kind.__name__, **kind._field_defaults, **fields}
    try:
        return decode_outcome(data, NO_VALUE)
    except (WrongShape, TypeError, ValueError, OverflowError, RecursionError):
        raise Ended("unasked") from None


def put(now: Any, value: Any) -> None:
    """Give an argument its new content."""
    if isinstance(value, Canvas):
        value.contents = now
    elif isinstance(value, np.ndarray):
        value[...] = now if np.shape(now) == value.shape else np.nan
    elif isinstance(value, list):
        value[:] = now if isinstance(now, list) else []
    elif isinstance(value, dict):
        value.clear()


class Lent(NamedTuple):
    """What was lent under a number; `ask` answers a question about it.

    A function of an exercise's own module, such as a wrong program that students must expose, is
    lent to the cells and to that exercise alone, since it may do much of what others ask for.
    """

    value: Any
    ask: Callable[..., Any]

    def is_for(self, module: str) -> bool:
        """Whether it is lent to the exercise of a module; "" stands for the cells."""
        home = str(getattr(self.value, "__module__", ""))
        is_shared = home.startswith(SHARED) or not home.startswith(LESSONS)
        return is_shared or module in ("", home)


def ask_thing(thing: Any, name: str, *given: Any, **named: Any) -> Any:
    """What a method of a thing returns, or its data of that name.

    Only what is public is asked for, and what COLLECTION holds. Raises AttributeError.
    """
    if name in COLLECTION:
        return COLLECTION[name](thing, *given)
    if name.startswith("_"):
        raise AttributeError(name)
    part = getattr(thing, name)
    return part(*given, **named) if callable(part) else part


class Student:
    """The student's process: one line to it, and the answer, with its questions in between."""

    def __init__(self, to_student: int, from_student: int) -> None:
        self.requests, self.replies = to_student, from_student
        self.buffer = b""
        self.total = 0
        self.end = ""
        self.module = ""  # of the exercise whose cases are run
        self.lent: list[Lent] = []
        self.classes: dict[type, int] = {}  # the numbers of those of them that are classes
        self.generators: dict[int, Any] = {}

    def start(self, limits: dict[str, int]) -> None:
        """Send the limits, and wait until the process has given up its rights. Raises Ended."""
        with time_limit(START):
            self.write(limits)
            if self.read() != {"ready": True}:
                raise Ended("died")

    def converse(self, seconds: float, **request: Any) -> dict[str, Any]:
        """Send a line, answer the questions that come, and return the line that answers it.

        seconds : of computation; the process reports itself where it takes longer, and is given up
            where it does not answer at all.

        Raises
        ------
        Ended
        """
        if self.buffer or select.select([self.replies], [], [], 0)[0]:
            raise Ended("unasked")
        answering = ANSWERING * seconds
        with time_limit(MAX_WAIT_FACTOR * seconds + GRACE):
            self.write({**request, "seconds": seconds})
            while "ask" in (reply := self.read()):
                waiting = set_alarm(answering)
                self.write(self.answer(reply["ask"]))
                answering = set_alarm(waiting)
        return reply

    def write(self, message: dict[str, Any]) -> None:
        """Write a line. Raises Ended."""
        try:
            data = wire.write_line(message)
            while data:
                data = data[os.write(self.requests, data) :]
        except BrokenPipeError:
            raise Ended("died") from None

    def read(self) -> dict[str, Any]:
        """The next line. Raises Ended."""
        while b"\n" not in self.buffer:
            data = os.read(self.replies, 2**16)
            self.total += len(data)
            self.buffer += data
            if not data:
                raise Ended("died")
            if len(self.buffer) > MOST_LINE or self.total > MOST_OUTPUT:
                raise Ended("flood")
        line, _, self.buffer = self.buffer.partition(b"\n")
        try:
            return wire.read_line(line)
        except wire.Unfit:
            raise Ended("unasked") from None

    def answer(self, question: Any) -> dict[str, Any]:
        """The answer to a question: a value or an exception, and the generators' new states.

        Raises
        ------
        Ended
            Where it is no question.
        """
        used: dict[int, Any] = {}
        try:
            number, name, given, named = question
            lent = self.lent[number]
            values = self.decode(given, used), self.decode(named, used)
        except (wire.Unfit, TypeError, ValueError, LookupError, ArithmeticError) as error:
            raise Ended("unasked") from error
        try:
            if not lent.is_for(self.module):
                raise NotLentError("this function is lent to its own exercise alone")
            reply = {"value": self.encode(lent.ask(name, *values[0], **values[1]))}
        except Ended:
            raise
        except Exception as error:
            kinds = [class_name(kind) for kind in type(error).__mro__]
            reply = {"raised": [kinds, message_of(error)]}
        states = [[number, wire.read_state(used[number])] for number in used]
        return {**reply, "states": states}

    def encode_names(self, names: dict[str, dict[str, Any]]) -> dict[str, dict[str, Any]]:
        """Values by module and name, encoded."""
        return {
            home: {name: self.encode(value) for name, value in values.items()}
            for home, values in names.items()
        }

    def encode(self, value: Any) -> Any:
        """A value for the student's process; what is not plain is lent."""
        return wire.encode(value, self.lend)

    def decode(self, data: Any, used: dict[int, Any] | None = None) -> Any:
        """A value of the student's process; the generators in it are noted in `used`."""

        def find_value(mark: str, content: Any) -> Any:
            if mark == wire.LENT:
                return self.lent[content].value
            number, state = content
            if number not in self.generators:
                self.generators[int(number)] = wire.generator_of(state)
            wire.set_state(self.generators[number], state)
            if used is not None:
                used[number] = self.generators[number]
            return self.generators[number]

        return wire.decode(data, find_value)

    def lend(self, value: Any) -> dict[str, Any]:
        """Lend what is not plain, and return its mark."""
        if isinstance(value, Canvas):
            return {wire.LENT: {"is": "axes"}}
        if hasattr(value, "lend"):
            value = value.lend()
        if len(self.lent) >= MOST_LENT:
            raise Ended("flood")
        number = len(self.lent)
        if isinstance(value, LentProblem):
            self.lent.append(Lent(value, value._ask))
            return {wire.LENT: {"is": "problem", "number": number, "parts": self.parts(value)}}
        fields = getattr(value, "_fields", None)
        if fields is None and type(value) in self.classes:
            self.lent.append(Lent(value, partial(ask_thing, value)))
            return {wire.LENT: {"is": "thing", "number": number, "of": self.classes[type(value)]}}
        self.lent.append(Lent(value, lambda name, *given, **named: value(*given, **named)))
        if fields is None and isinstance(value, type):
            number = self.classes.setdefault(value, number)
            methods = [name for name in dir(value) if callable(getattr(value, name))]
            name = class_name(value)
            return {wire.LENT: {"is": "class", "number": number, "name": name, "methods": methods}}
        if fields is None or isinstance(value, type):
            name = str(getattr(value, "__name__", ""))
            return {wire.LENT: {"is": "function", "number": number, "name": name}}
        parts = {name: self.encode(getattr(value, name)) for name in fields}
        return {wire.LENT: {"is": "record", "number": number, "parts": parts}}

    def parts(self, problem: LentProblem) -> dict[str, Any]:
        """What the student's process needs of a problem."""
        metric = problem._metric
        space = ["float", metric] if isinstance(metric, float) else [type(metric).__name__, *metric]
        parts = {
            "questions": problem._questions,
            "numbers": problem._numbers,
            "ends": problem._ends,
            "metric": space,
        }
        return {name: self.encode(part) for name, part in parts.items()}


class TooLong(BaseException):
    """A program and its questions have taken too long."""


@contextlib.contextmanager
def time_limit(seconds: float) -> Iterator[None]:
    """Raise Ended where what is done within takes longer than some seconds."""

    def ring(*_: object) -> None:
        raise TooLong

    signal.signal(signal.SIGALRM, ring)
    set_alarm(seconds)
    try:
        yield
    except TooLong:
        raise Ended("late") from None
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)


def set_alarm(seconds: float) -> float:
    """Set the alarm, and return the seconds that it had left."""
    return signal.setitimer(signal.ITIMER_REAL, max(seconds, 1e-6))[0]
