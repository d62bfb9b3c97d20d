"""What became of one call of a student's function, and how that travels as JSON.

An answer of the declared shape; an answer of another shape; an exception; or no answer in time.
Only this leaves the place where student code runs.
"""

import linecache
import traceback
from collections.abc import Callable, Sequence
from pathlib import Path
from types import FrameType, TracebackType
from typing import Any, NamedTuple

from ..support.time_limit import Bounded, Seen, TimeUp, within_processor_time
from ..words import say
from .plain import WrongShape, class_name, wrong
from .shapes import Listed, Record, Shape, Text, Truth

HERE = str(Path(__file__).resolve().parent.parent)


class Answer(NamedTuple):
    """It returned a value of the declared shape."""

    value: Any


class Misshapen(NamedTuple):
    """It returned something else; `message` says what was expected and what came."""

    message: str


class Changed(NamedTuple):
    """It changed arrays that it was given; their names."""

    names: list[str]


class Raised(NamedTuple):
    """It raised an exception: the names of its class and of the classes above, its message, the
    student's lines on the way, and the name of the student's function that raised it.
    """

    kinds: list[str]
    message: str
    lines: list[str]
    function: str

    @property
    def is_unwritten(self) -> bool:
        """Whether it says that nobody has written a function yet."""
        return self.kinds[:1] == ["NotImplementedError"]


class Late(NamedTuple):
    """It did not end within its time; `left_running` if it could not even be stopped.

    used, allowed : seconds of computing; how many were allowed on that computer, 0 where it is not
        known. passed : seconds on the wall. lines : a few lines of the student's, if it was seen in
        them alone for a long time.
    """

    left_running: bool
    used: float = 0.0
    allowed: float = 0.0
    passed: float = 0.0
    lines: Sequence[str] = ()


class Seconds(NamedTuple):
    """A stretch of time, as a float: neither negative nor longer than two weeks."""

    @property
    def words(self) -> str:
        """In words."""
        return say("shape.seconds")

    def encode(self, value: Any) -> float:
        """The float."""
        return self.decode(value)

    def decode(self, data: Any) -> float:
        """The same."""
        if type(data) is not float or not 0.0 <= data <= MOST_SECONDS:
            raise wrong(self.words, data)
        return data


MOST = 32  # classes above an exception's
MOST_SECONDS = 1e6
Outcome = Answer | Misshapen | Changed | Raised | Late
SHAPES: dict[type, Record] = {
    Misshapen: Record(message=Text()),
    Changed: Record(names=Listed(Text(), MOST)),
    Raised: Record(
        kinds=Listed(Text(), MOST), message=Text(), lines=Listed(Text(), 5), function=Text()
    ),
    Late: Record(
        left_running=Truth(),
        used=Seconds(),
        allowed=Seconds(),
        passed=Seconds(),
        lines=Listed(Text(), 6),
    ),
}


def outcome_of(
    call: Callable[[], Any],
    shape: Shape,
    seconds: float,
    bounded: Bounded = within_processor_time,
) -> Outcome:
    """Run it for at most so long, and copy what comes out into plain data of its shape."""

    def answered() -> Outcome:
        try:
            return Answer(shape.decode(shape.encode(call())))
        except TimeUp:
            raise
        except WrongShape as misfit:
            return Misshapen(str(misfit))
        # whatever a program can raise is an outcome; its message may be code of its own
        except BaseException as error:
            return raised(error)

    try:
        return bounded(seconds, answered)
    except TimeUp as over:
        return late(over)


def late(over: TimeUp) -> Late:
    """A time-out as plain data."""
    used, allowed, passed = (
        float(min(seconds, MOST_SECONDS)) for seconds in (over.used, over.allowed, over.passed)
    )
    lines = [] if over.seen is None else seen_lines(over.seen)
    return Late(over.left_running, used, allowed, passed, lines)


def seen_lines(seen: Seen) -> list[str]:
    """The student's lines in which a program was seen all the time, as "line 3: while True:"."""
    if not is_students(seen.file):
        return []
    numbers = range(seen.first, seen.last + 1)
    lines = [(number, linecache.getline(seen.file, number).strip()) for number in numbers]
    return [f"line {number}: {line}" for number, line in lines if line][:6]


def raised(error: BaseException) -> Raised:
    """An exception as plain data."""
    above = type.__dict__["__mro__"].__get__(type(error))
    kinds = [class_name(kind) for kind in above if kind not in (object, BaseException)][:MOST]
    own = own_steps(error.__traceback__)
    return Raised(kinds, message_of(error), lines_of(own), own[-1][0].f_code.co_name if own else "")


def message_of(error: BaseException) -> str:
    """An exception's message; one whose own code fails has none."""
    try:
        return str(str(error))[:2000]
    except BaseException:
        return ""


def own_steps(trace: TracebackType | None) -> list[tuple[FrameType, int]]:
    """The student's own functions that an exception passed, outermost first, each with the number
    of the line.
    """
    return [
        (frame, number)
        for frame, number in traceback.walk_tb(trace)
        if is_students(frame.f_code.co_filename)
    ]


def lines_of(steps: list[tuple[FrameType, int]]) -> list[str]:
    """Lines of code as "line 3: return 1 / 0"; a line that calls itself again and again only
    once.
    """
    lines = [
        f"line {number}: {linecache.getline(frame.f_code.co_filename, number).strip()}"
        for frame, number in steps
    ]
    return [
        line
        for line, after in zip(lines, [*lines[1:], ""])
        if line != after and not line.endswith(": ")
    ][-5:]


def is_students(file: str) -> bool:
    """Whether a file holds neither kinoedu nor an installed library."""
    return (
        not file.startswith((HERE, "<"))
        and "site-packages" not in file
        and not file.startswith(STANDARD)
    )


STANDARD = str(Path(traceback.__file__).resolve().parent)


def encode_outcome(outcome: Outcome, shape: Shape) -> dict[str, Any]:
    """An outcome as JSON data: its kind and what belongs to it."""
    if isinstance(outcome, Answer):
        return {"kind": "Answer", "value": shape.encode(outcome.value)}
    return {"kind": type(outcome).__name__, **SHAPES[type(outcome)].encode(outcome._asdict())}


def decode_outcome(data: Any, shape: Shape) -> Outcome:
    """An outcome from JSON data; WrongShape where it is none."""
    if isinstance(data, dict) and data.get("kind") == "Answer" and set(data) == {"kind", "value"}:
        return Answer(shape.decode(data["value"]))
    for kind, fields in SHAPES.items():
        if isinstance(data, dict) and data.get("kind") == kind.__name__:
            return kind(
                **fields.decode({name: value for name, value in data.items() if name != "kind"})
            )
    raise WrongShape("not an outcome")
