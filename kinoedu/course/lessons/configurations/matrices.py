"""Shared parts of the exercises on rotation and displacement. Bullo & Smith, chapters 3 and 6."""

from ...exercise import Axes, Case, ValueExercise
from ...outcomes import Answer, Outcome
from .pictures import draw_moved


class MatrixExercise(ValueExercise):
    """An exercise whose answer is a matrix that turns, and perhaps moves."""

    lesson = "05_configuration_spaces"

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw a flag, its right image, and its image under the student's matrix."""
        draw_moved(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)
