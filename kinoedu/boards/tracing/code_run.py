"""A run of a function whose lines are traced, and the drawing of it: one step for each line."""

from __future__ import annotations

import time
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from inspect import CO_GENERATOR
from typing import Any, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from ...compiled import in_python
from ...errors import InvalidParameter
from ...figures.robots import Outlined
from ...geometry.checks import Array
from ...messages import get_message
from ...problems import ProblemRecord, Question, Recorder
from ...support.line_trace import RAISED, Enough, LineTrace, Moment
from ...support.text import shortened
from ..core.drawing import Drawing, Layer, edges
from ..core.listing import Listing, read_code
from .moments import (
    Noted,
    draw_bodies,
    draw_circles,
    draw_lines,
    draw_moments,
    draw_variables,
    draw_vectors,
)
from .questions import FirstQuestions, draw_questions
from .rounds import Names, find_rounds, with_expressions
from .variables import (
    compile_expressions,
    compute_radii,
    evaluate,
    format_short,
    note_variables,
)

T = TypeVar("T")
Draw = Callable[[dict[str, Any]], Iterable[Layer]]
SECONDS = 1.0  # of processor time for the lines of one of this library's functions
FEW = 3  # questions of a line that are drawn thick
COLOURS = ("tree", "path", "cut", "robot", "roadmap")  # of variables, in the order they appear


@dataclass(frozen=True)
class Look:
    """What the picture shows of a function's variables, as `code_board` takes it.

    The body of `robot` is drawn at each variable that is a pose. `names` are further names that the
    expressions may use, and `colours` those of some variables; the others get one by their order.
    The variables in `hidden` are neither listed nor drawn.
    `progress` is an expression too: the step of the board's own drawing that a line belongs to.
    Without it that is the number of questions asked so far.
    """

    points: Mapping[str, str] = field(default_factory=dict)
    vectors: Mapping[str, str] = field(default_factory=dict)
    lines: Sequence[tuple[str, str]] = ()
    circles: Mapping[str, str] = field(default_factory=dict)
    draw: Draw | None = None
    first: int | None = None
    most: int = 1000
    robot: Outlined | None = None
    names: Mapping[str, Any] = field(default_factory=dict)
    colours: Mapping[str, str] = field(default_factory=dict)
    progress: str = ""
    hidden: Collection[str] = ()


class Note(NamedTuple):
    """What is kept after a line.

    Attributes
    ----------
    variables : those that a reader wants to see, by name.
    radii : of the circles that have one now, by the names of their points.
    drawn : the layers of the reader's own `draw`.
    asked : the number of questions so far.
    progress : the step of the board's own drawing, 0 where the expression has no value yet.
    """

    variables: Noted
    radii: Mapping[str, float]
    drawn: Sequence[Layer]
    asked: int
    progress: float = 0.0


