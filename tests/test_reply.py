"""Boards answer briefly while something is dragged, and wholly when it rests."""

import numpy as np
import pytest
from test_board import walled

from kinoedu.boards import (
    Canvas,
    Drawing,
    board,
    bug_board,
    exploring_board,
    properties_board,
    race_board,
    rewiring_board,
)
from kinoedu.boards.core.drawing import dots, edges, encode_drawing, labels, nodes
from kinoedu.boards.core.framed import find_canvases
from kinoedu.boards.core.notes import note, with_notes
from kinoedu.boards.core.reply import Reply
from kinoedu.boards.core.scene import frame_of, handle, make_scene
from kinoedu.boards.exploring.exploring import DRAGGED
from kinoedu.boards.tracing import code_run
from kinoedu.errors import InvalidParameter


def hear(canvas):
    """The messages that a canvas sends from now on, with their buffers."""
    heard = []
    canvas.send = lambda content, buffers=(): heard.append((content, buffers))
    return heard


def drag_goal(canvas, x, y):
    """Move the second handle, as a page does."""
    moved = [["handle", 1, [x, y]]]
    canvas._received(None, {"kind": "scene", "from": "page", "seq": 1, "moved": moved}, [])


def come_to_rest(canvas):
    canvas._received(None, {"kind": "hello", "from": "page"}, [])


def two_points():
    """A scene of two handles."""
    handles = [handle(name, (k, k), colour="start") for k, name in enumerate("qp")]
    return make_scene((0, 0), (9, 9), handles=handles)


def growing_layers():
    """One that grows, one whose rows disappear, texts, and rows that only say something."""
    rows = np.arange(8.0).reshape(4, 2)
    tree = edges(rows.reshape(2, 2, 2), "tree", when=[1, 3])
    return [
        with_notes(tree, note("node", node=None), node=[1, 2], parent=[0, 1]),
        dots(rows, "ink", when=[0, 1, 2, 3], until=[1, 2, 3, 4]),
        labels(rows[:2], ["then", "now"], "ink", when=[0, 3], until=[3, 9]),
        nodes(rows, when=[0, 1, 2, 3]),
    ]


def test_the_end_of_a_drawing_is_its_last_step():
    """What has disappeared, notes and earlier texts are left out."""
    drawing = Drawing(growing_layers(), total=3, step_texts=["a", "b", "c"], text="there")
    end = drawing.at_end()
    assert [layer.kind for layer in end.layers] == ["edges", "dots", "labels"]
    assert [len(layer.rows) for layer in end.layers] == [2, 1, 1]
    assert end.layers[2].texts == ("now",) and end.layers[0].says == ()
    assert all(layer.when is None and layer.until is None for layer in end.layers)
    assert (end.text, end.total, list(end.step_texts)) == ("there", 3, [])


def test_a_drawing_without_steps_is_answered_once():
    """There is nothing to ask for when it rests."""
    canvas = Canvas(two_points(), lambda _: Drawing([dots([[1, 1]], "tree")]))
    heard = hear(canvas)
    drag_goal(canvas, 3.0, 3.0)
    assert [content["brief"] for content, _ in heard] == [False]


def test_a_drag_waits_for_brief_answers_only():
    """The time that a page is told is that of a brief answer, however long the whole one takes."""
    reply = Reply(
        lambda: Drawing(text="there").completed_by(lambda: Drawing(text="all")), two_points()
    )
    brief, whole = reply.brief.content, reply.whole.content
    assert (brief["text"], whole["text"]) == ("there", "all")
    assert whole["took"] == brief["took"]


def test_a_drag_is_answered_briefly_and_a_rest_wholly():
    made = rewiring_board(walled(), nodes=60, step_size=1.0)
    heard = hear(made.canvas)
    drag_goal(made.canvas, 9.0, 2.0)
    come_to_rest(made.canvas)
    (brief, few), (whole, many) = heard
    assert brief["brief"] and not whole["brief"]
    assert brief["text"] == whole["text"] and brief["total"] == whole["total"]
    assert not brief["step_texts"] and len(whole["step_texts"]) == whole["total"]
    assert 5 * sum(map(len, few)) < sum(map(len, many))
    assert made.canvas.drawing.step_texts[-1] != made.canvas.drawing.text


def race(problem):
    return race_board(problem, nodes=80, step_size=1.0)


def bugs(_):
    return bug_board((0, 0), (4, 0), [[(1, -1), (2, -1), (2, 2), (1, 2)]], bug="all")


def one_bug(_):
    return bug_board((0, 0), (4, 0), [[(1, -1), (2, -1), (2, 2), (1, 2)]])


