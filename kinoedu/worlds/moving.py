"""Worlds with obstacles that move along known straight lines at given times, without rotating."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..compiled import compiled
from ..errors import InvalidWorld
from ..geometry.checks import Array, as_array, as_list, as_number
from ..geometry.convex import convex_parts
from ..geometry.parts import Parts, make_parts
from ..geometry.rings import as_ring
from ..support.constructors import Constructor, with_type_names
from ..support.text import shortened
from .polygon_world import PolygonWorldRecord, as_disc


@with_type_names
class Mover(NamedTuple):
    """The record that `Moving` returns: an obstacle and its motion.

    outline : (n, 2), in its own frame; or, for a disc, its centre, with `radius`.
    times, places : (k,) and (k, 2), the positions of the frame's origin.
    """

    outline: Array
    radius: float
    times: Array
    places: Array

    def at(self, t: float) -> Array:
        """The position of the frame's origin at time t, shape (2,).

        Raises
        ------
        InvalidPoint
            Where t is not one finite number.
        """
        time = as_number(t, "t")
        return np.array(position_at(self.times, self.places, 0, len(self.times), time))


@with_type_names
class MovingWorldRecord(NamedTuple):
    """The record that `MovingWorld` returns. Configurations in it are (x, y, t).

    still : the world of the obstacles that do not move.
    shapes : the convex pieces of the moving obstacles, each in its own frame. The origin of piece i
        is at places[k] at times[k] for knots[i, 0] <= k < knots[i, 1].
    outlines : the whole outlines of the moving obstacles, for drawing.
    owner : (pieces,), the number of the obstacle to which each piece belongs.
    lo, hi : the corners of the bounding box.
    """

    still: PolygonWorldRecord
    shapes: Parts
    times: Array
    places: Array
    knots: NDArray[np.int64]
    outlines: Parts
    owner: NDArray[np.int64]
    lo: Array
    hi: Array


class Moving(Mover, metaclass=Constructor):
    """An obstacle that moves along straight lines from place to place, without rotating.

    Before the first time it stands at the first place, after the last time at the last.

    Parameters
    ----------
    shape : a simple polygon (n, 2) in its own frame; or one number, the radius of a disc about the
        frame's origin.
    times : (k,), increasing, k >= 1.
    places : (k, 2), the position of the frame's origin at each time.

    Returns
    -------
    Mover

    Raises
    ------
    InvalidWorld, InvalidPolygon, InvalidPoint
        Where an argument is not valid.

    Examples
    --------
    >>> Moving(0.5, [0, 4], [(0, 0), (8, 0)]).at(1.0)
    array([2., 0.])
    """

    def __new__(cls, shape: ArrayLike, times: ArrayLike, places: ArrayLike) -> Mover:  # type: ignore[misc]  # returns the record
        moments, stops = as_array(times, "times"), as_array(places, "places")
        if moments.ndim != 1 or len(moments) == 0 or stops.shape != (len(moments), 2):
            raise InvalidWorld(
                "times (k,) and places (k, 2) must have the same k >= 1, got shapes "
                f"{moments.shape} and {stops.shape}"
            )
        if not (np.diff(moments) > 0.0).all():
            raise InvalidWorld(
                "times must increase from one place to the next, got "
                f"{shortened(moments.tolist())}; sort them"
            )
        body = as_array(shape, "shape")
        if body.ndim == 0:
            disc = as_disc((0.0, 0.0), float(body), "a moving disc")
            return Mover(np.zeros((1, 2)), float(disc[2]), moments, stops)
        return Mover(as_ring(body, "a moving obstacle"), 0.0, moments, stops)


class MovingWorld(MovingWorldRecord, metaclass=Constructor):
    """A PolygonWorld with moving obstacles; they may overlap fixed obstacles and each other.

    Parameters
    ----------
    still : a PolygonWorld. movers : results of `Moving`.

    Returns
    -------
    MovingWorldRecord

    Raises
    ------
    InvalidWorld
        Where an argument is of another type.

    Examples
    --------
    >>> from kinoedu import PolygonWorld
    >>> hall = PolygonWorld([(0, 0), (10, 0), (10, 6), (0, 6)])
    >>> cart = Moving([(-1, -1), (1, -1), (1, 1), (-1, 1)], [0, 5], [(5, -2), (5, 8)])
    >>> world = MovingWorld(hall, [cart])
    >>> world.knots
    array([[0, 2]])
    """

    def __new__(cls, still: PolygonWorldRecord, movers: Iterable[Any]) -> MovingWorldRecord:  # type: ignore[misc]  # returns the record
        if not isinstance(still, PolygonWorldRecord):
            raise InvalidWorld(
                f"the fixed obstacles must be a PolygonWorld, got {shortened(still)}"
            )
        given = as_list(movers, "movers")
        for mover in given:
            if not isinstance(mover, Mover):
                raise InvalidWorld(
                    f"expected movers Moving(shape, times, places), got {shortened(mover)}"
                )
        pieces = [
            [mover.outline] if mover.radius > 0.0 else convex_parts(mover.outline)
            for mover in given
        ]
        owner = np.repeat(np.arange(len(given)), [len(own) for own in pieces])
        ends = np.cumsum([0, *(len(mover.times) for mover in given)])
        radii = [mover.radius for mover in given]
        return MovingWorldRecord(
            still,
            make_parts([piece for own in pieces for piece in own], [radii[k] for k in owner]),
            np.concatenate([np.empty(0), *(mover.times for mover in given)]),
            np.concatenate([np.empty((0, 2)), *(mover.places for mover in given)]),
            np.column_stack([ends[:-1], ends[1:]])[owner].reshape(-1, 2),
            make_parts([mover.outline for mover in given], radii),
            owner,
            still.lo,
            still.hi,
        )


def movers_at(world: MovingWorldRecord, t: float) -> list[tuple[Array, float]]:
    """The outline (n, 2) and the radius of each moving obstacle at time t.

    The outline of a disc is its centre (1, 2); the radius of a polygon is 0.

    Raises
    ------
    InvalidWorld
        Where the world is of another type.
    InvalidPoint
        Where t is not one finite number.
    """
    if not isinstance(world, MovingWorldRecord):
        raise InvalidWorld(f"expected a MovingWorld, got {shortened(world)}")
    time = as_number(t, "t")
    shown, parts = [], world.outlines
    for k in range(len(parts.radius)):
        begin, end = world.knots[np.flatnonzero(world.owner == k)[0]]
        offset = position_at(world.times, world.places, int(begin), int(end), time)
        shown.append(
            (parts.points[parts.first[k] : parts.first[k + 1]] + offset, float(parts.radius[k]))
        )
    return shown


@compiled
def position_at(times: Array, places: Array, begin: int, end: int, t: float) -> tuple[float, float]:
    """The position at time t of an origin that is at places[k] at times[k], begin <= k < end."""
    if t <= times[begin]:
        return places[begin, 0], places[begin, 1]
    for k in range(begin + 1, end):
        if t < times[k]:
            fraction = (t - times[k - 1]) / (times[k] - times[k - 1])
            x, y = places[k - 1, 0], places[k - 1, 1]
            return x + fraction * (places[k, 0] - x), y + fraction * (places[k, 1] - y)
    return places[end - 1, 0], places[end - 1, 1]
