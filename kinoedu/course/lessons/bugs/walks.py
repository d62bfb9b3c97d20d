"""Exercises whose answer is a walk: any walk is right that stays near an exact one, all the way."""

from abc import abstractmethod
from typing import Any, ClassVar, NamedTuple

import numpy as np

from ....geometry import point_segment_distance
from ....geometry.checks import Array
from ....geometry.leash import at_most_apart, followed
from ....geometry.polygons import places
from ....words import say
from ...exercise import MOST_SHOWN, RIGHT, Case, Exercise, Verdict, spoken
from ...outcomes import Answer, Outcome
from ...shapes import Listed, Number, Numbers, Record

POINT, POLYGON = Numbers((2,)), Numbers(("n", 2))


class Departure(NamedTuple):
    """Where a walk breaks a rule: the rule, and the number of the walk's point."""

    rule: str
    at: int


class WalkExercise(Exercise):
    """From start, goal, obstacles and step to a path, shape (n, 2), beside an exact walk that may
    have several forms.

    leash : how far from the exact walk a student's may be, in steps.
    """

    given = Record(start=POINT, goal=POINT, obstacles=Listed(POLYGON), step=Number())
    answer = POLYGON
    seconds = 10.0
    lesson = "02_bug_algorithms"
    leash: ClassVar[float] = 5.0

    @abstractmethod
    def exact_walks(self, given: dict[str, Any]) -> list[Array]:
        """Every walk that is right, as the corners of a path (n, 2)."""

    def right_answer(self, *given: Any) -> Array:
        """An exact walk, in steps."""
        return self.exact_walks(dict(zip(self.given.fields, given)))[0]

    def value_verdict(self, case: Case, value: Array) -> Verdict:
        """It begins at the start, never jumps, never enters an obstacle, and goes where an exact
        walk goes.
        """
        departure = self.departure(case.given, value)
        return RIGHT if departure is None else Verdict(0.0, departure.rule, self.wanted(case))

    def departure(self, given: dict[str, Any], path: Array) -> Departure | None:
        """The first rule that a path breaks, and where; None where it breaks none."""
        step = given["step"]
        if (
            len(path) == 0
            or not np.isfinite(path).all()
            or np.linalg.norm(path[0] - given["start"]) > 1e-6 * step
        ):
            return Departure("start", 0)
        strides = np.linalg.norm(np.diff(path, axis=0), axis=1)
        if (strides > 1.001 * step).any():
            return Departure("jump", int((strides > 1.001 * step).argmax()) + 1)
        inside = first_inside(path, given["obstacles"], step)
        if inside is not None:
            return Departure("inside", inside)
        leash = self.leash * step
        reach = max(
            followed(path, at_most_apart(walk, step), leash) for walk in self.exact_walks(given)
        )
        if reach < len(path):
            return Departure("unfinished" if reach == len(path) - 1 else "walk", reach)
        return self.end(given, path)

    def end(self, given: dict[str, Any], path: Array) -> Departure | None:
        """Whether a path ends where it should: at the goal, or within a step of it."""
        return (
            None
            if np.linalg.norm(path[-1] - given["goal"]) <= 1.001 * given["step"]
            else Departure("goal", len(path) - 1)
        )

    def draw(self, case: Case, outcome: Outcome, ax: Any) -> None:
        """The world, an exact walk, the student's, and where it departs."""
        from ....figures import palette, plane

        path = outcome.value if isinstance(outcome, Answer) else np.empty((0, 2))
        seen = path[np.isfinite(path).all(axis=1)]
        given = case.given
        walk = max(
            self.exact_walks(given),
            key=lambda walk: followed(seen, walk, self.leash * given["step"]) if len(seen) else 0,
        )
        plane.frame(
            np.vstack([given["start"], given["goal"], walk, *given["obstacles"]]), ax, margin=0.15
        )
        for obstacle in given["obstacles"]:
            plane.polygon(obstacle, ax, numbers=False)
        ax.plot(
            *walk.T,
            "-",
            color=palette.START,
            linewidth=5.0,
            alpha=0.35,
            zorder=3,
            label=say("picture.true"),
        )
        if len(seen):
            ax.plot(
                *seen.T,
                ".--",
                color=palette.GOAL,
                linewidth=1.8,
                markersize=4,
                zorder=4,
                label=say("picture.yours_short"),
            )
        departure = self.departure(given, path)
        if departure is not None and departure.at < len(seen):
            plane.dot(seen[departure.at], say("walk.departs"), ax, colour=palette.INK, marker="X")
        plane.dot(given["start"], "start", ax, colour=palette.START)
        plane.dot(given["goal"], "goal", ax, colour=palette.GOAL, marker="*")
        ax.legend(fontsize=palette.TEXT_SIZE, loc="best")
        plane.title(
            self.words(f"pictures.{departure.rule if departure is not None else case.kind}"), ax
        )

    def wanted(self, case: Case) -> str:
        """The lengths of its forms."""
        lengths = {
            f"{length_of(walk):.4g}": None
            for walk in sorted(self.exact_walks(case.given), key=length_of)
        }
        return say(
            "walk.wanted",
            lengths=say("walk.or").join(lengths),
            tolerance=f"{self.leash * case.given['step']:.3g}",
        )

    def answer_words(self, case: Case, value: Array) -> str:
        """A long walk: how long, from where to where, and where it departs."""
        if len(value) <= MOST_SHOWN or not np.isfinite(value).all():
            return spoken(value)
        departure = self.departure(case.given, value)
        told = {
            "points": len(value),
            "length": f"{length_of(value):.4g}",
            "first": rounded(value[0]),
            "last": rounded(value[-1]),
        }
        if departure is None:
            return say("walk.yours", **told)
        at = departure.at
        return say(
            "walk.yours_departs",
            **told,
            at=rounded(value[at]),
            travelled=f"{length_of(value[: at + 1]):.4g}",
        )


def length_of(path: Array) -> float:
    """The length of a path (n, 2)."""
    return float(np.linalg.norm(np.diff(path, axis=0), axis=1).sum())


def rounded(point: Array) -> str:
    """A point, to what can be seen in a picture."""
    return spoken(np.round(point, 3))


def first_inside(path: Array, obstacles: list[Array], step: float) -> int | None:
    """The number of the first point of a path from which it goes deeper than a step into an
    obstacle; None if it never does.
    """
    between = at_most_apart(path, step / 4.0)
    deep = np.zeros(len(between), bool)
    for obstacle in obstacles:
        inside = np.flatnonzero(places(between, obstacle) > 0)
        deep[inside] |= rim_distances(between[inside], obstacle) > step
    return (
        int(np.linalg.norm(path - between[deep.argmax()], axis=1).argmin()) if deep.any() else None
    )


def rim_distances(points: Array, obstacle: Array) -> Array:
    """How far points, shape (m, 2), are from an obstacle's boundary, also inside; shape (m,)."""
    edges = zip(obstacle, np.roll(obstacle, -1, axis=0))
    return (
        np.min([point_segment_distance(points, a, b) for a, b in edges], axis=0)
        if len(points)
        else np.empty(0)
    )
