"""Which lines of a function run, in which order, and what its variables are after each."""

from __future__ import annotations

import ast
import dis
import inspect
import sys
import textwrap
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from traceback import walk_tb
from types import CodeType, FrameType, TracebackType
from typing import Any, NamedTuple

from ..errors import InvalidParameter
from .text import shortened, split_lines

Variables = dict[str, Any]
RETURNED, RAISED = "returned", "raised"
JUMP_BACKWARD = dis.opmap["JUMP_BACKWARD"]  # to the next item of a loop


class Enough(BaseException):
    """As many lines have run as a trace keeps; raised in the function to end the call."""


class Source(NamedTuple):
    """A function's source.

    lines : without indentation.
    first : the number of the first line.
    code : what Python made of it.
    conditions : the lines with the condition of an `if` or a `while`, each with the first lines
        below it.
    comprehensions : the offsets of the instructions inside a comprehension, each with its lines;
        and of those that go to the next item of a generator for `any`, `all` or `tuple`.
    """

    lines: tuple[str, ...]
    first: int
    code: CodeType
    conditions: dict[int, range]
    comprehensions: dict[int, range]


sources: dict[int, Source] = {}  # those that were read, by the identity of their code


@dataclass
class Moment:
    """A line that has run.

    Attributes
    ----------
    line : its index in the source, from 0.
    note : what was noted of the variables after it.
    ending : RETURNED or RAISED where the call ended with this line, or "".
    result : what the call returned.
    holds : whether the condition of this `if` or `while` was true; None for another line.
    """

    line: int
    note: Any = None
    ending: str = ""
    result: object = None
    holds: bool | None = None


class LineTrace:
    """A context in which the lines of one function are traced as they run, in this thread.

    Parameters
    ----------
    function : a function written in Python; decorators are looked through.
    note : called after each line with the local and the global variables. It returns what is to be
        kept of them, because they go on changing.
    most : the number of lines that are kept; later ones run at full speed. Where the function
        then raises an exception, the line that raised it is kept too.
    ends : whether Enough is raised in the function after these lines, instead of going on.

    Attributes
    ----------
    moments : the lines that have run, in order.
    is_cut : whether more than the most have run.

    Raises
    ------
    InvalidParameter
        Where the source of the function is not known.

    Examples
    --------
    >>> from kinoedu.graphs import extract_path
    >>> with LineTrace(extract_path, lambda variables, _: variables.get("node"), most=100) as trace:
    ...     path = extract_path([-1, 0, 1], 2)
    >>> trace.moments[-1].ending, len(trace.moments) > 3
    ('returned', True)
    """

    def __init__(
        self,
        function: Callable[..., object],
        note: Callable[[Variables, Variables], Any],
        *,
        most: int,
        ends: bool = False,
    ) -> None:
        self.source, self.note, self.most, self.ends = source_of(function), note, most, ends
        self.moments: list[Moment] = []
        self.is_cut = False

    def __enter__(self) -> LineTrace:
        self.before = sys.gettrace()
        sys.settrace(self.enter_call)
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        sys.settrace(self.before)
        if self.is_cut and isinstance(error, Exception):
            self.keep_failure(error.__traceback__)

    def keep_failure(self, traceback: TracebackType | None) -> None:
        """Add the line of the function that raised an exception after the trace was full."""
        calls = [call for call in walk_tb(traceback) if call[0].f_code is self.source.code]
        for frame, line in calls[-1:]:
            note = self.note(frame.f_locals, frame.f_globals)
            self.moments.append(Moment(line - self.source.first, note, RAISED))

    def enter_call(self, frame: FrameType, event: str, _: object) -> Any:
        """Trace the calls of the function, and no others."""
        if event == "call" and frame.f_code is self.source.code:
            return CallTrace(self, frame).step
        return None

    def begin(self, line: int) -> Moment | None:
        """A new moment, or None where there are enough."""
        if len(self.moments) == self.most:
            self.is_cut = True
            sys.settrace(None)
            if self.ends:
                raise Enough
            return None
        self.moments.append(Moment(line))
        return self.moments[-1]


