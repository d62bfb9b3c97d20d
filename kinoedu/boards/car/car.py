"""The car's board: two poses to set, a planner that leads from one to the other, and the car that
drives there; or you drive it.
"""

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

import numpy as np

from ...collision import is_free
from ...errors import InvalidParameter, KinoeduError
from ...figures.drawing import growth_of, summary
from ...geometry.checks import Array
from ...planners import trajectory_along
from ...planners.registry import PLANNERS
from ...planners.tuning import one_of, whole
from ...problems import Plan, Problem, ProblemRecord
from ...robots.car import CarRobot
from ...robots.trajectory import TrajectoryRecord
from ...support.text import shortened
from ...words import say
from ...worlds.polygon_world import PolygonWorldRecord
from ..arm.arm import standing
from ..core.controls import counter, menu, title_of
from ..core.drawing import Drawing, Layer
from ..core.framed import Framed
from ..core.scene import Scene, everything, moved
from ..planning.plans import canvas_of, world_in
from .car_drawn import (
    Ride,
    ends_drawn,
    followed,
    growth_drawn,
    refused_drawn,
    ride_along,
    ride_drawn,
    told_on,
    way_drawn,
)
from .car_poses import CAR, car_scene, handle_places, poses_in
from .driving import at_goal, driven_on, standing_at, steering

YOU = "you"
VIEWS = ("above", "followed")


ON_BOARD = {name: planner for name, planner in PLANNERS.items() if planner.car_board}


def car_board(
    problem: ProblemRecord,
    planner: str = "kinodynamic_rrt",
    *,
    iterations: int | None = None,
    view: str = "above",
    rng: int = 0,
) -> "CarBoard":
    """Set where a car starts and where it is to go, each with a heading, and see it planned and
    driven; or drive it yourself.

    Press on the ground to set the goal, with Shift the start, and pull the heading; or drag places,
    tips, obstacles. What is not free is refused, with the reason, and goes back to where it was
    free. Scrub: first the tree or roadmap grows, then the car drives, its wheels steered. Hold
    arrow keys at the car, and you drive it: left and right turn the wheel by notches, up and down
    go forward and back. It stops at what it would touch.

    Parameters
    ----------
    problem : a Problem of a Car.
    planner : who drives: "kinodynamic_rrt", "kinodynamic_prm", "rrt", which steers by Reeds and
    Shepp's curves, or "you".
    iterations : where a planner gives up, of the roadmap how many places are drawn; by default
    1,000, and 350. view, rng : where the other controls begin; a view is "above", or "followed",
    which goes with the car.

    `board.plan` is on show, None where you drive; `board.driven` is the Trajectory that you drove,
    `board.problem` what was asked. Raises InvalidParameter.

    >>> from kinoedu import Car, PolygonWorld, Problem
    >>> world = PolygonWorld([(0, 0), (20, 0), (20, 20), (0, 20)], [[(9, 0), (11, 0), (11, 10), (9, 10)]])
    >>> car_board(Problem(Car(3, 1, 2), world, (4, 4, 0), (16, 4, 0)), "you")
    CarBoard(you have driven 0; the wheels are turned by 0°)
    """
    return CarBoard(problem, planner, iterations, view, rng)


