"""Digests of everything that a run's outcome depends on, to find outcomes of earlier runs."""

import hashlib
import inspect
import sys
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import is_dataclass
from functools import cache, partial
from pathlib import Path
from types import CodeType
from typing import Any

import numpy as np

from ..compiled.choices import GENERICS
from ..compiled.store import source_digest
from ..errors import InvalidParameter
from ..support.own_code import check_unchanged, codes_in, own_file, sources_of
from ..support.text import shortened

PACKAGE = Path(__file__).parent.parent
Seen = dict[int, int]  # functions and classes by identity, numbered in their order


@cache
def version() -> str:
    """Digest of kinoedu's sources, since a changed planner may plan differently."""
    return source_digest(PACKAGE)


def digest(value: object, seen: Seen | None = None) -> str:
    """32 hexadecimal digits, equal for equal values in every process and on every computer.

    Parameters
    ----------
    seen : the functions and classes that the digest contains already; by default none.

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
    for part in encode_parts(value, {} if seen is None else seen):
        hasher.update(f"{len(part)} ".encode() + part)
    return hasher.hexdigest()[:32]


def encode_parts(value: object, seen: Seen) -> Iterator[bytes]:
    """Parts of a value as bytes, with types and lengths."""
    if value is None or isinstance(value, bool | int | float | str | bytes | np.generic):
        yield f"{type(value).__name__} {value!r}".encode("utf-8", "surrogatepass")
    elif isinstance(value, np.ndarray) and not value.dtype.hasobject:
        yield f"array {value.dtype.str} {value.shape}".encode()
        yield np.ascontiguousarray(value).tobytes()
    elif isinstance(value, tuple | list):
        yield f"{type(value).__module__}.{type(value).__qualname__} {len(value)}".encode()
        for item in (*value, *own_sources(type(value), seen)):
            yield from encode_parts(item, seen)
    elif is_dataclass(value) and not isinstance(value, type):
        yield from encode_parts(
            (name_of_kind(value), vars(value), *own_sources(type(value), seen)), seen
        )
    elif isinstance(value, dict):
        yield from encode_parts(("dict", *sorted(value.items(), key=repr)), seen)
    elif isinstance(value, partial):
        yield from encode_parts(("partial", value.func, value.args, value.keywords), seen)
    elif inspect.ismethod(value):
        yield from encode_parts(("method", value.__func__, value.__self__), seen)
    elif inspect.isfunction(value):
        about = ("function", value.__module__, value.__qualname__)
        yield from encode_parts((*about, *function_parts(value, seen)), seen)
    elif inspect.isbuiltin(value):
        yield from encode_parts(("builtin", str(value.__module__), value.__qualname__), seen)
    elif hasattr(value, "py_func"):  # a function that numba compiles
        yield from encode_parts(("compiled", value.py_func), seen)
    elif callable(value) and not isinstance(value, type):
        yield from encode_parts(
            (name_of_kind(value), vars(value), *own_sources(type(value), seen)), seen
        )
    else:
        raise InvalidParameter(
            "an experiment takes functions, records, arrays, numbers and words, got "
            f"{shortened(value)}"
        )


def name_of_kind(value: object) -> tuple[str, str]:
    """The module and the name of a value's class."""
    return name_of_class(type(value))


def name_of_class(kind: type) -> tuple[str, str]:
    """The module and the name of a class."""
    return kind.__module__, kind.__qualname__


def is_ours(module: str) -> bool:
    """Whether a module is of this package, whose sources `version` covers."""
    return module.partition(".")[0] == PACKAGE.name


def own_sources(kind: type, seen: Seen) -> tuple[Any, ...]:
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
        return used_parts(kind, seen) if kind.__module__ == "__main__" else ()
    check_unchanged(module)
    return (sources_of(module),)


def function_parts(function: Any, seen: Seen) -> tuple[Any, ...]:
    """All that the result of a user's function depends on; () for others.

    These are the sources of its module and of those that this imports, or the sources of all that
    it uses where it has no file, as in a notebook; and what it captures.
    """
    module = sys.modules.get(function.__module__)
    if is_ours(function.__module__):
        return ()
    if module is None or own_file(module.__name__) is None:
        is_installed = function.__module__ != "__main__" and hasattr(module, "__file__")
        return () if is_installed else used_parts(function, seen)
    check_unchanged(module)
    held = [thing for _, thing in captured(function) if thing is not function]
    about = (held, function.__defaults__, function.__kwdefaults__)
    return (sources_of(module), *source_parts(function), *about)


def captured(function: Any) -> Iterator[tuple[str, Any]]:
    """The names that a function captures from the functions around it, with what they hold."""
    for name, cell in zip(function.__code__.co_freevars, function.__closure__ or ()):
        with suppress(ValueError):  # nothing yet
            yield name, cell.cell_contents


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


def used_parts(thing: Any, seen: Seen) -> tuple[Any, ...]:
    """The source of a function or a class without a file, and of all that it uses."""
    if id(thing) in seen:
        return ("seen", seen[id(thing)])
    seen[id(thing)] = len(seen)
    parts: list[Any] = source_parts(thing)
    for name, used in class_uses(thing) if isinstance(thing, type) else function_uses(thing):
        if inspect.ismodule(used):
            parts += [name, used.__name__, sources_of(used)]
        elif isinstance(used, type):
            parts += [name, *name_of_class(used), *own_sources(used, seen)]
        else:
            parts += [name, digest_or_repr(used, seen)]
    return tuple(parts)


def function_uses(function: Any) -> Iterator[tuple[str, Any]]:
    """The names that a function uses, with what they stand for: captured, default or global."""
    yield from captured(function)
    yield "defaults", [function.__defaults__, function.__kwdefaults__]
    names = {name for code in codes_in(function.__code__) for name in code.co_names}
    for name in sorted(names & function.__globals__.keys()):
        yield name, function.__globals__[name]


def class_uses(kind: type) -> Iterator[tuple[str, Any]]:
    """The bases and the own members of a class, and its motions if it is a robot or a world."""
    for base in kind.__bases__:
        yield "base", base
    for name, member in vars(kind).items():
        thing = getattr(member, "__func__", getattr(member, "fget", member))  # of a method
        is_own = getattr(thing, "__module__", None) == kind.__module__
        if is_own or not (name.startswith("_") or hasattr(thing, "__get__")):
            yield name, thing
    for generic, _, _ in GENERICS:
        for kinds, function in generic.implementations.items():
            if kind in kinds:
                yield function.__name__, function


def digest_or_repr(thing: object, seen: Seen) -> str:
    """A digest of a value; where it has none, its repr, whose address is never the same again."""
    within = dict(seen)
    try:
        found = digest(thing, within)
    except InvalidParameter:
        return repr(thing)
    seen.update(within)
    return found
