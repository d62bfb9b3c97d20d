"""A problem as a student's planner has it: its questions, and nothing behind them."""

from collections.abc import Callable
from functools import partial
from inspect import Parameter, Signature
from typing import Any

import numpy as np

from ..geometry.checks import Array
from ..spaces.interface import distance
from ..spaces.real import RealSpace
from ..spaces.wrapping import WrappingSpace
from .poses import distance_of_poses

Metric = RealSpace | WrappingSpace | float  # a space, or the length of a radian for a car's poses
# the parameters of each question, as the exercises name them
PARAMETERS = {
    "sample": ("rng",),
    "steer": ("a", "b", "step"),
    "is_free": ("q",),
    "is_free_path": ("a", "b"),
    "is_semi_free_path": ("a", "b"),
    "control": ("rng",),
    "move": ("q", "v", "phi", "t"),
    "is_free_drive": ("q", "v", "phi", "t"),
    "near_goal": ("rng",),
    "best_drive": ("q", "target", "rng"),
}


def distance_in(metric: Metric) -> Callable[[Any, Any], Any]:
    """The distance of a metric."""
    if isinstance(metric, float):
        return lambda a, b: distance_of_poses(a, b, metric)
    return lambda a, b: distance(metric, a, b)


def as_configuration(value: Any) -> Any:
    """A list or tuple as an array; everything else as it is."""
    return np.array(value, float) if isinstance(value, list | tuple) else value


def put_in_order(question: str, given: tuple[Any, ...], named: dict[str, Any]) -> tuple[Any, ...]:
    """The arguments of a question in the order of its parameters.

    Raises
    ------
    TypeError
        Where they are not those that it takes.
    """
    names = PARAMETERS[question]
    parameters = [Parameter(name, Parameter.POSITIONAL_OR_KEYWORD) for name in names]
    try:
        return Signature(parameters).bind(*given, **named).args
    except TypeError:
        raise TypeError(f"problem.{question} takes ({', '.join(names)})") from None


class LentProblem:
    """The start, the goal and the questions of a problem.

    The problem itself may be in another process. `distance` is computed here, since planners ask it
    more often than all else.

    Attributes
    ----------
    start, goal : (d,) configurations.
    distance : the distance between two configurations.
    """

    def __init__(
        self,
        ask: Callable[..., Any],
        questions: tuple[str, ...],
        numbers: dict[str, float],
        ends: tuple[Array, Array],
        metric: Metric,
    ) -> None:
        self._ask, self._questions, self._numbers, self._ends = ask, questions, numbers, ends
        self._metric, self.distance = metric, distance_in(metric)

    @property
    def start(self) -> Array:
        """A new array at each use, so that no program changes the problem."""
        return np.array(self._ends[0])

    @property
    def goal(self) -> Array:
        """A new array at each use, as for the start."""
        return np.array(self._ends[1])

    def _put(self, question: str, /, *given: Any, **named: Any) -> Any:
        """Put a question to the problem; its arguments may be named."""
        if question in PARAMETERS and (named or len(given) != len(PARAMETERS[question])):
            given, named = put_in_order(question, given, named), {}
        return self._ask(question, *map(as_configuration, given), **named)

    def __getattr__(self, name: str) -> Any:
        """A question, or one of the problem's numbers."""
        if name.startswith("_"):
            raise AttributeError(name)
        if name in self._questions:
            return partial(self._put, name)
        if name in self._numbers:
            return self._numbers[name]
        names = ("start", "goal", "distance", *self._questions, *self._numbers)
        raise AttributeError(f"a problem has no {name}; it has {', '.join(names)}")

    def __repr__(self) -> str:
        return str(self._ask("__repr__"))
