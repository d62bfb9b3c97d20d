"""The planners' board: drag parts of a problem, choose planner and settings, see it planned."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import ipywidgets as widgets

from ...errors import InvalidParameter
from ...messages import get_message
from ...planners import rrt
from ...planners.own import name_of
from ...planners.problem_input import world_size
from ...planners.registry import PLANNERS
from ...planners.tuning import integer
from ...problems import Plan, ProblemRecord
from ...support.json_fields import JsonObject
from ...support.text import shortened
from ..core.drawing import Drawing
from ..core.framed import (
    Framed,
    make_code_box,
    make_counter,
    make_length_slider,
    make_menu,
    title_of,
)
from ..core.scene import Scene
from ..tracing.code_run import CodeRun, Look
from .as_code import write_code
from .lit import CODE, draw_lines_of, trace_planner
from .live import describe_live
from .own import Attempt, draw_attempt, try_planner
from .plans import check_in_plane, draw_plan, make_problem_canvas, problem_in

OWN = "own"
CONTROLS = ("seed", "step_size", "samples", "code")
SETTINGS = {"step_size": "step_size", "samples": "nodes"}  # the setting of each control
ON_BOARD = {name: planner for name, planner in PLANNERS.items() if planner.board is not None}


def board(
    problem: ProblemRecord,
    planner: str | Callable[..., object] = "rrt",
    *,
    step_size: float | None = None,
    samples: int = 1000,
    rng: int = 0,
) -> Board:
    """A problem to play with: drag start, goal, obstacles or vertices, and it is planned again.

    Parameters
    ----------
    problem : a Problem in the plane.
    planner : "rrt", "rrt_connect", "rrt_star", "prm", "astar", or a function of yours, `f(problem)`
        or `f(problem, rng)`, that returns a path (n, 2), a Plan or None. The questions that yours
        asks are recorded and drawn in order, its path is compared with our RRT's, and it is stopped
        after two seconds. With the box "code" the lines of the planner are shown beside the picture
        as they run.
    step_size : the first value of the control for the longest edge of a tree.
    samples : the first value of the control for the number of a roadmap's samples, and of RRT*'s
        nodes.
    rng : the first seed.

    Returns
    -------
    Board
        `plan` is the plan shown, for a planner of yours an Attempt; `problem` is its problem.

    Raises
    ------
    InvalidParameter
        For a problem that is not in the plane, an unknown planner, or a value out of range.

    Examples
    --------
    >>> from kinoedu import Point, PolygonWorld, Problem
    >>> room = [(0, 0), (10, 0), (10, 10), (0, 10)]
    >>> world = PolygonWorld(room, [[(4, 0), (6, 0), (6, 8), (4, 8)]])
    >>> board(Problem(Point(), world, start=(1, 1), goal=(9, 1)), planner="astar")
    Board(A*: a path of length 18.65, 1,762 nodes)
    """
    return Board(problem, planner, step_size=step_size, samples=samples, rng=rng)


class Board(Framed):
    """The widget that `board` returns: controls above a canvas.

    `canvas.scene` says where everything is.
    """

    def __init__(
        self,
        problem: ProblemRecord,
        planner: str | Callable[..., object],
        *,
        step_size: float | None,
        samples: int,
        rng: int,
    ) -> None:
        self.problem = check_in_plane(problem)
        self.plan: Plan | Attempt | None = None
        self._given = problem
        self._own, chosen = choose_planner(planner)
        self._stuck: Attempt | None = None
        self.planner = self._menu(chosen)
        self.seed, self.step_size, self.samples = self._sliders(step_size, samples, rng)
        self.code = make_code_box()
        controls = [self.planner, self.seed, self.step_size, self.samples, self.code]
        super().__init__(controls, [make_problem_canvas(problem, self.answer, self.write_code)])

    def _menu(self, chosen: str) -> widgets.Dropdown:
        options = [(title_of(planner, "board"), name) for name, planner in ON_BOARD.items()]
        if self._own is not None:
            options.append((get_message("board.own_name", name=name_of(self._own)), OWN))
        return make_menu("board.planner", options, chosen)

    def _sliders(self, step_size: float | None, samples: int, rng: int) -> tuple[Any, Any, Any]:
        return (
            make_counter("board.seed", integer(rng, "rng", least=0), 0, 99),
            make_length_slider("board.step_size", world_size(self._given), step_size),
            make_counter("board.samples", integer(samples, "samples", least=1), 10, 3000),
        )

    def answer(self, scene: Scene) -> Drawing:
        """Plan in a scene with the settings of the controls, and draw the plan."""
        problem = problem_in(scene, self._given)
        seed, self.problem = self.seed.value, problem
        if self.planner.value == OWN and self._own is not None:
            return self._draw_own(self._own, problem, seed)
        planner = ON_BOARD[self.planner.value]
        given = self._settings()
        settings = {name: given[name] for name in planner.board or ()}
        plan = self.plan = planner.plan(problem, seed=seed, **settings)
        drawing = draw_plan(plan)
        if not (self.code.value and planner.name in CODE):
            return drawing
        call = partial(planner.plan, seed=seed, **settings)
        return drawing.completed_by(
            lambda: draw_lines_of(plan, trace_planner(planner.name, problem, call))
        )

    def _draw_own(
        self, planner: Callable[..., object], problem: ProblemRecord, seed: int
    ) -> Drawing:
        """Try a reader's planner, and draw its questions and its path beside our RRT's."""
        ours = rrt(problem, step_size=self.step_size.value, rng=seed)

        def attempt(run: CodeRun | None) -> Drawing:
            tried = self._stuck or try_planner(planner, problem, seed, run=run)
            self._stuck = tried if tried.still_running else None
            self.plan = tried
            return draw_attempt(tried, ours, run)

        drawing = attempt(None)
        if not self.code.value:
            return drawing
        return drawing.completed_by(lambda: attempt(CodeRun(planner, Look())))

    def write_code(self) -> str:
        """Python code for this board as it is now: the problem, the planner and the settings.

        A reader's function has its name there, and one without a name is `my_planner`.
        """
        chosen, own = self.planner.value, getattr(self._own, "__name__", "")
        settings = {name: getattr(self, name).value for name in SETTINGS}
        named = own if own.isidentifier() else "my_planner"
        planner = named if chosen == OWN else f'"{chosen}"'
        return write_code(self.problem, planner, {**settings, "rng": self.seed.value})

    def record(self) -> list[JsonObject]:
        """The board as it is now; a page with the planner's body answers it, others play it."""
        chosen = self.planner.value, self.seed.value, self._settings()
        self.canvas.live = None if self.code.value else describe_live(self.problem, *chosen)
        return super().record()

    def _settings(self) -> dict[str, Any]:
        """The values of the controls, by the names of the planners' settings."""
        return {name: getattr(self, control).value for control, name in SETTINGS.items()}

    def _dress(self) -> None:
        """Show the controls that apply to the chosen planner."""
        own = self.planner.value == OWN
        takes = ["seed", "step_size"] if own else list_controls(self.planner.value)
        if own or self.planner.value in CODE:
            takes = [*takes, "code"]
        for name in CONTROLS:
            getattr(self, name).layout.display = None if name in takes else "none"


def list_controls(name: str) -> list[str]:
    """The controls that a planner takes."""
    planner = ON_BOARD[name]
    takes = [control for control, setting in SETTINGS.items() if setting in (planner.board or ())]
    return [*(["seed"] if planner.is_random else []), *takes]


def choose_planner(planner: object) -> tuple[Callable[..., object] | None, str]:
    """A reader's function or None, and the first choice of the menu; or InvalidParameter."""
    if isinstance(planner, str) and planner in ON_BOARD:
        return None, planner
    for name, choice in ON_BOARD.items():
        if planner is choice.function:
            return None, name
    if callable(planner):
        return planner, OWN
    raise InvalidParameter(
        get_message("board.unknown_planner", names=", ".join(ON_BOARD), given=shortened(planner))
    )
