"""Run the cells of a notebook, so that one mistake costs as little as possible.

This module runs in the process of a student's program and needs only Python's standard library. A
cell runs statement by statement: one that raises an exception does not prevent the later ones. A
cell with a syntax error runs without the function or statement that has the error. An answer that
was written above the cell for it is not replaced by the placeholder there.
"""

import __future__

import ast
import io
import re
from collections.abc import Coroutine, Iterator
from types import CodeType
from typing import Any, NamedTuple

FUTURES = {getattr(__future__, name).compiler_flag for name in __future__.all_feature_names}
MOST_STEPS = 1_000_000  # of a top-level await; nothing else runs meanwhile, so waiting is in vain
# of a cell with a syntax error, pieces that are joined to complete brackets or text: how many for
# one statement, and how many characters in all
MOST_PIECES, MOST_JOINED = 40, 200_000
MOST_BROKEN = 100  # blocks of a cell with syntax errors, after which the rest counts as one

# lines at column 0 that belong to the lines above
CONTINUES = re.compile(r"(else|elif|except|finally)\b|[\s#)\]}]")
DEFINES = re.compile(r"^(?:async +)?(?:def|class) +(\w+)|^(\w+) *=(?!=)", re.MULTILINE)
# what Python says of code that more lines could complete
INCOMPLETE = re.compile(r"was never closed|unterminated triple-quoted|unexpected EOF")
ON_LINE = re.compile(r"on line (\d+)")
DEFINITIONS = (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)
COMPREHENSIONS = (ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp)  # with names inside

Space = dict[str, Any]


class Failure(NamedTuple):
    """A statement that did not run to its end, or lines that are not Python.

    error : the exception; a SyntaxError counts lines from the cell's first one.
    line : the line of the cell, from 1.
    names : the functions and variables that the lines would have defined.
    """

    error: BaseException
    line: int
    names: tuple[str, ...]


class Compiler:
    """Compiles the statements of one notebook.

    A `from __future__ import ...` holds for all later cells, as in a notebook.
    """

    def __init__(self) -> None:
        self.flags = ast.PyCF_ALLOW_TOP_LEVEL_AWAIT

    def compile(self, statement: ast.stmt, name: str) -> CodeType:
        """Compile one statement of the file `name`. Raises what Python's `compile` raises."""
        tree = ast.Module([statement], [])
        code = compile(tree, name, "exec", flags=self.flags, dont_inherit=True)
        self.flags |= sum(flag for flag in FUTURES if code.co_flags & flag)
        return code


class TimeUp(BaseException):
    """A cell or a call computed for too long: seconds used, allowed, and passed on the clock.

    line : where the statement of the cell begins that did, from 1; 0 if it was none.
    """

    line = 0


def run_cell(source: str, name: str, space: Space, compiler: Compiler) -> Iterator[Failure]:
    """Run a cell in the namespace `space`, and yield each failure when it happens.

    Exceptions of the program are yielded, of whatever kind; only TimeUp passes through. The cell
    runs only as far as its failures are asked for.

    Parameters
    ----------
    name : the file name of the cell in tracebacks.
    compiler : the one of this notebook.

    Examples
    --------
    >>> space = {}
    >>> for failure in run_cell("x = 1\\n1 / 0\\ny = 2", "cell 1", space, Compiler()):
    ...     print(failure.line, failure.error)
    2 division by zero
    >>> space["x"], space["y"]
    (1, 2)
    """
    for statement in split_imports(parse_cell(source, name)):
        if isinstance(statement, Failure):
            yield statement
            continue
        if is_placeholder(statement) and callable(space.get(find_names(statement)[0])):
            continue
        try:
            run_statement(compiler.compile(statement, name), space)
        except TimeUp as over:
            over.line = statement.lineno
            raise
        except BaseException as error:
            yield Failure(error, find_line(error, name, statement), find_names(statement))


def split_imports(statements: Iterator[ast.stmt | Failure]) -> Iterator[ast.stmt | Failure]:
    """Yield the statements, each import of several modules as one import for each.

    So a module that is not there costs none of the others.

    >>> tree = ast.parse("import math, no_such_module")
    >>> [ast.unparse(one) for one in split_imports(iter(tree.body))]
    ['import math', 'import no_such_module']
    """
    for statement in statements:
        if isinstance(statement, ast.Import):
            for alias in statement.names:
                yield ast.copy_location(ast.Import([alias]), statement)
        else:
            yield statement


def parse_cell(source: str, name: str) -> Iterator[ast.stmt | Failure]:
    """Yield the statements of a cell, and a failure for each block that is not Python."""
    tree = parse(source, name)
    if isinstance(tree, ast.Module):
        yield from tree.body
        return
    pieces, begin, left, broken = split_at_statements(source), 0, MOST_JOINED, 0
    while begin < len(pieces):
        if broken == MOST_BROKEN:
            pieces[begin:] = [(pieces[begin][0], "".join(text for _, text in pieces[begin:]))]
        first, text = pieces[begin]
        joined = pieces[begin : begin + MOST_PIECES] if left > 0 else [pieces[begin]]
        count, tree, length = parse_first_block([text for _, text in joined], name)
        begin, left = begin + count, left - length
        if isinstance(tree, ast.Module):
            ast.increment_lineno(tree, first)
            yield from tree.body
        else:
            broken += 1
            names = tuple(one or other for one, other in DEFINES.findall(text))
            yield Failure(tree, shift_lines(tree, first), names)


