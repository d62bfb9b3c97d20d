"""The free space of a polygonal world cut into convex cells, and the roadmap that they make."""

from .roadmap import decomposition_roadmap
from .trapezoidation import Step, Trapezoidation, sweep, trapezoidation
from .triangulation import Triangulation, triangulation

__all__ = [
    "Step",
    "Trapezoidation",
    "Triangulation",
    "decomposition_roadmap",
    "sweep",
    "trapezoidation",
    "triangulation",
]
