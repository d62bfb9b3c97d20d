"""Problems: what a planner is asked, what it answers, and a recorder of its questions."""

from .in_time import TimedProblem
from .plan import Plan, Roadmap, Tree, Walk
from .problem import MOTIONS, PLACES, Problem, ProblemRecord
from .recorder import Question, Recorder

__all__ = [
    "MOTIONS",
    "PLACES",
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
