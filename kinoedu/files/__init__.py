"""Files: scenes, plans, maps, pictures and meshes, read with care and written whole."""

from .benchmr import read_benchmr
from .images import read_heights
from .meshes import mesh_outline, mesh_world, read_mesh
from .ompl_app import write_ompl_app
from .path_formats import ros_path_text
from .path_poses import poses_along
from .plans import read_plan, write_plan
from .scenario_files import read_scenario_problems, write_scenario
from .scenes import read_problem, read_scene, write_scene
from .tpcap import read_tpcap
from .world_files import write_world
from .worlds import read_world

__all__ = [
    "mesh_outline",
    "mesh_world",
    "poses_along",
    "read_benchmr",
    "read_heights",
    "read_mesh",
    "read_plan",
    "read_problem",
    "read_scenario_problems",
    "read_scene",
    "read_tpcap",
    "read_world",
    "ros_path_text",
    "write_ompl_app",
    "write_plan",
    "write_scenario",
    "write_scene",
    "write_world",
]
