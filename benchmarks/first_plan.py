"""New processes: the import beside numpy's, and the README's first plan with an empty cache beside
the same with a warm one.
"""

import itertools
import os
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

from timing import Contestant, Goal, measure, report, run

from kinoedu.compiled import WHEN_IT_PAYS

SECONDS = 300
COURSE = Path(__file__).resolve().parent.parent
TOWN = ["plan", "notebooks/maps/Paris_1_256.map", "--query", "324", "--planner", "prm"]
USED = "import kinoedu as ke; ke.rrt, ke.Problem, ke.PolygonWorld"


def process(*arguments: str, caches: Callable[[], Path]) -> Contestant:
    """A whole process of Python, which finds its cache in the next of some folders; what it prints,
    without the time it took.
    """

    def contestant(_case: Any) -> Callable[[], str]:
        def plan() -> str:
            variables = {"KINOEDU_CACHE": str(caches()), "KINOEDU_MACHINE_CODE": WHEN_IT_PAYS}
            line = [sys.executable, *arguments]
            done = subprocess.run(
                line,
                cwd=COURSE,
                env=os.environ | variables,
                check=True,
                capture_output=True,
                text=True,
            )
            return done.stdout.partition(";")[0]

        return plan

    return contestant


def judge(_case: Any, answers: dict[str, str]) -> None:
    """Every process found the same."""
    assert len(set(answers.values())) == 1, answers


def main(repeats: int = 11) -> None:
    """Eleven rounds; the first of each, which may fill the caches, does not count."""
    with tempfile.TemporaryDirectory() as place:
        warm, numbers = Path(place) / "warm", itertools.count()
        once, anew = (lambda: warm), (lambda: Path(place) / f"empty{next(numbers)}")
        imports = {
            "kinoedu": process("-c", "import kinoedu", caches=once),
            "kinoedu, a planner and a world": process("-c", USED, caches=once),
            "numpy": process("-c", "import numpy", caches=once),
        }
        report(
            "A new process that imports",
            measure(imports, [None], judge, repeats=repeats),
            {"numpy": Goal(at_most=1.3)},
        )
        plan = ("-m", "kinoedu", *TOWN)
        variables = {"KINOEDU_CACHE": str(warm), "KINOEDU_MACHINE_CODE": "first"}
        subprocess.run(
            [sys.executable, *plan],
            cwd=COURSE,
            env=os.environ | variables,
            check=True,
            capture_output=True,
        )
        plans = {
            "kinoedu": process(*plan, caches=anew),
            "with a warm cache": process(*plan, caches=once),
        }
        seconds = measure(plans, [None], judge, repeats=repeats)
        report("The first plan, empty cache", seconds, {"with a warm cache": Goal(at_most=1.5)})


if __name__ == "__main__":
    run(main)
