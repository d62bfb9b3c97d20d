"""Robots: the meaning of their configurations, and the set of points that they occupy."""

from .arm import ArmChain, TwoLinkArm, why_unreachable
from .car import Car
from .moving import place_body
from .polygon import RigidPolygon, TranslatingPolygon
from .round import Disk, Point
from .trajectory import Trajectory

__all__ = [
    "ArmChain",
    "Car",
    "Disk",
    "Point",
    "RigidPolygon",
    "Trajectory",
    "TranslatingPolygon",
    "TwoLinkArm",
    "place_body",
    "why_unreachable",
]
