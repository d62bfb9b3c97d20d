"""The kit for students: the lessons without answers, and the results that `check` needs of them.

Three things are taken out of the lessons: the bodies of withheld functions, the programs of known
misconceptions and of variants, and then whatever nothing else uses. What the withheld functions
return is recorded for the cases of `check`, which are the same for everybody; hidden cases are not
among them.
"""

import ast
import gzip
import json
from collections.abc import Iterable
from typing import Any

import numpy as np

from ..support.progress import Progress
from ..support.text import split_lines
from .exercise import Exercise, Restated
from .lessons import EXERCISES, find
from .withheld import Results, recorded_results

Sources = dict[str, str]  # by the path of a file in the folder of the lessons
Name = tuple[str, str]  # the path of a file, and a name that it defines; "" for other statements
Place = tuple[int, int]  # a line, from 1, and a byte of it
Edit = tuple[Place, Place, str]  # where a text begins and ends, and the new text
NAMED_PROGRAMS = ("Slip", "Change")  # students get the names alone


def take_out_answers(sources: Sources) -> Sources:
    """The sources of the lessons without answers, and without what only answers use."""
    cut = {path: cut_answers(text) for path, text in sources.items()}
    before, after = find_uses(sources), find_uses(cut)
    used = {name for user, names in before.items() for name in names if name != user}
    entries = {name for name in before if name not in used or not name[1]}
    unused = reach(before, entries) - reach(after, entries)
    return {
        path: remove_imports(remove_definitions(text, path, unused), sources[path])
        for path, text in cut.items()
    }


def cut_answers(text: str) -> str:
    r"""A source without bodies of withheld functions, and programs of misconceptions and variants.

    Raises
    ------
    ValueError
        Where a withheld function has no docstring, which is all that students get of it.

    Examples
    --------
    >>> print(cut_answers("@withheld\ndef half(x):\n    'Half of x.'\n    return x / 2\n"))
    @withheld
    def half(x):
        'Half of x.'
    <BLANKLINE>
    >>> cut_answers("slips = (Slip('sign', lambda x: -half(x)),)")
    "slips = (Slip('sign'),)"
    """
    edits: list[Edit] = []
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.FunctionDef) and is_marked(node):
            if ast.get_docstring(node) is None:
                raise ValueError(f"{node.name} is withheld, and needs a docstring")
            edits.append((end_of(node.body[0]), end_of(node), ""))
        elif isinstance(node, ast.Call) and (name := ast.unparse(node.func)) in NAMED_PROGRAMS:
            edits.append((place_of(node), end_of(node), f"{name}({ast.unparse(node.args[0])})"))
    return edit(text, edits)


def is_marked(node: ast.FunctionDef) -> bool:
    """Whether a definition is marked as withheld."""
    return "withheld" in map(ast.unparse, node.decorator_list)


def remove_definitions(text: str, path: str, unused: set[Name]) -> str:
    """A source without the definitions that nothing uses, and the comments above them."""
    lines, edits = split_lines(text), list[Edit]()
    for node in ast.parse(text).body:
        if (path, name_defined(node)) in unused:
            decorators = getattr(node, "decorator_list", [])
            line = min([node.lineno, *(one.lineno for one in decorators)])
            while lines[line - 2].startswith("#"):
                line -= 1
            edits.append(((line, 0), end_of(node), ""))
    return edit(text, edits)


def remove_imports(text: str, original: str) -> str:
    """A source without the imports that the original uses and this source does not."""
    tree, edits = ast.parse(text), list[Edit]()
    unused = names_in(ast.parse(original)) - names_in(tree)
    for node in ast.walk(tree):
        if isinstance(node, ast.Import | ast.ImportFrom):
            kept = [one for one in node.names if (one.asname or one.name) not in unused]
            if kept != node.names:
                node.names = kept
                edits.append((place_of(node), end_of(node), ast.unparse(node) if kept else ""))
    return edit(text, edits)


