"""The exercise `best_control`: choose the best of several controls, and where to cut it."""

import math
from collections.abc import Callable, Iterator

import numpy as np
from numpy.typing import ArrayLike

from ....geometry.checks import Array
from ....planners.driving.common import free_drive
from ....problems.protocols import PlanningProblem, ProblemLike
from ....spaces.angles import wrap_angle
from ...drivable import DrivenProblemShape, DrivingProblem
from ...exercise import Axes, Case, Given, Restated, Slip, ValueExercise
from ...outcomes import Answer, Outcome
from ...poses import distance_of_poses
from ...shapes import Maybe, Number, Numbers, Record, Value
from ...tasks import StudentProblem
from ...whole_shapes import Integer, Integers
from ...withheld import withheld
from ..shared.small_problems import box
from .garages import POSTS, make_garage

POSE = Numbers((3,))
Choice = tuple[int, int] | None


@withheld
def choose_best_control(
    problem: DrivingProblem, q: Array, target: Array, controls: Array, t: float, n: int
) -> Choice:
    """Take the free control that comes closest to the target, cut at its closest step."""
    best, least = None, math.inf
    for i, (v, phi) in enumerate(controls):
        away = [
            problem.distance(problem.move(q, v, phi, k * t / n), target) for k in range(1, n + 1)
        ]
        k = int(np.argmin(away))
        if away[k] < least and problem.is_free_drive(q, v, phi, (k + 1) * t / n):
            best, least = (i, k + 1), away[k]
    return best


def make_chooser(
    off: Callable[..., float],
    is_free: Callable[..., bool],
    first: int = 1,
    cut: Callable[..., Value] = np.argmin,
    start: float = math.inf,
) -> Callable[..., Choice]:
    """Return a program like `choose_best_control` that differs from it in one part.

    Parameters
    ----------
    off : distance of a pose from the target.
    is_free : whether a control may be taken; the others are left out.
    first : the first step that counts.
    cut : picks the step of one control from the distances at all of its steps.
    start : the value with which its minimum begins.
    """

    def choose(
        problem: DrivingProblem, q: Array, target: Array, controls: Array, t: float, n: int
    ) -> Choice:
        best, least = None, start
        for i, (v, phi) in enumerate(controls):
            away = [
                off(problem, problem.move(q, v, phi, k * t / n), target)
                for k in range(first, n + 1)
            ]
            k = int(cut(away))
            if away[k] < least and is_free(problem, q, v, phi, (first + k) * t / n, t):
                best, least = (i, first + k), away[k]
        return best

    return choose


def measure_distance(problem: ProblemLike, a: Array, b: Array) -> float:
    """Return the distance of the problem."""
    return float(problem.distance(a, b))


def is_free_to_cut(
    problem: DrivingProblem, q: Array, v: float, phi: float, cut: float, _: float
) -> bool:
    """Whether the drive is free up to its cut."""
    return bool(problem.is_free_drive(q, v, phi, cut))


def is_free_throughout(
    problem: DrivingProblem, q: Array, v: float, phi: float, _: float, t: float
) -> bool:
    """Whether the drive is free also beyond its cut."""
    return bool(problem.is_free_drive(q, v, phi, t))


def is_free_at_cut(
    problem: DrivingProblem, q: Array, v: float, phi: float, cut: float, _: float
) -> bool:
    """Whether the last pose is free."""
    return bool(problem.problem.is_free(problem.move(q, v, phi, cut)))


def accept_any(*_: object) -> bool:
    """Accept every drive."""
    return True


def compare_ends(
    problem: PlanningProblem, q: Array, target: Array, controls: Array, t: float, n: int
) -> Choice:
    """Compare the ends of the drives and cut none."""
    choice = make_chooser(measure_distance, is_free_to_cut)(problem, q, target, controls, t, 1)
    return choice and (choice[0], n)


def pick_then_check(*given: Value) -> Choice:
    """Take the best control of all, and return None where it is not free."""
    best = make_chooser(measure_distance, accept_any)(*given)
    return best if best == choose_best_control(*given) else None


