"""The exercise on dispersion: a lower and an upper bound from a lattice of probes.

Bullo & Smith, chapter 4; LaValle, section 5.2.3.
"""

import math
from collections.abc import Iterator

import numpy as np

from ....geometry.checks import Array
from ....sampling import dispersion, halton, largest_empty_ball, sukharev_grid, uniform_random
from ....sampling.dispersion import largest_empty_disc
from ...exercise import RIGHT, Axes, Case, Exercise, Restated, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Numbers, Record, Value
from .pictures import draw_holes

APART = 0.02  # the greatest allowed difference of the bounds
SLACK = 1e-9
# centres of holes that are as far as possible from all probes of a lattice that divides the square
# into 4 k + 2, 8 k + 4, 16 k + 8 and 32 k + 16 parts along each side, probes at the walls included
BETWEEN_PROBES = ((8, 24), (12, 20), (10, 22), (11, 21))  # thirty-seconds
APART_ROUND = 0.125  # half the side of the square of points round such a hole


class DispersionBounds(Exercise):
    """Compute two bounds of the Euclidean dispersion of points in the unit square."""

    name = "dispersion_bounds"
    lesson = "06_sampling"
    kinds = ("one", "inside", "wall", "corner")
    given = Record(points=Numbers(("n", 2)))
    answer = Numbers((2,))
    source = staticmethod(dispersion)
    shown = staticmethod(largest_empty_disc)

    changes = (
        Restated(
            "diameter",
            answer=lambda bounds, points: np.multiply(bounds, 2.0),
            usual_answer=lambda bounds, points: np.divide(bounds, 2.0),
        ),
        Restated(
            "middle",
            answer=lambda bounds, points: (np.mean(bounds), (bounds[1] - bounds[0]) / 2.0),
            usual_answer=lambda bounds, points: np.array([bounds[0] - bounds[1], sum(bounds)]),
        ),
    )

    def right_answer(self, *given: Value) -> Value:
        """Return the library's exact dispersion as both bounds."""
        return (dispersion(*given),) * 2

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield points that can be drawn by hand, the hundred of the book, and random ones."""
        for points in (
            [(0.5, 0.5)],
            [(0, 0), (1, 0), (1, 1), (0, 1)],
            [(0, 0), (0, 0.5), (0, 1), (1, 0), (1, 0.5), (1, 1)],
            [(0.2, 0.2), (0.8, 0.2), (0.2, 0.8)],
            [(0, 0)],
            [(0.5, 0.1), (0.5, 0.9)],
            [(0.3, 0.3), (0.4, 0.3), (0.3, 0.4), (0.4, 0.4)],
            [(0.1, 0.5), (0.9, 0.5), (0.5, 0.5)],
        ):
            yield make_case(np.array(points, float))
        yield make_case(halton(100))
        for centre in BETWEEN_PROBES:
            yield make_case(surround(np.array(centre) / 32))
        yield from self.chosen(rng)

    def chosen(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield eight random cases of each kind."""
        for _ in range(8):
            yield make_case(np.round(rng.uniform(0, 1, (1, 2)), 2))
            for kind in self.kinds[1:]:
                case = make_case(draw_points_at_random(rng))
                while case.kind != kind:
                    case = make_case(draw_points_at_random(rng))
                yield case

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Judge that both bounds hold and that they are close to each other."""
        (low, high), points = value, case.given["points"]
        truth, sup = dispersion(points), dispersion(points, math.inf)
        rule = ""
        if not np.isfinite([low, high]).all() or low > high + SLACK:
            rule = "bounds"
        elif low > truth + SLACK:
            rule = "low"
        elif high < truth - SLACK:
            by_kind = "high" if case.kind == "inside" else f"high_{case.kind}"
            rule = "sup" if low <= sup <= high else by_kind
        elif high - low > APART + SLACK:
            rule = "apart"
        return Verdict(0.0, rule, self.describe_expected(case)) if rule else RIGHT

    def describe_expected(self, case: Case) -> str:
        """Describe what the answer must be."""
        return self.message("wanted", truth=f"{dispersion(case.given['points']):.6f}", apart=APART)

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the points, the largest hole, and both bounds around its centre."""
        draw_holes(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)


def make_case(points: Array) -> Case:
    """Return a case, classified by where the centre of the largest hole lies."""
    centre = largest_empty_ball(points).centre
    walls = int(((centre < SLACK) | (centre > 1.0 - SLACK)).sum())
    return Case(
        "one" if len(points) == 1 else ("inside", "wall", "corner")[walls], {"points": points}
    )


def surround(centre: Array) -> Array:
    """Points all over the square, in which four points on diagonals leave a hole round a centre.

    Towards each of the four the distance decreases as fast as one moves, so that probes beside the
    centre find much less than the size of the hole.
    """
    i, j = np.indices((19, 19)).reshape(2, -1) - 9
    kept = ((i + j) % 2 == 0) & ((i != 0) | (j != 0))  # a grid and its centres, but for one centre
    points = centre + APART_ROUND * np.column_stack([i, j])[kept]
    near = ((points > -APART_ROUND) & (points < 1.0 + APART_ROUND)).all(axis=1)
    return np.unique(np.clip(points[near], 0.0, 1.0), axis=0)


def draw_points_at_random(rng: np.random.Generator) -> Array:
    """Draw 2 to 60 points of the unit square.

    They are random, of Halton's sequence, or of a perturbed grid.
    """
    n = int(rng.integers(2, 40))
    if rng.random() < 0.4:
        return np.round(uniform_random(n, rng=rng), 2)
    if rng.random() < 0.5:
        return halton(n, start=int(rng.integers(1, 50)))
    grid = sukharev_grid(int(rng.integers(2, 7)) ** 2)
    return np.clip(grid + rng.uniform(-0.08, 0.08, grid.shape), 0.0, 1.0).round(3)
