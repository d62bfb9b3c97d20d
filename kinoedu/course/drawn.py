"""The data of a plot: what was drawn in matplotlib axes, as numbers and words that can be judged in
another process.
"""

from typing import Any, NamedTuple

import numpy as np

from ..words import say
from .plain import wrong
from .shapes import Listed, Numbers, Record, Shape, Text

CURVE: Shape = Record(points=Numbers(("n", 2)), label=Text(), colour=Text())
PLOT = Record(
    lines=Listed(CURVE),
    dots=Listed(CURVE),
    polygons=Listed(CURVE),
    title=Text(),
    x_label=Text(),
    y_label=Text(),
    texts=Listed(Text()),
)


class Drawn(NamedTuple):
    """The artists of matplotlib axes. Decoded, a dict: lines, dots and polygons, each with points
    (n, 2) in data coordinates and a label and a colour, "#rrggbb" or "none"; title, x_label,
    y_label and texts. Dots of several colours are as many entries. Round patches are polygons of
    many vertices.
    """

    @property
    def words(self) -> str:
        """In words."""
        return say("shape.drawn")

    def encode(self, value: Any) -> dict[str, Any]:
        """From the axes, or from a figure with one pair of axes; what has been decoded is encoded
        as it was.
        """
        if type(value) is dict:
            return PLOT.encode(value)
        if hasattr(value, "axes") and isinstance(value.axes, list) and len(value.axes) == 1:
            value = value.axes[0]
        if not all(
            hasattr(value, name) for name in ("lines", "collections", "patches", "get_title")
        ):
            raise wrong(self.words, value)
        solid = [line for line in value.lines if line.get_linestyle() not in ("None", "")]
        dotted = [line for line in value.lines if line not in solid]
        groups = value.collections
        plot = {
            "lines": [curve(line.get_xydata(), line, line.get_color()) for line in solid]
            + [c for group in groups for c in segments(group)],
            "dots": [curve(line.get_xydata(), line, line.get_markerfacecolor()) for line in dotted]
            + [c for group in groups for c in scattered(group)],
            "polygons": [
                curve(corners(patch), patch, patch.get_facecolor()) for patch in value.patches
            ],
            "title": value.get_title(),
            "x_label": value.get_xlabel(),
            "y_label": value.get_ylabel(),
            "texts": [text.get_text() for text in value.texts],
        }
        return PLOT.encode(plot)

    def decode(self, data: Any) -> dict[str, Any]:
        """The numbers and words."""
        return PLOT.decode(data)


def curve(points: Any, artist: Any, colour: Any) -> dict[str, Any]:
    """An artist's points, its label and its colour."""
    from ..figures.palette import hex_of

    return {
        "points": np.asarray(points, float).reshape(-1, 2),
        "label": str(artist.get_label()),
        "colour": hex_of(colour),
    }


def corners(patch: Any) -> Any:
    """A patch's vertices, in data coordinates; along an arc sixteen of them."""
    path = patch.get_patch_transform().transform_path(patch.get_path())
    if path.codes is None or not np.isin(path.codes, (3, 4)).any():  # no arcs
        return path.vertices
    steps = np.linspace(0.0, 1.0, 17)[1:]
    return np.vstack(
        [arc(steps if len(arc.control_points) > 2 else steps[-1:]) for arc, _ in path.iter_bezier()]
    )


def segments(group: Any) -> list[dict[str, Any]]:
    """The lines of a collection of lines."""
    return (
        [curve(points, group, "none") for points in group.get_segments()]
        if hasattr(group, "get_segments")
        else []
    )


def scattered(group: Any) -> list[dict[str, Any]]:
    """The dots of a scatter plot, those of each colour together."""
    if hasattr(group, "get_segments") or not len(group.get_offsets()):
        return []
    points, colours = (
        np.asarray(group.get_offsets(), float),
        np.asarray(group.get_facecolor(), float),
    )
    if not len(colours):  # dots that are rings
        colours = np.asarray(group.get_edgecolor(), float)
    own = (
        colours[np.arange(len(points)) % len(colours)]
        if len(colours)
        else np.zeros((len(points), 4))
    )
    kinds, which = np.unique(own, axis=0, return_inverse=True)
    return [curve(points[which.ravel() == k], group, tuple(kind)) for k, kind in enumerate(kinds)]
