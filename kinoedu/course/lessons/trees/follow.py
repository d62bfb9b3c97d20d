"""The exercise on planning with a receding horizon: how far a robot follows its plan.

Bullo & Smith, chapter 5.
"""

from collections.abc import Iterator

import numpy as np

from ....geometry.checks import Array
from ....planners import receding_horizon
from ....problems.protocols import PlanningProblem
from ...exercise import Axes, Case, Change, Slip, ValueExercise, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Number, Record, Value
from ...tasks import StudentProblem
from ...withheld import withheld
from ..roadmaps.halls import make_arm
from ..shared.planned import PATH, Fault, ProblemShape
from ..shared.planned_pictures import draw_answer
from ..shared.small_problems import box, in_room


@withheld
def follow_path(problem: PlanningProblem, path: Array, horizon: float) -> Array:
    """Return the first part of a path, as long as the horizon, up to the first blocked motion."""
    gone, left = [path[0]], horizon
    for a, b in zip(path, path[1:]):
        q = problem.steer(a, b, left)
        if left <= 0.0 or not problem.is_free_path(a, q):
            break
        gone.append(q)
        left -= problem.distance(a, b)
    return np.array(gone)


def follow_to_next_corner(problem: PlanningProblem, path: Array, horizon: float) -> Array:
    """Go on to the end of the motion in which the horizon ends."""
    gone, left = [path[0]], horizon
    for a, b in zip(path, path[1:]):
        if left <= 0.0 or not problem.is_free_path(a, b):
            break
        gone.append(b)
        left -= problem.distance(a, b)
    return np.array(gone)


def stop_at_last_corner(problem: PlanningProblem, path: Array, horizon: float) -> Array:
    """Stop at the last corner before the horizon."""
    followed = follow_path(problem, path, horizon)
    return (
        followed
        if len(followed) < 2 or np.array_equal(followed[-1], path[len(followed) - 1])
        else followed[:-1]
    )


def follow_unchecked(problem: PlanningProblem, path: Array, horizon: float) -> Array:
    """Check no motion."""
    gone, left = [path[0]], horizon
    for a, b in zip(path, path[1:]):
        if left > 0.0:
            gone.append(problem.steer(a, b, left))
        left -= problem.distance(a, b)
    return np.array(gone)


def restart_horizon(problem: PlanningProblem, path: Array, horizon: float) -> Array:
    """Begin a new horizon at every corner."""
    gone = [path[0]]
    for a, b in zip(path, path[1:]):
        q = problem.steer(a, b, horizon)
        if not problem.is_free_path(a, q):
            break
        gone.append(q)
        if problem.distance(a, b) > horizon:
            break
    return np.array(gone)


def check_beyond(problem: PlanningProblem, path: Array, horizon: float) -> Array:
    """Check whole motions of the path, also beyond the horizon."""
    followed = follow_path(problem, path, horizon)
    for i, (a, b) in enumerate(zip(path[: len(followed) - 1], path[1:])):
        if not problem.is_free_path(a, b):
            return followed[: i + 1]
    return followed


