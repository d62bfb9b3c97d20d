"""Worlds and robots from triangle meshes, projected to the plane or sliced at a height.

trimesh reads the files, but for .obj, and does not rotate them. What it would leave out without a
word is an error. The up-axis that a file declares is often wrong, so z is up unless the parameter
`up` says otherwise.
"""

from __future__ import annotations

import codecs
import io
import logging
import os
import re
import warnings
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..errors import InvalidParameter, InvalidRobot, SceneTooLarge, UnknownFormat, UnreadableScene
from ..geometry.checks import LIMIT, Array, as_array, as_point, positive
from ..support.reading import as_path, read_bytes
from ..support.text import shortened
from ..worlds.polygon_world import PolygonWorld, PolygonWorldRecord
from .mesh_losses import refuse_what_trimesh_loses
from .obj import read_obj
from .outlines import Solid, project_triangles, rectangle, slice_triangles

ENDINGS = (".dae", ".glb", ".obj", ".stl")
MAX_TRIANGLES = 500_000
MAX_BYTES = 200_000_000
logging.getLogger("trimesh").addHandler(logging.NullHandler())  # else it prints tracebacks
UPRIGHT = {  # by the axis that is up: the coordinates, with signs, that become x, y and z
    "z": ((0, 1), (1, 1), (2, 1)),
    "y": ((0, 1), (2, -1), (1, 1)),
    "x": ((1, -1), (2, -1), (0, 1)),
}


def read_mesh(
    path: str | os.PathLike[str], *, slice_at: float | None = None, up: str = "z"
) -> list[Solid]:
    """Read the polygons of a mesh as pairs (outline, rooms): obstacles for `PolygonWorld`.

    Outlines are counter-clockwise and disjoint; holes of the mesh are rooms. Coordinates are exact
    to 2^-36 of the size of the mesh, or to the last digit of a float where that is coarser: one of
    32 bits in a .dae or .glb. A slice shows the bodies just above its height. An .obj file that is
    truncated between two lines cannot be distinguished from a complete one.

    Parameters
    ----------
    path : .stl, .obj, .dae or .glb. All bodies of a scene are used, at their positions in the file.
    slice_at : the height of the slice, which needs closed bodies; by default the mesh is projected
        from above.
    up : the axis of the file that points up: "z", "y", "x", or "file" for the axis that the file
        declares: `<up_axis>` of a .dae, or y where it has none; y in a .glb, z otherwise. Programs
        often write a wrong `<up_axis>`, so it is used only on request. With y up, the plane is (x,
        -z); with x up, (-y, -z).

    Returns
    -------
    list of pairs (outline, rooms): a polygon (n, 2), and a list of polygons.

    Raises
    ------
    UnreadableScene
        Where the file is missing, damaged or empty, covers no area, or is not closed at a slice.
    SceneTooLarge
        Where the file has too many bytes or triangles.
    UnknownFormat
        Where its ending is not one of these.
    InvalidParameter
        Where there is nothing at the height, or `up` is unknown.

    Examples
    --------
    >>> from pathlib import Path
    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     file = Path(folder) / "tile.obj"
    ...     _ = file.write_text("v 0 0 1\\nv 2 0 1\\nv 2 1 1\\nv 0 1 1\\nf 1 2 3\\nf 1 3 4\\n")
    ...     [(outline, rooms)] = read_mesh(file)
    >>> sorted(outline.tolist()), rooms
    ([[0.0, 0.0], [0.0, 1.0], [2.0, 0.0], [2.0, 1.0]], [])
    """
    if up not in (*UPRIGHT, "file"):
        raise InvalidParameter(f'up must be "x", "y", "z" or "file", got {shortened(up)}')
    file = as_path(path)
    triangles = read_triangles(file, up)
    if slice_at is None:
        made: list[Solid] | None = project_triangles(triangles)
        if not made:
            raise UnreadableScene(
                f"{file}: its triangles cover no area seen along {up}; if another axis is up, pass "
                "it as `up`"
            )
        return made
    height = as_array(slice_at, "slice_at")
    low, high = triangles[:, :, 2].min(), triangles[:, :, 2].max()
    if height.ndim or not low <= height < high:
        raise InvalidParameter(
            f"{file}: slice_at must be a height from {low:g} to below {high:g}, got "
            f"{shortened(slice_at)}"
        )
    made = slice_triangles(triangles, float(height))
    if made is None:
        raise UnreadableScene(
            f"{file}: the mesh is not closed at height {float(height):g}, or some of its "
            "triangles are oriented inward; repair it, or omit slice_at to project it from above"
        )
    if not made:
        raise InvalidParameter(
            f"{file}: no body is at height {float(height):g}; choose another slice_at"
        )
    return made


