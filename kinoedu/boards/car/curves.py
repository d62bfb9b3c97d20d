"""A board of a car's curves: two poses to drag, and the shortest curves between them."""

from __future__ import annotations

from functools import partial

import numpy as np
from numpy.typing import ArrayLike

from ...browser.curves import point_ahead, pose_looking
from ...curves.curve import as_pose, as_radius
from ...geometry.checks import Array
from ...messages import get_message
from ..core.canvas import Canvas
from ..core.scene import Scene, handle, make_scene, place_of
from ..core.shown import answer_by, make_live


def curves_board(a: ArrayLike, b: ArrayLike, radius: float) -> Canvas:
    """Drag two poses and the points that they look at: Dubins' and Reeds and Shepp's curves.

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
            handle(get_message(f"curves_board.{name}_looks"), point_ahead(pose, r), colour=colour)
        )
    return Canvas(
        make_scene(middle - 0.55 * reach, middle + 0.55 * reach, handles=handles),
        partial(answer_by, "curves", (r,)),
        live=make_live("curves", (r,)),
    )


def pose_in(scene: Scene, name: str) -> Array:
    """A pose in a scene, from its two handles."""
    ahead = place_of(scene, get_message(f"curves_board.{name}_looks"))
    return np.asarray(pose_looking(place_of(scene, name), ahead))
