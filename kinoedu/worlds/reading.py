"""The door to world files: which reader takes which file, and what every reader first asks of a file."""

import os
from collections.abc import Callable
from pathlib import Path
from stat import S_ISDIR, S_ISREG
from typing import TYPE_CHECKING

from ..errors import SceneTooLarge, UnknownFormat, UnreadableScene
from ..geometry.checks import shortened

if TYPE_CHECKING:
    from .polygon_world import PolygonWorldRecord
    from .terrain import TerrainRecord

MAX_CELLS = 25_000_000  # 5,000 x 5,000, which takes some 400 MB to read
MAX_BYTES = 3 * MAX_CELLS + 1_000  # the longest text of so many cells: one a row, with Windows line ends


def read_world(path: str | os.PathLike[str]) -> "TerrainRecord | PolygonWorldRecord":
    """The world in a file, read by what the file's name ends in (capitals do not matter).

    Parameters
    ----------
    path : str or path
        `.png`, `.bmp`, `.pgm`: a picture (`read_image`); `.map`: a MovingAI map (`read_map`); `.yaml`,
        `.yml`: a ROS map (`read_ros_map`); `.dae`, `.glb`, `.obj`, `.stl`: a mesh, seen from above (`mesh_world`); `.json`: a map
        of polygons (`read_benchmr`). A scene in `.json` is read by `kinoedu.scenes.read_scene`.

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
    # Imported here because each reader asks this file's questions.
    from .benchmr import read_polygons
    from .images import read_image
    from .meshes import mesh_world
    from .movingai import read_map
    from .ros_map import read_ros_map

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
    return UnknownFormat(f"{path}: expected {', '.join(known[:-1])} or {known[-1]}, got {got}; {advice}")


def as_path(path: str | os.PathLike[str]) -> Path:
    """The path of a file. Raises UnreadableScene for what is none."""
    try:
        return Path(path)
    except TypeError:
        raise UnreadableScene(f"expected the path of a file, got {shortened(path)}") from None


def regular_file(path: str | os.PathLike[str]) -> Path:
    """`path` again, once it is known to lead to a regular file.

    Raises
    ------
    UnreadableScene
        Nothing is there, the links run in a circle, or it is a folder, a pipe (opening it would wait for
        ever) or a device (reading it might never end).
    """
    path = as_path(path)
    try:
        mode = path.stat().st_mode
    except (OSError, ValueError) as error:  # ValueError: a NUL in the name
        why = getattr(error, "strerror", None) or error
        raise UnreadableScene(f"{str(path)!r}: expected a file, got: {why}; check the path") from error
    if not S_ISREG(mode):
        what = "a folder" if S_ISDIR(mode) else "a pipe or a device"
        raise UnreadableScene(f"{path}: expected a file, got {what}; give the path of a file")
    return path


def read_text(path: str | os.PathLike[str], most: int = MAX_BYTES) -> str:
    """The text of a UTF-8 or ASCII file of at most `most` bytes, every line end turned into a newline.

    Raises
    ------
    UnreadableScene, SceneTooLarge
        The file is missing or is not text; it is longer than `most`.
    """
    path = regular_file(path)
    try:
        with path.open("rb") as stream:
            data = stream.read(most + 1)  # not the size in the folder's list, which may be stale or 0
        text = data.decode("utf-8-sig")  # some editors begin a file with a byte-order mark
    except (OSError, UnicodeDecodeError) as error:
        raise UnreadableScene(f"{path}: expected plain text, got: {error}; save it as UTF-8") from error
    if len(data) > most:
        raise SceneTooLarge(f"{path}: expected at most {most:,} bytes, got more; is it the right file?")
    if "\0" in text:
        raise UnreadableScene(f"{path}: expected plain text, got a NUL byte; save it as UTF-8")
    return text.replace("\r\n", "\n").replace("\r", "\n")


def check_size(where: str | Path, columns: int, rows: int) -> None:
    """Refuse, before anything is decoded, a size that no terrain can have; `where` begins the message.

    Raises
    ------
    UnreadableScene, SceneTooLarge
        A side is not positive; the cells are more than `MAX_CELLS`.
    """
    if columns < 1 or rows < 1:
        raise UnreadableScene(f"{where}: expected at least one column and one row, got {columns} x {rows}")
    if columns * rows > MAX_CELLS:
        raise SceneTooLarge(f"{where}: expected at most {MAX_CELLS:,} cells, got {columns:,} x {rows:,}; shrink it")
