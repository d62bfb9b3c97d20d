"""A live canvas: the browser drags and paints, Python answers.

`Canvas(scene, answer)` shows a scene and draws `answer(scene)` over it, again and again while
something is dragged. A lesson writes only the answer: a function from a scene to a Drawing.
The messages between the two halves:

    to Python   {kind: "hello", from}
                    a page has opened and wants the newest drawing
                {kind: "scene", from, seq, moved: [[kind, number, coordinates], ...]}
                {kind: "keys", from, seq, held: ["ArrowUp", ...]}
                    sent repeatedly while arrow keys are held on a driven handle
                {kind: "keep", from}
                    something was let go, and its scene is answered
                {kind: "code", from}
    from Python {kind: "drawing", to, seq, took, brief, text, warning, total, unit, step_texts,
                 listing, first, places, layers, challenges} and a buffer of float32 for each layer
                {kind: "code", to, text}
                    the board as Python code, which the page copies

On a page without a kernel `browser/live.js` sends the same drawings, and {kind: "skipped", to, seq}
in place of one that is out of date.

A scene or keys are answered by a brief drawing, as at its last step; "hello" by the whole one, for
which a page asks again when everything is at rest.

`from` and `to` name a page, because several pages may show one widget. A drawing without `to` and
`seq` is for all pages. Only Python sets traits. On "keep" it sets `scene` to what is shown, which
may be newer than what the page has: others move things too. The bitmap is a trait as well: it is
sent only when it changes.
"""

from __future__ import annotations

import base64
import threading
import uuid
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from copy import deepcopy
from pathlib import Path
from typing import Any

import anywidget
import numpy as np
import traitlets

from ...errors import KinoeduError
from ...figures import palette
from ...messages import get_message
from ...support.json_fields import JsonObject
from .challenge import Posed
from .drawing import Drawing
from .printed import Bitmap, print_board
from .recorded import record_drawing
from .reply import Message, Reply
from .scene import Scene, list_places, move_parts
from .stored import Stored

CORE = Path(__file__).parent
ARROWS = ("ArrowLeft", "ArrowUp", "ArrowDown", "ArrowRight")
CHALLENGED = ("challenge", "reached", "done")
PLAIN = ("play", "pause", "next", "reset", "copy", "copied", "slider", "movable")
WAITING = ("thinking", "lost")
CODE = ("code", "lineBack", "lineOn", "begin", "condition", "old")
HINTS = ("hint", "deeper", "stops", "posed", "driving", "pad", "coded", "pointing", "pointer")
REASONS = ("outside", "cell", "unknown")
FRONT: dict[str, tuple[str, ...]] = {  # the messages that the browser shows, and their values
    **dict.fromkeys((*PLAIN, *WAITING, *CODE, *HINTS, *ARROWS, *REASONS, *CHALLENGED), ()),
    "meets": ("name",),
    "here": ("x", "y", "meaning"),
    "growth": ("shown", "total", "unit"),
    "handle": ("name", "x", "y"),
    "stop": ("name", "x", "y"),
    "driven": ("name", "x", "y"),
    "polygon": ("name", "x", "y"),
    "vertex": ("name", "number", "x", "y"),
}

# Messages and cells may run in different threads: all boards together answer one at a time.
_answering = threading.RLock()


def widget_script(file: Path) -> str:
    """A widget's script, after what the scripts of all widgets use."""
    common = CORE / "common.js"
    return "\n".join(part.read_text(encoding="utf-8") for part in (common, file))


def widget_style(*files: Path) -> str:
    """The style sheet of all boards, a widget's own files, and what VS Code needs besides."""
    parts = (CORE / "board.css", *files, CORE / "vs_code.css")
    return "".join(part.read_text(encoding="utf-8") for part in parts)


