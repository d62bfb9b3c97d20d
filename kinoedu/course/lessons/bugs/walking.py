"""Shared parts of the exercises on bug algorithms. Bullo & Smith, chapter 1.

The worlds are unambiguous: walls are met squarely or not at all, obstacles are many steps apart,
and the two ways back around an obstacle differ clearly in length. So a walk in steps, with its
small errors, follows the exact walk.
"""

from abc import abstractmethod

import numpy as np
from numpy.typing import ArrayLike

from ....geometry import convex_hull, point_polygon_distance
from ....geometry.checks import Array
from ....geometry.polygons import locate_point
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


def world(start: ArrayLike, goal: ArrayLike, obstacles: list[Array], step: float = STEP) -> Given:
    """Arguments of a case."""
    return {
        "start": np.array(start, float),
        "goal": np.array(goal, float),
        "obstacles": obstacles,
        "step": step,
    }


class BugExercise(WalkExercise):
    """A bug algorithm, compared with the exact walks of all its variants."""

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
