"""An arm in its workspace, and its configuration space, sampled or painted.

Bullo & Smith, chapter 4.
"""

from __future__ import annotations

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.colors import ListedColormap
from numpy.typing import ArrayLike, NDArray

from ..collision import link_in_contact
from ..errors import InvalidPoint
from ..geometry.checks import as_array
from ..messages import get_message
from ..robots.arm import ArmRobot
from ..worlds.checks import World
from . import palette
from .drawing import axes_for, draw_world
from .names import HALO
from .robots import draw_robot

MARKERS = ("o", "s", "^")  # free, link 1, link 2: distinguishable without colours too
TICKS = np.array([-1.0, -0.5, 0.0, 0.5, 1.0]) * np.pi
TICK_NAMES = (r"$-\pi$", r"$-\pi/2$", "0", r"$\pi/2$", r"$\pi$")

ANSWERS = (palette.FREE_LINK, palette.INK, palette.HIT)  # free, link 1, link 2, as in the square
LETTER, HIGH = 0.016, 0.045  # a letter's width and a line's height, shares of the square's side
SMALL = 0.03  # the depth of a region without a name, a share of that side
LINK_WORDS = "figure.link_0", "figure.link_1", "figure.link_2"


def plot_environment(
    arm: ArmRobot, q: ArrayLike, world: World, ax: Axes | None = None
) -> list[Artist]:
    """Draw a world and an arm in it: base, links with their width, joints.

    The colour says what is in contact: blue nothing, black link 1, red link 2.
    """
    ax = axes_for(world, ax)
    angles = as_array(q, "q")
    hit = link_in_contact(arm, angles, world)
    artists = draw_world(world, ax) + draw_robot(arm, angles, ax, ANSWERS[hit])
    base = ax.plot(*arm.base, "s", color=palette.INK, markersize=11, zorder=7)
    text = (
        get_message("figure.link_in_contact", link=hit)
        if hit
        else get_message("figure.no_link_in_contact")
    )
    ax.set_title(text, **palette.TEXT)
    return [*artists, *base]


def plot_configuration_space(
    arm: ArmRobot, world: World, samples: ArrayLike, ax: Axes | None = None
) -> list[Artist]:
    """Draw samples of a two-link arm's configuration space in the book's colours.

    Black squares: link 1 is in contact; red triangles: link 2 is; blue dots: the arm is free.

    Parameters
    ----------
    samples : (n, 2), angles in radians.

    Raises
    ------
    InvalidPoint
    """
    points = as_array(samples, "samples")
    if points.ndim != 2 or points.shape[1] != 2:
        raise InvalidPoint(
            f"samples must be angles of two links, shape (n, 2), got shape {points.shape}"
        )
    ax = torus_axes(ax)
    links = np.array([link_in_contact(arm, q, world) for q in points], int)
    wrapped = (points + np.pi) % (2.0 * np.pi) - np.pi
    size = float(np.clip(160.0 / np.sqrt(max(len(points), 1)), 2.0, 9.0))
    drawn: list[Artist] = []
    for link, (marker, colour) in enumerate(zip(MARKERS, palette.LINKS)):
        shown, name = wrapped[links == link], get_message(LINK_WORDS[link])
        look: palette.Style = {"color": colour, "markersize": size, "linestyle": "none"}
        drawn += ax.plot(*shown.T, marker, label=name, **look)
    above: palette.Style = {"loc": "upper center", "bbox_to_anchor": (0.5, 1.11), "ncols": 3}
    ax.legend(frameon=False, handletextpad=0.2, **above, **palette.TEXT)
    return drawn


def draw_configuration_space(image: NDArray[np.int8], ax: Axes | None = None) -> list[Artist]:
    """Draw an image from `paint_configuration_space`: theta1 to the right, theta2 up.

    Each region is named where it is widest.
    """
    ax = torus_axes(ax)
    cells: palette.Style = {"origin": "lower", "interpolation": "nearest", "zorder": 1}
    cells["extent"] = (-np.pi, np.pi, -np.pi, np.pi)
    colours = ListedColormap(palette.LINKS_LIGHT)
    artists: list[Artist] = [ax.imshow(image, cmap=colours, vmin=0, vmax=2, **cells)]
    for link, text in enumerate(LINK_WORDS):
        artists += name_region(image == link, get_message(text), ax)
    return artists


def name_region(region: NDArray[np.bool_], name: str, ax: Axes) -> list[Artist]:
    """Write a name where a region has room for it, lying or upright; else where it is widest.

    Nothing is written where the region is too small.
    """
    from scipy.ndimage import minimum_filter

    high, long = (round(share * len(region)) for share in (HIGH, LETTER * len(name)))
    look: palette.Style = {**palette.CENTRED, **palette.TEXT, "path_effects": HALO, "zorder": 5}
    for turned, box in ((0, (high, long)), (90, (long, high))):
        room = minimum_filter(region, box, mode="constant")
        if room.any():
            return [ax.text(*find_widest(room)[0], name, rotation=turned, **look)]
    (x, y), depth = find_widest(region)
    return [ax.text(x, y, name, **look)] if depth > SMALL else []


def find_widest(region: NDArray[np.bool_]) -> tuple[tuple[float, float], float]:
    """The angles at which a region of an image is widest, and its depth there, a share of 2 pi."""
    from scipy.ndimage import distance_transform_edt

    depth = distance_transform_edt(np.pad(region, 1))[1:-1, 1:-1]
    widest = np.argwhere(depth > depth.max() - 0.5)
    off_centre = np.abs(widest - len(region) / 2).sum(axis=1)
    row, column = widest[off_centre.argmin()]  # in a stripe, the middle
    x, y = ((float(index) + 0.5) * 2.0 * np.pi / len(region) - np.pi for index in (column, row))
    return (x, y), depth[row, column] / len(region)


def torus_axes(ax: Axes | None) -> Axes:
    """The axes given, or new ones: both angles from -pi to pi."""
    ax = palette.axes_or_new(ax, (6.4, 6.4))
    ax.set_aspect("equal")
    ax.set_xlim(-np.pi, np.pi)
    ax.set_ylim(-np.pi, np.pi)
    ax.set_xticks(TICKS, TICK_NAMES, fontsize=palette.TEXT_SIZE)
    ax.set_yticks(TICKS, TICK_NAMES, fontsize=palette.TEXT_SIZE)
    ax.set_xlabel("θ₁, link 1", fontsize=palette.TEXT_SIZE)
    ax.set_ylabel("θ₂, link 2 from link 1", fontsize=palette.TEXT_SIZE)
    return ax
