"""The exercise on the probability of a collision, estimated from given scenarios.

A path leads among discs whose positions are uncertain.
"""

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from ....collision import probability
from ....geometry.checks import Array
from ...exercise import Axes, Case, Restated, Slip, ValueExercise, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Numbers, Record, Value
from ...withheld import withheld
from .pictures import draw_scenarios
from .scenarios import Hits, find_contacts, measure_gaps

CLEAR = 1e-4  # scenarios in which a path nearly touches a disc, by less than this, are left out
Z = 1.96
# a disc with a smaller radius fits between the points of a path that a program samples
TINY = 0.01

# kind, path, discs, and a list of offsets for each scenario: cases that can be drawn by hand
SHORT, LONG, BENT = [(0, 0), (4, 0)], [(0, 0), (6, 0)], [(0, 0), (4, 0), (4, 4)]
PAIR = [(1, 2, 1), (4, 2, 1)]
SMALL: tuple[tuple[str, Any, Any, Any], ...] = (
    ("one", SHORT, [(2, 1.5, 1)], [[(0, 0)], [(0, -1)], [(0, 1)], [(5, 0)]]),
    ("one", SHORT, [(6.5, 0, 1)], [[(-1.5, 0)], [(-1, 0.2)], [(0, 0)]]),  # it touches the end
    ("one", SHORT, [(6.5, 0, 1)], [[(0, 0)], [(-1, 0.2)], [(-2, 0)], [(0, -0.5)]]),
    (
        "one",
        [(0, 0), (20, 0)],
        [(7, 0.00015, 0.0003)],
        [[(0.0123, 0)], [(3.4567, 0)], [(-5.433, 0)], [(6, 0.5)]],
    ),
    # in millimetres
    (
        "one",
        [(0, 0), (4e5, 0)],
        [(2e5, 1.5e5, 1e5)],
        [[(0, 0)], [(0, -1e5)], [(0, 1e5)], [(5e5, 0)]],
    ),
    ("bent", BENT, [(6, 2, 1)], [[(0, 0)], [(-1.5, 0)], [(-4, 0)], [(-3.5, -1.8)]]),
    (
        "several",
        LONG,
        PAIR,
        [
            [(0, -1.5), (0, -1.5)],
            [(0, 0), (0, -1.5)],
            [(0, -1.5), (0, 1)],
            [(0, 0), (0, 0)],
        ],
    ),
    ("none", SHORT, [(2, 2, 1)], [[(0, 0)], [(1, 0)], [(0, 1)], [(0, -0.5)]]),
    (
        "all",
        LONG,
        PAIR,
        [[(0, -1.5), (0, 0)], [(0, 0), (0, -1.5)], [(0, 1), (0, -1.5)]],
    ),
)


def add_interval(hits: float, n: int) -> Array:
    """Return the fraction hits / n and the ends of its Wilson interval with z = 1.96, (3,)."""
    share, square = hits / n, Z * Z / n
    reach = Z * np.sqrt(share * (1.0 - share) / n + square / (4 * n))
    ends = (share + square / 2 + np.array([-reach, reach])) / (1.0 + square)
    return np.array([share, *ends.clip(0.0, 1.0)])


@withheld
def estimate_probability(path: Array, discs: Array, offsets: Array) -> Array:
    """Return the fraction of scenarios that hit the path with its 95 percent interval, (3,)."""
    return add_interval(int(find_contacts(path, discs, offsets).any(axis=1).sum()), len(offsets))


def use_normal_interval(path: Array, discs: Array, offsets: Array) -> Array:
    """Return the fraction plus and minus 1.96 standard deviations, shape (3,)."""
    share = find_contacts(path, discs, offsets).any(axis=1).mean()
    reach = Z * np.sqrt(share * (1 - share) / len(offsets))
    return np.array([share, share - reach, share + reach])


def count_by(count: Callable[[Hits], float]) -> Callable[..., Array]:
    """Return a program that counts contacts with `count`."""

    def mistaken(path: Array, discs: Array, offsets: Array) -> Array:
        hits = find_contacts(path, discs, offsets)
        share = min(count(hits), 1.0)
        return add_interval(share * len(hits), len(hits))

    return mistaken


def change_input(change: Callable[..., tuple[Array, Array, Array]]) -> Callable[..., Array]:
    """Return a program that is right about a path, discs or offsets changed by `change`."""
    return lambda path, discs, offsets: estimate_probability(*change(path, discs, offsets))


def miss_tiny_discs(path: Array, discs: Array, offsets: Array) -> Array:
    """Ignore discs so small that they fit between the sampled points of a path."""
    hits = find_contacts(path, discs, offsets)[:, discs[:, 2] >= TINY]
    return add_interval(int(hits.any(axis=1).sum()), len(offsets))


def check_points_only(path: Array, discs: Array, offsets: Array) -> Array:
    """Check only the points of the path, not the segments between them."""
    points = np.repeat(path, 2, axis=0)
    hits = np.any(
        [find_contacts(points[2 * k : 2 * k + 2], discs, offsets) for k in range(len(path))], axis=0
    )
    return add_interval(int(hits.any(axis=1).sum()), len(offsets))


def count_misses(shares: Value, *given: Value) -> Array:
    """Return the same three numbers for the scenarios without a hit."""
    share, low, high = shares
    return np.array([1.0 - share, 1.0 - high, 1.0 - low])


