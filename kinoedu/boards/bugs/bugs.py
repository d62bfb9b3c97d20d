"""The bugs' board: a bug's walk round obstacles, and a plot of its distance to the goal."""

from __future__ import annotations

from collections.abc import Iterable
from functools import partial
from typing import Any

import ipywidgets as widgets
import numpy as np
from numpy.typing import ArrayLike

from ...browser.bug_looks import REASONS, WALKED
from ...browser.walks import show_walk
from ...geometry.checks import Array, as_point
from ...messages import get_message
from ...planners import bug0, bug1, bug2, bug2_prelim, bug_base
from ...planners.bugs.walls import any_meet, check_obstacles
from ...planners.tuning import one_of
from ...problems import Plan, Walk
from ...support.json_fields import JsonObject
from ..core.canvas import Canvas
from ..core.drawing import Drawing, encode_drawing, sides_of
from ..core.framed import Pictured, make_code_box, make_menu
from ..core.printed import join_pictures
from ..core.recorded import record_drawing
from ..core.scene import Scene, frame_of, handle, make_scene, place_of, polygon
from ..core.shown import draw_beside, draw_shown
from ..planning.plans import GOAL, START
from .lit import trace_bug
from .walks import Clock, course_of, draw_plots, draw_race, make_clock, make_plot_scene

BUGS: dict[str, tuple[str, Any]] = {
    "bug_base": ("BugBase", bug_base),
    "bug0": ("Bug 0", bug0),
    "bug1": ("Bug 1", bug1),
    "bug2_prelim": ("Bug 2.prelim", bug2_prelim),
    "bug2": ("Bug 2", bug2),
}
ALL = "all"
FINENESS = 160.0  # a walk across the whole world takes this many steps of the clock


def bug_board(
    start: ArrayLike,
    goal: ArrayLike,
    obstacles: Iterable[ArrayLike],
    *,
    bug: str = "bug1",
    turn: str = "left",
) -> BugBoard:
    """Drag start, goal, obstacles or vertices; a bug walks again. Scrub along its walk.

    With the box "code" a step is a line of the bug, which is shown beside the picture.

    Parameters
    ----------
    start, goal : (x, y).
    obstacles : simple polygons, (n, 2) each, as for `bug1`.
    bug : "bug_base", "bug0", "bug1", "bug2_prelim", "bug2", or "all" for all in one picture.
    turn : "left" or "right", at a wall.

    Returns
    -------
    BugBoard
        `plans` are the plans shown, each with its walk; `step` is the length of a step.

    Raises
    ------
    InvalidPoint, InvalidPolygon, InvalidParameter

    Examples
    --------
    >>> bug_board((0, 0), (4, 0), [[(1, -1), (2, -1), (2, 2), (1, 2)]])
    BugBoard(Bug 1: reached after 14; hits 1)
    """
    return BugBoard(start, goal, obstacles, bug=bug, turn=turn)


