"""A function run line by line: its code, its variables, and a picture of them that can be dragged.

The lines are traced as they run, so nothing is written twice: a reader's own function, or one of
this library, is shown as it is.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from inspect import Parameter, signature
from itertools import chain
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...errors import InvalidParameter
from ...geometry.checks import Array, as_point
from ...planners.tuning import integer
from ...support.faults import describe_exception, describe_timeout
from ...support.time_limit import TimeUp, run_within_processor_time
from ..core.canvas import Canvas
from ..core.drawing import Drawing
from ..core.scene import Scene, make_scene
from ..tracing.code_run import CodeRun, Draw, Look
from .arguments import COLOURS, Argument, ProblemArgument, find_robot, make_arguments

SECONDS = 2.0
MARGIN = 0.15  # around the points, of their extent


def code_board(
    function: Callable[..., object],
    *given: Any,
    points: Mapping[str, str] | None = None,
    vectors: Mapping[str, str] | None = None,
    lines: Iterable[tuple[str, str]] = (),
    circles: Mapping[str, str] | None = None,
    draw: Draw | None = None,
    fixed: Iterable[str] = (),
    areas: Iterable[str] = (),
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
        n > 2. Points, polygons, lists of polygons, the nodes of an embedded Graph and the parts of
        a Problem can be dragged; all else is passed on as a copy. An array (rows, columns) of
        booleans is a bitmap, drawn beneath. Where a robot that turns is passed in, alone or in a
        Problem, its body is drawn at each variable (x, y, theta), and those that are passed in can
        be dragged and turned.
    points : further points to draw, each an expression in the function's variables, such as
        `{"q_near": "nodes[near]"}`.
    vectors : variables to draw as arrows, each with the name of the point where it begins.
    lines : pairs of names of points, to be joined by a dashed line.
    circles : circles to draw: for the name of the point in the middle the radius, an expression,
        such as `{"q": "distance"}`.
    draw : a function of a dict of the variables, that returns layers for the moment after a line.
    fixed : the names of parameters that cannot be dragged.
    areas : the names of parameters that are polygons and no obstacles.
    window : the corners of the part of the plane that is shown.
    first : the number of lines that have run when the board opens. Default: all.
    most : the number of lines that are shown; a longer run is shown up to there.

    Returns
    -------
    Canvas

    Raises
    ------
    InvalidParameter
        Where the source of the function is not known, the arguments do not fit it, it has no
        variable or parameter of a name, or no argument and no window says which part of the plane
        to show.

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
        circles or {},
        draw,
        None if first is None else integer(first, "first", least=0),
        integer(most, "most", least=1),
    )
    run = Steerable(function, given, frozenset(fixed), frozenset(areas), look)
    return Canvas(run.make_scene(window), run.answer, free=run.free)


class Steerable:
    """A function whose arguments are taken from a scene, where they can be dragged."""

    def __init__(
        self,
        function: Callable[..., object],
        given: Sequence[Any],
        fixed: frozenset[str],
        areas: frozenset[str],
        look: Look,
    ) -> None:
        self.function = getattr(function, "py_func", function)
        named = bind(self.function, given)
        self.arguments = make_arguments(named, fixed, areas)
        self.look = replace(look, robot=find_robot(named.values()))
        run = CodeRun(self.function, self.look)  # raises without a source, or for wrong expressions
        check_names("parameter", [*fixed, *areas], signature(self.function).parameters, run)
        check_names("variable", names_drawn(look), [*names_of(run), *look.points], run)

    @property
    def free(self) -> NDArray[np.bool_] | None:
        """The bitmap beneath the picture."""
        return next((one.free for one in self.arguments if one.free is not None), None)

    def make_scene(self, window: tuple[ArrayLike, ArrayLike] | None) -> Scene:
        """The scene of the arguments that can be dragged."""
        scenes = (one.make_scene() for one in self.arguments)
        scene = next((found for found in scenes if found is not None), None)
        if scene is None or (window is not None and self.free is None):
            plain = make_scene(*find_window(window, self.arguments))
            scene = plain if scene is None else {**scene, "lo": plain["lo"], "hi": plain["hi"]}
        number = 0
        for one in self.arguments:
            parts = one.list_parts(COLOURS[number % len(COLOURS)])
            for kind, items in parts.items():
                scene[kind] += items
            number += "handles" in parts
        return scene

    def run(self, scene: Scene) -> tuple[CodeRun, str]:
        """A run of the function on the arguments of a scene, and what was wrong with it."""
        run = CodeRun(self.function, self.look)
        for one in self.arguments:
            if isinstance(one, ProblemArgument):
                one.log = run.log
        values = [one.value(scene) for one in self.arguments]

        def work() -> None:
            with run.trace:
                self.function(*values)

        try:
            run_within_processor_time(SECONDS, work)
        except TimeUp as over:
            return run, describe_timeout(over, run.name)
        except Exception as error:  # the function's own
            return run, describe_exception(error, run.name)
        return run, ""

    def answer(self, scene: Scene) -> Drawing:
        """Run the function on the arguments of a scene, and draw how it ran."""
        run, fault = self.run(scene)
        if fault and not run.trace.moments:
            # Python 3.11 was seen to hang once before the first line of a traced call
            run, fault = self.run(scene)
        names = [item["name"] for item in scene["handles"]]
        drawing = run.draw(fault=fault, dragged=names)
        layers = [layer for one in self.arguments for layer in one.draw(scene)]
        moved = [place for one in self.arguments for place in one.list_places(scene).items()]
        return replace(
            drawing,
            layers=[*layers, *drawing.layers],
            places=[("handle", names.index(name), at.tolist()) for name, at in moved],
        )


def bind(function: Callable[..., object], given: Sequence[Any]) -> dict[str, Any]:
    """The arguments by the names of their parameters; those of `*points` are "points 0", ...

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
    named: dict[str, Any] = {}
    for name, value in bound.arguments.items():
        many = bound.signature.parameters[name].kind is Parameter.VAR_POSITIONAL
        named |= {f"{name} {k}": one for k, one in enumerate(value)} if many else {name: value}
    return named


