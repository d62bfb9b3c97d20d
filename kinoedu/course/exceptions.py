"""Exceptions of students' programs as plain data. Needs Python alone.

None of the program's own code is run, but for the exception's `__str__`.
"""

import linecache
import traceback
from collections.abc import Callable
from types import FrameType, TracebackType

MAX_NAMES = 32  # base classes of an exception, or changed arguments
MAX_LETTERS = 2000  # of its message
MAX_LINES = 5  # of the traceback
MAX_LINE = 300  # letters of each

Step = tuple[FrameType, int]


def describe_exception(
    error: BaseException, is_students: Callable[[str], bool]
) -> tuple[list[str], str, list[str], str]:
    """Kinds, message, lines and function of an exception; see `outcomes.Raised`.

    is_students : whether a file holds a student's program.
    """
    above = type.__dict__["__mro__"].__get__(type(error))
    # by identity: `in` would run a class's own comparison
    own_kinds = [kind for kind in above if kind is not object and kind is not BaseException]
    kinds = [class_name(kind) for kind in own_kinds[:MAX_NAMES]]
    own = own_steps(error.__traceback__, is_students)
    return kinds, message_of(error), lines_of(own), name_of(own)


def class_name(kind: type) -> str:
    """Name of a class, at most 100 characters, read without running the class's own code."""
    return str(type.__dict__["__name__"].__get__(kind))[:100]


def message_of(error: BaseException) -> str:
    """Message of an exception; "" where its own code fails."""
    try:
        return str(str(error))[:MAX_LETTERS]
    except BaseException:
        return ""


def own_steps(trace: TracebackType | None, is_students: Callable[[str], bool]) -> list[Step]:
    """Frames of the student's own functions in a traceback, outermost first, with line numbers."""
    return [
        (frame, number)
        for frame, number in traceback.walk_tb(trace)
        if is_students(frame.f_code.co_filename)
    ]


def name_of(steps: list[Step]) -> str:
    """The name of the innermost function; "" where there is none."""
    return steps[-1][0].f_code.co_name[:MAX_LINE] if steps else ""


def lines_of(steps: list[Step]) -> list[str]:
    """Lines of code as "line 3: return 1 / 0"; repeated lines of a recursion appear once."""
    lines = [
        f"line {number}: {linecache.getline(frame.f_code.co_filename, number).strip()[:MAX_LINE]}"
        for frame, number in steps
    ]
    return [
        line
        for line, after in zip(lines, [*lines[1:], ""])
        if line != after and not line.endswith(": ")
    ][-MAX_LINES:]
