"""The contents of matplotlib axes as plain numbers and text, which another process can judge."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ..messages import get_message
from ..support.json_fields import JsonObject
from .plain import wrong_shape
from .shapes import Listed, Numbers, Record, Shape, Text, Value

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
    """The shape of an answer that is a drawing in matplotlib axes.

    The decoded value is a dict. `lines`, `dots` and `polygons` are lists; each entry has points (n,
    2) in data coordinates, a label, and a colour "#rrggbb" or "none". `title`, `x_label`, `y_label`
    and `texts` are text. Dots of several colours make one entry per colour. Round patches are
    polygons with many vertices.
    """

    @property
    def description(self) -> str:
        """Description of the shape, for messages."""
        return get_message("shape.drawn")

    def load(self) -> None:
        """Load matplotlib, so that it takes no time of a student's program."""
        from ..figures.plane import plane_figure

        plane_figure()

    def encode(self, value: Value) -> JsonObject:
        """Encode axes, a figure with one pair of axes, or a value that was decoded before.

        Raises
        ------
        WrongShape
        """
        if type(value) is dict:
            return PLOT.encode(value)
        if hasattr(value, "axes") and isinstance(value.axes, list) and len(value.axes) == 1:
            value = value.axes[0]
        if not all(
            hasattr(value, name) for name in ("lines", "collections", "patches", "get_title")
        ):
            raise wrong_shape(self.description, value)
        solid = [line for line in value.lines if line.get_linestyle() not in ("None", "")]
        dotted = [line for line in value.lines if line not in solid]
        lines = [curve_data(line.get_xydata(), line, line.get_color()) for line in solid]
        dots = [curve_data(line.get_xydata(), line, line.get_markerfacecolor()) for line in dotted]
        for group in value.collections:
            lines += line_segments(group)
            dots += scatter_dots(group)
        polygons = [
            curve_data(patch_vertices(patch), patch, patch.get_facecolor())
            for patch in value.patches
        ]
        plot = {
            "lines": lines,
            "dots": dots,
            "polygons": polygons,
            "title": value.get_title(),
            "x_label": value.get_xlabel(),
            "y_label": value.get_ylabel(),
            "texts": [text.get_text() for text in value.texts],
        }
        return PLOT.encode(plot)

    def decode(self, data: object) -> JsonObject:
        """Decode into a dict of numbers and text. Raises WrongShape."""
        return PLOT.decode(data)


def curve_data(points: ArrayLike, artist: Any, colour: Any) -> JsonObject:
    """Points, label and colour of an artist."""
    from ..figures.palette import hex_of

    return {
        "points": np.asarray(points, float).reshape(-1, 2),
        "label": str(artist.get_label()),
        "colour": hex_of(colour),
    }


def patch_vertices(patch: Any) -> Any:
    """Vertices of a patch in data coordinates, with sixteen points on each arc."""
    path = patch.get_patch_transform().transform_path(patch.get_path())
    if path.codes is None or not np.isin(path.codes, (3, 4)).any():  # no arcs
        return path.vertices
    steps = np.linspace(0.0, 1.0, 17)[1:]
    return np.vstack(
        [arc(steps if len(arc.control_points) > 2 else steps[-1:]) for arc, _ in path.iter_bezier()]
    )


def line_segments(group: Any) -> list[dict[str, Any]]:
    """The line segments of a line collection."""
    if not hasattr(group, "get_segments"):
        return []
    return [curve_data(points, group, "none") for points in group.get_segments()]


def scatter_dots(group: Any) -> list[dict[str, Any]]:
    """The dots of a scatter plot, one entry for each colour."""
    if hasattr(group, "get_segments") or not len(group.get_offsets()):
        return []
    points = np.asarray(group.get_offsets(), float)
    colours = np.asarray(group.get_facecolor(), float)
    if not len(colours):  # unfilled dots
        colours = np.asarray(group.get_edgecolor(), float)
    if not len(colours):
        colours = np.zeros((1, 4))
    own = colours[np.arange(len(points)) % len(colours)]
    kinds, which = np.unique(own, axis=0, return_inverse=True)
    return [
        curve_data(points[which.ravel() == k], group, tuple(kind)) for k, kind in enumerate(kinds)
    ]
