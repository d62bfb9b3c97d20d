"""The shortest curves of a car with a minimal turning radius.

Dubins' cars drive forward only, Reeds and Shepp's cars forward and backward.
"""

from .curve import Curve
from .dubins import dubins_path
from .reeds_shepp import reeds_shepp_path

__all__ = ["Curve", "dubins_path", "reeds_shepp_path"]
