"""Scenes: the things on a board and which of them can be dragged, as plain data.

Python and the browser share this form.

lo, hi      the corners of the world, [x, y]
boundary    the ring outside of which nothing is free, or None
polygons    each {name, rings: the outer one and its holes, movable, vertices: whether the vertices
            can be dragged one by one}
discs       each {name, at, radius, movable}
handles     points to drag, each {name, at, colour, marker: "dot" or "star", radius: of a body to
            draw}; or a stop {name, at, stop}, which the answer draws. A click on a stop moves the
            second handle to it, Shift and click the first. Handles exactly at a stop move with it
driven      a handle with this key is moved only by the answer, while arrow keys are held: see
            `Canvas`
posed       the handles are pairs of a place and its tip, the point that it looks at. A press on the
            ground moves the second place there, with Shift the first, and its tip is dragged. Left
            out, all handles are places
colour      of a handle; of a polygon that is no obstacle
drawn       an item with this key is painted only by the answer, which may move it: see
            `Drawing.places`
size        rows and columns of the bitmap beneath, or None
colours     the names of the colours of a bitmap with one byte for each cell. Left out, the bitmap
            has bits, and true is free
meanings    what each colour of the bitmap means, to be read where one points. Left out, it says
            nothing
glued       {lo, hi}: a box whose opposite sides are identified: what leaves it on one side enters
            on the other. The bitmap fills it. Left out, the world ends at its rim, and the bitmap
            fills the world
ticks       whether its picture has scales. Left out, it has
decimals    the number of decimals that a dragged coordinate keeps
"""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...errors import InvalidParameter
from ...figures import palette
from ...geometry.checks import Array, as_array, as_point
from ...messages import get_message
from ...support.json_fields import JsonObject
from ...support.text import shortened

Scene = dict[str, Any]

LISTS = {"handle": "handles", "disc": "discs", "polygon": "polygons"}


def make_scene(
    lo: ArrayLike,
    hi: ArrayLike,
    *,
    boundary: ArrayLike | None = None,
    **parts: list[JsonObject],
) -> Scene:
    """A scene of `handles`, `polygons` and `discs`, lists of what the functions below return.

    Parameters
    ----------
    lo, hi : (2,), the corners of the world.
    boundary : (n, 2), the ring outside of which nothing is free.

    Returns
    -------
    dict
        Plain data, as the head of this file describes it.

    Raises
    ------
    InvalidParameter
        For a list of another name, or a world without width or height.
    InvalidPoint
        Where a corner or the boundary is not made of finite numbers.
    """
    low, high = as_point(lo, "lo"), as_point(hi, "hi")
    unknown = set(parts) - set(LISTS.values())
    if unknown:
        raise InvalidParameter(
            f"a scene has {', '.join(LISTS.values())}, got {', '.join(sorted(unknown))}"
        )
    if not (low < high).all():
        raise InvalidParameter(
            "lo must lie below and to the left of hi, got "
            f"lo = {shortened(low.tolist())}, hi = {shortened(high.tolist())}"
        )
    return {
        "lo": low.tolist(),
        "hi": high.tolist(),
        "boundary": None if boundary is None else as_array(boundary, "boundary").tolist(),
        **{name: list(parts.get(name, [])) for name in LISTS.values()},
        "size": None,
        "decimals": int(np.clip(np.ceil(-np.log10((high - low).max() / 1000.0)), 0, 90)),
    }


def handle(
    name: str, at: ArrayLike, *, colour: str, marker: str = "dot", radius: float = 0.0
) -> JsonObject:
    """A point to drag."""
    check_colour(colour)
    return {
        "name": name,
        "at": as_point(at, name).tolist(),
        "colour": colour,
        "marker": marker,
        "radius": float(radius),
    }


def check_colour(name: str) -> None:
    """Raise InvalidParameter for the name of a colour that the palette does not have."""
    if name not in palette.NAMED:
        known = ", ".join(palette.NAMED)
        raise InvalidParameter(f"no colour is named {name!r}; the names are {known}")


