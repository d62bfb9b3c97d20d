"""Parameters of planners of drives: how drives are tried, and what changes near the goal.

A reader gives `Drives`, `GoalBias`, `GoalRegion`, `Sparsity` and `Refinement`. A parameter that is
None depends on the car; `as_drives` and the like return the numbers for one car, for compiled code.
"""

import math
from dataclasses import dataclass
from typing import Any, NamedTuple, TypeVar

import numpy as np

from ...errors import InvalidParameter
from ...support.text import shortened
from ..tuning import integer, nonnegative, positive

Parameters = TypeVar("Parameters")
ROUNDING = 1e-9  # of a number of time steps


@dataclass(frozen=True)
class Drives:
    """How drives are tried: random controls are simulated, and the best one is kept.

    Parameters
    ----------
    trials : M, how many controls are tried, each a speed of the car and a steering angle.
    duration : delta t, for how long each control is simulated; by default as long as a drive of
        0.75 wheelbases takes at top speed.
    time_step : the time step of the simulation; by default a 150th of the duration. The best drive
        ends at the time step that is closest to the target; a part of a step is left out.
    batches : how many times M controls are drawn while the best drive is not free.

    Raises
    ------
    InvalidParameter
        Where a parameter is out of its range.

    Examples
    --------
    >>> Drives(trials=8, duration=0.5)
    Drives(trials=8, duration=0.5, time_step=None, batches=4)
    """

    trials: int = 20
    duration: float | None = None
    time_step: float | None = None
    batches: int = 4

    def __post_init__(self) -> None:
        integer(self.trials, "trials", least=1)
        if self.duration is not None:
            positive(self.duration, "duration")
        if self.time_step is not None:
            positive(self.time_step, "time_step")
        integer(self.batches, "batches", least=1)


@dataclass(frozen=True)
class GoalBias:
    """How often targets are drawn near the goal.

    To park in a tight place, draw more from the region: `GoalBias(goal_every=10, region_every=2)`.

    Parameters
    ----------
    goal_every, region_every : every so many iterations the target is the goal, or is drawn from a
        region round it; 0 for never.
    region, region_turn : the radius of that region, by default 2.5 wheelbases, and how far its
        headings may be from the goal's, in radians.

    Raises
    ------
    InvalidParameter
        Where a parameter is out of its range.

    Examples
    --------
    >>> GoalBias(goal_every=10, region=50.0).goal_every
    10
    """

    goal_every: int = 4
    region_every: int = 7
    region: float | None = None
    region_turn: float = math.radians(90.0)

    def __post_init__(self) -> None:
        integer(self.goal_every, "goal_every", least=0)
        integer(self.region_every, "region_every", least=0)
        if self.region is not None:
            nonnegative(self.region, "region")
        nonnegative(self.region_turn, "region_turn")


@dataclass(frozen=True)
class GoalRegion:
    """Which poses count as the goal.

    Parameters
    ----------
    tolerance : how far a position may be from the goal's; by default a quarter of the wheelbase.
    turn_tolerance : how far a heading may be from the goal's, in radians.

    Raises
    ------
    InvalidParameter
        Where a parameter is out of its range.

    Examples
    --------
    >>> GoalRegion(tolerance=2.0, turn_tolerance=0.1)
    GoalRegion(tolerance=2.0, turn_tolerance=0.1)
    """

    tolerance: float | None = None
    turn_tolerance: float = math.radians(15.0)

    def __post_init__(self) -> None:
        if self.tolerance is not None:
            nonnegative(self.tolerance, "tolerance")
        nonnegative(self.turn_tolerance, "turn_tolerance")


@dataclass(frozen=True)
class Sparsity:
    """How sparse a tree is: each witness keeps the cheapest node only.

    Parameters
    ----------
    radius : delta_s, within which a witness keeps one node; by default 0.4 wheelbases. The smaller
        it is, the shorter the drives become in the end.
    reach : delta_BN, the radius round a target within which the cheapest node is chosen; by default
        twice the radius.

    Raises
    ------
    InvalidParameter
        Where a parameter is out of its range.

    Examples
    --------
    >>> Sparsity(radius=0.5)
    Sparsity(radius=0.5, reach=None)
    """

    radius: float | None = None
    reach: float | None = None

    def __post_init__(self) -> None:
        if self.radius is not None:
            positive(self.radius, "radius")
        if self.reach is not None:
            positive(self.reach, "reach")


