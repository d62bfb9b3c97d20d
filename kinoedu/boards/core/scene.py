"""Scenes: what stands on a board and what of it can be dragged, as plain data that Python and the
browser share.

lo, hi      the corners of the world, [x, y]
boundary    the ring outside of which nothing is free, or None
polygons    each {name, rings: the outer one and its rooms, movable, vertices: whether those move one by one}
discs       each {name, at, radius, movable}
handles     points to drag: each {name, at, colour, marker: "dot" or "star", radius: of a body to draw}; or a stop {name, at, stop},
            drawn by the answer: the second handle comes to it when it is clicked, the first with Shift; what stands exactly
            there is taken along when it is dragged
driven      a handle that has this is put elsewhere by the answer alone, while arrow keys are held: see `Canvas`
posed       the handles are places and the tips that they look at, by turns: pressed on the ground, the second place comes there,
            with Shift the first, and its tip is in the hand. Left out, they are places alone
drawn       what has this is painted by the answer alone, which may put it elsewhere: see `Drawing.places`
size        rows and columns of the bitmap beneath, or None
colours     the names of the colours of a bitmap that has a byte a cell; left out, it is of bits, and true is free
glued       {lo, hi}: a box whose opposite sides are one, so that what leaves it comes in again; the bitmap fills it. Left out,
            the world ends at its rim, and the bitmap fills it all
ticks       whether a picture of it has scales; left out, it has
decimals    how many digits behind the point a dragged coordinate keeps
"""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...errors import InvalidParameter
from ...geometry.checks import Array, as_array, as_point
from ...support.text import shortened
from ...words import say

Scene = dict[str, Any]

LISTS = {"handle": "handles", "disc": "discs", "polygon": "polygons"}


def make_scene(
    lo: ArrayLike,
    hi: ArrayLike,
    *,
    boundary: ArrayLike | None = None,
    **parts: list[dict[str, Any]],
) -> Scene:
    """A scene of `handles`, `polygons` and `discs`, each a list; see the functions below."""
    low, high = as_point(lo, "lo"), as_point(hi, "hi")
    unknown = set(parts) - set(LISTS.values())
    if unknown:
        raise InvalidParameter(
            f"a scene has {', '.join(LISTS.values())}, got {', '.join(sorted(unknown))}"
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
) -> dict[str, Any]:
    """A point to drag."""
    return {
        "name": name,
        "at": as_point(at, name).tolist(),
        "colour": colour,
        "marker": marker,
        "radius": float(radius),
    }


def stop(name: str, at: ArrayLike) -> dict[str, Any]:
    """A point to drag, to which the first two handles can be called."""
    return {"name": name, "at": as_point(at, name).tolist(), "stop": True}


def polygon(
    name: str, rings: list[Array], *, movable: bool = True, vertices: bool = True
) -> dict[str, Any]:
    """A polygon to drag, whole or by its vertices; the rings after the first are its rooms."""
    return {
        "name": name,
        "rings": [ring.tolist() for ring in rings],
        "movable": movable,
        "vertices": vertices,
    }


def disc(name: str, at: ArrayLike, radius: float, *, movable: bool = True) -> dict[str, Any]:
    """A disc to drag."""
    return {
        "name": name,
        "at": as_point(at, name).tolist(),
        "radius": float(radius),
        "movable": movable,
    }


def drawn(item: dict[str, Any]) -> dict[str, Any]:
    """A handle or polygon that can be dragged, but is painted by the answer, which may put it
    elsewhere.
    """
    return {**item, "drawn": True}


def driven(item: dict[str, Any]) -> dict[str, Any]:
    """A handle that is not dragged, but driven by the arrow keys."""
    return {**drawn(item), "driven": True}


def place_of(scene: Scene, name: str) -> Array:
    """Where a handle is, shape (2,). Raises InvalidParameter where there is none of that name."""
    for item in scene["handles"]:
        if item["name"] == name:
            return np.array(item["at"])
    raise InvalidParameter(f"the scene has no handle {name!r}")


def moved(scene: Scene, parts: Any) -> Scene:
    """The scene with some of its parts elsewhere: each (kind, number, coordinates), of the same
    shape as before.

    What comes from a browser is not trusted. Raises InvalidParameter, InvalidPoint.
    """
    after = {**scene, **{name: list(scene[name]) for name in LISTS.values()}}
    if not isinstance(parts, list | tuple):
        raise unknown(parts)
    for part in parts:
        if not isinstance(part, list | tuple) or len(part) != 3:
            raise unknown(part)
        kind, number, coordinates = part
        items = after[LISTS[kind]] if isinstance(kind, str) and kind in LISTS else []
        if not isinstance(number, int) or isinstance(number, bool) or not 0 <= number < len(items):
            raise unknown(part)
        items[number] = item_at(items[number], coordinates, part)
    return after


def item_at(item: dict[str, Any], coordinates: Any, part: Any) -> dict[str, Any]:
    """A handle, disc or polygon elsewhere."""
    if "at" in item:
        return {**item, "at": as_point(coordinates, item["name"]).tolist()}
    if not isinstance(coordinates, list | tuple) or len(coordinates) != len(item["rings"]):
        raise unknown(part)
    rings = [as_array(ring, item["name"]) for ring in coordinates]
    if any(
        ring.shape != np.shape(before) for ring, before in zip(rings, item["rings"], strict=True)
    ):
        raise unknown(part)
    return {**item, "rings": [ring.tolist() for ring in rings]}


def unknown(part: Any) -> InvalidParameter:
    """The error for a part that no scene has."""
    return InvalidParameter(say("board.no_such_part", part=shortened(part)))


def arranged_like(home: Scene, proposed: Any) -> Scene:
    """A whole scene from elsewhere: home with everything where the other has it. Raises
    InvalidParameter, InvalidPoint.
    """
    if not isinstance(proposed, dict):
        raise unknown(proposed)
    for name in LISTS.values():
        items = proposed.get(name)
        if (
            not isinstance(items, list)
            or len(items) != len(home[name])
            or not all(isinstance(item, dict) for item in items)
        ):
            raise unknown(items)
    return moved(home, everything(proposed))


def everything(scene: Scene) -> list[tuple[str, int, Any]]:
    """Where each part of a scene is, as `moved` takes it."""
    return [
        (kind, number, item.get("at", item.get("rings")))
        for kind, name in LISTS.items()
        for number, item in enumerate(scene[name])
    ]
