"""The planners' board: a problem whose parts can be dragged, planned anew as they move, with
planner, seed and step to choose.
"""

from collections.abc import Callable
from typing import Any

import ipywidgets as widgets

from ...errors import InvalidParameter
from ...planners import rrt
from ...planners.problem_input import world_size
from ...planners.registry import PLANNERS
from ...planners.tuning import whole
from ...problems import Plan, ProblemRecord
from ...support.text import shortened
from ...words import say
from ..core.canvas import with_picture
from ..core.controls import length_slider, look, title_of
from ..core.drawing import Drawing
from ..core.scene import Scene
from .own import Attempt, attempt, drawing_of_attempt
from .plans import canvas_for, drawing_of, in_plane, problem_in

OWN = "own"
CONTROLS = ("seed", "step", "samples")
SETTINGS = {"step": "step", "samples": "nodes"}  # what controls are called by planners
ON_BOARD = {name: planner for name, planner in PLANNERS.items() if planner.board is not None}


def board(
    problem: ProblemRecord,
    planner: str | Callable[..., Any] = "rrt",
    *,
    step: float | None = None,
    samples: int = 1000,
    rng: int = 0,
) -> "Board":
    """A problem to play with: drag the start, the goal, the obstacles and their vertices, and it is
    planned anew.

    Parameters
    ----------
    problem : a Problem in the plane.
    planner : "rrt", "prm", "astar", or a function of yours, `f(problem)` or `f(problem, rng)`, that
    returns a path (n, 2), a Plan
        or None. Yours is recorded, drawn in the order in which it asked, raced against our RRT, and
        stopped after two seconds.
    step, samples, rng : where the controls begin: the longest edge of a tree, the number of a
    roadmap's samples, the seed.

    `board.plan` is the plan on show (of yours, what came of it), `board.problem` what was asked.
    Raises InvalidParameter.

    >>> from kinoedu import Point, PolygonWorld, Problem
    >>> world = PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [[(4, 0), (6, 0), (6, 8), (4, 8)]])
    >>> board(Problem(Point(), world, start=(1, 1), goal=(9, 1)), planner="astar")
    Board(A*: a path of length 18.65, 1,762 nodes)
    """
    return Board(problem, planner, step=step, samples=samples, rng=rng)


class Board(widgets.VBox):
    """What `board` makes: the controls, and the canvas below them. `canvas.scene` says where
    everything is.
    """

    def __init__(
        self,
        problem: ProblemRecord,
        planner: str | Callable[..., Any],
        *,
        step: float | None,
        samples: int,
        rng: int,
    ) -> None:
        self.problem = in_plane(problem)
        self.plan: Plan | Attempt | None = None
        self._given = problem
        self._own, chosen = chosen_planner(planner)
        self._stuck: Attempt | None = None
        self.planner = self._menu(chosen)
        self.seed, self.step, self.samples = self._sliders(step, samples, rng)
        self._dress()
        self.canvas = canvas_for(problem, self.answer)
        super().__init__([self.planner, self.seed, self.step, self.samples, self.canvas])
        for control in (self.planner, self.seed, self.step, self.samples):
            control.observe(self._changed, "value")

    def _menu(self, chosen: str) -> widgets.Dropdown:
        options = [(title_of(planner, "board"), name) for name, planner in ON_BOARD.items()]
        if self._own is not None:
            options.append((say("board.own_name", name=getattr(self._own, "__name__", "?")), OWN))
        return widgets.Dropdown(options=options, value=chosen, **look("planner"))

    def _sliders(self, step: float | None, samples: int, rng: int) -> tuple[Any, Any, Any]:
        seed, n = whole(rng, "rng", least=0), whole(samples, "samples", least=1)
        return (
            widgets.IntSlider(seed, 0, max(99, seed), **look("seed")),
            length_slider("board.step", world_size(self._given), step),
            widgets.IntSlider(n, min(50, n), max(3000, n), **look("samples")),
        )

    def answer(self, scene: Scene) -> Drawing:
        """Plan in a scene, with what the controls say, and draw it."""
        problem = problem_in(scene, self._given)
        seed, self.problem = self.seed.value, problem
        if self.planner.value == OWN and self._own is not None:
            ours = rrt(problem, step=self.step.value, rng=seed)
            tried = self._stuck or attempt(self._own, problem, seed)
            self._stuck = tried if tried.still_running else None
            self.plan = tried
            return drawing_of_attempt(tried, ours)
        given = {name: getattr(self, control).value for control, name in SETTINGS.items()}
        planner = ON_BOARD[self.planner.value]
        self.plan = planner.plan(problem, seed=seed, **{n: given[n] for n in planner.board or ()})
        return drawing_of(self.plan)

    def _changed(self, _: Any) -> None:
        self._dress()
        self.canvas.refresh()

    def _dress(self) -> None:
        """Show the controls that the planner takes."""
        takes = ("seed", "step") if self.planner.value == OWN else controls_of(self.planner.value)
        for name in CONTROLS:
            getattr(self, name).layout.display = None if name in takes else "none"

    def __repr__(self) -> str:
        return f"Board({self.canvas.drawing.says})"

    def _repr_mimebundle_(self, **kwargs: Any) -> Any:
        return with_picture(super()._repr_mimebundle_(**kwargs), self, self.canvas)


def controls_of(name: str) -> list[str]:
    """The controls that a planner takes."""
    planner = ON_BOARD[name]
    takes = [control for control, setting in SETTINGS.items() if setting in (planner.board or ())]
    return [*(["seed"] if planner.is_random else []), *takes]


def chosen_planner(planner: Any) -> tuple[Callable[..., Any] | None, str]:
    """A reader's function or None, and the name that the menu begins with. Raises
    InvalidParameter.
    """
    if isinstance(planner, str) and planner in ON_BOARD:
        return None, planner
    for name, choice in ON_BOARD.items():
        if planner is choice.function:
            return None, name
    if callable(planner):
        return planner, OWN
    raise InvalidParameter(
        say("board.unknown_planner", names=", ".join(ON_BOARD), given=shortened(planner))
    )
