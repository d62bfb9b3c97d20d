"""A board's answer: a drawing, made of layers of lines, dots, arrows and texts.

A layer that *grows* gives for each row the step at which it appears, and possibly the step at
which it disappears, so that the board can show earlier states of the drawing. Colours are the
names in `kinoedu.figures.palette`, in small letters.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ...errors import InvalidParameter
from ...geometry.checks import Array
from ...support.constructors import with_type_names
from ...support.json_fields import JsonObject
from ...support.text import shortened
from .listing import Listing, encode_listing
from .scene import check_colour

# The number of points that begin each row; the rows of polygons consist of points.
POINTS = {"edges": 2, "path": 1, "dots": 1, "nodes": 1, "arrows": 1, "labels": 1, "eye": 1}


@with_type_names
class Layer(NamedTuple):
    """Rows of numbers and their style; made by the functions below.

    Attributes
    ----------
    rows : edges x, y, next x, next y; path, dots, nodes and labels x, y; arrows x, y, dx, dy; an
        eye x, y, width; cells and bodies all corners.
    when : for each row the step at which it appears, not decreasing; None where all rows are there
        from the beginning.
    until : for each row the step at which it disappears; None where all rows stay.
    last : whether the layer is shown only when everything else has grown.
    casing : whether a path lies on a dark line, and dots have a ring where a handle hides them.
    hatched : whether bodies have stripes.
    says, names, notes : what a row says when one points at it; see `notes.py`.
    """

    kind: str
    rows: Array
    colour: str
    width: float = 1.0
    dash: tuple[float, ...] = ()
    when: Array | None = None
    last: bool = False
    casing: bool = False
    texts: tuple[str, ...] = ()
    until: Array | None = None
    hatched: bool = False
    says: tuple[str, ...] = ()
    names: tuple[str, ...] = ()
    notes: Array | None = None

    @property
    def points(self) -> int:
        """How many points begin each row."""
        return POINTS.get(self.kind, self.rows.shape[1] // 2)

    def at(self, step: int) -> Layer:
        """The layer as it is seen at a step, without notes; it does not grow."""
        there = np.ones(len(self.rows), np.bool_)
        if self.when is not None:
            there &= self.when <= step
        if self.until is not None:
            there &= self.until > step
        texts = tuple(text for text, is_there in zip(self.texts, there) if is_there)
        seen = self._replace(rows=self.rows[there], texts=texts, when=None, until=None)
        return seen._replace(says=(), names=(), notes=None)


@dataclass(frozen=True, eq=False)
class Drawing:
    """A board's answer to a scene.

    Attributes
    ----------
    layers : what is drawn, the lowest first.
    text : what the picture shows. It is read out, unless there is a warning.
    warning : what is wrong; it replaces the text. Without layers the last drawing stays, pale.
    total : the number of steps of the growth, 0 for none.
    unit : the unit of a step, in words.
    step_texts : the text at each step before the last, from step 0; without them the board shows
        the number of the step.
    listing : the code beside the picture; then each step is a line that has run.
    first : the step that is shown at first; None for the last one.
    places : where the answer moves things, each (kind, number, coordinates) as in `move_parts`;
        things that are being dragged are not moved.
    whole : makes the same drawing with all that only scrubbing and pointing need, where that takes
        long. It is called when nothing is dragged any more.
    unfinished : whether `whole` has a further result, which challenges are judged by too.
    """

    layers: Sequence[Layer] = ()
    text: str = ""
    warning: str = ""
    total: int = 0
    unit: str = ""
    step_texts: Sequence[str] = ()
    listing: Listing | None = None
    first: int | None = None
    places: Sequence[tuple[str, int, Any]] = ()
    whole: Callable[[], Drawing] | None = None
    unfinished: bool = False

    def at_end(self) -> Drawing:
        """The drawing as it is seen at its last step; itself where that is all, or has code."""
        if self.total == 0 or self.listing is not None:
            return self
        seen = [one if one.kind == "eye" else one.at(self.total) for one in self.layers]
        layers = [layer for layer in seen if layer.kind != "nodes"]
        return replace(self, layers=layers, step_texts=())

    def completed_by(self, whole: Callable[[], Drawing]) -> Drawing:
        """This drawing while something is dragged, and another one when nothing is."""
        return replace(self, whole=whole)

    def with_texts(self, describe: Callable[[], Sequence[str]]) -> Drawing:
        """This drawing, whose texts of earlier steps are made when nothing is dragged."""
        return self.completed_by(lambda: replace(self, step_texts=describe()))

    @property
    def completed(self) -> Drawing:
        """The drawing when nothing is dragged; itself where that is all."""
        return self if self.whole is None else self.whole()

    @property
    def message(self) -> str:
        """The warning, or else the text."""
        return self.warning or self.text


def edges(
    segments: ArrayLike,
    colour: str,
    *,
    width: float = 1.2,
    dash: Sequence[float] = (),
    when: ArrayLike | None = None,
    until: ArrayLike | None = None,
) -> Layer:
    """A layer of segments, shape (m, 2, 2)."""
    rows, dashes = as_rows(segments, 4), tuple(dash)
    return Layer("edges", rows, colour, width, dashes, as_steps(when), until=as_steps(until))


def path_edges(
    segments: ArrayLike, *, when: ArrayLike | None = None, until: ArrayLike | None = None
) -> list[Layer]:
    """Segments (m, 2, 2) in the style of a path, on a dark casing; unlike a path they may grow."""
    return [
        edges(segments, colour, width=width, when=when, until=until)
        for colour, width in (("ink", 5.0), ("path", 3.0))
    ]


def path(
    points: ArrayLike,
    colour: str,
    *,
    width: float = 3.0,
    dash: Sequence[float] = (),
    casing: bool = True,
) -> Layer:
    """A line through points, shape (n, 2), on a dark casing; shown when everything has grown."""
    return Layer("path", as_rows(points, 2), colour, width, tuple(dash), last=True, casing=casing)


def dots(
    points: ArrayLike,
    colour: str,
    *,
    radius: float = 2.0,
    when: ArrayLike | None = None,
    until: ArrayLike | None = None,
) -> Layer:
    """Dots at points, shape (n, 2); the radius is in pixels."""
    rows = as_rows(points, 2)
    return Layer("dots", rows, colour, radius, when=as_steps(when), until=as_steps(until))


def nodes(
    points: ArrayLike,
    reach: float = 0.02,
    *,
    when: ArrayLike | None = None,
    until: ArrayLike | None = None,
) -> Layer:
    """Points that are not painted, shape (n, 2), for their notes.

    reach : how near a pointer must come, as a share of the world's size.
    """
    layer = Layer("nodes", as_rows(points, 2), "ink", reach)
    return layer._replace(when=as_steps(when), until=as_steps(until))


def arrows(
    begins: ArrayLike,
    vectors: ArrayLike,
    colour: str,
    *,
    width: float = 3.0,
    when: ArrayLike | None = None,
    until: ArrayLike | None = None,
) -> Layer:
    """Arrows from points (n, 2) along vectors (n, 2), in the unit of the world."""
    rows = np.hstack([as_rows(begins, 2), as_rows(vectors, 2)])
    return Layer("arrows", rows, colour, width, when=as_steps(when), until=as_steps(until))


def labels(
    points: ArrayLike,
    texts: Sequence[str],
    colour: str,
    *,
    when: ArrayLike | None = None,
    until: ArrayLike | None = None,
) -> Layer:
    """Texts beside points, shape (n, 2)."""
    layer = Layer("labels", as_rows(points, 2), colour, texts=tuple(texts))
    return layer._replace(when=as_steps(when), until=as_steps(until))


def cells(
    corners: ArrayLike,
    colour: str,
    *,
    when: ArrayLike | None = None,
    until: ArrayLike | None = None,
) -> Layer:
    """Filled polygons of k corners each, shape (n, k, 2), beneath obstacles and other layers."""
    return Layer("cells", polygon_rows(corners), colour, when=as_steps(when), until=as_steps(until))


def bodies(
    corners: ArrayLike,
    colour: str,
    *,
    hatched: bool = False,
    when: ArrayLike | None = None,
    until: ArrayLike | None = None,
) -> Layer:
    """Outlined and tinted polygons of k corners each, shape (n, k, 2), above everything else.

    Hatched ones have stripes too.
    """
    layer = Layer("bodies", polygon_rows(corners), colour, 2.0, hatched=hatched)
    return layer._replace(when=as_steps(when), until=as_steps(until))


def eye(points: ArrayLike, width: float, *, when: ArrayLike) -> Layer:
    """The part of the world that is shown from each step on.

    Parameters
    ----------
    points : (n, 2), the middle of the part shown.
    width : its width, in the unit of the world.
    when : (n,), the step from which each applies.
    """
    middles = as_rows(points, 2)
    rows = np.column_stack([middles, np.full(len(middles), width)])
    return Layer("eye", rows, "ink", when=as_steps(when))


def segments_along(points: Array) -> Array:
    """A line through points (n, 2) as segments, shape (n - 1, 2, 2)."""
    return np.stack([points[:-1], points[1:]], axis=1)


def sides_of(ring: Array) -> Array:
    """The sides of a polygon (n, 2) as segments, shape (n, 2, 2)."""
    return np.stack([ring, np.roll(ring, -1, axis=0)], axis=1)


def polygon_rows(corners: ArrayLike) -> Array:
    """Polygons of k corners each, shape (n, k, 2), as rows."""
    shapes = np.asarray(corners, np.float64)
    return as_rows(shapes, 2 * shapes.shape[1])


def as_rows(values: ArrayLike, columns: int) -> Array:
    """Numbers as rows of a given number of columns."""
    return np.asarray(values, np.float64).reshape(-1, columns)


def as_steps(when: ArrayLike | None) -> Array | None:
    """Steps as an array of numbers, or None."""
    return None if when is None else np.asarray(when, np.float64)


def check_layers(layers: Sequence[Layer]) -> None:
    """Check what neither a page nor a picture could draw.

    Raises
    ------
    InvalidParameter
        For a colour that is none of the palette's, or another number of texts or steps than rows.
    """
    for layer in layers:
        check_colour(layer.colour)
        texts = layer.texts if layer.kind == "labels" else None
        for name, values in (("texts", texts), ("when", layer.when), ("until", layer.until)):
            if values is not None and np.shape(values) != (len(layer.rows),):
                raise InvalidParameter(
                    f"each of the {len(layer.rows)} rows of {layer.kind} needs one of {name}, got "
                    f"{shortened(values)}"
                )


def encode_drawing(drawing: Drawing, lo: ArrayLike, size: float) -> tuple[JsonObject, list[bytes]]:
    """A drawing as a message and a buffer of float32 for each layer.

    Coordinates are sent as multiples of `size` from the corner `lo`; the notes of a row follow its
    coordinates, then come its steps.
    """
    about: list[JsonObject] = [
        {
            "kind": layer.kind,
            "colour": layer.colour,
            "width": layer.width,
            "dash": list(layer.dash),
            "grows": layer.when is not None,
            "ends": layer.until is not None,
            "last": layer.last,
            "casing": layer.casing,
            "texts": list(layer.texts),
            "points": layer.points,
            "hatched": layer.hatched,
            **({"says": list(layer.says), "names": list(layer.names)} if layer.says else {}),
        }
        for layer in drawing.layers
    ]
    buffers, corner = [], np.asarray(lo, np.float64)
    for layer in drawing.layers:
        shift = np.zeros(layer.rows.shape[1])  # sizes and directions are not relative to the corner
        shift[: 2 * layer.points] = np.tile(corner, layer.points)
        further = [f for f in (layer.notes, layer.when, layer.until) if f is not None]
        columns = np.column_stack([(layer.rows - shift) / size, *further])
        buffers.append(columns.astype(np.float32).tobytes())
    places = [[kind, number, np.asarray(where).tolist()] for kind, number, where in drawing.places]
    message = {
        "layers": about,
        "total": drawing.total,
        "places": places,
        "text": drawing.text,
        "warning": drawing.warning,
        "unit": drawing.unit,
        "step_texts": list(drawing.step_texts),
        "listing": encode_listing(drawing.listing),
        "first": drawing.first,
    }
    return message, buffers
