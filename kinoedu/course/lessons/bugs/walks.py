"""Exercises whose answer is a walk. A walk is right if it stays near an exact one throughout."""

from abc import abstractmethod
from collections.abc import Iterable
from typing import ClassVar, NamedTuple

import numpy as np

from ....geometry import point_segment_distance
from ....geometry.checks import Array
from ....geometry.leash import count_followed_points, densify_path
from ....geometry.paths import path_length
from ....geometry.polygons import locate_points
from ....messages import get_message
from ...exercise import MAX_POINTS_SHOWN, RIGHT, Axes, Case, Exercise, Given, Verdict, format_value
from ...outcomes import Answer, Outcome
from ...shapes import Listed, Number, Numbers, Record, Value
from ...sizes import refuse_excess

TIMES_LONGER, FEW_ROWS = 5.0, 100  # a walk is judged up to so many exact ones, and some rows
POINT, POLYGON = Numbers((2,)), Numbers(("n", 2))


class Violation(NamedTuple):
    """Where a walk breaks a rule: the rule, and the index of the walk's point."""

    rule: str
    at: int


class WalkExercise(Exercise):
    """An exercise from start, goal, obstacles and step to a path, shape (n, 2).

    The path is compared with exact walks, of which there may be several.

    Attributes
    ----------
    leash : the largest distance between the student's walk and an exact one, in steps.
    """

    given = Record(start=POINT, goal=POINT, obstacles=Listed(POLYGON), step=Number())
    answer = POLYGON
    seconds = 10.0
    lesson = "02_bug_algorithms"
    leash: ClassVar[float] = 5.0

    @abstractmethod
    def exact_walks(self, given: Given) -> list[Array]:
        """Every walk that is right, as the vertices of a path (n, 2)."""

    def right_answer(self, *given: Value) -> Array:
        """One exact walk."""
        return self.exact_walks(dict(zip(self.given.fields, given)))[0]

    def value_verdict(self, case: Case, value: Array) -> Verdict:
        """Check start, step lengths, obstacles, and closeness to an exact walk."""
        violation = self.find_violation(case.given, value)
        return (
            RIGHT
            if violation is None
            else Verdict(0.0, violation.rule, self.describe_expected(case))
        )

    def size_limit(self, case: Case) -> int:
        """The most rows: those of a walk that is many times longer than the exact ones."""
        longest = max(map(path_length, self.exact_walks(case.given)))
        return int(TIMES_LONGER * longest / case.given["step"]) + FEW_ROWS

    def bound_size(self, case: Case, outcome: Outcome) -> Outcome:
        """The outcome, or an answer of the wrong shape where the walk is too long."""
        if not isinstance(outcome, Answer):
            return outcome
        return refuse_excess(
            outcome, len(outcome.value), self.size_limit(case), "shape.too_many_rows"
        )

    def find_violation(self, given: Given, path: Array) -> Violation | None:
        """First rule that a path breaks, and where; None where it breaks none."""
        step = given["step"]
        if len(path) == 0 or not np.isfinite(path).all():
            return Violation("start", 0)
        if len(path) > 2 and (path == path[0]).all():
            return Violation("same", 0)
        if np.linalg.norm(path[0] - given["start"]) > 1e-6 * step:
            return Violation("start", 0)
        strides = np.linalg.norm(np.diff(path, axis=0), axis=1)
        if (strides > 1.001 * step).any():
            return Violation("jump", int((strides > 1.001 * step).argmax()) + 1)
        inside = first_inside(path, given["obstacles"], step)
        if inside is not None:
            return Violation("inside", inside)
        _, reach = self.closest_walk(given, path)
        if reach < len(path):
            return Violation("unfinished" if reach == len(path) - 1 else "walk", reach)
        return self.end(given, path)

    def closest_walk(self, given: Given, path: Array) -> tuple[Array, int]:
        """The exact walk that a path follows farthest, and the number of points that follow it."""
        return self.closest_of(self.exact_walks(given), given, path)

    def closest_of(self, walks: Iterable[Array], given: Given, path: Array) -> tuple[Array, int]:
        """The walk, of several, that a path follows farthest, and how many points follow it."""
        step = given["step"]
        followed = [
            (walk, count_followed_points(path, densify_path(walk, step), self.leash * step))
            for walk in walks
        ]
        return max(followed, key=lambda one: one[1])

    def end(self, given: Given, path: Array) -> Violation | None:
        """Violation where a path does not end within a step of the goal."""
        at_goal = np.linalg.norm(path[-1] - given["goal"]) <= 1.001 * given["step"]
        return None if at_goal else Violation("goal", len(path) - 1)

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the world, an exact walk, the student's walk, and where they separate."""
        from ....figures import palette, plane

        path = outcome.value if isinstance(outcome, Answer) else np.empty((0, 2))
        seen = path[np.isfinite(path).all(axis=1)]
        given = case.given
        walk = self.closest_walk(given, seen)[0] if len(seen) else self.exact_walks(given)[0]
        plane.frame(
            np.vstack([given["start"], given["goal"], walk, *given["obstacles"]]), ax, margin=0.15
        )
        for obstacle in given["obstacles"]:
            plane.polygon(obstacle, ax, numbers=False)
        broad: palette.Style = {
            "color": palette.TRUE,
            "linewidth": 5.0,
            "alpha": 0.35,
            "zorder": 3,
        }
        ax.plot(*walk.T, "-", label=get_message("picture.true"), **broad)
        if len(seen):
            dotted: palette.Style = {
                "color": palette.YOURS,
                "linewidth": 1.8,
                "markersize": 4,
                "zorder": 4,
            }
            ax.plot(*seen.T, ".--", label=get_message("picture.yours_short"), **dotted)
        is_answer = isinstance(outcome, Answer)
        violation = self.find_violation(given, path) if is_answer else None
        if violation is not None and violation.at < len(seen):
            plane.dot(
                seen[violation.at], get_message("walk.departs"), ax, colour=palette.INK, marker="X"
            )
        plane.dot(given["start"], "start", ax, colour=palette.START)
        plane.dot(given["goal"], "goal", ax, colour=palette.GOAL, marker="*")
        ax.legend(fontsize=palette.TEXT_SIZE, loc="best")
        shown = case.kind if violation is None else violation.rule
        plane.title(self.message(f"pictures.{shown}"), ax)

    def describe_expected(self, case: Case) -> str:
        """Description by the lengths of the exact walks."""
        walks = sorted(self.exact_walks(case.given), key=path_length)
        lengths = dict.fromkeys(f"{path_length(walk):.4g}" for walk in walks)
        tolerance = f"{self.leash * case.given['step']:.3g}"
        return get_message(
            "walk.wanted", lengths=get_message("walk.or").join(lengths), tolerance=tolerance
        )

    def describe_answer(self, case: Case, value: Array) -> str:
        """Description of a long walk: its length, its ends, and where it leaves the exact one."""
        if len(value) <= MAX_POINTS_SHOWN or not np.isfinite(value).all():
            return format_value(value)
        violation = self.find_violation(case.given, value)
        values = {
            "points": len(value),
            "length": f"{path_length(value):.4g}",
            "first": round_point(value[0]),
            "last": round_point(value[-1]),
        }
        if violation is None:
            return get_message("walk.yours", **values)
        at = violation.at
        travelled = f"{path_length(value[: at + 1]):.4g}"
        return get_message(
            "walk.yours_departs", **values, at=round_point(value[at]), travelled=travelled
        )


def round_point(point: Array) -> str:
    """A point, rounded to what can be seen in a picture."""
    return format_value(np.round(point, 3))


def first_inside(path: Array, obstacles: list[Array], step: float) -> int | None:
    """Index of the first point from which a path goes deeper than a step into an obstacle.

    None where it never does.
    """
    between = densify_path(path, step / 4.0)
    deep = np.zeros(len(between), bool)
    for obstacle in obstacles:
        inside = np.flatnonzero(locate_points(between, obstacle) > 0)
        deep[inside] |= rim_distances(between[inside], obstacle) > step
    if not deep.any():
        return None
    return int(np.linalg.norm(path - between[deep.argmax()], axis=1).argmin())


def rim_distances(points: Array, obstacle: Array) -> Array:
    """Distances of points (m, 2) to an obstacle's boundary, also from inside; shape (m,)."""
    if not len(points):
        return np.empty(0)
    edges = zip(obstacle, np.roll(obstacle, -1, axis=0))
    return np.array([point_segment_distance(points, a, b) for a, b in edges]).min(axis=0)
