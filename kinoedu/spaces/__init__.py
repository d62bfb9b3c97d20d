"""Configuration spaces: distance, interpolation, sampling, nearest neighbours."""

from .asks import distance, interpolate, nearest, sample
from .real import RealSpace
from .wrapping import WrappingSpace

__all__ = ["RealSpace", "WrappingSpace", "distance", "interpolate", "nearest", "sample"]
