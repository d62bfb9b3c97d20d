"""How many submissions of the geometry assignment are graded a second, where the time goes, and
what nbgrader takes beside it.

Seconds of the processor, since they mean more than the clock on a machine with other work; and the
clock's.
"""

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from grading_soak import HOUSE, SECRET, class_of, grader, results
from processes import below, seconds_of

from kinoedu.grading.assignments.questions import read_assignment
from kinoedu.grading.judge.submission import grade
from kinoedu.grading.sandbox.sandbox import Sandbox

NAME = "01_geometry"


def processor() -> float:
    """Seconds of the processor that this process has used, and what it started, also what has ended
    in a sandbox.
    """
    return time.process_time() + seconds_of(below(os.getpid()))


def timed(work: Callable[[], Any], times: int) -> tuple[float, float]:
    """Seconds of the processor and of the clock for one run of the work, which has been run once
    before.
    """
    work()
    begun, clock = processor(), time.perf_counter()
    for _ in range(times):
        work()
    return (processor() - begun) / times, (time.perf_counter() - clock) / times


def one_by_one(times: int) -> dict[str, tuple[float, float]]:
    """One submission: a right one, an empty one, and a request in which nothing is run, which is
    what the sandbox costs.
    """
    box, task = Sandbox(), read_assignment(NAME)
    right, empty = (
        (HOUSE / room / f"{NAME}.ipynb").read_bytes() for room in ("solutions", "exercises")
    )
    limits = {"memory": 2**30, "cpu": 10, "files": 2**20}
    request = {"cells": [], "questions": [], "lent": [], "drawing": False, "patience": 1.0}
    nothing = [{**request, "limits": limits}]
    found = {
        "a right submission": timed(lambda: grade(right, task, SECRET, box), times),
        "an empty one": timed(lambda: grade(empty, task, SECRET, box), times),
        "the sandbox alone": timed(lambda: box.ask(nothing, 10.0), times),
    }
    box.close()
    return found


def a_class(size: int, workers: int, folder: Path) -> float:
    """Seconds of the clock for a class on so many workers, all that starts included."""
    out = folder / f"out{workers}"
    begun = time.perf_counter()
    grader(folder / "class", out, str(workers)).wait()
    assert len(results(out)) == size
    return time.perf_counter() - begun


def nbgrader(times: int, folder: Path) -> tuple[float, float]:
    """nbgrader's autograde on the same notebook, for so many students."""
    course = folder / "course"
    (course / "source" / NAME).mkdir(parents=True)
    shutil.copy(HOUSE / "solutions" / f"{NAME}.ipynb", course / "source" / NAME)
    for number in range(times):
        place = course / "submitted" / f"student{number}" / NAME
        place.mkdir(parents=True)
        shutil.copy(HOUSE / "solutions" / f"{NAME}.ipynb", place)
    command = [sys.executable, "-m", "nbgrader"]
    options = {"cwd": course, "check": True, "capture_output": True}
    subprocess.run([*command, "generate_assignment", NAME], **options)  # type: ignore[call-overload]
    before, clock = os.times(), time.perf_counter()
    subprocess.run([*command, "autograde", NAME], **options)  # type: ignore[call-overload]
    after = os.times()
    used = (
        after.children_user + after.children_system - before.children_user - before.children_system
    )
    return used / times, (time.perf_counter() - clock) / times


def main() -> None:
    """Measure and print."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument(
        "submissions", nargs="?", type=int, default=30, help="default: %(default)s"
    )
    size = options.parse_args().submissions
    rows = one_by_one(min(size, 20))
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        class_of(size, folder / "class", 0.0)
        clock = {workers: a_class(size, workers, folder) for workers in (1, 2)}
        try:
            rows["nbgrader's autograde"] = nbgrader(3, folder)
        except (subprocess.CalledProcessError, OSError) as error:
            print(f"skipped: nbgrader ({str(getattr(error, 'stderr', error))[-300:]})")
    for what, (used, took) in rows.items():
        print(
            f"{what:24s} {used * 1e3:8.1f} ms of the processor {took * 1e3:8.1f} ms by the clock "
            f"{1 / used:7.1f} a second and core"
        )
    print(
        f"a class of {size}, half of them empty: "
        f"{', '.join(f'{took:.1f} s on {n}' for n, took in clock.items())} workers"
    )


if __name__ == "__main__":
    main()
