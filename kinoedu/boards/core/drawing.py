"""What a board answers: a drawing, made of layers of lines, dots, arrows and words.

A layer that *grows* says for each of its rows at which step it came, and perhaps at which it went,
so that the board can show the drawing as it was then. Colours go by their names in
`kinoedu.figures.palette`, in small letters.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ...geometry.checks import Array

POINTS = {
    "edges": 2,
    **dict.fromkeys(("path", "dots", "arrows", "labels", "eye"), 1),
}  # that begin each row; a polygon's are all


class Layer(NamedTuple):
    """Rows of numbers and how they look; the functions below make it.

    rows : edges x, y, next x, next y; path, dots, labels x, y; arrows x, y, dx, dy; an eye x, y,
        width; cells and bodies all corners.
    when : for each row the step at which it came, not decreasing; None where all is there from the
        beginning.
    until : for each row the step at which it is gone again; None where all stays.
    last : it is shown only when everything else has grown. hatched : of bodies, with stripes.
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

    @property
    def points(self) -> int:
        """How many points begin each row."""
        return POINTS.get(self.kind, self.rows.shape[1] // 2)


@dataclass(frozen=True, eq=False)
class Drawing:
    """A board's answer to a scene.

    text : what the picture shows; warning : what is wrong instead. One of them is read out.
    total : how many steps the growth has, 0 for none; unit : what a step is, in words.
    told : the text at each step before the last, from step 0; left out, the board counts the steps.
    places : where the answer puts things, each (kind, number, coordinates) as in `moved`; not out
        of a hand that holds them.
    """

    layers: Sequence[Layer] = ()
    text: str = ""
    warning: str = ""
    total: int = 0
    unit: str = ""
    told: Sequence[str] = ()
    places: Sequence[tuple[str, int, Any]] = ()

    @property
    def says(self) -> str:
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
    """Segments, shape (m, 2, 2)."""
    return Layer(
        "edges",
        rows_of(segments, 4),
        colour,
        width,
        tuple(dash),
        steps_of(when),
        until=steps_of(until),
    )


def path(
    points: ArrayLike,
    colour: str,
    *,
    width: float = 3.0,
    dash: Sequence[float] = (),
    casing: bool = True,
) -> Layer:
    """A line through points, shape (n, 2), on a dark casing; shown when everything has grown."""
    return Layer("path", rows_of(points, 2), colour, width, tuple(dash), last=True, casing=casing)


def dots(
    points: ArrayLike,
    colour: str,
    *,
    radius: float = 2.0,
    when: ArrayLike | None = None,
    until: ArrayLike | None = None,
) -> Layer:
    """Dots, shape (n, 2), of a radius in pixels."""
    return Layer(
        "dots", rows_of(points, 2), colour, radius, when=steps_of(when), until=steps_of(until)
    )


def arrows(
    begins: ArrayLike,
    vectors: ArrayLike,
    colour: str,
    *,
    width: float = 3.0,
    when: ArrayLike | None = None,
    until: ArrayLike | None = None,
) -> Layer:
    """Arrows from points (n, 2) along vectors (n, 2), in the world's unit."""
    rows = np.hstack([rows_of(begins, 2), rows_of(vectors, 2)])
    return Layer("arrows", rows, colour, width, when=steps_of(when), until=steps_of(until))


def labels(
    points: ArrayLike, texts: Sequence[str], colour: str, *, when: ArrayLike | None = None
) -> Layer:
    """Words beside points, shape (n, 2)."""
    return Layer("labels", rows_of(points, 2), colour, texts=tuple(texts), when=steps_of(when))


def cells(
    corners: ArrayLike,
    colour: str,
    *,
    when: ArrayLike | None = None,
    until: ArrayLike | None = None,
) -> Layer:
    """Filled polygons of k corners each, shape (n, k, 2), beneath obstacles and all other
    layers.
    """
    return Layer("cells", outlines(corners), colour, when=steps_of(when), until=steps_of(until))


def bodies(
    corners: ArrayLike,
    colour: str,
    *,
    hatched: bool = False,
    when: ArrayLike | None = None,
    until: ArrayLike | None = None,
) -> Layer:
    """Polygons of k corners each, shape (n, k, 2), over everything else: an outline, a tint, and
    stripes where they are hatched.
    """
    return Layer(
        "bodies",
        outlines(corners),
        colour,
        2.0,
        when=steps_of(when),
        until=steps_of(until),
        hatched=hatched,
    )


def eye(points: ArrayLike, width: float, *, when: ArrayLike) -> Layer:
    """What is seen of the world from each step on: a stretch of a width, in the world's unit, with
    a point (n, 2) in its middle.
    """
    middles = rows_of(points, 2)
    return Layer(
        "eye", np.column_stack([middles, np.full(len(middles), width)]), "ink", when=steps_of(when)
    )


def outlines(corners: ArrayLike) -> Array:
    """Polygons of k corners each, shape (n, k, 2), as rows."""
    shapes = np.asarray(corners, np.float64)
    return rows_of(shapes, 2 * shapes.shape[1])


def rows_of(values: ArrayLike, columns: int) -> Array:
    """Numbers as rows."""
    return np.asarray(values, np.float64).reshape(-1, columns)


def steps_of(when: ArrayLike | None) -> Array | None:
    """Steps as numbers."""
    return None if when is None else np.asarray(when, np.float64)


def encoded(drawing: Drawing, lo: ArrayLike, size: float) -> tuple[dict[str, Any], list[bytes]]:
    """A drawing as a message and a buffer of float32 for each layer: places as multiples of `size`
    from the corner lo, a row's steps at its end.
    """
    about = [
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
        }
        for layer in drawing.layers
    ]
    buffers, corner = [], np.asarray(lo, np.float64)
    for layer in drawing.layers:
        rows = layer.rows / size
        for k in range(layer.points):
            rows[:, 2 * k : 2 * k + 2] = (layer.rows[:, 2 * k : 2 * k + 2] - corner) / size
        whole = np.column_stack(
            [rows, *(steps for steps in (layer.when, layer.until) if steps is not None)]
        )
        buffers.append(whole.astype(np.float32).tobytes())
    words = {
        "text": drawing.text,
        "warning": drawing.warning,
        "unit": drawing.unit,
        "told": list(drawing.told),
    }
    places = [[kind, number, np.asarray(where).tolist()] for kind, number, where in drawing.places]
    return {"layers": about, "total": drawing.total, "places": places, **words}, buffers
