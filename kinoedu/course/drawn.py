"""The data of a plot: what was drawn in matplotlib axes, as numbers and words that can be judged in another process."""

from typing import Any, NamedTuple

import numpy as np

from ..words import say
from .plain import wrong
from .shapes import Listed, Numbers, Record, Shape, Text

CURVE: Shape = Record(points=Numbers(("n", 2)), label=Text())
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
    """The artists of matplotlib axes. Decoded, a dict: lines, dots and polygons, each with points (n, 2) in data coordinates and a
    label; title, x_label, y_label and texts.
    """

    @property
    def words(self) -> str:
        """In words."""
        return say("shape.drawn")

    def encode(self, value: Any) -> dict[str, Any]:
        """From the axes, or from a figure with one pair of axes."""
        if hasattr(value, "axes") and isinstance(value.axes, list) and len(value.axes) == 1:
            value = value.axes[0]
        if not all(hasattr(value, name) for name in ("lines", "collections", "patches", "get_title")):
            raise wrong(self.words, value)
        solid = [line for line in value.lines if line.get_linestyle() not in ("None", "")]
        dotted = [line for line in value.lines if line not in solid]
        groups = value.collections
        plot = {
            "lines": [curve(line.get_xydata(), line) for line in solid] + [c for group in groups for c in segments(group)],
            "dots": [curve(line.get_xydata(), line) for line in dotted] + [c for group in groups for c in scattered(group)],
            "polygons": [curve(corners(patch), patch) for patch in value.patches],
            "title": value.get_title(),
            "x_label": value.get_xlabel(),
            "y_label": value.get_ylabel(),
            "texts": [text.get_text() for text in value.texts],
        }
        return PLOT.encode(plot)

    def decode(self, data: Any) -> dict[str, Any]:
        """The numbers and words."""
        return PLOT.decode(data)


def curve(points: Any, artist: Any) -> dict[str, Any]:
    """An artist's points and its label."""
    return {"points": np.asarray(points, float).reshape(-1, 2), "label": str(artist.get_label())}


def corners(patch: Any) -> Any:
    """A patch's vertices, in data coordinates."""
    return patch.get_patch_transform().transform_path(patch.get_path()).vertices


def segments(group: Any) -> list[dict[str, Any]]:
    """The lines of a collection of lines."""
    return [curve(points, group) for points in group.get_segments()] if hasattr(group, "get_segments") else []


def scattered(group: Any) -> list[dict[str, Any]]:
    """The dots of a scatter plot."""
    return [curve(group.get_offsets(), group)] if not hasattr(group, "get_segments") and len(group.get_offsets()) else []
