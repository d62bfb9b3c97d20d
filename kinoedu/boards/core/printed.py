"""A board as a picture, for readers without JavaScript: matplotlib draws the same layers."""

import io
from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure
from matplotlib.patches import Circle, PathPatch
from numpy.typing import NDArray
from PIL import Image, ImageColor

from ...figures import palette
from ...figures.drawing import compound
from ...figures.names import (
    NOWHERE,
    move_names_off_points,
    roomy_side,
    spread,
    without_formulas,
    write_beside_names,
    write_name,
)
from ...figures.style import Levels, as_png, use_colours
from ...geometry.checks import Array
from .drawing import Drawing, Layer
from .listing import Listing
from .scene import Scene

Bitmap = NDArray[np.bool_ | np.integer]  # booleans, or numbers of colours
SHARP = 2  # dots of the picture for one dot of a page, in both directions
DPI = 72 * SHARP
ACROSS = 2  # pictures in a row: with more the texts would be too small on a page
LINE_HEIGHT = 0.2  # inches, of a line of code
TITLE_HEIGHT = 0.4  # inches
ENOUGH = 80_000  # bytes, so that a notebook with a dozen boards stays below a megabyte
MOST = 100_000
MIXTURES = (1.0, 0.75, 0.5, 0.35, 0.1)  # shares of a colour mixed with white; 0.35 is of bodies
FEWER = ((1.0, 0.5), (1.0,))  # the same for pictures with too many bytes


def print_board(scene: Scene, drawing: Drawing, free: Bitmap | None = None) -> bytes:
    """A board's scene and the drawing that answers it, as a PNG; `free` is the bitmap beneath."""
    return save_with_few_colours(draw_board(scene, drawing, free))


def draw_board(scene: Scene, drawing: Drawing, free: Bitmap | None = None) -> Figure:
    """The figure of a board."""
    (x0, y0), (x1, y1) = scene["lo"], scene["hi"]
    size, margin = max(x1 - x0, y1 - y0), 0.01 * max(x1 - x0, y1 - y0)
    width, height = max(6.0 * (x1 - x0) / size, 2.2) + 1.0, max(6.0 * (y1 - y0) / size, 2.2) + 1.0
    figure, ax = make_page(width, height, drawing.listing, drawing.first)
    ax.set(aspect="equal", xlim=(x0 - margin, x1 + margin), ylim=(y0 - margin, y1 + margin))
    ax.set_title(without_formulas(drawing.message), fontsize=palette.TEXT_SIZE, wrap=True)
    ax.tick_params(labelsize=palette.TEXT_SIZE - 1)
    print_world(scene, free, ax)
    print_handles(scene, ax)
    passed = [print_layer(layer, ax, drawing) for layer in drawing.layers]
    ways = [rows for rows, layer in zip(passed, drawing.layers) if layer.colour == "path"]
    figure.draw_without_rendering()  # the layout settles only when a figure is drawn
    move_names_off_points(join_rows(passed), ax, join_rows(ways))
    for x, y, width in (layer.rows[-1] for layer in drawing.layers if layer.kind == "eye"):
        half_x, half_y = 0.5 * width * (x1 - x0) / size, 0.5 * width * (y1 - y0) / size
        ax.set(xlim=(x - half_x, x + half_x), ylim=(y - half_y, y + half_y))
    if not scene.get("ticks", True):
        ax.set_axis_off()
    return figure


def make_page(
    width: float, height: float, listing: Listing | None, step: int | None
) -> tuple[Figure, Axes]:
    """A figure and the axes of the picture; the code stands to the right of it."""
    texts, lit = write_listing(listing, step)
    beside = 0.115 * max(map(len, texts)) + 0.3 if texts else 0.0
    if texts:  # the title stands above both
        height = max(height, LINE_HEIGHT * (len(texts) + 1)) + TITLE_HEIGHT
    figure = Figure(figsize=(width + beside, height), dpi=DPI, layout="constrained")
    FigureCanvasAgg(figure)
    if not texts:
        return figure, figure.add_subplot()
    ax, page = figure.subplots(1, 2, width_ratios=(width, beside))
    print_lines(texts, lit, page)
    return figure, ax


