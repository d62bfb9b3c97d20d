"""The exploring board: a robot with a sensor of limited range in an unknown world."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from functools import partial
from itertools import islice

from ...errors import InvalidParameter
from ...messages import get_message
from ...planners.exploring.receding_horizon import Look, plan_from_looks, receding_horizon_looks
from ...planners.problem_input import world_size
from ...planners.tuning import integer, positive
from ...problems import Plan, ProblemRecord
from ...robots.round import RoundRobot
from ...support.text import shortened
from ...worlds.polygon_world import PolygonWorldRecord
from ..core.drawing import Drawing
from ..core.framed import Framed, make_code_box, make_counter, make_length_slider
from ..core.scene import Scene
from ..planning.plans import check_in_plane, make_problem_canvas, problem_in
from ..tracing.code_run import Look as CodeLook
from ..tracing.code_run import trace_lines
from .explored import MOVES, draw_exploration

RAYS, MOST = 180, 60  # of the sensor; the most moves
DRAGGED = 5  # the looks that are drawn while something is dragged
LOOK = CodeLook(  # at the code: the points, and the step of the drawing
    {"q": "q", "walls in map": "len(walls)"}, colours={"q": "robot"}, progress=f"{MOVES} * moves"
)


def exploring_board(
    problem: ProblemRecord,
    reach: float | None = None,
    *,
    horizon: float | None = None,
    rng: int = 0,
) -> ExploringBoard:
    """Scrub along a robot that looks, plans in its map, moves a little, and looks again.

    The region seen is blue, the region seen now is framed, and the walls in the map are red. The
    dashed line is the plan in the map, where everything unseen counts as free. Drag start, goal and
    obstacles. With the box "code" a step is a line of the loop.

    Parameters
    ----------
    problem : a Problem of a Point or a Disk in a PolygonWorld.
    reach, horizon, rng : the first values of the controls; see `receding_horizon`.

    Returns
    -------
    ExploringBoard
        `plan` and `looks` are the plan and the looks shown.

    Raises
    ------
    InvalidParameter

    Examples
    --------
    >>> from kinoedu import Point, PolygonWorld, Problem
    >>> room = [(0, 0), (10, 0), (10, 10), (0, 10)]
    >>> world = PolygonWorld(room, [[(4, 0), (6, 0), (6, 8), (4, 8)]])
    >>> exploring_board(Problem(Point(), world, start=(1, 1), goal=(9, 1)), 6)
    ExploringBoard(at the goal after 14 looks, walked 17.79)
    """
    return ExploringBoard(problem, reach, horizon, rng)


class ExploringBoard(Framed):
    """The widget that `exploring_board` returns: controls, and the exploration in `canvas`."""

    def __init__(
        self, problem: ProblemRecord, reach: float | None, horizon: float | None, rng: int
    ) -> None:
        self._given = check_in_plane(problem)
        among_polygons = isinstance(problem.world, PolygonWorldRecord)
        if not among_polygons or not isinstance(problem.robot, RoundRobot):
            raise InvalidParameter(get_message("exploring_board.needs", given=shortened(problem)))
        size = world_size(problem)
        sight = size / 5.0 if reach is None else positive(reach, "reach")
        ahead = sight / 2.0 if horizon is None else horizon
        self.reach = make_length_slider("exploring_board.reach", size, sight)
        self.horizon = make_length_slider("exploring_board.horizon", size, ahead)
        self.seed = make_counter("exploring_board.seed", integer(rng, "rng", least=0), 0, 99)
        self.looks: list[Look] = []
        self.plan: Plan | None = None
        self.code = make_code_box()
        controls = [self.reach, self.horizon, self.seed, self.code]
        super().__init__(controls, [make_problem_canvas(problem, self.answer)])

    def answer(self, scene: Scene) -> Drawing:
        """Explore a scene: while something is dragged its first looks, then the whole."""
        self.looks, self.plan = [], None
        problem = problem_in(scene, self._given)
        given = {"reach": self.reach.value, "horizon": self.horizon.value, "rng": self.seed.value}
        explore = partial(receding_horizon_looks, problem, **given, rays=RAYS, max_moves=MOST)
        looks = explore()

        def finish() -> Drawing:
            whole = self._draw_on(problem, looks)
            if not self.code.value:
                return whole.completed
            run = trace_lines(receding_horizon_looks, LOOK, lambda _: list(explore()))
            return run.draw_over(whole)

        first = self._draw_on(problem, islice(looks, DRAGGED))
        if len(self.looks) == DRAGGED and self.plan is not None and self.plan.path is None:
            text = get_message("exploring_board.first", looks=DRAGGED)
            first = replace(first, text=text, unfinished=True)
        return first.completed_by(finish)

    def _draw_on(self, problem: ProblemRecord, looks: Iterable[Look]) -> Drawing:
        """Draw the exploration with further looks."""
        self.looks += looks
        self.plan = plan_from_looks(problem, self.looks)
        return draw_exploration(self.plan, self.looks)
