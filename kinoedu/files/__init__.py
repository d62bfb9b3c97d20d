"""Files: scenes, plans, maps, pictures and meshes, read with care and written whole."""

from .benchmr import read_benchmr
from .images import read_heights
from .meshes import mesh_outline, mesh_world, read_mesh
from .plans import read_plan, write_plan
from .scenes import read_problem, read_scene, write_scene
from .worlds import read_world

__all__ = [
    "mesh_outline",
    "mesh_world",
    "read_benchmr",
    "read_heights",
    "read_mesh",
    "read_plan",
    "read_problem",
    "read_scene",
    "read_world",
    "write_plan",
    "write_scene",
]
