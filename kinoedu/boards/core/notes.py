"""What the rows of a layer say when one points at them, or chooses them by keys.

A text is sent once for a whole layer, with blanks; a row carries only the numbers that fill them.
Some names have a meaning of their own:

node, parent   a row's number in a tree and that of its parent, -1 for a root. The branch to the
               root is lit. The blanks {depth} and {length} are its edges and their whole length
which          the number of the text, where a layer has several
{length}       without node and parent: the length of an edge
{why}          of an edge: what it meets first. The browser looks it up in the scene
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...messages import get_message
from .drawing import Layer

FILLED = ("length", "depth", "why")  # the blanks that the browser fills


def with_notes(layer: Layer, *says: str, **values: ArrayLike) -> Layer:
    """A layer whose rows say something.

    Parameters
    ----------
    says : the texts, from `note`.
    values : for each name a number for each row, (n,).

    Examples
    --------
    >>> from .drawing import dots
    >>> layer = with_notes(dots([(0, 0), (1, 2)], "tree"), note("free", number=None), number=[1, 2])
    >>> layer.says, layer.names, layer.notes.tolist()
    (('configuration {number} is free',), ('number',), [[1.0], [2.0]])
    """
    columns = [np.broadcast_to(np.asarray(v, float), len(layer.rows)) for v in values.values()]
    notes = np.column_stack(columns) if columns else None
    return layer._replace(says=says, names=tuple(values), notes=notes)


def note(key: str, **values: Any) -> str:
    """The message `board.note.<key>`; a value None is a blank that each row fills by itself."""
    blanks = {name: f"{{{name}}}" for name in FILLED}
    own = {name: f"{{{name}}}" if value is None else value for name, value in values.items()}
    return get_message(f"board.note.{key}", **blanks, **own)
