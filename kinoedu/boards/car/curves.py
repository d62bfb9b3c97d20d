"""A board of a car's curves: two poses to drag, and the shortest curves between them."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from ...curves import Curve, dubins_path, reeds_shepp_path
from ...curves.curve import as_pose, as_radius
from ...geometry.checks import Array
from ...messages import get_message
from ..core.canvas import Canvas
from ..core.drawing import Drawing, Layer, arrows, edges, segments_along
from ..core.scene import Scene, handle, make_scene, place_of

NOSE = 1.5  # the distance from a pose to the point that it looks at, in turning radii
PIECES = 40  # the points that draw an arc


def curves_board(a: ArrayLike, b: ArrayLike, radius: float) -> Canvas:
    """Drag two poses and the points that they look at: Dubins and Reeds-Shepp curves.

    Parameters
    ----------
    a, b : (x, y, theta), the first poses.
    radius : the turning radius.

    Raises
    ------
    InvalidPoint, InvalidParameter

    Examples
    --------
    >>> curves_board((0, 0, 0), (0, 4, 0), 2.0)
    Canvas(forward only LSL, 16.6 long; both ways RLRL, 7.29 long)
    """
    poses, r = {"a": as_pose(a, "a"), "b": as_pose(b, "b")}, as_radius(radius)
    places = np.array([pose[:2] for pose in poses.values()])
    middle, reach = places.mean(axis=0), float(np.ptp(places, axis=0).max()) + 5.0 * r
    handles = []
    for (name, pose), colour, marker in zip(poses.items(), ("start", "goal"), ("dot", "star")):
        handles.append(handle(name, pose[:2], colour=colour, marker=marker))
        handles.append(
            handle(get_message(f"curves_board.{name}_looks"), nose(pose, r), colour=colour)
        )
    return Canvas(
        make_scene(middle - 0.55 * reach, middle + 0.55 * reach, handles=handles),
        lambda now: draw_curves(now, r),
    )


def nose(pose: Array, radius: float) -> Array:
    """The point that a pose looks at."""
    return pose[:2] + NOSE * radius * np.array([math.cos(pose[2]), math.sin(pose[2])])


def pose_in(scene: Scene, name: str) -> Array:
    """A pose in a scene, from its two handles."""
    place, ahead = place_of(scene, name), place_of(scene, get_message(f"curves_board.{name}_looks"))
    return np.array([*place, math.atan2(ahead[1] - place[1], ahead[0] - place[0])])


def draw_curves(scene: Scene, radius: float) -> Drawing:
    """Draw both curves, backward pieces dashed.

    The points that the poses look at return to their distance.
    """
    a, b = pose_in(scene, "a"), pose_in(scene, "b")
    forward, both = dubins_path(a, b, radius), reeds_shepp_path(a, b, radius)
    layers = [*draw_curve(forward, "tree", 2.0), *draw_curve(both, "path", 4.0)]
    for pose, colour in ((a, "start"), (b, "goal")):
        layers.append(arrows([pose[:2]], [nose(pose, radius) - pose[:2]], colour))
    values = {
        "forward": forward.word,
        "first": f"{forward.length:.3g}",
        "both": both.word or "-",
        "second": f"{both.length:.3g}",
    }
    places = [("handle", number, nose(pose, radius).tolist()) for number, pose in ((1, a), (3, b))]
    return Drawing(layers, text=get_message("curves_board.text", **values), places=places)


def draw_curve(curve: Curve, colour: str, width: float) -> list[Layer]:
    """Draw the pieces of a curve."""
    ends = np.concatenate([[0.0], np.cumsum(np.abs(curve.lengths))])
    pieces = [
        segments_along(curve.at(np.linspace(begin, end, PIECES))[:, :2])
        for begin, end in zip(ends, ends[1:])
    ]
    return [
        edges(piece, colour, width=width, dash=(7, 5) if length < 0.0 else ())
        for piece, length in zip(pieces, curve.lengths)
    ]
