"""The robot of the Bug family: a point with a contact sensor.

It knows its own place, and the direction and distance to the goal. It can move straight towards the
goal, and follow a wall that it touches. The obstacles are not accessible through this object.

Bullo & Smith, chapter 1.
"""

import numpy as np

from ...errors import InvalidWorld
from ...geometry.checks import Array
from ...geometry.exact import length
from ...geometry.segments import proper_crossing
from .contact import (
    ALONG_AFTER,
    ALONG_BEFORE,
    AT_CORNER,
    BLOCKED,
    REACHED,
    crossing_fraction,
    first_contact,
    sense_walls,
)
from .place import Place
from .walls import Walls


class BugRobot:
    """A robot among walls, on its way from start to goal, shape (2,) each.

    An algorithm may use `place`, `travelled` (the distance walked) and the methods without an
    underscore. `trail` records the walk.

    turn : +1 to turn right at a wall, which is then on the robot's left; -1 to turn left.
    """

    def __init__(self, walls: Walls, start: Array, goal: Array, turn: int) -> None:
        self._walls, self._start, self._goal, self._turn = walls, start, goal, turn
        self._readings = sense_walls(walls.points, walls.before, walls.after, start, goal)
        self._heading = turn
        self._places: dict[int, list[Place]] = {}
        self.place = self._at(*start, on_line=True, wall=-1)
        self.travelled = 0.0
        self.trail = Trail(self.place)

    def move_to_goal(self) -> bool:
        """Move straight towards the goal; returns False where a wall was hit before it."""
        walls, place = self._walls, self.place
        here = np.array([place.x, place.y])
        # on the start-goal line inside an edge, the line is that from the start, without rounding
        origin = self._start if place.on_line and place.along > 0.0 else here
        if place.wall >= 0:
            self.trail.leave()
            if self.trail.times_left(place) > 2:
                raise InvalidWorld(
                    "the walls lie closer together than floats of their size can represent; "
                    "move them apart"
                )
        edge_left = place.wall if place.along > 0.0 else -1
        how, which = first_contact(
            walls.points, walls.before, walls.after, origin, self._goal, edge_left
        )
        if how == REACHED:
            self._go(self._at(*self._goal, on_line=True, wall=-1), following=False)
            return True
        self._heading = self._turn
        hit = self._places_on(which)[0] if how == AT_CORNER else self._crossing(which, origin)
        self._go(hit, following=False)
        self.trail.hit()
        return False

    def can_move_to_goal(self) -> bool:
        """Whether the robot can move towards the goal, other than back the way it came."""
        place = self.place
        at_corner = place.wall >= 0 and place.along == 0.0
        back = ALONG_BEFORE if self._heading > 0 else ALONG_AFTER
        return place.is_open and not (at_corner and self._readings.opens[place.wall] == back)

    def follow_wall(self) -> None:
        """Follow the wall to the next place of interest.

        Such places are corners, hit points, points on the start-goal line, and points inside an
        edge that are nearest to the goal.
        """
        wall, along, walls = self.place.wall, self.place.along, self._walls
        if self._heading > 0:
            ahead = [place for place in self._places_on(wall) if place.along > along]
            place = ahead[0] if ahead else self._places_on(int(walls.after[wall]))[0]
        elif along > 0.0:
            place = [place for place in self._places_on(wall) if place.along < along][-1]
        else:
            place = self._places_on(int(walls.before[wall]))[-1]
        self._go(place, following=True)

    def turn_round(self) -> None:
        """Follow the wall in the other direction from now on, until the robot leaves it."""
        self._heading = -self._heading
        self.trail.keep()

    def _at(
        self,
        x: float,
        y: float,
        *,
        on_line: bool,
        wall: int,
        along: float = 0.0,
        made_of: tuple[Array, ...] = (),
    ) -> Place:
        points = tuple((float(p[0]), float(p[1])) for p in (self._goal, *made_of))
        distance = float(length(self._goal[0] - x, self._goal[1] - y))
        is_open = wall < 0 or (
            self._readings.faces[wall] if along > 0.0 else self._readings.opens[wall] != BLOCKED
        )
        return Place(
            float(x), float(y), distance, bool(on_line), bool(is_open), wall, float(along), points
        )

    def _go(self, place: Place, following: bool) -> None:
        self.travelled += float(length(place.x - self.place.x, place.y - self.place.y))
        self.place = place
        self.trail.append(place, following)

    def _places_on(self, wall: int) -> list[Place]:
        """The places of interest on an edge, in order, from the corner where it begins."""
        if wall not in self._places:
            readings, (a, b) = self._readings, self._ends(wall)
            inner = {}
            if readings.foot[wall] > 0.0:
                at, along = readings.foot_at[wall], readings.foot[wall]
                foot = self._at(*at, on_line=False, wall=wall, along=along, made_of=(a, b))
                inner[foot.along] = foot
            if readings.crossing[wall] > 0.0:
                at, along = readings.crossing_at[wall], readings.crossing[wall]
                crossing = self._at(
                    *at, on_line=True, wall=wall, along=along, made_of=(a, b, self._start)
                )
                inner[crossing.along] = crossing
            self._places[wall] = [
                self._at(*a, on_line=readings.on_line[wall], wall=wall),
                *(inner[along] for along in sorted(inner)),
            ]
        return self._places[wall]

    def _crossing(self, wall: int, origin: Array) -> Place:
        """The place where the line from origin to goal meets an edge, now of interest."""
        (a, b), places = self._ends(wall), self._places_on(wall)
        along = crossing_fraction(*a, *b, *origin, *self._goal)
        for place in places:
            if place.along == along:
                return place
        at = proper_crossing(a, b, origin, self._goal)
        hit = self._at(*at, on_line=False, wall=wall, along=along, made_of=(a, b, origin))
        places.append(hit)
        places.sort(key=lambda place: place.along)
        return hit

    def _ends(self, wall: int) -> tuple[Array, Array]:
        return self._walls.points[wall], self._walls.points[self._walls.after[wall]]


class Trail:
    """The record of a walk: the places in order, and whether a wall was followed to each of them.

    hits, leaves : the numbers of the places where a wall was hit or left.
    """

    def __init__(self, start: Place) -> None:
        self.places, self.following = [start], [False]
        self.hits, self.leaves = list[int](), list[int]()
        self._kept = True

    def append(self, place: Place, following: bool) -> None:
        """Append a place.

        The last place is dropped where nothing happened there and the wall was straight.
        """
        if not self._kept:
            del self.places[-1], self.following[-1]
        self.places.append(place)
        self.following.append(following)
        self._kept = (
            not following
            or place.along == 0.0
            or any(self.places[hit] == place for hit in self.hits)
        )

    def hit(self) -> None:
        """Record that a wall was hit at the last place."""
        self.keep()
        self.hits.append(len(self.places) - 1)

    def leave(self) -> None:
        """Record that the wall was left at the last place."""
        self.keep()
        self.leaves.append(len(self.places) - 1)

    def keep(self) -> None:
        """Keep the last place, even on a straight wall."""
        self._kept = True

    def times_left(self, place: Place) -> int:
        """How many times the wall was left at a place."""
        return sum(self.places[leave] == place for leave in self.leaves)