@pytest.mark.parametrize("make", [rewiring_board, race, bugs, one_bug])
def test_a_drag_shows_the_last_step_of_what_is_there_at_rest(make):
    """In every picture of a board, also in those that follow the one that is dragged."""
    made = make(walled())
    canvases = find_canvases(made)
    heard = [hear(canvas) for canvas in canvases]
    drag_goal(canvases[0], 3.0, 1.0)
    for canvas, sent in zip(canvases, heard, strict=True):
        brief, few = sent[-1]
        assert brief["brief"] and not brief["step_texts"]
        whole = canvas.drawing
        assert (brief["text"], brief["total"]) == (whole.text, whole.total) and whole.step_texts
        end, many = encode_drawing(whole.at_end(), *frame_of(canvas.shown))
        assert [layer["kind"] for layer in brief["layers"]] == [
            one["kind"] for one in end["layers"]
        ]
        assert few == many


def test_an_exploration_shows_its_first_looks_while_it_is_dragged():
    """The others follow at rest, as if all had been made at once; a short one is whole at once."""
    made = exploring_board(walled(), 4.0)
    plan, looks = made.plan, len(made.looks)
    heard = hear(made.canvas)
    drag_goal(made.canvas, 9.0, 2.0)
    drag_goal(made.canvas, 9.0, 1.0)
    assert f"the first {DRAGGED} looks" in heard[-1][0]["text"] and len(made.looks) == DRAGGED
    come_to_rest(made.canvas)
    assert len(made.looks) == looks > DRAGGED and np.array_equal(made.plan.path, plan.path)
    assert heard[-1][0]["text"] == made.canvas.drawing.text != heard[-2][0]["text"]
    drag_goal(made.canvas, 1.5, 1.5)
    assert "at the goal" in heard[-1][0]["text"]


def test_a_roadmap_is_measured_at_few_places_while_it_is_dragged():
    """And at all of them at rest."""
    made = properties_board(walled(), n=40)
    text, heard = made.canvas.drawing.text, hear(made.canvas)
    ring = made.canvas.scene["polygons"][0]["rings"][0]
    for by in (0.5, 0.0):
        moved = [["polygon", 0, [[[x + by, y] for x, y in ring]]]]
        made.canvas._received(None, {"kind": "scene", "from": "page", "seq": 1, "moved": moved}, [])
    assert len(made.survey.places) == 25 and "when nothing moves" in heard[-1][0]["text"]
    come_to_rest(made.canvas)
    assert len(made.survey.places) == 100 and heard[-1][0]["text"] == text


def test_lines_are_traced_only_at_rest(monkeypatch):
    """While the goal is dragged machine code answers alone."""
    made = board(walled(), step_size=0.5)
    made.code.value = True
    traced = []
    monkeypatch.setattr(
        code_run.CodeRun, "draw_over", lambda run, drawing: traced.append(run) or drawing
    )
    hear(made.canvas)
    drag_goal(made.canvas, 9.0, 2.0)
    drag_goal(made.canvas, 9.0, 3.0)
    assert not traced
    come_to_rest(made.canvas)
    come_to_rest(made.canvas)
    assert len(traced) == 1


@pytest.mark.parametrize("seconds", [0.0, 1e9])
def test_tracing_has_a_budget_of_time(monkeypatch, seconds):
    """Without time one line is kept; the text says how many are."""
    monkeypatch.setattr(code_run, "SECONDS", seconds)
    made = board(walled(), step_size=0.5)
    made.code.value = True
    drawing = made.canvas.drawing
    kept = len(drawing.listing.ran)
    assert kept == 1 if seconds == 0.0 else kept > 100
    assert ("the first 1 line" in drawing.text) == (seconds == 0.0)


def test_what_fails_at_rest_is_shown():
    """An exception of the part that makes the whole becomes a warning."""

    def fail():
        raise ZeroDivisionError("nothing is left")

    canvas = Canvas(two_points(), lambda _: Drawing(total=2, text="quick").completed_by(fail))
    heard = hear(canvas)
    drag_goal(canvas, 3.0, 3.0)
    come_to_rest(canvas)
    assert heard[0][0]["warning"] == "" and "nothing is left" in heard[1][0]["warning"]


@pytest.mark.parametrize(
    ("layer", "says"),
    [
        (dots([(0, 0)], "pink"), "no colour is named 'pink'; the names are start, goal, "),
        (dots([(0, 0), (1, 1)], "ink", when=[1]), "each of the 2 rows of dots needs one of when"),
        (labels([(0, 0), (1, 1)], ["a"], "ink"), "each of the 2 rows of labels needs one of texts"),
    ],
)
def test_a_layer_that_cannot_be_drawn_is_said_on_the_board(layer, says):
    """Where a page would show nothing, and the stored picture would fail."""
    made = Canvas(make_scene((0, 0), (1, 1)), lambda scene: Drawing([layer], text="drawn", total=1))
    assert made.drawing.warning.startswith(says)
    assert made._repr_mimebundle_()[0]["image/png"]


def test_a_handle_needs_a_colour_of_the_palette():
    with pytest.raises(InvalidParameter, match="no colour is named 'pink'"):
        handle("q", (0, 0), colour="pink")
