"""The outcome of one call of a student's function, and its encoding as JSON.

An outcome is an answer of the declared shape, an answer of another shape, an exception, a change of
the arguments, or no answer in time. Nothing else leaves the process that runs student code.
"""

import linecache
import traceback
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from ..messages import get_message
from ..support.json_fields import JsonObject
from ..support.time_limit import Limiter, SeenLines, TimeUp, run_within_processor_time
from .exceptions import MAX_LINES, MAX_NAMES, describe_exception
from .plain import WrongShape, wrong_shape
from .shapes import Listed, Record, Shape, Text, Truth, Value

HERE = Path(__file__).resolve().parent.parent  # the package
STANDARD = Path(traceback.__file__).resolve().parent  # Python's own library
MAX_SEEN = 6  # lines in which a program was late


class Answer(NamedTuple):
    """The function returned a value of the declared shape."""

    value: Value


class Misshapen(NamedTuple):
    """The function returned another shape; `message` says what was expected and what came."""

    message: str


class Changed(NamedTuple):
    """The function changed arguments in place; `names` lists them."""

    names: list[str]


class Raised(NamedTuple):
    """The function raised an exception.

    Attributes
    ----------
    kinds : names of the exception's class and its base classes.
    message : its message.
    lines : the student's lines in the traceback.
    function : name of the student's function that raised it.
    """

    kinds: list[str]
    message: str
    lines: list[str]
    function: str

    @property
    def is_unwritten(self) -> bool:
        """Whether the exception says that a function is not written yet."""
        return self.kinds[:1] == ["NotImplementedError"]


class Late(NamedTuple):
    """The function did not end within its time limit.

    Attributes
    ----------
    left_running : whether it could not be stopped.
    used, allowed : seconds of processor time; `allowed` is 0 where it is unknown.
    passed : seconds of wall time.
    lines : a few of the student's lines, where the program stayed in them for a long time.
    """

    left_running: bool
    used: float = 0.0
    allowed: float = 0.0
    passed: float = 0.0
    lines: Sequence[str] = ()


class Seconds(NamedTuple):
    """The shape of a duration: a float from 0 to 1,000,000 seconds."""

    @property
    def description(self) -> str:
        """Description of the shape, for messages."""
        return get_message("shape.seconds")

    def encode(self, value: object) -> float:
        """Check the float. Raises WrongShape."""
        return self.decode(value)

    def decode(self, data: object) -> float:
        """Check the float. Raises WrongShape."""
        if type(data) is not float or not 0.0 <= data <= MOST_SECONDS:
            raise wrong_shape(self.description, data)
        return data


class Elsewhere(BaseException):
    """A call went to another process, and ended there with an outcome that is no answer."""

    def __init__(self, outcome: "Outcome") -> None:
        super().__init__()
        self.outcome = outcome


MOST_SECONDS = 1e6
Outcome = Answer | Misshapen | Changed | Raised | Late
SHAPES: dict[type, Record] = {
    Misshapen: Record(message=Text()),
    Changed: Record(names=Listed(Text(), MAX_NAMES)),
    Raised: Record(
        kinds=Listed(Text(), MAX_NAMES),
        message=Text(),
        lines=Listed(Text(), MAX_LINES),
        function=Text(),
    ),
    Late: Record(
        left_running=Truth(),
        used=Seconds(),
        allowed=Seconds(),
        passed=Seconds(),
        lines=Listed(Text(), MAX_SEEN),
    ),
}


def outcome_of(
    call: Callable[[], Any],
    shape: Shape,
    seconds: float,
    bounded: Limiter = run_within_processor_time,
) -> Outcome:
    """Run a call within a time limit, and copy its result into plain data of its shape.

    Returns
    -------
    Outcome
    """

    def answered() -> Outcome:
        try:
            return Answer(shape.decode(shape.encode(call())))
        except TimeUp:
            raise
        except Elsewhere as ended:
            return ended.outcome
        except WrongShape as misfit:
            return Misshapen(str(misfit))
        # anything that a program raises is an outcome; even its message may run student code
        except BaseException as error:
            return raised_outcome(error)

    getattr(shape, "load", lambda: None)()  # before the clock of the student's program starts
    try:
        return bounded(seconds, answered)
    except TimeUp as over:
        return late_outcome(over)


def late_outcome(over: TimeUp) -> Late:
    """Plain data of a time-out."""
    used, allowed, passed = (
        float(min(seconds, MOST_SECONDS)) for seconds in (over.used, over.allowed, over.passed)
    )
    lines = [] if over.seen is None else seen_lines(over.seen)
    return Late(over.left_running, used, allowed, passed, lines)


def seen_lines(seen: SeenLines) -> list[str]:
    """The student's lines in which a program was seen all the time, as "line 3: while True:"."""
    if not is_students(seen.file):
        return []
    numbers = range(seen.first, seen.last + 1)
    lines = [(number, linecache.getline(seen.file, number).strip()) for number in numbers]
    return [f"line {number}: {line}" for number, line in lines if line][:MAX_SEEN]


def raised_outcome(error: BaseException) -> Raised:
    """Plain data of an exception."""
    return Raised(*describe_exception(error, is_students))


def is_students(file: str) -> bool:
    """Whether a file belongs neither to kinoedu nor to an installed library."""
    return (
        not file.startswith("<")
        and "site-packages" not in file
        and {HERE, STANDARD}.isdisjoint(Path(file).parents)
    )


def encode_outcome(outcome: Outcome, shape: Shape) -> JsonObject:
    """Encode an outcome as JSON data: its kind and its fields."""
    if isinstance(outcome, Answer):
        return {"kind": "Answer", "value": shape.encode(outcome.value)}
    return {"kind": type(outcome).__name__, **SHAPES[type(outcome)].encode(outcome._asdict())}


def decode_outcome(data: object, shape: Shape) -> Outcome:
    """Decode an outcome from JSON data.

    Raises
    ------
    WrongShape
        Where the data are not an outcome.
    """
    if isinstance(data, dict) and data.get("kind") == "Answer" and set(data) == {"kind", "value"}:
        return Answer(shape.decode(data["value"]))
    for kind, fields in SHAPES.items():
        if isinstance(data, dict) and data.get("kind") == kind.__name__:
            return kind(
                **fields.decode({name: value for name, value in data.items() if name != "kind"})
            )
    raise WrongShape("not an outcome")
