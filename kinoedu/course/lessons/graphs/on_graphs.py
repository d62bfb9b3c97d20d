"""The base class of the exercises on graphs. Bullo & Smith, chapter 2."""

from ...exercise import ValueExercise
from ...shapes import Listed, Value
from ...whole_shapes import Integer

NODES = Listed(Integer())


class GraphExercise(ValueExercise):
    """An exercise of lesson 4 whose answer is a list of nodes, or None."""

    lesson = "04_graph_search"

    def same(self, value: Value, truth: Value) -> bool:
        """Whether both hold the same nodes in the same order, or both are None."""
        return (None if value is None else list(value)) == (None if truth is None else list(truth))