class Follow(ValueExercise):
    """Find the part of a plan that a robot follows before it senses again."""

    name = "follow"
    lesson = "09_trees"
    kinds = ("straight", "corners", "whole", "blocked")
    given = Record(problem=ProblemShape(), path=PATH, horizon=Number())
    answer = PATH
    source = staticmethod(follow_path)
    shown = staticmethod(receding_horizon)
    slips = (
        Slip("to_the_corner", follow_to_next_corner),
        Slip("before_the_corner", stop_at_last_corner),
        Slip("trusting", follow_unchecked),
        Slip("each_within", restart_horizon),
        Slip("asking_beyond", check_beyond),
    )
    changes = (
        Change("backwards", lambda followed, p, path, horizon: followed(p, path[::-1], horizon)),
        Change("double_speed", lambda followed, p, path, horizon: followed(p, path, 2.0 * horizon)),
    )

    @staticmethod
    @withheld
    def reference(*given: Value) -> Value:
        """Return the part that is followed."""
        return follow_path(*given)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield one motion, corners, a horizon beyond the goal, and an unexpected wall."""
        free = in_room((1, 1), (9, 5))
        yield make_case("straight", free, [(1, 1), (9, 1)], 3.0)
        yield make_case("corners", free, [(1, 1), (4, 1), (4, 9)], 5.0)
        yield make_case("corners", free, [(1, 1), (4, 1), (4, 9)], 3.0)
        yield make_case("corners", free, [(1, 1), (4, 1), (4, 9)], 3.001)
        # the first motion of the arm is short, because its angle wraps
        yield make_case("corners", make_arm(), [(3.0, 0.3), (-3.0, 0.3), (-2.5, 0.3)], 0.4)
        yield make_case("whole", free, [(1, 1), (4, 1)], 5.0)
        yield make_case(
            "blocked",
            in_room((1, 1), (9, 5), box(6, 0, 7, 3)),
            [(1, 1), (4, 1), (9, 1), (9, 5)],
            7.0,
        )
        # the motion only touches the wall
        yield make_case(
            "blocked", in_room((1, 1), (9, 5), box(2, 0, 3, 1)), [(1, 1), (9, 1), (9, 5)], 2.0
        )
        yield make_case(
            "blocked", in_room((1, 1), (9, 5), box(7, 0, 8, 3)), [(1, 1), (9, 1), (9, 5)], 2.0
        )
        yield make_case(
            "blocked", in_room((1, 1), (9, 5), box(5, 0, 6, 3)), [(9, 5), (9, 1), (1, 1)], 2.0
        )
        for turn in range(14):
            path = np.round(rng.uniform(0.5, 9.5, (int(rng.integers(4, 8)), 2)), 1)
            motions = np.linalg.norm(np.diff(path, axis=0), axis=1)
            yield make_case(
                "straight", free, path[:2], round(float(rng.uniform(0.2, 0.9) * motions[0]), 2)
            )
            yield make_case(
                "corners",
                free,
                path,
                round(float(motions[:2].sum() + rng.uniform(0.2, 0.8) * motions[2]), 2),
            )
            yield make_case(
                "whole", free, path, round(float(motions.sum() + rng.uniform(0.5, 5.0)), 2)
            )
            i = int(rng.integers(1, len(path) - 1))
            x, y = np.round(0.5 * (path[i] + path[i + 1]), 2)
            half = (0.2, 0.01, 0.0005)[
                turn % 3
            ]  # a wall that is thinner than any step between places
            wall = in_room((0.1, 0.1), (9.9, 9.9), box(x - half, y - 0.2, x + half, y + 0.2))
            yield make_case(
                "blocked",
                wall,
                path,
                round(float(motions[:i].sum() + rng.uniform(0.1, 1.5) * motions[i]), 2),
            )

    def same(self, value: Value, truth: Value) -> bool:
        """Whether all rows are the same."""
        return np.shape(value) == np.shape(truth) and super().same(value, truth)

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Judge the first row and equal rows by rules of their own, then the rest."""
        verdict = super().value_verdict(case, value)
        rows, truth = np.asarray(value), self.truth(case)
        if verdict.is_right or (len(rows) > 0 and rows.shape[1:] != truth.shape[1:]):
            return verdict
        if len(rows) == 0 or np.abs(rows[0] - truth[0]).max() > self.tolerance:
            return verdict._replace(rule="begins")
        repeated = len(rows) > 1 and not np.diff(rows, axis=0).any(axis=1).all()
        return verdict._replace(rule="repeated") if repeated else verdict

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the plan, the part that should be followed, and where the student's part ends."""
        from ....figures import palette
        from ....figures.robots import place_of, track_of

        problem, path = case.given["problem"], case.given["path"]
        fault = None
        value = outcome.value if isinstance(outcome, Answer) else np.empty((0, 2))
        if len(value) and value.shape[1] == 2 and np.isfinite(value).all():
            fault = Fault("", value)
        draw_answer(problem.problem, [], None, fault, self.message(f"pictures.{case.kind}"), ax)
        truth, plan = (track_of(problem.robot, rows) for rows in (self.truth(case), path))
        ax.plot(*truth.T, "-", color=palette.TRUE, linewidth=5.0, zorder=5)
        corners = np.array([place_of(problem.robot, q) for q in path])
        ax.plot(*plan.T, ":", color=palette.INK, linewidth=1.5, zorder=3)
        ax.plot(*corners.T, "o", color=palette.INK, markersize=4, zorder=3)


def make_case(kind: str, problem: StudentProblem, path: object, horizon: float) -> Case:
    """Return a case."""
    return Case(kind, {"problem": problem, "path": np.array(path, float), "horizon": horizon})
