"""A digest of all that a run's outcome depends on: what was run before is found again by it."""

import hashlib
import inspect
from collections.abc import Iterator
from functools import cache, partial
from pathlib import Path
from typing import Any

import numpy as np

from ..compiled.store import source_digest
from ..errors import InvalidParameter
from ..support.text import shortened

PACKAGE = Path(__file__).parent.parent


@cache
def version() -> str:
    """This kinoedu, by its sources: a changed planner may plan otherwise."""
    return source_digest(PACKAGE)


def digest(value: Any) -> str:
    """32 hexadecimal digits; equal for equal values, whatever process or computer asks. Raises
    InvalidParameter.

    >>> digest({"step": 2.0}) == digest({"step": 2.0}), digest({"step": 2.0}) == digest({"step": 2})
    (True, False)
    """
    told = hashlib.sha256()
    for part in spelled(value):
        told.update(f"{len(part)} ".encode() + part)
    return told.hexdigest()[:32]


def spelled(value: Any) -> Iterator[bytes]:
    """A value's parts as bytes, types and lengths among them."""
    if value is None or isinstance(value, bool | int | float | str | bytes | np.generic):
        yield f"{type(value).__name__} {value!r}".encode("utf-8", "surrogatepass")
    elif isinstance(value, np.ndarray) and not value.dtype.hasobject:
        yield f"array {value.dtype.str} {value.shape}".encode()
        yield np.ascontiguousarray(value).tobytes()
    elif isinstance(value, tuple | list):
        yield f"{type(value).__module__}.{type(value).__qualname__} {len(value)}".encode()
        for item in value:
            yield from spelled(item)
    elif isinstance(value, dict):
        yield from spelled(("dict", *sorted(value.items(), key=repr)))
    elif isinstance(value, partial):
        yield from spelled(("partial", value.func, value.args, value.keywords))
    elif inspect.isfunction(value):
        yield from spelled(("function", value.__module__, value.__qualname__, *own_source(value)))
    else:
        raise InvalidParameter(
            "an experiment takes functions, records, arrays, numbers and words, got "
            f"{shortened(value)}"
        )


def own_source(function: Any) -> tuple[Any, ...]:
    """A reader's function by its lines and what it holds from outside; the package's own are told
    by its version.
    """
    if function.__module__.partition(".")[0] == PACKAGE.name:
        return ()
    held = [cell.cell_contents for cell in function.__closure__ or ()]
    try:
        return inspect.getsource(function), held, function.__defaults__, function.__kwdefaults__
    except OSError:
        return function.__code__.co_code, held, function.__defaults__, function.__kwdefaults__
