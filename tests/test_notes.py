"""What boards say of the thing under the pointer, before a browser shows it."""

import re
import string
from pathlib import Path

import numpy as np
import pytest
from test_board import walled
from test_recorded import MAKERS, stored

import kinoedu as ke
from kinoedu.boards import (
    board,
    car_board,
    rewiring_board,
    roadmap_board,
    search_board,
    sweep_board,
)
from kinoedu.boards.core.drawing import dots, edges, encode_drawing, nodes
from kinoedu.boards.core.framed import find_canvases
from kinoedu.boards.core.notes import FILLED, note, with_notes
from kinoedu.boards.planning.plans import draw_plan
from kinoedu.messages import catalogue, get_message

GARAGE = ke.PolygonWorld([(0, 0), (20, 0), (20, 20), (0, 20)], [[(9, 0), (11, 0), (11, 9), (9, 9)]])


def blocked(problem):
    """A planner that asks about a motion through the wall."""
    problem.is_free_path((1, 1), (2, 5))
    return [problem.start, problem.goal]


SAYING = {
    **MAKERS,
    "roadmap": lambda: board(walled(), planner="prm", samples=40),
    "growing roadmap": lambda: roadmap_board(walled(), n=40),
    "A* on a grid": lambda: board(walled(), planner="astar"),
    "own": lambda: board(walled(), planner=blocked),
    "rewiring": lambda: rewiring_board(walled(), nodes=60, step_size=1),
    "sweep": lambda: sweep_board(walled().world, x=8),
    "search": lambda: search_board(np.ones((4, 5), bool), search="astar"),
    "car": lambda: car_board(
        ke.Problem(ke.Car(3, 1, 2), GARAGE, (4, 4, 0), (16, 4, 0)), max_iterations=60
    ),
}


def saying_layers(made):
    """The layers that say something, of all pictures of a board."""
    canvases = [made] if not hasattr(made, "children") else find_canvases(made)
    return [layer for one in canvases for layer in one.drawing.layers if layer.says]


@pytest.mark.parametrize("make", SAYING.values(), ids=SAYING)
def test_every_blank_of_a_text_is_filled(make):
    """By a number of the row, or by the browser."""
    for layer in saying_layers(make()):
        for text in layer.says:
            blanks = {name for _, name, _, _ in string.Formatter().parse(text) if name}
            assert blanks <= {*layer.names, *FILLED}
        if layer.names:
            assert layer.notes.shape == (len(layer.rows), len(layer.names))


@pytest.mark.parametrize("name", sorted(set(SAYING) - {"code"}))
def test_boards_say_something(name):
    assert saying_layers(SAYING[name]())


def test_the_branch_of_a_node_leads_to_the_start():
    """By its numbers alone; its length is the cost of the path, which ends at the last node."""
    made = board(walled(), step_size=0.5)
    (layer,) = saying_layers(made)
    rows = {int(node): k for k, (node, _) in enumerate(layer.notes.tolist())}
    node = next(k for k, row in enumerate(layer.rows) if row[2:].tolist() == [9, 1])
    length, at = 0.0, int(layer.notes[node, 0])
    while at in rows:
        begin, end = layer.rows[rows[at]].reshape(2, 2)
        length += np.hypot(*(end - begin))
        at = int(layer.notes[rows[at], 1])
    assert at == 0 and begin.tolist() == [1, 1]
    assert length == pytest.approx(made.plan.cost)


def test_both_trees_of_rrt_connect_have_branches():
    tree, other = (
        layer
        for layer in draw_plan(ke.rrt_connect(walled(), step_size=1, rng=0)).layers
        if layer.says
    )
    assert {0, 1} >= {p for p in tree.notes[:, 1] if p not in tree.notes[:, 0]}
    roots = {p for p in other.notes[:, 1] if p not in other.notes[:, 0]}
    assert len(roots) == 1 and not roots & set(tree.notes[:, 0])


