"""How large an answer is, so that judging it takes bounded time."""

from ..messages import get_message
from .outcomes import Answer, Misshapen, Outcome
from .shapes import Value

MOST_NUMBERS = 10_000  # in the answer to an exercise that declares no other limit
MOST_OF_EXAMPLE = 400  # numbers in an example that a student makes up


def count_numbers(value: Value) -> int:
    """The numbers, texts and truth values in an answer.

    >>> count_numbers(([[1, 2], [3]], None, {"a": 5}))
    5
    """
    if isinstance(value, dict):
        return sum(map(count_numbers, value.values()))
    if isinstance(value, list | tuple):
        return sum(map(count_numbers, value))
    return int(getattr(value, "size", 1))


def count_rows(value: Value) -> int:
    """The length of the longest list or array in an answer.

    >>> count_rows(([(1, 2), (3, 4), (5, 6)], [7]))
    3
    """
    if isinstance(value, tuple):
        return max(map(count_rows, value), default=0)
    if isinstance(value, list):
        return max(len(value), *map(count_rows, value), 0)
    shape = getattr(value, "shape", ())
    return int(shape[0]) if shape else 0


def refuse_excess(outcome: Outcome, size: int, most: int, message: str) -> Outcome:
    """The outcome, or an answer of the wrong shape, with a message, where it is too large."""
    if not isinstance(outcome, Answer) or size <= most:
        return outcome
    return Misshapen(get_message(message, most=f"{most:,}", came=f"{size:,}"))
