"""The contents of matplotlib axes as plain numbers and text, which another process can judge."""

from typing import Any, NamedTuple

from ..messages import get_message
from ..support.json_fields import JsonObject
from .axes_contents import read_axes
from .plain import wrong_shape
from .shapes import Listed, Numbers, Record, Shape, Text, Value

CURVE: Shape = Record(points=Numbers(("n", 2)), label=Text(), colour=Text())
PLOT = Record(
    lines=Listed(CURVE),
    dots=Listed(CURVE),
    polygons=Listed(CURVE),
    title=Text(),
    x_label=Text(),
    y_label=Text(),
    texts=Listed(Text()),
)


class Canvas:
    """New axes for a function that draws.

    Where the function runs in another process, the axes are there, and `contents` come back.
    """

    ax: Any = None
    contents: JsonObject | None = None

    def lend(self) -> Any:
        """The axes, made at the first use."""
        from ..figures.plane import plane_figure

        if self.ax is None:
            self.ax = plane_figure()[1]
        return self.ax


class Drawn(NamedTuple):
    """The shape of an answer that is a drawing in matplotlib axes.

    The decoded value is a dict. `lines`, `dots` and `polygons` are lists; each entry has points (n,
    2) in data coordinates, a label, and a colour "#rrggbb" or "none". `title`, `x_label`, `y_label`
    and `texts` are text. Dots of several colours make one entry per colour. Round patches are
    polygons with many vertices.
    """

    @property
    def description(self) -> str:
        """Description of the shape, for messages."""
        return get_message("shape.drawn")

    def load(self) -> None:
        """Load matplotlib, so that it takes no time of a student's program."""
        from ..figures.plane import plane_figure

        plane_figure()

    def encode(self, value: Value) -> JsonObject:
        """Encode axes, a figure with one pair of axes, or a value that was decoded before.

        Raises
        ------
        WrongShape
        """
        if isinstance(value, Canvas):
            value = value.contents if value.ax is None else value.ax
        if type(value) is dict:
            return PLOT.encode(value)
        contents = read_axes(value)
        if contents is None:
            raise wrong_shape(self.description, value)
        return PLOT.encode(contents)

    def decode(self, data: object) -> JsonObject:
        """Decode into a dict of numbers and text. Raises WrongShape."""
        return PLOT.decode(data)
