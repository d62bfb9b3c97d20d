"""Boards: problems to play with in a notebook.

`board` is for planners; a lesson makes its own board of `Canvas`, `Drawing` and layers.
"""

from .arm.arm import ArmBoard, arm_board
from .arm.reach import reach_board, torus_board
from .bugs.bugs import BugBoard, bug_board
from .car.car import CarBoard, car_board
from .car.curves import curves_board
from .code.code_board import code_board
from .core.canvas import Canvas
from .core.challenge import Challenge, challenge
from .core.drawing import Drawing, Layer
from .exploring.exploring import ExploringBoard, exploring_board
from .geometry.geometry import distance_board
from .geometry.samples import SamplesBoard, samples_board
from .geometry.slide import SlideBoard, slide_board
from .geometry.solid import SolidBoard, solid_board, turning_board
from .geometry.sweep import SweepBoard, sweep_board
from .moving.chances import ChanceBoard, chance_board
from .moving.moving import MovingBoard, moving_board
from .planning.board import Board, board
from .planning.race import RaceBoard, race_board
from .roadmaps.properties import PropertiesBoard, properties_board
from .roadmaps.roadmaps import RoadmapBoard, roadmap_board
from .search.search import SearchBoard, search_board
from .trees.rewiring import RewiringBoard, rewiring_board

__all__ = [
    "ArmBoard",
    "Board",
    "BugBoard",
    "Canvas",
    "CarBoard",
    "Challenge",
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
    "challenge",
    "chance_board",
    "code_board",
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
