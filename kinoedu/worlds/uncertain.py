"""Worlds whose obstacles are displaced by random offsets: isotropic Gaussians."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import InvalidParameter, InvalidPoint, InvalidWorld
from ..geometry.checks import Array, as_array, as_generator, as_list, integer, is_real
from ..geometry.convex import convex_parts
from ..geometry.grown import grow_piece
from ..geometry.parts import Parts, make_parts
from ..geometry.rings import as_ring
from ..support.constructors import Constructor, with_type_names
from ..support.text import shortened
from .polygon_world import PolygonWorld, PolygonWorldRecord, as_disc, is_pair_with_radius


@with_type_names
class UncertainWorldRecord(NamedTuple):
    """The record that `UncertainWorld` returns.

    expected : the world with every obstacle at its expected position. empty : without obstacles.
    parts : the convex pieces of the obstacles. owner : (k,), the obstacle of each piece.
    sigma : (m,), the standard deviation of each obstacle's offset in x, and in y.
    """

    expected: PolygonWorldRecord
    empty: PolygonWorldRecord
    parts: Parts
    owner: NDArray[np.int64]
    sigma: Array


class UncertainWorld(UncertainWorldRecord, metaclass=Constructor):
    """A workspace whose obstacles have uncertain positions. Its boundary is certain.

    Parameters
    ----------
    boundary : (n, 2), a simple polygon.
    obstacles : m simple polygons (k, 2), or pairs (centre, radius).
    sigma : the standard deviation of each obstacle's offset along any axis, one number for all or
        (m,); 0 for a certain obstacle. Each obstacle moves as a whole; the offsets are independent
        of each other.

    Returns
    -------
    UncertainWorldRecord

    Raises
    ------
    InvalidWorld, InvalidPolygon, InvalidPoint
        Where an argument is not valid.

    Examples
    --------
    >>> disc, triangle = ((3, 3), 1), [(5, 2), (7, 2), (6, 4)]
    >>> world = UncertainWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [disc, triangle], 0.2)
    >>> world.sigma, world.owner
    (array([0.2, 0.2]), array([0, 1]))
    """

    def __new__(  # type: ignore[misc]  # returns the record
        cls,
        boundary: ArrayLike,
        obstacles: Iterable[Any],
        sigma: ArrayLike,
    ) -> UncertainWorldRecord:
        given = as_list(obstacles, "obstacles")
        pieces = [
            convex_pieces(obstacle, f"obstacle {number}") for number, obstacle in enumerate(given)
        ]
        spread = as_array(sigma, "sigma")
        if (spread.ndim and spread.shape != (len(given),)) or (spread < 0.0).any():
            raise InvalidWorld(
                "sigma must be zero or more, one number or one for each of "
                f"{len(given)} obstacles, got {shortened(sigma)}"
            )
        owner = np.repeat(np.arange(len(given)), [len(own) for own, _ in pieces])
        radii = [radius for own, radius in pieces for _ in own]
        parts = make_parts([piece for own, _ in pieces for piece in own], radii)
        expected, empty = PolygonWorld(boundary, given), PolygonWorld(boundary)
        each = np.broadcast_to(spread, (len(given),)).copy()
        return UncertainWorldRecord(expected, empty, parts, owner, each)


def check_uncertain(world: object) -> None:
    """Raise InvalidParameter for another world."""
    if not isinstance(world, UncertainWorldRecord):
        raise InvalidParameter(f"the world must be an UncertainWorld, got {shortened(world)}")


def convex_pieces(obstacle: Any, name: str) -> tuple[list[Array], float]:
    """The convex pieces of an obstacle and their radius."""
    if is_pair_with_radius(obstacle):
        x, y, radius = as_disc(obstacle[0], obstacle[1], name)
        return [np.array([(x, y)])], float(radius)
    return convex_parts(as_ring(obstacle, name)), 0.0


def chance_margins(sigma: ArrayLike, delta: float) -> Array:
    """The distance to keep from each obstacle for a collision probability of at most delta.

    An offset with standard deviation sigma along each of two axes is longer than r with probability
    exp(-r^2 / (2 sigma^2)): its square over sigma^2 has the chi-square distribution with two
    degrees of freedom. Each of the m uncertain obstacles gets an equal fraction delta / m of the
    probability (union bound): r = sigma sqrt(-2 log(delta / m)).

    Returns
    -------
    (m,) array, 0 for certain obstacles.

    Raises
    ------
    InvalidPoint
        Where sigma is not finite numbers.
    InvalidParameter
        Where sigma is negative or not a row of numbers, or delta is not between 0 and 1.

    Examples
    --------
    >>> chance_margins([0.1, 0.1, 0.0], 0.05).round(4)
    array([0.2716, 0.2716, 0.    ])
    """
    spread = as_array(sigma, "sigma")
    if not is_real(delta) or not 0.0 < delta < 1.0:
        raise InvalidParameter(
            f"delta must be a probability between 0 and 1, both excluded, got {shortened(delta)}"
        )
    if spread.ndim != 1 or (spread < 0.0).any():
        raise InvalidParameter(
            f"sigma must be numbers of zero or more, shape (m,), got {shortened(sigma)}"
        )
    uncertain = max(int(np.count_nonzero(spread)), 1)
    return spread * math.sqrt(-2.0 * math.log(delta / uncertain))


def inflated(world: UncertainWorldRecord, delta: float) -> PolygonWorldRecord:
    """The world with every obstacle grown by its `chance_margins`.

    The collision probability of a path that is free in it is at most delta; any planner may be
    used. Rounded corners are replaced by polygons that are conservative, by up to half a percent of
    a margin.

    Returns
    -------
    PolygonWorldRecord

    Raises
    ------
    InvalidParameter
        Where `world` is not an UncertainWorld, or delta is not between 0 and 1.

    Examples
    --------
    >>> world = UncertainWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [((3, 3), 1)], 0.2)
    >>> inflated(world, 0.05).obstacles.radius.round(4)
    array([1.4895])
    """
    check_uncertain(world)
    margin, parts = chance_margins(world.sigma, delta)[world.owner], world.parts
    solids: list[Any] = []
    for k, (radius, m) in enumerate(zip(parts.radius, margin)):
        piece = parts.points[parts.first[k] : parts.first[k + 1]]
        solids.append((piece[0], radius + m) if radius > 0.0 else grow_piece(piece, float(m)))
    return PolygonWorld(ring_of(world.empty), solids)


def scenarios(world: UncertainWorldRecord, n: int, *, rng: int | np.random.Generator) -> Array:
    """Draw n scenarios: the offsets of all obstacles, shape (n, m, 2).

    The same seed gives the same scenarios (common random numbers), so that two paths are compared
    in the same ones.

    Returns
    -------
    (n, m, 2) array.

    Raises
    ------
    InvalidParameter
        Where `world` is not an UncertainWorld, or n or rng is not valid.
    """
    check_uncertain(world)
    count = integer(n, "n", least=0)
    return as_generator(rng).standard_normal((count, len(world.sigma), 2)) * world.sigma[:, None]


def scenario_world(world: UncertainWorldRecord, offsets: ArrayLike) -> PolygonWorldRecord:
    """One scenario as a world: every convex piece moved by the offset of its obstacle.

    Parameters
    ----------
    offsets : (m, 2).

    Returns
    -------
    PolygonWorldRecord

    Raises
    ------
    InvalidPoint
        Where offsets are not a point for each obstacle.
    InvalidParameter
        Where `world` is not an UncertainWorld.
    """
    check_uncertain(world)
    moves, count = as_array(offsets, "offsets"), len(world.sigma)
    if moves.shape != (count, 2) and (count or moves.size):
        raise InvalidPoint(f"offsets must have shape ({count}, 2), got {moves.shape}")
    parts, moves = world.parts, moves.reshape(count, 2)[world.owner]
    solids: list[Any] = []
    for k, (own, move) in enumerate(zip(parts.radius, moves)):
        piece = parts.points[parts.first[k] : parts.first[k + 1]] + move
        solids.append((piece[0], own) if own > 0.0 else piece)
    return PolygonWorld(ring_of(world.empty), solids)


def ring_of(world: PolygonWorldRecord) -> Array:
    """The boundary of a world without obstacles, as it was given."""
    return world.edges[::-1, :2].copy()
