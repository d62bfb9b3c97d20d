"""10,000 random drives of cars among polygons, discs and walls a hair thin: judged whole, and at
each of 150 steps.

`certify.py` tells which of them are free. A drive judged whole must never be called free where it
is not.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from certify import arc, is_free_motion, scenery_of
from compiling import njit
from random_problems import robot_at_random, world_at_random
from timing import Contestant, measure, report, run

from kinoedu.collision import is_free, is_free_drive
from kinoedu.curves.arcs import drive_arc
from kinoedu.robots.car import CarRobot

SECONDS = 100
DRIVES, EACH, STEPS = 10_000, 100, 150


class Case(NamedTuple):
    """A car in a world, and drives: where each begins, (n, 3), how far it goes, signed, and how it
    is steered, (n,).
    """

    car: CarRobot
    world: Any
    poses: np.ndarray
    lengths: np.ndarray
    steering: np.ndarray


def case_of(seed: int) -> Case:
    """Drives up to five turning radii long, each from a pose that is free."""
    rng = np.random.default_rng([seed, 13])
    car, world, poses = (
        robot_at_random("car", rng),
        world_at_random(("polygons", "discs too")[seed % 2], rng),
        [],
    )
    while len(poses) < EACH:
        pose = rng.uniform((0, 0, -np.pi), (10, 10, np.pi))
        if is_free(car, world, pose, 0.0):
            poses.append(pose)
    lengths = rng.uniform(-5.0, 5.0, EACH) * car.radius
    return Case(
        car, world, np.array(poses), lengths, rng.uniform(-1.0, 1.0, EACH) * car.max_steering
    )


@njit
def judged_whole(car, world, poses, lengths, curvatures):  # type: ignore[no-untyped-def]
    """One question a drive."""
    free = np.empty(len(poses), np.bool_)
    for i in range(len(poses)):
        free[i] = is_free_drive(car, world, poses[i], lengths[i], curvatures[i], 0.0)
    return free


@njit
def judged_in_steps(car, world, poses, lengths, curvatures):  # type: ignore[no-untyped-def]
    """The pose after each step, up to the first that is not free."""
    free = np.ones(len(poses), np.bool_)
    for i in range(len(poses)):
        for k in range(STEPS + 1):
            x, y, theta = drive_arc(
                poses[i, 0], poses[i, 1], poses[i, 2], lengths[i] * k / STEPS, curvatures[i]
            )
            if not is_free(car, world, np.array([x, y, theta]), 0.0):
                free[i] = False
                break
    return free


def contestant(judged: Callable[..., np.ndarray]) -> Contestant:
    """All of a case's drives."""

    def prepared(case: Case) -> Callable[[], np.ndarray]:
        curvatures = np.tan(case.steering) / case.car.wheelbase
        return lambda: judged(case.car, case.world, case.poses, case.lengths, curvatures)

    return prepared


class Verdicts:
    """How often each way of judging calls a drive free that is not, and the other way round."""

    def __init__(self) -> None:
        self.free, self.wrong = 0, {}

    def __call__(self, case: Case, answers: dict[str, np.ndarray]) -> None:
        """By the judge that knows nothing of kinoedu's tests; each case once."""
        key = case.poses.tobytes()
        if key in self.wrong:
            return
        scenery = scenery_of(case.world)
        drives = zip(case.poses, case.lengths, case.steering)
        truth = np.array(
            [is_free_motion(case.car, scenery, arc(case.car, *drive)) for drive in drives]
        )
        self.free += truth.sum()
        self.wrong[key] = {
            name: np.array([(free & ~truth).sum(), (~free & truth).sum()])
            for name, free in answers.items()
        }

    def print(self) -> None:
        """A row for each."""
        print(f"\n{EACH * len(self.wrong):,} drives, {self.free:,} of them free\n")
        print("| judged | called free and not so | called not free and yet so |\n|---|---:|---:|")
        for name in next(iter(self.wrong.values())):
            missed, alarms = sum(wrong[name] for wrong in self.wrong.values())
            print(f"| {name} | {missed:,} | {alarms:,} |")


def main(drives: int = DRIVES) -> None:
    """Both ways, drive by drive."""
    cases, verdicts = range(drives // EACH), Verdicts()
    ways = {"whole": contestant(judged_whole), f"in {STEPS} steps": contestant(judged_in_steps)}
    report(
        f"{EACH} drives of a car",
        measure(ways, map(case_of, cases), verdicts, repeats=1),
        {},
        ours="whole",
    )
    verdicts.print()
    raise SystemExit(any(wrong["whole"][0] for wrong in verdicts.wrong.values()))


if __name__ == "__main__":
    run(main)
