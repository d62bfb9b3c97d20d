"""Boards: problems to play with in a notebook. `board` for planners; `Canvas`, `Drawing` and its layers for a lesson's own."""

from .arm import ArmBoard, arm_board
from .board import Board, board
from .bugs import BugBoard, bug_board
from .canvas import Canvas
from .drawing import Drawing, Layer
from .geometry import distance_board
from .reach import reach_board, torus_board
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
    "Drawing",
    "Layer",
    "SamplesBoard",
    "SearchBoard",
    "SlideBoard",
    "SolidBoard",
    "SweepBoard",
    "arm_board",
    "board",
    "bug_board",
    "distance_board",
    "reach_board",
    "samples_board",
    "search_board",
    "slide_board",
    "solid_board",
    "sweep_board",
    "torus_board",
    "turning_board",
]
