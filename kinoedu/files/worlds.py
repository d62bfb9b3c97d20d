"""The world in a file: which reader takes which file."""

import os
from collections.abc import Callable
from pathlib import Path

from ..errors import UnknownFormat
from ..support.reading import as_path
from ..worlds.polygon_world import PolygonWorldRecord
from ..worlds.terrain import TerrainRecord
from .benchmr import read_polygons
from .images import read_image
from .meshes import mesh_world
from .movingai import read_map
from .ros_map import read_ros_map


def read_world(path: str | os.PathLike[str]) -> TerrainRecord | PolygonWorldRecord:
    """The world in a file, read by what the file's name ends in (capitals do not matter).

    Parameters
    ----------
    path : str or path
        `.png`, `.bmp`, `.pgm`: a picture (`read_image`); `.map`: a MovingAI map (`read_map`);
        `.yaml`, `.yml`: a ROS map (`read_ros_map`); `.dae`, `.glb`, `.obj`, `.stl`: a mesh, seen
        from above (`mesh_world`); `.json`: a map of polygons (`read_benchmr`). A scene in `.json`
        is read by `kinoedu.files.scenes.read_scene`.

    Returns
    -------
    TerrainRecord, or of a mesh or polygons a PolygonWorldRecord
        x right, y up; the picture or map looks on the page as in its file.

    Raises
    ------
    UnknownFormat
        No reader knows the ending.
    UnreadableScene, SceneTooLarge
        The file is missing or damaged; it holds more than `MAX_CELLS` cells.

    Examples
    --------
    >>> read_world("world.txt")  # doctest: +ELLIPSIS
    Traceback (most recent call last):
    kinoedu.errors.UnknownFormat: world.txt: expected .bmp, .dae, ... .yaml or .yml, got .txt; ...
    """
    readers: dict[str, Callable[[str | os.PathLike[str]], TerrainRecord | PolygonWorldRecord]] = {
        ".bmp": read_image, ".dae": mesh_world, ".glb": mesh_world, ".json": read_polygons, ".map": read_map, ".obj": mesh_world,
        ".pgm": read_image, ".png": read_image, ".stl": mesh_world, ".yaml": read_ros_map, ".yml": read_ros_map,
    }  # fmt: skip
    file = as_path(path)
    ending = file.suffix.lower()
    if ending not in readers:
        raise _unknown_format(file, ending, sorted(readers))
    return readers[ending](path)


def _unknown_format(path: Path, ending: str, known: list[str]) -> UnknownFormat:
    """The error for an ending that no reader knows; a folder gets advice of its own."""
    got, advice = ending or "no ending", "save it as one of those"
    if os.path.isdir(path):
        got, advice = "a folder", "name a file inside it"
    return UnknownFormat(
        f"{path}: expected {', '.join(known[:-1])} or {known[-1]}, got {got}; {advice}"
    )
