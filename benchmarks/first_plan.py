"""New processes with a warm cache: the first plan against the first call of one bare compiled function, and the imports alone."""

import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

from timing import Contestant, Goal, measure, report, run

SECONDS = 60
IMPORTS = "import numpy, numba"
BARE = """
import numba, numpy as np

@numba.njit(cache=True)
def total(values):
    result = 0.0
    for value in values:
        result += value
    return result

print(total(np.ones(3)))
"""
FIRST_PLAN = """
import kinoedu as ke

world = ke.PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [[(4, 0), (6, 0), (6, 8), (4, 8)]])
print(ke.rrt(ke.Problem(ke.Point(), world, start=(1, 1), goal=(9, 1)), rng=0).path is not None)
"""


def process(folder: Path, name: str, source: str) -> Contestant:
    """A whole process that runs a file; a file, because numba caches nothing for code that has none."""
    script = folder / f"{name}.py"
    script.write_text(source)

    def contestant(_case: Any) -> Callable[[], str]:
        return lambda: subprocess.run([sys.executable, script], check=True, capture_output=True, text=True).stdout.strip()

    return contestant


def judge(_case: Any, answers: dict[str, str]) -> None:
    """Every process did its work."""
    assert all(answer in ("", "3.0", "True") for answer in answers.values()), answers


def main(repeats: int = 11) -> None:
    """Eleven rounds; the first of each, which may fill the caches, does not count."""
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        imports = {"kinoedu": process(folder, "ours", "import kinoedu"), "numpy and numba": process(folder, "bare", IMPORTS)}
        seconds = measure(imports, [None], judge, repeats=repeats)
        report("A new process that imports", seconds, {"numpy and numba": Goal(at_most=1.3)})
        calls = {"kinoedu": process(folder, "first_plan", FIRST_PLAN), "bare function": process(folder, "first_call", BARE)}
        seconds = measure(calls, [None], judge, repeats=repeats)
        report("A new process up to its first answer, warm cache", seconds, {"bare function": Goal(at_most=2)})


if __name__ == "__main__":
    run(main)
