"""A curve of arcs and straight lines, each driven forward or back. LaValle, Planning Algorithms,
section 15.3.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..compiled import compiled
from ..errors import InvalidParameter, InvalidPoint
from ..geometry.checks import Array, as_array
from ..spaces.angles import wrapped
from ..support.text import shortened
from .arcs import driven

LETTERS = {1: "L", 0: "S", -1: "R"}


class Curve(NamedTuple):
    """A way driven from `start` (x, y, theta): piece i turns left (1), right (-1) or not (0), for
    lengths[i] of the world's unit, backwards where it is negative; arcs have the one `radius`."""

    start: Array
    radius: float
    turns: NDArray[np.int64]
    lengths: Array

    @property
    def length(self) -> float:
        """How far is driven, forward and back."""
        return float(np.abs(self.lengths).sum())

    @property
    def word(self) -> str:
        """The pieces by letter, such as "LSR"."""
        return "".join(LETTERS[turn] for turn in self.turns.tolist())

    def at(self, s: ArrayLike) -> Array:
        """The pose (x, y, theta) after a distance s driven, shape (3,); for many, shape (m,), the
        poses (m, 3).

        s is kept between 0 and the whole length. Raises InvalidPoint where it is not numbers.
        """
        along = np.clip(as_array(s, "s"), 0.0, self.length)
        poses = poses_along(self.start, self.radius, self.turns, self.lengths, np.atleast_1d(along))
        return poses if along.ndim else poses[0]


@compiled
def poses_along(
    start: Array, radius: float, turns: NDArray[np.int64], lengths: Array, along: Array
) -> Array:
    """The poses after each distance, shape (m, 3)."""
    poses = np.empty((len(along), 3))
    for i in range(len(along)):
        x, y, theta, left = start[0], start[1], start[2], along[i]
        for turn, length in zip(turns, lengths):
            piece = min(left, abs(length))
            x, y, theta = driven(x, y, theta, piece if length >= 0.0 else -piece, turn / radius)
            left -= piece
        poses[i, 0], poses[i, 1], poses[i, 2] = x, y, theta
    return poses


def as_pose(value: ArrayLike, name: str) -> Array:
    """A pose (x, y, theta), its angle wrapped; or InvalidPoint."""
    pose = as_array(value, name)
    if pose.shape != (3,):
        raise InvalidPoint(f"{name} must be a pose (x, y, theta), got {shortened(value)}")
    pose[2] = wrapped(pose[2])
    return pose


def as_radius(value: ArrayLike) -> float:
    """A turning radius, positive; or InvalidParameter."""
    radius = as_array(value, "radius")
    if radius.ndim or radius <= 0.0:
        raise InvalidParameter(
            f"the turning radius must be one positive length, got {shortened(value)}"
        )
    return float(radius)


@compiled
def seen_from(q0: Array, q1: Array, radius: float) -> tuple[float, float, float]:
    """q1 in the frame of q0, lengths in turning radii."""
    dx, dy, c, s = (
        (q1[0] - q0[0]) / radius,
        (q1[1] - q0[1]) / radius,
        math.cos(q0[2]),
        math.sin(q0[2]),
    )
    return c * dx + s * dy, c * dy - s * dx, wrapped(q1[2] - q0[2])
