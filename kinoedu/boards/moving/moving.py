"""The board of moving obstacles: a slider of time, and a plan for the whole time."""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np

from ...errors import InvalidParameter, KinoeduError
from ...figures.moving import outline_of
from ...figures.robots import outline_at
from ...geometry.checks import Array
from ...messages import get_message
from ...planners import plan_in_time
from ...planners.moving.safe_intervals import search_intervals
from ...planners.tuning import integer
from ...problems import Plan
from ...problems.in_time import TimedProblem, TimedProblemRecord
from ...robots.round import RoundRobot
from ...support.text import shortened
from ...worlds.moving import MovingWorldRecord, movers_at
from ..core.canvas import Canvas
from ..core.drawing import Drawing, Layer, bodies, dots, edges, path_edges, segments_along
from ..core.framed import Framed, NotchedSlider, control_style, make_code_box, make_counter
from ..core.scene import Scene, handle, place_of
from ..planning.plans import GOAL, START, make_world_scene, world_in
from ..tracing.code_run import Look, trace_lines

STEPS = 150  # of the time slider
LOOK = Look(  # at the code of the search
    {
        "q_u": "nodes[u]",
        "q_v": "nodes[v]",
        "intervals of v": "safe[first[v]:first[v + 1]].tolist()",
    },
    lines=(("q_u", "q_v"),),
    colours={"q_u": "path", "q_v": "hit"},
    hidden=(
        *("nodes", "safe", "first", "hulls", "knots", "times", "places", "owner", "collisions"),
        *("arrival", "departure", "parent"),
    ),
)


def moving_board(problem: TimedProblemRecord, *, nodes: int = 200, rng: int = 0) -> MovingBoard:
    """Scrub through time: the moving obstacles and the robot on its path.

    Drag start, goal or static obstacles, or change the speed, and it is planned again. With the box
    "code" a step is a line of the search over safe intervals.

    Parameters
    ----------
    problem : a TimedProblem.
    nodes : the number of the roadmap's nodes; see `plan_in_time`.
    rng : the first seed.

    Returns
    -------
    MovingBoard
        `plan` is the plan shown.

    Raises
    ------
    InvalidParameter

    Examples
    --------
    >>> from kinoedu import Disk, Moving, MovingWorld, PolygonWorld, TimedProblem
    >>> hall = PolygonWorld([(0, 0), (10, 0), (10, 6), (0, 6)])
    >>> world = MovingWorld(hall, [Moving(1.0, [0, 10], [(9, 3), (-1, 3)])])
    >>> moving_board(TimedProblem(Disk(0.5), world, start=(1, 3), goal=(9, 3)))
    MovingBoard(at the goal at time 9.24, waited 0)
    """
    return MovingBoard(problem, nodes, rng)


