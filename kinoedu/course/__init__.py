"""The course: exercises, checks of students' answers, and the feedback that students read."""

from .checking import check
from .exercise import Case, Change, Exercise, Slip, ValueExercise, Verdict
from .lessons import EXERCISES, find
from .questions import ask
from .showing import show

__all__ = [
    "EXERCISES",
    "Case",
    "Change",
    "Exercise",
    "Slip",
    "ValueExercise",
    "Verdict",
    "ask",
    "check",
    "find",
    "show",
]
