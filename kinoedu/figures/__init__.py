"""Figures: the only place that draws with matplotlib."""

from .drawing import draw_path, draw_plan, draw_problem, draw_roadmap, draw_robot, draw_tree, draw_world
from .saving import save_plan

__all__ = ["draw_path", "draw_plan", "draw_problem", "draw_roadmap", "draw_robot", "draw_tree", "draw_world", "save_plan"]
