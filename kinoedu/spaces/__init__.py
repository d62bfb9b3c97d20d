"""Configuration spaces: distance, interpolation, sampling and nearest neighbours."""

from .angles import circle_distance, torus_distance
from .interface import diameter, distance, interpolate, nearest, sample
from .near import near
from .real import Box, RealSpace
from .wrapping import SE2, Circle, Torus, WrappingSpace, wrapped_configuration

__all__ = [
    "SE2",
    "Box",
    "Circle",
    "RealSpace",
    "Torus",
    "WrappingSpace",
    "circle_distance",
    "diameter",
    "distance",
    "interpolate",
    "near",
    "nearest",
    "sample",
    "torus_distance",
    "wrapped_configuration",
]
