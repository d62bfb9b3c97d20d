"""Names of places in figures: beside the place, where there is room, and off the path."""

from __future__ import annotations

import numpy as np
from matplotlib import patheffects
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.text import Annotation
from matplotlib.transforms import Transform
from numpy.typing import ArrayLike

from ..collision import free_configurations
from ..geometry.checks import Array
from ..geometry.paths import points_at_fractions
from ..robots import Point
from ..worlds.checks import World
from ..worlds.polygon_world import PolygonWorldRecord
from ..worlds.terrain import TerrainRecord
from . import palette
from .palette import Style

HALO = [patheffects.withStroke(linewidth=3.5, foreground="white")]
NAME = "name of a place"  # the gid of its text
OFFSET = "offset points"
APART = 9.0  # points between a place and its name
WIDTH = 0.65  # of a letter, by the size of the text
STEPS = 400  # places of a line that are looked at
GRID = (13, 4)  # places of a name's box that are looked at, across and up

NOWHERE = np.empty((0, 2))

Side = tuple[int, int]  # of the place: 1 right, 0 or -1 left, and 1 above, 0 or -1 below
Box = tuple[Array, Array]  # its lower left and its upper right corner


def label_beside(q: Array, name: str, colour: str, world: World, ax: Axes) -> Artist:
    """Write a name next to a place, on a side without obstacles, or else where there is room."""
    text = write_name(q, name, colour, roomy_side(q, world.lo, world.hi), ax)
    ax.apply_aspect()
    for side in sides_of(text):
        if is_in_the_open(box_of(text, offset_on(side), ax), world, ax):
            put(text, side)
            break
    return text


def is_in_the_open(box: Box, world: World, ax: Axes) -> bool:
    """Whether a box lies in a world and covers no obstacle, as far as a grid of places tells."""
    if not isinstance(world, PolygonWorldRecord | TerrainRecord):
        return True
    x, y = (np.linspace(low, high, n) for low, high, n in zip(*box, GRID))
    grid = np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)
    places = ax.transData.inverted().transform(grid * ax.figure.dpi / 72.0)
    return bool(free_configurations(Point(), world, places).all())


def roomy_side(q: ArrayLike, low: ArrayLike, high: ArrayLike) -> Side:
    """The side of a place where a box from `low` to `high` has room for a name."""
    share = (np.asarray(q)[:2] - np.asarray(low)) / (np.asarray(high) - np.asarray(low))
    return (1 if share[0] < 0.75 else -1, 1 if share[1] < 0.85 else -1)


def write_name(q: ArrayLike, name: str, colour: str, side: Side, ax: Axes) -> Annotation:
    """Write a name on a side of a place (x, y)."""
    x, y = np.asarray(q, float)[:2]
    style: Style = {"color": colour, "path_effects": HALO, "zorder": 8, **palette.BOLD}
    plain = without_formulas(name)
    text = ax.annotate(plain, (x, y), (0, 0), textcoords=OFFSET, gid=NAME, **style)
    put(text, side)
    return text


def write_beside_names(q: ArrayLike, name: str, colour: str, ax: Axes) -> Annotation:
    """Write a name on the first side of a place (x, y) where no name is."""
    written = [one for one in ax.texts if isinstance(one, Annotation) and one.get_gid() == NAME]
    text = write_name(q, name, colour, (1, 1), ax)
    others = [box_of(one, one.xyann, ax) for one in written]
    for side in sides_of(text):
        if not covers(box_of(text, offset_on(side), ax), NOWHERE, others):
            put(text, side)
            break
    return text


def without_formulas(text: str) -> str:
    """A text in which dollar signs are written: two of them would enclose a formula."""
    return text.replace("$", r"\$")


def put(text: Annotation, side: Side) -> None:
    """Put a name on a side of its place."""
    right, up = side
    text.set(ha=("center", "left", "right")[right], va=("center", "bottom", "top")[up])
    text.xyann = offset_on(side)


def offset_on(side: Side) -> tuple[float, float]:
    """The offset of a name on a side of its place, in points."""
    right, up = side
    return APART * right, APART * up