class MovingBoard(Framed):
    """The widget that `moving_board` returns: controls, and the world in `canvas`.

    The slider of the canvas is the time.
    """

    def __init__(self, problem: TimedProblemRecord, nodes: int, rng: int) -> None:
        if not isinstance(problem, TimedProblemRecord):
            raise InvalidParameter(get_message("moving_board.needs", given=shortened(problem)))
        self._given, self._nodes = problem, integer(nodes, "nodes", least=0)
        notch = problem.speed / 10.0
        span = {"min": 3 * notch, "max": 30 * notch, "step": notch, "readout_format": ".3g"}
        self.speed = NotchedSlider(problem.speed, **span, **control_style("moving_board.speed"))
        self.seed = make_counter("board.seed", integer(rng, "rng", least=0), 0, 99)
        self.code = make_code_box()
        self.plan: Plan | None = None
        handles = [
            handle(START, problem.start, colour="start"),
            handle(GOAL, problem.goal, colour="goal", marker="star"),
        ]
        canvas = Canvas(make_world_scene(problem.world.still, handles), self.answer)
        super().__init__([self.speed, self.seed, self.code], [canvas])

    def answer(self, scene: Scene) -> Drawing:
        """Plan in a scene and draw all moments.

        Where planning fails, draw the moving obstacles at time 0 with the reason.
        """
        self.plan = None
        try:
            return self.planned(scene)
        except KinoeduError as error:
            return Drawing(draw_movers(self._given.world, np.zeros(1)), warning=str(error))

    def planned(self, scene: Scene) -> Drawing:
        """The drawing of a plan in a scene, at all its moments, or KinoeduError."""
        problem = self._problem_in(scene)
        world = problem.world
        call = partial(plan_in_time, problem, n=self._nodes, rng=self.seed.value)
        self.plan = plan = call()
        rest = float(world.times.max()) if len(world.times) else 1.0
        last = plan.cost if plan.path is not None else rest
        moments = np.linspace(0.0, max(last, 1e-9), STEPS + 1)
        layers = [
            edges(plan.roadmap.nodes[plan.roadmap.edges], "roadmap", width=0.4),
            *draw_movers(world, moments),
        ]
        if plan.path is None:
            text = get_message("moving_board.none", reason=plan.reason)
        else:
            times = {"time": f"{plan.cost:.3g}", "waited": f"{waiting_time(plan.path):.3g}"}
            text = get_message("moving_board.there", **times)
            layers += draw_path(problem.robot, plan.path, moments)
        drawing = Drawing(layers, text=text, total=STEPS, unit=get_message("moving_board.unit"))
        if not self.code.value:
            return drawing.with_texts(lambda: describe_moments(plan.path, moments[:-1]))
        return drawing.completed_by(
            lambda: trace_lines(search_intervals, LOOK, lambda _: call()).draw_over(
                Drawing(layers, text=text)
            )
        )

    def _problem_in(self, scene: Scene) -> TimedProblemRecord:
        """The given problem with everything where the scene has it, at the speed chosen."""
        given = self._given
        world = given.world._replace(still=world_in(scene))
        ends = place_of(scene, START), place_of(scene, GOAL)
        limits = {"horizon": given.horizon, "clearance": given.clearance}
        return TimedProblem(given.robot, world, *ends, speed=self.speed.value, **limits)


def describe_moments(path: Array | None, moments: Array) -> list[str]:
    """The time at each moment, and whether the robot waits, in words."""
    keys = ["waits" if waits_at(path, t) else "now" for t in moments.tolist()]
    times = [f"{t:.2f}" for t in moments.tolist()]
    return [get_message(f"moving_board.{key}", time=time) for key, time in zip(keys, times)]


def draw_movers(world: MovingWorldRecord, moments: Array) -> list[Layer]:
    """Draw the moving obstacles at each moment."""
    layers, steps = [], np.arange(len(moments))
    for k, mover in enumerate(movers_at(world, float(moments[0]))):
        begin, end = world.knots[np.flatnonzero(world.owner == k)[0]]
        stops = interpolate_places(world.times[begin:end], world.places[begin:end], moments)
        shapes = outline_of(*mover) + (stops - stops[0])[:, None]
        layers.append(bodies(shapes, "obstacle", hatched=True, when=steps, until=steps + 1))
    return layers


def draw_path(robot: Any, path: Array, moments: Array) -> list[Layer]:
    """Draw the path, and the robot at each moment."""
    stops, steps = interpolate_places(path[:, 2], path[:, :2], moments), np.arange(len(moments))
    span: Any = {"when": steps, "until": steps + 1}
    layers = path_edges(segments_along(path[:, :2]))
    layers.append(dots(stops, "robot", radius=6.0, **span))
    origin = np.zeros(2)
    if not isinstance(robot, RoundRobot):
        shape = outline_at(robot, origin)
    elif robot.radius > 0.0:
        shape = outline_of(origin[None], robot.radius)
    else:
        return layers
    return [*layers, bodies(shape + stops[:, None], "robot", **span)]


def interpolate_places(times: Array, places: Array, moments: Array) -> Array:
    """The positions (k, 2) at moments (k,), interpolated between places[i] at times[i]."""
    return np.column_stack([np.interp(moments, times, places[:, axis]) for axis in (0, 1)])


def waits_on_legs(path: Array) -> Any:
    """Whether the robot waits on each leg of a path (m, 3)."""
    return (path[1:, :2] == path[:-1, :2]).all(axis=1)


def waits_at(path: Array | None, t: float) -> bool:
    """Whether the robot waits at a time; not on a path of one place, nor without one."""
    if path is None or len(path) < 2:
        return False
    return bool(waits_on_legs(path)[np.searchsorted(path[1:-1, 2], t, side="right")])


def waiting_time(path: Array) -> float:
    """The total waiting time of a path (m, 3)."""
    return float(np.diff(path[:, 2])[waits_on_legs(path)].sum())
