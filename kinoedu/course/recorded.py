"""Arguments and results of functions as JSON: results exactly, arguments as short keys."""

import builtins
import functools
import hashlib
import json
import marshal
from dataclasses import fields, is_dataclass
from importlib import import_module
from typing import Any

import numpy as np

from .. import errors
from ..problems import ProblemRecord
from ..support.json_fields import Json
from .tasks import StudentProblem, scene_of

DIGITS = 9  # of a number in a key: another processor may round the last digits differently
BITS = 30  # of a number of an array in a key, about as many
NEGLIGIBLE = 1e-13  # of an array's largest number: what is smaller is rounding
PLAIN = {type(None), bool, int, float, str}  # types of values that are JSON as they are


def encode(value: Any) -> Json:
    """Encode a value exactly: numbers, text, arrays, problems, and what is made of them.

    Raises
    ------
    TypeError
        Where the value is of another kind.

    Examples
    --------
    >>> encode((1.5, [None, np.array([2, 3])]))
    {'tuple': [1.5, [None, {'array': ['<i8', [2], [2, 3]]}]], 'kind': ''}
    """
    kind = type(value)
    if kind in PLAIN:
        return value
    if isinstance(value, np.generic):
        return encode(value.item())
    if isinstance(value, int | float | str):  # of a class of its own
        return value
    if isinstance(value, list):
        return [encode(one) for one in value]
    if isinstance(value, dict):
        return {"dict": [[encode(key), encode(one)] for key, one in value.items()]}
    if isinstance(value, np.ndarray):
        return {"array": [value.dtype.str, list(value.shape), value.ravel().tolist()]}
    if isinstance(value, StudentProblem | ProblemRecord):
        scene = scene_of(value.problem if isinstance(value, StudentProblem) else value)
        return {"problem": encode(scene), "kind": type(value).__name__}
    if isinstance(value, np.random.Generator):
        return {"generator": encode(value.bit_generator.state)}
    if is_dataclass(kind):
        value = tuple(getattr(value, field.name) for field in fields(kind))
    if isinstance(value, tuple):
        name = "" if kind is tuple else f"{kind.__module__}:{kind.__qualname__}"
        return {"tuple": [encode(one) for one in value], "kind": name}
    raise TypeError(f"a withheld function can neither take nor return a {type(value).__name__}")


def to_bits(data: Json) -> bytes:
    """The bits of encoded data, which are the same for identical data, NaN included.

    >>> to_bits([float("nan"), 1.0]) == to_bits([float("nan"), 1.0]), to_bits(0.0) == to_bits(-0.0)
    (True, False)
    """
    return marshal.dumps(data, 2)  # in version 2 equal data look equal


def decode(data: Json) -> Any:
    """Decode what `encode` has made of a result; problems and generators are no results.

    >>> decode(encode({"path": (np.eye(2), None)}))
    {'path': (array([[1., 0.],
           [0., 1.]]), None)}
    """
    if isinstance(data, list):
        return [decode(one) for one in data]
    if not isinstance(data, dict):
        return data
    if "array" in data:
        kind, shape, numbers = data["array"]
        return np.array(numbers, kind).reshape(shape)
    if "dict" in data:
        return {decode(key): decode(one) for key, one in data["dict"]}
    items = tuple(decode(one) for one in data["tuple"])
    return named(data["kind"])(*items) if data["kind"] else items


def named(name: str) -> Any:
    """The class with a name such as "kinoedu.problems.plan:Tree"."""
    module, _, kind = name.partition(":")
    return getattr(import_module(module), kind)


def encode_error(error: Exception) -> Json:
    """Encode an error by its message and its class, the nearest one of kinoedu or of Python."""
    known = (errors.__name__, builtins.__name__)
    kind = next(base for base in type(error).__mro__ if base.__module__ in known)
    return {"error": kind.__name__, "message": str(error)}


def decode_error(data: Json) -> Exception:
    """Decode an error of kinoedu or of Python."""
    kind = getattr(errors, data["error"], None) or getattr(builtins, data["error"])
    return kind(data["message"])


def key_of(given: Any) -> str:
    """A short key of arguments; arguments that differ only by rounding have the same key.

    >>> key_of((0.1 + 0.2, np.array([1.0, 6e-17]))) == key_of((0.3, np.array([1.0, 0.0])))
    True
    >>> key_of((1e-12,)) == key_of((0.0,))
    False
    """
    return key_of_bits(to_bits(encode(given)))


@functools.lru_cache(maxsize=1)  # misconceptions are asked about the same case, one after the other
def key_of_bits(bits: bytes) -> str:
    """`key_of` for the bits of encoded arguments."""
    text = json.dumps(rounded(marshal.loads(bits)), separators=(",", ":"))
    return hashlib.sha256(text.encode()).hexdigest()[:12]


def rounded(data: Json) -> Json:
    """Encoded data with numbers of a few digits."""
    if isinstance(data, float):
        return f"{data + 0.0:.{DIGITS}g}"
    if isinstance(data, list):
        return [rounded(one) for one in data]
    if not isinstance(data, dict):
        return data
    if "array" in data:
        kind, shape, numbers = data["array"]
        return [kind, shape, rounded_numbers(np.array(numbers, kind)).tobytes().hex()]
    return {name: rounded(one) for name, one in data.items()}


def rounded_numbers(numbers: np.ndarray) -> np.ndarray:
    """Numbers of an array with few binary digits; negligible ones are 0.

    >>> rounded_numbers(np.array([1.0, 0.1 + 0.2, 1e-17])) == rounded_numbers(np.array([1, 0.3, 0]))
    array([ True,  True,  True])
    """
    if numbers.dtype.kind != "f":
        return numbers
    sizes = np.abs(numbers)
    largest = sizes.max(initial=0.0, where=np.isfinite(sizes))
    mantissas, exponents = np.frexp(np.where(sizes < NEGLIGIBLE * largest, 0.0, numbers))
    return np.ldexp(np.rint(np.ldexp(mantissas, BITS)), exponents - BITS) + 0.0  # and no -0.0