class Canvas(Stored, anywidget.AnyWidget):
    """A scene to drag, and the drawing that answers it.

    Parameters
    ----------
    scene : a scene from `make_scene`.
    answer : a function from a scene to a Drawing. A KinoeduError that it raises is shown as a
        warning, over the last good drawing, which turns pale.
    free : a bitmap to draw beneath, (rows, columns), lowest row first. True is free; where the
        scene has `colours`, each cell is the number of a colour.
    drive : a function of the set of arrow keys held, by name. It moves the driven handle; then the
        scene is answered.
    live : what a page needs to answer the scene without Python, as `describe_live` makes it.
    code : a function that writes the board as it is now as Python code, for the button that copies
        it; without one there is no button.

    Attributes
    ----------
    drawing : the answer shown now.
    live : as given; a board changes it with its controls.
    challenges : those that are posed on the board, see `challenge`.
    partner : the key of another board that is scrubbed together with this one, for example a plot
        with its world. All boards with the same partner are scrubbed together.
    lane : where several boards show the same things, the name of this one. Those who hear the names
        of its things hear it first.

    Without JavaScript the board is shown as a picture.
    """

    _esm = widget_script(CORE / "board.js")
    _css = widget_style()
    _reply: Reply
    key = traitlets.Unicode().tag(sync=True)
    partner = traitlets.Unicode().tag(sync=True)
    lane = traitlets.Unicode().tag(sync=True)
    scene = traitlets.Dict().tag(sync=True)
    home = traitlets.Dict().tag(sync=True)
    bitmap = traitlets.Bytes().tag(sync=True)
    copies = traitlets.Bool().tag(sync=True)
    palette = traitlets.Dict().tag(sync=True)
    words = traitlets.Dict().tag(sync=True)

    def __init__(
        self,
        scene: Scene,
        answer: Callable[[Scene], Drawing],
        *,
        free: Bitmap | None = None,
        drive: Callable[[set[str]], None] | None = None,
        live: JsonObject | None = None,
        code: Callable[[], str] | None = None,
    ) -> None:
        self._answer, self._drive, self.live, self._code = answer, drive, live, code
        self.challenges: Posed | None = None
        kind: Any = np.uint8 if "colours" in scene else np.bool_
        self._free = None if free is None else np.asarray(free, kind)
        self._shown = {**scene, "size": None if self._free is None else list(self._free.shape)}
        super().__init__(
            key=uuid.uuid4().hex,
            scene=self._shown,
            home=deepcopy(self._shown),
            bitmap=pack_bitmap(self._free),
            copies=code is not None,
            palette=palette.THEMES,
            words=front_messages(),
        )
        self.on_msg(self._received)
        self.observe(self._arranged, "scene")
        self.refresh()

    def refresh(self) -> None:
        """Answer the same scene again, after something else changed, and show it on every page."""
        with _answering:
            self._draw()
            self._show(None, None, self._complete())

    def follow(self, scene: Scene) -> None:
        """Move all parts to their places in another scene, and show its brief answer on every page.

        The other scene has the same parts. It is for what follows while another canvas is dragged:
        pages ask for the whole when it rests, and `scene` is the caller's to set then.
        """
        with _answering:
            self._shown = scene
            self._draw()
            self._show(None, None, self._with_places())

    def arrange(self, scene: Scene) -> None:
        """`follow` another scene, and keep it as `scene`."""
        with _answering:
            self.follow(scene)
            self.scene = scene  # last, because a page that has the places sends no question

    def set_bitmap(self, bitmap: Bitmap | None) -> None:
        """Replace the bitmap beneath by another of the same size.

        Every page receives it now and paints it together with the next drawing.
        """
        with _answering:
            kind = None if self._free is None else self._free.dtype
            self._free = None if bitmap is None else np.asarray(bitmap, kind)
            self.bitmap = pack_bitmap(self._free)

    def keep(self) -> None:
        """Set `scene` to the scene that is shown."""
        with _answering:
            self.scene = self._shown

    def set_state(self, sync_data: JsonObject) -> None:
        """Accept no trait from a page: it sends messages."""

    def _arranged(self, _: object) -> None:
        """Answer a scene that Python has set."""
        with _answering:
            if self.scene != self._shown:
                self._shown = self.scene
                self._draw()

    def _received(self, _: object, message: object, _buffers: object) -> None:
        """Handle a message from a page; ignore messages of other forms."""
        if not isinstance(message, dict) or not isinstance(message.get("from"), str):
            return
        page, seq = message["from"], message.get("seq")
        with _answering:
            if message.get("kind") == "hello":
                self._show(page, None, self._complete())
            elif message.get("kind") == "keep":
                self.keep()
            elif message.get("kind") == "code" and self._code is not None:
                self.send({"kind": "code", "to": page, "text": self._code()})
            elif message.get("kind") == "scene" and isinstance(seq, int):
                with self._replying(page, seq):
                    self._move(message.get("moved"))
            elif message.get("kind") == "keys" and isinstance(seq, int) and self._drive is not None:
                held = message.get("held")
                keys = held if isinstance(held, list) else []
                with self._replying(page, seq):
                    self._drive({key for key in ARROWS if key in keys})
                    self._draw()

    @contextmanager
    def _replying(self, page: str, seq: int) -> Iterator[None]:
        """Reply to a page after the block, whatever happens in it: the page waits for a reply."""
        before = self._shown, self._reply
        try:
            yield
            message = self._reply.brief
        except KinoeduError as error:
            warning = Drawing(warning=str(error))
            message = Reply(lambda: warning, self._shown).brief
        except BaseException:  # interrupted, or a fault in what the board was given
            self._shown, self._reply = before
            self._show(page, seq, self._with_places())
            raise
        self._show(page, seq, message)

    def _move(self, parts: object) -> None:
        """Move parts of the scene and answer it, unless nothing changed. Raises KinoeduError."""
        scene = move_parts(self._shown, parts)
        if scene != self._shown:
            self._shown = scene
            self._draw()

    def _draw(self) -> None:
        """Answer the scene, or show what is wrong with it."""
        self._reply = Reply(lambda: self._answer(self._shown), self._shown)
        self._shown = move_parts(self._shown, self._reply.brief.content["places"])
        self._judge()

    def _complete(self) -> Message:
        """The whole answer; challenges are judged again where it has a further result."""
        unfinished, whole = self._reply.unfinished, self._reply.whole
        if unfinished:
            self._judge()
        return whole

    def _judge(self) -> None:
        if self.challenges is not None:
            self.challenges.judge()

    def _show(self, page: str | None, seq: int | None, message: Message) -> None:
        """Send a drawing to one page or to all."""
        content, buffers = self._with_challenges(message)
        self.send({"kind": "drawing", "to": page, "seq": seq, **content}, buffers=buffers)

    def _with_places(self) -> Message:
        """The brief answer with the places of all parts, for pages that have them elsewhere."""
        content, buffers = self._reply.brief
        places = [list(part) for part in list_places(self._shown)]
        return Message({**content, "places": places}, buffers)

    def _with_challenges(self, message: Message) -> Message:
        """A message that also says how far the challenges are met."""
        posed = [] if self.challenges is None else self.challenges.answers
        return Message({**message.content, "challenges": posed}, message.buffers)

    @property
    def drawing(self) -> Drawing:
        """The answer shown now."""
        self._complete()
        return self._reply.drawing

    @property
    def shown(self) -> Scene:
        """The scene that `drawing` answers; unlike `scene` also during a drag."""
        return self._shown

    def picture(self) -> bytes:
        """The board as it is now, as a PNG."""
        return print_board(self._shown, self.drawing, self._free)

    def record(self) -> list[JsonObject]:
        """The board as it is now, for pages without a kernel."""
        bitmap = base64.b64encode(pack_bitmap(self._free)).decode("ascii")
        drawing = record_drawing(*self._with_challenges(self._complete()))
        live = {} if self.live is None else {"live": self.live}
        return [{"scene": self._shown, "bitmap": bitmap, "team": 0, **drawing, **live}]

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.drawing.message})"


def front_messages(
    table: str = "board.front", front: Mapping[str, Sequence[str]] = FRONT
) -> dict[str, str]:
    """The messages of a table that the browser shows, by name; it fills in their values."""
    return {
        name: get_message(f"{table}.{name}", **{value: f"{{{value}}}" for value in values})
        for name, values in front.items()
    }


def pack_bitmap(bitmap: Bitmap | None) -> bytes:
    """The bytes of a bitmap as sent: booleans as bits, numbers as bytes, b"" for None."""
    if bitmap is None:
        return b""
    return bytes(np.packbits(bitmap).tobytes() if bitmap.dtype == np.bool_ else bitmap.tobytes())
