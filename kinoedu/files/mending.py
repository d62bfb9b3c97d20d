"""Repair of drawn polygons that a world refuses, with a warning that lists the repairs."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from typing import Any

import numpy as np

from ..errors import InvalidPolygon, MendedPolygons
from ..geometry.checks import Array, as_array
from ..geometry.rings import as_ring
from ..support.json_fields import Field

# of the area of the polygon's bounding rectangle: smaller regions at a crossing are rounding errors
SLIVER = 1e-12


def mend_scene(scene: Field, file: str) -> Field:
    """A parsed scene with its polygons repaired; a warning says which.

    The obstacles are repaired as by `mend_polygons`, and keep their order. The boundary, and an
    obstacle with rooms and its rooms, only lose their repeated corners. Numbers are those of the
    list of obstacles.
    """
    world = scene.value.get("world") if isinstance(scene.value, dict) else None
    if not isinstance(world, dict) or world.get("kind") != "polygons":
        return scene
    fields = Field(f"{scene.name}.world", world, scene.folder).members(
        ("kind", "boundary"), ("obstacles",)
    )
    notes = list[str]()
    mended = {**world, "boundary": without_repeats(fields["boundary"], notes)}
    if "obstacles" in fields:
        items = fields["obstacles"].items()
        plain = [k for k, item in enumerate(items) if is_plain_polygon(item)]
        rings = mended_rings([polygon_of(items[k]) for k in plain], notes, plain)
        parts = {k: [{"polygon": ring.tolist()} for ring in own] for k, own in zip(plain, rings)}
        mended["obstacles"] = [
            part
            for k, item in enumerate(items)
            for part in (parts[k] if k in parts else [mend_rooms(item, notes)])
        ]
    warn_mended(notes, file)
    return scene._replace(value={**scene.value, "world": mended})


def is_plain_polygon(obstacle: Field) -> bool:
    """Whether an obstacle of a scene is a polygon without rooms."""
    return isinstance(obstacle.value, dict) and set(obstacle.value) == {"polygon"}


def polygon_of(obstacle: Field) -> Array:
    """The corners of an obstacle, (n, 2)."""
    field = obstacle.members(("polygon",))["polygon"]
    corners = as_array(field.points(), field.name)
    if corners.ndim != 2 or corners.shape[1] != 2:
        raise field.wrong("a list of points [x, y]")
    return corners


def mend_rooms(obstacle: Field, notes: list[str]) -> Any:
    """An obstacle with rooms whose rings have no repeated corners; others as they are."""
    if not isinstance(obstacle.value, dict) or "polygon" not in obstacle.value:
        return obstacle.value
    fields = obstacle.members(("polygon",), ("rooms",))
    rooms = fields["rooms"].items() if "rooms" in fields else []
    return {
        "polygon": without_repeats(fields["polygon"], notes),
        "rooms": [without_repeats(room, notes) for room in rooms],
    }


def without_repeats(ring: Field, notes: list[str]) -> list[list[float]]:
    """The points of a ring without those that repeat the one before."""
    points = ring.points()
    kept = [q for q, before in zip(points, points[-1:] + points[:-1]) if q != before]
    if len(kept) < len(points):
        notes.append(f"{ring.name} repeats {len(points) - len(kept)} of its corners, left out")
    return kept


def warn_mended(notes: list[str], file: str) -> None:
    """Warn of the repairs, if there were any."""
    if notes:
        warnings.warn(f"{file}: {'; '.join(notes)}", MendedPolygons, stacklevel=3)


def mend_polygons(drawn: list[Array], file: str) -> list[Array]:
    """Repair the drawn polygons, and warn where a repair was needed."""
    notes = list[str]()
    rings = mended_rings(drawn, notes, range(len(drawn)))
    warn_mended(notes, file)
    return [ring for own in rings for ring in own]


def mended_rings(drawn: list[Array], notes: list[str], numbers: Sequence[int]) -> list[list[Array]]:
    """The simple rings of each drawn polygon; what was repaired is appended to the notes.

    An outline that crosses itself becomes the region that it encloses; repeated corners and
    polygons are left out. `numbers` are the names of the polygons.
    """
    rings: list[list[Array]] = []
    first_index: dict[Any, int] = {}
    for k, (i, polygon) in enumerate(zip(numbers, drawn)):
        again = (polygon == np.roll(polygon, -1, axis=0)).all(axis=1)
        if again.any():
            notes.append(f"polygon {i} repeats {again.sum()} of its corners, left out")
        corners = polygon[~again]
        earlier = first_index.setdefault(frozenset(map(tuple, corners.tolist())), k)
        if earlier != k and same_ring(drawn[earlier], corners):
            notes.append(f"polygon {i} is polygon {numbers[earlier]} again, left out")
            rings.append([])
            continue
        try:
            rings.append([as_ring(corners, f"polygon {i}")])
        except InvalidPolygon as error:
            rings.append(enclosed_outlines(corners, error))
            notes.append(f"polygon {i} crosses or touches itself: the region it encloses is solid")
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
