"""Lesson 2: Bug algorithms, or finding the way by touch.

Its exercises, in the order of the notebook.
"""

from .bug1 import Bug1
from .bug2 import Bug2
from .bug_base import BugBase
from .exposing_problem import ExposeMendedBug

EXERCISES = [
    BugBase,
    Bug1,
    Bug2,
    ExposeMendedBug,
]
