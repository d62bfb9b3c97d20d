"""What a notebook stores of a board, for readers without a kernel: a picture and a record."""

from __future__ import annotations

import base64
from typing import Any

from ...support.json_fields import JsonObject
from .printed import fit_page
from .recorded import RECORD, pack_records


class Stored:
    """The base of widgets that are stored with their text, their picture and their record.

    It stands before the widget's class among the bases. Each has `picture` and `record`.
    """

    def picture(self) -> bytes:
        """The board as it is now, as a PNG."""
        raise NotImplementedError

    def record(self) -> list[JsonObject]:
        """The board as it is now, for pages without a kernel; by default they show the picture."""
        return []

    def _repr_mimebundle_(self, **kwargs: Any) -> tuple[JsonObject, JsonObject] | None:
        bundle = super()._repr_mimebundle_(**kwargs)  # type: ignore[misc]  # that of the widget
        data, about = bundle if isinstance(bundle, tuple) else (bundle, {})
        if data is None:
            return None
        picture, size = fit_page(self.picture())
        shown = {"text/plain": repr(self), "image/png": base64.b64encode(picture).decode("ascii")}
        records = self.record()
        recorded = {RECORD: pack_records(records)} if records else {}
        return {**data, **shown, **recorded}, {**about, "image/png": size}
