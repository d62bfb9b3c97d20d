"""How time and memory grow with n, doubled up to a few seconds: neighbours, trees, roadmaps, cells,
searches, grading.

Seconds of the processor, since they mean more than the clock on a machine with other work.
"""

import csv
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from growing import GROWTHS, Task
from timing import Missing, run, turn

from kinoedu.bench import surroundings
from kinoedu.bench.running import RESULTS, SKIPPED
from kinoedu.figures.growth import Curve, save_growth

SECONDS = 300
LAST = 4  # sizes that the exponent is fitted to
HERE = Path(__file__).resolve().parent
NOTE = """\
{repeats} rounds; the exponent is the slope of the last {last} sizes on logarithmic axes, the median
over the rounds. Times are processor times. Memory is the peak resident set of a process of its own
during the work, minus what it held before: the problem itself is not counted, nor is the sandbox of
the grader."""
ALONE = (
    "import sys; sys.path.insert(0, sys.argv[1]); import growth; "
    "print(growth.memory_of(sys.argv[2], int(sys.argv[3])))"
)


def doubled(name: str, limit: float) -> list[Task]:
    """Problems of doubled size, up to the first that takes half the limit; each is solved and its
    answer judged.
    """
    growth, found, took = GROWTHS[name], [], 0.0
    growth.make_task(growth.first).work()  # compiles
    while took < limit / 2 or len(found) < LAST:
        task = growth.make_task(growth.first * 2 ** len(found))
        took, answer = once(task, growth.clock, runs=1)
        task.judge(answer)
        found.append(task)
    return found


def timed(name: str, limit: float, repeats: int) -> Curve:
    """All sizes, round after round."""
    problems = doubled(name, limit)
    rounds = [[once(task, GROWTHS[name].clock)[0] for task in problems] for _ in range(repeats)]
    n, seconds = np.array([task.n for task in problems], float), np.array(rounds).T
    return Curve(
        name, GROWTHS[name].unit, n, seconds, float(np.median(exponents(n, seconds))), LAST
    )


def once(task: Task, clock: Callable[[], float], *, runs: int = 5) -> tuple[float, Any]:
    """Seconds of the processor for a problem, the best of a few runs, and the answer."""
    return turn(lambda _: task.work, None, runs=runs, clock=clock)


def exponents(n: np.ndarray, seconds: np.ndarray) -> np.ndarray:
    """The slope of the last sizes of each round, both axes logarithmic, (rounds,)."""
    return np.polyfit(np.log(n[-LAST:]), np.log(seconds[-LAST:]), 1)[0]


def memory_of(name: str, n: int) -> int:
    """The most bytes that this process holds while it works, over what it held before: the problem
    and code compiled are not in it.

    Raises Missing where the system does not know it.
    """
    growth = GROWTHS[name]
    growth.make_task(growth.first).work()
    work, status = growth.make_task(n).work, Path("/proc/self/status")
    try:
        Path("/proc/self/clear_refs").write_text("5")  # the most from now on
        before = kilobytes(status, "VmRSS")
        answer = work()
        return 1024 * (kilobytes(status, "VmHWM") - before) if answer is not None else 0
    except OSError:
        raise Missing("/proc/self/clear_refs, as Linux has it") from None


def kilobytes(status: Path, key: str) -> int:
    """A number of /proc/self/status."""
    return next(
        int(line.split()[1]) for line in status.read_text().splitlines() if line.startswith(key)
    )


def memory_alone(curve: Curve, n: int) -> str:
    """The memory of the largest n in a process of its own, in MB; "" where the system does not
    know it.
    """
    command = [sys.executable, "-c", ALONE, str(HERE), curve.name, str(n)]
    ran = subprocess.run(
        command, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False
    )
    return f"{int(ran.stdout) / 1e6:.3g}" if ran.returncode == 0 else ""


def line_of(curve: Curve) -> str:
    """A line of the table."""
    growth, slopes, most = GROWTHS[curve.name], exponents(curve.n, curve.seconds), curve.seconds[-1]
    memory = memory_alone(curve, growth.first * 2 ** (len(curve.n) - 1))
    cells = [
        curve.name,
        f"{slopes.min():.2f} to {slopes.max():.2f}",
        growth.expected,
        f"{curve.n[0]:,.0f} to {curve.n[-1]:,.0f}",
    ]
    return (
        f"| {' | '.join([*cells, curve.unit, f'{1e3 * np.median(most):,.3g}', memory])} | "
        f"**{curve.exponent:.2f}** |"
    )


def write_csv(curves: list[Curve], file: Path) -> None:
    """A line for each time."""
    with file.open("w", newline="", encoding="utf-8") as table:
        lines = csv.writer(table)
        lines.writerow(("growth", "unit", "n", "round", "processor_seconds"))
        for curve in curves:
            for n, times in zip(curve.n.astype(int).tolist(), curve.seconds):
                lines.writerows(
                    (curve.name, curve.unit, n, number, f"{took:.6g}")
                    for number, took in enumerate(times, start=1)
                )


def main(repeats: int = 5, limit: float = 2.0, only: str = "") -> None:
    """All of them, or one; the largest n takes about `limit` seconds."""
    if only not in ("", *GROWTHS):
        sys.exit(f"there is no growth {only!r}; there are {', '.join(GROWTHS)}")
    folder = Path(os.environ.get(RESULTS, HERE / "results"))
    folder.mkdir(parents=True, exist_ok=True)
    print(
        "| | exponents of the rounds | expected | n | counts | largest n, ms | its memory, MB | "
        "exponent |"
    )
    print("|---|---:|---:|---:|---|---:|---:|---:|")
    curves, left_out = [], []
    for name in [only] if only else GROWTHS:
        try:
            curves.append(timed(name, limit, repeats))
        except Missing as missing:
            left_out.append(f"{SKIPPED}{name} ({missing})")
        else:
            print(line_of(curves[-1]), flush=True)
    print("", *left_out, sep="\n")
    print(f"\n{NOTE.format(repeats=repeats, last=LAST)}\n\n{surroundings()}", flush=True)
    if curves:
        write_csv(curves, folder / "growth.csv")
        save_growth(curves, folder / "growth.png")


if __name__ == "__main__":
    run(main)
