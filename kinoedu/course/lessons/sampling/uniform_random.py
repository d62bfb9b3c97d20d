"""The exercise on random points. Bullo & Smith, chapter 4; LaValle, section 5.2.2."""

from collections.abc import Callable, Iterator

import numpy as np

from ....geometry.checks import Array
from ....sampling import uniform_random
from ...exercise import RIGHT, Axes, Case, Exercise, Given, Verdict, format_value
from ...outcomes import Answer, Outcome
from ...shapes import Record, Together, Value
from ...sizes import MOST_NUMBERS
from ...watching import FAR
from ...whole_shapes import Integer
from .grids import DIMENSIONS, POINTS, find_points_fault
from .pictures import draw_points

BOXES = {1: 64, 2: 8, 3: 4}  # boxes along each side by dimension: 64 in all
MANY = 640  # points from which their spread is tested: ten in each box
# bounds of the chi-square statistic of 64 boxes; random points leave them once in 10^9 times
EVEN, UNEVEN = 16.0, 160.0
REPEATED = 10  # one coordinate in so many may be equal to another; random ones never are
CORRELATED = 0.3  # the correlation of 640 independent pairs exceeds it once in 10^13 times


class UniformRandom(Exercise):
    """Draw n random points of the unit cube."""

    name = "uniform_random"
    lesson = "06_sampling"
    kinds = ("few", "line", "plane", "space")
    given = Record(n=Integer(), d=Integer(), rng=Integer())
    answer = Together((POINTS, POINTS, POINTS, POINTS), is_returned=False)
    source = staticmethod(uniform_random)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield few points, the hundred of the book, and enough points to test their spread."""
        for n, d in ((3, 1), (4, 2), (1, 2), (2, 3), (100, 2)):
            yield make_case(n, d, int(rng.integers(1000)))
        for _ in range(10):
            yield make_case(
                int(rng.integers(1, 50)), int(rng.integers(1, 4)), int(rng.integers(1000))
            )
            for d in DIMENSIONS:
                yield make_case(int(rng.integers(MANY, 2000)), d, int(rng.integers(1000)))

    def call(self, function: Callable[..., object], given: Given) -> Value:
        """Call the student's function four times: twice with rng, and with two other seeds."""
        n, d, rng = given.values()
        return tuple(function(n, d, seed) for seed in (rng, rng, rng + 1, rng + FAR))

    def right_answer(self, *given: Value) -> Value:
        """Return the library's points; the library takes rng by name only."""
        n, d, rng = given
        return uniform_random(n, d, rng=rng)

    def size_limit(self, case: Case) -> int:
        """The most numbers: half as many again as the four answers have, and some more."""
        return MOST_NUMBERS + 6 * int(case.given["n"] * case.given["d"])

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Judge number and range, repeatability, another seed, and the spread.

        It also judges whether two seeds share points.
        """
        n, d, _ = case.given.values()
        first, again, *others = value
        rule = find_points_fault(first, n, d)
        if not rule and not np.array_equal(first, again):
            rule = "again"
        if not rule and any(np.array_equal(first, other) for other in others):
            rule = "another"
        rule = rule or find_randomness_fault(first)
        rule = rule or next(filter(None, (find_points_fault(one, n, d) for one in others)), "")
        if not rule and any(share_points(first, other) for other in others):
            rule = "shared"
        if not rule and any(move_together(first, other) for other in others):
            rule = "moved"
        return Verdict(0.0, rule, self.describe_expected(case)) if rule else RIGHT

    def describe_expected(self, case: Case) -> str:
        """Describe what the answer must be."""
        n, d, _ = case.given.values()
        return self.message("wanted", n=n, d=d)

    def describe_answer(self, case: Case, value: Value) -> str:
        """Describe the first of the four answers, or the two that are compared."""
        n, d, _ = case.given.values()
        first, again, other, far = value
        rule = self.value_verdict(case, value).rule

        def is_wrong(_: Array, second: Array) -> bool:
            return bool(find_points_fault(second, n, d))

        tests: dict[str, Callable[[Array, Array], bool]] = {
            "another": np.array_equal,
            "shared": share_points,
            "moved": move_together,
            "count": is_wrong,
            "outside": is_wrong,
        }
        if is_wrong(first, first) or (rule != "again" and rule not in tests):
            return format_value(first)
        key, second = "again", again
        if rule in tests:
            key, second = ("another", other) if tests[rule](first, other) else ("far", far)
        return self.message(
            f"answers.{key}", first=format_value(first[:3]), second=format_value(second[:3])
        )

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the student's points."""
        draw_points(self, case, outcome.value[0] if isinstance(outcome, Answer) else None, None, ax)


def make_case(n: int, d: int, rng: int) -> Case:
    """Return a case and classify it."""
    return Case(DIMENSIONS[d] if n >= 100 else "few", {"n": n, "d": d, "rng": rng})


def find_randomness_fault(points: Array) -> str:
    """Return the rule that shows that points (n, d) are not random, or ""."""
    n, d = points.shape
    if d > 1 and (points == points[:, :1]).all():
        return "diagonal"
    if len(np.unique(points, axis=0)) < n:
        return "distinct"
    if count_repeated(points) > n * d / REPEATED:
        return "dependent"
    if n < MANY:
        return ""
    off = measure_unevenness(points)
    if not EVEN <= off <= UNEVEN:
        return "uneven" if off > UNEVEN else "too_even"
    return "sorted" if is_in_order(points) else ""


def share_points(first: Array, other: Array) -> bool:
    """Whether two seeds share half of their points, or one coordinate of all points.

    It is tested for three points and more.
    """
    rows = set(map(tuple, first.tolist())) & set(map(tuple, other.tolist()))
    columns = (first.T[:, None] == other.T).all(axis=2)
    return len(first) > 2 and (2 * len(rows) >= len(first) or bool(columns.any()))


def count_repeated(points: Array) -> int:
    """Return how many coordinates are equal to another one, or to 1 minus another one."""
    return points.size - len(np.unique(np.minimum(points, 1.0 - points)))


def is_in_order(points: Array) -> bool:
    """Whether a coordinate never falls, or never grows, from one point to the next."""
    steps = np.diff(points, axis=0)
    return bool(((steps >= 0.0).all(axis=0) | (steps <= 0.0).all(axis=0)).any())


def move_together(first: Array, other: Array) -> bool:
    """Whether many points of another seed are those of the first, moved all in the same way."""
    if len(first) < MANY:
        return False
    both = zip(first.T, other.T)
    return any(abs(float(np.corrcoef(x, y)[0, 1])) > CORRELATED for x, y in both)


def measure_unevenness(points: Array) -> float:
    """Return the chi-square statistic of the counts of points in 64 equal boxes.

    It is the sum of (count - expected)^2 / expected, about 63 for random points of any number.
    """
    n, d = points.shape
    places = np.clip(np.floor(points * BOXES[d]), 0, BOXES[d] - 1).astype(np.int64)
    counts = np.bincount(np.ravel_multi_index(tuple(places.T), (BOXES[d],) * d), minlength=64)
    return float(((counts - n / 64) ** 2).sum() / (n / 64))
