"""The sweep line's board: a line to drag across polygons, its status, and the cells it leaves."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import ipywidgets as widgets
import numpy as np
from numpy.typing import NDArray

from ...decomposition import Step, sweep
from ...decomposition.trapezoidation import corners_of
from ...geometry.checks import Array
from ...messages import get_message
from ...worlds.polygon_world import PolygonWorldRecord, rings_of
from ..core.canvas import Canvas
from ..core.drawing import Drawing, Layer, cells, dots, edges, labels
from ..core.framed import Pictured, make_code_box
from ..core.notes import note, with_notes
from ..core.scene import Scene, handle, make_scene, place_of, polygon
from ..planning.plans import world_in
from .lit import draw_events, trace_sweep

FLOOR, CEILING = "floor", "ceiling"  # colours of the status, as in the figures


def sweep_board(world: PolygonWorldRecord, *, x: float | None = None) -> SweepBoard:
    """Drag the sweep line across a world, or obstacles and their vertices.

    The closed and the open cells and the status of the line are shown. With the box "code" a step
    is a line of the algorithm, from the event on at which the sweep line is.

    Parameters
    ----------
    world : a PolygonWorld without discs.
    x : where the line begins; by default half way across.

    Returns
    -------
    SweepBoard
        `steps` are the events met so far.

    Raises
    ------
    InvalidWorld

    Examples
    --------
    >>> from kinoedu.worlds import PolygonWorld
    >>> world = PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [[(3, 3), (6, 2), (5, 4)]])
    >>> sweep_board(world, x=5.5)
    SweepBoard(at x = 5: a bend; cells closed 2, open 2
    status: edge 0, edge 2, edge 4, edge 1)
    """
    return SweepBoard(world, x=x)


class SweepBoard(Pictured, widgets.HBox):
    """The widget that `sweep_board` returns: the world in `canvas`, the status in `status`."""

    def __init__(self, world: PolygonWorldRecord, *, x: float | None) -> None:
        sweep(world)  # raises for a world that it cannot cut
        self.steps: list[Step] = []
        self.code = make_code_box()
        self.code.layout = widgets.Layout(flex="1 1 100%")
        self.status = widgets.HTML(layout=widgets.Layout(flex="1 1 11em"))
        self.canvas = Canvas(make_sweep_scene(world, x), self.answer)
        self.canvas.layout = widgets.Layout(flex="4 1 22em", max_width="650px", min_width="0")
        layout = widgets.Layout(flex_flow="row wrap", grid_gap="8px")
        super().__init__([self.code, self.canvas, self.status], layout=layout)
        self.code.observe(self._changed, "value")

    def _changed(self, _: object) -> None:
        """Show or hide the code; the variables beside it list the status."""
        self.status.layout.display = "none" if self.code.value else None
        self.canvas.layout.max_width = "none" if self.code.value else "650px"
        self.canvas.refresh()

    def answer(self, scene: Scene) -> Drawing:
        """Sweep a scene up to the line."""
        self.steps, rows = [], np.empty((0, 4))
        try:
            world = world_in(scene)
            everything = list(sweep(world))
            x = float(place_of(scene, get_message("sweep_board.line"))[0])
            self.steps = [step for step in everything if step.x <= x]
            names = number_edges(everything)
            if not self.steps:
                return Drawing(
                    [draw_line(x, scene)], text=get_message("sweep_board.before", x=f"{x:.4g}")
                )
            rows = self.steps[-1].status
            drawing = draw_sweep(self.steps, x, names, scene)
            if not self.code.value:
                return drawing
            return drawing.completed_by(lambda: self._with_code(world, everything, names, scene))
        finally:
            self.status.value = list_status(rows, names if len(rows) else {})

    def _with_code(
        self,
        world: PolygonWorldRecord,
        everything: Sequence[Step],
        names: dict[tuple[float, ...], int],
        scene: Scene,
    ) -> Drawing:
        """The lines of the whole sweep; the handle says which of its events is shown at first."""
        run = trace_sweep(world, everything, names)
        layers = draw_events(everything, lambda steps, x: draw_sweep(steps, x, names, scene))
        text = get_message("sweep_board.events", events=len(everything))
        drawing = run.draw_over(Drawing(layers, text=text))
        progress = [0.0 if one.note is None else one.note.progress for one in run.trace.moments]
        first = np.searchsorted(np.maximum.accumulate(progress), len(self.steps)) + 1
        return replace(drawing, first=min(int(first), drawing.total))


def make_sweep_scene(world: PolygonWorldRecord, x: float | None) -> Scene:
    """The scene of a world, with a handle for the sweep line below it."""
    (outline,), *solids = rings_of(world)
    margin = 0.06 * (world.hi - world.lo).max()
    at = (world.lo[0] + world.hi[0]) / 2.0 if x is None else x
    polygons = [
        polygon(get_message("sweep_board.obstacle", number=k), rings)
        for k, rings in enumerate(solids)
    ]
    handles = [handle(get_message("sweep_board.line"), (at, world.lo[1] - margin), colour="ink")]
    lo, hi = world.lo - [margin, 1.5 * margin], world.hi + margin
    return make_scene(lo, hi, boundary=outline[::-1], handles=handles, polygons=polygons)


def number_edges(steps: Sequence[Step]) -> dict[tuple[float, ...], int]:
    """A number for every edge that the line crosses somewhere.

    They are numbered from left to right by their left ends, lower ones first.
    """
    rows = np.unique(np.concatenate([step.status for step in steps]), axis=0)
    slopes = (rows[:, 3] - rows[:, 1]) / (rows[:, 2] - rows[:, 0])
    ordered = rows[np.lexsort((slopes, rows[:, 1], rows[:, 0]))]
    return {tuple(row): number for number, row in enumerate(ordered.tolist())}


def draw_sweep(
    steps: Sequence[Step], x: float, names: dict[tuple[float, ...], int], scene: Scene
) -> Drawing:
    """Draw the cells that the line has left, and what it crosses at x."""
    now, done = steps[-1], np.concatenate([step.closed for step in steps])
    begun = find_open_cells(steps, x)
    corners, size = corners_of(done), float(np.subtract(scene["hi"], scene["lo"]).max())
    layers = [
        note_cells(cells(corners, "cell"), corners),
        draw_outlines(corners, "tree", 1.5),
        draw_outlines(begun, "tree", 1.8, (6.0, 5.0)),
        labels(
            corners.mean(axis=1) - 0.015 * size, [str(k) for k in range(1, len(done) + 1)], "tree"
        ),
        draw_line(x, scene),
    ]
    layers += [
        edges(now.status[k::2], colour, width=4.0) for k, colour in enumerate((FLOOR, CEILING))
    ]
    heights = height_at(now.status, x)
    layers += [
        dots(np.concatenate([step.vertices for step in steps]), "ink", radius=3.5),
        dots(now.vertices, "path", radius=6.0),
        dots(np.column_stack([np.full(len(heights), x), heights]), "ink", radius=3.0),
    ]
    places = np.column_stack([np.full(len(heights), x), spread_heights(heights, 0.045 * size)])
    texts = [str(names[tuple(row)]) for row in now.status.tolist()]
    layers += [
        labels(places[k::2], texts[k::2], colour) for k, colour in enumerate((FLOOR, CEILING))
    ]
    values = {"x": f"{now.x:.4g}", "event": now.kind, "closed": len(done)}
    if not len(now.status):
        return Drawing(layers, text=get_message("sweep_board.ended", **values))
    status = ", ".join(get_message("sweep_board.edge", number=text) for text in texts)
    return Drawing(
        layers, text=get_message("sweep_board.now", **values, open=len(begun), status=status)
    )


def note_cells(layer: Layer, corners: Array) -> Layer:
    """The layer of closed cells (n, 4, 2), each of which says which others it is joined to."""
    texts = []
    (left, right), joined = corners[:, (0, 1), 0].T, find_joined(corners)
    for number, (begin, end) in enumerate(zip(left, right, strict=True)):
        others = ", ".join(str(other + 1) for other in np.flatnonzero(joined[number]))
        text = note("joined", cells=others) if others else note("alone")
        values = {"left": f"{begin:.4g}", "right": f"{end:.4g}", "joined": text}
        texts.append(note("cell", number=number + 1, **values))
    return with_notes(layer, *texts, which=np.arange(len(corners)))


def find_joined(corners: Array) -> NDArray[np.bool_]:
    """Whether two cells (n, 4, 2) have a part of a wall in common, (n, n)."""
    (left, low_left), (right, low_right) = corners[:, 0].T, corners[:, 1].T
    top_right, top_left = corners[:, 2, 1], corners[:, 3, 1]
    overlap = np.minimum(top_right[:, None], top_left) - np.maximum(low_right[:, None], low_left)
    after = np.isclose(right[:, None], left) & (overlap > 1e-12)
    return np.asarray(after | after.T)


def draw_line(x: float, scene: Scene) -> Layer:
    """The sweep line."""
    return edges([[(x, scene["lo"][1]), (x, scene["hi"][1])]], "ink", width=2.0)


def draw_outlines(corners: Array, colour: str, width: float, dash: Sequence[float] = ()) -> Layer:
    """The sides of quadrangles (n, 4, 2)."""
    return edges(
        np.stack([corners, np.roll(corners, -1, axis=1)], axis=2), colour, width=width, dash=dash
    )


def find_open_cells(steps: Sequence[Step], x: float) -> Array:
    """The cells that the line at x is crossing, up to x, (n, 4, 2).

    Only the left wall of each is stored; its floor and ceiling are the neighbours in the status
    that pass through the wall's ends.
    """
    walls: list[tuple[float, ...]] = []
    for step in steps:
        ended = {tuple(row) for row in step.closed[:, [0, 2, 3]].tolist()}
        walls = [wall for wall in walls if wall not in ended] + [
            tuple(row) for row in step.opened.tolist()
        ]
    pairs, found = steps[-1].status.reshape(-1, 2, 4), []
    for floor, ceiling in pairs:
        left = max(floor[0], ceiling[0])
        misses = [
            np.abs(height_at(np.array([floor, ceiling]), begin) - [low, high]).sum()
            if begin >= left
            else np.inf
            for begin, low, high in walls
        ]
        begin, low, high = walls.pop(int(np.argmin(misses)))
        bottom, top = height_at(np.array([floor, ceiling]), x)
        found.append([(begin, low), (x, bottom), (x, top), (begin, high)])
    return np.array(found).reshape(-1, 4, 2)


def height_at(rows: Array, x: float) -> Array:
    """The height of edges (n, 4) at x, (n,)."""
    x0, y0, x1, y1 = rows.T
    return y0 + (x - x0) / (x1 - x0) * (y1 - y0)


def spread_heights(heights: Array, gap: float) -> Array:
    """Heights in increasing order, pushed up where they are closer than a gap."""
    places = heights.copy()
    for below, above in pairwise(range(len(places))):
        places[above] = max(places[above], places[below] + gap)
    return places


def list_status(rows: Array, names: dict[tuple[float, ...], int]) -> str:
    """The status as an HTML list, the top of the line first."""
    lines = [
        get_message(
            "sweep_board.ceiling" if k % 2 else "sweep_board.floor", number=names[tuple(row)]
        )
        for k, row in enumerate(rows.tolist())
    ]
    title, rest = (
        get_message("sweep_board.status"),
        lines[::-1] or [get_message("sweep_board.empty")],
    )
    return f"<b>{title}</b><ul>{''.join(f'<li>{line}</li>' for line in rest)}</ul>"
