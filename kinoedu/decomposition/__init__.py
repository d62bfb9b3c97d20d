"""Decomposition of a polygonal world's free space into convex cells, and their roadmap."""

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
