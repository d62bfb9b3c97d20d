"""The processes that a program has started, and the processor's time that they take, as Linux tells
it.
"""

import os
from pathlib import Path


def below(parent: int) -> list[int]:
    """The processes that a process started, and those that they did."""
    found: list[int] = []
    for task in Path("/proc").glob(f"{parent}/task/*/children"):
        try:
            children = [int(child) for child in task.read_text().split()]
        except OSError:
            continue
        found += children + [one for child in children for one in below(child)]
    return found


def seconds_of(processes: list[int]) -> float:
    """The processor's seconds of processes, and of children of theirs that have ended."""
    total = 0
    for process in processes:
        try:
            text = Path(f"/proc/{process}/stat").read_text(encoding="utf-8")
        except OSError:
            continue
        total += sum(map(int, text.rpartition(")")[2].split()[11:15]))
    return total / os.sysconf("SC_CLK_TCK")
