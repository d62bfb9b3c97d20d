"""What became of one call of a student's function, and how that travels as JSON.

An answer of the declared shape; an answer of another shape; an exception; or no answer in time. Only this leaves the place where
student code runs.
"""

import linecache
import traceback
from collections.abc import Callable
from pathlib import Path
from types import TracebackType
from typing import Any, NamedTuple

from ..time_limit import TimeUp, within
from .plain import WrongShape
from .shapes import Listed, Record, Shape, Text, Truth

HERE = str(Path(__file__).resolve().parent.parent)


class Answer(NamedTuple):
    """It returned a value of the declared shape."""

    value: Any


class Misshapen(NamedTuple):
    """It returned something else; `message` says what was expected and what came."""

    message: str


class Raised(NamedTuple):
    """It raised an exception: the names of its class and of the classes above, its message, and the student's lines on the way."""

    kinds: list[str]
    message: str
    lines: list[str]

    @property
    def is_unanswered(self) -> bool:
        """Whether it says that nobody has written it yet."""
        return self.kinds[:1] == ["NotImplementedError"]


class Late(NamedTuple):
    """It did not end within its time; `left_running` if it could not even be stopped."""

    left_running: bool


Outcome = Answer | Misshapen | Raised | Late
SHAPES: dict[type, Record] = {
    Misshapen: Record(message=Text()),
    Raised: Record(kinds=Listed(Text()), message=Text(), lines=Listed(Text())),
    Late: Record(left_running=Truth()),
}


def outcome_of(call: Callable[[], Any], shape: Shape, seconds: float) -> Outcome:
    """Run it for at most so long, and copy what comes out into plain data of its shape."""

    def answered() -> Any:
        return shape.encode(call())

    try:
        return Answer(shape.decode(within(seconds, answered)))
    except TimeUp as over:
        return Late(over.left_running)
    except WrongShape as misfit:
        return Misshapen(str(misfit))
    except KeyboardInterrupt:
        raise
    except BaseException as error:
        return raised(error)


def raised(error: BaseException) -> Raised:
    """An exception as plain data."""
    kinds = [kind.__name__ for kind in type(error).__mro__ if kind not in (object, BaseException)]
    return Raised(kinds, message_of(error), own_lines(error.__traceback__))


def message_of(error: BaseException) -> str:
    """An exception's message; one whose own code fails has none."""
    try:
        return str(str(error))[:2000]
    except BaseException:
        return ""


def own_lines(trace: TracebackType | None) -> list[str]:
    """The lines of the student's own code that an exception passed, outermost first, as "line 3: return 1 / 0"."""
    steps = [(frame.f_code.co_filename, number) for frame, number in traceback.walk_tb(trace)]
    own = [(file, number) for file, number in steps if is_students(file)]
    return [f"line {number}: {text}" for file, number in own[-5:] if (text := linecache.getline(file, number).strip())]


def is_students(file: str) -> bool:
    """Whether a file holds neither kinoedu nor an installed library."""
    return not file.startswith((HERE, "<")) and "site-packages" not in file and not file.startswith(STANDARD)


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
            return kind(**fields.decode({name: value for name, value in data.items() if name != "kind"}))
    raise WrongShape("not an outcome")
