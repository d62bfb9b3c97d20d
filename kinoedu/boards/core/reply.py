"""An answer as pages receive it: brief while something is dragged, whole when it has come to rest.

The brief one has what is seen at the last step. So a drag does not wait for what only scrubbing
and pointing need: the earlier steps, their texts, the notes of rows, and the lines of code.
"""

from __future__ import annotations

import logging
import time
from collections.abc import Callable
from typing import NamedTuple

from ...errors import KinoeduError
from ...messages import get_message
from ...support.json_fields import JsonObject
from ...support.text import shortened
from .drawing import Drawing, check_layers, encode_drawing
from .scene import Scene, frame_of

log = logging.getLogger("kinoedu")


class Message(NamedTuple):
    """A drawing as a message and its buffers."""

    content: JsonObject
    buffers: list[bytes]


class Reply:
    """A board's answer to a scene.

    Parameters
    ----------
    answer : makes the drawing. What is wrong with it is shown as a warning; an exception that is
        not a KinoeduError is logged too.
    scene : the scene that is answered.

    Attributes
    ----------
    brief : the message while something is dragged. Its `brief` says whether `whole` is another one.
    took : the milliseconds of the brief answer. Both messages say it, because a drag waits for the
        brief one only.
    """

    def __init__(self, answer: Callable[[], Drawing], scene: Scene) -> None:
        self._frame = frame_of(scene)
        self._drawing, self.took = draw_in_time(answer)
        last = self._drawing.at_end()
        is_brief = last is not self._drawing or last.whole is not None
        self.brief = self._encode(last, is_brief=is_brief)
        self._whole = None if is_brief else self.brief

    @property
    def whole(self) -> Message:
        """The message when everything is at rest."""
        if self._whole is None:
            drawing = self._drawing
            self._drawing, _ = draw_in_time(lambda: drawing.completed)
            self._whole = self._encode(self._drawing, is_brief=False)
        return self._whole

    @property
    def unfinished(self) -> bool:
        """Whether `whole`, which has not been made yet, has a further result."""
        return self._drawing.unfinished

    @property
    def drawing(self) -> Drawing:
        """The whole drawing."""
        _ = self.whole
        return self._drawing

    def _encode(self, drawing: Drawing, *, is_brief: bool) -> Message:
        content, buffers = encode_drawing(drawing, *self._frame)
        return Message({**content, "took": self.took, "brief": is_brief}, buffers)


def draw_in_time(answer: Callable[[], Drawing]) -> tuple[Drawing, float]:
    """A drawing, or what is wrong with it, and the milliseconds that it took."""
    began = time.perf_counter()
    try:
        drawing = answer()
        if not isinstance(drawing, Drawing):
            raise TypeError(f"expected a Drawing, got {shortened(drawing)}")
        check_layers(drawing.layers)
    except KinoeduError as error:
        drawing = Drawing(warning=str(error))
    except Exception as error:
        log.exception("a board could not answer")
        fault = f"{type(error).__name__}: {error}"
        drawing = Drawing(warning=get_message("board.failed", error=fault))
    return drawing, 1e3 * (time.perf_counter() - began)
