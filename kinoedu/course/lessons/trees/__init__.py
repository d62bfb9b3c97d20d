"""Lesson 9: Trees, or one question, one answer, now. Its exercises, as the notebook asks for
them.
"""

from .exposing_room import ExposeHastyGoal
from .follow import Follow
from .insert import Insert
from .rrt import Rrt
from .rrt_connect import RrtConnect
from .tree_roadmap import TreeRoadmap

EXERCISES = [
    TreeRoadmap,
    Rrt,
    RrtConnect,
    Insert,
    Follow,
    ExposeHastyGoal,
]
