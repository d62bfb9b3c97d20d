"""The exercise that compares planners over many seeds by medians, quartiles and failures."""

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

import numpy as np

from ....geometry.checks import Array
from ...exercise import Axes, Case, Given, Slip, ValueExercise
from ...outcomes import Answer, Outcome
from ...shapes import Listed, Numbers, Record, Text, Value
from ...whole_shapes import Integer
from ...withheld import withheld

QUARTERS = (0.25, 0.5, 0.75)


def use_method(method: str) -> Callable[..., Array]:
    """Return a program whose quartiles are always among the lengths."""
    return lambda lengths, *_: make_table(
        lengths, keep_found, partial(find_quartiles, method=method)
    )


class ComparePlanners(ValueExercise):
    """Compute for each planner how often it finds a path, and the quartiles of the lengths.

    A row holds the fraction of seeds with a path, lower quartile, median and upper quartile.
    """

    name = "compare_planners"
    lesson = "10_terrains"
    kinds = ("all_found", "other_seeds", "some_fail", "none_found", "outlier")
    given = Record(
        lengths=Numbers(("planners", "seeds")), planners=Listed(Text(40)), seeds=Listed(Integer())
    )
    answer = Numbers(("n", 4))
    one_for_each = "planners"
    slips = (
        Slip("mean", lambda lengths, *_: make_table(lengths, keep_found, find_mean_and_quartiles)),
        Slip("with_failures", lambda lengths, *_: make_table(lengths, keep_all)),
        Slip("failures_are_zero", lambda lengths, *_: make_table(lengths, take_failures_as_zero)),
        Slip("percent", lambda lengths, *_: make_table(lengths) * (100.0, 1.0, 1.0, 1.0)),
        Slip(
            "whole_spread",
            lambda lengths, *_: make_table(
                lengths, keep_found, partial(find_quartiles, quarters=(0.0, 0.5, 1.0))
            ),
        ),
        *(Slip("not_between", use_method(method)) for method in ("nearest", "lower", "higher")),
        Slip("deviation", lambda lengths, *_: use_deviations(lengths)),
        Slip("one_seed", lambda lengths, *_: make_table(lengths[:, :1])),
        Slip("counts", lambda lengths, *_: make_table(lengths) * (lengths.shape[1], 1.0, 1.0, 1.0)),
    )

    @staticmethod
    @withheld
    def reference(lengths: Array, planners: list[str], seeds: list[int]) -> Array:
        """Return rows of fraction found, lower quartile, median and upper quartile."""
        return make_table(lengths)

    source = reference

    def call(self, function: Callable[..., object], given: Given) -> Value:
        """Call the student's function with a runner for the given planners and seeds.

        The runner raises a ValueError for any other planner or seed.
        """
        lengths, planners, seeds = given.values()

        def run(planner: str, seed: int) -> float:
            """Return the length of a planner's path with a seed; infinity without a path."""
            if planner not in planners or int(seed) not in seeds:
                raise ValueError(
                    f"run was called with planner {planner!r} and seed {seed!r}; the planners are "
                    f"{planners}, the seeds are {seeds}"
                )
            return float(lengths[planners.index(planner), seeds.index(int(seed))])

        return function(run, list(planners), list(seeds))

    def right_answer(self, run: Any, planners: list[str], seeds: list[int]) -> Array:
        """Return the table of all runs."""
        lengths = np.array([[run(planner, seed) for seed in seeds] for planner in planners])
        return self.reference(lengths, planners, seeds)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield four tables that can be computed by hand, then random ones.

        Some planners fail, and some runs are outliers.
        """
        inf = float("inf")
        for kind, rows, numbers in (
            ("all_found", [[4.0, 2.0, 6.0, 8.0, 10.0]], [0, 1, 2, 3, 4]),
            ("other_seeds", [[4.0, 2.0, 6.0, 8.0, 10.0]], [7, 3, 11, 2, 5]),
            ("some_fail", [[4.0, inf, 6.0, inf]], [0, 1, 2, 3]),
            ("some_fail", [[4.0, inf]], [0, 1]),
            ("none_found", [[inf, inf], [1.0, 2.0]], [0, 1]),
            ("outlier", [[2.0, 2.0, 3.0, 100.0]], [0, 1, 2, 3]),
        ):
            yield self.make_case(kind, np.array(rows), numbers)
        for _ in range(11):
            for kind in self.kinds:
                n, m = int(rng.integers(1, 4)), int(rng.integers(5, 40))
                lengths = np.round(rng.gamma(4.0, 60.0, (n, m)) + 334.0, 3)
                if kind == "some_fail":
                    lengths[rng.random((n, m)) < 0.3] = inf
                    lengths[:, 0], lengths[:, 1] = 400.0, inf
                elif kind == "none_found":
                    lengths[-1] = inf
                elif kind == "outlier":
                    lengths[:, m // 2] *= 30.0
                seeds = (
                    rng.permutation(100)[:m].tolist() if kind == "other_seeds" else list(range(m))
                )
                yield self.make_case(kind, lengths, seeds)

    def make_case(self, kind: str, lengths: Array, seeds: list[int]) -> Case:
        """Return a case with a planner's name for each row."""
        names = ["RRT", "PRM", "A*"][: len(lengths)]
        return Case(kind, {"lengths": lengths, "planners": names, "seeds": seeds})

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw every run as a dot, the right quartiles and median, and the student's."""
        from .pictures import draw_runs

        draw_runs(
            self, case, outcome.value if isinstance(outcome, Answer) else None, self.truth(case), ax
        )


def keep_found(runs: Array) -> Array:
    """Return the lengths of the runs that found a path: the right ones."""
    return runs[np.isfinite(runs)]


def keep_all(runs: Array) -> Array:
    """Return all lengths, infinite where no path was found."""
    return runs


def take_failures_as_zero(runs: Array) -> Array:
    """Return all lengths, 0 where no path was found."""
    return np.where(np.isfinite(runs), runs, 0.0)


def find_quartiles(
    lengths: Array, quarters: tuple[float, ...] = QUARTERS, method: Any = "linear"
) -> tuple[float, ...]:
    """Return the quartiles of lengths; nan where there are none."""
    if not len(lengths):
        return (np.nan,) * len(quarters)
    return tuple(np.quantile(lengths, quarters, method=method).tolist())


def find_mean_and_quartiles(lengths: Array) -> tuple[float, ...]:
    """Return the quartiles, with the mean in place of the median."""
    low, _, high = find_quartiles(lengths)
    return low, float(np.mean(lengths)) if len(lengths) else np.nan, high


def make_table(
    lengths: Array,
    keep: Callable[[Array], Array] = keep_found,
    summarise: Callable[[Array], tuple[float, ...]] = find_quartiles,
) -> Array:
    """Return for each row of lengths the fraction found and a summary of the lengths kept."""
    return np.array([(np.isfinite(runs).mean(), *summarise(keep(runs))) for runs in lengths])


def use_deviations(lengths: Array) -> Array:
    """Return mean and mean plus and minus one standard deviation."""
    table = make_table(lengths, keep_found, find_mean_and_quartiles)
    sigma = np.array(
        [np.std(runs[np.isfinite(runs)]) if np.isfinite(runs).any() else np.nan for runs in lengths]
    )
    table[:, 1], table[:, 3] = table[:, 2] - sigma, table[:, 2] + sigma
    return table
