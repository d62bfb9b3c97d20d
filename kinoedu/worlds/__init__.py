"""Worlds in which robots move: polygons and bitmaps, built in code or read from files."""

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
from .uncertain import UncertainWorld, chance_margins, inflated, scenario_world, scenarios

__all__ = [
    "LANDSCAPES",
    "Moving",
    "MovingWorld",
    "PolygonWorld",
    "Scan",
    "Terrain",
    "UncertainWorld",
    "chance_margins",
    "clearance_of_cells",
    "hills",
    "inflated",
    "landscape",
    "mesh_outline",
    "mesh_world",
    "movers_at",
    "read_benchmr",
    "read_heights",
    "read_mesh",
    "read_world",
    "roughness",
    "scan",
    "scattered",
    "scenario_world",
    "scenarios",
    "slope",
]
