"""A recorder stands for a problem and writes down every question that a planner asks."""

from typing import Any, NamedTuple

import numpy as np


class Question(NamedTuple):
    """One question asked of a problem: its name, what was given, what was answered."""

    name: str
    given: tuple[Any, ...]
    answer: Any


class Recorder:
    """A problem that writes down every question it is asked, in order, in `log`.

    A planner given a recorder runs its interpreted body and grows the very same tree.

    >>> from kinoedu import Point, Problem, Terrain
    >>> recorder = Recorder(Problem(Point(), Terrain([[1, 1], [1, 1]]), start=(0.5, 0.5), goal=(1.5, 1.5)))
    >>> recorder.is_free_path(recorder.start, recorder.goal)
    True
    >>> recorder.log[0].name, recorder.counts()
    ('is_free_path', {'is_free_path': 1})
    """

    QUESTIONS: tuple[str, ...] = (
        *(
            "sample",
            "distance",
            "motion_cost",
            "steer",
            "nearest",
            "is_free",
            "is_free_path",
            "is_semi_free_path",
        ),
        *("control", "is_free_drive"),
    )

    def __init__(self, problem: Any) -> None:
        self.problem = problem
        self.log: list[Question] = []

    def __getattr__(self, name: str) -> Any:
        if name == "problem":  # while being unpickled or copied there is none yet
            raise AttributeError(name)
        answer = getattr(self.problem, name)
        return self._recorded(name, answer) if name in self.QUESTIONS else answer

    def _recorded(self, name: str, question: Any) -> Any:
        def ask(*given: Any) -> Any:
            answer = question(*given)
            kept = tuple(g.copy() if isinstance(g, np.ndarray) else g for g in given)
            self.log.append(
                Question(name, kept, answer.copy() if isinstance(answer, np.ndarray) else answer)
            )
            return answer

        return ask

    def counts(self) -> dict[str, int]:
        """How often each question was asked."""
        return {
            name: n
            for name in self.QUESTIONS
            if (n := sum(question.name == name for question in self.log))
        }
