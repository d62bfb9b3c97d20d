"""Which variables still have the value of an earlier round of their loop.

A variable that only the lines of a loop assign has a new value in each round. From the beginning of
a round until a line assigns it, what it has is of the round before.
"""

from __future__ import annotations

import ast
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from types import CodeType

Names = frozenset[str]


@dataclass(frozen=True)
class Loop:
    """A loop: the line of its head, those of its body, and the variables that only it assigns."""

    head: int
    body: range
    names: Names


@dataclass(frozen=True)
class Rounds:
    """The loops of a function, and the variables that each of its lines assigns."""

    loops: Sequence[Loop]
    assigned: Mapping[int, Names]

    def begun_by(self, line: int, following: int) -> Names:
        """The variables of the loop of which a round begins, where a line is its head."""
        loops = [loop for loop in self.loops if loop.head == line and following in loop.body]
        return frozenset[str]().union(*(loop.names for loop in loops))

    def find_old(self, lines: Sequence[int], changed: Sequence[Collection[str]]) -> list[Names]:
        """The variables with a value of an earlier round, after each line that has run.

        changed : the variables whose value has changed with each line, as a list that has grown.
        """
        old, given, found = frozenset[str](), frozenset[str](), []
        for line, following, new in zip(lines, [*lines[1:], -1], changed):
            old |= given & self.begun_by(line, following)
            now = self.assigned.get(line, frozenset()) | frozenset(new)
            old, given = old - now, given | now
            found.append(old)
        return found


def find_rounds(lines: Sequence[str]) -> Rounds:
    """The rounds of a function with these lines.

    Examples
    --------
    >>> rounds = find_rounds(["def count(n):", "    for i in range(n):", "        j = 2 * i"])
    >>> rounds.find_old([1, 2, 1, 2], [["i"], ["j"], ["i"], ["j"]])
    [frozenset(), frozenset(), frozenset({'j'}), frozenset()]
    """
    tree = ast.parse("\n".join(lines))
    assigned = dict[int, Names]()
    for statement in ast.walk(tree):
        if isinstance(statement, ast.stmt):
            line = statement.lineno - 1
            assigned[line] = assigned.get(line, frozenset()) | names_assigned_by(statement)
    given = frozenset(node.arg for node in ast.walk(tree) if isinstance(node, ast.arg))
    loops = [
        Loop(node.lineno - 1, range(node.body[0].lineno - 1, end_of(node.body)), frozenset())
        for node in ast.walk(tree)
        if isinstance(node, ast.For | ast.While)
    ]
    return Rounds([with_names(loop, assigned, given) for loop in loops], assigned)


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


def with_names(loop: Loop, assigned: Mapping[int, Names], given: Names) -> Loop:
    """A loop with the variables that are assigned in it and nowhere else."""
    inside, outside = frozenset[str](), given
    for line, names in assigned.items():
        if line == loop.head or line in loop.body:
            inside |= names
        else:
            outside |= names
    return Loop(loop.head, loop.body, inside - outside)


def with_expressions(old: Names, expressions: Mapping[str, CodeType]) -> Names:
    """The variables with an old value, and the expressions that one of them is part of."""
    return old | {name for name, code in expressions.items() if old & {*code.co_names}}