def count_from_zero(*given: Value) -> Choice:
    """Return a step that is one too low."""
    choice = choose_best_control(*given)
    return choice and (choice[0], choice[1] - 1)


def find_first_dip(away: list[float]) -> int:
    """Return the step before the first one that is farther away."""
    return next((k for k in range(len(away) - 1) if away[k + 1] > away[k]), len(away) - 1)


def cut_until_free(
    problem: StudentProblem, q: Array, target: Array, controls: Array, t: float, n: int
) -> Choice:
    """Cut a control before its first contact instead of leaving it out."""

    def measure(step: tuple[int, int]) -> float:
        i, k = step
        return measure_distance(problem, problem.move(q, *controls[i], k * t / n), target)

    steps = [(i, k) for i in range(len(controls)) for k in range(1, n + 1)]
    free = [(i, k) for i, k in steps if problem.is_free_drive(q, *controls[i], k * t / n)]
    return min(free, key=measure, default=None)


def demand_closer(
    problem: DrivingProblem, q: Array, target: Array, controls: Array, t: float, n: int
) -> Choice:
    """Accept only controls that come closer to the target than q itself."""
    choice = choose_best_control(problem, q, target, controls, t, n)
    if choice is None:
        return None
    v, phi = controls[choice[0]]
    end = problem.move(q, v, phi, choice[1] * t / n)
    return (
        choice
        if measure_distance(problem, end, target) < measure_distance(problem, q, target)
        else None
    )


def choose_farthest(*given: Value) -> Choice:
    """Take the farthest control instead of the closest."""
    return make_chooser(lambda problem, a, b: -problem.distance(a, b), is_free_to_cut)(*given)


def count_steps_left(choice: Value, *given: Value) -> Choice:
    """Return the control, and how many of its steps are not driven."""
    return int(choice[0]), int(given[-1] - choice[1])


def count_from_last(choice: Value, *given: Value) -> Choice:
    """Return the control, counted from the last one, and its steps."""
    return len(given[3]) - 1 - int(choice[0]), int(choice[1])


MIDDLE = [post for post in POSTS if 60 <= min(post[0]) and max(post[0]) < 180]
ROOMS = (
    make_garage((30, 30, 0), (150, 150, 0)),
    make_garage(
        (30, 30, 0),
        (150, 150, 0),
        box(100, 112, 101, 125),
        box(118, 96, 119, 97),
        box(75, 75, 90, 80),
        *MIDDLE,
    ),
)
WIDE = make_garage((10_000, 10_000, 0), (25_000, 20_000, 0), size=30_000.0)


