"""Boards: problems to play with in a notebook. `board` for planners; `Canvas`, `Drawing` and its layers for a lesson's own."""

from .arm import ArmBoard, arm_board
from .board import Board, board
from .bugs import BugBoard, bug_board
from .canvas import Canvas
from .car import CarBoard, car_board
from .chances import ChanceBoard, chance_board
from .curves import curves_board
from .drawing import Drawing, Layer
from .exploring import ExploringBoard, exploring_board
from .geometry import distance_board
from .moving import MovingBoard, moving_board
from .properties import PropertiesBoard, properties_board
from .race import RaceBoard, race_board
from .reach import reach_board, torus_board
from .rewiring import RewiringBoard, rewiring_board
from .roadmaps import RoadmapBoard, roadmap_board
from .samples import SamplesBoard, samples_board
from .search import SearchBoard, search_board
from .slide import SlideBoard, slide_board
from .solid import SolidBoard, solid_board, turning_board
from .sweep import SweepBoard, sweep_board

__all__ = [
    "ArmBoard",
    "Board",
    "BugBoard",
    "Canvas",
    "CarBoard",
    "ChanceBoard",
    "Drawing",
    "ExploringBoard",
    "Layer",
    "MovingBoard",
    "PropertiesBoard",
    "RaceBoard",
    "RewiringBoard",
    "RoadmapBoard",
    "SamplesBoard",
    "SearchBoard",
    "SlideBoard",
    "SolidBoard",
    "SweepBoard",
    "arm_board",
    "board",
    "bug_board",
    "car_board",
    "chance_board",
    "curves_board",
    "distance_board",
    "exploring_board",
    "moving_board",
    "properties_board",
    "race_board",
    "reach_board",
    "rewiring_board",
    "roadmap_board",
    "samples_board",
    "search_board",
    "slide_board",
    "solid_board",
    "sweep_board",
    "torus_board",
    "turning_board",
]