def parse(source: str, name: str) -> ast.Module | Exception:
    """The syntax tree of the source, or the reason why there is none."""
    try:
        return ast.parse(source, name)
    except Exception as error:  # a SyntaxError, or too much for the parser
        return error


def split_at_statements(source: str) -> list[tuple[int, str]]:
    """The pieces of a cell that begin like statements, each with its number of lines above.

    Decorators and `else` stay with their block. Text in triple quotes may be torn apart.

    >>> split_at_statements("@cached\\ndef f(:\\n    pass\\nx = 1")
    [(0, '@cached\\ndef f(:\\n    pass\\n'), (3, 'x = 1')]
    """
    lines = io.StringIO(source, newline="").readlines()
    statements = [number for number, line in enumerate(lines) if not CONTINUES.match(line)]
    starts = [
        number
        for number, above in zip(statements, [None, *statements])
        if above is None or not lines[above].startswith("@")
    ]
    starts = sorted({0, *starts})
    return [
        (start, "".join(lines[start:end])) for start, end in zip(starts, [*starts[1:], len(lines)])
    ]


def parse_first_block(pieces: list[str], name: str) -> tuple[int, ast.Module | Exception, int]:
    """Parse the first piece, joined with later ones while these may complete it.

    Returns the number of pieces and their tree, or 1 and the error of the first piece; and the
    number of characters that were parsed.
    """
    text, first, length = "", Exception(), 0
    for count, piece in enumerate(pieces, 1):
        text += piece
        tree, length = parse(text, name), length + len(text)
        if isinstance(tree, ast.Module):
            return count, tree, length
        first = tree if count == 1 else first
        if not INCOMPLETE.search(str(tree)):
            break
    return 1, first, length


def shift_lines(error: Exception, lines: int) -> int:
    """Make a syntax error count its lines from the start of the cell, and return its line."""
    if not isinstance(error, SyntaxError) or error.lineno is None:
        return lines + 1
    error.msg = ON_LINE.sub(lambda line: f"on line {int(line[1]) + lines}", error.msg)
    error.lineno += lines
    error.end_lineno = error.end_lineno and error.end_lineno + lines
    return error.lineno


def is_placeholder(statement: ast.stmt) -> bool:
    """Whether a statement defines a function as it was handed out: its first step says so.

    >>> is_placeholder(ast.parse("def f(): raise NotImplementedError").body[0])
    True
    """
    if not isinstance(statement, ast.FunctionDef):
        return False
    steps = [
        step
        for step in statement.body
        if not (isinstance(step, ast.Expr) and isinstance(step.value, ast.Constant))
    ]
    if not steps:
        return True
    raised = ast.walk(steps[0]) if isinstance(steps[0], ast.Raise) else ()
    return any(isinstance(one, ast.Name) and one.id == "NotImplementedError" for one in raised)


def run_statement(code: CodeType, space: Space) -> None:
    """Run a compiled statement; if it awaits at top level, to the end of what it awaits."""
    found = eval(code, space)
    if isinstance(found, Coroutine):
        finish(found)


def finish(coroutine: Coroutine[Any, None, Any]) -> None:
    """Run a coroutine to its end; there is no event loop that could wake what really waits."""
    try:
        for _ in range(MOST_STEPS):
            coroutine.send(None)
    except StopIteration:
        return
    finally:
        coroutine.close()
    raise RuntimeError("this waits for something that never happens, as nothing else runs here")


def find_line(error: BaseException, name: str, statement: ast.stmt) -> int:
    """The line of the cell in which an exception was raised, of nested calls the innermost."""
    if isinstance(error, SyntaxError) and error.filename == name and error.lineno:
        return error.lineno
    line, trace = statement.lineno, error.__traceback__
    while trace is not None:
        if trace.tb_frame.f_code.co_filename == name:
            line = trace.tb_lineno or line
        trace = trace.tb_next
    return line


def find_names(statement: ast.stmt) -> tuple[str, ...]:
    """The functions, classes and variables that a statement defines in the notebook.

    >>> find_names(ast.parse("with x as y:\\n    def f(): z = 1\\n    g = [u for u in x]").body[0])
    ('f', 'y', 'g')
    """
    nodes: list[ast.AST] = [statement]
    found = []
    for node in nodes:
        if isinstance(node, DEFINITIONS):
            found.append(node.name)
        elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            found.append(node.id)
        elif not isinstance(node, COMPREHENSIONS):
            nodes.extend(ast.iter_child_nodes(node))
    return tuple(found)