def mesh_world(
    path: str | os.PathLike[str],
    *,
    boundary: ArrayLike | None = None,
    margin: float | None = None,
    slice_at: float | None = None,
    up: str = "z",
) -> PolygonWorldRecord:
    """Read a world whose obstacles are the polygons of a mesh.

    Parameters
    ----------
    boundary : (n, 2), a simple polygon; by default the bounding rectangle of the mesh, grown by
        `margin`.
    margin : a length, by default a tenth of the longer side of the mesh.
    path, slice_at, up : as in `read_mesh`.

    Returns
    -------
    PolygonWorldRecord

    Raises
    ------
    InvalidPolygon
        Where the boundary is not a simple polygon.
    UnreadableScene, SceneTooLarge, UnknownFormat, InvalidParameter
        As `read_mesh`.
    """
    obstacles = read_mesh(path, slice_at=slice_at, up=up)
    if boundary is None:
        corners = np.concatenate([outline for outline, _ in obstacles])
        lo, hi = corners.min(axis=0), corners.max(axis=0)
        off = (hi - lo).max() / 10.0 if margin is None else positive(margin, "margin")
        boundary = rectangle(lo - off, hi + off)
    elif margin is not None:
        raise InvalidParameter("give a boundary or a margin, not both")
    return PolygonWorld(boundary, obstacles)


def mesh_outline(
    path: str | os.PathLike[str],
    *,
    slice_at: float | None = None,
    up: str = "z",
    reference: ArrayLike = (0.0, 0.0),
) -> Array:
    """Read the outline of a mesh of one piece: vertices for `RigidPolygon` or `TranslatingPolygon`.

    Holes are filled.

    Parameters
    ----------
    reference : the point of the mesh, in the plane, that becomes the origin: the reference point of
        the robot.
    path, slice_at, up : as in `read_mesh`.

    Returns
    -------
    (n, 2) array.

    Raises
    ------
    InvalidRobot
        Where there is more than one piece.
    UnreadableScene, SceneTooLarge, UnknownFormat, InvalidParameter
        As `read_mesh`.
    """
    pieces = read_mesh(path, slice_at=slice_at, up=up)
    if len(pieces) > 1:
        raise InvalidRobot(f"{path}: a robot must be in one piece, got {len(pieces)}")
    return pieces[0][0] - as_point(reference, "reference")


def read_triangles(file: Path, up: str) -> Array:
    """The triangles of a file, (m, 3, 3), z up."""
    ending = file.suffix.lower()
    if ending not in ENDINGS:
        raise UnknownFormat(f"{file}: expected {', '.join(ENDINGS)}, got {ending or 'no ending'}")
    data = read_bytes(file, MAX_BYTES)
    if len(data) > MAX_BYTES:
        raise SceneTooLarge(
            f"{file}: expected at most {MAX_BYTES:,} bytes, got more; simplify the mesh"
        )
    triangles = load_triangles(data, ending[1:], file)
    if len(triangles) == 0:
        raise UnreadableScene(f"{file}: it holds no triangles; export the surfaces as a mesh")
    if len(triangles) > MAX_TRIANGLES:
        raise SceneTooLarge(
            f"{file}: expected at most {MAX_TRIANGLES:,} triangles, got {len(triangles):,}; "
            "simplify the mesh"
        )
    if not (np.abs(triangles) <= LIMIT).all():
        raise UnreadableScene(
            f"{file}: coordinates must be finite and at most 1e150; export it again"
        )
    axes = UPRIGHT[declared_up_axis(data, ending) if up == "file" else up]
    return np.stack([sign * triangles[:, :, row] for row, sign in axes], axis=2)


def load_triangles(data: bytes, kind: str, file: Path) -> Array:
    """Read the triangles of all bodies, at their positions in the scene."""
    data = data.removeprefix(codecs.BOM_UTF8)
    try:
        if kind == "obj":
            return read_obj(data)
        refuse_what_trimesh_loses(data, kind)
        is_text = kind == "stl" and data.lstrip()[:5] == b"SOLID"
        return load_by_trimesh(data.lower() if is_text else data, kind)
    except UnreadableScene as error:
        raise UnreadableScene(f"{file}: {error}") from None
    except ImportError as error:
        raise UnreadableScene(
            f"{file}: reading .{kind} needs a package that is not installed: {error}"
        ) from error
    except Exception as error:  # damaged bytes raise anything from KeyError to struct.error
        raise UnreadableScene(
            f"{file}: expected a mesh in .{kind}, got damage: {shortened(error)}; export it again"
        ) from error


def load_by_trimesh(data: bytes, kind: str) -> Array:
    """The triangles that trimesh reads, (m, 3, 3)."""
    import trimesh

    options: dict[str, Any] = {"skip_materials": True} if kind == "glb" else {}
    with warnings.catch_warnings(), np.errstate(all="ignore"):
        warnings.simplefilter("ignore")  # the results are checked later
        scene = trimesh.load_scene(io.BytesIO(data), file_type=kind, process=False, **options)
        surfaces = any(isinstance(body, trimesh.Trimesh) for body in scene.geometry.values())
        return np.array(scene.triangles, np.float64) if surfaces else np.empty((0, 3, 3))


def declared_up_axis(data: bytes, ending: str) -> str:
    """The axis that the file declares as up."""
    found = re.search(rb"<up_axis>\s*([XYZ])_UP", data) if ending == ".dae" else None
    if found:
        return found[1].decode().lower()
    return "y" if ending in (".dae", ".glb") else "z"  # the default of the two formats is y
