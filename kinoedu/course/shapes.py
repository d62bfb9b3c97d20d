"""Shapes that cases and answers have, and how they travel as JSON.

A shape turns a value into plain JSON data (`encode`) and back (`decode`), and refuses what does not
fit it with WrongShape, whose message a student can read. So a case can go to another process and
its answer come back, and nothing but numbers, words and truth values ever passes: what a student's
program returns is copied into such data before anybody looks at it.

Numbers that JSON has no word for travel as "nan", "inf" and "-inf"; every float comes back as it
was, to the last bit.
"""

from collections.abc import Mapping
from typing import Any, NamedTuple, Protocol

import numpy as np

from ..words import say
from .plain import nested, numeric, read_number, spelled, unnested, wrong


class Shape(Protocol):
    """What `encode` and `decode` promise; `words` says in a student's words what the shape is."""

    @property
    def words(self) -> str: ...

    def encode(self, value: Any) -> Any: ...

    def decode(self, data: Any) -> Any: ...


class Number(NamedTuple):
    """One number, as a float.

    >>> Number().encode(float("inf")), Number().decode("inf"), Number().encode(np.int64(3))
    ('inf', inf, 3.0)
    """

    @property
    def words(self) -> str:
        """In words."""
        return say("shape.number")

    def encode(self, value: Any) -> float | str:
        """A float, an int or numpy's, also as an array of no dimensions."""
        return spelled(float(numeric(value, (), self)))

    def decode(self, data: Any) -> float:
        """The float."""
        return read_number(data, self)


class Numbers(NamedTuple):
    """An array of numbers. A dimension given by a letter may have any length; the same letter, the
    same length.

    >>> Numbers((2,)).decode([1.0, "nan"])
    array([ 1., nan])
    >>> Numbers(("n", 2)).encode([(0, 0), (4, 0), (4, 3)])
    [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0]]
    >>> Numbers(("n", 2)).encode(np.array([]))
    []
    """

    dimensions: tuple[int | str, ...]

    @property
    def words(self) -> str:
        """In words."""
        return say("shape.numbers", dimensions=str(self.dimensions).replace("'", ""))

    def encode(self, value: Any) -> Any:
        """An array, or lists and tuples that make one."""
        array = numeric(value, self.dimensions, self)
        return array.tolist() if np.isfinite(array).all() else nested(array.tolist())

    def decode(self, data: Any) -> np.ndarray:
        """The array, float64."""
        return numeric(unnested(data, self, len(self.dimensions)), self.dimensions, self)


class Truth(NamedTuple):
    """True or False."""

    @property
    def words(self) -> str:
        """In words."""
        return say("shape.truth")

    def encode(self, value: Any) -> bool:
        """Python's or numpy's."""
        if type(value) is not bool and type(value) is not np.bool_:
            raise wrong(self.words, value)
        return bool(value)

    def decode(self, data: Any) -> bool:
        """The same."""
        return self.encode(data)


class Text(NamedTuple):
    """Words, no longer than `most` characters."""

    most: int = 10_000

    @property
    def words(self) -> str:
        """In words."""
        return say("shape.text")

    def encode(self, value: Any) -> str:
        """A str, with what no file can hold replaced."""
        if type(value) is not str or len(value) > self.most:
            raise wrong(self.words, value)
        return value.encode("utf-8", "replace").decode("utf-8")

    def decode(self, data: Any) -> str:
        """The same."""
        return self.encode(data)


class Record:
    """Named values, each of its own shape; a dict on both sides.

    >>> Record(q=Numbers((2,)), r=Number()).encode({"q": (1, 2), "r": 3})
    {'q': [1.0, 2.0], 'r': 3.0}
    """

    def __init__(self, **fields: Shape) -> None:
        self.fields = fields

    def __repr__(self) -> str:
        return f"Record({', '.join(f'{name}={shape!r}' for name, shape in self.fields.items())})"

    @property
    def words(self) -> str:
        """In words."""
        return say("shape.record", names=", ".join(self.fields))

    def encode(self, value: Any) -> dict[str, Any]:
        """Each value by its shape."""
        return {name: shape.encode(self._named(value)[name]) for name, shape in self.fields.items()}

    def decode(self, data: Any) -> dict[str, Any]:
        """Each value by its shape."""
        return {name: shape.decode(self._named(data)[name]) for name, shape in self.fields.items()}

    def _named(self, value: Any) -> Mapping[str, Any]:
        if not isinstance(value, Mapping) or set(value) != set(self.fields):
            raise wrong(self.words, value)
        return value


class Listed(NamedTuple):
    """A list of values of one shape, at most so many."""

    row: Shape
    most: int = 100_000

    @property
    def words(self) -> str:
        """In words."""
        return say("shape.list", row=self.row.words)

    def encode(self, value: Any) -> list[Any]:
        """A list, a tuple or an array."""
        if not isinstance(value, list | tuple | np.ndarray) or len(value) > self.most:
            raise wrong(self.words, value)
        return [self.row.encode(item) for item in value]

    def decode(self, data: Any) -> list[Any]:
        """The list."""
        if not isinstance(data, list) or len(data) > self.most:
            raise wrong(self.words, data)
        return [self.row.decode(item) for item in data]


class Together(NamedTuple):
    """A tuple whose every place has a shape of its own, such as a point and a polygon.

    >>> Together((Numbers((2,)), Number())).encode(((1, 2), 3))
    [[1.0, 2.0], 3.0]
    >>> Together((Numbers((2,)), Numbers((2,)))).encode(np.eye(2))
    [[1.0, 0.0], [0.0, 1.0]]
    """

    places: tuple[Shape, ...]

    @property
    def words(self) -> str:
        """In words."""
        if len(set(self.places)) == 1:
            return say("shape.alike", number=len(self.places), shape=self.places[0].words)
        return say("shape.together", places=", ".join(shape.words for shape in self.places))

    def encode(self, value: Any) -> list[Any]:
        """A tuple or a list of that length, or an array of so many rows."""
        is_array = type(value) is np.ndarray and value.ndim > 0
        if not (isinstance(value, list | tuple) or is_array) or len(value) != len(self.places):
            raise wrong(self.words, value)
        return [shape.encode(item) for shape, item in zip(self.places, value, strict=True)]

    def decode(self, data: Any) -> tuple[Any, ...]:
        """The tuple."""
        if not isinstance(data, list) or len(data) != len(self.places):
            raise wrong(self.words, data)
        return tuple(shape.decode(item) for shape, item in zip(self.places, data, strict=True))


class Maybe(NamedTuple):
    """A value of a shape, or None."""

    shape: Shape

    @property
    def words(self) -> str:
        """In words."""
        return say("shape.maybe", shape=self.shape.words)

    def encode(self, value: Any) -> Any:
        """None stays None."""
        return None if value is None else self.shape.encode(value)

    def decode(self, data: Any) -> Any:
        """None stays None."""
        return None if data is None else self.shape.decode(data)
