"""What boards of controls over pictures have in common."""

from collections.abc import Sequence
from typing import Any

import ipywidgets as widgets

from .canvas import Canvas, with_picture
from .printed import side_by_side


class Framed(widgets.VBox):
    """Controls above one canvas, or some in a row; the first is `canvas`. When a control changes,
    that one answers anew.
    """

    def __init__(self, controls: Sequence[Any], canvases: Sequence[Canvas]) -> None:
        self.canvas, self.canvases = canvases[0], list(canvases)
        for canvas in canvases[1:]:
            canvas.partner = self.canvas.key
        super().__init__([*controls, self.canvas if len(canvases) == 1 else in_a_row(canvases)])
        for control in controls:
            control.observe(self._changed, "value")

    def _changed(self, _: Any) -> None:
        """Answer anew: a control has another value."""
        self.canvas.refresh()

    def picture(self) -> bytes:
        """The board as it is now, as a PNG."""
        pictures = [canvas.picture() for canvas in self.canvases]
        return pictures[0] if len(pictures) == 1 else side_by_side(*pictures)

    def __repr__(self) -> str:
        return (
            f"{type(self).__name__}({'; '.join(canvas.drawing.says for canvas in self.canvases)})"
        )

    def _repr_mimebundle_(self, **kwargs: Any) -> Any:
        return with_picture(super()._repr_mimebundle_(**kwargs), self, self)


def in_a_row(canvases: Sequence[Canvas]) -> widgets.HBox:
    """Canvases beside each other, below each other where there is no room."""
    for canvas in canvases:
        canvas.layout = widgets.Layout(flex="1 1 19em", min_width="0", padding="0 2px 0 0")
    return widgets.HBox(list(canvases), layout=widgets.Layout(flex_flow="row wrap", grid_gap="8px"))
