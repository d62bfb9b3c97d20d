"""The exercises of lesson 9, trees, in the order of the notebook."""

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
