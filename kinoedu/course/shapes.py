"""Shapes of cases and answers, and their encoding as JSON.

A shape turns a value into plain JSON data (`encode`) and back (`decode`). A value that does not fit
raises WrongShape, with a message for students. So a case can be sent to another process and its
answer can be returned. Only numbers, text and truth values ever pass: the result of a student's
program is copied into such data before anything else uses it.

Numbers that JSON cannot represent are encoded as "nan", "inf" and "-inf". Every float is decoded to
the same bits.
"""

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple, Protocol

import numpy as np

from ..messages import get_message
from ..support.json_fields import JsonObject
from .plain import (
    WrongShape,
    as_array,
    decode_float,
    decode_floats,
    encode_float,
    encode_floats,
    wrong_shape,
)

Value = Any  # a value of a shape that an exercise declares


class Shape(Protocol):
    """Interface of all shapes; `description` is for students."""

    @property
    def description(self) -> str: ...

    def encode(self, value: Value) -> object: ...

    def decode(self, data: object) -> object: ...


class Number(NamedTuple):
    """One number, as a float.

    >>> Number().encode(float("inf")), Number().decode("inf"), Number().encode(np.int64(3))
    ('inf', inf, 3.0)
    """

    @property
    def description(self) -> str:
        """Description of the shape, for messages."""
        return get_message("shape.number")

    def encode(self, value: Value) -> float | str:
        """Encode a Python or numpy number, or an array without dimensions."""
        return encode_float(float(as_array(value, (), self)))

    def decode(self, data: object) -> float:
        """Decode a float."""
        return decode_float(data, self)


class Numbers(NamedTuple):
    """An array of numbers.

    A dimension given by a letter may have any length; the same letter stands for the same length.

    >>> Numbers((2,)).decode([1.0, "nan"])
    array([ 1., nan])
    >>> Numbers(("n", 2)).encode([(0, 0), (4, 0), (4, 3)])
    [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0]]
    >>> Numbers(("n", 2)).encode(np.array([]))
    []
    """

    dimensions: tuple[int | str, ...]

    @property
    def description(self) -> str:
        """Description of the shape, for messages."""
        return get_message("shape.numbers", dimensions=str(self.dimensions).replace("'", ""))

    def encode(self, value: Value) -> object:
        """Encode an array, or nested lists and tuples that make one."""
        array = as_array(value, self.dimensions, self)
        return array.tolist() if np.isfinite(array).all() else encode_floats(array.tolist())

    def decode(self, data: object) -> np.ndarray:
        """Decode a float64 array."""
        return as_array(decode_floats(data, self, len(self.dimensions)), self.dimensions, self)


class Truth(NamedTuple):
    """True or False."""

    @property
    def description(self) -> str:
        """Description of the shape, for messages."""
        return get_message("shape.truth")

    def encode(self, value: Value) -> bool:
        """Encode a Python or numpy truth value."""
        if type(value) is not bool and type(value) is not np.bool_:
            raise wrong_shape(self.description, value)
        return bool(value)

    def decode(self, data: object) -> bool:
        """Decode a truth value."""
        return self.encode(data)


class Text(NamedTuple):
    """Text of at most `most` characters."""

    most: int = 10_000

    @property
    def description(self) -> str:
        """Description of the shape, for messages."""
        return get_message("shape.text")

    def encode(self, value: Value) -> str:
        """Encode a str, with characters that UTF-8 cannot hold replaced."""
        if type(value) is not str or len(value) > self.most:
            raise wrong_shape(self.description, value)
        return value.encode("utf-8", "replace").decode("utf-8")

    def decode(self, data: object) -> str:
        """Decode a str."""
        return self.encode(data)


