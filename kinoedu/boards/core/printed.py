"""A board as a picture, for readers without JavaScript: the same scene, the same layers, drawn by
matplotlib.
"""

import io
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure
from matplotlib.patches import Circle, PathPatch
from PIL import Image, ImageColor

from ...figures import palette
from ...geometry.checks import Array
from ...figures.drawing import HALO, compound
from .drawing import Drawing, Layer
from .scene import Scene

DPI = (72, 54)  # dots an inch; the smaller where the picture would take more than ENOUGH bytes
ACROSS = 2  # pictures in a row: of more the words would be too small on a page
ENOUGH = 44_000  # a notebook with a dozen boards stays small


def printed(scene: Scene, drawing: Drawing, free: Any = None) -> bytes:
    """A board's scene and what was answered, as a PNG; `free` is the bitmap beneath."""
    (x0, y0), (x1, y1) = scene["lo"], scene["hi"]
    size, margin = max(x1 - x0, y1 - y0), 0.01 * max(x1 - x0, y1 - y0)
    width, height = max(6.0 * (x1 - x0) / size, 2.2) + 1.0, max(6.0 * (y1 - y0) / size, 2.2) + 1.0
    figure = Figure(figsize=(width, height), dpi=DPI[0], layout="constrained")
    FigureCanvasAgg(figure)
    ax = figure.add_subplot()
    ax.set(aspect="equal", xlim=(x0 - margin, x1 + margin), ylim=(y0 - margin, y1 + margin))
    ax.set_title(drawing.says, fontsize=palette.TEXT_SIZE, wrap=True)
    ax.tick_params(labelsize=palette.TEXT_SIZE - 1)
    print_world(scene, free, ax)
    for layer in drawing.layers:
        print_layer(layer, ax, drawing.total)
    print_handles(scene, ax)
    for x, y, seen in (layer.rows[-1] for layer in drawing.layers if layer.kind == "eye"):
        half_x, half_y = 0.5 * seen * (x1 - x0) / size, 0.5 * seen * (y1 - y0) / size
        ax.set(xlim=(x - half_x, x + half_x), ylim=(y - half_y, y + half_y))
    if not scene.get("ticks", True):
        ax.set_axis_off()
    pictures = (with_few_colours(figure, dpi) for dpi in DPI)
    return next(
        (picture for picture in pictures if len(picture) <= ENOUGH),
        with_few_colours(figure, DPI[-1]),
    )


def with_few_colours(figure: Figure, dpi: int) -> bytes:
    """A figure as a PNG in the course's colours and their mixtures: a quarter of the size, and no
    colour lost.
    """
    stream, small = io.BytesIO(), io.BytesIO()
    figure.savefig(stream, format="png", dpi=dpi)
    own = Image.new("P", (1, 1))
    own.putpalette(mixtures())
    Image.open(stream).convert("RGB").quantize(palette=own, dither=Image.Dither.NONE).save(
        small, "png", optimize=True
    )
    return small.getvalue()


def mixtures() -> list[int]:
    """The named colours, and each mixed with white, and the lines' with the obstacles': the levels
    red, green, blue of each.
    """
    named = np.array([list(ImageColor.getrgb(colour)) for colour in palette.NAMED.values()])
    lines, solid = (
        [palette.TREE, palette.ROADMAP, palette.PATH],
        np.array(ImageColor.getrgb(palette.OBSTACLE)),
    )
    mixed = [share * named + (1.0 - share) * 255.0 for share in (1.0, 0.75, 0.5, 0.25, 0.1)]
    mixed += [0.5 * np.array(ImageColor.getrgb(line)) + 0.5 * solid for line in lines]
    return [int(level) for level in np.unique(np.vstack(mixed).round(), axis=0).ravel()]


def print_world(scene: Scene, free: Any, ax: Axes) -> None:
    """What stands there."""
    if free is not None:
        (x0, y0), (x1, y1) = (scene.get("glued", scene)[corner] for corner in ("lo", "hi"))
        shades = [palette.NAMED[name] for name in scene.get("colours", ("obstacle", "free"))]
        extent, most = (x0, x1, y0, y1), len(shades) - 1
        ax.imshow(
            free,
            origin="lower",
            extent=extent,
            cmap=ListedColormap(shades),
            vmin=0,
            vmax=most,
            interpolation="nearest",
            zorder=0.6,
        )
    if scene["boundary"] is not None:
        ax.set_facecolor(palette.OUTSIDE)
        outline = compound([np.array(scene["boundary"])])
        ax.add_patch(
            PathPatch(outline, facecolor=palette.FREE, edgecolor=palette.OBSTACLE, zorder=0.5)
        )
    for polygon in scene["polygons"]:
        if polygon.get("drawn"):
            continue
        rings = [wound(np.array(ring), inner=k > 0) for k, ring in enumerate(polygon["rings"])]
        ax.add_patch(
            PathPatch(compound(rings), facecolor=palette.OBSTACLE, edgecolor=palette.OBSTACLE)
        )
    for disc in scene["discs"]:
        ax.add_patch(Circle(disc["at"], disc["radius"], facecolor=palette.OBSTACLE))


def wound(ring: np.ndarray, *, inner: bool) -> np.ndarray:
    """A ring counter-clockwise, or clockwise for a room, which is so cut out."""
    x, y = ring.T
    left = (x * np.roll(y, -1) - np.roll(x, -1) * y).sum() > 0.0
    return ring[::-1] if left == inner else ring


def print_layer(layer: Layer, ax: Axes, total: int) -> None:
    """One layer, as it is after the last step."""
    rows = layer.rows if layer.until is None else layer.rows[layer.until > total]
    if len(rows) and layer.kind in PRINTERS:
        PRINTERS[layer.kind](layer, rows, palette.NAMED[layer.colour], ax)


