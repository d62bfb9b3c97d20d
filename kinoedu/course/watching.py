"""Call a student's planner three times, and read what it drew each time.

It knows no right answer.
"""

import math
import random
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from ..geometry.checks import Array
from .tasks import StudentProblem

# from the seed of two calls to that of the third: seeds so far apart differ, even where a program
# keeps only some last digits
FAR = 1000
# what a row of a log records
SAMPLE, NEAR_GOAL, DRIVE, STEER = 0, 1, 2, 3
DRIVING = {"sample": SAMPLE, "near_goal": NEAR_GOAL, "best_drive": DRIVE}


class Run(NamedTuple):
    """What one call of a planner drew.

    Attributes
    ----------
    samples : (m, d), what `problem.sample` returned, in order.
    generators : number of different generators that it was given.
    others : number of samples before which its generator was also used for something else.
    """

    samples: Array
    generators: int
    others: int


def call_three_times(
    function: Callable[..., object],
    given: dict[str, Any],
    read: Callable[[Any, int], object],
) -> tuple[Any, ...]:
    """Call a planner with the seeds rng, rng and rng + 1000, each time with a new problem.

    Returns
    -------
    The three answers; whether Python's and numpy's global generators were left unused; and what
    `read` finds in the problem, for the seed, after the first and after the third call.
    """
    before, answers, found = global_states(), [], []
    for rng in (given["rng"], given["rng"], given["rng"] + FAR):
        problem = given["problem"].fresh_copy()
        answers.append(function(*{**given, "problem": problem, "rng": rng}.values()))
        found.append(read(problem, rng))
    is_unused = global_states() == before
    random.setstate(before[0])
    np.random.set_state(before[1])
    return *answers, is_unused, found[0], found[2]


def global_states() -> tuple[Any, Any]:
    """The states of Python's and of numpy's global generators, which can be compared."""
    numpys: Any = np.random.get_state()
    name, key, *rest = numpys
    return random.getstate(), (name, tuple(key.tolist()), *rest)


def read_nothing(problem: object, rng: int) -> None:
    """Read nothing: of a planner that is judged by its answers alone."""


def read_samples(problem: StudentProblem, rng: int) -> Run:
    """What was sampled from a problem in one call with a seed."""
    state: object = np.random.default_rng(rng).bit_generator.state
    others = 0
    for draw in problem.draws:
        others += draw.before != state
        state = draw.after
    samples = [draw.sample for draw in problem.draws]
    return Run(np.array(samples), len({id(draw.generator) for draw in problem.draws}), others)


def read_attempts(problem: StudentProblem, rng: int) -> Array:
    """The samples and steers that a problem has logged, shape (calls, 6).

    A row holds the kind, the generator's number, and two places: the sample twice, or from where to
    where.
    """
    generators, rows = list[object](), []
    for name, given, answer in problem.log:
        if name == "sample":
            q = np.asarray(answer)[:2]
            rows.append([SAMPLE, number_of(given[0], generators), *q, *q])
        elif name == "steer":
            rows.append([STEER, 0, *np.asarray(given[0])[:2], *np.asarray(given[1])[:2]])
    return np.array(rows, float).reshape(-1, 6)


def read_drives(problem: Any, rng: int) -> Array:
    """The random poses and best drives that a problem has logged, shape (calls, 11).

    A row holds the kind, the generator's number, q, the target, and the drive; nan stands for no
    drive. For a random pose, q and the target are the pose.
    """
    generators, rows = list[object](), []
    for name, given, answer in problem.log:
        if name in DRIVING:
            q, target = given[:2] if name == "best_drive" else (answer, answer)
            found = name == "best_drive" and answer is not None
            drive = np.asarray(answer if found else (math.nan,) * 3, float)
            number = number_of(given[-1], generators)
            rows.append([DRIVING[name], number, *q[:3], *target[:3], *drive])
    return np.array(rows).reshape(-1, 11)


def number_of(generator: object, generators: list[object]) -> int:
    """The number of a generator, in the order in which they were first used."""
    if not any(generator is one for one in generators):
        generators.append(generator)
    return next(i for i, one in enumerate(generators) if one is generator)
