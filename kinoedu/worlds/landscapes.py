"""Random terrains of 256 x 256 cells for comparing planners; START and GOAL are always connected.

J. R. Sánchez-Ibáñez, C. J. Pérez-del-Pulgar, A. García-Cerezo, "Path planning for autonomous mobile
robots: a review" (2021), on the requirements of outdoor planners.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import InvalidParameter
from ..geometry.checks import Array, as_generator, nonnegative
from ..support.text import shortened
from .terrain import Terrain, TerrainRecord

SIDE = 256
START, GOAL = (10.0, 10.0), (246.0, 246.0)
CLEAR = 9  # half the side, in cells, of the free squares around START and GOAL
Cells = NDArray[np.bool_]


def rocks(rng: np.random.Generator) -> Cells:
    """Ninety round rocks of different sizes, some of which overlap."""
    return ~discs(rng.uniform(0, SIDE, (90, 2)), rng.uniform(3.0, 13.0, 90))


def craters(rng: np.random.Generator) -> Cells:
    """Fourteen craters, each a rim with a gap on one side: traps for greedy planners."""
    x, y = centres()
    blocked = np.zeros((SIDE, SIDE), np.bool_)
    for cx, cy, radius, opening in zip(
        *rng.uniform(24, 232, (2, 14)), rng.uniform(14, 30, 14), rng.uniform(-np.pi, np.pi, 14)
    ):
        far, turn = np.hypot(x - cx, y - cy), np.arctan2(y - cy, x - cx)
        is_open = np.cos(turn - opening) > 0.8
        blocked |= (np.abs(far - radius) < 2.5) & ~is_open
    return ~blocked


def ridges(rng: np.random.Generator) -> Cells:
    """Three ridges across the terrain, each with one pass of ten cells."""
    x, y = centres()
    free = np.ones((SIDE, SIDE), np.bool_)
    for middle, phase, gap in zip(
        (64, 128, 192), rng.uniform(0, 2 * np.pi, 3), rng.uniform(30, 226, 3)
    ):
        crest = middle + 14.0 * np.sin(x / 28.0 + phase)
        free &= (np.abs(y - crest) > 5.0) | (np.abs(x - gap) < 5.0)
    return free


def dunes(rng: np.random.Generator) -> Cells:
    """A maze of dunes: walls of three cells between rooms of 29 cells, some of them missing."""
    free = np.ones((SIDE, SIDE), np.bool_)
    for place in range(32, SIDE - 8, 32):
        for k in range(8):
            if rng.random() < 0.55:
                free[place - 1 : place + 2, 32 * k : 32 * k + 33] = False
            if rng.random() < 0.55:
                free[32 * k : 32 * k + 33, place - 1 : place + 2] = False
    return free


def fords(rng: np.random.Generator) -> Cells:
    """A winding river with three fords six cells wide, and stones on both banks."""
    x, y = centres()
    along, across = (x - y) / np.sqrt(2), (x + y - SIDE) / np.sqrt(2)
    river = np.abs(across - 22.0 * np.sin(along / 30.0 + rng.uniform(0, 2 * np.pi))) < 9.0
    for place in rng.uniform(-110, 110, 3):
        river &= np.abs(along - place) > 3.0
    return ~(river | discs(rng.uniform(0, SIDE, (40, 2)), rng.uniform(2.0, 7.0, 40)))


def spires(rng: np.random.Generator) -> Cells:
    """Five hundred thin spires: much free space, but few long straight lines in it."""
    return ~discs(rng.uniform(0, SIDE, (500, 2)), rng.uniform(1.0, 3.0, 500))


LANDSCAPES: dict[str, Callable[[np.random.Generator], Cells]] = {
    kind.__name__: kind for kind in (rocks, craters, ridges, dunes, fords, spires)
}


def landscape(kind: str, rng: int | np.random.Generator = 0, **terrain: Any) -> TerrainRecord:
    """Draw a terrain of a kind: rocks, craters, ridges, dunes, fords or spires.

    Terrains are drawn until the cells START (10, 10) and GOAL (246, 246) are connected; cells are
    counted from the lower left corner.

    Parameters
    ----------
    rng : a seed or a numpy Generator.
    terrain : further arguments of `Terrain`: resolution, origin, cost.

    Returns
    -------
    TerrainRecord

    Raises
    ------
    InvalidParameter
        Where the kind is unknown.

    Examples
    --------
    >>> landscape("rocks", 0).free.shape
    (256, 256)
    """
    if not isinstance(kind, str) or kind not in LANDSCAPES:
        raise InvalidParameter(
            f"kind must be one of {', '.join(LANDSCAPES)}, got {shortened(kind)}"
        )
    generator = as_generator(rng)
    while True:
        free = LANDSCAPES[kind](generator)
        for x, y in (START, GOAL):
            free[int(y) - CLEAR : int(y) + CLEAR, int(x) - CLEAR : int(x) + CLEAR] = True
        if are_connected(free, START, GOAL):
            return Terrain(free, **terrain)


def hills(rng: int | np.random.Generator = 0, *, highest: float = 40.0) -> Array:
    """Draw random heights: waves of all lengths, the long ones highest, as in eroded mountains.

    R. F. Voss, "Random fractal forgeries" (1985).

    Parameters
    ----------
    rng : a seed or a numpy Generator.
    highest : the height of the highest cell, zero or more, in the unit of a cell's side; the lowest
        cell is at 0.

    Returns
    -------
    (256, 256) array with values from 0 to `highest`.

    Raises
    ------
    InvalidParameter
        Where `rng` is not a seed or a Generator, or `highest` is negative or not a number.

    Examples
    --------
    >>> hills(1).shape
    (256, 256)
    """
    generator, top = as_generator(rng), nonnegative(highest, "highest")
    v, u = np.meshgrid(np.fft.fftfreq(SIDE), np.fft.rfftfreq(SIDE), indexing="ij")
    waves = np.sqrt(u * u + v * v)
    waves[0, 0] = np.inf
    noise = generator.normal(size=(*waves.shape, 2)) @ np.array([1.0, 1.0j])
    # amplitudes fall with the cube of the frequency, a fractal's at most with its square, so the
    # ground is smooth
    ground = np.fft.irfft2(noise / waves**3.0, s=(SIDE, SIDE))
    return top * (ground - ground.min()) / (ground.max() - ground.min())


def centres() -> tuple[Array, Array]:
    """The coordinates x and y of every cell's centre, (256, 256) each."""
    y, x = np.indices((SIDE, SIDE)) + 0.5
    return x, y


def discs(places: Array, radii: Array) -> Cells:
    """The cells whose centres lie in one of the discs, (256, 256)."""
    x, y = centres()
    inside = np.zeros((SIDE, SIDE), np.bool_)
    for (cx, cy), radius in zip(places, radii):
        inside |= (x - cx) ** 2 + (y - cy) ** 2 <= radius * radius
    return inside


def are_connected(free: Cells, a: tuple[float, float], b: tuple[float, float]) -> bool:
    """Whether a and b are connected by free cells that share sides."""
    from scipy.ndimage import label

    parts, _ = label(free)
    here, there = (parts[int(y), int(x)] for x, y in (a, b))
    return bool(here and here == there)
