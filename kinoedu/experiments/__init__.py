"""Experiments: planners x problems x seeds, run in parallel or on a cluster, as one table.

An experiment that was stopped resumes where it stopped.
"""

from .experiment import Experiment
from .files import read_experiment
from .running import run
from .seeds import best_of_restarts, describe_spread, over_seeds
from .summaries import as_text, summary
from .table import Row, Table
from .worlds import narrow_passage, scattered_polygons

__all__ = [
    "Experiment",
    "Row",
    "Table",
    "as_text",
    "best_of_restarts",
    "describe_spread",
    "narrow_passage",
    "over_seeds",
    "read_experiment",
    "run",
    "scattered_polygons",
    "summary",
]
