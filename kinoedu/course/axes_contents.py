"""What matplotlib axes hold, as plain lists of numbers and text.

Needs numpy and matplotlib alone.
"""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike


def read_axes(value: Any) -> dict[str, Any] | None:
    """The contents of axes, or of a figure with one pair of axes; None where it is neither."""
    if hasattr(value, "axes") and isinstance(value.axes, list) and len(value.axes) == 1:
        value = value.axes[0]
    if not all(hasattr(value, name) for name in ("lines", "collections", "patches", "get_title")):
        return None
    solid = [line for line in value.lines if is_seen(line)]
    dotted = [line for line in value.lines if str(line.get_marker()) not in ("None", "", " ")]
    lines = [curve_data(line_vertices(line), line, line.get_color()) for line in solid]
    dots = [curve_data(line_vertices(line), line, line.get_markerfacecolor()) for line in dotted]
    for group in value.collections:
        lines += line_segments(group)
        dots += scatter_dots(group)
    polygons = [
        curve_data(patch_vertices(patch), patch, patch.get_facecolor()) for patch in value.patches
    ]
    return {
        "lines": lines,
        "dots": dots,
        "polygons": polygons,
        "title": value.get_title(),
        "x_label": value.get_xlabel(),
        "y_label": value.get_ylabel(),
        "texts": [text.get_text() for text in value.texts],
    }


def is_seen(line: Any) -> bool:
    """Whether a line is drawn between its points."""
    return line.get_linestyle() not in ("None", "") and line.get_linewidth() > 0.0


def hex_of(colour: Any) -> str:
    """A matplotlib colour as "#rrggbb", or "none" where it is none or fully transparent.

    Examples
    --------
    >>> hex_of("red"), hex_of((0, 0, 1, 0.5)), hex_of("none")
    ('#ff0000', '#0000ff', 'none')
    """
    from matplotlib.colors import to_hex, to_rgba

    red, green, blue, opacity = to_rgba(colour)
    return to_hex((red, green, blue)) if opacity > 0.0 else "none"


def curve_data(points: ArrayLike, artist: Any, colour: Any) -> dict[str, Any]:
    """Points, label and colour of an artist."""
    return {
        "points": np.asarray(points, float).reshape(-1, 2),
        "label": str(artist.get_label()),
        "colour": hex_of(colour),
    }


def to_data(artist: Any) -> Any:
    """The transform to data coordinates, which moves or turns an artist that has one of its own."""
    return artist.get_transform() - artist.axes.transData


def line_vertices(line: Any) -> Any:
    """Points of a line in data coordinates."""
    return to_data(line).transform(line.get_xydata())


def patch_vertices(patch: Any) -> Any:
    """Vertices of a patch in data coordinates, with sixteen points on each arc."""
    path = to_data(patch).transform_path(patch.get_path())
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
    group.update_scalarmappable()  # colours by numbers, which are otherwise mapped when drawn
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
