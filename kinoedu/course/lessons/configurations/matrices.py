"""Shared by the exercises on matrices that turn and move. Bullo & Smith, chapters 3 and 6."""

from typing import Any

from ...exercise import Case, ValueExercise
from ...outcomes import Answer, Outcome
from .pictures import draw_moved


class MatrixExercise(ValueExercise):
    """An exercise whose answer is a matrix that turns, and perhaps moves."""

    lesson = "05_configuration_spaces"

    def draw(self, case: Case, outcome: Outcome, ax: Any) -> None:
        """A flag, where it should go, and where the student's matrix takes it."""
        draw_moved(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)
