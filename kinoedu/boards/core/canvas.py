"""A live canvas: the browser drags and paints, Python answers.

`Canvas(scene, answer)` shows a scene and, over it, what `answer(scene)` draws, again and again
while something is dragged. All that a lesson writes is the answer: a function from a scene to a
Drawing. The messages between the two halves:

    to Python   {kind: "hello", from}                       a page is there: what was answered last?
                {kind: "scene", from, seq, moved: [[kind, number, coordinates], ...]}
                {kind: "keys", from, seq, held: ["ArrowUp", ...]}  again and again while arrow keys are held at what is driven
    from Python {kind: "drawing", to, seq, took, text, warning, total, unit, told, places, layers}
                                                            and a buffer of float32 for each layer
                {kind: "note", text}                        what takes so long

`from` and `to` name a page, since several may show one widget; a drawing to none and without seq is
for all. When something was let go, and that is answered, the page writes its whole scene to the
trait `scene`. The bitmap is a trait too: it travels only when it changes.
"""

import base64
import logging
import threading
import time
import uuid
from collections.abc import Callable
from copy import deepcopy
from pathlib import Path
from typing import Any

import anywidget
import numpy as np
import traitlets

from ...errors import KinoeduError
from ...figures import palette
from ...words import say
from .drawing import Drawing, encoded
from .printed import printed
from .scene import Scene, arranged_like, everything, moved

log = logging.getLogger("kinoedu")

ARROWS = ("ArrowLeft", "ArrowUp", "ArrowDown", "ArrowRight")
FRONT = {  # the words that the browser shows, and what it fills in
    **dict.fromkeys(
        (
            "play",
            "pause",
            "next",
            "reset",
            "slider",
            "movable",
            "thinking",
            "hint",
            "deeper",
            "stops",
        ),
        (),
    ),
    **dict.fromkeys(("posed", "driving", "pad", *ARROWS), ()),
    "growth": ("shown", "total", "unit"),
    "handle": ("name", "x", "y"),
    "stop": ("name", "x", "y"),
    "driven": ("name", "x", "y"),
    "polygon": ("name", "x", "y"),
    "vertex": ("name", "number", "x", "y"),
}

_answering = (
    threading.RLock()
)  # messages and cells may come in different threads: one answer at a time, on all boards