def height(layer: Layer) -> float:
    """What comes last lies on the path, the rest beneath it."""
    return 5.5 if layer.last else 3.0


def dashed(layer: Layer) -> Any:
    """matplotlib's style of line for a layer's dashes."""
    return (0, [2.0 * d / max(layer.width, 1.0) for d in layer.dash]) if layer.dash else "solid"


def print_cells(layer: Layer, rows: Array, colour: str, ax: Axes) -> None:
    """Filled polygons beneath all else."""
    shapes = list(rows.reshape(-1, layer.points, 2))
    ax.add_collection(PolyCollection(shapes, facecolors=colour, edgecolors="none", zorder=0.7))


def print_bodies(layer: Layer, rows: Array, colour: str, ax: Axes) -> None:
    """Outlines, filled so lightly that what lies beneath is seen."""
    shapes, stripes = list(rows.reshape(-1, layer.points, 2)), "////" if layer.hatched else None
    outline: Any = {"edgecolors": colour, "linewidths": layer.width, "hatch": stripes}
    beneath = height(layer) - 0.2
    ax.add_collection(PolyCollection(shapes, facecolors=f"{colour}59", zorder=beneath, **outline))


def print_edges(layer: Layer, rows: Array, colour: str, ax: Axes) -> None:
    """Segments."""
    segments, cap = list(rows.reshape(-1, 2, 2)), "butt" if layer.dash else "round"
    style: Any = {"linewidths": layer.width, "linestyles": dashed(layer), "capstyle": cap}
    ax.add_collection(LineCollection(segments, colors=colour, zorder=height(layer), **style))


def print_path(layer: Layer, rows: Array, colour: str, ax: Axes) -> None:
    """One line through all rows, on a dark one where it has a casing."""
    if layer.casing:
        casing: Any = {"linewidth": layer.width + 2.0, "solid_capstyle": "round"}
        ax.plot(*rows.T, color=palette.INK, zorder=4, **casing)
    ax.plot(*rows.T, color=colour, linewidth=layer.width, linestyle=dashed(layer), zorder=5)


def print_dots(layer: Layer, rows: Array, colour: str, ax: Axes) -> None:
    """Points."""
    style: Any = {"markersize": 1.6 * layer.width, "markeredgewidth": 0.0}
    ax.plot(*rows.T, "o", color=colour, zorder=height(layer) + 0.5, **style)


def print_arrows(layer: Layer, rows: Array, colour: str, ax: Axes) -> None:
    """Arrows; those that grow lie beneath the path."""
    style: Any = {"width": 0.008 * layer.width / 3.0, "zorder": 6.0 if layer.when is None else 3.2}
    ax.quiver(*rows.T, angles="xy", scale_units="xy", scale=1.0, color=colour, **style)


def print_labels(layer: Layer, rows: Array, colour: str, ax: Axes) -> None:
    """Texts beside their points."""
    style: Any = {"fontsize": palette.TEXT_SIZE, "color": colour, "path_effects": HALO}
    for point, text in zip(rows, layer.texts, strict=True):
        offset: Any = {"xytext": (7, 7), "textcoords": "offset points"}
        ax.annotate(text, tuple(point), zorder=8, **offset, **style)


PRINTERS = {
    "cells": print_cells,
    "bodies": print_bodies,
    "edges": print_edges,
    "path": print_path,
    "dots": print_dots,
    "arrows": print_arrows,
    "labels": print_labels,
}


def side_by_side(*pictures: bytes) -> bytes:
    """Pictures in a row, in more rows where they are many, as one PNG."""
    opened = [Image.open(io.BytesIO(picture)).convert("RGB") for picture in pictures]
    rows = [opened[k : k + ACROSS] for k in range(0, len(opened), ACROSS)]
    heights = [max(one.height for one in row) for row in rows]
    whole = Image.new(
        "RGB", (max(sum(one.width for one in row) for row in rows), sum(heights)), "white"
    )
    for number, row in enumerate(rows):
        left, top = 0, sum(heights[:number])
        for one in row:
            whole.paste(one, (left, top + (heights[number] - one.height) // 2))
            left += one.width
    stream = io.BytesIO()
    whole.quantize(64, dither=Image.Dither.NONE).save(stream, "png", optimize=True)
    return stream.getvalue()


def print_handles(scene: Scene, ax: Axes) -> None:
    """The points to drag, with their names; where there are stops, whose own names are above them,
    below.
    """
    low = any(handle.get("stop") for handle in scene["handles"])
    for handle in scene["handles"]:
        if handle.get("stop") or handle.get("drawn"):  # the answer draws it
            continue
        (x, y), colour = handle["at"], palette.NAMED[handle["colour"]]
        if handle["radius"]:
            ax.add_patch(Circle((x, y), handle["radius"], facecolor=colour, alpha=0.35, zorder=6))
        marker, size = ("*", 15) if handle["marker"] == "star" else ("o", 9)
        ax.plot(
            x,
            y,
            marker,
            color=colour,
            markersize=size,
            markeredgecolor="white",
            markeredgewidth=1.2,
            zorder=7,
        )
        style: Any = {
            "fontsize": palette.TEXT_SIZE,
            "fontweight": "bold",
            "color": colour,
            "path_effects": HALO,
            "zorder": 8,
        }
        right, up = (
            x < scene["lo"][0] + 0.75 * (scene["hi"][0] - scene["lo"][0]),
            not low and y < scene["lo"][1] + 0.85 * (scene["hi"][1] - scene["lo"][1]),
        )
        ax.annotate(
            handle["name"],
            (x, y),
            xytext=(9 if right else -9, 9 if up else -9),
            textcoords="offset points",
            ha="left" if right else "right",
            va="bottom" if up else "top",
            **style,
        )
