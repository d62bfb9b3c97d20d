"""The course: exercises, the judges of their answers, and what a student is told."""

from .checking import check
from .exercise import Case, Exercise, Slip, ValueExercise, Verdict
from .lessons import EXERCISES, find
from .showing import show

__all__ = [
    "EXERCISES",
    "Case",
    "Exercise",
    "Slip",
    "ValueExercise",
    "Verdict",
    "check",
    "find",
    "show",
]