class Canvas(anywidget.AnyWidget):
    """A scene to drag, and what is answered to it.

    Parameters
    ----------
    scene : what `make_scene` makes.
    answer : a function from a scene to a Drawing. A KinoeduError that it raises is shown as a
    warning, and nothing else.
    free : a bitmap to draw beneath, (rows, columns), the lowest row first; true is free, or, where
    the scene has `colours`, the
        number of one.
    drive : a function of the arrow keys held, by their names, that moves on what is driven; then
    the scene is answered.

    `partner` is the key of another board that is scrubbed together with this one, as a plot is with
    what it plots; so are all that have the same partner. `drawing` is the answer on show. Where
    there is no JavaScript the same is shown as a picture.
    """

    _esm = Path(__file__).with_name("board.js")
    _css = Path(__file__).with_name("board.css")
    key = traitlets.Unicode().tag(sync=True)
    partner = traitlets.Unicode().tag(sync=True)
    scene = traitlets.Dict().tag(sync=True)
    home = traitlets.Dict().tag(sync=True)
    bitmap = traitlets.Bytes().tag(sync=True)
    palette = traitlets.Dict().tag(sync=True)
    words = traitlets.Dict().tag(sync=True)

    def __init__(
        self,
        scene: Scene,
        answer: Callable[[Scene], Drawing],
        *,
        free: Any = None,
        drive: Callable[[set[str]], None] | None = None,
    ) -> None:
        self._answer, self._drive = answer, drive
        self._free = (
            None if free is None else np.asarray(free, np.uint8 if "colours" in scene else np.bool_)
        )
        self.drawing = Drawing()
        self._shown = {**scene, "size": None if self._free is None else list(self._free.shape)}
        super().__init__(
            key=uuid.uuid4().hex,
            scene=self._shown,
            home=deepcopy(self._shown),
            bitmap=packed(self._free),
            palette=palette.NAMED,
            words={
                name: say(f"board.front.{name}", **{v: f"{{{v}}}" for v in values})
                for name, values in FRONT.items()
            },
        )
        self.on_msg(self._received)
        self.observe(self._arranged, "scene")
        self.refresh()

    def refresh(self) -> None:
        """Answer the same scene again, because something else changed, and show that on every
        page.
        """
        with _answering:
            self._draw()
            self._show(None, None)

    def arrange(self, scene: Scene) -> None:
        """Put everything where a scene of the same parts has it, answer that, and show it on every
        page.
        """
        with _answering:
            self._shown = scene
            self._draw()
            self._content["places"] = [list(part) for part in everything(scene)]
            self._show(None, None)
            self.scene = scene  # after its places: a page that has them asks for nothing

    def lay(self, bitmap: Any) -> None:
        """Another bitmap beneath, of the same size: every page gets it now, and paints it with what
        is answered next.
        """
        with _answering:
            self._free = np.asarray(bitmap, None if self._free is None else self._free.dtype)
            self.bitmap = packed(self._free)

    def set_state(self, sync_data: dict[str, Any]) -> None:
        """What a page may change: where things are. Anything else, or a scene that makes no sense,
        is left out.
        """
        try:
            super().set_state(
                {"scene": arranged_like(self.home, sync_data["scene"])}
                if "scene" in sync_data
                else {}
            )
        except KinoeduError as error:
            log.warning("a board was sent a scene that it cannot show: %s", error)

    def _arranged(self, _: Any) -> None:
        """The scene was set, by a page that let something go or by Python."""
        with _answering:
            if self.scene != self._shown:
                self._shown = self.scene
                self._draw()

    def _received(self, _: Any, message: Any, _buffers: Any) -> None:
        """A message from a page; what is none of those above is left unanswered."""
        page, seq = (
            (message.get("from"), message.get("seq")) if isinstance(message, dict) else (None, None)
        )
        if not isinstance(page, str):
            return
        with _answering:
            if message.get("kind") == "hello":
                self._show(page, None)
            elif message.get("kind") == "scene" and isinstance(seq, int):
                try:
                    self._move(message.get("moved"))
                except KinoeduError as error:
                    self._show(page, seq, warning=str(error))
                else:
                    self._show(page, seq)
            elif message.get("kind") == "keys" and isinstance(seq, int) and self._drive is not None:
                held = message.get("held")
                self._drive(
                    {key for key in ARROWS if key in held} if isinstance(held, list) else set()
                )
                self._draw()
                self._show(page, seq)

    def _move(self, parts: Any) -> None:
        """Some parts of the scene moved: answer, unless they are where they were."""
        scene = moved(self._shown, parts)
        if scene != self._shown:
            self._shown = scene
            self._draw()

    def _draw(self) -> None:
        """Answer the scene, or say what is wrong with it; a fault of the answer's own is told and
        logged, not raised at a page.
        """
        began = time.perf_counter()
        try:
            self._keep(self._answer(self._shown))
        except KinoeduError as error:
            self._keep(Drawing(warning=str(error)))
        except Exception as error:
            log.exception("a board could not answer")
            self._keep(
                Drawing(warning=say("board.failed", error=f"{type(error).__name__}: {error}"))
            )
        self._content["took"] = 1e3 * (time.perf_counter() - began)

    def _keep(self, drawing: Drawing) -> None:
        """Keep a drawing, and the message that carries it."""
        lo, hi = self._shown["lo"], self._shown["hi"]
        self._content, self._buffers = encoded(drawing, lo, max(hi[0] - lo[0], hi[1] - lo[1]))
        self._shown = moved(self._shown, self._content["places"])
        self.drawing = drawing

    def _show(self, page: str | None, seq: int | None, *, warning: str = "") -> None:
        """Send the drawing to a page, or to all; or a warning in its place."""
        if warning:
            content, _ = encoded(Drawing(warning=warning), self._shown["lo"], 1.0)
            self.send(
                {"kind": "drawing", "to": page, "seq": seq, "took": 0.0, **content}, buffers=[]
            )
        else:
            self.send(
                {"kind": "drawing", "to": page, "seq": seq, **self._content}, buffers=self._buffers
            )

    def picture(self) -> bytes:
        """The board as it is now, as a PNG."""
        return printed(self._shown, self.drawing, self._free)

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.drawing.says})"

    def _repr_mimebundle_(self, **kwargs: Any) -> tuple[dict[str, Any], dict[str, Any]] | None:
        return with_picture(super()._repr_mimebundle_(**kwargs), self, self)


def packed(bitmap: Any) -> bytes:
    """A bitmap as it travels: truths as bits, numbers as bytes; nothing where there is none."""
    if bitmap is None:
        return b""
    return bytes(np.packbits(bitmap).tobytes() if bitmap.dtype == np.bool_ else bitmap.tobytes())


def with_picture(
    bundle: Any, widget: Any, canvas: Any
) -> tuple[dict[str, Any], dict[str, Any]] | None:
    """What a notebook keeps of a widget: its text, its place, and a picture for readers without
    JavaScript.
    """
    data, about = bundle if isinstance(bundle, tuple) else (bundle, {})
    if data is None:
        return None
    picture = base64.b64encode(canvas.picture()).decode("ascii")
    return {**data, "text/plain": repr(widget), "image/png": picture}, about
