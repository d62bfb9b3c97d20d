"""The base of boards that have controls above their pictures."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import ipywidgets as widgets

from ...messages import get_message, has_message
from ...planners.registry import Planner
from ...planners.tuning import positive
from ...support.json_fields import JsonObject
from .canvas import Canvas
from .printed import join_pictures
from .stored import Stored


class Pictured(Stored, widgets.Box):
    """A widget that a notebook stores with the text and the picture of its `canvas`."""

    canvas: Canvas

    def __init__(self, children: Sequence[widgets.Widget], **style: Any) -> None:
        super().__init__(children, **style)
        self.add_class("kinoedu-framed")  # board.js makes the controls in it usable by keys

    def picture(self) -> bytes:
        """The board as it is now, as a PNG."""
        return self.canvas.picture()

    def record(self) -> list[JsonObject]:
        """Its canvases as they are now, for pages without a kernel.

        Those that are scrubbed together have one `team`.
        """
        canvases = find_canvases(self)
        teams = [canvas.partner or canvas.key for canvas in canvases]
        records = [record for canvas in canvases for record in canvas.record()]
        return [{**one, "team": teams.index(team)} for one, team in zip(records, teams)]

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.canvas.drawing.message})"


def find_canvases(box: widgets.Box) -> list[Canvas]:
    """The canvases in a widget, in their order."""
    found = list[Canvas]()
    for child in box.children:
        if isinstance(child, Canvas):
            found.append(child)
        elif isinstance(child, widgets.Box):
            found += find_canvases(child)
    return found


class Framed(Pictured, widgets.VBox):
    """Controls above one canvas or a row of canvases; the first one is `canvas`.

    When a control changes, the first canvas answers again.
    """

    def __init__(self, controls: Sequence[Any], canvases: Sequence[Canvas]) -> None:
        self.canvas, self.canvases = canvases[0], list(canvases)
        for canvas in canvases[1:]:
            canvas.partner = self.canvas.key
        super().__init__(
            [*controls, self.canvas if len(canvases) == 1 else arrange_in_row(canvases)]
        )
        for control in controls:
            control.observe(self._changed, "value")
        self._dress()

    def _changed(self, _: object) -> None:
        """Answer again, because a control has another value."""
        self._dress()
        self.canvas.refresh()

    def _dress(self) -> None:
        """Show the controls that apply to what is chosen; by default all of them."""

    def picture(self) -> bytes:
        """The board as it is now, as a PNG."""
        pictures = [canvas.picture() for canvas in self.canvases]
        return pictures[0] if len(pictures) == 1 else join_pictures(*pictures)

    def __repr__(self) -> str:
        messages = "; ".join(canvas.drawing.message for canvas in self.canvases)
        return f"{type(self).__name__}({messages})"


def arrange_in_row(canvases: Sequence[Canvas], width: str = "19em") -> widgets.HBox:
    """Canvases side by side, or below each other where there is no room."""
    for canvas in canvases:
        canvas.layout = widgets.Layout(flex=f"1 1 {width}", min_width="0", padding="0 2px 0 0")
    return widgets.HBox(list(canvases), layout=widgets.Layout(flex_flow="row wrap", grid_gap="8px"))


def make_menu(name: str, options: Sequence[tuple[str, str]], chosen: str) -> widgets.Dropdown:
    """A drop-down menu named by the message under a key; options are pairs (text, value)."""
    return widgets.Dropdown(options=options, value=chosen, **control_style(name))


def make_code_box() -> widgets.Checkbox:
    """The box "code": whether a board shows the lines of its algorithm."""
    return widgets.Checkbox(False, indent=False, **control_style("board.show_code"))


def title_of(planner: Planner, table: str) -> str:
    """A planner's text in a menu: the message `<table>.<name>`, or else its row of the registry."""
    key = f"{table}.{planner.name}"
    return get_message(key) if has_message(key) else f"{planner.name}: {planner.about}"


def make_counter(name: str, value: int, least: int, most: int) -> widgets.IntSlider:
    """A slider for an integer, named by the message under a key."""
    return widgets.IntSlider(value, min(least, value), max(most, value), **control_style(name))


class NotchedSlider(widgets.FloatSlider):
    """A slider that keeps its value where a browser rounds it to a notch.

    Browsers compute 10 notches of 0.3 as 2.9999999999999996; a planner may answer this otherwise.
    """

    def set_state(self, sync_data: JsonObject) -> None:
        """Accept a page's value only if it is another one."""
        value = sync_data.get("value")
        if isinstance(value, int | float) and math.isclose(value, self.value, rel_tol=1e-9):
            sync_data = {name: given for name, given in sync_data.items() if name != "value"}
        super().set_state(sync_data)


def make_length_slider(key: str, size: float, given: float | None) -> NotchedSlider:
    """A slider for a length, named by the message under a key.

    Parameters
    ----------
    size : the size of the world.
    given : the first value; None for a twentieth of the size.

    Raises
    ------
    InvalidParameter
        Where the given length is not positive.
    """
    first = size / 20.0 if given is None else positive(given, key.rpartition(".")[2])
    notch = first / 20.0  # browsers round to notches, so the first value must be a multiple
    return NotchedSlider(
        first,
        min=min(first, notch * max(1, round(size / 200.0 / notch))),
        max=notch * max(40, round(size / 4.0 / notch)),  # at least twice the first value
        step=notch,
        readout_format=".3g",
        **control_style(key),
    )


def control_style(key: str) -> JsonObject:
    """The shared style of a control, and its name: the message under a key."""
    layout = widgets.Layout(width="30em", max_width="100%")
    return {
        "description": get_message(key),
        "layout": layout,
        "style": {"description_width": "6em"},
    }
