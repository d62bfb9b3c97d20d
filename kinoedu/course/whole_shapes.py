"""Shapes of integers: counts and indices."""

from typing import NamedTuple

import numpy as np

from ..messages import get_message
from .plain import as_array, decode_floats, wrong_item, wrong_shape


class Integer(NamedTuple):
    """One integer, such as the index of a node, of Python or numpy; not True, 1.0 or "1".

    >>> Integer().encode(np.int64(3))
    3
    """

    @property
    def description(self) -> str:
        """Description of the shape, for messages."""
        return get_message("shape.whole")

    def encode(self, value: object) -> int:
        """Encode an integer of at most fifteen digits. Raises WrongShape."""
        if (
            not (type(value) is int or isinstance(value, np.integer))
            or not -(10**15) < value < 10**15
        ):
            raise wrong_shape(self.description, value)
        return int(value)

    def decode(self, data: object) -> int:
        """Decode an integer. Raises WrongShape."""
        return self.encode(data)


class Integers(NamedTuple):
    """An array of integers, such as indices; dimensions as for `Numbers`.

    >>> Integers(("n", 2)).encode([(0, 1), (1.0, 2)])
    [[0, 1], [1, 2]]
    """

    dimensions: tuple[int | str, ...]

    @property
    def description(self) -> str:
        """Description of the shape, for messages."""
        return get_message("shape.whole_numbers", dimensions=str(self.dimensions).replace("'", ""))

    def encode(self, value: object) -> object:
        """Encode an array, or nested lists and tuples; floats without a fraction are accepted."""
        array = as_array(value, self.dimensions, self)
        is_whole = (np.abs(array) < 2**53) & (array == np.rint(array))
        if not is_whole.all():
            raise wrong_item(self.description, value, array[~is_whole][0])
        return array.astype(np.int64).tolist()

    def decode(self, data: object) -> np.ndarray:
        """Decode an int64 array."""
        whole = self.encode(decode_floats(data, self, len(self.dimensions)))
        return as_array(whole, self.dimensions, self).astype(np.int64)
