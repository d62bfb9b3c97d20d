"""A million points of Halton's sequence in the plane."""

from typing import Any

import numpy as np
from timing import Contestant, Goal, available, measure, report, run

import kinoedu as ke

SECONDS = 10
POINTS = 1_000_000
GOALS = {"scipy": Goal(at_least=20)}


def kinoedu() -> Contestant:
    """The public function, from number 0 as scipy begins."""
    return lambda n: lambda: ke.halton(n, start=0)


def scipy() -> Contestant:
    """scipy.stats.qmc, not scrambled."""
    from scipy.stats import qmc

    def contestant(n: int) -> Any:
        engine = qmc.Halton(2, scramble=False)
        return lambda: engine.random(n)

    return contestant


def judge(n: int, answers: dict[str, Any]) -> None:
    """The same points, but for what scipy rounds along the way."""
    if "scipy" in answers:
        assert answers["kinoedu"].shape == (n, 2)
        assert np.abs(answers["kinoedu"] - answers["scipy"]).max() < 1e-14


def main(repeats: int = 11) -> None:
    """Eleven rounds."""
    contestants = available({"kinoedu": kinoedu, "scipy": scipy})
    seconds = measure(contestants, [POINTS], judge, repeats=repeats)
    report(f"Halton, {POINTS:,} points in the plane", seconds, GOALS)


if __name__ == "__main__":
    run(main)