def stop(name: str, at: ArrayLike) -> JsonObject:
    """A point to drag; the first two handles can be moved to it by a click."""
    return {"name": name, "at": as_point(at, name).tolist(), "stop": True}


def polygon(
    name: str, rings: list[Array], *, movable: bool = True, vertices: bool = True
) -> JsonObject:
    """A polygon to drag as a whole or by its vertices; the rings after the first are holes."""
    return {
        "name": name,
        "rings": [ring.tolist() for ring in rings],
        "movable": movable,
        "vertices": vertices,
    }


def disc(name: str, at: ArrayLike, radius: float, *, movable: bool = True) -> JsonObject:
    """A disc to drag."""
    return {
        "name": name,
        "at": as_point(at, name).tolist(),
        "radius": float(radius),
        "movable": movable,
    }


def mark_drawn(item: JsonObject) -> JsonObject:
    """A handle or polygon that is dragged, but painted by the answer, which may move it."""
    return {**item, "drawn": True}


def mark_area(item: JsonObject) -> JsonObject:
    """A polygon that is no obstacle: pale, with a rim."""
    return {**item, "colour": "shape"}


def mark_driven(item: JsonObject) -> JsonObject:
    """A handle that is driven by the arrow keys instead of dragged."""
    return {**mark_drawn(item), "driven": True}


def place_of(scene: Scene, name: str) -> Array:
    """The position of a handle.

    Returns
    -------
    (2,) array

    Raises
    ------
    InvalidParameter
        Where the scene has no handle of this name.
    """
    for item in scene["handles"]:
        if item["name"] == name:
            return np.array(item["at"])
    raise InvalidParameter(f"the scene has no handle {name!r}")


def frame_of(scene: Scene) -> tuple[list[float], float]:
    """The lower corner of a scene, and its size."""
    lo, hi = scene["lo"], scene["hi"]
    return lo, max(hi[0] - lo[0], hi[1] - lo[1])


def move_parts(scene: Scene, parts: object) -> Scene:
    """The scene with some parts at other places.

    Parameters
    ----------
    parts : each (kind, number, coordinates), of the same shape as before. They come from a browser
        and are checked.

    Raises
    ------
    InvalidParameter, InvalidPoint
        Where a part does not exist, or its coordinates do not fit.
    """
    after = {**scene, **{name: list(scene[name]) for name in LISTS.values()}}
    if not isinstance(parts, list | tuple):
        raise unknown_part(parts)
    for part in parts:
        if not isinstance(part, list | tuple) or len(part) != 3:
            raise unknown_part(part)
        kind, number, coordinates = part
        items = after[LISTS[kind]] if isinstance(kind, str) and kind in LISTS else []
        if not isinstance(number, int) or isinstance(number, bool) or not 0 <= number < len(items):
            raise unknown_part(part)
        items[number] = move_item(items[number], coordinates, part)
    return after


def move_item(item: JsonObject, coordinates: Any, part: Any) -> JsonObject:
    """A handle, disc or polygon at another place."""
    if "at" in item:
        return {**item, "at": as_point(coordinates, item["name"]).tolist()}
    if not isinstance(coordinates, list | tuple) or len(coordinates) != len(item["rings"]):
        raise unknown_part(part)
    rings = [as_array(ring, item["name"]) for ring in coordinates]
    if [ring.shape for ring in rings] != [np.shape(before) for before in item["rings"]]:
        raise unknown_part(part)
    return {**item, "rings": [ring.tolist() for ring in rings]}


def unknown_part(part: Any) -> InvalidParameter:
    """The error for a part that the scene does not have."""
    return InvalidParameter(get_message("board.no_such_part", part=shortened(part)))


def list_places(scene: Scene) -> list[tuple[str, int, Any]]:
    """The place of each part of a scene, in the form that `move_parts` takes."""
    return [
        (kind, number, item.get("at", item.get("rings")))
        for kind, name in LISTS.items()
        for number, item in enumerate(scene[name])
    ]
