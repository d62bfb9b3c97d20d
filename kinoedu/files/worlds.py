"""`read_world`: read a world from a file, by the reader for its file name extension."""

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
    """Read a world from a file, by its file name extension; upper or lower case.

    Parameters
    ----------
    path : str or path
        `.png`, `.bmp`, `.pgm`: a picture (`read_image`); `.map`: a MovingAI map (`read_map`);
        `.yaml`, `.yml`: a ROS map (`read_ros_map`); `.dae`, `.glb`, `.obj`, `.stl`: a mesh,
        projected from above (`mesh_world`); `.json`: a polygon map (`read_benchmr`). A scene in
        `.json` is read by `read_scene`.

    Returns
    -------
    TerrainRecord, or a PolygonWorldRecord for a mesh or polygons
        x points right and y up; the picture or map has the same orientation as in its file.

    Raises
    ------
    UnknownFormat
        Where there is no reader for the extension.
    UnreadableScene
        Where the file is missing or damaged.
    SceneTooLarge
        Where it has more than `MAX_CELLS` cells.

    Examples
    --------
    >>> read_world("world.txt")  # doctest: +ELLIPSIS
    Traceback (most recent call last):
    kinoedu.errors.UnknownFormat: world.txt: expected .bmp, .dae, ... .yaml or .yml, got .txt; ...
    """
    readers: dict[str, Callable[[str | os.PathLike[str]], TerrainRecord | PolygonWorldRecord]] = {
        **dict.fromkeys((".bmp", ".pgm", ".png"), read_image),
        **dict.fromkeys((".dae", ".glb", ".obj", ".stl"), mesh_world),
        **dict.fromkeys((".yaml", ".yml"), read_ros_map),
        ".json": read_polygons,
        ".map": read_map,
    }
    file = as_path(path)
    ending = file.suffix.lower()
    if ending not in readers:
        raise _unknown_format(file, ending, sorted(readers))
    return readers[ending](path)


def _unknown_format(path: Path, ending: str, extensions: list[str]) -> UnknownFormat:
    """The error for an unknown extension, or for a folder."""
    got, advice = ending or "no ending", "save it as one of those"
    if os.path.isdir(path):
        got, advice = "a folder", "name a file inside it"
    return UnknownFormat(
        f"{path}: expected {', '.join(extensions[:-1])} or {extensions[-1]}, got {got}; {advice}"
    )
