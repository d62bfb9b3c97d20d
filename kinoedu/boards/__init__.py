"""Boards: problems to play with in a notebook. `board` for planners; `Canvas`, `Drawing` and its layers for a lesson's own."""

from .board import Board, board
from .canvas import Canvas
from .drawing import Drawing, Layer
from .geometry import distance_board

__all__ = ["Board", "Canvas", "Drawing", "Layer", "board", "distance_board"]
