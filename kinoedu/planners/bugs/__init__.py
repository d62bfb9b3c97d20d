"""What the Bug family stands on: the walls, the contact sensor that alone may feel them, and the
walk that comes of it.
"""

from .place import Place
from .robot import BugRobot
from .walk import BugProblem

__all__ = ["BugProblem", "BugRobot", "Place"]
