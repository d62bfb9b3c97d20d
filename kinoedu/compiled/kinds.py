"""The kinds of a call's arguments. Machine code serves all calls with the same kinds.

A kind says of a value what its numba type says, but is found without importing numba: "f8" for a
float, (dtype, dimensions, layout, writable) for an array, (class, kinds) for a tuple or a record.
"""

from typing import Any

import numpy as np

Kind = Any  # hashable, and can be pickled
SCALARS: dict[type, str] = {bool: "b1", float: "f8", np.float64: "f8", np.int64: "i8"}
SMALLEST, LARGEST = -(2**63), 2**63 - 1
RNG, NONE = "rng", "none"


class UnsupportedValue(TypeError):
    """The value has a type for which no machine code can be made."""


def kinds_of(values: tuple[object, ...]) -> tuple[Kind, ...] | None:
    """The kinds of some values, or None if one of them has no kind.

    Examples
    --------
    >>> kinds_of((1.5, 2, True))
    ('f8', 'i8', 'b1')
    >>> kinds_of((object(),)) is None
    True
    """
    try:
        return tuple([kind_of(value) for value in values])
    except UnsupportedValue:
        return None


def kind_of(value: Any) -> Kind:
    """The kind of a value.

    Raises
    ------
    UnsupportedValue
        Where no machine code can be made for the value.
    """
    cls = type(value)
    if cls is np.ndarray:
        return kind_of_array(value)
    if cls in SCALARS:
        return SCALARS[cls]
    if cls is int:
        if SMALLEST <= value <= LARGEST:
            return "i8"
    elif isinstance(value, tuple) and (cls is tuple or hasattr(cls, "_fields")):
        return cls, tuple([kind_of(field) for field in value])
    elif isinstance(value, np.random.Generator):
        return RNG
    elif isinstance(value, np.generic) and value.dtype.kind in "biuf":
        return value.dtype.str[1:]
    elif value is None:
        return NONE
    raise UnsupportedValue(cls.__name__)


def kind_of_array(array: "np.ndarray[Any, Any]") -> Kind:
    """The kind of an array: dtype, dimensions, layout ("A" for any), whether it is writable."""
    flags, dtype = array.flags, array.dtype
    if dtype.kind not in "biuf" or not dtype.isnative:
        raise UnsupportedValue(str(dtype))
    layout = "C" if flags.c_contiguous else "F" if flags.f_contiguous else "A"
    return dtype.str[1:], array.ndim, layout, flags.writeable


def record_classes(kind: Kind) -> set[type]:
    """The classes of the records in a kind."""
    if not is_tuple_kind(kind):
        return set()
    inner = set[type]().union(*map(record_classes, kind[1]))
    return inner if kind[0] is tuple else inner | {kind[0]}


def is_tuple_kind(kind: Kind) -> bool:
    """Whether a kind is that of a tuple or a record."""
    return isinstance(kind, tuple) and isinstance(kind[0], type)


def spell_kind(kind: Kind) -> str:
    """A kind as text, the same in every process.

    Examples
    --------
    >>> spell_kind(kind_of((1.0, np.zeros((2, 2)))))
    'tuple(f8, f8:2:C:w)'
    """
    if is_tuple_kind(kind):
        name = "tuple" if kind[0] is tuple else f"{kind[0].__module__}.{kind[0].__qualname__}"
        return f"{name}({', '.join(map(spell_kind, kind[1]))})"
    if isinstance(kind, tuple):
        dtype, dimensions, layout, writable = kind
        return f"{dtype}:{dimensions}:{layout}:{'w' if writable else 'r'}"
    return str(kind)
