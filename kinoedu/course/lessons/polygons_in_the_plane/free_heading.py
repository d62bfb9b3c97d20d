"""The exercise on free headings: a polygon turns in place until it is free.

LaValle, section 4.3.3, at one position.
"""

from collections.abc import Iterator

import numpy as np

from ....collision import free_heading as middle_of_widest
from ....collision import free_headings
from ....geometry.checks import Array
from ....messages import get_message
from ....problems import Problem
from ....robots import RigidPolygon
from ....worlds import PolygonWorld, scattered
from ...exercise import RIGHT, Axes, Case, Exercise, Restated, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Maybe, Number, Record, Value
from ...tasks import ProblemShape, StudentProblem
from ..shared.small_problems import SQUARE
from .pictures import draw_heading

LEAST = 0.2  # radians: no interval of free headings is shorter
BAR = RigidPolygon([(-0.5, -0.3), (2.5, -0.3), (2.5, 0.3), (-0.5, 0.3)])
HOOK = RigidPolygon([(-0.4, -0.4), (1.8, -0.4), (1.8, 0.0), (0.0, 0.0), (0.0, 1.2), (-0.4, 1.2)])
HALF = 0.56  # half the width of a dead end, in which the bar has little more than LEAST
NARROW = 0.5525  # the same, with 0.203 to 0.204 radians
# steps between headings that miss a narrow dead end, from 0 on and from -pi on
TOO_WIDE = (2.0 * np.pi / 30, 0.205)
OTHERS_TOO_WIDE = (0.205, 0.21, 0.22)
SEAM = 0.115  # a dead end so far from a whole or a half turn ends just before it
CORNER = (1.4, 1.4, 0.0)  # the robot's start, which is free in every world


def to_radians(theta: float, *others: Value) -> float:
    """Return an angle that is given in degrees in radians."""
    return float(np.radians(theta))


class FreeHeading(Exercise):
    """Find a heading at which the robot is free at a position, or None."""

    name = "free_heading"
    lesson = "11_polygons_in_the_plane"
    kinds = ("open", "slot", "none")
    given = Record(problem=ProblemShape(), x=Number(), y=Number())
    answer = Maybe(Number())
    source = staticmethod(
        lambda problem, x, y: middle_of_widest(problem.robot, problem.world, (x, y))
    )
    shown = staticmethod(middle_of_widest)

    changes = (
        Restated(
            "degrees", answer=lambda theta, *given: np.degrees(theta), usual_answer=to_radians
        ),
        Restated("clockwise", answer=lambda theta, *given: -theta),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield open places, slots all the way round, and places beside and inside obstacles."""
        room = PolygonWorld(SQUARE)
        yield make_case(BAR, room, (5.0, 5.0))
        yield make_case(BAR, room, (9.0, 5.0))
        for angle in (0.0, np.pi / 2, np.pi, -np.pi / 2):
            yield make_case(BAR, make_slot(angle, HALF), (5.0, 5.0))
        yield make_case(BAR, make_slot(0.0, 0.2), (5.0, 5.0))
        for angle in slot_angles(rng):
            yield make_case(BAR, make_slot(angle, HALF), (5.0, 5.0))
        for step in TOO_WIDE:
            for k in rng.integers(0, 30, 2).tolist():
                yield make_case(BAR, make_slot((k + 0.5) * step, NARROW), (5.0, 5.0))
        for step in OTHERS_TOO_WIDE:
            for first in (0.0, -np.pi):
                yield make_case(BAR, make_slot(first + 7.5 * step, NARROW), (5.0, 5.0))
        for robot in (BAR, HOOK):
            world = scattered(12, side=10.0, radius=1.2, keep_free=[(1.4, 1.4, 2.6)], rng=rng)
            for place in np.round(rng.uniform(0.5, 9.5, (40, 2)), 2):
                widths = np.diff(free_headings(robot, world, place))
                if not len(widths) or widths.max() > LEAST:
                    yield make_case(robot, world, place)

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Judge that None is returned exactly where no heading is free.

        Any other answer must be free by the course's own collision check.
        """
        if value is None:
            return (
                RIGHT
                if case.kind == "none"
                else Verdict(0.0, "missed", self.describe_expected(case))
            )
        if not np.isfinite(value):
            return Verdict(0.0, "free", self.describe_expected(case))
        problem = case.given["problem"].problem
        free = problem.is_free(np.array([case.given["x"], case.given["y"], value]))
        return (
            RIGHT
            if free
            else Verdict(
                0.0, "none" if case.kind == "none" else "free", self.describe_expected(case)
            )
        )

    def describe_expected(self, case: Case) -> str:
        """Describe the free intervals."""
        rows = np.sort([[self.as_asked(end, case) for end in row] for row in self.intervals(case)])
        text = ", ".join(f"{low:.3f} ... {high:.3f}" for low, high in rows)
        return get_message("free_heading.wanted", intervals=text) if text else "None"

    def intervals(self, case: Case) -> Array:
        """Return the free intervals of headings."""
        problem = case.given["problem"].problem
        return free_headings(problem.robot, problem.world, (case.given["x"], case.given["y"]))

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the robot at the student's heading and at a free one."""
        value = outcome.value if isinstance(outcome, Answer) else None
        right = self.source(*case.given.values())
        place = (case.given["x"], case.given["y"])
        heading = "" if value is None else f"{self.as_asked(value, case):.4g}"
        texts = self.message(f"pictures.{case.kind}"), heading
        draw_heading(case.given["problem"].problem, place, value, right, texts, ax)


def slot_angles(rng: np.random.Generator) -> list[float]:
    """Return angles of dead ends: beside both seams, and one in each twelfth of the turn."""
    twelfths = (np.arange(12) + rng.random(12)) * np.pi / 6.0
    return [-SEAM, np.pi - SEAM, SEAM - np.pi, *np.round(twelfths, 2).tolist()]


def make_case(robot: Value, world: Value, place: Value) -> Case:
    """Return a case and classify it."""
    widths = np.diff(free_headings(robot, world, place))
    kind = "none" if not len(widths) else "slot" if widths.max() < 0.8 else "open"
    problem = StudentProblem(Problem(robot, world, CORNER, CORNER))
    return Case(kind, {"problem": problem, "x": float(place[0]), "y": float(place[1])})


def make_slot(angle: float, half: float) -> Value:
    """Return a room with a dead end of width 2 `half` around its centre, open in one direction."""
    bars = np.array(
        [
            [(-1.2, half), (3.0, half), (3.0, half + 0.4), (-1.2, half + 0.4)],
            [(-1.2, -half - 0.4), (3.0, -half - 0.4), (3.0, -half), (-1.2, -half)],
            [(-1.2, -half - 0.4), (-0.8, -half - 0.4), (-0.8, half + 0.4), (-1.2, half + 0.4)],
        ]
    )
    c, s = np.cos(angle), np.sin(angle)
    return PolygonWorld(SQUARE, list((bars @ np.array([[c, s], [-s, c]]) + 5.0).round(3)))
