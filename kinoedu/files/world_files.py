"""Worlds for other programs: a map of MovingAI, or a map for the map_server of ROS."""

from __future__ import annotations

import math
import os
import re
from pathlib import Path
from typing import Any

import numpy as np

from ..collision import clearance_of
from ..errors import InvalidParameter, SceneTooLarge, UnknownFormat
from ..geometry.checks import positive
from ..robots import Point
from ..support.text import shortened
from ..support.whole_files import written_whole
from ..worlds.polygon_world import PolygonWorldRecord
from ..worlds.terrain import Terrain, TerrainRecord
from .path_formats import number

MOST_RASTERED = 250_000  # cells of a world of polygons
NAME = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.-]*")


def write_world(
    world: TerrainRecord | PolygonWorldRecord,
    path: str | os.PathLike[str],
    *,
    resolution: float | None = None,
) -> None:
    """Write a world as a bitmap for another program, from which `read_world` reads the same cells.

    Parameters
    ----------
    path : a name in .map for MovingAI, whose cells have the side 1 and no place; or in .yaml for
        the map_server of ROS, with the picture beside it in .pgm.
    resolution : the side of a cell, needed for a world of polygons. A cell is free where the
        circle round its corners touches no obstacle and lies inside the world.

    Raises
    ------
    UnknownFormat
        Where the file name extension is another one.
    InvalidParameter
        Where `world` is no terrain and no polygons, the resolution is missing, or a terrain has
        one; where a terrain has costs, which these files cannot hold.
    SceneTooLarge
        Where the world would have more than 250,000 cells, from polygons.
    OSError

    Examples
    --------
    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     write_world(Terrain([[1, 0], [1, 1]]), Path(folder) / "corner.map")
    ...     print((Path(folder) / "corner.map").read_text())
    type octile
    height 2
    width 2
    map
    ..
    .@
    <BLANKLINE>
    """
    file = Path(path)
    writers = {".map": write_movingai_map, ".yaml": write_ros_map, ".yml": write_ros_map}
    if file.suffix.lower() not in writers:
        raise UnknownFormat(f"{file}: a bitmap ends in .map (MovingAI) or .yaml (ROS)")
    writers[file.suffix.lower()](as_terrain(world, resolution), file)


def as_terrain(world: Any, resolution: float | None) -> TerrainRecord:
    """The terrain itself, or the cells of a world of polygons."""
    if isinstance(world, PolygonWorldRecord):
        if resolution is None:
            raise InvalidParameter("a world of polygons is written as cells: give resolution=")
        return raster(world, positive(resolution, "resolution"))
    if not isinstance(world, TerrainRecord):
        raise InvalidParameter(
            f"write_world takes a Terrain or a PolygonWorld, got {shortened(world)}"
        )
    if resolution is not None:
        raise InvalidParameter("a terrain has its own resolution; do not give another")
    if world.cost.size:
        raise InvalidParameter("these maps hold no costs; write the problem by write_scene")
    return world


def raster(world: PolygonWorldRecord, resolution: float) -> TerrainRecord:
    """The cells of a world of polygons. A cell is free where the circle round its corners is."""
    with np.errstate(over="ignore"):  # refused below
        size = np.ceil((world.hi - world.lo) / resolution)
        count = size.prod()
    if count > MOST_RASTERED:
        raise SceneTooLarge(
            f"{size[0]:.10g} x {size[1]:.10g} cells are more than {MOST_RASTERED:,}; give a larger "
            "resolution"
        )
    columns, rows = map(int, size)
    # a little more than half a diagonal, so that no corner in contact is lost in rounding
    half, point = resolution / math.sqrt(2.0) * (1.0 + 1e-9), Point()
    free = np.zeros((rows, columns), bool)
    for j in range(rows):
        for i in range(columns):
            centre = world.lo + resolution * np.array([i + 0.5, j + 0.5])
            free[j, i] = clearance_of(point, world, centre) > half
    return Terrain(free, resolution=resolution, origin=world.lo)


def write_movingai_map(world: TerrainRecord, file: Path) -> None:
    """Write a map of MovingAI."""
    rows, columns = world.free.shape
    cells = "\n".join("".join(np.where(row, ".", "@")) for row in world.free[::-1])
    with written_whole(file) as part:
        part.write_text(
            f"type octile\nheight {rows}\nwidth {columns}\nmap\n{cells}\n", encoding="ascii"
        )


def write_ros_map(world: TerrainRecord, file: Path) -> None:
    """Write a map of ROS: the picture first, so that the YAML never names a missing one."""
    picture = file.with_suffix(".pgm")
    if not NAME.fullmatch(picture.name):
        raise InvalidParameter(f"{file}: a map's name needs letters, digits, _, - or . only")
    rows, columns = world.free.shape
    pixels = np.where(world.free[::-1], 254, 0).astype(np.uint8)
    resolution, x, y = (number(value) for value in (world.resolution, *world.origin))
    with written_whole(picture) as part:
        part.write_bytes(f"P5\n{columns} {rows}\n255\n".encode() + pixels.tobytes())
    with written_whole(file) as part:
        part.write_text(
            f"image: {picture.name}\nmode: trinary\nresolution: {resolution}\n"
            f"origin: [{x}, {y}, 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\n",
            encoding="utf-8",
        )
