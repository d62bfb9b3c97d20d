"""Shared parts of the exercises on bug algorithms. Bullo & Smith, chapter 1.

The worlds are unambiguous: walls are met squarely or not at all, obstacles are many steps apart,
and the two ways back around an obstacle differ clearly in length. So a walk in steps, with its
small errors, follows the exact walk.
"""

from abc import abstractmethod
from collections.abc import Callable
from typing import Any, NamedTuple, cast

import numpy as np
from numpy.typing import ArrayLike

from ....geometry import convex_hull, point_polygon_distance
from ....geometry.checks import Array
from ....geometry.polygons import locate_point
from ....planners.bugs import BugRobot
from ....planners.bugs.walk import plan_walk
from ....problems import Plan, Walk
from ...exercise import CONTRACT, Case, Given
from .walks import Violation, WalkExercise

ME145 = [np.array([(1, 2), (1, 0), (3, 0)], float), np.array([(2, 3), (4, 1), (5, 2)], float)]
BOX = np.array([(2, -1), (4, -1), (4, 2), (2, 2)], float)
TURNS = ("left", "right")
STEP = 0.05
CLEAR = 8.0  # steps; obstacles that are not hit stay this far away
# steps; this far before a hit the wall is still farther than half of it, otherwise it is grazed
SHORT = 2.5


class Choice(NamedTuple):
    """What a bug chooses at a hit: its turn, and the way back to the nearest point."""

    turn: str
    back: str = "same"


def world(start: ArrayLike, goal: ArrayLike, obstacles: list[Array], step: float = STEP) -> Given:
    """Arguments of a case."""
    return {
        "start": np.array(start, float),
        "goal": np.array(goal, float),
        "obstacles": obstacles,
        "step": step,
    }


# a program that has the usual step in it, in place of the one that is given, fails here
SMALL_STEPS = world((0, 0), (2.4, 0), [np.round(0.4 * BOX, 2)], 0.02)


class BugExercise(WalkExercise):
    """A bug algorithm, compared with the exact walks of all its variants.

    A path may follow one variant at one hit and another at the next.
    """

    @property
    def turns(self) -> tuple[str, ...]:
        """The allowed turns at a hit: both, or the one that the contract names."""
        return (self.variant,) if self.variant else TURNS

    @abstractmethod
    def plans(self, given: Given) -> list[Plan]:
        """Plan of each variant that is right."""

    def exact_walks(self, given: Given) -> list[Array]:
        """Walks of these plans."""
        return [walk_of(plan).points for plan in self.plans(given)]

    def closest_walk(self, given: Given, path: Array) -> tuple[Array, int]:
        """The exact walk that a path follows farthest, and the number of points that follow it.

        Where the path follows no walk to its end, the choices at each hit may also differ.
        """
        best = super().closest_walk(given, path)
        options, choices = self.options(), list[Choice]()
        while options and best[1] < len(path):
            walks = [self.mixed_walk(given, [*choices, option]) for option in options]
            followed = [self.closest_of([walk], given, path) for walk, _ in walks]
            best = max(best, *followed, key=lambda one: one[1])
            chosen = int(np.argmax([reach for _, reach in followed]))
            if walks[chosen][1] <= len(choices) + 1:
                break
            choices.append(options[chosen])
        return best

    def options(self) -> list[Choice]:
        """The choices that are right at each hit, whatever was chosen at the others."""
        return []

    def mixed_walk(self, given: Given, choices: list[Choice]) -> tuple[Array, int]:
        """The exact walk with these choices at the first hits, the last of them at the rest.

        Second comes its number of hits.
        """
        raise NotImplementedError

    def find_violation(self, given: Given, path: Array) -> Violation | None:
        """First rule that a path breaks, and where.

        Where the path is right except for the direction of its turn, the broken rule is the
        contract.
        """
        found = super().find_violation(given, path)
        if (
            found is None
            or not self.variant
            or type(self)().find_violation(given, path) is not None
        ):
            return found
        return Violation(CONTRACT, found.at)

    def random_case(self, rng: np.random.Generator, kind: str, n: int) -> Case:
        """Random case among n obstacles, all of which some variant of the walk meets."""
        while True:
            given = random_world(rng, n)
            plans = self.plans(given)
            if max(len(walk_of(plan).hit) for plan in plans) == n and all(
                self.leaves_no_doubt(given, plan) for plan in plans
            ):
                return Case(kind, given)

    def leaves_no_doubt(self, given: Given, plan: Plan) -> bool:
        """Whether a walk with small errors follows the exact walk."""
        return is_clear(given, plan)