def find_uses(sources: Sources) -> dict[Name, set[Name]]:
    """What each top-level definition of the sources uses of the others, by name."""
    uses: dict[Name, set[Name]] = {}
    for path, text in sources.items():
        tree = ast.parse(text)
        known = find_imports(tree, path, sources)
        known |= {name: (path, name) for node in tree.body if (name := name_defined(node))}
        for node in tree.body:
            found = {known[name] for name in names_in(node) if name in known}
            uses.setdefault((path, name_defined(node)), set()).update(found)
    return uses


def find_imports(tree: ast.Module, path: str, sources: Sources) -> dict[str, Name]:
    """The names that a source imports from other sources, each with what it stands for."""
    imported: dict[str, Name] = {}
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node.module and node.level:
            folders = path.split("/")[: -node.level]
            file = "/".join([*folders, *node.module.split(".")]) + ".py"
            if file in sources and node.level <= path.count("/") + 1:
                imported |= {one.asname or one.name: (file, one.name) for one in node.names}
    return imported


def reach(uses: dict[Name, set[Name]], entries: Iterable[Name]) -> set[Name]:
    """All names that are used by entries, or by what they use, with the entries."""
    reached, stack = set(entries), list(entries)
    while stack:
        new = uses.get(stack.pop(), set()) - reached
        reached |= new
        stack += new
    return reached


def names_in(tree: ast.AST) -> set[str]:
    """The names that a source uses."""
    return {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}


def name_defined(node: ast.stmt) -> str:
    """The name that a top-level statement defines, or ""."""
    if isinstance(node, ast.FunctionDef | ast.ClassDef):
        return node.name
    if isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
        return node.target.id
    if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
        return node.targets[0].id if len(node.targets) == 1 else ""
    return ""


def place_of(node: Any) -> Place:
    """Where a node of a syntax tree begins."""
    return node.lineno, node.col_offset


def end_of(node: Any) -> Place:
    """Where a node of a syntax tree ends."""
    return node.end_lineno, node.end_col_offset


def edit(text: str, edits: list[Edit]) -> str:
    """A text with edits, which do not overlap; no more than two empty lines follow each other."""
    lines = [line.encode() for line in split_lines(text)]
    for (first, left), (last, right), new in sorted(edits, reverse=True):
        lines[first - 1 : last] = [lines[first - 1][:left] + new.encode() + lines[last - 1][right:]]
    result = b"".join(lines).decode()
    while "\n\n\n\n" in result:
        result = result.replace("\n\n\n\n", "\n\n\n")
    return result


def record_results(
    exercises: Iterable[Exercise] | None = None, progress: Progress | None = None
) -> Results:
    """Record what withheld functions return while `check` judges its cases, with each variant.

    Parameters
    ----------
    exercises : by default all of the course.
    progress : called with the number of exercises and variants that are recorded, and of all.
    """
    judged = [
        find(exercise.name, variant)
        for exercise in (EXERCISES.values() if exercises is None else exercises)
        for variant in ("", *exercise.variants)
        # for the others the results of the usual form are all that is needed
        if not is_only_answered_otherwise(exercise, variant)
    ]
    report_progress = progress or (lambda done, everything: None)
    with recorded_results() as results, np.errstate(all="ignore"):
        for done, exercise in enumerate(judged):
            report_progress(done, len(judged))
            # new cases, because a kept answer to a fixed one would not be recorded
            for case in exercise.cases(np.random.default_rng(0)):
                exercise.ask_for_answers(case)
    report_progress(len(judged), len(judged))
    return results


def is_only_answered_otherwise(exercise: Exercise, variant: str) -> bool:
    """Whether a variant has the usual arguments, and the usual answers in another form."""
    return any(
        isinstance(change, Restated) and change.key == variant and change.given is None
        for change in exercise.changes
    )


def compress_results(results: Results) -> bytes:
    """Write results as a file for the kit; the same results give the same bytes."""
    text = json.dumps(results, separators=(",", ":"), sort_keys=True)
    return gzip.compress(text.encode(), mtime=0)
