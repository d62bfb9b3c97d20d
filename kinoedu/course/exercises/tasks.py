"""The problems that planner exercises hand out, how they travel, and small ones that are traps."""

from pathlib import Path
from typing import Any, NamedTuple

from ...fields import Field
from ...problems import Problem, ProblemRecord, Recorder
from ...robots import Point
from ...scene_robots import described
from ...scenes import problem_from
from ...words import say
from ...worlds import PolygonWorld
from ..plain import WrongShape, wrong


class Asked(Recorder):
    """A problem as a student's planner meets it: it writes down what it is asked, and reads as the line that makes it."""

    QUESTIONS = ("sample", "steer", "is_free", "is_free_path")  # distances are asked too often to be written down

    def __init__(self, problem: ProblemRecord) -> None:
        super().__init__(problem)
        self.distance = problem.distance

    def __repr__(self) -> str:
        return f"problem_of({scene_of(self.problem)})"


def scene_of(problem: ProblemRecord) -> dict[str, Any]:
    """A problem as a scene has it."""
    ends = {"start": problem.start.tolist(), "goal": problem.goal.tolist()}
    margin = {"clearance": problem.clearance} if problem.clearance > 0.0 else {}
    return {"robot": described(problem.robot), "world": described(problem.world), **ends, **margin}


def problem_of(scene: dict[str, Any]) -> Asked:
    """The problem in a scene, as a planner exercise hands it out.

    >>> square = {"kind": "polygons", "boundary": [(0, 0), (4, 0), (4, 4), (0, 4)]}
    >>> problem = problem_of({"robot": {"kind": "point"}, "world": square, "start": [1, 1], "goal": [3, 2]})
    >>> problem.is_free_path(problem.start, problem.goal), problem.counts()
    (True, {'is_free_path': 1})
    """
    return Asked(problem_from(Field("scene", {"version": 1, **scene}, Path())))


class Task(NamedTuple):
    """The shape of a problem: it travels as a scene."""

    @property
    def words(self) -> str:
        """In words."""
        return say("planner.problem")

    def encode(self, value: Any) -> dict[str, Any]:
        """The scene."""
        if not isinstance(value, Asked):
            raise wrong(self.words, value)
        return scene_of(value.problem)

    def decode(self, data: Any) -> Asked:
        """A new problem, of which nothing has been asked."""
        try:
            return problem_of(data)
        except Exception:
            raise WrongShape(self.words) from None


SQUARE = [(0, 0), (10, 0), (10, 10), (0, 10)]


def in_room(start: Any, goal: Any, *obstacles: Any) -> Asked:
    """A point among obstacles, in a room of 10 x 10."""
    return Asked(Problem(Point(), PolygonWorld(SQUARE, obstacles), start, goal))


def box(x0: float, y0: float, x1: float, y1: float) -> list[tuple[float, float]]:
    """A box, counter-clockwise."""
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


ROOM = in_room((2, 3), (8, 7))
SAME = in_room((4, 5), (4, 5))
WALL = in_room((2, 2), (8, 2), box(4.5, 0, 5.5, 7))
THIN = in_room((2, 5), (8.4, 5), box(7.9, 3, 7.91, 7))  # between start and goal, near the goal, and thinner than any step
PASSAGE = in_room((2, 8), (8, 2), box(4, 0, 6, 4.3), box(4, 5.7, 6, 10))
SEALED = in_room((2, 2), (8, 8), box(6, 6, 10, 6.4), box(6, 6, 6.4, 10))
TRAPS = {"room": ROOM, "same": SAME, "wall": WALL, "thin": THIN, "passage": PASSAGE, "sealed": SEALED}
