"""The board of moving obstacles: a slider of time, and everything where it is then; planned anew
when something is dragged.
"""

from typing import Any

import ipywidgets as widgets
import numpy as np

from ...errors import InvalidParameter, KinoeduError
from ...figures.moving import outline_of
from ...figures.robots import outline_at
from ...geometry.checks import Array
from ...planners import plan_in_time
from ...planners.tuning import whole
from ...problems import Plan
from ...problems.in_time import TimedProblem, TimedProblemRecord
from ...robots.round import RoundRobot
from ...support.text import shortened
from ...words import say
from ...worlds.moving import MovingWorldRecord, movers_at
from ..arm.rides import line
from ..core.canvas import Canvas
from ..core.controls import counter, look
from ..core.drawing import Drawing, Layer, bodies, dots, edges
from ..core.framed import Framed
from ..core.scene import Scene, handle, place_of
from ..planning.plans import GOAL, START, scene_with, world_in

STEPS = 150  # of the time slider


def moving_board(problem: TimedProblemRecord, *, nodes: int = 200, rng: int = 0) -> "MovingBoard":
    """Scrub through time: the obstacles, and the robot on its way. Drag start, goal, or what stands
    still; change the speed.

    Parameters
    ----------
    problem : a TimedProblem. nodes, rng : of the roadmap, and where the seed begins; see
    `plan_in_time`.

    `board.plan` is on show. Raises InvalidParameter.

    >>> from kinoedu import Disk, Moving, MovingWorld, PolygonWorld, TimedProblem
    >>> hall = PolygonWorld([(0, 0), (10, 0), (10, 6), (0, 6)])
    >>> world = MovingWorld(hall, [Moving(1.0, [0, 10], [(9, 3), (-1, 3)])])
    >>> moving_board(TimedProblem(Disk(0.5), world, start=(1, 3), goal=(9, 3)))
    MovingBoard(at the goal at the time 9.24; it has waited 0)
    """
    return MovingBoard(problem, nodes, rng)


class MovingBoard(Framed):
    """What `moving_board` makes: the controls, and the world in `canvas`, whose slider is the
    time.
    """

    def __init__(self, problem: TimedProblemRecord, nodes: int, rng: int) -> None:
        if not isinstance(problem, TimedProblemRecord):
            raise InvalidParameter(say("moving_board.needs", given=shortened(problem)))
        self._given, self._nodes = problem, whole(nodes, "nodes", least=0)
        notch = problem.speed / 10.0
        self.speed = widgets.FloatSlider(
            problem.speed, min=3 * notch, max=30 * notch, step=notch, readout_format=".3g",
            **{**look("step"), "description": say("moving_board.speed")},
        )  # fmt: skip
        self.seed = counter("board.seed", whole(rng, "rng", least=0), 0, 99)
        self.plan: Plan | None = None
        handles = [
            handle(START, problem.start, colour="start"),
            handle(GOAL, problem.goal, colour="goal", marker="star"),
        ]
        super().__init__(
            [self.speed, self.seed], [Canvas(scene_with(problem.world.still, handles), self.answer)]
        )

    def answer(self, scene: Scene) -> Drawing:
        """Plan in a scene, and draw all its moments; where nothing can be planned, say why, and
        show what moves at the time 0.
        """
        self.plan = None
        try:
            return self.planned(scene)
        except KinoeduError as error:
            return Drawing(movers_drawn(self._given.world, np.zeros(1)), warning=str(error))

    def planned(self, scene: Scene) -> Drawing:
        """The plan in a scene, at all its moments. Raises KinoeduError."""
        given = self._given
        world = given.world._replace(still=world_in(scene))
        ends = place_of(scene, START), place_of(scene, GOAL)
        problem = TimedProblem(
            given.robot,
            world,
            *ends,
            speed=self.speed.value,
            horizon=given.horizon,
            clearance=given.clearance,
        )
        self.plan = plan = plan_in_time(problem, n=self._nodes, rng=self.seed.value)
        last = (
            plan.cost
            if plan.path is not None
            else float(world.times.max())
            if len(world.times)
            else 1.0
        )
        moments = np.linspace(0.0, max(last, 1e-9), STEPS + 1)
        layers = [
            edges(plan.roadmap.nodes[plan.roadmap.edges], "roadmap", width=0.4),
            *movers_drawn(world, moments),
        ]
        if plan.path is None:
            text = say("moving_board.none", reason=plan.reason)
        else:
            text = say(
                "moving_board.there", time=f"{plan.cost:.3g}", waited=f"{waited(plan.path):.3g}"
            )
            layers += way_drawn(problem.robot, plan.path, moments)
        told = [
            say(f"moving_board.{'waits' if stands_at(plan.path, t) else 'now'}", time=f"{t:.2f}")
            for t in moments[:-1]
        ]
        return Drawing(layers, text=text, total=STEPS, unit=say("moving_board.unit"), told=told)


def movers_drawn(world: MovingWorldRecord, moments: Array) -> list[Layer]:
    """What moves, at each moment."""
    layers, steps = [], np.arange(len(moments))
    for k, mover in enumerate(movers_at(world, float(moments[0]))):
        begin, end = world.knots[np.flatnonzero(world.owner == k)[0]]
        stops = between_rows(world.times[begin:end], world.places[begin:end], moments)
        shapes = outline_of(*mover) + (stops - stops[0])[:, None]
        layers.append(bodies(shapes, "obstacle", hatched=True, when=steps, until=steps + 1))
    return layers


def way_drawn(robot: Any, path: Array, moments: Array) -> list[Layer]:
    """The path, and the robot at each moment."""
    stops, steps = between_rows(path[:, 2], path[:, :2], moments), np.arange(len(moments))
    legs = np.stack([path[:-1, :2], path[1:, :2]], axis=1)
    layers = [*line(legs), dots(stops, "robot", radius=6.0, when=steps, until=steps + 1)]
    if isinstance(robot, RoundRobot) and robot.radius == 0.0:
        return layers
    origin = np.zeros(2)
    shape = (
        outline_of(origin[None], robot.radius)
        if isinstance(robot, RoundRobot)
        else outline_at(robot, origin)
    )
    return [*layers, bodies(shape + stops[:, None], "robot", when=steps, until=steps + 1)]


def between_rows(times: Array, places: Array, moments: Array) -> Array:
    """Where something is at moments (k,) that is at places[i] at times[i] and moves straight
    between them; shape (k, 2).
    """
    return np.column_stack([np.interp(moments, times, places[:, axis]) for axis in (0, 1)])


def stands(path: Array) -> Any:
    """Whether each leg of a path (m, 3) stays where it is."""
    return (path[1:, :2] == path[:-1, :2]).all(axis=1)


def stands_at(path: Array | None, t: float) -> bool:
    """Whether the robot waits at a time."""
    return path is not None and bool(stands(path)[np.searchsorted(path[1:-1, 2], t, side="right")])


def waited(path: Array) -> float:
    """For how long a path (m, 3) stays where it is."""
    return float(np.diff(path[:, 2])[stands(path)].sum())
