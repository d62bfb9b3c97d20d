"""Boards as they were stored: what a page without a kernel needs to show, play and scrub them."""

import base64
import json
import zlib
from collections.abc import Iterable, Sequence

import numpy as np

from ...support.json_fields import JsonObject

RECORD = "application/vnd.kinoedu.board+json"  # the type of a notebook's output that holds boards
VERSION = 1
FINE = 2**13  # coordinates are kept to this part of the world's size, finer than a pixel


def record_drawing(message: JsonObject, buffers: Sequence[bytes]) -> JsonObject:
    """A drawing as `encode_drawing` makes it, as plain data with rounded coordinates."""
    rounded = [
        np.float32(np.round(np.frombuffer(buffer, np.float32).astype(float) * FINE) / FINE)
        for buffer in buffers
    ]
    texts = [base64.b64encode(numbers.tobytes()).decode("ascii") for numbers in rounded]
    kept = {name: value for name, value in message.items() if name not in ("took", "places")}
    return {"drawing": {**kept, "took": 0.0, "places": []}, "buffers": texts}


def pack_records(boards: Iterable[JsonObject]) -> JsonObject:
    """Boards of one output as a notebook stores them: compressed."""
    text = json.dumps(list(boards), separators=(",", ":"))
    packed = zlib.compress(text.encode("utf-8"), 9)
    return {"version": VERSION, "boards": base64.b64encode(packed).decode("ascii")}


def unpack_records(record: JsonObject) -> list[JsonObject]:
    """The boards of an output.

    >>> unpack_records(pack_records([{"scene": {}, "team": 0}]))
    [{'scene': {}, 'team': 0}]
    """
    boards: list[JsonObject] = json.loads(zlib.decompress(base64.b64decode(record["boards"])))
    return boards
