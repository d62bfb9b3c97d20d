"""Robots: what a configuration means, and the body it places."""

from .round import Disk, Point

__all__ = ["Disk", "Point"]
