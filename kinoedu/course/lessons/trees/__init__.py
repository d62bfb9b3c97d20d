"""Lesson 9: Trees, or one query answered at once. Its exercises, in the order of the notebook."""

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