class CollisionProbability(ValueExercise):
    """Estimate the fraction of scenarios in which a path is hit, with its interval."""

    name = "collision_probability"
    lesson = "14_moving_and_uncertain"
    kinds = ("one", "bent", "several", "none", "all")
    given = Record(path=Numbers(("k", 2)), discs=Numbers(("m", 3)), offsets=Numbers(("n", "m", 2)))
    answer = Numbers((3,))
    tolerance = 1e-4
    source = staticmethod(estimate_probability)
    shown = staticmethod(probability.collision_probability)
    slips = (
        Slip("corners", check_points_only),
        Slip("points", miss_tiny_discs),
        Slip("per_disc", count_by(lambda hits: float(hits.sum() / len(hits)))),
        Slip("pairs", count_by(lambda hits: float(hits.mean()))),
        Slip("every_disc", count_by(lambda hits: float(hits.all(axis=1).mean()))),
        Slip(
            "independent",
            count_by(lambda hits: 1.0 - float(np.prod(1.0 - hits.mean(axis=0)))),
        ),
        Slip("missed", count_by(lambda hits: 1.0 - float(hits.any(axis=1).mean()))),
        Slip("normal", use_normal_interval),
        Slip(
            "one_offset",
            change_input(
                lambda path, discs, offsets: (
                    path,
                    discs,
                    offsets[:, :1].repeat(len(discs), axis=1),
                )
            ),
        ),
        Slip("minus", change_input(lambda path, discs, offsets: (path, discs, -offsets))),
        Slip("expected", change_input(lambda path, discs, offsets: (path, discs, 0.0 * offsets))),
        Slip(
            "first_disc",
            change_input(lambda path, discs, offsets: (path, discs[:1], offsets[:, :1])),
        ),
        Slip(
            "last_stretch",
            change_input(
                lambda path, discs, offsets: (path[: max(len(path) - 1, 2)], discs, offsets)
            ),
        ),
        Slip(
            "closed",
            change_input(
                lambda path, discs, offsets: (np.vstack([path, path[:1]]), discs, offsets)
            ),
        ),
        Slip("beeline", change_input(lambda path, discs, offsets: (path[[0, -1]], discs, offsets))),
    )
    reference = staticmethod(estimate_probability)

    changes = (
        Restated("no_hit", answer=count_misses),
        Restated(
            "percent",
            answer=lambda shares, *given: np.multiply(shares, 100.0),
            usual_answer=lambda percent, *given: np.divide(percent, 100.0),
        ),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield a few scenarios that can be drawn by hand, then random ones."""
        for kind, *given in SMALL:
            arrays = [np.array(rows, float) for rows in given]
            yield Case(kind, dict(zip(("path", "discs", "offsets"), arrays)))
        wanted = dict.fromkeys(self.kinds, 10)
        while any(wanted.values()):
            kind = next(kind for kind, left in wanted.items() if left == max(wanted.values()))
            case = draw_case(kind, rng)
            if case is not None:
                wanted[kind] -= 1
                yield case

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Judge the fraction and the interval.

        A right fraction with a wrong interval breaks a rule of its own, except where no
        scenario or every scenario is hit.
        """
        verdict = super().value_verdict(case, value)
        is_share = self.near(float(value[0]), float(self.truth(case)[0])) and case.kind not in (
            "none",
            "all",
        )
        return verdict._replace(rule="interval") if verdict.rule and is_share else verdict

    def ask_for_answers(self, case: Case) -> None:
        """Ask also for the contacts, which the picture shows."""
        super().ask_for_answers(case)
        find_contacts(*case.given.values())

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the path, the discs at their centres and in scenarios, and both answers."""
        draw_scenarios(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)


def draw_case(kind: str, rng: np.random.Generator) -> Case | None:
    """Draw a random case of a kind; None where it turns out to be of another kind."""
    n, m, k = int(rng.integers(40, 120)), 1, 2
    if kind != "one":
        m, k = int(rng.integers(2, 5)), int(rng.integers(3, 5))
    path = np.round(rng.uniform(0, 10, (k, 2)), 1)
    sizes: Array = rng.uniform(0.3, 1.5, m)
    discs: Array = np.column_stack([rng.uniform(0, 10, (m, 2)), sizes]).round(1)
    offsets: Array = np.round(rng.normal(0, rng.uniform(0.3, 1.5, m)[:, None], (n, m, 2)), 3)
    if kind not in list_kinds(path, discs, offsets):
        return None
    return Case(kind, {"path": path, "discs": discs, "offsets": offsets})


@withheld
def list_kinds(path: Array, discs: Array, offsets: Array) -> list[str]:
    """Return the kinds that a case fits; none where a disc is nearly touched or a motion is 0."""
    near = measure_gaps(path, discs, offsets)
    if np.abs(near).min() < CLEAR or (np.diff(path, axis=0) == 0.0).all(axis=1).any():
        return []
    hits = near <= 0.0
    share = hits.any(axis=1).mean()
    fits = {
        "none": share == 0.0,
        "all": share == 1.0 and not hits.all(axis=0).any(),
        "one": 0.1 < share < 0.9,
        "bent": 0.1 < share < 0.9,
        "several": 0.1 < share < 0.9 and (hits.sum(axis=1) > 1).any(),
    }
    return [kind for kind, is_one in fits.items() if is_one]
