"""Shared by the exercises on distances between angles: on the circle, and on the torus. Bullo &
Smith, chapter 3.
"""

from math import pi
from typing import Any

from ...exercise import Case, ValueExercise
from ...outcomes import Answer, Outcome
from .pictures import draw_short_ways

TURN = 2.0 * pi


class BetweenAngles(ValueExercise):
    """An exercise whose case is two angles, or two rows of angles, a and b."""

    lesson = "05_configuration_spaces"

    def draw(self, case: Case, outcome: Outcome, ax: Any) -> None:
        """A circle for each angle, the short way round it, and both distances."""
        draw_short_ways(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)
