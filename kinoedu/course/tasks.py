"""The problems that planner exercises hand out, and how they travel."""

from itertools import groupby
from pathlib import Path
from typing import Any, NamedTuple

from ..files.scene_robots import described
from ..files.scenes import problem_from
from ..problems import ProblemRecord, Recorder
from ..support.json_fields import Field
from ..words import say
from .plain import WrongShape, wrong


class Asked(Recorder):
    """A problem as a student's planner meets it: it writes down what it is asked, and reads as the
    line that makes it.
    """

    QUESTIONS = (
        "sample",
        "steer",
        "is_free",
        "is_free_path",
    )  # distances are asked too often to be written down

    def __init__(self, problem: ProblemRecord) -> None:
        super().__init__(problem)
        self.distance = problem.distance

    def __repr__(self) -> str:
        scene = scene_of(self.problem)
        rows = scene["world"].get("rows")
        return (
            f"problem_of({scene})"
            if rows is None
            else f"problem_of({scene})".replace(repr(rows), in_runs(rows))
        )

    def anew(self) -> "Asked":
        """The same problem, of which nothing has been asked."""
        return type(self)(problem_of(scene_of(self.problem)).problem)


def in_runs(rows: list[str]) -> str:
    """A list as code, equal neighbours written once.

    >>> in_runs(["...", "...", ".@."])
    "[*['...'] * 2, '.@.']"
    """
    runs = [(row, len(list(alike))) for row, alike in groupby(rows)]
    return "[" + ", ".join(f"*[{row!r}] * {n}" if n > 1 else repr(row) for row, n in runs) + "]"


def scene_of(problem: ProblemRecord) -> dict[str, Any]:
    """A problem as a scene has it."""
    ends = {"start": problem.start.tolist(), "goal": problem.goal.tolist()}
    margin = {"clearance": problem.clearance} if problem.clearance > 0.0 else {}
    return {"robot": described(problem.robot), "world": described(problem.world), **ends, **margin}


def problem_of(scene: dict[str, Any]) -> Asked:
    """The problem in a scene, as a planner exercise hands it out.

    >>> square = {"kind": "polygons", "boundary": [[0, 0], [4, 0], [4, 4], [0, 4]]}
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