def write_listing(listing: Listing | None, step: int | None) -> tuple[list[str], int]:
    """The lines of the code, and the variables after a step below them; and which line is lit.

    The step is the last one where it is None; no line is lit before the first step.
    """
    if listing is None:
        return [], -1
    step = len(listing.ran) if step is None else step
    lit = listing.ran[step - 1] if 0 < step <= len(listing.ran) else -1
    values = listing.values[step - 1] if 0 < step <= len(listing.values) else {}
    room = max(map(len, listing.lines))
    below = (clip(f"{name} = {text}", room) for name, text in values.items())
    return [*listing.lines, "", *below], lit


def print_lines(texts: list[str], lit: int, page: Axes) -> None:
    """Write lines of code, one of them lit."""
    page.set_axis_off()
    font: palette.Style = {"fontfamily": "monospace", "fontsize": palette.TEXT_SIZE - 1}
    page.set(xlim=(0.0, 1.0), ylim=(max(len(texts), 16), -1.0))
    for number, text in enumerate(texts):
        box = {"facecolor": palette.LIT, "edgecolor": "none", "pad": 2.0} if number == lit else None
        page.text(0.0, number, without_formulas(text), bbox=box, va="center", **font)


def clip(text: str, room: int) -> str:
    """A text without what does not fit."""
    return text if len(text) <= room else text[: room - 3] + "..."


def save_with_few_colours(figure: Figure) -> bytes:
    """A figure as a PNG with few colours."""
    return keep_own_colours(render(figure))


def render(figure: Figure) -> Image.Image:
    """The pixels of a figure."""
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    return Image.fromarray(np.asarray(canvas.buffer_rgba()))


def keep_own_colours(picture: Image.Image, shares: Sequence[float] = MIXTURES) -> bytes:
    """A picture as a PNG with only the course's colours and their mixtures.

    The file is about a quarter of the size, and every colour of the course is kept exactly.

    shares : of a colour in its mixtures with white.
    """
    return as_png(use_colours(picture.convert("RGB"), mix_colours(shares)))


def mix_colours(shares: Sequence[float]) -> Levels:
    """The named colours and the mixtures that figures need, levels (n, 3).

    Each colour is mixed with white; those of lines are mixed with that of obstacles too.
    """
    named = np.array([list(ImageColor.getrgb(colour)) for colour in palette.NAMED.values()])
    lines = (palette.TREE, palette.ROADMAP, palette.PATH)
    solid = np.array(ImageColor.getrgb(palette.OBSTACLE))
    mixed = [share * named + (1.0 - share) * 255.0 for share in shares]
    mixed += [0.5 * np.array(ImageColor.getrgb(line)) + 0.5 * solid for line in lines]
    return np.unique(np.vstack(mixed).round().astype(np.int64), axis=0)


def print_world(scene: Scene, free: Bitmap | None, ax: Axes) -> None:
    """Draw the bitmap, the boundary and the obstacles."""
    if free is not None:
        (x0, y0), (x1, y1) = (scene.get("glued", scene)[corner] for corner in ("lo", "hi"))
        shades = [palette.NAMED[name] for name in scene.get("colours", ("obstacle", "free"))]
        colours: palette.Style = {
            "cmap": ListedColormap(shades),
            "vmin": 0,
            "vmax": len(shades) - 1,
        }
        cells: palette.Style = {"origin": "lower", "interpolation": "nearest", "zorder": 0.6}
        ax.imshow(free, extent=(x0, x1, y0, y1), **cells, **colours)
    solid: palette.Style = {"facecolor": palette.OBSTACLE, "edgecolor": palette.OBSTACLE}
    if scene["boundary"] is not None:
        ax.set_facecolor(palette.OUTSIDE)
        outline = compound([np.array(scene["boundary"])])
        ax.add_patch(PathPatch(outline, **{**solid, "facecolor": palette.FREE}, zorder=0.5))
    for polygon in scene["polygons"]:
        if polygon.get("drawn"):
            continue
        rings = [
            orient_ring(np.array(ring), inner=k > 0) for k, ring in enumerate(polygon["rings"])
        ]
        inside = palette.NAMED[polygon.get("colour", "obstacle")]
        ax.add_patch(PathPatch(compound(rings), **{**solid, "facecolor": inside}))
    for disc in scene["discs"]:
        ax.add_patch(Circle(disc["at"], disc["radius"], facecolor=palette.OBSTACLE))


