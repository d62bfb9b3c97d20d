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
import warnings
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ..errors import InvalidPolygon, MendedPolygons, UnknownFormat
from ..geometry.checks import Array, as_array
from ..geometry.rings import as_ring
from ..support.constructors import with_type_names
from ..support.json_fields import Field, read_json
from ..support.reading import regular_file
from ..worlds.polygon_world import PolygonWorld, PolygonWorldRecord
from .outlines import rectangle

# of the area of the polygon's bounding rectangle: smaller regions at a crossing are rounding errors
SLIVER = 1e-12


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
        Path(path), "map", lambda field: isinstance(field.value, dict) and "polygons" in field.value
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


def mend_polygons(drawn: list[Array], file: str) -> list[Array]:
    """Repair the drawn polygons, and warn where a repair was needed."""
    rings: list[Array] = []
    first_index: dict[Any, int] = {}
    notes = []
    for i, polygon in enumerate(drawn):
        again = (polygon == np.roll(polygon, -1, axis=0)).all(axis=1)
        if again.any():
            notes.append(f"polygon {i} repeats {again.sum()} of its corners, left out")
        corners = polygon[~again]
        earlier = first_index.setdefault(frozenset(map(tuple, corners.tolist())), i)
        if earlier != i and same_ring(drawn[earlier], corners):
            notes.append(f"polygon {i} is polygon {earlier} again, left out")
            continue
        try:
            rings.append(as_ring(corners, f"polygon {i}"))
        except InvalidPolygon as error:
            rings += enclosed_outlines(corners, error)
            notes.append(f"polygon {i} crosses or touches itself: the region it encloses is solid")
    if notes:
        warnings.warn(f"{file}: {'; '.join(notes)}", MendedPolygons, stacklevel=2)
    return rings


def same_ring(a: Array, b: Array) -> bool:
    """Whether two rings have the same edges, in either orientation."""
    return edges_of_drawing(a) == edges_of_drawing(b)


def edges_of_drawing(ring: Array) -> set[frozenset[Any]]:
    """The edges of positive length as pairs of ends."""
    ends = list(map(tuple, ring.tolist()))
    return {frozenset(pair) for pair in zip(ends, ends[1:] + ends[:1]) if pair[0] != pair[1]}


def enclosed_outlines(corners: Array, error: InvalidPolygon) -> list[Array]:
    """The outlines of the region that a self-crossing ring encloses; raise `error` without area."""
    import shapely

    if len(corners) < 3:
        raise error
    closed = shapely.linestrings(np.vstack([corners, corners[:1]]))
    faces = shapely.polygonize(shapely.get_parts(shapely.node(closed)))
    least = SLIVER * np.prod(np.ptp(corners, axis=0))
    parts = [
        part
        for part in shapely.get_parts(shapely.union_all(shapely.get_parts(faces)))
        if part.area > least
    ]
    if not parts:
        raise error
    return [
        as_ring(
            shapely.get_coordinates(part.exterior)[:-1], "the region enclosed by a repaired polygon"
        )
        for part in parts
    ]