def move_names_off(line: Array, ax: Axes) -> None:
    """Put names that a line (n, 2) or another text covers on a side where nothing does."""
    move_names_off_points(spread(line), ax)


def move_names_off_points(points: Array, ax: Axes, path: Array = NOWHERE) -> None:
    """Put names that cover a point of some (n, 2), or another text, on a side where they do not.

    Where there is no such side, a name that covers a point of `path` (m, 2) is put where it covers
    none of these, and few others. If it can be, no place of another name is nearer to a name that
    is moved than its own place.
    """
    ax.apply_aspect()
    passed, way = (in_points(lines, ax.transData, ax) for lines in (points, path))
    low, high = in_points(np.array([[0, 0], [1, 1]]), ax.transAxes, ax)
    texts = [text for text in ax.texts if isinstance(text, Annotation) and text.get_text()]
    beside = [text for text in texts if text.anncoords == OFFSET]
    for text in beside:
        if text.get_gid() == NAME:
            others = [box_of(one, one.xyann, ax) for one in beside if one is not text]
            boxes = {side: box_of(text, offset_on(side), ax) for side in sides_of(text)}
            within = [side for side, box in boxes.items() if is_within(box, (low, high))]
            free = [side for side in within if not covers(boxes[side], passed, others)]
            here = sides_of(text)[0]
            if not free and covers(boxes[here], way, []):
                free = [side for side in within if not covers(boxes[side], way, others)]
                free.sort(key=lambda side: count_within(boxes[side], passed))
            clear = [s for s in free if s == here or is_nearest(text, boxes[s], beside, ax)]
            for side in (clear or free)[:1]:
                put(text, side)


def sides_of(text: Annotation) -> list[Side]:
    """The sides of a place: that of its name, then the corners, then straight beside it."""
    here: Side = tuple(np.sign(text.xyann).astype(int).tolist())
    right, up = here[0] or 1, here[1] or 1
    across = [(right, up), (right, -up), (-right, up), (-right, -up)]
    return [here, *across, (right, 0), (0, up), (0, -up), (-right, 0)]


def is_nearest(text: Annotation, box: Box, texts: list[Annotation], ax: Axes) -> bool:
    """Whether no place of another name is nearer to a text's box than its own place."""
    own, *others = in_points(
        np.array([text.xy, *(one.xy for one in texts if one.get_gid() == NAME)]), ax.transData, ax
    )
    return all(distance_to(box, own) <= distance_to(box, other) + 1e-9 for other in others)


def distance_to(box: Box, point: Array) -> float:
    """The distance between a box and a point."""
    low, high = box
    return float(np.hypot(*np.maximum(0.0, np.maximum(low - point, point - high))))


def is_within(inner: Box, outer: Box) -> bool:
    """Whether a box lies in another."""
    return bool((inner[0] >= outer[0]).all() and (inner[1] <= outer[1]).all())


def covers(box: Box, points: Array, others: list[Box]) -> bool:
    """Whether a box covers one of some points (n, 2), or a part of another box."""
    low, high = box
    is_near = any((low < b).all() and (a < high).all() for a, b in others)
    return is_near or count_within(box, points) > 0


def count_within(box: Box, points: Array) -> int:
    """How many of some points (n, 2) a box covers."""
    low, high = box
    return int(((low < points) & (points < high)).all(axis=1).sum())


def in_points(line: Array, transform: Transform, ax: Axes) -> Array:
    """A line (n, 2) in points of the figure, each 1/72 inch."""
    pixels: Array = transform.transform(line)
    return pixels * 72.0 / ax.figure.dpi


def spread(line: Array) -> Array:
    """Places along a line, evenly, (n, 2)."""
    if len(line) < 2:
        return line
    return points_at_fractions(line, np.linspace(0.0, 1.0, STEPS))


def box_of(text: Annotation, offset: tuple[float, float], ax: Axes) -> Box:
    """About the box that a text fills at an offset from its place, in points."""
    size = np.array([WIDTH * len(text.get_text()), 1.0]) * text.get_fontsize()
    corner = in_points(np.array([text.xy]), ax.transData, ax)[0] + offset
    low = corner + size * (np.sign(offset) - 1.0) / 2.0
    return low, low + size
