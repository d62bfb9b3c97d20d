"""Figures, drawn with matplotlib; each function takes axes and returns its artists.

Beside them only boards draw with it, the pictures that stand for a board where it cannot run; the
pictures of wrong answers in `course/lessons` are made of these functions.
"""

from .ackermann import draw_ackermann
from .arms import draw_configuration_space, plot_configuration_space, plot_environment
from .bug_flowcharts import draw_bug_base_flowchart
from .c_space import draw_c_obstacle, draw_grown, draw_turning_obstacle
from .comparisons import draw_convergence, draw_ecdf, draw_medians
from .decomposition import draw_decomposition, draw_sweep
from .drawing import (
    draw_path,
    draw_plan,
    draw_problem,
    draw_roadmap,
    draw_robot,
    draw_tree,
    draw_world,
)
from .drives import draw_drives, draw_moves, draw_routes, draw_runs
from .driving_steps import draw_driving_steps
from .graphs import draw_graph
from .headings import draw_cells_with_headings, draw_headings
from .looks import draw_looks
from .moving import draw_against_time, draw_moment, draw_movers
from .panels import draw_plans, panels
from .rrt_steps import draw_rrt_flowchart, draw_rrt_steps
from .samples import draw_dispersion, draw_samples, draw_shares
from .saving import save_panels, save_plan
from .searches import draw_search
from .solid import draw_mesh, torus_mesh
from .style import apply_style
from .success import draw_dots, draw_spread, draw_success
from .trees import draw_insertion, draw_regions
from .uncertain import draw_uncertain
from .walks import draw_distance_to_goal, draw_walk

apply_style()

__all__ = [
    "draw_ackermann",
    "draw_against_time",
    "draw_bug_base_flowchart",
    "draw_c_obstacle",
    "draw_cells_with_headings",
    "draw_configuration_space",
    "draw_convergence",
    "draw_decomposition",
    "draw_dispersion",
    "draw_distance_to_goal",
    "draw_dots",
    "draw_drives",
    "draw_driving_steps",
    "draw_ecdf",
    "draw_graph",
    "draw_grown",
    "draw_headings",
    "draw_insertion",
    "draw_looks",
    "draw_medians",
    "draw_mesh",
    "draw_moment",
    "draw_movers",
    "draw_moves",
    "draw_path",
    "draw_plan",
    "draw_plans",
    "draw_problem",
    "draw_regions",
    "draw_roadmap",
    "draw_robot",
    "draw_routes",
    "draw_rrt_flowchart",
    "draw_rrt_steps",
    "draw_runs",
    "draw_samples",
    "draw_search",
    "draw_shares",
    "draw_spread",
    "draw_success",
    "draw_sweep",
    "draw_tree",
    "draw_turning_obstacle",
    "draw_uncertain",
    "draw_walk",
    "draw_world",
    "panels",
    "plot_configuration_space",
    "plot_environment",
    "save_panels",
    "save_plan",
    "torus_mesh",
]
