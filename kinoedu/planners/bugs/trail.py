"""The record of a bug's walk."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...compiled import compiled
from ...errors import InvalidWorld
from .places import Places

MOST_PLACES = 10_000_000  # of a trail
SIZE, HITS, LEAVES, KEPT = range(4)


class Trail(NamedTuple):
    """The places of a walk in order, and whether a wall was followed to each of them.

    places : (n,), numbers of places.
    following : (n,).
    hits, leaves : the rows of the places where a wall was hit or left.
    counts : (4,), the numbers of rows, hits and leaves, and whether the last place is kept.
    """

    places: NDArray[np.int64]
    following: NDArray[np.bool_]
    hits: NDArray[np.int64]
    leaves: NDArray[np.int64]
    counts: NDArray[np.int64]


@compiled
def new_trail(start: int, places: int) -> Trail:
    """The trail of a robot that has not moved, with room for a walk among so many places."""
    # after a hit each place is passed at most twice, and each hit is at another place
    rows = min(2 * places * places, MOST_PLACES)
    trail = Trail(
        np.empty(rows, np.int64),
        np.empty(rows, np.bool_),
        np.empty(2 * places, np.int64),  # no wall is left at a place more than twice
        np.empty(2 * places, np.int64),
        np.zeros(4, np.int64),
    )
    trail.places[0], trail.following[0] = start, False
    trail.counts[SIZE], trail.counts[KEPT] = 1, 1
    return trail


@compiled
def append(trail: Trail, places: Places, place: int, following: bool) -> None:
    """Append a place.

    The last place is dropped where nothing happened there and the wall was straight.
    """
    counts = trail.counts
    if not counts[KEPT]:
        counts[SIZE] -= 1
    if counts[SIZE] == len(trail.places):
        raise InvalidWorld(
            "the walk of the bug has more than ten million corners; give obstacles with fewer"
        )
    trail.places[counts[SIZE]], trail.following[counts[SIZE]] = place, following
    counts[SIZE] += 1
    is_kept = not following or places.along[place] == 0.0 or was_hit(trail, place)
    counts[KEPT] = 1 if is_kept else 0


@compiled
def record_hit(trail: Trail) -> None:
    """Record that a wall was hit at the last place."""
    trail.hits[trail.counts[HITS]] = trail.counts[SIZE] - 1
    trail.counts[HITS] += 1
    trail.counts[KEPT] = 1


@compiled
def record_leave(trail: Trail) -> None:
    """Record that the wall was left at the last place, even on a straight wall."""
    trail.leaves[trail.counts[LEAVES]] = trail.counts[SIZE] - 1
    trail.counts[LEAVES] += 1
    trail.counts[KEPT] = 1


@compiled
def was_hit(trail: Trail, place: int) -> bool:
    """Whether a wall was hit at a place."""
    for k in range(trail.counts[HITS]):
        if trail.places[trail.hits[k]] == place:
            return True
    return False


@compiled
def times_left(trail: Trail, place: int) -> int:
    """How many times the wall was left at a place."""
    times = 0
    for k in range(trail.counts[LEAVES]):
        if trail.places[trail.leaves[k]] == place:
            times += 1
    return times