class Record:
    """Named values, each of its own shape; decoded as a dict.

    >>> Record(q=Numbers((2,)), r=Number()).encode({"q": (1, 2), "r": 3})
    {'q': [1.0, 2.0], 'r': 3.0}
    """

    def __init__(self, **fields: Shape) -> None:
        self.fields = fields

    def __repr__(self) -> str:
        return f"Record({', '.join(f'{name}={shape!r}' for name, shape in self.fields.items())})"

    @property
    def description(self) -> str:
        """Description of the shape, for messages."""
        return get_message("shape.record", names=", ".join(self.fields))

    def encode(self, value: Value) -> JsonObject:
        """Encode each value by its shape."""
        return {name: shape.encode(self._named(value)[name]) for name, shape in self.fields.items()}

    def decode(self, data: object) -> dict[str, Any]:
        """Decode each value by its shape."""
        return {name: shape.decode(self._named(data)[name]) for name, shape in self.fields.items()}

    def _named(self, value: object) -> Mapping[str, Any]:
        if not isinstance(value, Mapping) or set(value) != set(self.fields):
            raise wrong_shape(self.description, value)
        return value


def is_row(value: object) -> bool:
    """Whether a value has items in an order: a list, a tuple, a deque, an array and the like.

    >>> is_row(range(3)), is_row(np.zeros(3)), is_row(np.array(3.0)), is_row("abc")
    (True, True, False, False)
    """
    if isinstance(value, np.ndarray):
        return value.ndim > 0
    return isinstance(value, Sequence) and not isinstance(
        value, str | bytes | bytearray | memoryview
    )


def encode_place(message: str, place: int, shape: Shape, item: Value) -> Any:
    """Encode one of several values; where it does not fit, the error's message names its place."""
    try:
        return shape.encode(item)
    except WrongShape as error:
        raise WrongShape(get_message(message, place=place, wrong=str(error))) from None


class Listed(NamedTuple):
    """A list of at most `most` values of one shape."""

    row: Shape
    most: int = 100_000

    @property
    def description(self) -> str:
        """Description of the shape, for messages."""
        return get_message("shape.list", row=self.row.description)

    def encode(self, value: Value) -> list[Any]:
        """Encode a list, a tuple or an array."""
        if not is_row(value) or len(value) > self.most:
            raise wrong_shape(self.description, value)
        return [
            encode_place("shape.item", place, self.row, item) for place, item in enumerate(value)
        ]

    def decode(self, data: object) -> list[Any]:
        """Decode a list."""
        if not isinstance(data, list) or len(data) > self.most:
            raise wrong_shape(self.description, data)
        return [self.row.decode(item) for item in data]


class Together(NamedTuple):
    """A tuple in which each place has its own shape, such as a point and a polygon.

    >>> Together((Numbers((2,)), Number())).encode(((1, 2), 3))
    [[1.0, 2.0], 3.0]
    >>> Together((Numbers((2,)), Numbers((2,)))).encode(np.eye(2))
    [[1.0, 0.0], [0.0, 1.0]]
    """

    places: tuple[Shape, ...]
    is_returned: bool = True  # by one call of the student's function; else by several calls

    @property
    def description(self) -> str:
        """Description of the shape, for messages."""
        if len(set(self.places)) == 1:
            return get_message(
                "shape.alike", number=len(self.places), shape=self.places[0].description
            )
        return get_message(
            "shape.together",
            number=len(self.places),
            places="; ".join(shape.description for shape in self.places),
        )

    def encode(self, value: Value) -> list[Any]:
        """Encode a tuple or list of the right length, or an array with that many rows."""
        if not is_row(value) or len(value) != len(self.places):
            raise wrong_shape(self.description, value)
        pairs = zip(self.places, value, strict=True)
        if not self.is_returned:
            return [shape.encode(item) for shape, item in pairs]
        return [
            encode_place("shape.value", place, shape, item)
            for place, (shape, item) in enumerate(pairs, 1)
        ]

    def decode(self, data: object) -> tuple[Any, ...]:
        """Decode a tuple."""
        if not isinstance(data, list) or len(data) != len(self.places):
            raise wrong_shape(self.description, data)
        return tuple(shape.decode(item) for shape, item in zip(self.places, data, strict=True))


class Maybe(NamedTuple):
    """A value of a shape, or None."""

    shape: Shape

    @property
    def description(self) -> str:
        """Description of the shape, for messages."""
        return get_message("shape.maybe", shape=self.shape.description)

    def encode(self, value: Value) -> object:
        """Encode a value; None stays None."""
        return None if value is None else self.shape.encode(value)

    def decode(self, data: object) -> object:
        """Decode a value; None stays None."""
        return None if data is None else self.shape.decode(data)
