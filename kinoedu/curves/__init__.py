"""Curves: the shortest ways of a car that turns no tighter than a radius, forward only (Dubins) or
both ways (Reeds and Shepp).
"""

from .curve import Curve
from .dubins import dubins_path
from .reeds_shepp import reeds_shepp_path

__all__ = ["Curve", "dubins_path", "reeds_shepp_path"]