def orient_ring(ring: np.ndarray, *, inner: bool) -> np.ndarray:
    """A ring counter-clockwise; an inner ring clockwise, so that it is cut out."""
    x, y = ring.T
    left = (x * np.roll(y, -1) - np.roll(x, -1) * y).sum() > 0.0
    return ring[::-1] if left == inner else ring


def print_layer(layer: Layer, ax: Axes, drawing: Drawing) -> Array:
    """Draw one layer as it is at the step that is shown first; returns what names keep off."""
    step = drawing.total if drawing.first is None else drawing.first
    seen = layer.at(step)
    rows = seen.rows if step >= drawing.total or not layer.last else seen.rows[:0]
    if len(rows) and layer.kind in PRINTERS:
        shown = seen._replace(when=layer.when)  # arrows that grow lie beneath others
        PRINTERS[layer.kind](shown, rows, palette.NAMED[layer.colour], ax)
    return passed_places(layer, rows)


def join_rows(parts: list[Array]) -> Array:
    """Places (n, 2) from many arrays of them, or from none."""
    return np.concatenate([NOWHERE, *parts])


def passed_places(layer: Layer, rows: Array) -> Array:
    """Places that names keep off, (n, 2): of a path, of arrows, and where other names belong."""
    if layer.kind == "labels" or len(rows) == 0:
        return rows[:, :2]
    lines = list[Array]()
    if layer.kind == "path":
        lines = [rows]
    elif layer.kind == "edges" and layer.colour == "path":
        lines = join_segments(rows)
    elif layer.kind == "arrows":
        lines = [np.array([at, at + by]) for at, by in rows.reshape(-1, 2, 2)]
    return np.concatenate([rows[:0, :2], *map(spread, lines)])


def zorder_of(layer: Layer) -> float:
    """The z-order of a layer: one that comes last lies on the path, others beneath it."""
    return 5.5 if layer.last else 3.0


def line_style(layer: Layer) -> Any:
    """A layer's dashes as a line style of matplotlib."""
    return (0, [2.0 * d / max(layer.width, 1.0) for d in layer.dash]) if layer.dash else "solid"


def print_cells(layer: Layer, rows: Array, colour: str, ax: Axes) -> None:
    """Draw filled polygons beneath everything else."""
    shapes = list(rows.reshape(-1, layer.points, 2))
    ax.add_collection(PolyCollection(shapes, facecolors=colour, edgecolors="none", zorder=0.7))


def print_bodies(layer: Layer, rows: Array, colour: str, ax: Axes) -> None:
    """Draw outlines with a fill so light that things beneath are visible."""
    shapes, stripes = list(rows.reshape(-1, layer.points, 2)), "////" if layer.hatched else None
    outline: palette.Style = {"edgecolors": colour, "linewidths": layer.width, "hatch": stripes}
    beneath = zorder_of(layer) - 0.2
    ax.add_collection(PolyCollection(shapes, facecolors=f"{colour}59", zorder=beneath, **outline))


def print_edges(layer: Layer, rows: Array, colour: str, ax: Axes) -> None:
    """Draw segments; dashes go on from one segment to the next."""
    segments = join_segments(rows) if layer.dash else list(rows.reshape(-1, 2, 2))
    cap = "butt" if layer.dash else "round"
    style: palette.Style = {
        "linewidths": layer.width,
        "linestyles": line_style(layer),
        "capstyle": cap,
    }
    ax.add_collection(LineCollection(segments, colors=colour, zorder=zorder_of(layer), **style))


def join_segments(rows: Array) -> list[Array]:
    """Lines (k, 2) of segments (m, 4) that begin where the one before them ends."""
    breaks = np.flatnonzero((rows[1:, :2] != rows[:-1, 2:]).any(axis=1)) + 1
    runs = np.split(rows, breaks)
    return [np.vstack([run[:, :2], run[-1:, 2:]]) for run in runs]


