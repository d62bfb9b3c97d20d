"""The exploring board: a robot that sees no farther than its sensor goes its way through an unknown
world.
"""

from ...errors import InvalidParameter
from ...planners.exploring.receding_horizon import Look, plan_of_looks, receding_horizon_looks
from ...planners.problem_input import world_size
from ...planners.tuning import positive, whole
from ...problems import Plan, ProblemRecord
from ...robots.round import RoundRobot
from ...support.text import shortened
from ...words import say
from ...worlds.polygon_world import PolygonWorldRecord
from ..core.controls import counter, length_slider
from ..core.drawing import Drawing
from ..core.framed import Framed
from ..core.scene import Scene
from ..planning.plans import canvas_for, in_plane, problem_in
from .explored import exploration_drawn

RAYS = 180


def exploring_board(
    problem: ProblemRecord,
    reach: float | None = None,
    *,
    horizon: float | None = None,
    rng: int = 0,
) -> "ExploringBoard":
    """Scrub along a robot that looks, plans in what it has seen, goes a little way, and looks
    again; drag start, goal, obstacles.

    Blue is what has been seen, framed what is seen now, red the walls in the map; the dashed line
    is the plan in that map, in which what was never seen counts as free.

    Parameters
    ----------
    problem : a Problem of a Point or a Disk in a PolygonWorld.
    reach, horizon, rng : where the controls begin; see `receding_horizon`.

    `board.plan` and `board.looks` are on show. Raises InvalidParameter.

    >>> from kinoedu import Point, PolygonWorld, Problem
    >>> world = PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [[(4, 0), (6, 0), (6, 8), (4, 8)]])
    >>> exploring_board(Problem(Point(), world, start=(1, 1), goal=(9, 1)), 6)
    ExploringBoard(at the goal after 16 looks, walked 23.96)
    """
    return ExploringBoard(problem, reach, horizon, rng)


class ExploringBoard(Framed):
    """What `exploring_board` makes: the controls, and the exploration in `canvas`."""

    def __init__(
        self, problem: ProblemRecord, reach: float | None, horizon: float | None, rng: int
    ) -> None:
        self._given = in_plane(problem)
        if not isinstance(problem.robot, RoundRobot) or not isinstance(
            problem.world, PolygonWorldRecord
        ):
            raise InvalidParameter(say("exploring_board.needs", given=shortened(problem)))
        size = world_size(problem)
        sight = size / 5.0 if reach is None else positive(reach, "reach")
        self.reach = length_slider("exploring_board.reach", size, sight)
        self.horizon = length_slider(
            "exploring_board.horizon", size, sight / 2.0 if horizon is None else horizon
        )
        self.seed = counter("exploring_board.seed", whole(rng, "rng", least=0), 0, 99)
        self.looks: list[Look] = []
        self.plan: Plan | None = None
        super().__init__([self.reach, self.horizon, self.seed], [canvas_for(problem, self.answer)])

    def answer(self, scene: Scene) -> Drawing:
        """Explore a scene, and draw the way with all that was seen on it."""
        self.looks, self.plan = [], None
        problem = problem_in(scene, self._given)
        self.looks = list(
            receding_horizon_looks(
                problem,
                reach=self.reach.value,
                horizon=self.horizon.value,
                rays=RAYS,
                max_moves=60,
                rng=self.seed.value,
            )
        )
        self.plan = plan_of_looks(problem, self.looks)
        return exploration_drawn(self.plan, self.looks)
