"""The Bug family: the walls, the robot with its contact sensor, and the walk that results."""

from .place import Place
from .robot import BugRobot
from .walk import BugProblem

__all__ = ["BugProblem", "BugRobot", "Place"]