class CarBoard(Framed):
    """What `car_board` makes: the controls, and the car in `canvas`."""

    def __init__(
        self, problem: ProblemRecord, planner: str, iterations: int | None, view: str, rng: int
    ) -> None:
        self.problem = of_a_car(problem)
        self.plan: Plan | None = None
        chosen = one_of(planner, "planner", (*ON_BOARD, YOU))
        most = ON_BOARD.get(chosen, ON_BOARD["rrt"]).car_board if iterations is None else iterations
        titles = [(title_of(planner, "car_board"), name) for name, planner in ON_BOARD.items()]
        self.planner = menu("board.planner", [*titles, *named([YOU])], chosen)
        self.iterations = counter(
            "car_board.iterations", whole(most, "iterations", least=1), 50, 3000
        )
        self.seed = counter("board.seed", whole(rng, "rng", least=0), 0, 99)
        self.view = menu("car_board.view", named(VIEWS), one_of(view, "view", VIEWS))
        self._drive, self._ends = standing_at(problem), (problem.start, problem.goal)
        self._home = self._good = car_scene(problem)
        self._drawing = Drawing()
        self._dress()
        canvas = canvas_of(problem.world, self._home, self.answer, self.hold)
        super().__init__([self.planner, self.iterations, self.seed, self.view], [canvas])

    @property
    def driven(self) -> TrajectoryRecord:
        """What you have driven: replay it by `board.driven.poses`, look at it by
        `board.driven.controls`.
        """
        return self._drive.trajectory

    def answer(self, scene: Scene) -> Drawing:
        """Take what was moved, plan or show what was driven, and draw it."""
        try:
            self._take(scene)
        except KinoeduError as error:
            return self._refusal(scene, str(error))
        self.plan = None if self.planner.value == YOU else self._planned()
        drawing = self._by_you() if self.plan is None else self._by_planner(self.plan)
        self._good, self._drawing = moved(scene, drawing.places), drawing
        return drawing

    def hold(self, held: set[str]) -> None:
        """Drive for a moment, with the arrow keys of these names held."""
        self.planner.value = YOU
        self._drive = driven_on(self.problem, self._drive, held)

    def _take(self, scene: Scene) -> None:
        """Take what was moved. A drive begins anew where its start or an obstacle is elsewhere, or
        the board was started again.
        """
        before, car = self.problem, self.problem.robot
        stood = standing(scene) == standing(self._good)
        world = (
            world_in(scene)
            if isinstance(before.world, PolygonWorldRecord) and not stood
            else before.world
        )
        ends = poses_in(scene, car, [(before.start, before.goal), self._ends])
        self.problem = Problem(car, world, *ends, clearance=before.clearance)
        at, there, home = (some["handles"][CAR]["at"] for some in (scene, self._good, self._home))
        if (
            not stood
            or not np.array_equal(before.start, self.problem.start)
            or (at != there and at == home)
        ):
            self._drive = standing_at(self.problem)

    def _refusal(self, scene: Scene, reason: str) -> Drawing:
        """What was good stays; what is refused is shown until it is let go."""
        asked = self.problem
        ends = poses_in(scene, asked.robot, [(asked.start, asked.goal)])
        wrong = [q for q in ends if not is_free(asked.robot, asked.world, q, asked.clearance)]
        layers = [*self._drawing.layers, *refused_drawn(asked.robot, wrong)]
        return replace(self._drawing, layers=layers, warning=reason, places=everything(self._good))

    def _planned(self) -> Plan:
        """The plan of the planner that is chosen."""
        return ON_BOARD[self.planner.value].plan(
            self.problem, seed=self.seed.value, iterations=self.iterations.value
        )

    def _by_planner(self, plan: Plan) -> Drawing:
        """A plan: what grows, and then the ride along its trajectory, if only to the nearest
        pose.
        """
        layers, begin = growth_drawn(self.problem.robot, plan)
        total, unit = growth_of(plan)
        counts = {"planner": plan.planner, "total": f"{total:,}", "unit": unit}
        told = [
            say("figure.growing", shown=f"{k * total // begin:,}", **counts) for k in range(begin)
        ]
        ride = ride_along(trajectory_of(plan))
        return self._ridden(
            ride,
            begin,
            layers,
            [*told, *told_on(ride)[:-1], summary(plan, total)],
            self.problem.start,
        )

    def _by_you(self) -> Drawing:
        """What you have driven."""
        ride, phi = ride_along(self.driven), steering(self.problem.robot, self._drive.notch)
        ride.controls[-1, 1] = phi
        here = ride.poses[-1]
        said = [
            say(
                "car_board.driven", length=f"{self.driven.length:.4g}", phi=f"{np.degrees(phi):.0f}"
            )
        ]
        said += [say("car_board.contact")] if self._drive.stopped else []
        said += [say("car_board.arrived")] if at_goal(self.problem, here) else []
        return self._ridden(ride, 0, [], [*told_on(ride)[:-1], "\n".join(said)], here)

    def _ridden(
        self, ride: Ride, begin: int, grown: list[Layer], told: list[str], here: Array
    ) -> Drawing:
        """What has grown until a step, and the ride that follows; the car that can be driven is
        here.
        """
        car, ends = self.problem.robot, (self.problem.start, self.problem.goal)
        layers = [*grown, *ends_drawn(car, ends), *way_drawn(ride, begin)]
        layers += ride_drawn(
            car, ride, begin, hit=self.planner.value == YOU and self._drive.stopped
        )
        layers += [followed(car, ride, begin)] if self.view.value == "followed" else []
        places = [("handle", k, place) for k, place in enumerate(handle_places(car, *ends, here))]
        *before, text = told
        return Drawing(
            layers,
            text=text,
            total=len(before),
            unit=say("car_board.unit"),
            told=before,
            places=places,
        )

    def _dress(self) -> None:
        """Show the controls that a planner takes."""
        for control in (self.iterations, self.seed):
            control.layout.display = "none" if self.planner.value == YOU else None

    def _changed(self, change: Any) -> None:
        self._dress()
        if change["owner"] is self.planner and change["new"] != YOU:
            self.iterations.unobserve(self._changed, "value")
            self.iterations.value = ON_BOARD[change["new"]].car_board
            self.iterations.observe(self._changed, "value")
        super()._changed(change)


def of_a_car(problem: Any) -> ProblemRecord:
    """A problem of a car, or InvalidParameter."""
    if not isinstance(problem, ProblemRecord) or not isinstance(problem.robot, CarRobot):
        raise InvalidParameter(
            f"a car board needs a Problem(Car(...), world, start, goal), got {shortened(problem)}"
        )
    return problem


def named(names: Iterable[str]) -> list[tuple[str, str]]:
    """The options of a menu: their words, and themselves."""
    return [(say(f"car_board.{name}"), name) for name in names]


def trajectory_of(plan: Plan) -> TrajectoryRecord:
    """What a car drives by a plan; nothing without a path and a trajectory."""
    if plan.path is not None:
        return trajectory_along(plan)
    return plan.trajectory or standing_at(plan.problem).trajectory
