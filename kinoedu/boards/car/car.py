"""The car's board: set two poses, and see the motion planned and driven, or drive it yourself."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from ...collision import is_free
from ...errors import InvalidParameter, KinoeduError
from ...figures.drawing import growth_of, summary
from ...geometry.checks import Array
from ...messages import get_message
from ...planners import trajectory_along
from ...planners.registry import PLANNERS
from ...planners.tuning import integer, one_of
from ...problems import Plan, Problem, ProblemRecord
from ...problems.protocols import ProblemLike
from ...robots.car import CarRobot
from ...robots.trajectory import TrajectoryRecord
from ...support.text import shortened
from ...support.time_limit import slowdown
from ...worlds.polygon_world import PolygonWorldRecord
from ..arm.arm import obstacle_places
from ..core.drawing import Drawing, Layer
from ..core.framed import Framed, make_code_box, make_counter, make_menu, title_of
from ..core.scene import Scene, list_places, move_parts
from ..planning.plans import make_canvas, world_in
from .car_drawn import (
    Ride,
    describe_ride,
    draw_ends,
    draw_growth,
    draw_rear_axle_path,
    draw_refused,
    draw_ride,
    follow_car,
    make_ride,
    note_tree,
)
from .car_poses import CAR, handle_places, make_car_scene, poses_in
from .driving import continue_drive, is_at_goal, start_drive, steering_angle
from .lit import trace_car_planner

YOU = "you"
# The iterations of a planner that a page waits for while something is dragged, on a typical
# computer; a slower one does fewer. The first ones are the same however many follow.
DRAGGED = {"kinodynamic_rrt": 220, "kinodynamic_prm": 90, "rrt": 180}
VIEWS = ("above", "followed")


ON_BOARD = {name: planner for name, planner in PLANNERS.items() if planner.car_board}


def car_board(
    problem: ProblemRecord,
    planner: str = "kinodynamic_rrt",
    *,
    max_iterations: int | None = None,
    view: str = "above",
    rng: int = 0,
) -> CarBoard:
    """Set a car's start and goal pose, and see its motion planned and driven; or drive yourself.

    While something is dragged, a planner does its first iterations only, and the text says so; the
    others follow when everything rests.

    Press on the ground to set the goal, with Shift the start, and pull its heading; or drag places,
    tips and obstacles. A pose that is not free is refused, with the reason, and returns to where it
    was free. Scrub: first the tree or roadmap grows, then the car drives with its wheels steered.
    Hold arrow keys at the car to drive it: left and right turn the wheel by notches, up and down
    drive forward and back. The car stops before a collision. With the box "code" the lines of the
    planner are shown as they run.

    Parameters
    ----------
    problem : a Problem of a Car.
    planner : "kinodynamic_rrt", "kinodynamic_prm", "rrt" (which steers by Reeds and Shepp's
        curves), or "you".
    max_iterations : where a planner gives up; of the roadmap, how many configurations are sampled.
        The default is 1,000, and 350 for the roadmap.
    view : "above", or "followed" for a view that moves with the car.
    rng : the first seed.

    Returns
    -------
    CarBoard
        `plan` is the plan shown, None while you drive; `driven` is the Trajectory that you drove;
        `problem` is the problem solved.

    Raises
    ------
    InvalidParameter

    Examples
    --------
    >>> from kinoedu import Car, PolygonWorld, Problem
    >>> room = [(0, 0), (20, 0), (20, 20), (0, 20)]
    >>> world = PolygonWorld(room, [[(9, 0), (11, 0), (11, 10), (9, 10)]])
    >>> car_board(Problem(Car(3, 1, 2), world, (4, 4, 0), (16, 4, 0)), "you")
    CarBoard(you have driven 0; the wheels are turned by 0°)
    """
    return CarBoard(problem, planner, max_iterations, view, rng)


class CarBoard(Framed):
    """The widget that `car_board` returns: the controls, and the car in `canvas`."""

    def __init__(
        self, problem: ProblemRecord, planner: str, max_iterations: int | None, view: str, rng: int
    ) -> None:
        self.problem = check_car_problem(problem)
        self.plan: Plan | None = None
        chosen = one_of(planner, "planner", (*ON_BOARD, YOU))
        default = ON_BOARD.get(chosen, ON_BOARD["rrt"]).car_board
        most = integer(
            default if max_iterations is None else max_iterations, "max_iterations", least=1
        )
        titles = [(title_of(one, "car_board"), name) for name, one in ON_BOARD.items()]
        self.planner = make_menu("board.planner", [*titles, *make_options([YOU])], chosen)
        self.iterations = make_counter("car_board.iterations", most, 50, 3000)
        self.seed = make_counter("board.seed", integer(rng, "rng", least=0), 0, 99)
        self.view = make_menu("car_board.view", make_options(VIEWS), one_of(view, "view", VIEWS))
        self.code = make_code_box()
        self._drive, self._ends = start_drive(problem), (problem.start, problem.goal)
        self._home = self._good = make_car_scene(problem)
        self._drawing = Drawing()
        canvas = make_canvas(problem.world, self._home, self.answer, self.hold)
        controls = [self.planner, self.iterations, self.seed, self.view, self.code]
        super().__init__(controls, [canvas])

    @property
    def driven(self) -> TrajectoryRecord:
        """The trajectory that you drove, with its `poses` and `controls`."""
        return self._drive.trajectory

    def answer(self, scene: Scene) -> Drawing:
        """Take over what was moved, plan or show the drive, and draw it."""
        try:
            self._take(scene)
        except KinoeduError as error:
            return self._refusal(scene, str(error))
        drawing = self._by_you() if self.planner.value == YOU else self._by_planner()
        self._good, self._drawing = move_parts(scene, drawing.places), drawing
        return drawing

    def hold(self, held: set[str]) -> None:
        """Drive for a moment, with the arrow keys of these names held."""
        self.planner.value = YOU
        self._drive = continue_drive(self.problem, self._drive, held)

    def _take(self, scene: Scene) -> None:
        """Take over what was moved.

        The drive begins again where its start or an obstacle moved, or the board was reset.
        """
        before, car = self.problem, self.problem.robot
        stood, world = obstacle_places(scene) == obstacle_places(self._good), before.world
        if isinstance(world, PolygonWorldRecord) and not stood:
            world = world_in(scene)
        ends = poses_in(scene, car, [(before.start, before.goal), self._ends])
        self.problem = Problem(car, world, *ends, clearance=before.clearance)
        at, there, home = (some["handles"][CAR]["at"] for some in (scene, self._good, self._home))
        new_start = not np.array_equal(before.start, self.problem.start)
        reset = at != there and at == home
        if not stood or new_start or reset:
            self._drive = start_drive(self.problem)

    def _refusal(self, scene: Scene, reason: str) -> Drawing:
        """Keep the last valid drawing; show the refused pose until it is released."""
        last = self.problem
        ends = poses_in(scene, last.robot, [(last.start, last.goal)])
        wrong = [q for q in ends if not is_free(last.robot, last.world, q, last.clearance)]
        refused, valid = draw_refused(last.robot, wrong), self._drawing
        places = list_places(self._good)

        def warn(drawing: Drawing) -> Drawing:
            layers = [*drawing.layers, *refused]
            return replace(drawing, layers=layers, warning=reason, places=places, whole=None)

        whole = valid.whole
        return warn(valid) if whole is None else warn(valid).completed_by(lambda: warn(whole()))

    def _by_planner(self) -> Drawing:
        """Draw the plan of the first iterations, completed by the plan of all."""
        most = self.iterations.value
        few = min(most, math.ceil(DRAGGED[self.planner.value] / slowdown()))
        self.plan = plan = self._plan(self.problem, few)
        if few == most or (plan.tree is not None and plan.path is not None):  # it has stopped
            return self._draw_plan(plan)

        def finish() -> Drawing:
            self.plan = self._plan(problem, most)
            return self._draw_plan(self.plan).completed

        problem, drawing = self.problem, self._draw_plan(plan)
        found = drawing.text if plan.path is not None else get_message("car_board.none_yet")
        first = get_message("car_board.first", few=f"{few:,}", most=f"{most:,}")
        return replace(drawing, text=f"{found}\n{first}", whole=finish, unfinished=True)

    def _plan(self, problem: Any, iterations: int) -> Plan:
        """The plan of the chosen planner for the problem, or for a recorder of it."""
        planner = ON_BOARD[self.planner.value]
        return planner.plan(problem, seed=self.seed.value, iterations=iterations)

    def _draw_plan(self, plan: Plan) -> Drawing:
        """Draw a plan: its growth, then the ride along its trajectory.

        Without a path the ride leads to the pose nearest to the goal.
        """
        grown, begin = draw_growth(self.problem.robot, plan)
        total, unit = growth_of(plan)
        problem, name, ride = self.problem, self.planner.value, make_ride(trajectory_of(plan))
        text = summary(plan, total)

        def ride_along() -> Drawing:
            layer = grown if plan.tree is None else note_tree(grown, plan.tree)
            counts = {"planner": plan.planner, "total": f"{total:,}", "unit": unit}
            shown = (f"{k * total // begin:,}" for k in range(begin))
            texts = [get_message("figure.growing", shown=count, **counts) for count in shown]
            cars = draw_ride(problem.robot, ride, begin)
            drawing = self._ridden(ride, begin, [layer], cars, text, problem.start)
            return replace(drawing, step_texts=[*texts, *describe_ride(ride)[:-1]])

        def show_lines() -> Drawing:
            call = partial(self._plan, iterations=self.iterations.value)
            run = trace_car_planner(name, problem, call, begin / max(total, 1))
            ends = draw_ends(problem.robot, (problem.start, problem.goal))
            return run.draw_over(Drawing([grown, *ends], text=text))

        parked = draw_ride(problem.robot, ride.last, begin + len(ride.times) - 1)
        drawing = self._ridden(ride, begin, [grown], parked, text, problem.start)
        return drawing.completed_by(show_lines if self.code.value else ride_along)

    def _by_you(self) -> Drawing:
        """Draw what you have driven."""
        self.plan = None
        ride, phi = make_ride(self.driven), steering_angle(self.problem.robot, self._drive.notch)
        ride.controls[-1, 1] = phi
        here, car = ride.poses[-1], self.problem.robot
        values = {"length": f"{self.driven.length:.4g}", "phi": f"{np.degrees(phi):.0f}"}
        lines = [get_message("car_board.driven", **values)]
        lines += [get_message("car_board.contact")] if self._drive.stopped else []
        lines += [get_message("car_board.arrived")] if is_at_goal(self.problem, here) else []
        cars = draw_ride(car, ride, 0, hit=self._drive.stopped)
        drawing = self._ridden(ride, 0, [], cars, "\n".join(lines), here)
        return drawing.with_texts(lambda: describe_ride(ride)[:-1])

    def _ridden(
        self,
        ride: Ride,
        begin: int,
        grown: list[Layer],
        cars: list[Layer],
        text: str,
        here: Array,
    ) -> Drawing:
        """Draw what has grown until step `begin`, and the ride that follows.

        cars : the car at the moments of the ride.
        here : the pose of the car that can be driven.
        """
        car, ends = self.problem.robot, (self.problem.start, self.problem.goal)
        layers = [*grown, *draw_ends(car, ends), *draw_rear_axle_path(ride, begin), *cars]
        layers += [follow_car(car, ride, begin)] if self.view.value == "followed" else []
        places = [("handle", k, place) for k, place in enumerate(handle_places(car, *ends, here))]
        total, unit = begin + len(ride.times) - 1, get_message("car_board.unit")
        return Drawing(layers, text=text, total=total, unit=unit, places=places)

    def _dress(self) -> None:
        """Show the controls that apply to the chosen planner."""
        for control in (self.iterations, self.seed, self.code):
            control.layout.display = "none" if self.planner.value == YOU else None

    def _changed(self, change: Any) -> None:
        """Answer again; another planner begins with its own number of iterations."""
        if change["owner"] is self.planner and change["new"] != YOU:
            self.iterations.unobserve(self._changed, "value")
            self.iterations.value = ON_BOARD[change["new"]].car_board
            self.iterations.observe(self._changed, "value")
        super()._changed(change)


def check_car_problem(problem: ProblemLike) -> ProblemRecord:
    """The problem itself, if it is a car's; or InvalidParameter."""
    if not isinstance(problem, ProblemRecord) or not isinstance(problem.robot, CarRobot):
        raise InvalidParameter(
            f"a car board needs a Problem(Car(...), world, start, goal), got {shortened(problem)}"
        )
    return problem


def make_options(names: Iterable[str]) -> list[tuple[str, str]]:
    """The options of a menu: pairs (text, name)."""
    return [(get_message(f"car_board.{name}"), name) for name in names]


def trajectory_of(plan: Plan) -> TrajectoryRecord:
    """The trajectory of a car in a plan; empty without a path and a trajectory."""
    if plan.path is not None:
        return trajectory_along(plan)
    return plan.trajectory or start_drive(plan.problem).trajectory