class ChoosingRobot:
    """A bug robot that follows a choice of its own at each hit, the last one at all hits after it.

    A robot that leaves a wall where the wall itself is in the way hits it again at once, as a robot
    does that moves in steps.

    hits : the number of hits.
    """

    def __init__(self, robot: BugRobot, choices: list[Choice]) -> None:
        self._robot, self._choices, self.hits = robot, choices, 0
        self._choice, self._turn = choices[0], "left"

    def __getattr__(self, name: str) -> Any:
        """Everything else is done by the robot itself."""
        return getattr(self._robot, name)

    def move_to_goal(self) -> bool:
        """Move as the robot does; after a hit, turn to the side that was chosen."""
        if self._robot.place.wall < 0 or self._robot.can_move_to_goal():
            if self._robot.move_to_goal():
                return True
            self._turn = "left"  # the robot's own
        self._choice = self._choices[min(self.hits, len(self._choices) - 1)]
        self.hits += 1
        if self._choice.turn != self._turn:
            self._robot.turn_round()
            self._turn = self._choice.turn
        return False

    def can_move_to_goal(self) -> bool:
        """True, so that the robot leaves the wall, also where it hits it again at once."""
        return True

    def turn_round(self) -> None:
        """Turn round where the choice is the shorter way back."""
        if self._choice.back == "shorter":
            self._robot.turn_round()


def walk_with_choices(
    algorithm: Callable[[BugRobot], int], given: Given, choices: list[Choice]
) -> tuple[Array, int]:
    """The exact walk of an algorithm whose robot chooses at each hit, and the number of hits."""
    hits = 0

    def chosen_walk(robot: BugRobot) -> int:
        nonlocal hits
        choosing = ChoosingRobot(robot, choices)
        outcome = algorithm(cast("BugRobot", choosing))
        hits = choosing.hits
        return outcome

    start, goal, obstacles, step = given.values()
    outcomes = ("", "not reached")
    plan = plan_walk("bug", chosen_walk, outcomes, start, goal, obstacles, step, "left", 0.0)
    return walk_of(plan).points, hits


def walk_of(plan: Plan) -> Walk:
    """Walk of a bug's plan, which is never None."""
    assert plan.walk is not None
    return plan.walk


def random_world(rng: np.random.Generator, n: int) -> Given:
    """n convex obstacles in a row, far apart, roughly on the way from start to goal."""
    angle = rng.uniform(0.0, 2.0 * np.pi)
    along = np.array([np.cos(angle), np.sin(angle)])
    across = np.array([-np.sin(angle), np.cos(angle)])
    obstacles = []
    for i in range(n):
        middle = (2.6 + 3.6 * i) * along + rng.uniform(-0.7, 0.7) * across
        turns = 2.0 * np.pi * (np.arange(5) + rng.uniform(0.0, 0.8, 5)) / 5.0
        directions = np.column_stack([np.cos(turns), np.sin(turns)])
        corners = middle + rng.uniform(0.9, 1.3, (5, 1)) * directions
        obstacles.append(convex_hull(np.round(corners, 2)))
    goal = np.round((1.6 + 3.6 * n) * along + rng.uniform(-0.3, 0.3) * across, 2)
    return world((0, 0), goal, obstacles)


def turned_world(given: Given, angle: float) -> Given:
    """A world turned about the origin; coordinates are rounded where they are not whole."""
    (x, y) = np.cos(angle), np.sin(angle)

    def turn(points: Array) -> Array:
        return np.round(points @ np.array([(x, y), (-y, x)]), 3) + 0.0

    return {
        "start": turn(given["start"]),
        "goal": turn(given["goal"]),
        "obstacles": [turn(obstacle) for obstacle in given["obstacles"]],
        "step": given["step"],
    }


def is_clear(given: Given, plan: Plan) -> bool:
    """Whether every straight move hits its wall squarely and keeps away from everything else."""
    walk, room = walk_of(plan), CLEAR * given["step"]
    begins = [0, *walk.leave]
    ends = [*walk.hit, len(walk.points) - 1]
    for begin, end in zip(begins, ends):
        a, b = walk.points[begin], walk.points[end]
        length = np.linalg.norm(b - a)
        if length < 2.0 * room:
            return False
        for obstacle in given["obstacles"]:
            near = [float(point_polygon_distance(q, obstacle)) for q in (a, b)]
            shares = np.linspace(0.0, 1.0, 200)
            # an obstacle touched at one end of the move is near there
            begun, ended = (3.0 * room / length if gap < 1e-6 else 0.0 for gap in near)
            shares = shares[(shares >= begun) & (shares <= 1.0 - ended)]
            gaps = point_polygon_distance(a + shares[:, None] * (b - a), obstacle)
            if np.min(gaps, initial=np.inf) < room:
                return False
            stride = given["step"] * (b - a) / length
            if near[1] < 1e-6 and not is_met_squarely(b, stride, obstacle):
                return False
    return True


def is_met_squarely(hit: Array, stride: Array, obstacle: Array) -> bool:
    """Whether a move hits a convex obstacle steeply, away from its corners.

    Then a walk that stops as soon as the wall is nearer than a step stops near the exact hit.
    """
    before, ahead = hit - SHORT * stride, hit + CLEAR * stride
    steep = point_polygon_distance(before, obstacle) > SHORT / 2.0 * np.linalg.norm(stride)
    return bool(steep and locate_point(ahead[0], ahead[1], obstacle) > 0)
