"""Shared parts of the exercises on distances between angles. Bullo & Smith, chapter 3."""

from math import pi

from ...exercise import Axes, Case, ValueExercise
from ...outcomes import Answer, Outcome
from .pictures import draw_shorter_arcs

TURN = 2.0 * pi


class BetweenAngles(ValueExercise):
    """An exercise with the arguments a and b: two angles, or two rows of angles."""

    lesson = "05_configuration_spaces"

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw a circle with the shorter arc for each angle, and both distances."""
        draw_shorter_arcs(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)
