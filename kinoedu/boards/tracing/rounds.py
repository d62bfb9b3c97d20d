"""Which variables still have the value of an earlier round of their loop.

A variable that only the lines of a loop assign has a new value in each round. From the beginning of
a round until a line assigns it, what it has is of the round before.
"""

from __future__ import annotations

import ast
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from types import CodeType

from ...support.line_trace import parse_lines

Names = frozenset[str]


@dataclass(frozen=True)
class Loop:
    """A loop: the lines of its body, and the variables that only it assigns."""

    body: range
    names: Names


@dataclass(frozen=True)
class Rounds:
    """The loops of a function by each line of their heads, and what each line assigns."""

    loops: Mapping[int, Loop]
    assigned: Mapping[int, Names]

    def begun_by(self, line: int, following: int) -> Names:
        """The variables of the loop of which a round begins, where a line is of its head."""
        loop = self.loops.get(line)
        return loop.names if loop is not None and following in loop.body else frozenset()

    def find_old(self, lines: Sequence[int], changed: Sequence[Collection[str]]) -> list[Names]:
        """The variables with a value of an earlier round, after each line that has run.

        Parameters
        ----------
        lines : the lines that have run, in order, as indices from 0.
        changed : the variables whose value has changed with each of them: a list that has grown is
            new too, though no line assigns it.
        """
        old, seen, found = frozenset[str](), frozenset[str](), []
        for line, following, new in zip(lines, [*lines[1:], -1], changed):
            old |= seen & self.begun_by(line, following)
            now = self.assigned.get(line, frozenset()) | frozenset(new)
            old, seen = old - now, seen | now
            found.append(old)
        return found


@lru_cache(maxsize=100)
def find_rounds(lines: tuple[str, ...]) -> Rounds:
    """The loops of a function, from the lines of its source.

    Examples
    --------
    >>> rounds = find_rounds(("def count(n):", "    for i in range(n):", "        j = 2 * i"))
    >>> rounds.find_old([1, 2, 1, 2], [["i"], ["j"], ["i"], ["j"]])
    [frozenset(), frozenset(), frozenset({'j'}), frozenset()]
    """
    tree = parse_lines(lines)
    assigned = dict[int, Names]()
    for statement in ast.walk(tree):
        if isinstance(statement, ast.stmt):
            line = statement.lineno - 1
            assigned[line] = assigned.get(line, frozenset()) | names_assigned_by(statement)
    given = frozenset(node.arg for node in ast.walk(tree) if isinstance(node, ast.arg))
    loops = dict[int, Loop]()
    for node in ast.walk(tree):
        if isinstance(node, ast.For | ast.While):
            begin, body = node.lineno - 1, range(node.body[0].lineno - 1, end_of(node.body))
            loop = Loop(body, names_only_in(range(begin, body.stop), assigned, given))
            loops |= dict.fromkeys(range(begin, body.start), loop)
    return Rounds(loops, assigned)


def end_of(body: Sequence[ast.stmt]) -> int:
    """The number of the last line of a body."""
    return body[-1].end_lineno or body[-1].lineno


def names_assigned_by(statement: ast.stmt) -> Names:
    """The variables that a statement assigns itself, not by the statements in it."""
    parts = [node for node in ast.iter_child_nodes(statement) if not isinstance(node, ast.stmt)]
    stored = (
        node.id
        for part in parts
        for node in ast.walk(part)
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)
    )
    return frozenset(stored)


def names_only_in(lines: Collection[int], assigned: Mapping[int, Names], given: Names) -> Names:
    """The variables that are assigned in some lines and nowhere else."""
    inside, outside = frozenset[str](), given
    for line, names in assigned.items():
        if line in lines:
            inside |= names
        else:
            outside |= names
    return inside - outside


def with_expressions(old: Names, expressions: Mapping[str, CodeType]) -> Names:
    """The variables with an old value, and the expressions that one of them is part of."""
    return old | {name for name, code in expressions.items() if old & {*code.co_names}}
