"""Figures of uncertain obstacles: expected places, scenarios, and safety margins."""

from __future__ import annotations

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection

from ..geometry.checks import Array
from ..geometry.grown import grow_piece
from ..worlds.polygon_world import discs_of, rings_of
from ..worlds.uncertain import UncertainWorldRecord, chance_margins
from . import palette
from .drawing import axes_for, draw_world
from .moving import outline_of
from .palette import Style


def expected_outlines(world: UncertainWorldRecord) -> list[tuple[int, Array]]:
    """The number of each obstacle and its outline (k, 2) at its expected place, polygons first.

    A disc's outline has 24 corners.
    """
    is_round = np.zeros(len(world.sigma), bool)
    is_round[world.owner[world.parts.radius > 0.0]] = True
    rings = [solid[0] for solid in rings_of(world.expected)[1:]]
    discs = [outline_of(row[None, :2], row[2]) for row in discs_of(world.expected)]
    numbers = np.concatenate([np.flatnonzero(~is_round), np.flatnonzero(is_round)])
    return list(zip(numbers.tolist(), rings + discs))


def margin_rings(world: UncertainWorldRecord, delta: float) -> list[Array]:
    """The outline of each obstacle grown by its `chance_margins`, shape (k, 2)."""
    import shapely

    margins, parts = chance_margins(world.sigma, delta)[world.owner], world.parts
    pieces = [parts.points[a:b] for a, b in zip(parts.first[:-1], parts.first[1:])]
    grown_pieces = [
        shapely.Polygon(grow_piece(piece, float(own + more)))
        for piece, own, more in zip(pieces, parts.radius, margins)
    ]
    wholes = [
        shapely.union_all([grown_pieces[k] for k in np.flatnonzero(world.owner == i)])
        for i in range(len(world.sigma))
    ]
    return [shapely.get_coordinates(shapely.get_exterior_ring(union))[:-1] for union in wholes]


def draw_uncertain(
    world: UncertainWorldRecord,
    ax: Axes | None = None,
    *,
    offsets: Array | None = None,
    delta: float | None = None,
) -> list[Artist]:
    """Draw the expected world, margins for a chance delta dashed, and scenarios faintly.

    offsets : (n, m, 2), the scenarios.

    Examples
    --------
    >>> from kinoedu import UncertainWorld
    >>> from kinoedu.worlds import scenarios
    >>> from matplotlib import pyplot as plt
    >>> world = UncertainWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [((3, 3), 1)], 0.2)
    >>> artists = draw_uncertain(world, plt.gca(), offsets=scenarios(world, 20, rng=0), delta=0.05)
    >>> plt.close()
    """
    ax = axes_for(world.expected, ax)
    drawn = draw_world(world.expected, ax)
    faint: Style = {"edgecolors": palette.HIT, "alpha": 0.35, "linewidths": 0.9}
    dashed: Style = {"edgecolors": palette.INK, "linestyles": "--", "linewidths": 1.8}
    moved: list[Array] = []
    if offsets is not None:
        moved = [
            ring + by for number, ring in expected_outlines(world) for by in offsets[:, number]
        ]
    if moved:
        ghosts = PolyCollection(moved, facecolors="none", zorder=2, **faint)
        drawn.append(ax.add_collection(ghosts))
    if delta is not None:
        rings = margin_rings(world, delta)
        margins = PolyCollection(rings, facecolors="none", zorder=2.5, **dashed)
        drawn.append(ax.add_collection(margins))
    return drawn
