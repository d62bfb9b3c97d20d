"""Base class of the exercises that ask for a drawing."""

from collections.abc import Callable

import numpy as np

from ...drawn import Canvas, Drawn
from ...exercise import Given, ValueExercise
from ...shapes import Value

FULL = 2.0 * np.pi
NEAR = 1e-5  # dots closer than this are equal


class DrawnExercise(ValueExercise):
    """An exercise whose function draws into given axes; the contents of the axes are judged."""

    answer = Drawn()

    def call(self, function: Callable[..., object], given: Given) -> Value:
        """Call the function with new axes as its last argument, and return what it drew."""
        canvas = Canvas()
        function(*given.values(), canvas)
        return canvas


def same_dots(found: object, wanted: object, *, modulo: bool = False) -> bool:
    """Whether rows are equal up to rounding and order.

    With `modulo`, the first two columns count modulo 2 pi.
    """
    ours, theirs = np.asarray(found, float), np.asarray(wanted, float)
    if ours.shape != theirs.shape or not np.isfinite(ours).all():
        return False
    apart = np.abs(ours[:, None] - theirs[None])
    if modulo:
        apart[..., :2] = np.minimum(apart[..., :2] % FULL, FULL - apart[..., :2] % FULL)
    return bool(((apart <= NEAR).all(axis=2).sum(axis=0) == 1).all())