class BestControl(ValueExercise):
    """Choose which of several controls to apply, and for how many steps."""

    name = "best_control"
    lesson = "13_kinodynamic_planning"
    kinds = ("open", "cut", "blocked", "beyond", "none")
    given = Record(
        problem=DrivenProblemShape(),
        q=POSE,
        target=POSE,
        controls=Numbers(("m", 2)),
        t=Number(),
        n=Integer(),
    )
    answer = Maybe(Integers((2,)))
    source = staticmethod(choose_best_control)
    shown = staticmethod(free_drive)
    reference = staticmethod(choose_best_control)
    slips = (
        Slip("last", compare_ends),
        Slip("unchecked", make_chooser(measure_distance, accept_any)),
        Slip("picked", pick_then_check),
        Slip("whole", make_chooser(measure_distance, is_free_throughout)),
        Slip("end_only", make_chooser(measure_distance, is_free_at_cut)),
        Slip("place", make_chooser(lambda problem, a, b: math.dist(a[:2], b[:2]), is_free_to_cut)),
        Slip(
            "no_wrap",
            make_chooser(
                lambda problem, a, b: math.hypot(*(b - a)[:2], problem.radian * (b[2] - a[2])),
                is_free_to_cut,
            ),
        ),
        Slip("dip", make_chooser(measure_distance, is_free_to_cut, cut=find_first_dip)),
        Slip("shorter", cut_until_free),
        Slip("closer", demand_closer),
        Slip("finite", make_chooser(measure_distance, is_free_to_cut, start=1e4)),
        Slip("standing", make_chooser(measure_distance, is_free_to_cut, 0)),
        Slip("counted", count_from_zero),
        Slip("farthest", choose_farthest),
    )

    changes = (
        Restated("steps_left", answer=count_steps_left),
        Restated("from_last", answer=count_from_last),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield straight controls and one that comes round again, then random controls.

        Random controls are drawn until there are enough cases of each kind.
        """
        yield Case(
            "open",
            make_arguments(ROOMS[0], (100, 100, 0), (110, 100, 0), [(2, 0), (-1, 0)], 4.0, 4),
        )
        yield Case(
            "open",
            make_arguments(
                WIDE, (10_000, 10_000, 0), (25_000, 20_000, 0), [(2, 0), (-1, 0)], 4_000.0, 4
            ),
        )
        yield Case(
            "cut", make_arguments(ROOMS[0], (100, 100, 0), (104, 100, 0), [(2, 0), (-1, 0)], 4.0, 4)
        )
        yield Case(
            "cut",
            make_arguments(
                ROOMS[0], (100, 100, 0), (90, 120, -2.6), [(2, 0.7), (-1, -0.2)], 60.0, 12
            ),
        )
        drawn: dict[str, list[Case]] = {kind: [] for kind in self.kinds}
        while min(map(len, drawn.values())) < 10:
            case = self.drawn_case(rng)
            if case is not None and len(drawn[case.kind]) < 10:
                drawn[case.kind].append(case)
        every = (case for cases in drawn.values() for case in cases)
        yield from sorted(every, key=lambda case: len(case.given["controls"]) * case.given["n"])

    def drawn_case(self, rng: np.random.Generator) -> Case | None:
        """Draw a random case and classify it.

        Returns
        -------
        The case; None where two controls are nearly equally good, or where q is not free.
        """
        room = ROOMS[int(rng.random() < 0.8)]
        n, m = int(rng.choice([2, 3, 5, 8, 12, 40])), int(rng.integers(2, 8))
        q = np.round([*rng.uniform(60, 140, 2), rng.uniform(-3.1, 3.1)], 1)
        target = np.round(q + rng.uniform((-25, -25, -1.5), (25, 25, 1.5)), 1)
        controls = np.column_stack(
            [rng.choice([-1.0, 2.0], m), np.round(rng.uniform(-0.78, 0.78, m), 2)]
        )
        if not room.problem.is_free(q):
            return None
        t = float(rng.integers(4, 20))
        arguments = make_arguments(
            room, q, np.array([*target[:2], wrap_angle(target[2])]), controls, t, n
        )
        kind = classify(arguments)
        return Case(kind, arguments) if kind else None

    def same(self, value: Value, truth: Value) -> bool:
        """Whether both are the same control and step, or both None."""
        return value is None if truth is None else value is not None and list(value) == list(truth)

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw all drives, the right one and the student's."""
        from .pictures import draw_choice

        draw_choice(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)


def make_arguments(
    room: Value, q: ArrayLike, target: ArrayLike, controls: ArrayLike, t: float, n: int
) -> Given:
    """Return the arguments of a case."""
    poses = {"q": np.array(q, float), "target": np.array(target, float)}
    return {"problem": room, **poses, "controls": np.array(controls, float), "t": t, "n": n}


@withheld
def classify(arguments: Given) -> str:
    """Return the kind of a case; "" where two answers are nearly equally good."""
    room, q, target, controls, t, n = arguments.values()
    poses = room.poses_after(q, controls, t * np.arange(1, n + 1) / n)
    away = np.sort(distance_of_poses(poses, target, room.radian), axis=1)
    least = np.sort(away[:, 0])
    if np.diff(least).min() < 1e-3 or (n > 1 and (away[:, 1] - away[:, 0]).min() < 1e-3):
        return ""
    truth = choose_best_control(*arguments.values())
    if truth is None:
        return "none"
    if truth != make_chooser(measure_distance, accept_any)(*arguments.values()):
        return "blocked"
    if not room.is_free_drive(q, *controls[truth[0]], t):
        return "beyond"
    return "open" if truth[1] == n else "cut"
