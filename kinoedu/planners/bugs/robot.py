"""The robot of the Bug family: a point with a contact sensor.

It knows its own place, and the direction and distance to the goal. It can move straight towards the
goal, and follow a wall that it touches. The algorithms do not look at the obstacles.

Bullo & Smith, chapter 1.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...compiled import compiled, record
from ...errors import InvalidWorld
from ...geometry.checks import Array
from ...geometry.exact import length
from .contact import (
    ALONG_AFTER,
    ALONG_BEFORE,
    AT_CORNER,
    REACHED,
    WallReadings,
    first_contact,
    sense_walls,
)
from .place import Place
from .places import GOAL, START, Places, lay_places, place_at, place_of_hit
from .trail import (
    HITS,
    KEPT,
    SIZE,
    Trail,
    append,
    new_trail,
    record_hit,
    record_leave,
    times_left,
)
from .walls import Walls

HERE, HEADING = 0, 1  # the entries of `state`


@record
class BugRobot(NamedTuple):
    """A robot among walls, on its way from start to goal, shape (2,) each.

    An algorithm uses `place`, `travelled` (the distance walked) and the methods; the fields are the
    robot's own. `trail` records the walk.

    turn : +1 to turn right at a wall, which is then on the robot's left; -1 to turn left.
    state : (2,), the number of its place and its heading, +1 with the wall on its left.
    walked : (1,), the distance walked.
    """

    walls: Walls
    readings: WallReadings
    places: Places
    start: Array
    goal: Array
    turn: int
    state: NDArray[np.int64]
    walked: Array
    trail: Trail

    @property
    def place(self) -> Place:
        """Where the robot is."""
        return place_at(self.places, self.state[HERE])

    @property
    def travelled(self) -> float:
        """The distance walked."""
        return float(self.walked[0])

    def move_to_goal(self) -> bool:
        """Move straight towards the goal; returns False where a wall was hit before it."""
        walls, places, here = self.walls, self.places, self.state[HERE]
        wall, along = places.wall[here], places.along[here]
        # on the start-goal line inside an edge, the line is that from the start, without rounding
        origin = self.start if places.on_line[here] and along > 0.0 else places.at[here]
        if wall >= 0:
            leave_wall(self)
        how, which = first_contact(
            walls.points,
            walls.before,
            walls.after,
            origin,
            self.goal,
            wall if along > 0.0 else -1,
        )
        if how == REACHED:
            go(self, GOAL, False)
            return True
        self.state[HEADING] = self.turn
        if how == AT_CORNER:
            hit = places.first[which]
        else:
            hit = place_of_hit(places, walls, which, self.readings.faces[which], origin, self.goal)
        go(self, hit, False)
        record_hit(self.trail)
        return False

    def can_move_to_goal(self) -> bool:
        """Whether the robot can move towards the goal, other than back the way it came."""
        places, here = self.places, self.state[HERE]
        wall = places.wall[here]
        at_corner = wall >= 0 and places.along[here] == 0.0
        back = ALONG_BEFORE if self.state[HEADING] > 0 else ALONG_AFTER
        return bool(places.is_open[here]) and not (at_corner and self.readings.opens[wall] == back)

    def follow_wall(self) -> None:
        """Follow the wall to the next place of interest.

        Such places are corners, hit points, points on the start-goal line, and points inside an
        edge that are nearest to the goal.
        """
        here = self.state[HERE]
        if self.state[HEADING] > 0:
            go(self, self.places.ahead[here], True)
        else:
            go(self, self.places.behind[here], True)

    def turn_round(self) -> None:
        """Follow the wall in the other direction from now on, until the robot leaves it."""
        self.state[HEADING] = -self.state[HEADING]
        self.trail.counts[KEPT] = 1

    def was_hit_before(self) -> bool:
        """Whether an earlier motion towards the goal has ended here too."""
        trail = self.trail
        last = trail.counts[HITS] - 1
        for k in range(last):
            if trail.places[trail.hits[k]] == self.state[HERE]:
                return True
        return False


@compiled
def new_robot(walls: Walls, start: Array, goal: Array, turn: int) -> BugRobot:
    """A robot at the start."""
    readings = sense_walls(walls.points, walls.before, walls.after, start, goal)
    places = lay_places(walls, readings, start, goal)
    trail = new_trail(START, len(places.at))
    state = np.array([START, turn])
    own = start.copy(), goal.copy()
    return BugRobot(walls, readings, places, own[0], own[1], turn, state, np.zeros(1), trail)


@compiled
def leave_wall(robot: BugRobot) -> None:
    """Record that the robot leaves a wall.

    Raises
    ------
    InvalidWorld
        Where it leaves the wall there for the third time.
    """
    record_leave(robot.trail)
    if times_left(robot.trail, robot.state[HERE]) > 2:
        raise InvalidWorld(
            "the walls lie closer together than floats of their size can represent; move them apart"
        )


@compiled
def go(robot: BugRobot, place: int, following: bool) -> None:
    """Move to a place on a straight line."""
    at, here = robot.places.at, robot.state[HERE]
    robot.walked[0] += length(at[place, 0] - at[here, 0], at[place, 1] - at[here, 1])
    robot.state[HERE] = place
    append(robot.trail, robot.places, place, following)


@compiled
def corners_of(robot: BugRobot) -> Array:
    """The corners of the walk, (n, 2)."""
    trail = robot.trail
    return robot.places.at[trail.places[: trail.counts[SIZE]]]
