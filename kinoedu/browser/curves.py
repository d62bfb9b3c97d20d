"""The body of the curves' board: the shortest curves of a car between two poses.

Their numbers are those of a lesson's board but for the last digits of sines and arcs, which are not
the same in every C library.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..compiled import algorithm, compiled
from ..curves.curve import poses_along, relative_pose
from ..curves.dubins import shortest_forward
from ..curves.reeds_shepp import ROUNDING, shortest
from ..geometry.checks import Array
from ..spaces.angles import wrap_angle
from .scenes import FOUND, SceneArrays

NOSE = 1.5  # the distance from a pose to the point that it looks at, in turning radii
PIECES = 40  # the points that draw a piece of a curve
LETTERS = "RSL"  # the letters of the turns -1, 0, 1


class CurveSettings(NamedTuple):
    """The settings of curves: the turning radius."""

    radius: float


class ShownCurves(NamedTuple):
    """What is shown of Dubins' curve and that of Reeds and Shepp.

    facts : (5,), the status, and word and length of each curve.
    forward : (m, 4), Dubins' curve, rows x, y, next x, next y.
    driven, backed : (m, 4), the pieces of the other one that are driven forward and backward.
    first, second : (1, 4), rows x, y, dx, dy, from each pose to the point that it looks at.
    noses : (2, 3), rows number, x, y: the handles of these points.
    """

    facts: Array
    forward: Array
    driven: Array
    backed: Array
    first: Array
    second: Array
    noses: Array


@algorithm
def show_curves(
    scene: SceneArrays, settings: CurveSettings, rng: np.random.Generator
) -> ShownCurves:
    """The curves from the pose of the first two handles to that of the next two."""
    radius = settings.radius
    a = pose_looking(scene.handles[0], scene.handles[1])
    b = pose_looking(scene.handles[2], scene.handles[3])
    x, y, phi = relative_pose(a, b, radius)
    turns, lengths = shortest_forward(x, y, phi)
    forward = radius * lengths
    ways, sizes = shortest(x, y, phi)
    is_driven = np.abs(sizes) > ROUNDING
    ways, both = ways[is_driven], radius * sizes[is_driven]
    ax, ay = point_ahead(a, radius)
    bx, by = point_ahead(b, radius)
    return ShownCurves(
        np.array(
            [
                float(FOUND),
                spell_turns(turns),
                np.abs(forward).sum(),
                spell_turns(ways),
                np.abs(both).sum(),
            ]
        ),
        rows_along(a, radius, turns, forward, 1.0),
        rows_along(a, radius, ways, both, 1.0),
        rows_along(a, radius, ways, both, -1.0),
        np.array([a[0], a[1], ax - a[0], ay - a[1]]).reshape(1, 4),
        np.array([b[0], b[1], bx - b[0], by - b[1]]).reshape(1, 4),
        np.array([1.0, ax, ay, 3.0, bx, by]).reshape(2, 3),
    )


@compiled
def pose_looking(place: Array, ahead: Array) -> Array:
    """The pose (3,) at a place that looks at another."""
    heading = math.atan2(ahead[1] - place[1], ahead[0] - place[0])
    return np.array([place[0], place[1], wrap_angle(heading)])


@compiled
def point_ahead(pose: Array, radius: float) -> tuple[float, float]:
    """The point that a pose looks at."""
    far = NOSE * radius
    return pose[0] + far * math.cos(pose[2]), pose[1] + far * math.sin(pose[2])


@compiled
def spell_turns(turns: NDArray[np.int64]) -> float:
    """A word as a number with a digit for each turn: its place among LETTERS, from 1."""
    word = 0.0
    for turn in turns:
        word = 10.0 * word + turn + 2
    return word


@compiled
def rows_along(
    start: Array, radius: float, turns: NDArray[np.int64], lengths: Array, gear: float
) -> Array:
    """The pieces of a curve that are driven in a gear, 1 or -1, as segments (m, 4)."""
    rows, m, begin = np.empty((PIECES * len(lengths), 4)), 0, 0.0
    along = np.empty(PIECES)
    for i in range(len(lengths)):
        for k in range(PIECES):
            along[k] = begin + abs(lengths[i]) * k / (PIECES - 1)
        begin += abs(lengths[i])
        if gear * lengths[i] < 0.0:
            continue
        poses = poses_along(start, radius, turns, lengths, along)
        for k in range(PIECES - 1):
            rows[m, 0], rows[m, 1] = poses[k, 0], poses[k, 1]
            rows[m, 2], rows[m, 3] = poses[k + 1, 0], poses[k + 1, 1]
            m += 1
    return rows[:m].copy()
