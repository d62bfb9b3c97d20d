"""Maps of polygons in JSON, as drawn for bench-mr: parking lots and warehouses, y down as in the
pictures they were traced from.

    {"polygons": [[[x, y], ...], ...], "start": [x, y, theta], "goal": [x, y, theta], "source": "...", "note": "..."}

All but `polygons` may be left out. E. Heiden, L. Palmieri et al., "Bench-MR: a motion planning
benchmark for wheeled mobile robots" (2021). Such drawings have what a world refuses: outlines that
cross themselves, corners and polygons that are there twice. Here they are mended, and a warning
says which.
"""

import os
import warnings
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ..errors import InvalidPolygon, MendedPolygons, UnknownFormat
from ..geometry.checks import Array, as_array
from ..geometry.rings import as_ring
from ..support.json_fields import Field, read_json
from ..support.reading import regular_file
from ..worlds.polygon_world import PolygonWorld, PolygonWorldRecord
from .outlines import rectangle

SLIVER = (
    1e-12  # of the polygon's rectangle: what a crossing pinches off and is smaller, is rounding
)


class PolygonMap(NamedTuple):
    """A map's world, and its start and goal where it has them; y up."""

    world: PolygonWorldRecord
    start: Array | None
    goal: Array | None


def read_benchmr(path: str | os.PathLike[str], *, boundary: ArrayLike | None = None) -> PolygonMap:
    """The map in a JSON file of polygons.

    Parameters
    ----------
    boundary : (n, 2), a simple polygon, y up; by default the rectangle round all polygons.

    y turns up: the lowest corner of the drawing has y = 0, x stays. A heading theta becomes -theta.
    An outline that crosses itself becomes all that it encloses; repeated corners and polygons are
    left out. A warning, MendedPolygons, gives their numbers.

    Raises UnreadableScene, with the field at fault; InvalidPolygon for one without area, by its
    number.
    """
    file = regular_file(path)
    return read_json(file, "map", lambda field: map_from(field, boundary, str(file)))


def is_polygon_map(path: str | os.PathLike[str]) -> bool:
    """Whether a JSON file is such a map, and not a scene. Raises UnreadableScene."""
    return read_json(
        Path(path), "map", lambda field: isinstance(field.value, dict) and "polygons" in field.value
    )


def read_polygons(path: str | os.PathLike[str]) -> PolygonWorldRecord:
    """The world alone, as `read_world` gives it. Raises UnknownFormat for a scene, and all that
    `read_benchmr` does.
    """
    if not is_polygon_map(path):
        raise UnknownFormat(
            f"{path}: expected a map with `polygons`; a scene is read by kinoedu.files.scenes.read_scene"
        )
    return read_benchmr(path).world


def map_from(field: Field, boundary: ArrayLike | None, file: str) -> PolygonMap:
    """A map from the whole file."""
    fields = field.members(("polygons",), ("start", "goal", "source", "note"))
    drawn = [as_array(polygon.points(), polygon.name) for polygon in fields["polygons"].items()]
    if not drawn:
        raise fields["polygons"].wrong("a list of at least one polygon")
    for i, polygon in enumerate(drawn):
        if polygon.ndim != 2 or polygon.shape[1] != 2:
            raise fields["polygons"].items()[i].wrong("a list of points [x, y]")
    bottom = max(polygon[:, 1].max() for polygon in drawn)
    rings = mended([polygon * (1.0, -1.0) + (0.0, bottom) for polygon in drawn], file)
    if boundary is None:
        corners = np.concatenate(rings)
        boundary = rectangle(corners.min(axis=0), corners.max(axis=0))
    start, goal = (
        turned_up(fields[name], bottom) if name in fields else None for name in ("start", "goal")
    )
    return PolygonMap(PolygonWorld(boundary, rings), start, goal)


def turned_up(field: Field, bottom: float) -> Array:
    """A configuration (x, y) or (x, y, theta), y up."""
    q = as_array(field.numbers(), field.name)
    if len(q) not in (2, 3):
        raise field.wrong("[x, y] or [x, y, theta]")
    return np.append((q[0], bottom - q[1]), -q[2:])


def mended(drawn: list[Array], file: str) -> list[Array]:
    """Simple polygons from what was drawn, and a warning where they are not the same."""
    rings: list[Array] = []
    seen: dict[Any, int] = {}
    notes = []
    for i, polygon in enumerate(drawn):
        again = (polygon == np.roll(polygon, -1, axis=0)).all(axis=1)
        if again.any():
            notes.append(f"polygon {i} repeats {again.sum()} of its corners, left out")
        corners = polygon[~again]
        earlier = seen.setdefault(frozenset(map(tuple, corners.tolist())), i)
        if earlier != i and same_ring(drawn[earlier], corners):
            notes.append(f"polygon {i} is polygon {earlier} again, left out")
            continue
        try:
            rings.append(as_ring(corners, f"polygon {i}"))
        except InvalidPolygon as error:
            rings += enclosed(corners, error)
            notes.append(f"polygon {i} crosses or touches itself: all that it encloses is solid")
    if notes:
        warnings.warn(f"{file}: {'; '.join(notes)}", MendedPolygons, stacklevel=2)
    return rings


def same_ring(a: Array, b: Array) -> bool:
    """Whether two rings have the same edges, whichever way round they are written."""
    return edges_of_drawing(a) == edges_of_drawing(b)


def edges_of_drawing(ring: Array) -> set[frozenset[Any]]:
    """The edges of positive length as pairs of ends."""
    ends = list(map(tuple, ring.tolist()))
    return {frozenset(pair) for pair in zip(ends, ends[1:] + ends[:1]) if pair[0] != pair[1]}


def enclosed(corners: Array, error: InvalidPolygon) -> list[Array]:
    """The outlines of all that a ring which crosses itself encloses; without area, its error."""
    import shapely

    if len(corners) < 3:
        raise error
    faces = shapely.polygonize(
        shapely.get_parts(shapely.node(shapely.linestrings(np.vstack([corners, corners[:1]]))))
    )
    least = SLIVER * np.prod(np.ptp(corners, axis=0))
    parts = [
        part
        for part in shapely.get_parts(shapely.union_all(shapely.get_parts(faces)))
        if part.area > least
    ]
    if not parts:
        raise error
    return [
        as_ring(shapely.get_coordinates(part.exterior)[:-1], "what a mended polygon encloses")
        for part in parts
    ]