@dataclass(frozen=True)
class Refinement:
    """How much finer a sparse tree is near the goal, so that a car can shift to and fro there.

    Within a region round the goal, radii and drives shrink in proportion to the distance from it,
    but not below a share.

    Parameters
    ----------
    region : the radius of the region, in the distance of SE(2); by default 4 wheelbases.
    radius : the least share of the radius and the reach, in (0, 1].
    duration : the least share of the duration, in (0, 1].

    Raises
    ------
    InvalidParameter
        Where a parameter is out of its range.

    Examples
    --------
    >>> Refinement(radius=0.1)
    Refinement(region=None, radius=0.1, duration=0.25)
    """

    region: float | None = None
    radius: float = 0.05
    duration: float = 0.25

    def __post_init__(self) -> None:
        if self.region is not None:
            positive(self.region, "region")
        for name in ("radius", "duration"):
            share = positive(getattr(self, name), name)
            if share > 1.0:
                raise InvalidParameter(f"{name} must be a share in (0, 1], got {share:g}")


class DrivesRecord(NamedTuple):
    """`Drives` of one car: each drive is simulated for up to `steps` time steps."""

    trials: int
    steps: int
    time_step: float
    batches: int


class GoalBiasRecord(NamedTuple):
    """`GoalBias` of one car.

    Targets in the region are drawn with a density that grows towards the goal.
    """

    goal_every: int
    region_every: int
    region: float
    region_turn: float


class GoalRegionRecord(NamedTuple):
    """`GoalRegion` of one car."""

    tolerance: float
    turn_tolerance: float


class RefinementRecord(NamedTuple):
    """`Refinement` of one car."""

    region: float
    radius: float
    duration: float


def as_drives(problem: Any, drives: Drives) -> DrivesRecord:
    """The numbers of `Drives` for the problem's car.

    Raises
    ------
    InvalidParameter
        Where it is not a `Drives`, or its time step is longer than its duration.
    """
    given = check_kind(drives, Drives, "drives")
    fastest = float(np.abs(problem.robot.speeds).max())
    duration = 0.75 * problem.robot.wheelbase / fastest
    if given.duration is not None:
        duration = float(given.duration)
    time_step = duration / 150.0 if given.time_step is None else float(given.time_step)
    if time_step > duration:
        raise InvalidParameter(
            f"the time_step {time_step:g} must not be longer than the duration {duration:g}"
        )
    whole = math.floor(duration / time_step * (1.0 + ROUNDING))
    steps = integer(whole, "duration / time_step", least=1)
    return DrivesRecord(int(given.trials), steps, time_step, int(given.batches))


def as_goal_bias(problem: Any, goal_bias: GoalBias) -> GoalBiasRecord:
    """The numbers of `GoalBias` for the problem's car.

    Raises
    ------
    InvalidParameter
        Where it is not a `GoalBias`.
    """
    given = check_kind(goal_bias, GoalBias, "goal_bias")
    radius = 2.5 * problem.robot.wheelbase if given.region is None else float(given.region)
    turns = int(given.goal_every), int(given.region_every)
    return GoalBiasRecord(*turns, radius, float(given.region_turn))


def as_goal_region(problem: Any, goal_region: GoalRegion) -> GoalRegionRecord:
    """The numbers of `GoalRegion` for the problem's car.

    Raises
    ------
    InvalidParameter
        Where it is not a `GoalRegion`.
    """
    given = check_kind(goal_region, GoalRegion, "goal_region")
    distance = 0.25 * problem.robot.wheelbase if given.tolerance is None else float(given.tolerance)
    return GoalRegionRecord(distance, float(given.turn_tolerance))


def as_sparsity(problem: Any, sparsity: Sparsity) -> tuple[float, float]:
    """The radius and the reach of `Sparsity` for the problem's car.

    Raises
    ------
    InvalidParameter
        Where it is not a `Sparsity`.
    """
    given = check_kind(sparsity, Sparsity, "sparsity")
    radius = 0.4 * problem.robot.wheelbase if given.radius is None else float(given.radius)
    return radius, 2.0 * radius if given.reach is None else float(given.reach)


def as_refinement(problem: Any, refinement: Refinement | None) -> RefinementRecord:
    """The numbers of `Refinement` for the problem's car; of None, shares of 1.

    Raises
    ------
    InvalidParameter
        Where it is not a `Refinement`.
    """
    if refinement is None:
        return RefinementRecord(1.0, 1.0, 1.0)
    given = check_kind(refinement, Refinement, "refinement")
    region = 4.0 * problem.robot.wheelbase if given.region is None else float(given.region)
    return RefinementRecord(region, float(given.radius), float(given.duration))


def check_kind(given: Any, kind: type[Parameters], name: str) -> Parameters:
    """The parameters themselves, if they are of a kind; or InvalidParameter."""
    if not isinstance(given, kind):
        raise InvalidParameter(f"{name} must be {kind.__name__}(...), got {shortened(given)}")
    return given
