"""Curves made of arcs and straight pieces, each driven forward or backward.

Source: LaValle, Planning Algorithms, section 15.3.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..compiled import compiled
from ..errors import InvalidParameter, InvalidPoint
from ..geometry.checks import LIMIT, Array, as_array, as_row
from ..spaces.angles import wrap_angle
from ..support.constructors import with_type_names
from ..support.text import shortened
from .arcs import drive_arc

LETTERS = {1: "L", 0: "S", -1: "R"}


@with_type_names
class Curve(NamedTuple):
    """A curve from `start` (x, y, theta).

    Piece i turns left (1), right (-1) or not (0), for lengths[i] units, backwards where that is
    negative. All arcs have the same `radius`.
    """

    start: Array
    radius: float
    turns: NDArray[np.int64]
    lengths: Array

    @property
    def length(self) -> float:
        """The distance driven, forward and backward."""
        return float(np.abs(self.lengths).sum())

    @property
    def word(self) -> str:
        """The letters of the pieces, such as "LSR"."""
        return "".join(LETTERS[turn] for turn in self.turns.tolist())

    def at(self, s: ArrayLike) -> Array:
        """The pose (x, y, theta) at a distance s along the curve.

        Parameters
        ----------
        s : a distance, or (m,) distances. Each is clipped to the interval from 0 to the curve's
            length.

        Returns
        -------
        (3,) array, or (m, 3) array for many distances.

        Raises
        ------
        InvalidPoint
            Where s is not a number or a row of numbers.
        """
        along = np.clip(as_row(s, "s"), 0.0, self.length)
        poses = poses_along(self.start, self.radius, self.turns, self.lengths, np.atleast_1d(along))
        return poses if along.ndim else poses[0]


@compiled
def poses_along(
    start: Array, radius: float, turns: NDArray[np.int64], lengths: Array, along: Array
) -> Array:
    """The pose after each distance, shape (m, 3)."""
    poses = np.empty((len(along), 3))
    for i in range(len(along)):
        x, y, theta, left = start[0], start[1], start[2], along[i]
        for turn, length in zip(turns, lengths):
            piece = min(left, abs(length))
            x, y, theta = drive_arc(x, y, theta, piece if length >= 0.0 else -piece, turn / radius)
            left -= piece
        poses[i, 0], poses[i, 1], poses[i, 2] = x, y, theta
    return poses


def as_pose(value: ArrayLike, name: str) -> Array:
    """A pose (x, y, theta) with its angle wrapped, shape (3,).

    Raises
    ------
    InvalidPoint
        Where the value is not three finite numbers.
    """
    pose = as_array(value, name)
    if pose.shape != (3,):
        raise InvalidPoint(f"{name} must be a pose (x, y, theta), got {shortened(value)}")
    pose[2] = wrap_angle(pose[2])
    return pose


def as_radius(value: ArrayLike) -> float:
    """A positive turning radius.

    Raises
    ------
    InvalidParameter
        Where the value is not one positive number.
    InvalidPoint
        Where the value is not a finite number.
    """
    radius = as_array(value, "radius")
    if radius.ndim or radius <= 0.0:
        raise InvalidParameter(
            f"the turning radius must be one positive length, got {shortened(value)}"
        )
    return float(radius)


def as_relative_pose(q0: Array, q1: Array, radius: float) -> tuple[float, float, float]:
    """The `relative_pose` of two poses whose distance can be counted in turning radii.

    Raises
    ------
    InvalidParameter
        Where they are too far apart for that.
    """
    with np.errstate(over="ignore", invalid="ignore"):
        x, y, theta = relative_pose(q0, q1, radius)
    if not max(abs(x), abs(y)) <= LIMIT:
        raise InvalidParameter(
            f"the poses are too far apart for a turning radius of {radius:g}; give a larger one"
        )
    return x, y, theta


@compiled
def relative_pose(q0: Array, q1: Array, radius: float) -> tuple[float, float, float]:
    """The pose q1 in the frame of q0, with lengths in turning radii."""
    dx, dy = (q1[0] - q0[0]) / radius, (q1[1] - q0[1]) / radius
    c, s = math.cos(q0[2]), math.sin(q0[2])
    return c * dx + s * dy, c * dy - s * dx, wrap_angle(q1[2] - q0[2])
