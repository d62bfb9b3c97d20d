"""Digests of everything that a run's outcome depends on, to find outcomes of earlier runs."""

import hashlib
import inspect
import sys
from collections.abc import Iterator
from dataclasses import is_dataclass
from functools import cache, partial
from pathlib import Path
from types import CodeType
from typing import Any

import numpy as np

from ..compiled.store import source_digest
from ..errors import InvalidParameter
from ..support.own_code import check_unchanged, codes_in, own_file, sources_of
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
        for item in (*value, *own_sources(type(value))):
            yield from encode_parts(item)
    elif is_dataclass(value) and not isinstance(value, type):
        yield from encode_parts((name_of_kind(value), vars(value), *own_sources(type(value))))
    elif isinstance(value, dict):
        yield from encode_parts(("dict", *sorted(value.items(), key=repr)))
    elif isinstance(value, partial):
        yield from encode_parts(("partial", value.func, value.args, value.keywords))
    elif inspect.ismethod(value):
        yield from encode_parts(("method", value.__func__, value.__self__))
    elif inspect.isfunction(value):
        about = ("function", value.__module__, value.__qualname__)
        yield from encode_parts((*about, *function_parts(value)))
    elif inspect.isbuiltin(value):
        yield from encode_parts(("builtin", str(value.__module__), value.__qualname__))
    elif hasattr(value, "py_func"):  # a function that numba compiles
        yield from encode_parts(("compiled", value.py_func))
    elif callable(value) and not isinstance(value, type):
        yield from encode_parts((name_of_kind(value), vars(value), *own_sources(type(value))))
    else:
        raise InvalidParameter(
            "an experiment takes functions, records, arrays, numbers and words, got "
            f"{shortened(value)}"
        )


def name_of_kind(value: object) -> tuple[str, str]:
    """The module and the name of a value's class."""
    return type(value).__module__, type(value).__qualname__


def is_ours(module: str) -> bool:
    """Whether a module is of this package, whose sources `version` covers."""
    return module.partition(".")[0] == PACKAGE.name


def own_sources(kind: type) -> tuple[Any, ...]:
    """The sources that a reader's own class depends on; () for other classes.

    Raises
    ------
    InvalidParameter
        Where a file has changed since it was imported.
    """
    module = sys.modules.get(kind.__module__)
    if module is None or is_ours(kind.__module__):
        return ()
    if own_file(module.__name__) is None:
        return tuple(source_parts(kind)) if kind.__module__ == "__main__" else ()
    check_unchanged(module)
    return (sources_of(module),)


def function_parts(function: Any) -> tuple[Any, ...]:
    """All that the result of a user's function depends on; () for the package's own.

    These are the sources of its module and of those that this imports, or the sources of all that
    it uses where it has no file, as in a notebook; and what it captures.
    """
    module = sys.modules.get(function.__module__)
    if is_ours(function.__module__):
        return ()
    cells = function.__closure__ or ()
    held = [one.cell_contents for one in cells if one.cell_contents is not function]
    about = (held, function.__defaults__, function.__kwdefaults__)
    if module is not None and own_file(module.__name__) is not None:
        check_unchanged(module)
        return (sources_of(module), *source_parts(function), *about)
    return (used_parts(function, set()), *about)


def source_parts(thing: Any) -> list[Any]:
    """The source of a function or a class; where there is none, what its code consists of."""
    try:
        return [inspect.getsource(thing)]
    except (OSError, TypeError):
        codes = [thing] if inspect.isfunction(thing) else vars(thing).values()
        return [parts_of_code(one.__code__) for one in codes if inspect.isfunction(one)]


def parts_of_code(code: CodeType) -> list[Any]:
    """The instructions, names and constants of compiled Python."""
    constants = [parts_of_code(c) if isinstance(c, CodeType) else repr(c) for c in code.co_consts]
    return [code.co_code, list(code.co_names), constants]


def used_parts(function: Any, seen: set[int]) -> list[Any]:
    """The source of a function without a file, and of the global names that it uses."""
    seen.add(id(function))
    parts: list[Any] = source_parts(function)
    names = {name for code in codes_in(function.__code__) for name in code.co_names}
    for name in sorted(names & function.__globals__.keys()):
        thing = function.__globals__[name]
        kind = getattr(thing, "__module__", None)
        if id(thing) in seen:
            continue
        if inspect.ismodule(thing):
            parts += [name, thing.__name__, sources_of(thing)]
        elif inspect.isfunction(thing) and kind == function.__module__:
            parts += [name, used_parts(thing, seen), thing.__defaults__, thing.__kwdefaults__]
        elif isinstance(thing, type) and kind == function.__module__:
            parts += [name, *source_parts(thing)]
        else:
            parts += [name, encoded_or_repr(thing)]
    return parts


def encoded_or_repr(thing: object) -> str:
    """A digest of a value; where it has none, its repr, whose address is never the same again."""
    try:
        return digest(thing)
    except InvalidParameter:
        return repr(thing)
