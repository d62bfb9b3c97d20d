"""Time contestants side by side: the same cases, turn by turn, the median of many rounds, and how far the rounds spread.

A *contestant* takes a case and returns what is timed, a function without arguments; what it does before is not timed. A *maker*
returns a contestant, or raises Missing or ImportError where this computer lacks what it needs: then it is named and left out.
"""

import gc
import os
import platform
import time
from collections.abc import Callable, Iterable
from importlib.metadata import PackageNotFoundError, version
from typing import Any, NamedTuple

import numpy as np

Contestant = Callable[[Any], Callable[[], Any]]
Judge = Callable[[Any, dict[str, Any]], None]
Seconds = dict[str, list[float]]


class Missing(Exception):
    """Something that this computer lacks; the message says what."""


class Goal(NamedTuple):
    """A ratio to hold: at_most times a ruler's time, or at_least times as fast as a peer."""

    at_most: float | None = None
    at_least: float | None = None


def available(makers: dict[str, Callable[[], Contestant]]) -> dict[str, Contestant]:
    """The contestants that can be had here; the others are named."""
    found = {}
    for name, make in makers.items():
        try:
            found[name] = make()
        except (Missing, ImportError) as error:
            print(f"skipped: {name} ({error})")
    return found


def measure(contestants: dict[str, Contestant], cases: Iterable[Any], judge: Judge, *, repeats: int) -> Seconds:
    """Let everyone solve every case `repeats` times, after one round that only warms up; each round's answers are judged."""
    seconds: Seconds = {name: [] for name in contestants}
    cases = list(cases)
    for repeat in range(repeats + 1):
        for case in cases:
            answers = {}
            for name, contestant in contestants.items():
                took, answers[name] = turn(contestant, case)
                if repeat > 0:
                    seconds[name].append(took)
            judge(case, answers)
    return seconds


def turn(contestant: Contestant, case: Any, *, runs: int = 5, enough: float = 0.1) -> tuple[float, Any]:
    """The best of a few runs in a row, so that nobody pays for the caches that the one before emptied; and the last answer."""
    best, spent = np.inf, 0.0
    gc.collect()
    gc.disable()
    for _ in range(runs):
        run = contestant(case)
        began = time.perf_counter()
        answer = run()
        took = time.perf_counter() - began
        best, spent = min(best, took), spent + took
        if spent > enough:
            break
    gc.enable()
    return best, answer


def report(title: str, seconds: Seconds, goals: dict[str, Goal], *, ours: str = "kinoedu") -> None:
    """Print a table: each ratio is the median over the rounds, with the middle half of them in brackets."""
    print(f"\n### {title}\n\n| contestant | median, ms | ratio | to hold | |\n|---|---:|---:|---:|---|")
    for name, times in seconds.items():
        cells = row(np.array(seconds[ours]), np.array(times), goals.get(name, Goal())) if name != ours else ["", "", ""]
        print(f"| {name} | {1e3 * np.median(times):.3g} | {' | '.join(cells)} |")
    print(f"\n{len(seconds[ours])} rounds; {surroundings()}", flush=True)


def row(ours: np.ndarray, theirs: np.ndarray, goal: Goal) -> list[str]:
    """The ratio, the goal and whether it holds: our time by a ruler's, a peer's time by ours."""
    ratios = ours / theirs if goal.at_most else theirs / ours
    low, middle, high = np.percentile(ratios, [25, 50, 75])
    ratio = f"{middle:.3g} ({low:.3g} to {high:.3g})"
    if goal.at_most:
        return [ratio, f"<= {goal.at_most:g}", "holds" if middle <= goal.at_most else "MISSED"]
    if goal.at_least:
        return [ratio, f">= {goal.at_least:g}", "holds" if middle >= goal.at_least else "MISSED"]
    return [ratio, "", ""]


def surroundings() -> str:
    """What the numbers depend on: versions, processor, load."""
    names = ("numpy", "numba", "scipy", "ompl", "pathplanning", "roboticstoolbox-python", "rsplan")
    versions = [f"{name} {found}" for name in names if (found := installed(name))]
    load = f", load {os.getloadavg()[0]:.1f}" if hasattr(os, "getloadavg") else ""
    return f"Python {platform.python_version()}, {', '.join(versions)}, {platform.machine()}, {os.cpu_count()} cores{load}"


def installed(name: str) -> str | None:
    """A package's version, or None."""
    try:
        return version(name)
    except PackageNotFoundError:
        return None
