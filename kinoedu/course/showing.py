"""Show the source of the library's functions in a notebook, so that no lesson pastes code."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from html import escape
from textwrap import dedent
from typing import Any

from ..errors import InvalidParameter
from ..messages import get_message
from .checking import PASSED
from .lessons import EXERCISES
from .withheld import IN_THE_KIT, is_withheld

# of JupyterLab, of the site, and of pages that other programs make of a notebook
CODE_FONT = "font-family: var(--jp-code-font-family, var(--font-stack--monospace, monospace))"


class Source:
    """The source of one function, with its file."""

    def __init__(self, function: Callable[..., object]) -> None:
        self.text = dedent(inspect.getsource(function)).rstrip()
        self.place = f"{function.__module__.replace('.', '/')}.py"

    def __repr__(self) -> str:
        return f"# {self.place}\n{self.text}"

    def _repr_html_(self) -> str:
        """HTML with the colours of notebook cells."""
        from pygments import highlight
        from pygments.formatters import HtmlFormatter
        from pygments.lexers import PythonLexer

        formatter = HtmlFormatter(
            noclasses=True, nobackground=True, style="friendly", prestyles=CODE_FONT
        )
        body = highlight(self.text, PythonLexer(), formatter)
        return f"<div style='opacity:.75'>{escape(self.place)}</div>{body}"


class Note(str):
    """A sentence that a notebook displays as it is."""

    __slots__ = ()

    def __repr__(self) -> str:
        return str(self)


def show(function: Callable[..., object] | str) -> Source | Note:
    """Show the source of one of kinoedu's functions.

    Parameters
    ----------
    function : Callable or str
        A function of kinoedu, or the name of an exercise whose check has passed in this session.

    Returns
    -------
    Source or Note
        In the kit for students, a note instead of a program that is withheld.

    Raises
    ------
    InvalidParameter
        Where it is not a function of kinoedu, or the exercise has not passed yet.

    Examples
    --------
    >>> from kinoedu.course.lessons.geometry.polygons import turn_left
    >>> print(show(turn_left).text.splitlines()[0])
    def turn_left(v: Array) -> Array:
    """
    name = function if isinstance(function, str) else getattr(function, "__name__", "")
    exercise = EXERCISES.get(name)
    ours = (exercise.shown or exercise.source) if exercise is not None else function
    lines: Any = inspect.unwrap(getattr(ours, "py_func", ours)) if callable(ours) else None
    if not inspect.isfunction(lines) or not lines.__module__.startswith("kinoedu."):
        raise InvalidParameter(get_message("check.nothing_to_show", what=repr(function)[:80]))
    if exercise is not None and name not in PASSED:
        raise InvalidParameter(get_message("check.secret", name=name))
    if IN_THE_KIT and is_withheld(ours):
        return Note(get_message("check.with_teacher", name=name))
    return Source(lines)
