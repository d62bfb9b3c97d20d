"""Worlds: where a robot moves, made from polygons or bitmaps or read from files."""

from .benchmr import read_benchmr
from .heights import clearance_of_cells, read_heights, roughness, slope
from .landscapes import LANDSCAPES, hills, landscape
from .meshes import mesh_outline, mesh_world, read_mesh
from .moving import Moving, MovingWorld, movers_at
from .polygon_world import PolygonWorld
from .range_sensor import Scan, scan
from .reading import read_world
from .scattered import scattered
from .terrain import Terrain
from .uncertain import UncertainWorld, as_it_is, chance_margins, inflated, scenarios

__all__ = ["PolygonWorld", "Scan", "Terrain", "mesh_outline", "mesh_world", "read_benchmr", "read_mesh", "read_world", "scan"]
__all__ = [
    "LANDSCAPES",
    "PolygonWorld",
    "Scan",
    "Terrain",
    "clearance_of_cells",
    "hills",
    "landscape",
    "read_heights",
    "read_world",
    "roughness",
    "scan",
    "slope",
]
__all__ = ["PolygonWorld", "Scan", "Terrain", "read_world", "scan", "scattered"]
__all__ += ["Moving", "MovingWorld", "UncertainWorld", "as_it_is", "chance_margins", "inflated", "movers_at", "scenarios"]