class BugBoard(Pictured, widgets.VBox):
    """The widget that `bug_board` returns: controls, the world in `canvas`, the plot in `plot`."""

    def __init__(
        self,
        start: ArrayLike,
        goal: ArrayLike,
        obstacles: Iterable[ArrayLike],
        *,
        bug: str,
        turn: str,
    ) -> None:
        scene = make_bug_scene(start, goal, obstacles)
        chosen, heading = one_of(bug, "bug", (*BUGS, ALL)), one_of(turn, "turn", ("left", "right"))
        self.plans: list[tuple[Plan, Walk]] = []
        self._clock = Clock(1.0, 0)  # of both pictures
        self._plot = Drawing(text=get_message("bug_board.nothing"))
        self.step = max(b - a for a, b in zip(scene["lo"], scene["hi"], strict=True)) / FINENESS
        bugs = [(name, key) for key, (name, _) in BUGS.items()]
        self.bug = make_menu("bug_board.bug", [*bugs, (get_message("bug_board.all"), ALL)], chosen)
        turns = [(get_message(f"bug_board.{side}"), side) for side in ("left", "right")]
        self.turn = make_menu("bug_board.turn", turns, heading)
        self.code = make_code_box()
        self.plot = Canvas(make_plot_scene(), self._plotted)
        self.canvas = Canvas(scene, self.answer)
        self.plot.partner = self.canvas.key
        self.canvas.layout = widgets.Layout(flex="4 1 22em", min_width="0")
        self.plot.layout = widgets.Layout(flex="3 1 18em", min_width="0", padding="0 2px 0 0")
        pictures = widgets.HBox(
            [self.canvas, self.plot], layout=widgets.Layout(flex_flow="row wrap", grid_gap="8px")
        )
        super().__init__([self.bug, self.turn, self.code, pictures])
        self._dress()
        for control in (self.bug, self.turn, self.code):
            control.observe(self._changed, "value")

    @property
    def shows_code(self) -> bool:
        """Whether the lines of one bug are the steps; then there is no plot beside them."""
        return bool(self.code.value) and self.bug.value != ALL

    def _changed(self, _: object) -> None:
        self._dress()
        self.canvas.refresh()

    def _dress(self) -> None:
        """Show the box for one bug only, and the plot without code only."""
        self.code.layout.display = "none" if self.bug.value == ALL else None
        self.plot.layout.display = "none" if self.shows_code else None

    def answer(self, scene: Scene) -> Drawing:
        """Walk in a scene with the settings of the controls; draw the walk here and in the plot."""
        self.plans = []
        plans: list[tuple[Plan, Walk]] = []
        obstacles = [item["rings"][0] for item in scene["polygons"]]
        start, goal = place_of(scene, START), place_of(scene, GOAL)
        chosen = list(BUGS) if self.bug.value == ALL else [self.bug.value]
        for name in chosen:
            plan = BUGS[name][1](start, goal, obstacles, self.step, turn=self.turn.value)
            plans.append((plan, plan.walk))
        self.plans = plans
        self._clock = make_clock([walk for _, walk in plans], self.step)
        if len(plans) > 1:
            drawing, self._plot = draw_race(plans, self._clock), draw_plots(plans, self._clock)
        else:
            drawing, self._plot = draw_walk(name, plan, check_obstacles(obstacles), self.step)
        self.plot.follow(self.plot.shown)
        if not self.shows_code:
            return drawing
        walk = partial(BUGS[name][1], start, goal, obstacles, self.step, turn=self.turn.value)
        tick = self._clock.tick
        return drawing.completed_by(lambda: trace_bug(name, tick, walk).draw_over(drawing))

    def _plotted(self, _: Scene) -> Drawing:
        """The plot of the walks shown."""
        if not self.plans or self.shows_code:
            return Drawing(text=get_message("bug_board.nothing"))
        return self._plot

    def record(self) -> list[JsonObject]:
        """Both pictures as they are now; a page answers for one bug among separate obstacles."""
        name, rings = self.bug.value, [item["rings"][0] for item in self.canvas.shown["polygons"]]
        self.canvas.live = self.plot.live = None
        if name != ALL and not self.shows_code and not any_meet([*map(np.array, rings)]):
            numbers = [-1.0 if self.turn.value == "left" else 1.0, float(self.step)]
            given = {bug: numbers if bug == name else name for bug in WALKED}
            self.canvas.live = {"body": name, "seed": 0, "settings": given}
            under = encode_drawing(Drawing(), *frame_of(self.plot.shown))
            self.plot.live = {"body": name, "under": record_drawing(*under)}
        return super().record()

    def picture(self) -> bytes:
        """World and plot side by side, as a PNG; with code the world alone."""
        if self.shows_code:
            return self.canvas.picture()
        return join_pictures(self.canvas.picture(), self.plot.picture())


def draw_walk(name: str, plan: Plan, rings: list[Array], step: float) -> tuple[Drawing, Drawing]:
    """Draw one walk, and the plot of it."""
    body, outcome, walk = WALKED[name], REASONS[name].index(plan.reason), plan.walk
    assert walk is not None
    walls = np.concatenate([np.empty((0, 4)), *(sides_of(ring).reshape(-1, 4) for ring in rings)])
    ends = np.array([plan.problem.start, plan.problem.goal])
    shown = show_walk(outcome, course_of(walk), ends, walls, step)
    facts = shown.facts.tolist()[1:]
    return draw_shown(body, outcome, facts, shown), draw_beside(body, outcome, facts, shown)


def make_bug_scene(start: ArrayLike, goal: ArrayLike, obstacles: Iterable[ArrayLike]) -> Scene:
    """The scene of a bug: everything in it can be dragged."""
    rings, begin, end = check_obstacles(obstacles), as_point(start, START), as_point(goal, GOAL)
    shown = np.concatenate([*rings, begin[None], end[None]])
    lo, hi = shown.min(axis=0), shown.max(axis=0)
    margin = 0.12 * (hi - lo).max() or 1.0
    ends = [handle(START, begin, colour="start"), handle(GOAL, end, colour="goal", marker="star")]
    polygons = [
        polygon(get_message("bug_board.obstacle", number=k), [ring]) for k, ring in enumerate(rings)
    ]
    return make_scene(lo - margin, hi + margin, handles=ends, polygons=polygons)
