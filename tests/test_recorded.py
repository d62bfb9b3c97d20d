"""Boards as notebooks store them, for pages without a kernel."""

import base64
import json

import numpy as np
import pytest
from test_board import walled

import kinoedu as ke
from kinoedu.boards import board, bug_board, code_board
from kinoedu.boards.core.drawing import encode_drawing
from kinoedu.boards.core.recorded import RECORD, unpack_records

BOX = [(1, -1), (2, -1), (2, 2), (1, 2)]
CUBE = [(0, 0), (2, 0), (2, 1)]


def middle(a, b):
    c = (a + b) / 2
    return c / 2


MAKERS = {
    "planner": lambda: board(walled(), step_size=0.5),
    "bug": lambda: bug_board((0, 0), (4, 0), [BOX]),
    "code": lambda: code_board(middle, (0.0, 0.0), (1.0, 3.0), first=1),
    "terrain": lambda: board(
        ke.Problem(ke.Point(), ke.Terrain(np.ones((9, 7))), (0.5, 0.5), (5.5, 6.5))
    ),
}


def stored(made):
    """What a notebook stores of a board: its data, and the boards recorded in it."""
    data, _ = made._repr_mimebundle_()
    return data, unpack_records(json.loads(json.dumps(data[RECORD])))


@pytest.mark.parametrize("make", MAKERS.values(), ids=MAKERS)
def test_a_notebook_stores_the_board_beside_its_picture(make):
    """The same each time, so that a notebook that is run again does not change."""
    data, records = stored(make())
    assert data["image/png"] and data[RECORD] == stored(make())[0][RECORD]
    assert len(data[RECORD]["boards"]) < 60_000
    for record in records:
        drawing = record["drawing"]
        assert len(drawing["layers"]) == len(record["buffers"]) and drawing["took"] == 0.0
        assert {"lo", "hi", "handles"} <= set(record["scene"])


def test_places_are_finer_than_a_pixel():
    """A picture is at most 640 pixels wide."""
    made = board(walled(), step_size=0.5)
    _, (record,) = stored(made)
    _, buffers = encode_drawing(made.canvas.drawing, (0, 0), 10.0)
    for kept, buffer in zip(record["buffers"], buffers, strict=True):
        short, exact = (
            np.frombuffer(data, np.float32) for data in (base64.b64decode(kept), buffer)
        )
        assert np.abs(short - exact).max(initial=0.0) < 0.2 / 640


def test_a_world_and_its_plot_stay_together():
    """Boards that are scrubbed together have one number."""
    _, records = stored(bug_board((0, 0), (4, 0), [BOX]))
    assert [record["team"] for record in records] == [0, 0]


def test_the_bits_of_a_terrain_are_stored():
    _, (record,) = stored(MAKERS["terrain"]())
    assert len(base64.b64decode(record["bitmap"])) == 8 and record["scene"]["size"] == [9, 7]


def test_the_code_and_the_step_are_stored():
    _, (record,) = stored(MAKERS["code"]())
    assert record["drawing"]["first"] == 1
    assert record["drawing"]["listing"]["lines"][0] == "def middle(a, b):"


def test_a_solid_has_only_its_picture():
    data, _ = ke.boards.turning_board(CUBE, CUBE, place=(3, 3))._repr_mimebundle_()
    assert RECORD not in data and data["image/png"]
