"""Worlds in which robots move: polygons and bitmaps."""

from .heights import clearance_of_cells, roughness, slope
from .landscapes import LANDSCAPES, hills, landscape
from .moving import Moving, MovingWorld, movers_at
from .polygon_world import PolygonWorld
from .range_sensor import Scan, scan
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
    "movers_at",
    "roughness",
    "scan",
    "scattered",
    "scenario_world",
    "scenarios",
    "slope",
]
