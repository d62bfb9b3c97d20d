"""The variables of a running function: each as a short text, and as points if it is that."""

from collections import deque
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence, Sized
from itertools import islice
from types import CodeType, ModuleType
from typing import Any, NamedTuple

import numpy as np

from ...errors import InvalidParameter
from ...geometry.checks import Array
from ...problems import Recorder

MOST_POINTS = 500  # of a list; a longer one is not drawn
ENDS = 3  # items of a long list that are written
LETTERS = 200  # of a text, at most


class Variable(NamedTuple):
    """A variable after a line: its text, and its points (n, 2), or None where it has none.

    `pose` is (3,) where it has three coordinates, as a robot's configuration has.
    """

    text: str
    points: Array | None = None
    is_point: bool = False
    pose: Array | None = None


def note_variables(values: Mapping[str, Any]) -> dict[str, Variable]:
    """The variables that a reader wants to see: no functions, modules, problems or generators."""
    return {
        name: Variable(format_short(value), *find_points(value), find_pose(value))
        for name, value in values.items()
        if not name.startswith(("_", ".")) and not is_hidden(value)
    }


def find_pose(value: object) -> Array | None:
    """A value as a pose (x, y, theta), or None: an array of three floats."""
    fits = isinstance(value, np.ndarray) and value.shape == (3,) and value.dtype.kind == "f"
    return np.array(value, float) if fits else None


def is_hidden(value: object) -> bool:
    """Whether a value is a tool of the function, or a record of the library, which has no text."""
    tools = (ModuleType, type, Recorder, np.random.Generator)
    record = hasattr(value, "_fields") and type(value).__module__.partition(".")[0] == "kinoedu"
    return isinstance(value, tools) or record or callable(value) or hasattr(value, "is_free_path")


def find_points(value: object) -> tuple[Array | None, bool]:
    """The points (n, 2) that a value holds, or None; and whether it is a single point.

    Integers are no coordinates: they are numbers of nodes, or places in a grid.
    """
    if is_point(value):
        return np.array([value], float), True
    if isinstance(value, np.ndarray):
        fits = value.ndim == 2 and value.shape[1] == 2 and value.dtype.kind == "f"
        return (value.copy(), False) if fits and len(value) <= MOST_POINTS else (None, False)
    if isinstance(value, list) and 0 < len(value) <= MOST_POINTS and all(map(is_point, value)):
        return np.array(value, float), False
    return None, False


def is_point(value: object) -> bool:
    """Whether a value is a point of the plane: an array of two floats, or a tuple of two."""
    if isinstance(value, np.ndarray):
        return value.shape == (2,) and value.dtype.kind == "f"
    return isinstance(value, tuple) and len(value) == 2 and all(isinstance(x, float) for x in value)


def format_short(value: object) -> str:
    """A value on one short line; the name of its type where it cannot be written.

    >>> format_short(np.array([1.0, 1 / 3])), format_short([0, 1, 2, 3, 4, 5, 6, 7])
    ('(1, 0.3333)', '[0, 1, 2, ..., 7] (8)')
    >>> format_short({"a": (1, 2.5)}), format_short(np.ones((30, 2)))
    ('{a: (1, 2.5)}', '30 x 2 numbers')
    """
    try:
        text = write_value(value).replace("\n", r"\n")
    except Exception:  # too many digits, a list that holds itself, a fault in a reader's own class
        return type(value).__name__
    return text if len(text) <= LETTERS else f"{text[:LETTERS]}..."


def write_value(value: object) -> str:
    """A value as a text, the items of long lists left out."""
    if isinstance(value, bool | np.bool_ | str) or value is None:
        return str(value) or '""'
    if isinstance(value, int | np.integer):
        return str(int(value))
    if isinstance(value, float | np.floating):
        return f"{0.0 if value == 0 else float(value):.4g}"
    if isinstance(value, np.ndarray):
        if value.ndim == 0:
            return write_value(value.item())
        if value.ndim == 1 and len(value) <= 4:
            return f"({', '.join(map(write_value, value))})"
        return f"{' x '.join(map(str, value.shape))} numbers"
    if isinstance(value, dict):
        return join_items(value.items(), format_pair, "{}")
    if hasattr(value, "_fields"):
        return type(value).__name__
    if isinstance(value, tuple):
        return join_items(value, write_value, "()")
    if isinstance(value, Iterable) and isinstance(value, Sized) and not isinstance(value, Iterator):
        return join_items(value, write_value, "[]")
    return type(value).__name__  # to read an iterator would use it up, or never end


def format_pair(pair: tuple[object, object]) -> str:
    """A key and its value."""
    return ": ".join(map(write_value, pair))


def join_items(items: Any, write: Callable[[Any], str], brackets: str) -> str:
    """Items in brackets; of many only the first ones and the last, and how many there are."""
    count = len(items)
    if count <= 2 * ENDS:
        return f"{brackets[0]}{', '.join(map(write, items))}{brackets[1]}"
    last = items[-1] if isinstance(items, Sequence) else deque(items, maxlen=1).pop()
    written = [*map(write, islice(items, ENDS)), "...", write(last)]
    return f"{brackets[0]}{', '.join(written)}{brackets[1]} ({count})"


def compile_expressions(expressions: Mapping[str, str]) -> dict[str, CodeType]:
    """Expressions by name, compiled.

    Raises
    ------
    InvalidParameter
        Where one is not an expression of Python.
    """
    try:
        return {name: compile(text, name, "eval") for name, text in expressions.items()}
    except (SyntaxError, TypeError, ValueError) as error:
        raise InvalidParameter(
            f"points and radii must be expressions of Python: {error}"
        ) from error


def compute_radii(
    expressions: Mapping[str, CodeType], local: dict[str, Any], names: dict[str, Any]
) -> dict[str, float]:
    """The values of expressions that are numbers where a function is now."""
    found = evaluate(expressions, local, names)
    numbers = (int, float, np.integer, np.floating)
    return {name: float(value) for name, value in found.items() if isinstance(value, numbers)}


def evaluate(
    expressions: Mapping[str, CodeType], local: dict[str, Any], names: dict[str, Any]
) -> dict[str, Any]:
    """The values of expressions that have one where a function is now."""
    found, scope = {}, {**names, **local}  # one scope, which a lambda in an expression sees too
    for name, expression in expressions.items():
        try:
            found[name] = eval(expression, scope)
        except Exception:  # the variables that it needs have no values yet, or none that fit
            continue
    return found
