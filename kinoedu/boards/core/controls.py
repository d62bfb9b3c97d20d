"""The controls of boards: menus and sliders of one size."""

from collections.abc import Sequence
from typing import Any

import ipywidgets as widgets

from ...planners.registry import Planner
from ...planners.tuning import positive
from ...words import has_words, say


def look(name: str) -> dict[str, Any]:
    """How a control looks."""
    layout = widgets.Layout(width="30em", max_width="100%")
    return {
        "description": say(f"board.{name}"),
        "layout": layout,
        "style": {"description_width": "6em"},
    }


def menu(name: str, options: Sequence[tuple[str, str]], chosen: str) -> widgets.Dropdown:
    """A menu whose name is the words under a key; options : words and value of each."""
    return widgets.Dropdown(
        options=options, value=chosen, **{**look("planner"), "description": say(name)}
    )


def title_of(planner: Planner, table: str) -> str:
    """How a menu calls a planner: the message `<table>.<name>`, or else what its row says."""
    key = f"{table}.{planner.name}"
    return say(key) if has_words(key) else f"{planner.name}: {planner.about}"


def counter(name: str, value: int, least: int, most: int) -> widgets.IntSlider:
    """A slider for a whole number whose name is the words under a key."""
    return widgets.IntSlider(
        value, min(least, value), max(most, value), **{**look("seed"), "description": say(name)}
    )


def length_slider(key: str, size: float, given: float | None) -> widgets.FloatSlider:
    """A slider for a length in a world of a size, named by the words under a key: it begins at what
    is given, or at a twentieth of the size. Raises InvalidParameter.
    """
    first = size / 20.0 if given is None else positive(given, key.rpartition(".")[2])
    notch = (
        first / 20.0
    )  # the browser moves a slider to the nearest notch: the first value must lie on one
    return widgets.FloatSlider(
        first,
        min=min(first, notch * max(1, round(size / 200.0 / notch))),
        max=notch * max(20, round(size / 4.0 / notch)),
        step=notch,
        readout_format=".3g",
        **{**look("step"), "description": say(key)},
    )
