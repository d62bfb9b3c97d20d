"""Configuration spaces: distance, interpolation, sampling, nearest neighbours."""

from .asks import distance, interpolate, nearest, sample
from .real import RealSpace

__all__ = ["RealSpace", "distance", "interpolate", "nearest", "sample"]
