"""Shared by the exercises on trees in graphs: the breadth-first tree, and the paths that parents
hold. Bullo & Smith, chapter 2.
"""

from typing import Any

from ...exercise import ValueExercise
from ...shapes import Listed
from ...whole_shapes import Whole

NODES = Listed(Whole())


class OnGraph(ValueExercise):
    """An exercise of lesson 4, whose answers are lists of nodes, or None."""

    lesson = "04_graph_search"

    def same(self, value: Any, truth: Any) -> bool:
        """The same nodes in the same order."""
        return (None if value is None else list(value)) == (None if truth is None else list(truth))
