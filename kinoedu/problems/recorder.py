"""A recorder wraps a problem and logs every query of a planner."""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from .protocols import ProblemLike


class Question(NamedTuple):
    """One logged query: the name of the method, its arguments and its result."""

    name: str
    given: tuple[Any, ...]
    answer: object


class Recorder:
    """A problem that logs every query, in order, in `log`.

    A planner that is given a recorder runs interpreted and builds exactly the same tree.

    Examples
    --------
    >>> from kinoedu import Point, Problem, Terrain
    >>> world = Terrain([[1, 1], [1, 1]])
    >>> problem = Problem(Point(), world, start=(0.5, 0.5), goal=(1.5, 1.5))
    >>> recorder = Recorder(problem)
    >>> recorder.is_free_path(recorder.start, recorder.goal)
    True
    >>> recorder.log[0].name, recorder.counts()
    ('is_free_path', {'is_free_path': 1})
    """

    QUERIES: tuple[str, ...] = (
        *("sample", "distance", "motion_cost", "steer", "nearest"),
        *("is_free", "is_free_path", "is_semi_free_path"),
        *("control", "is_free_drive"),
    )

    def __init__(self, problem: ProblemLike) -> None:
        self.problem: Any = problem
        self.log: list[Question] = []

    def __getattr__(self, name: str) -> Any:
        if name == "problem":  # it does not exist yet while a copy is unpickled
            raise AttributeError(name)
        answer = getattr(self.problem, name)
        return self._recorded(name, answer) if name in self.QUERIES else answer

    def _recorded(self, name: str, question: Callable[..., object]) -> Callable[..., object]:
        def logged(*given: object) -> object:
            answer = question(*given)
            copies = tuple(g.copy() if isinstance(g, np.ndarray) else g for g in given)
            self.log.append(
                Question(name, copies, answer.copy() if isinstance(answer, np.ndarray) else answer)
            )
            return answer

        return logged

    def counts(self) -> dict[str, int]:
        """The number of queries of each kind."""
        return {
            name: n
            for name in self.QUERIES
            if (n := sum(question.name == name for question in self.log))
        }


def unwrap_recorder(problem: Any) -> Any:
    """The problem that a recorder records; any other problem is returned unchanged."""
    return problem.problem if isinstance(problem, Recorder) else problem


def record_as(problem: Any, changed: Any) -> Any:
    """A changed problem, with a recorder that writes the same log if the problem has one."""
    if not isinstance(problem, Recorder):
        return changed
    recorder = Recorder(changed)
    recorder.log = problem.log
    return recorder