def test_a_text_is_sent_once_and_a_node_costs_eight_bytes():
    """The tree of 10,000 nodes: two numbers of four bytes each, and not one string."""
    n = 10_000
    rng = np.random.default_rng(0)
    rows, when = rng.random((n, 2, 2)), np.arange(n)
    bare = edges(rows, "tree", when=when)
    told = with_notes(bare, note("node", node=None), node=np.arange(n), parent=np.arange(n) - 1)
    (about, plain), (noted_about, noted) = (
        encode_drawing(ke.boards.Drawing([layer]), (0, 0), 1.0) for layer in (bare, told)
    )
    assert len(noted[0]) - len(plain[0]) == 8 * n
    assert len(str(noted_about)) - len(str(about)) < 200
    row = np.frombuffer(noted[0], np.float32).reshape(n, 7)[17]
    assert row[4:].tolist() == [17, 16, 17]  # its notes, then the step at which it comes


def test_layers_without_notes_are_sent_as_before():
    about, _ = encode_drawing(ke.boards.Drawing([edges([[(0, 0), (1, 1)]], "tree")]), (0, 0), 1.0)
    assert not {"says", "names"} & set(about["layers"][0])


def test_a_search_says_the_costs_at_each_step():
    """g, h and f of A* as its expansions have them, and nothing of nodes not seen yet."""
    made = search_board(np.ones((3, 4), bool), search="astar")
    (layer,) = saying_layers(made)
    assert layer.kind == "nodes" and layer.names == ("node", "parent", "which", "g", "h", "f")
    for step, moment in enumerate(made.moments, start=1):
        there = (layer.when <= step) & (layer.until > step)
        rows = layer.notes[there]
        assert sorted(rows[:, 0]) == list(range(12))  # each node once
        costs = dict(zip(rows[:, 0].astype(int).tolist(), rows[:, 3].tolist(), strict=True))
        assert [costs[node] for node in range(12)] == moment.cost.tolist()
        assert int(rows[rows[:, 2] == 3, 0][0]) == moment.node
    assert "{g}" in layer.says[1] and "{g}" not in layer.says[0]


def test_a_cell_says_what_it_is_joined_to():
    """The wall leaves a cell on the left, one above, and one on the right."""
    (layer,) = saying_layers(sweep_board(walled().world, x=9.9999))
    assert len(layer.rows) == 2  # the third is still open
    texts = [
        layer.says[int(which)].format(**dict(zip(layer.names[1:], map(int, numbers))))
        for which, *numbers in layer.notes
    ]
    assert texts[0].endswith("joined to 2") and texts[1].endswith("joined to 1")


def test_motions_that_were_refused_say_why():
    refused = [one for one in saying_layers(board(walled(), planner=blocked)) if one.dash]
    assert refused and all("{why}" in text for one in refused for text in one.says)


def test_what_is_stored_says_the_same():
    """The numbers of a record are those of the board."""
    _, (record,) = stored(MAKERS["planner"]())
    layer = record["drawing"]["layers"][0]
    assert layer["names"] == ["node", "parent"] and "{length}" in layer["says"][0]


def test_colours_of_the_square_have_meanings():
    world = ke.PolygonWorld([(-4, -4), (4, -4), (4, 4), (-4, 4)], [((2, 1), 0.5)])
    made = ke.boards.arm_board(ke.TwoLinkArm(1.5, 1.2, 0.2), world)
    scene = made.square.scene
    assert len(scene["meanings"]) == len(scene["colours"]) == made.image.max() + 1


def test_notes_fit_their_layer():
    with pytest.raises(ValueError, match="broadcast"):
        with_notes(dots([(0, 0), (1, 1)], "tree"), "{a}", a=[1, 2, 3])
    assert nodes([(0, 0)]).says == ()


def test_all_notes_of_the_catalogue_are_used():
    """A message that no board shows is one that nobody has read."""
    names = set(catalogue("en")["board"]["note"])
    source = "".join(
        file.read_text(encoding="utf-8")
        for room in ("boards", "browser")
        for file in (Path(ke.__file__).parent / room).rglob("*.py")
    )
    assert all(re.search(rf'["\.]{name}"', source) for name in names)
    assert get_message("board.note.alone")
