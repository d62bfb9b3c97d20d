"""The race: planners side by side in one scene, with one seed and one slider of steps."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache, partial
from typing import Any

from ...errors import InvalidParameter, KinoeduError
from ...messages import get_message
from ...planners import rrt, rrt_connect, rrt_star
from ...planners.own import name_of
from ...planners.problem_input import world_size
from ...planners.tuning import integer
from ...problems import Plan, ProblemRecord
from ...support.text import shortened
from ..core.canvas import Canvas
from ..core.drawing import Drawing
from ..core.framed import Framed, make_counter, make_length_slider, make_menu
from ..core.scene import Scene
from .own import Attempt
from .plans import Settings, check_in_plane, make_problem_canvas, problem_in
from .racing import Runner, run_planner, stretch_growth
from .racing_lit import follow_lines, has_lines

MOST = 4  # the most planners side by side
NO_CODE = ""


def race_board(
    problem: ProblemRecord,
    planners: Sequence[Callable[..., object]] | None = None,
    *,
    nodes: int = 1000,
    step_size: float | None = None,
    rng: int = 0,
) -> RaceBoard:
    """Planners side by side: each scene follows the others, and one slider scrubs through all.

    A step is one node of each tree, or one edge of a roadmap. The menu "code of" shows the lines of
    one of the planners as they run; then a step is a line, and the other trees have as many nodes
    as this one.

    Parameters
    ----------
    problem : a Problem in the plane.
    planners : one to four functions; by default rrt, rrt_connect and rrt_star. A function of yours,
        `f(problem)` or `f(problem, rng)`, is recorded and stopped as on `board`; its steps are the
        queries that it made.
    nodes, step_size, rng : the first values of the controls: the most nodes of a tree, its longest
        edge, and the seed.

    Returns
    -------
    RaceBoard
        `plans` are the plans shown.

    Raises
    ------
    InvalidParameter

    Examples
    --------
    >>> from kinoedu import Point, PolygonWorld, Problem
    >>> room = [(0, 0), (10, 0), (10, 10), (0, 10)]
    >>> world = PolygonWorld(room, [[(4, 0), (6, 0), (6, 8), (4, 8)]])
    >>> for plan in race_board(Problem(Point(), world, start=(1, 1), goal=(9, 1))).plans:
    ...     print(plan.planner, len(plan.tree.nodes), f"{plan.cost:.2f}")
    RRT 116 21.92
    RRT-Connect 73 28.70
    RRT* 1001 18.18
    """
    return RaceBoard(problem, planners, nodes, step_size, rng)


class RaceBoard(Framed):
    """The widget that `race_board` returns: controls, and one canvas per planner in `canvases`."""

    def __init__(
        self,
        problem: ProblemRecord,
        planners: Sequence[Callable[..., object]] | None,
        nodes: int,
        step_size: float | None,
        rng: int,
    ) -> None:
        self._given, self._planners = check_in_plane(problem), check_planners(planners)
        self.nodes = make_counter("rewiring_board.n", integer(nodes, "nodes", least=2), 50, 3000)
        self.step_size = make_length_slider("board.step_size", world_size(problem), step_size)
        self.seed = make_counter("board.seed", integer(rng, "rng", least=0), 0, 99)
        self.code = make_menu("race_board.code", list_lines(self._planners), NO_CODE)
        self._scene: Scene = {}
        self._runners: list[Runner] = []
        self._stuck: dict[int, Runner] = {}  # those that could not be stopped, by their numbers
        self._fault: KinoeduError | None = None
        self._lines: Callable[[], list[Drawing]] | None = None
        self.canvases: list[Canvas] = []
        canvases = [
            make_problem_canvas(problem, partial(self.answer, number))
            for number in range(len(self._planners))
        ]
        for canvas in canvases[1:]:
            canvas.add_class("kinoedu-led")
        for canvas, planner in zip(canvases, self._planners, strict=True):
            canvas.lane = name_of(planner).replace("_", " ")
            canvas.observe(self._settled, "scene")
        super().__init__([self.nodes, self.step_size, self.seed, self.code], canvases)

    @property
    def plans(self) -> list[Plan | Attempt]:
        """The result of each planner; empty where the scene allows no plan."""
        return [runner.plan for runner in self._runners]

    def answer(self, number: int, scene: Scene) -> Drawing:
        """Draw the result of one planner in a scene.

        If the scene is new, all planners run in it first, and the other canvases show it too.
        """
        if scene != self._scene:
            self._run(scene)
            for other, canvas in enumerate(self.canvases):
                if other != number:
                    canvas.follow(scene)
        if self._fault is not None:
            raise self._fault
        drawings = [runner.drawing for runner in self._runners]
        drawing = stretch_growth(drawings[number], max(drawing.total for drawing in drawings))
        lines = self._lines
        return drawing if lines is None else drawing.completed_by(lambda: lines()[number])

    def _run(self, scene: Scene) -> None:
        """Run all planners, except a reader's planner that could not be stopped before.

        A run that is interrupted leaves all lanes as they were.
        """
        runners = list[Runner]()
        try:
            problem = problem_in(scene, self._given)
        except KinoeduError as error:
            self._scene, self._fault, self._runners, self._lines = scene, error, [], None
            return
        given = Settings(self.seed.value, self.step_size.value, self.nodes.value)
        for number, planner in enumerate(self._planners):
            runners.append(self._stuck.get(number) or run_planner(planner, problem, given))
        self._scene, self._fault, self._runners = scene, None, runners
        self._stuck = {
            number: runner
            for number, runner in enumerate(runners)
            if isinstance(runner.plan, Attempt) and runner.plan.still_running
        }
        self._lines = self._choose_lines(problem, given)

    def _choose_lines(
        self, problem: ProblemRecord, given: Settings
    ) -> Callable[[], list[Drawing]] | None:
        """A function that makes all drawings follow the lines of the chosen planner, once."""
        if self.code.value == NO_CODE:
            return None
        leader, runners = int(self.code.value), self._runners
        if leader in self._stuck:
            return None
        return cache(partial(follow_lines, self._planners[leader], runners, leader, problem, given))

    def _settled(self, change: Any) -> None:
        """Keep in all canvases the scene that was let go in one."""
        for canvas in self.canvases:
            canvas.scene = change.new

    def _changed(self, change: object) -> None:
        self._scene = {}  # so that all planners run again
        super()._changed(change)


def list_lines(planners: Sequence[Callable[..., object]]) -> list[tuple[str, str]]:
    """The options of the menu of lines: pairs (name, number of the planner)."""
    names = [name_of(planner) for planner in planners]
    shown = [number for number, planner in enumerate(planners) if has_lines(planner)]
    none = get_message("race_board.no_code"), NO_CODE
    return [none, *((names[number], str(number)) for number in shown)]


def check_planners(planners: Sequence[Callable[..., object]] | None) -> list[Callable[..., object]]:
    """The planners of a race, or InvalidParameter."""
    chosen = [rrt, rrt_connect, rrt_star] if planners is None else planners
    some = isinstance(chosen, Sequence) and 1 <= len(chosen) <= MOST
    if not some or not all(map(callable, chosen)):
        raise InvalidParameter(
            get_message("race_board.too_many", most=MOST, given=shortened(planners))
        )
    return list(chosen)
