"""The planners' board: a problem whose parts can be dragged, planned anew as they move, with
planner, seed and step to choose.
"""

from collections.abc import Callable
from typing import Any

import ipywidgets as widgets

from ...errors import InvalidParameter
from ...planners import rrt
from ...planners.problem_input import world_size
from ...planners.tuning import positive, whole
from ...problems import Plan, ProblemRecord
from ...support.text import shortened
from ...words import say
from ..core.canvas import with_picture
from ..core.drawing import Drawing
from ..core.scene import Scene
from .own import Attempt, attempt, drawing_of_attempt
from .plans import PLANNERS, Settings, canvas_for, drawing_of, in_plane, problem_in

OWN = "own"
CONTROLS = ("seed", "step", "samples")


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
        options = [(say(f"board.{name}"), name) for name in PLANNERS]
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
        settings = Settings(self.seed.value, self.step.value, self.samples.value)
        self.problem = problem
        if self.planner.value == OWN and self._own is not None:
            ours = rrt(problem, step=settings.step, rng=settings.seed)
            tried = self._stuck or attempt(self._own, problem, settings.seed)
            self._stuck = tried if tried.still_running else None
            self.plan = tried
            return drawing_of_attempt(tried, ours)
        self.plan = PLANNERS[self.planner.value].plan(problem, settings)
        return drawing_of(self.plan)

    def _changed(self, _: Any) -> None:
        self._dress()
        self.canvas.refresh()

    def _dress(self) -> None:
        """Show the controls that the planner takes."""
        takes = (
            ("seed", "step") if self.planner.value == OWN else PLANNERS[self.planner.value].takes
        )
        for name in CONTROLS:
            getattr(self, name).layout.display = None if name in takes else "none"

    def __repr__(self) -> str:
        return f"Board({self.canvas.drawing.says})"

    def _repr_mimebundle_(self, **kwargs: Any) -> Any:
        return with_picture(super()._repr_mimebundle_(**kwargs), self, self.canvas)


def chosen_planner(planner: Any) -> tuple[Callable[..., Any] | None, str]:
    """A reader's function or None, and the name that the menu begins with. Raises
    InvalidParameter.
    """
    if isinstance(planner, str) and planner in PLANNERS:
        return None, planner
    for name, choice in PLANNERS.items():
        if planner is choice.function:
            return None, name
    if callable(planner):
        return planner, OWN
    raise InvalidParameter(
        say("board.unknown_planner", names=", ".join(PLANNERS), given=shortened(planner))
    )


def length_slider(key: str, size: float, given: float | None) -> widgets.FloatSlider:
    """A slider for a length in a world of a size, named by the words under a key: it begins at what
    is given, or at a twentieth of the size. Raises InvalidParameter.
    """
    first = size / 20.0 if given is None else positive(given, key.rpartition(".")[2])
    notch = (
        first / 20.0
    )  # the browser moves a slider to the nearest notch: the first value must lie on one
    return widgets.FloatSlider(
        first,
        min=min(first, notch * max(1, round(size / 200.0 / notch))),
        max=notch * max(20, round(size / 4.0 / notch)),
        step=notch,
        readout_format=".3g",
        **{**look("step"), "description": say(key)},
    )


def look(name: str) -> dict[str, Any]:
    """How a control looks."""
    layout = widgets.Layout(width="30em", max_width="100%")
    return {
        "description": say(f"board.{name}"),
        "layout": layout,
        "style": {"description_width": "6em"},
    }
