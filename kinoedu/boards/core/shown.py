"""What a body shows as a drawing of a board. Pages without Python do the same: `browser/live.js`.

So a board whose answer is a body needs no lines of its own to draw it, and works in both places.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from ...browser.arms import CORNERS
from ...browser.bodies import BODIES
from ...browser.looks import (
    DOT,
    HANDLES,
    IMAGE,
    LINE,
    LIST,
    TEXTS,
    TOTAL,
    Body,
    Look,
    in_form,
    split_form,
    template_of,
)
from ...browser.scenes import RING_FAULT, pack_scene
from ...errors import InvalidPolygon
from ...figures.drawing import dot_size, line_width
from ...geometry.checks import Array
from ...geometry.rings import RingFault, describe_ring_fault
from ...messages import chosen_language, get_message
from ...support.json_fields import JsonObject
from .drawing import Drawing, Layer
from .notes import with_notes
from .scene import Scene

# the columns of each kind that are coordinates
COORDINATES = {
    "edges": 4,
    "path": 2,
    "dots": 2,
    "arrows": 4,
    "labels": 2,
    "cells": 8,
    "nodes": 2,
    "bodies": CORNERS,
}


def make_live(name: str, settings: Sequence[float]) -> JsonObject:
    """What a page needs to answer a board by a body with these settings, for `Canvas`."""
    return {"body": name, "seed": 0, "settings": {name: list(settings)}}


def answer_by(name: str, settings: Sequence[float], scene: Scene) -> Drawing:
    """The answer of a body to a scene.

    Raises
    ------
    InvalidPolygon
        Where a ring of the scene is not a simple polygon.
    """
    body = BODIES[name]
    shown = body.function(pack_scene(scene), body.settings(*settings), np.random.default_rng(0))
    status, *facts = shown.facts.tolist()
    if status <= RING_FAULT:
        raise fault_of(scene, int(RING_FAULT - status), *map(int, facts))
    return draw_shown(body, int(status), facts, shown)


def draw_shown(body: Body, status: int, facts: Sequence[float], shown: Any) -> Drawing:
    """A drawing of the layers that a body shows."""
    layers, places = list[Layer](), list[tuple[str, int, Any]]()
    told = [look for look in body.layers if look.kind == TEXTS]
    named = [(*split_form(form), fact) for form, fact in zip(body.facts, facts)]
    values = {name: fact for name, _, fact in named}
    blanks = {name: in_form(fact, form) for name, form, fact in named if form}
    for look in body.layers:
        rows = getattr(shown, look.field)
        if look.kind == HANDLES:
            places += [("handle", int(number), at) for number, *at in rows.tolist()]
        elif look.kind == LIST:
            blanks[look.field] = ", ".join(fill_texts(look, rows))
        elif len(rows) and look.kind not in (IMAGE, TEXTS):
            layers.append(make_layer(look, rows, values))
    text = template_of(body.says[status], chosen_language())
    text = text.format(**blanks)
    total, unit = int(values.get(TOTAL, 0)), get_message(body.unit) if body.unit else ""
    drawing = Drawing(layers, text=text, total=total, unit=unit, places=places)
    if not told:
        return drawing
    return drawing.with_texts(lambda: fill_texts(told[0], getattr(shown, told[0].field)))


def draw_beside(body: Body, status: int, facts: Sequence[float], shown: Any) -> Drawing:
    """The drawing of a body's second picture."""
    assert body.beside is not None
    names = [split_form(fact)[0] for fact in body.facts]
    chosen = facts[names.index(body.beside.chosen)] if body.beside.chosen else status
    second = body._replace(says=body.beside.says, layers=body.beside.layers)
    return draw_shown(second, int(chosen), facts, shown)


def make_layer(look: Look, rows: Array, values: dict[str, float]) -> Layer:
    """The layer of a look, in a drawing with these facts."""
    columns, is_path = COORDINATES[look.kind], look.kind == "path"
    width = width_of(look.width, values, len(rows))
    layer = Layer(look.kind, rows[:, :columns], look.colour, width, look.dash)
    layer = layer._replace(last=is_path, casing=is_path, hatched=look.hatched)
    if look.ends:
        layer, rows = layer._replace(until=rows[:, -1]), rows[:, :-1]
    if look.grows:
        layer = layer._replace(when=rows[:, -1])
    if look.kind == "labels" and look.says:
        return layer._replace(texts=tuple(fill_texts(look, rows[:, columns:])))
    if look.kind == "labels":
        return layer._replace(texts=tuple(in_form(row[columns], look.form) for row in rows))
    if not look.says:
        return layer
    numbers = dict(zip(look.names, rows[:, columns:].T))
    return with_notes(layer, *templates_of(look), **numbers)


def width_of(width: float | str, values: dict[str, float], rows: int) -> float:
    """The width of a look in pixels."""
    if not isinstance(width, str):
        return width
    if width == LINE:
        return line_width(int(values[TOTAL]))
    return dot_size(rows) / 2.0 if width == DOT else values[width]


def fill_texts(look: Look, rows: Array) -> list[str]:
    """The text of each row."""
    templates, named = templates_of(look), [split_form(name) for name in look.names]
    texts = []
    for row in rows.tolist():
        values = {name: in_form(number, form) for (name, form), number in zip(named, row)}
        texts.append(templates[int(values.get("which", 0))].format(**values))
    return texts


def templates_of(look: Look) -> list[str]:
    """What the rows of a look say, with blanks."""
    return [template_of(say, chosen_language()) for say in look.says]


def fault_of(scene: Scene, kind: int, ring: int, i: int, j: int) -> InvalidPolygon:
    """The error for a ring of a scene; ring 0 is the boundary."""
    edge_of_world: JsonObject = {"name": "boundary", "rings": [scene["boundary"]]}
    item = scene["polygons"][ring - 1] if ring else edge_of_world
    points = np.array(item["rings"][0])
    return InvalidPolygon(describe_ring_fault(points, RingFault(kind, i, j), item["name"]))