class CallTrace:
    """The lines of one call. The variables after a line are known when the next one begins."""

    def __init__(self, trace: LineTrace, frame: FrameType) -> None:
        self.trace, self.frame = trace, frame
        self.now: Moment | None = None
        self.raises = False
        self.within = range(0)  # the lines of the comprehension that runs

    def step(self, frame: FrameType, event: str, value: object) -> Any:
        """Handle an event of this call, as Python asks of a tracer."""
        if event == "exception":
            self.raises = True
            return self.step
        line = -1  # of no source
        if event == "line":
            line = frame.f_lineno - self.trace.source.first
            self.within = self.lines_of_comprehension(frame, line)
            if self.now is not None and self.now.line in self.within:
                return self.step
            line = min(self.within, default=line)
        if self.now is not None:
            self.now.note = self.trace.note(frame.f_locals, frame.f_globals)
        if event == "line":
            self.judge_condition(line)
            self.raises = False
            self.now = self.trace.begin(line)
            return None if self.now is None else self.step
        if event == "return" and self.now is not None:
            self.now.ending = RAISED if self.raises else RETURNED
            self.now.result = value
            self.judge_condition(-1)
        return None

    def lines_of_comprehension(self, frame: FrameType, line: int) -> range:
        """The lines of the comprehension that runs, or has just run in this line; else none.

        From Python 3.12 on each of its items is an event of the function that it is in, and from
        3.14 on so is each item of a generator expression in `any(...)`, `all(...)` or `tuple(...)`.
        """
        found = self.trace.source.comprehensions.get(frame.f_lasti)
        return found or (self.within if line in self.within else range(0))

    def judge_condition(self, following: int) -> None:
        """Note whether the condition of the last line was true, by the line that follows it."""
        now, conditions = self.now, self.trace.source.conditions
        if now is not None and now.line in conditions and not self.raises and following != now.line:
            now.holds = following in conditions[now.line]


def find_conditions(lines: Sequence[str]) -> dict[int, range]:
    """The `conditions` of a source."""
    return {
        node.lineno - 1: range(node.body[0].lineno - 1, node.body[0].end_lineno or 0)
        for node in ast.walk(parse_lines(lines))
        if isinstance(node, ast.If | ast.While)
        and node.lineno == node.test.end_lineno
        and node.lineno < node.body[0].lineno
    }


def find_comprehensions(
    lines: Sequence[str], first: int, indent: int, code: CodeType
) -> dict[int, range]:
    """The `comprehensions` of a source whose lines were indented by some columns."""
    kinds = ast.ListComp | ast.SetComp | ast.DictComp
    nodes = list(ast.walk(parse_lines(lines)))
    found: list[ast.expr] = [node for node in nodes if isinstance(node, kinds)]
    calls = [node for node in nodes if isinstance(node, ast.Call)]
    # Python gives the loop over a generator's items the place of the name before the brackets
    names = [c.func for c in calls if c.args and isinstance(c.args[0], ast.GeneratorExp)]
    inside = {}
    operations = code.co_code[::2]
    for number, (line, last, column, end) in enumerate(code.co_positions()):
        if line is None or last is None or column is None or end is None:
            continue
        begin, stop = (line - first + 1, column - indent), (last - first + 1, end - indent)
        for node in found + names if operations[number] == JUMP_BACKWARD else found:
            last_line, last_column = node.end_lineno or 0, node.end_col_offset or 0
            if (node.lineno, node.col_offset) <= begin and stop <= (last_line, last_column):
                inside[2 * number] = range(node.lineno - 1, last_line)
                break
    return inside


def parse_lines(lines: Sequence[str]) -> ast.Module:
    """The syntax tree of a function's lines, which may be indented.

    They are where a text in them begins at the left margin, because `dedent` then removes nothing.
    """
    text = "\n".join(lines)
    try:
        return ast.parse(text)
    except IndentationError:
        tree: Any = ast.parse("if 1:\n" + text)
        return ast.increment_lineno(ast.Module(tree.body[0].body, []), -1)


def source_of(function: Callable[..., object]) -> Source:
    """The source of a function.

    Raises
    ------
    InvalidParameter
        Where it is not written in Python, or its source is not known.
    """
    code = getattr(inspect.unwrap(getattr(function, "py_func", function)), "__code__", None)
    if not isinstance(code, CodeType):
        raise InvalidParameter(
            f"only a function written in Python has lines to show, got {shortened(function)}"
        )
    if id(code) not in sources:
        try:
            found, first = inspect.getsourcelines(code)
        except (OSError, TypeError) as error:
            raise InvalidParameter(f"the source of {shortened(function)} is not known") from error
        dedented = split_lines(textwrap.dedent("".join(found)))
        lines = tuple(line.rstrip("\n") for line in dedented)
        indent = len(found[0].rstrip("\n")) - len(lines[0]) if lines else 0
        within = find_comprehensions(lines, first, indent, code)
        sources[id(code)] = Source(lines, first, code, find_conditions(lines), within)
    return sources[id(code)]
