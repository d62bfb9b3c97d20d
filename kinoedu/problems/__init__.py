"""Planning problems, plans, and a recorder of the queries that a planner makes."""

from .in_time import TimedProblem
from .plan import CellsWithHeadings, Plan, Roadmap, Tree, Walk
from .problem import MOTIONS, PLACES, Problem, ProblemRecord
from .recorder import Question, Recorder

__all__ = [
    "MOTIONS",
    "PLACES",
    "CellsWithHeadings",
    "Plan",
    "Problem",
    "ProblemRecord",
    "Question",
    "Recorder",
    "Roadmap",
    "TimedProblem",
    "Tree",
    "Walk",
]