class CodeRun:
    """One run of a function; `trace` is the context in which it is to be called.

    Parameters
    ----------
    ends : whether the call is given up after the lines that are shown.

    Attributes
    ----------
    log : the questions that the function asks a Recorder.
    """

    def __init__(self, function: Callable[..., object], look: Look, *, ends: bool = False) -> None:
        self.name, self.look = getattr(function, "__name__", "?"), look
        self.points = compile_expressions(look.points)
        self.circles = compile_expressions(look.circles)
        self.progress = compile_expressions({"step": look.progress} if look.progress else {})
        self.log = FirstQuestions()
        self.trace = LineTrace(function, self.note, most=look.most, ends=ends)
        self.over = time.thread_time() + SECONDS if ends else float("inf")

    def record(self, problem: ProblemRecord) -> Recorder:
        """A recorder of a problem, whose questions are drawn."""
        recorder = Recorder(problem)
        recorder.log = self.log
        return recorder

    def note(self, local: dict[str, Any], names: dict[str, Any]) -> Note:
        """What is kept after a line; when the time is over, it is the last one."""
        if time.thread_time() > self.over:
            self.trace.most = len(self.trace.moments)
        names = {**names, **self.look.names}
        seen = {name: value for name, value in local.items() if name not in self.look.hidden}
        values = {**seen, **evaluate(self.points, local, names)}
        progress = compute_radii(self.progress, local, names).get("step", 0.0)
        return Note(
            note_variables(values),
            compute_radii(self.circles, values, names),
            self.draw_own(local),
            len(self.log),
            progress if self.progress else len(self.log),
        )

    def draw_own(self, local: dict[str, Any]) -> list[Layer]:
        """The layers of the reader's own `draw` after a line."""
        drawn = [] if self.look.draw is None else self.look.draw(dict(local))
        if not isinstance(drawn, Iterable):
            raise InvalidParameter(f"draw must return a list of layers, got {shortened(drawn)}")
        return list(drawn)

    @property
    def steps(self) -> Array:
        """For each line that is shown, the step of the board's own drawing that it belongs to."""
        code = read_code(self.trace.source)
        notes = [moment.note for moment in self.trace.moments if moment.line in code]
        return np.maximum.accumulate([0.0 if note is None else note.progress for note in notes])

    def draw(self, *, fault: str = "", dragged: Collection[str] = ()) -> Drawing:
        """The code, the variables and the questions, step by step.

        Parameters
        ----------
        fault : what was wrong with the run, in words.
        dragged : the names of variables that the scene shows.
        """
        code = read_code(self.trace.source)
        moments = [moment for moment in self.trace.moments if moment.line in code]
        last = Note({}, {}, [], len(self.log))  # of a line that did not end
        kept = [moment.note or last for moment in moments]
        values = [one.variables for one in kept]
        old = self.find_old(moments, values)
        notes = [without(note, names) for note, names in zip(values, old)]
        robot = self.look.robot
        chosen = choose_colours(notes, dragged, with_poses=robot is not None)
        colours = {name: self.look.colours.get(name, colour) for name, colour in chosen.items()}
        layers = [
            *draw_lines(notes, self.look.lines),  # beneath the motion that is asked about
            *draw_asked(self.log[:], [one.asked for one in kept]),
            *draw_moments([one.drawn for one in kept]),
            *draw_circles(notes, [one.radii for one in kept]),
            *draw_vectors(notes, self.look.vectors, colours),
            *draw_variables(notes, without(colours, self.look.vectors)),
            *([] if robot is None else draw_bodies(notes, robot, colours)),
        ]
        listing = Listing(
            [*code.values()],
            [[*code].index(moment.line) for moment in moments],
            [list_values(moment, note) for moment, note in zip(moments, values)],
            colours,
            old=old,
            legend=get_message("board.code.asked") if self.log else "",
        )
        first = self.look.first
        return Drawing(
            layers,
            text=self.describe(),
            warning=fault,
            total=len(moments),
            unit=get_message("board.code.lines"),
            listing=listing,
            first=None if first is None else min(first, len(moments)),
        )

    def find_old(self, moments: Sequence[Moment], notes: Sequence[Noted]) -> list[Names]:
        """The variables that have a value of an earlier round after each line."""
        changed = [
            {name for name, one in note.items() if name in last and last[name].text != one.text}
            for last, note in zip([{}, *notes], notes)
        ]
        lines = [moment.line for moment in moments]
        old = find_rounds(self.trace.source.lines).find_old(lines, changed)
        return [with_expressions(names, self.points) for names in old]

    def draw_over(self, drawing: Drawing) -> Drawing:
        """The lines over another drawing of the same run, which grows as they run."""
        own, steps = self.draw(), self.steps
        beneath = [retime(layer, steps) for layer in drawing.layers if not layer.last]
        layers = [*beneath, *own.layers, *(layer for layer in drawing.layers if layer.last)]
        key = "board.code.planned_cut" if self.trace.is_cut else "board.code.planned"
        text = get_message(key, lines=own.text, plan=drawing.text)
        return replace(own, layers=layers, text=text, warning=drawing.warning)

    def describe(self) -> str:
        """What the run came to, in words."""
        if self.trace.is_cut:
            kept = f"{len(self.trace.moments):,}"
            return get_message("board.code.cut", name=self.name, most=kept)
        last = self.trace.moments[-1] if self.trace.moments else None
        if last is None or last.ending in ("", RAISED):
            return get_message("board.code.raised", name=self.name)
        if self.trace.source.code.co_flags & CO_GENERATOR:
            return get_message("board.code.ended", name=self.name)
        return get_message("board.code.returned", name=self.name, value=format_short(last.result))


