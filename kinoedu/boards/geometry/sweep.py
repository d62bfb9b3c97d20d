"""The sweep line's board: a line to drag across polygons, its status, and the cells it leaves."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import takewhile

import ipywidgets as widgets
import numpy as np

from ...browser.bodies import BODIES
from ...browser.sweeps import ShownSweep, number_edges, show_cut
from ...decomposition import Step
from ...decomposition.sweep import new_sweep
from ...decomposition.trapezoidation import steps, sweep_world
from ...messages import get_message
from ...support.json_fields import JsonObject
from ...worlds.polygon_world import PolygonWorldRecord, rings_of
from ..core.canvas import Canvas
from ..core.drawing import Drawing
from ..core.framed import Pictured, make_code_box
from ..core.scene import Scene, handle, make_scene, place_of, polygon
from ..core.shown import draw_shown, make_live
from ..planning.plans import world_in
from ..tracing.moments import draw_moments
from .lit import trace_sweep


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
        self._world: PolygonWorldRecord | None = world
        self._edges, self._x = sweep_world(world)[1], -np.inf
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

    @property
    def steps(self) -> list[Step]:
        """The events met so far; none in a scene that cannot be swept."""
        met = [] if self._world is None else steps(new_sweep(self._edges))
        return list(takewhile(lambda step: step.x <= self._x, met))

    def answer(self, scene: Scene) -> Drawing:
        """Sweep a scene up to the line."""
        self._world = None
        self._world = world_in(scene)
        self._edges = sweep_world(self._world)[1]
        self._x = float(place_of(scene, get_message("sweep_board.line"))[0])
        shown = self._cut(scene, self._x)
        self.status.value = list_status(shown.status.ravel().astype(int).tolist())
        drawing = draw(shown)
        if not self.code.value:
            return drawing
        return drawing.completed_by(lambda: self._with_code(scene))

    def _cut(self, scene: Scene, x: float) -> ShownSweep:
        """The sweep up to x, as it is shown in a scene."""
        return show_cut(self._edges, x, np.array(scene["lo"]), np.array(scene["hi"]))

    def _with_code(self, scene: Scene) -> Drawing:
        """The lines of the whole sweep; the handle says which of its events is shown at first."""
        assert self._world is not None
        everything = list(steps(new_sweep(self._edges)))
        ends = new_sweep(self._edges).ends
        numbers = zip(ends.tolist(), number_edges(ends), strict=True)
        run = trace_sweep(self._world, everything, {tuple(row): k for row, k in numbers})
        layers = draw_moments([draw(self._cut(scene, step.x)).layers for step in everything])
        text = get_message("sweep_board.events", events=len(everything))
        drawing = run.draw_over(Drawing(layers, text=text))
        progress = [0.0 if one.note is None else one.note.progress for one in run.trace.moments]
        first = np.searchsorted(np.maximum.accumulate(progress), len(self.steps)) + 1
        return replace(drawing, first=min(int(first), drawing.total))

    def record(self) -> list[JsonObject]:
        """The board as it is now; without its code and rooms a page answers it."""
        has_rooms = any(len(item["rings"]) > 1 for item in self.canvas.shown["polygons"])
        plays = self.code.value or has_rooms
        self.canvas.live = None if plays else make_live("sweep", ())
        return super().record()


def draw(shown: ShownSweep) -> Drawing:
    """The drawing of what is shown."""
    status, *facts = shown.facts.tolist()
    return draw_shown(BODIES["sweep"], int(status), facts, shown)


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


def list_status(numbers: Sequence[int]) -> str:
    """The status, edges from bottom to top, as an HTML list with the top first."""
    sides = "sweep_board.floor", "sweep_board.ceiling"
    lines = [get_message(sides[k % 2], number=number) for k, number in enumerate(numbers)]
    title = get_message("sweep_board.status")
    rest = lines[::-1] or [get_message("sweep_board.empty")]
    return f"<b>{title}</b><ul>{''.join(f'<li>{line}</li>' for line in rest)}</ul>"