def names_drawn(look: Look) -> Iterable[str]:
    """The names of variables that a look draws in a way of its own."""
    return [*look.circles, *look.vectors, *look.vectors.values(), *chain.from_iterable(look.lines)]


def names_of(run: CodeRun) -> Iterable[str]:
    """The names of all variables that a function can have while it runs."""
    code = run.trace.source.code
    return [*code.co_varnames, *code.co_cellvars, *code.co_freevars]


def check_names(kind: str, given: Iterable[str], known: Iterable[str], run: CodeRun) -> None:
    """Refuse names that a function does not have: nothing would be drawn, without a word."""
    names = list(known)
    for name in given:
        if name not in names:
            raise InvalidParameter(
                f"{run.name} has no {kind} {name!r}; it has {', '.join(names) or 'none'}"
            )


def find_window(
    window: tuple[ArrayLike, ArrayLike] | None, arguments: Iterable[Argument]
) -> tuple[Array, Array]:
    """The corners of the part of the plane that is shown.

    Raises
    ------
    InvalidParameter
        Where nothing says which part that is.
    """
    if window is not None:
        return as_point(window[0], "window"), as_point(window[1], "window")
    everything = np.concatenate([one.points() for one in arguments] or [np.empty((0, 2))])
    if not len(everything):
        raise InvalidParameter(
            "no argument is a point, a polygon or a Problem: pass the corners of a window, such as "
            "window=((0, 0), (10, 10))"
        )
    lo, hi = everything.min(axis=0), everything.max(axis=0)
    margin = MARGIN * max(float((hi - lo).max()), 1e-9 + float(np.abs(hi).max()) * 1e-3)
    return lo - margin, hi + margin
