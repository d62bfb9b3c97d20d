"""Which way is up in a mesh, as a picture: python docs/mesh_up.py draws docs/mesh_up.png.

One mesh, three beams of different lengths along its axes, and the worlds that `mesh_world` makes of
it for each choice of `up`.
"""

import sys
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

HOUSE = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(HOUSE))

from kinoedu.figures import draw_world, palette  # noqa: E402
from kinoedu.files import mesh_world  # noqa: E402

PICTURE = HOUSE / "docs" / "mesh_up.png"
BEAMS = {"x": (6.0, 1.0, 1.0), "y": (1.0, 4.0, 1.0), "z": (1.0, 1.0, 2.5)}
COLOURS = {"x": palette.GOAL, "y": palette.START, "z": palette.PATH}
PLANES = {"z": ("x", "y"), "y": ("x", "-z"), "x": ("-y", "-z")}
SIDES = np.array(
    [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
)


def corners(size):
    """The corners of a box at the origin, (8, 3)."""
    return np.array([(i, j, k) for i in (0, 1) for j in (0, 1) for k in (0, 1)]) * size


def mesh_text():
    """The three beams in Wavefront's format."""
    lines = []
    for k, size in enumerate(BEAMS.values()):
        lines += ["v {} {} {}".format(*corner) for corner in corners(size)]
        lines += ["f " + " ".join(str(8 * k + i + 1) for i in side) for side in SIDES]
    return "\n".join(lines) + "\n"


def draw(file):
    """The mesh, and its world for each axis that may point up."""
    figure = Figure(figsize=(11.0, 3.2), layout="constrained")
    FigureCanvasAgg(figure)
    grid = figure.add_gridspec(1, 4, width_ratios=[1.3, 1, 1, 1])
    ax = figure.add_subplot(grid[0], projection="3d")
    for name, size in BEAMS.items():
        faces = Poly3DCollection(corners(size)[SIDES], facecolor=COLOURS[name], edgecolor="white")
        ax.add_collection3d(faces)
        end = np.array(size) * [axis == name for axis in "xyz"] + 0.9
        ax.text(*end, name, fontsize=palette.TEXT_SIZE + 2, ha="center")
    ax.set(xlim=(0, 6), ylim=(0, 4), zlim=(0, 2.5))
    ax.set_box_aspect((6, 4, 2.5), zoom=0.85)
    ax.set_axis_off()
    ax.text2D(0.5, 0.95, "the mesh in its file", transform=ax.transAxes, ha="center")
    for column, (up, (right, top)) in enumerate(PLANES.items(), start=1):
        panel = figure.add_subplot(grid[column])
        draw_world(mesh_world(file, up=up, margin=1.0), panel)
        panel.set(title=f'up="{up}"', xlabel=f"{right} of the file", ylabel=f"{top} of the file")
        for axis, end in ((right, 0), (top, 1)):
            far = BEAMS[axis[-1]]["xyz".index(axis[-1])] - 0.5
            place = np.full(2, 0.5) * [-1 if name[0] == "-" else 1 for name in (right, top)]
            place[end] = -far if axis[0] == "-" else far
            colour = COLOURS[axis[-1]]
            panel.text(*place, axis[-1], color="white", ha="center", va="center", weight="bold",
                       bbox={"facecolor": colour, "edgecolor": "none", "pad": 2})
        panel.set(xlim=None, ylim=None)
        panel.set_autoscale_on(True)
        panel.set_aspect("equal")
        panel.set_box_aspect(0.85)
        panel.set_adjustable("datalim")
    figure.savefig(PICTURE, dpi=110)


if __name__ == "__main__":
    with TemporaryDirectory() as folder:
        mesh = Path(folder) / "beams.obj"
        mesh.write_text(mesh_text())
        draw(mesh)
