"""Figures of solids: a mesh in (x, y, theta) with a plane through it, and the coloured torus."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib import pyplot as plt
from matplotlib.artist import Artist
from matplotlib.colors import to_rgb
from numpy.typing import ArrayLike

from ..errors import InvalidPoint
from ..geometry.checks import Array
from ..support.text import shortened
from . import palette
from .palette import Style

if TYPE_CHECKING:
    from trimesh import Trimesh

LIGHT = np.array([-0.45, -0.65, 0.61])  # towards the light, over the reader's left shoulder
TORUS = (2.0, 1.0)  # the radii of the ring and of the tube
ARM = palette.LINKS  # free; link 1 in contact; link 2 in contact


def draw_mesh(
    mesh: Trimesh, ax: Any = None, *, theta: float | None = None, axes: bool = True
) -> list[Artist]:
    """Draw a triangle mesh in 3-D axes, lit from the left, in its own colours where it has any.

    Parameters
    ----------
    theta : draw a translucent plane at this height, and the outline of the cut.
    axes : whether axes x, y, θ are drawn.
    """
    from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection

    if ax is None:
        figure = plt.figure(figsize=(6.0, 5.5), dpi=72, layout="constrained")
        ax = figure.add_subplot(projection="3d")
    ax.computed_zorder = False
    colours = shade_faces(mesh)
    seamless: Style = {"facecolors": colours, "edgecolors": colours, "linewidths": 0.3}
    solid = Poly3DCollection(mesh.triangles, zorder=1, **seamless)
    artists: list[Artist] = [ax.add_collection3d(solid)]
    lo, hi = mesh.bounds
    ax.set(xlim=(lo[0], hi[0]), ylim=(lo[1], hi[1]), zlim=(lo[2], hi[2]))
    flat = (hi - lo)[:2].max()
    height, zoom = (1.0, 0.92) if axes else ((hi - lo)[2] / flat, 1.25)
    ax.set_box_aspect((*((hi - lo)[:2] / flat), height), zoom=zoom)
    if axes:
        dress_axes(ax)
    else:
        ax.set_axis_off()
    if theta is not None:
        solid.set(alpha=0.5, edgecolor="none")
        margin = 0.06 * (hi - lo)
        (x0, y0, _), (x1, y1, _) = lo - margin, hi + margin
        page = [[(x0, y0, theta), (x1, y0, theta), (x1, y1, theta), (x0, y1, theta)]]
        glass: Style = {"facecolors": palette.PATH, "edgecolors": palette.CUT, "alpha": 0.22}
        plane, outline = Poly3DCollection(page, zorder=2, **glass), list(cut_mesh(mesh, theta))
        cut = Line3DCollection(outline, colors=palette.CUT, linewidths=3.0, zorder=3)
        artists.append(ax.add_collection3d(plane))
        artists.append(ax.add_collection3d(cut))
    return artists


def dress_axes(ax: Any) -> None:
    """Set names and ticks of the axes x, y, θ, the last in degrees."""
    ax.set_xlabel("x", fontsize=palette.TEXT_SIZE, labelpad=8)
    ax.set_ylabel("y", fontsize=palette.TEXT_SIZE, labelpad=8)
    ax.set_zlabel("θ", fontsize=palette.TEXT_SIZE)
    ax.set_zticks(np.radians([-180, -90, 0, 90, 180]), ["-180°", "-90°", "0°", "90°", "180°"])
    ax.locator_params(axis="x", nbins=4, prune="upper")  # the numbers of two axes meet at a corner
    ax.locator_params(axis="y", nbins=4, prune="lower")
    ax.tick_params(labelsize=palette.TEXT_SIZE - 1)
    ax.view_init(elev=22, azim=-62)


def shade_faces(mesh: Trimesh) -> Array:
    """The colour of each face under the light, (m, 3), also of one without an area."""
    visual: Any = mesh.visual
    own = np.array([to_rgb(palette.ROADMAP)])
    if visual is not None and visual.kind == "face":
        own = np.asarray(visual.face_colors)[:, :3] / 255.0
    normals = np.array(mesh.face_normals)
    normals[:, 2] /= np.pi  # the solid is drawn compressed in theta, which makes faces steeper
    lengths = np.linalg.norm(normals, axis=1)[:, None]
    normals = np.divide(normals, lengths, out=np.zeros_like(normals), where=lengths > 0.0)
    light = 0.62 + 0.38 * (normals @ LIGHT)
    return np.clip(own * light[:, None], 0.0, 1.0)


def cut_mesh(mesh: Trimesh, theta: float) -> Array:
    """The outline of a mesh at a height, as segments in space, shape (k, 2, 3).

    At a flat end it is the outline of the end; beyond the mesh it is empty.
    """
    from trimesh.intersections import mesh_plane

    low, high = mesh.bounds[:, 2]
    inset = 1e-7 * (high - low)  # because a plane does not cut a flat end that lies in it
    level = float(np.clip(theta, low + inset, high - inset)) if low <= theta <= high else theta
    segments = mesh_plane(mesh, plane_normal=(0.0, 0.0, 1.0), plane_origin=(0.0, 0.0, level))
    return np.asarray(segments, float).reshape(-1, 2, 3)


def torus_mesh(image: ArrayLike) -> Trimesh:
    """The torus of a two-link arm's configurations, its faces coloured by an image.

    Parameters
    ----------
    image : (n, m) of 0 free, 1 link 1 in contact, 2 link 2 in contact. Column i is the first angle,
        round the ring; row j the second, round the tube; cell (j, i) spans 2 pi i / m to
        2 pi (i + 1) / m, and 2 pi j / n to 2 pi (j + 1) / n.

    Raises
    ------
    InvalidPoint

    Examples
    --------
    >>> mesh = torus_mesh(np.zeros((24, 36), int))
    >>> mesh.is_watertight, mesh.euler_number, len(mesh.faces)
    (True, 0, 1728)
    """
    from trimesh import Trimesh

    cells = np.asarray(image)
    if cells.ndim != 2 or min(cells.shape) < 3 or not np.isin(cells, (0, 1, 2)).all():
        raise InvalidPoint(
            f"image must be at least 3 x 3 cells of 0, 1 or 2, got {shortened(image)}"
        )
    n, m = cells.shape
    ring, tube = np.meshgrid(2.0 * np.pi * np.arange(m) / m, 2.0 * np.pi * np.arange(n) / n)
    far = TORUS[0] + TORUS[1] * np.cos(tube)
    coordinates = (far * np.cos(ring), far * np.sin(ring), TORUS[1] * np.sin(tube))
    points = np.column_stack([values.ravel() for values in coordinates])
    here = np.arange(n * m).reshape(n, m)
    right, up = np.roll(here, -1, axis=1), np.roll(here, -1, axis=0)
    across = np.roll(right, -1, axis=0)
    halves = [np.stack([here, right, across], axis=-1), np.stack([here, across, up], axis=-1)]
    faces = np.stack(halves, axis=2).reshape(-1, 3)
    levels = [[*(np.array(to_rgb(colour)) * 255).astype(np.uint8), 255] for colour in ARM]
    colours = np.repeat(np.array(levels, np.uint8)[cells.ravel().astype(int)], 2, axis=0)
    return Trimesh(points, faces, face_colors=colours, process=False)
