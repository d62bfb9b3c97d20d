"""The bank of wrong answers: plausible wrong programs that each exercise must reject.

Each program is wrong for a reason of its own. A bank is a Python file that only instructors have,
beside the solutions. It holds functions marked `@wrong("name_of_the_exercise")`, and small changes
of a right answer, made with `Solutions.changed`. It also has a right program for each variant that
has another right answer, made with `Solutions.varied`.
"""

import runpy
from collections.abc import Callable, Sequence
from os import PathLike
from pathlib import Path
from typing import Any, NamedTuple

from ..support.notebooks import read_notebook


class Wrong(NamedTuple):
    """A wrong program, its exercise, and the misconception that a check must recognise, or "".

    `read_bank` fills in the name that the program has in its bank. `variant` is the variant of the
    exercise for which it was written, or "".
    """

    exercise: str
    slip: str
    function: Callable[..., Any]
    name: str = ""
    variant: str = ""


class Right(NamedTuple):
    """A right program for a variant of an exercise."""

    exercise: str
    variant: str
    function: Callable[..., Any]


def wrong(exercise: str, slip: str = "") -> Callable[[Callable[..., Any]], Wrong]:
    """Mark a function of a bank as a wrong answer to an exercise.

    Returns
    -------
    Callable
        A decorator; the decorated function becomes a `Wrong`.
    """
    return lambda function: Wrong(exercise, slip, function)


class Solutions:
    """The answers in a notebook of solutions, and the functions defined for them.

    The notebook's first cell, which imports, and all cells that begin with `def` are executed.

    Attributes
    ----------
    right : what these cells define, by name.
    """

    def __init__(self, notebook: str | PathLike[str]) -> None:
        cells = read_notebook(Path(notebook))["cells"]
        code = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]
        self.imports = code[0]
        self.sources = {
            source[4 : source.index("(")]: source for source in code if source.startswith("def ")
        }
        self.right = self.run(self.sources)

    def run(self, sources: dict[str, str]) -> dict[str, Any]:
        """Execute the imports and some sources, and return what they define."""
        defined: dict[str, Any] = {}
        for source in (self.imports, *sources.values()):
            exec(source, defined)  # the course's own solutions
        return defined

    def changed(
        self,
        exercise: str,
        *changes: tuple[str, str],
        slip: str = "",
        within: str = "",
        variant: str = "",
    ) -> Wrong:
        """Make a wrong answer from the right one by replacing parts of its text.

        Parameters
        ----------
        changes : pairs of an old text, which must occur exactly once, and a new one.
        within : the function that begins the changed cell, if it is not the exercise's own.
        variant : the variant for which the answer is written.

        Raises
        ------
        ValueError
            Where an old text does not occur exactly once.
        """
        function = self.run_changed(within or exercise, changes)[exercise]
        return Wrong(exercise, slip, function, variant=variant)

    def varied(self, exercise: str, variant: str, *changes: tuple[str, str]) -> Right:
        """Make a right answer to a variant from the usual one, as `changed` makes a wrong one."""
        return Right(exercise, variant, self.run_changed(exercise, changes)[exercise])

    def run_changed(self, within: str, changes: Sequence[tuple[str, str]]) -> dict[str, Any]:
        """Execute all sources with one of them changed, and return what they define."""
        source = self.sources[within]
        for old, new in changes:
            if source.count(old) != 1:
                raise ValueError(
                    f"{old!r} must occur once in {within}, not {source.count(old)} times"
                )
            source = source.replace(old, new)
        return self.run({**self.sources, within: source})


def read_bank(path: str | PathLike[str]) -> list[Wrong]:
    """Read the wrong answers of a bank, in the order of the file.

    The file is executed: read only banks that you trust.

    Returns
    -------
    list of Wrong
    """
    found = runpy.run_path(str(path)).items()
    return [item._replace(name=name) for name, item in found if isinstance(item, Wrong)]


def read_variants(path: str | PathLike[str]) -> list[Right]:
    """Read the right answers to variants of a bank, which is executed as by `read_bank`.

    Returns
    -------
    list of Right
    """
    return [item for item in runpy.run_path(str(path)).values() if isinstance(item, Right)]
