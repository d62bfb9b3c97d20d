"""Time contestants side by side: the same cases, turn by turn, the median of many rounds, and how
far the rounds spread.

A *contestant* takes a case and returns what is timed, a function without arguments; what it does
before is not timed. A *maker* returns a contestant, or raises Missing or ImportError where this
computer lacks what it needs: then it is named and left out.
"""

import argparse
import gc
import inspect
import os
import sys
import time
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from kinoedu.bench import append_ratios, as_table, surroundings
from kinoedu.bench.ratios import HELD, MISSED, NO_GOAL, Ratio
from kinoedu.bench.running import NOTHING_RUN, RESULTS, SKIPPED
from kinoedu.compiled import COMPILED_FIRST, running

Contestant = Callable[[Any], Callable[[], Any]]
Judge = Callable[[Any, dict[str, Any]], None]
Seconds = dict[str, list[float]]
Comparison = tuple[float, float, float, str, str]  # ratio, low, high, the goal, whether it holds
OURS = None, None, None, "", NO_GOAL  # kinoedu is beside nobody


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
            print(f"{SKIPPED}{name} ({error})")
    return found


def measure(
    contestants: dict[str, Contestant], cases: Iterable[Any], judge: Judge, *, repeats: int
) -> Seconds:
    """Let everyone solve every case `repeats` times, after one round that only warms up; each
    round's answers are judged.
    """
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


def turn(
    contestant: Contestant,
    case: Any,
    *,
    runs: int = 5,
    enough: float = 0.1,
    clock: Callable[[], float] = time.perf_counter,
) -> tuple[float, Any]:
    """The best of a few runs in a row, so that nobody pays for the caches that the one before
    emptied; and the last answer.
    """
    best, spent = np.inf, 0.0
    gc.collect()
    gc.disable()
    for _ in range(runs):
        work = contestant(case)
        began = clock()
        answer = work()
        took = clock() - began
        best, spent = min(best, took), spent + took
        if spent > enough:
            break
    gc.enable()
    return best, answer


def report(
    title: str,
    seconds: Seconds,
    goals: dict[str, Goal],
    *,
    ours: str = "kinoedu",
    compare: Callable[[np.ndarray, np.ndarray, Goal], Comparison] | None = None,
) -> None:
    """Print a table, and add it to ratios.csv where `kinoedu bench` has named a folder for it.

    compare : how two lists of times give a ratio; by default `compare_rounds`.
    """
    row, mine = Path(sys.argv[0]).stem, np.array(seconds[ours])
    ratios = [
        Ratio(row, title, name, 1e3 * float(np.median(times)), *ratio, len(mine))
        for name, times in seconds.items()
        for ratio in [
            OURS
            if name == ours
            else (compare or compare_rounds)(mine, np.array(times), goals.get(name, Goal()))
        ]
    ]
    print(
        f"\n### {title}\n\n{as_table(ratios)}\n\n{len(mine)} rounds; {surroundings()}", flush=True
    )
    if RESULTS in os.environ:
        append_ratios(Path(os.environ[RESULTS], "ratios.csv"), ratios)


def compare_rounds(ours: np.ndarray, theirs: np.ndarray, goal: Goal) -> Comparison:
    """The median ratio of all rounds, and their middle half."""
    ratios = ours / theirs if goal.at_most else theirs / ours
    low, middle, high = map(float, np.percentile(ratios, [25, 50, 75]))
    return middle, low, high, *held(middle, goal)


def compare_medians(ours: np.ndarray, theirs: np.ndarray, goal: Goal) -> Comparison:
    """The ratio of the median times, with the 95 % interval of 2,000 samples with replacement.

    For planners whose times differ by chance more than from case to case.
    """
    rng = np.random.default_rng(0)

    def medians(times: np.ndarray) -> np.ndarray:
        return np.median(times[rng.integers(len(times), size=(2000, len(times)))], axis=1)

    above, below = (ours, theirs) if goal.at_most else (theirs, ours)
    middle = float(np.median(above) / np.median(below))
    low, high = map(float, np.percentile(medians(above) / medians(below), [2.5, 97.5]))
    return middle, low, high, *held(middle, goal)


def held(ratio: float, goal: Goal) -> tuple[str, str]:
    """The goal in words, and whether it holds: our time by a ruler's, a peer's time by ours."""
    if goal.at_most:
        return f"<= {goal.at_most:g}", HELD if ratio <= goal.at_most else MISSED
    if goal.at_least:
        return f">= {goal.at_least:g}", HELD if ratio >= goal.at_least else MISSED
    return "", NO_GOAL


def run(main: Callable[..., None]) -> None:
    """Do a script's work as the command line says: each parameter of main is an option, with its
    default. Machine code is made first, so that it is what is timed. The status is 3 where this
    computer lacks what all of it needs.
    """
    options = argparse.ArgumentParser(description=inspect.getdoc(inspect.getmodule(main)))
    for name, parameter in inspect.signature(main).parameters.items():
        kind = type(parameter.default)
        options.add_argument(
            f"--{name}",
            type=kind,
            default=parameter.default,
            metavar="N" if kind is int else name.upper(),
            help="default: %(default)s",
        )
    try:
        with running(COMPILED_FIRST):
            main(**vars(options.parse_args()))
    except (Missing, ModuleNotFoundError) as error:
        print(f"{SKIPPED}{error}")
        sys.exit(NOTHING_RUN)
