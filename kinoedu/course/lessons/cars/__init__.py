"""Lesson 12: The car, or why it cannot move sideways.

Its exercises, in the order of the notebook.
"""

from .csc_length import CscLength
from .euler import Euler
from .exposing_drive import ExposeSmallAngles
from .move import Move
from .order_of_error import OrderOfError
from .replay import Replay

EXERCISES = [
    Move,
    Replay,
    Euler,
    OrderOfError,
    CscLength,
    ExposeSmallAngles,
]
