"""Shapes of whole numbers: how many, and which one."""

from typing import Any, NamedTuple

import numpy as np

from ..words import say
from .plain import numeric, unnested, wrong


class Whole(NamedTuple):
    """One whole number, such as the number of a node: Python's or numpy's; True, 1.0 and "1" are
    none.

    >>> Whole().encode(np.int64(3))
    3
    """

    @property
    def words(self) -> str:
        """In words."""
        return say("shape.whole")

    def encode(self, value: Any) -> int:
        """An int or numpy's, of at most fifteen digits."""
        if (
            not (type(value) is int or isinstance(value, np.integer))
            or not -(10**15) < value < 10**15
        ):
            raise wrong(self.words, value)
        return int(value)

    def decode(self, data: Any) -> int:
        """The same; JSON knows no numpy."""
        return self.encode(data)


class WholeNumbers(NamedTuple):
    """An array of whole numbers, such as the numbers of things; its dimensions as those of
    `Numbers`.

    >>> WholeNumbers(("n", 2)).encode([(0, 1), (1.0, 2)])
    [[0, 1], [1, 2]]
    """

    dimensions: tuple[int | str, ...]

    @property
    def words(self) -> str:
        """In words."""
        return say("shape.whole_numbers", dimensions=str(self.dimensions).replace("'", ""))

    def encode(self, value: Any) -> Any:
        """An array, or lists and tuples that make one; floats that are whole will do."""
        array = numeric(value, self.dimensions, self)
        if not (np.abs(array) < 2**53).all() or (array != np.rint(array)).any():
            raise wrong(self.words, value)
        return array.astype(np.int64).tolist()

    def decode(self, data: Any) -> np.ndarray:
        """The array, int64."""
        whole = self.encode(unnested(data, self, len(self.dimensions)))
        return numeric(whole, self.dimensions, self).astype(np.int64)
