"""Polygon maps in JSON, as drawn for Bench-MR: parking lots and warehouses, with y down.

    {
        "polygons": [[[x, y], ...], ...],
        "start": [x, y, theta],
        "goal": [x, y, theta],
        "source": "...",
        "note": "..."
    }

Only `polygons` is required. E. Heiden, L. Palmieri et al., "Bench-MR: a motion planning benchmark
for wheeled mobile robots" (2021). Such drawings contain what a world refuses: outlines that cross
themselves, repeated corners and repeated polygons. They are repaired here, and a warning lists the
repairs.
"""

from __future__ import annotations

import os
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ..errors import UnknownFormat
from ..geometry.checks import Array, as_array
from ..support.constructors import with_type_names
from ..support.json_fields import Field, read_json
from ..support.reading import as_path, regular_file
from ..worlds.polygon_world import PolygonWorld, PolygonWorldRecord
from .mending import mend_polygons
from .outlines import rectangle


@with_type_names
class PolygonMap(NamedTuple):
    """The world of a map, and its start and goal, or None; y points up."""

    world: PolygonWorldRecord
    start: Array | None
    goal: Array | None


def read_benchmr(path: str | os.PathLike[str], *, boundary: ArrayLike | None = None) -> PolygonMap:
    """Read a polygon map from a JSON file.

    y is flipped to point up: the lowest corner of the drawing has y = 0, x stays. A heading theta
    becomes -theta. An outline that crosses itself becomes the region that it encloses; repeated
    corners and polygons are dropped. The warning MendedPolygons gives their numbers.

    Parameters
    ----------
    boundary : (n, 2), a simple polygon, y up; by default the bounding rectangle of all polygons.

    Returns
    -------
    PolygonMap

    Raises
    ------
    UnreadableScene
        Where the file is missing or damaged; the message names the field.
    InvalidPolygon
        Where a polygon has no area; the message gives its number.
    """
    file = regular_file(path)
    return read_json(file, "map", lambda field: parse_map(field, boundary, str(file)))


def is_polygon_map(path: str | os.PathLike[str]) -> bool:
    """Whether a JSON file is a polygon map, and not a scene.

    Raises
    ------
    UnreadableScene
        Where the file is missing or damaged.
    """
    return read_json(
        as_path(path),
        "map",
        lambda field: isinstance(field.value, dict) and "polygons" in field.value,
    )


def read_polygons(path: str | os.PathLike[str]) -> PolygonWorldRecord:
    """Read the world of a polygon map; the reader that `read_world` uses.

    Returns
    -------
    PolygonWorldRecord

    Raises
    ------
    UnknownFormat
        Where the file is a scene.
    UnreadableScene, InvalidPolygon
        As `read_benchmr`.
    """
    if not is_polygon_map(path):
        raise UnknownFormat(
            f"{path}: expected a map with `polygons`; read a scene by kinoedu.files.read_scene"
        )
    return read_benchmr(path).world


def parse_map(field: Field, boundary: ArrayLike | None, file: str) -> PolygonMap:
    """Build a map from the parsed file."""
    fields = field.members(("polygons",), ("start", "goal", "source", "note"))
    drawn = [as_array(polygon.points(), polygon.name) for polygon in fields["polygons"].items()]
    if not drawn:
        raise fields["polygons"].wrong("a list of at least one polygon")
    for i, polygon in enumerate(drawn):
        if polygon.ndim != 2 or polygon.shape[1] != 2:
            raise fields["polygons"].items()[i].wrong("a list of points [x, y]")
    bottom = max(polygon[:, 1].max() for polygon in drawn)
    rings = mend_polygons([polygon * (1.0, -1.0) + (0.0, bottom) for polygon in drawn], file)
    if boundary is None:
        corners = np.concatenate(rings)
        boundary = rectangle(corners.min(axis=0), corners.max(axis=0))
    start, goal = (
        flip_y(fields[name], bottom) if name in fields else None for name in ("start", "goal")
    )
    return PolygonMap(PolygonWorld(boundary, rings), start, goal)


def flip_y(field: Field, bottom: float) -> Array:
    """Flip the y-axis of a configuration (x, y) or (x, y, theta)."""
    q = as_array(field.numbers(), field.name)
    if len(q) not in (2, 3):
        raise field.wrong("[x, y] or [x, y, theta]")
    return np.append((q[0], bottom - q[1]), -q[2:])
