"""Shared by the exercises on the Bug algorithms. Bullo & Smith, chapter 1.

The worlds leave no doubt: a wall is met squarely or not at all, obstacles are far apart beside a
step, and of no obstacle are the two ways back round it nearly equally long. So a walk in steps,
with its small errors, goes where the exact walk goes."""

from abc import abstractmethod
from typing import Any

import numpy as np

from ....geometry import convex_hull, point_polygon_distance
from ....geometry.checks import Array
from ....geometry.polygons import place
from ....problems import Plan, Walk
from ...exercise import CONTRACT, Case
from .walks import Departure, WalkExercise

ME145 = [np.array([(1, 2), (1, 0), (3, 0)], float), np.array([(2, 3), (4, 1), (5, 2)], float)]


BOX = np.array([(2, -1), (4, -1), (4, 2), (2, 2)], float)


TURNS = ("left", "right")


STEP = 0.05


CLEAR = 8.0  # steps: what is not met stays so far away


# steps: so little before a hit the wall is still farther than half of that, or it is grazed rather
# than met
SHORT = 2.5


def world(start: Any, goal: Any, obstacles: list[Array], step: float = STEP) -> dict[str, Any]:
    """The arguments of a case."""
    return {
        "start": np.array(start, float),
        "goal": np.array(goal, float),
        "obstacles": obstacles,
        "step": step,
    }


class BugExercise(WalkExercise):
    """A Bug algorithm, judged beside the exact walks of its forms."""

    @property
    def turns(self) -> tuple[str, ...]:
        """Which way to turn at a hit: either, or the one that the contract names."""
        return (self.variant,) if self.variant else TURNS

    @abstractmethod
    def plans(self, given: dict[str, Any]) -> list[Plan]:
        """The plan of every form that is right."""

    def exact_walks(self, given: dict[str, Any]) -> list[Array]:
        """Their walks."""
        return [walk_of(plan).points for plan in self.plans(given)]

    def departure(self, given: dict[str, Any], path: Array) -> Departure | None:
        """The first rule that a path breaks, and where; the contract, where it turned the other way
        and all else is right.
        """
        found = super().departure(given, path)
        if found is None or not self.variant or type(self)().departure(given, path) is not None:
            return found
        return Departure(CONTRACT, found.at)

    def random_case(self, rng: np.random.Generator, kind: str, n: int) -> Case:
        """A case among n obstacles, all of which are met on some form of the walk."""
        while True:
            given = random_world(rng, n)
            plans = self.plans(given)
            if max(len(walk_of(plan).hit) for plan in plans) == n and all(
                self.leaves_no_doubt(given, plan) for plan in plans
            ):
                return Case(kind, given)

    def leaves_no_doubt(self, given: dict[str, Any], plan: Plan) -> bool:
        """Whether a walk with small errors goes the same way as an exact one."""
        return is_clear(given, plan)


def walk_of(plan: Plan) -> Walk:
    """A Bug plan's walk, which it always has."""
    assert plan.walk is not None
    return plan.walk


def random_world(rng: np.random.Generator, n: int) -> dict[str, Any]:
    """n convex obstacles in a row, well apart, about on the way from start to goal."""
    angle = rng.uniform(0.0, 2.0 * np.pi)
    along, across = (
        np.array([np.cos(angle), np.sin(angle)]),
        np.array([-np.sin(angle), np.cos(angle)]),
    )
    obstacles = []
    for i in range(n):
        middle = (2.6 + 3.6 * i) * along + rng.uniform(-0.7, 0.7) * across
        turns = 2.0 * np.pi * (np.arange(5) + rng.uniform(0.0, 0.8, 5)) / 5.0
        corners = middle + rng.uniform(0.9, 1.3, (5, 1)) * np.column_stack(
            [np.cos(turns), np.sin(turns)]
        )
        obstacles.append(convex_hull(np.round(corners, 2)))
    goal = np.round((1.6 + 3.6 * n) * along + rng.uniform(-0.3, 0.3) * across, 2)
    return world((0, 0), goal, obstacles)


def is_clear(given: dict[str, Any], plan: Plan) -> bool:
    """Whether every straight move hits squarely what it hits, and stays well away from everything
    else.
    """
    walk, room = walk_of(plan), CLEAR * given["step"]
    begins = [0, *walk.leave]
    ends = [*walk.hit, len(walk.points) - 1]
    for begin, end in zip(begins, ends):
        a, b = walk.points[begin], walk.points[end]
        far = np.linalg.norm(b - a)
        if far < 2.0 * room:
            return False
        for obstacle in given["obstacles"]:
            near = [float(point_polygon_distance(q, obstacle)) for q in (a, b)]
            shares = np.linspace(0.0, 1.0, 200)
            begun = (
                3.0 * room / far if near[0] < 1e-6 else 0.0
            )  # what is touched at an end is near there
            ended = 3.0 * room / far if near[1] < 1e-6 else 0.0
            shares = shares[(shares >= begun) & (shares <= 1.0 - ended)]
            if (
                np.min(
                    point_polygon_distance(a + shares[:, None] * (b - a), obstacle), initial=np.inf
                )
                < room
            ):
                return False
            if near[1] < 1e-6 and not is_met_squarely(b, given["step"] * (b - a) / far, obstacle):
                return False
    return True


def is_met_squarely(hit: Array, stride: Array, obstacle: Array) -> bool:
    """Whether a move that hits a convex obstacle comes upon it steeply, by no corner, and would go
    on into it. Then a walk that stops as soon as the wall is nearer than a step stops near the hit.
    """
    before, ahead = hit - SHORT * stride, hit + CLEAR * stride
    steep = point_polygon_distance(before, obstacle) > SHORT / 2.0 * np.linalg.norm(stride)
    return bool(steep and place(ahead[0], ahead[1], obstacle) > 0)
