"""Digests of everything that a run's outcome depends on, to find outcomes of earlier runs."""

import hashlib
import inspect
from collections.abc import Iterator
from dataclasses import is_dataclass
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
    """Digest of kinoedu's sources, since a changed planner may plan differently."""
    return source_digest(PACKAGE)


def digest(value: object) -> str:
    """32 hexadecimal digits, equal for equal values in every process and on every computer.

    Raises
    ------
    InvalidParameter
        Where the value contains an object of another kind.

    Examples
    --------
    >>> digest({"step": 2.0}) == digest({"step": 2.0}), digest({"step": 2.0}) == digest({"step": 2})
    (True, False)
    """
    hasher = hashlib.sha256()
    for part in encode_parts(value):
        hasher.update(f"{len(part)} ".encode() + part)
    return hasher.hexdigest()[:32]


def encode_parts(value: object) -> Iterator[bytes]:
    """Parts of a value as bytes, with types and lengths."""
    if value is None or isinstance(value, bool | int | float | str | bytes | np.generic):
        yield f"{type(value).__name__} {value!r}".encode("utf-8", "surrogatepass")
    elif isinstance(value, np.ndarray) and not value.dtype.hasobject:
        yield f"array {value.dtype.str} {value.shape}".encode()
        yield np.ascontiguousarray(value).tobytes()
    elif isinstance(value, tuple | list):
        yield f"{type(value).__module__}.{type(value).__qualname__} {len(value)}".encode()
        for item in value:
            yield from encode_parts(item)
    elif is_dataclass(value) and not isinstance(value, type):
        kind = type(value)
        yield from encode_parts((kind.__module__, kind.__qualname__, vars(value)))
    elif isinstance(value, dict):
        yield from encode_parts(("dict", *sorted(value.items(), key=repr)))
    elif isinstance(value, partial):
        yield from encode_parts(("partial", value.func, value.args, value.keywords))
    elif inspect.isfunction(value):
        yield from encode_parts(
            ("function", value.__module__, value.__qualname__, *own_source(value))
        )
    else:
        raise InvalidParameter(
            "an experiment takes functions, records, arrays, numbers and words, got "
            f"{shortened(value)}"
        )


def own_source(function: Any) -> tuple[Any, ...]:
    """Source of a user's function with its closure and defaults; () for the package's own.

    The package's own functions are covered by `version`.
    """
    if function.__module__.partition(".")[0] == PACKAGE.name:
        return ()
    held = [cell.cell_contents for cell in function.__closure__ or ()]
    try:
        return inspect.getsource(function), held, function.__defaults__, function.__kwdefaults__
    except OSError:
        return function.__code__.co_code, held, function.__defaults__, function.__kwdefaults__
