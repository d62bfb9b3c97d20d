"""The code beside a picture: the lines of a function, and what each step of a board shows of them.

Each step of the board is a line that has run. The browser lights that line, and lists the variables
after it. To send less, each step carries only the variables that have changed.
"""

from __future__ import annotations

import ast
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field

from ...support.json_fields import JsonObject
from ...support.line_trace import Source, parse_lines


@dataclass(frozen=True)
class Listing:
    """The lines of a function, and the steps of its run.

    Attributes
    ----------
    lines : the source, without decorators and docstring.
    ran : for each step the index of the line that has run.
    values : for each step the variables after it, by name, as texts.
    colours : the colours of the variables that the picture shows.
    old : for each step the variables whose value is of an earlier round of their loop.
    legend : what the picture shows of the run, in words.
    """

    lines: Sequence[str]
    ran: Sequence[int] = ()
    values: Sequence[Mapping[str, str]] = ()
    colours: Mapping[str, str] = field(default_factory=dict)
    old: Sequence[Collection[str]] = ()
    legend: str = ""


def read_code(source: Source) -> dict[int, str]:
    """The lines of a function to show, by their indices in its source.

    Decorators, docstring and the types of parameters are left out.
    """
    lines = dict(enumerate(source.lines))
    function = parse_lines(source.lines).body[0]
    if not isinstance(function, ast.FunctionDef | ast.AsyncFunctionDef):
        return lines
    body = function.body
    has_docstring = ast.get_docstring(function, clean=False) is not None and len(body) > 1
    decorators = getattr(body[0], "decorator_list", [])
    head = function.lineno - 1
    begin = min(one.lineno for one in (body[0], *decorators)) - 1
    hidden = {*range(head), *range(head + 1, begin)}
    if has_docstring and begin > head:
        hidden |= set(range(begin, body[0].end_lineno or 0))
    if begin > head:
        lines[head] = f"def {function.name}({write_parameters(function.args)}):"
    return {number: text for number, text in lines.items() if number not in hidden}


def write_parameters(parameters: ast.arguments) -> str:
    """The parameters of a function with their defaults, without their types."""
    for parameter in ast.walk(parameters):
        if isinstance(parameter, ast.arg):
            parameter.annotation = None
    return ast.unparse(parameters)


def encode_listing(listing: Listing | None) -> JsonObject | None:
    """A listing as plain data; each step has the variables that changed, None where one is gone."""
    if listing is None:
        return None
    changes, before = list[dict[str, str | None]](), dict[str, str]()
    for values in listing.values:
        new = {name: text for name, text in values.items() if before.get(name) != text}
        gone = dict.fromkeys(name for name in before if name not in values)
        changes.append({**new, **gone})
        before = dict(values)
    return {
        "lines": list(listing.lines),
        "ran": list(listing.ran),
        "changes": changes,
        "colours": dict(listing.colours),
        "old": encode_old(listing.old),
        "legend": listing.legend,
    }


def encode_old(old: Sequence[Collection[str]]) -> list[list[str] | None]:
    """The variables with an old value after each step; None where they are those before it."""
    names = [sorted(each) for each in old]
    return [None if now == last else now for last, now in zip([None, *names], names)]
