"""A function run line by line: its code, its variables, and a picture of them that can be dragged.

The lines are traced as they run, so nothing is written twice: a reader's own function, or one of
this library, is shown as it is.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from copy import deepcopy
from inspect import signature
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...errors import InvalidParameter, KinoeduError
from ...geometry.checks import Array, as_array, as_point
from ...planners.tuning import integer
from ...problems import ProblemRecord, Recorder
from ...support.json_fields import JsonObject
from ...support.time_limit import TimeUp, run_within_processor_time
from ..core.canvas import Canvas
from ..core.drawing import Drawing
from ..core.scene import Scene, handle, make_scene, place_of, polygon
from ..planning.plans import check_in_plane, make_problem_scene, problem_in
from ..tracing.code_run import CodeRun, Draw, Look
from ..tracing.faults import describe_exception, describe_timeout
from ..tracing.variables import find_points

SECONDS = 2.0
COLOURS = ("start", "goal", "robot", "hit")  # of points that can be dragged
MARGIN = 0.15  # around the points, of their extent


def code_board(
    function: Callable[..., object],
    *given: Any,
    points: Mapping[str, str] | None = None,
    vectors: Mapping[str, str] | None = None,
    lines: Iterable[tuple[str, str]] = (),
    draw: Draw | None = None,
    fixed: Iterable[str] = (),
    window: tuple[ArrayLike, ArrayLike] | None = None,
    first: int | None = None,
    most: int = 1000,
) -> Canvas:
    """A function's code beside a picture of its variables; step through it, and drag its arguments.

    The line that has just run is lit. Click a line to go to the next time that it runs. Variables
    that are points, or lists of points, are drawn with their names; points that were passed in can
    be dragged, and so can polygons and the parts of a Problem. The motions that the function asks a
    Problem about are drawn too, blocked ones dashed.

    Parameters
    ----------
    function : a function written in Python, yours or this library's.
    given : its arguments. A point is an array or a tuple of two floats, a polygon an array (n, 2),
        n > 2. Points, polygons, lists of polygons and the parts of a Problem can be dragged; all
        else is passed on as a copy.
    points : further points to draw, each an expression in the function's variables, such as
        `{"q_near": "nodes[near]"}`.
    vectors : variables to draw as arrows, each with the name of the point where it begins.
    lines : pairs of names of points, to be joined by a dashed line.
    draw : a function of a dict of the variables, that returns layers for the moment after a line.
    fixed : the names of parameters that cannot be dragged.
    window : the corners of the part of the plane that is shown.
    first : the number of lines that have run when the board opens. Default: all.
    most : the number of lines that are shown; a longer run is shown up to there.

    Returns
    -------
    Canvas

    Raises
    ------
    InvalidParameter
        Where the source of the function is not known, the arguments do not fit it, or no argument
        and no window says which part of the plane to show.

    Examples
    --------
    >>> def midpoint(a, b):
    ...     middle = (a + b) / 2
    ...     return middle
    >>> code_board(midpoint, (0.0, 0.0), (4.0, 2.0))
    Canvas(midpoint returns (2, 1))
    """
    look = Look(
        points or {},
        vectors or {},
        tuple(lines),
        draw,
        None if first is None else integer(first, "first", least=0),
        integer(most, "most", least=1),
    )
    run = Steerable(function, given, frozenset(fixed), look)
    return Canvas(run.make_scene(window), run.answer)


class Steerable:
    """A function whose arguments are taken from a scene, where they can be dragged."""

    def __init__(
        self,
        function: Callable[..., object],
        given: Sequence[Any],
        fixed: frozenset[str],
        look: Look,
    ) -> None:
        self.function = getattr(function, "py_func", function)
        CodeRun(self.function, look)  # raises where there is no source, or a wrong expression
        self.given = bind(self.function, given)
        self.fixed, self.look = fixed, look

    def make_scene(self, window: tuple[ArrayLike, ArrayLike] | None) -> Scene:
        """The scene of the arguments that can be dragged."""
        problem = next((v for v in self.given.values() if isinstance(v, ProblemRecord)), None)
        lo, hi = find_window(window, self.given.values(), problem)
        plain = make_scene(lo, hi)
        scene = plain if problem is None else make_problem_scene(check_in_plane(problem))
        for kind, part in self.list_parts():
            scene[kind].append(part)
        return scene

    def list_parts(self) -> Iterator[tuple[str, JsonObject]]:
        """The handles and polygons of the arguments."""
        number = 0
        for name, value in self.given.items():
            if name in self.fixed:
                continue
            if is_plane_point(value):
                yield "handles", handle(name, value, colour=COLOURS[number % len(COLOURS)])
                number += 1
            for part, ring in name_rings(name, value).items():
                yield "polygons", polygon(part, [ring])

    def arguments(self, scene: Scene, run: CodeRun) -> list[Any]:
        """The arguments, with everything where the scene has it."""
        rings = {one["name"]: np.array(one["rings"][0]) for one in scene["polygons"]}

        def place(name: str, value: Any) -> Any:
            if isinstance(value, ProblemRecord):
                recorder = Recorder(problem_in(self.without_own(scene), value))
                recorder.log = run.log
                return recorder
            if name in self.fixed:
                return deepcopy(value)
            if is_plane_point(value):
                return place_of(scene, name)
            found = [rings[part] for part in name_rings(name, value)]
            if not found:
                return deepcopy(value)
            return found if isinstance(value, list) else found[0]

        return [place(name, value) for name, value in self.given.items()]

    def without_own(self, scene: Scene) -> Scene:
        """A scene without the polygons that are arguments, so that those of a problem are left."""
        own = {part for name, value in self.given.items() for part in name_rings(name, value)}
        return {**scene, "polygons": [one for one in scene["polygons"] if one["name"] not in own]}

    def answer(self, scene: Scene) -> Drawing:
        """Run the function on the arguments of a scene, and draw how it ran."""
        run = CodeRun(self.function, self.look)
        arguments, fault = self.arguments(scene, run), ""

        def work() -> None:
            with run.trace:
                self.function(*arguments)

        try:
            run_within_processor_time(SECONDS, work)
        except TimeUp as over:
            fault = describe_timeout(over, run.name)
        except Exception as error:  # the function's own
            fault = describe_exception(error, run.name)
        return run.draw(fault=fault, dragged=[one["name"] for one in scene["handles"]])


def bind(function: Callable[..., object], given: Sequence[Any]) -> dict[str, Any]:
    """The arguments by the names of their parameters.

    Raises
    ------
    InvalidParameter
        Where they do not fit the function.
    """
    try:
        bound = signature(function).bind(*given)
    except TypeError as error:
        name = getattr(function, "__name__", "?")
        raise InvalidParameter(
            f"the arguments do not fit {name}{signature(function)}: {error}"
        ) from error
    return dict(bound.arguments)


def is_plane_point(value: object) -> bool:
    """Whether an argument is a point of the plane."""
    return find_points(value)[1]


def name_rings(name: str, value: object) -> dict[str, Array]:
    """The polygons that an argument is, or holds as a list, by their names on the board."""
    rings: Any = value if isinstance(value, list) else [value]
    try:
        arrays = [as_array(ring, name) for ring in rings]
    except KinoeduError:
        return {}
    if not all(ring.ndim == 2 and ring.shape[1] == 2 and len(ring) > 2 for ring in arrays):
        return {}
    names = [f"{name} {k}" for k in range(len(arrays))] if isinstance(value, list) else [name]
    return dict(zip(names, arrays, strict=True))


def find_window(
    window: tuple[ArrayLike, ArrayLike] | None,
    values: Iterable[Any],
    problem: ProblemRecord | None,
) -> tuple[Array, Array]:
    """The corners of the part of the plane that is shown.

    Raises
    ------
    InvalidParameter
        Where nothing says which part that is.
    """
    if window is not None:
        return as_point(window[0], "window"), as_point(window[1], "window")
    if problem is not None:
        return problem.world.lo, problem.world.hi
    found = list[Array]()
    for value in values:
        is_point = is_plane_point(value)
        found += [np.array([value], float)] if is_point else name_rings("", value).values()
    if not found:
        raise InvalidParameter(
            "no argument is a point, a polygon or a Problem: pass the corners of a window, such as "
            "window=((0, 0), (10, 10))"
        )
    everything = np.concatenate(found)
    lo, hi = everything.min(axis=0), everything.max(axis=0)
    margin = MARGIN * max(float((hi - lo).max()), 1e-9 + float(np.abs(hi).max()) * 1e-3)
    return lo - margin, hi + margin