def list_values(moment: Moment, note: Noted) -> dict[str, str]:
    """The variables after a line as texts, and first whether its condition was true."""
    told = {} if moment.holds is None else {get_message("board.front.condition"): str(moment.holds)}
    return {**told, **{name: one.text for name, one in note.items()}}


def trace_lines(
    function: Callable[..., object],
    look: Look,
    call: Callable[[CodeRun], object],
    *callers: Callable[..., object],
) -> CodeRun:
    """The first lines of one of this library's functions in a call, which ends after them.

    Those of the first SECONDS: without machine code a line may take long.

    Parameters
    ----------
    call : is called with the run, which may record a problem.
    callers : functions between the call and the function; machine code would hide its lines.
    """
    run = CodeRun(function, look, ends=True)
    try:
        with in_python(function, *callers), run.trace:
            call(run)
    except Enough:
        pass
    return run


def retime(layer: Layer, steps: Array) -> Layer:
    """A layer whose rows appear and disappear with the first line that has come to their step."""
    if layer.when is None:
        return layer
    when = np.where(layer.when > 0.0, np.searchsorted(steps, layer.when) + 1.0, 0.0)
    until: Array | None = None
    if layer.until is not None:
        until = np.searchsorted(steps, layer.until).astype(float) + 1.0
    return layer._replace(when=when, until=until)


def choose_colours(
    notes: Sequence[Noted], dragged: Collection[str], *, with_poses: bool = False
) -> dict[str, str]:
    """A colour for each variable that is drawn, in the order in which they appear."""
    names = [
        name
        for name in dict.fromkeys(name for note in notes for name in note)
        if name not in dragged
        and any(has_points(note, name) or (with_poses and has_pose(note, name)) for note in notes)
    ]
    return {name: COLOURS[k % len(COLOURS)] for k, name in enumerate(names)}


def has_points(note: Noted, name: str) -> bool:
    """Whether a variable has points to draw after a line."""
    return name in note and note[name].points is not None


def has_pose(note: Noted, name: str) -> bool:
    """Whether a variable is a pose after a line."""
    return name in note and note[name].pose is not None


def without(named: Mapping[str, T], names: Collection[str]) -> dict[str, T]:
    """What is left of a mapping without some names."""
    return {name: one for name, one in named.items() if name not in names}


def draw_asked(questions: list[Question], asked: Sequence[int]) -> list[Layer]:
    """The questions to a problem, each from the step at which it was asked.

    At that step it is drawn thick, unless one line has asked many. A line that calls its own
    function ends after the lines of that call, whose questions are theirs.

    asked : how many had been asked after each step.
    """
    in_order = np.minimum.accumulate(np.array(asked, int)[::-1])[::-1]
    steps = np.searchsorted(in_order, np.arange(1, len(questions) + 1)) + 1.0
    layers = list[Layer]()
    for layer in draw_questions(questions):
        if layer.when is None or not len(layer.rows):
            continue
        when = steps[layer.when.astype(int) - 1]
        layers.append(layer._replace(when=when))
        if layer.kind == "edges":
            few = np.isin(when, find_few(steps))
            colour = "contact" if layer.dash else layer.colour
            now = edges(layer.rows[few], colour, width=4.0, dash=layer.dash, when=when[few])
            layers.append(now._replace(until=when[few] + 1.0))
    return layers


def find_few(steps: NDArray[np.floating]) -> NDArray[np.floating]:
    """The steps at which at most FEW questions were asked, of the steps of all questions."""
    found, numbers = np.unique(steps, return_counts=True)
    return found[numbers <= FEW]
