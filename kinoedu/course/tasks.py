"""Problems that planner exercises give to students, and their encoding."""

import json
from functools import lru_cache
from itertools import groupby
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from ..files.scene_robots import describe_for_scene
from ..files.scenes import parse_problem
from ..geometry.checks import Array
from ..messages import get_message
from ..problems import ProblemRecord, Recorder
from ..support.generators import plain_state
from ..support.json_fields import Field, Json, JsonObject
from .lent_problem import LentProblem, Metric
from .plain import WrongShape, wrong_shape


class Draw(NamedTuple):
    """One call of `sample`: its generator, the state of it before and after, and the sample."""

    generator: object
    before: object
    after: object
    sample: Array


class StudentProblem(Recorder):
    """A problem as a student's planner sees it; it records the planner's calls.

    Its repr is the line of code that makes it.

    Attributes
    ----------
    draws : what `sample` drew, in order.
    """

    # distance is not recorded: it is called too often
    QUERIES = ("sample", "steer", "is_free", "is_free_path")
    # what a student's planner may use beside start, goal and distance
    QUESTIONS: tuple[str, ...] = ("sample", "steer", "is_free", "is_free_path", "is_semi_free_path")
    NUMBERS: tuple[str, ...] = ()

    def __init__(self, problem: ProblemRecord) -> None:
        super().__init__(problem)
        self.metric: Metric = problem.space
        self.distance = problem.distance
        self.draws: list[Draw] = []

    def __repr__(self) -> str:
        scene = scene_of(self.problem)
        rows = scene["world"].get("rows")
        code = f"problem_of({scene})"
        return code if rows is None else code.replace(repr(rows), runs_as_code(rows))

    def sample(self, rng: Any) -> Array:
        """A configuration drawn from the whole space, free or not."""
        before = state_of(rng)
        q = np.asarray(self._recorded("sample", self.problem.sample)(rng))
        self.draws.append(Draw(rng, before, state_of(rng), q.copy()))
        return q

    def ask(self, name: str, *given: Any) -> Any:
        """Answer a question of a student's planner.

        Raises
        ------
        AttributeError
            Where it is not one of QUESTIONS.
        """
        if name == "__repr__":
            return repr(self)
        if name not in self.QUESTIONS:
            raise AttributeError(name)
        return getattr(self, name)(*given)

    def lend(self) -> LentProblem:
        """The problem as a student's planner has it."""
        numbers = {name: getattr(self, name) for name in self.NUMBERS}
        ends = self.start, self.goal
        return LentProblem(self.ask, self.QUESTIONS, numbers, ends, self.metric)

    def fresh_copy(self) -> "StudentProblem":
        """The same problem without recorded calls."""
        return type(self)(self.problem)


def state_of(rng: Any) -> object:
    """State of a generator, which can be compared.

    For an object without one, it is an object that equals no state.
    """
    return plain_state(getattr(getattr(rng, "bit_generator", None), "state", object()))


def runs_as_code(rows: list[str]) -> str:
    """Write a list as code, with equal neighbours written once.

    >>> runs_as_code(["...", "...", ".@."])
    "[*['...'] * 2, '.@.']"
    """
    runs = [(row, len(list(alike))) for row, alike in groupby(rows)]
    return "[" + ", ".join(f"*[{row!r}] * {n}" if n > 1 else repr(row) for row, n in runs) + "]"


def scene_of(problem: ProblemRecord) -> JsonObject:
    """Scene of a problem."""
    ends = {"start": problem.start.tolist(), "goal": problem.goal.tolist()}
    margin = {"clearance": problem.clearance} if problem.clearance > 0.0 else {}
    return {
        "robot": describe_for_scene(problem.robot),
        "world": describe_for_scene(problem.world),
        **ends,
        **margin,
    }


def problem_of(scene: dict[str, Any]) -> StudentProblem:
    """Problem of a scene, as a planner exercise gives it to a student.

    >>> square = {"kind": "polygons", "boundary": [[0, 0], [4, 0], [4, 4], [0, 4]]}
    >>> ends = {"start": [1, 1], "goal": [3, 2]}
    >>> problem = problem_of({"robot": {"kind": "point"}, "world": square, **ends})
    >>> problem.is_free_path(problem.start, problem.goal), problem.counts()
    (True, {'is_free_path': 1})
    """
    return StudentProblem(read_problem(scene))


def read_problem(scene: dict[str, Any]) -> ProblemRecord:
    """The problem itself of a scene."""
    return parse_problem(Field("scene", {"version": 1, **scene}, Path()))


@lru_cache(maxsize=128)
def decode_problem(text: str) -> ProblemRecord:
    """The problem of a scene in JSON; cached, because a case is decoded for each of its calls."""
    return read_problem(json.loads(text))


class ProblemShape(NamedTuple):
    """The shape of a problem, encoded as a scene."""

    @property
    def description(self) -> str:
        """Description of the shape, for messages."""
        return get_message("planner.problem")

    def encode(self, value: object) -> JsonObject:
        """Encode a problem as its scene. Raises WrongShape."""
        if not isinstance(value, StudentProblem):
            raise wrong_shape(self.description, value)
        return scene_of(value.problem)

    def decode(self, data: Json) -> StudentProblem:
        """Decode into a new problem without recorded calls. Raises WrongShape."""
        try:
            return self.wrap(decode_problem(json.dumps(data)))
        except Exception:
            raise WrongShape(self.description) from None

    def wrap(self, problem: ProblemRecord) -> StudentProblem:
        """The problem as a student's program sees it."""
        return StudentProblem(problem)
