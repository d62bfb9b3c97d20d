"""Planners: each takes a problem and returns a plan."""

from .rrt import rrt

__all__ = ["rrt"]