def print_path(layer: Layer, rows: Array, colour: str, ax: Axes) -> None:
    """Draw one line through all rows, on a dark line where it has a casing."""
    if layer.casing:
        casing: palette.Style = {"linewidth": layer.width + 2.0, "solid_capstyle": "round"}
        ax.plot(*rows.T, color=palette.INK, zorder=4, **casing)
    ax.plot(*rows.T, color=colour, linewidth=layer.width, linestyle=line_style(layer), zorder=5)


def print_dots(layer: Layer, rows: Array, colour: str, ax: Axes) -> None:
    """Draw dots."""
    style: palette.Style = {"markersize": 1.6 * layer.width, "markeredgewidth": 0.0}
    ax.plot(*rows.T, "o", color=colour, zorder=zorder_of(layer) + 0.5, **style)


def print_arrows(layer: Layer, rows: Array, colour: str, ax: Axes) -> None:
    """Draw arrows; those that grow lie beneath the path."""
    style: palette.Style = {
        "width": 0.008 * layer.width / 3.0,
        "zorder": 6.0 if layer.when is None else 3.2,
    }
    ax.quiver(*rows.T, angles="xy", scale_units="xy", scale=1.0, color=colour, **style)


def print_labels(layer: Layer, rows: Array, colour: str, ax: Axes) -> None:
    """Draw texts beside their points."""
    for point, text in zip(rows, layer.texts, strict=True):
        write_beside_names(point, text, colour, ax).set(fontweight="normal")


PRINTERS = {
    "cells": print_cells,
    "bodies": print_bodies,
    "edges": print_edges,
    "path": print_path,
    "dots": print_dots,
    "arrows": print_arrows,
    "labels": print_labels,
}


def join_pictures(*pictures: bytes) -> bytes:
    """Join pictures in rows of two into one PNG."""
    opened = [Image.open(io.BytesIO(picture)).convert("RGB") for picture in pictures]
    rows = [opened[k : k + ACROSS] for k in range(0, len(opened), ACROSS)]
    heights = [max(one.height for one in row) for row in rows]
    width = max(sum(one.width for one in row) for row in rows)
    joined = Image.new("RGB", (width, sum(heights)), "white")
    for number, row in enumerate(rows):
        left, top = 0, sum(heights[:number])
        for one in row:
            joined.paste(one, (left, top + (heights[number] - one.height) // 2))
            left += one.width
    return keep_own_colours(joined)


def fit_page(picture: bytes) -> tuple[bytes, dict[str, int]]:
    """A sharp picture and its size on a page.

    With more than ENOUGH bytes its lines get harder rims; with more than MOST it becomes coarser.
    """
    sharp = Image.open(io.BytesIO(picture))
    width, height = sharp.width // SHARP, sharp.height // SHARP
    for shares in FEWER:
        if len(picture) > ENOUGH:
            picture = keep_own_colours(sharp, shares)
    if len(picture) > MOST:
        coarse = sharp.convert("RGB").resize((width, height), Image.Resampling.LANCZOS)
        picture = keep_own_colours(coarse)
    return picture, {"width": width, "height": height}


def print_handles(scene: Scene, ax: Axes) -> None:
    """Draw the points to drag, with their names.

    Where the scene has stops, the names stand below, because the stops' names stand above.
    """
    low = any(handle.get("stop") for handle in scene["handles"])
    for handle in scene["handles"]:
        if handle.get("stop") or handle.get("drawn"):  # drawn by the answer
            continue
        (x, y), colour = handle["at"], palette.NAMED[handle["colour"]]
        if handle["radius"]:
            ax.add_patch(Circle((x, y), handle["radius"], facecolor=colour, alpha=0.35, zorder=6))
        marker, size = ("*", 15) if handle["marker"] == "star" else ("o", 9)
        rim: palette.Style = {"markeredgecolor": "white", "markeredgewidth": 1.2}
        ax.plot(x, y, marker, color=colour, markersize=size, zorder=7, **rim)
        right, up = roomy_side((x, y), scene["lo"], scene["hi"])
        write_name((x, y), handle["name"], colour, (right, -1 if low else up), ax)
