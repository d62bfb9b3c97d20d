"""Challenges on boards: each can be reached, none is at first, and all answer in words."""

import json
from functools import partial
from pathlib import Path

import numpy as np
import pytest
import shapely
from test_board import Page

import kinoedu as ke
from kinoedu.boards import (
    Challenge,
    arm_board,
    board,
    bug_board,
    car_board,
    challenge,
    challenges,
    chance_board,
    curves_board,
    distance_board,
    moving_board,
    properties_board,
    race_board,
    reach_board,
    roadmap_board,
    samples_board,
    search_board,
    slide_board,
    sweep_board,
    torus_board,
)
from kinoedu.boards.core.recorded import RECORD, unpack_records
from kinoedu.errors import InvalidParameter
from kinoedu.messages import catalogue
from kinoedu.sampling import largest_empty_ball, uniform_random

LESSONS = sorted((Path(ke.__file__).parent.parent / "notebooks").glob("[01][0-9]_*.ipynb"))
NOTCHED = [(0, 0), (6, 0), (6, 4), (4, 4), (4, 2), (2, 2), (2, 5), (0, 5)]
ROOM = [(0, 0), (20, 0), (20, 12), (0, 12)]
WALLS = [
    [(4, 0), (5, 0), (5, 7), (4, 7)],
    [(8, 4), (9, 4), (9, 12), (8, 12)],
    [(12, 1), (15, 2), (14, 5)],
    [(13, 7), (16, 7), (16, 10), (13, 9)],
]
HALL = ke.Problem(ke.Point(), ke.PolygonWorld(ROOM, WALLS), (1.5, 2), (18, 9))
HOUSE = ke.Problem(
    ke.Point(),
    ke.PolygonWorld(
        [(0, 0), (16, 0), (16, 10), (0, 10)],
        [
            [(5, 0), (6, 0), (6, 4), (5, 4)],
            [(5, 6), (6, 6), (6, 10), (5, 10)],
            [(10, 2), (11, 2), (11, 8), (10, 8)],
            [(13, 3), (15, 4), (14, 6)],
            [(2, 4), (3.5, 5), (2.5, 7)],
        ],
    ),
    (1, 1),
    (15, 9),
)
FIELD = ke.PolygonWorld(
    [(0, 1), (8, -1), (20, 0), (19, 11), (10, 13), (1, 11.5)],
    [[(3, 3), (6, 2), (5, 8)], [(9, 5), (13, 2.5), (15, 6), (12, 9.5)]],
)
ARM = ke.TwoLinkArm(1.5, 1.2, 0.25)
CELL = ke.PolygonWorld(
    [(-3.2, -3.2), (3.2, -3.2), (3.2, 3.2), (-3.2, 3.2)],
    [((2.1, 1.3), 0.75), ((-0.4, -1.1), 0.35)],
)
ROBOT = np.array([(0, 0), (2, 0), (0, 1)], float)
STONE = np.array([(4, 2), (6, 2), (6.5, 3), (5, 4)], float)
YARD = ke.PolygonWorld(
    [(10, 10), (290, 10), (290, 290), (10, 290)],
    [
        [(75, 75), (100, 75), (100, 100), (75, 100)],
        [(125, 175), (225, 175), (235, 165), (135, 165)],
    ],
)
DRIVE = ke.Problem(ke.Car(30, 10, 20), YARD, (250, 250, 0), (50, 50, np.pi / 2))
POSTS = ke.worlds.scattered(20, side=30, radius=2.2, keep_free=[(2, 2, 1.5), (28, 28, 1.5)], rng=4)
THINGS = [
    ((3, 4), 0.8),
    [(7, 1), (10, 1), (10, 2), (8, 2), (8, 4), (7, 4)],
    [(4, 6), (6, 6), (5, 7.2)],
]
UNSURE = ke.UncertainWorld([(0, 0), (12, 0), (12, 8), (0, 8)], THINGS, [0.3, 0.2, 0.4])
ROADS = ke.Graph(
    nodes=[(0, 0), (1, 1), (2, 2), (3, 1), (2, -1), (1, -2), (4, 0), (-1, 0), (-2, 1)],
    edges=[(0, 1), (1, 2), (2, 3), (3, 6), (0, 4), (4, 6), (0, 5), (0, 7), (7, 8), (4, 5)],
)
NAMES = set(challenges.__all__)


def spiral():
    """A square spiral, two walls wide, as in the lesson."""
    line = [(0, 0)]
    for k in range(14):
        (dx, dy), size = ((1, 0), (0, 1), (-1, 0), (0, -1))[k % 4], 1 + k // 2
        line.append((line[-1][0] + size * dx, line[-1][1] + size * dy))
    wall = shapely.LineString(line).buffer(0.2, cap_style="flat", join_style="mitre")
    return wall.exterior.coords[:-1]


def doorway():
    """A robot that must pass a place where something goes to and fro."""
    world = ke.MovingWorld(
        ke.PolygonWorld([(0, 0), (20, 0), (20, 4), (0, 4)]),
        [ke.Moving([(-1, -2), (1, -2), (1, 2), (-1, 2)], [0, 12, 14], [(10, 2), (10, 2), (10, 8)])],
    )
    return ke.TimedProblem(ke.Disk(0.4), world, start=(2, 2), goal=(18, 2), speed=1)


def straight(problem):
    return [problem.start, problem.goal]


def only_short(problem):
    """A planner that gives up on long ways."""
    near = np.hypot(*(problem.goal - problem.start)) < 5
    return [problem.start, problem.goal] if near else None


def shifted(ring, by):
    return (np.array(ring, float) + by).tolist()


def round_the_wall(problem):
    x, y = problem.start
    return [problem.start, (x, y + 8), (problem.goal[0], y + 8), problem.goal]


def drag(*parts):
    """Move parts of the first picture, each (kind, number, coordinates)."""
    return lambda made: Page(canvas_of(made)).moves(*parts)


def put(**values):
    """Set controls."""

    def act(made):
        for name, value in values.items():
            control = getattr(made, name, None) or getattr(made.controls, name)
            control.value = value

    return act


def both(*acts):
    """One thing after another."""

    def act(made):
        for one in acts:
            one(made)

    return act


def in_square(q):
    """Put the configuration of an arm's board."""
    return lambda made: Page(made.square).moves(("handle", 0, q))


def canvas_of(made):
    return getattr(made, "canvas", made)


def handles(*places):
    return drag(*(("handle", number, list(place)) for number, place in enumerate(places)))


def wall_moves(by):
    """Move the first wall of the hall."""
    return drag(("polygon", 0, [shifted(WALLS[0], by)]))


DISTANCE = partial(distance_board, NOTCHED, (3.2, 2.9))
BUGS = partial(bug_board, (-6, 0.5), (6, 0.5), [spiral()], bug="bug2")
SWEEP = partial(sweep_board, FIELD)
GRAPH = partial(search_board, ROADS, start=7, goal=8)
SAMPLES = partial(samples_board, "random", 60)
CURVES = partial(curves_board, (0, 0, 0), (30, 40, -2.5), radius=20)
RACE = partial(race_board, HALL, [ke.rrt, ke.rrt_connect], step_size=1.0)
THEIRS = partial(race_board, HALL, [straight, round_the_wall])
CAR = partial(car_board, DRIVE)
PRM = partial(
    board,
    ke.Problem(ke.Disk(ke.Car(1.4, 0.6, 0.9).radius), POSTS, (2, 2), (28, 28)),
    planner="prm",
    samples=60,
    rng=1,
)

# For each challenge: a board where it is not reached, how it is reached, and what does not do.
WAYS = {
    "between_two_walls": (DISTANCE, handles((3, 3.5)), handles((8, 2))),
    "diagonal_tangent": (DISTANCE, handles((7.5, -1.5)), handles((8, 2))),
    "bug2_walks_farther": (BUGS, both(put(turn="right"), handles((0.4, 0.6))), handles((0.4, 0.6))),
    "bug0_is_lost": (BUGS, handles((0.4, 0.6)), put(turn="right")),
    "eight_edges": (
        SWEEP,
        drag(
            ("handle", 0, [11.5, -2]),
            ("polygon", 0, [[[11, 10.4], [12, 10.6], [11.5, 11.2]]]),
            ("polygon", 1, [[[9, 5], [13, 2.5], [10.5, 6], [12, 9.5]]]),
        ),
        drag(("handle", 0, [11.5, -2])),
    ),
    "one_event_for_two": (
        SWEEP,
        drag(("polygon", 0, [[[3, 3], [6, 2], [6, 8]]]), ("handle", 0, [11.5, -2])),
        drag(("handle", 0, [11.5, -2])),
    ),
    "depth_first_detour": (GRAPH, handles((0, 0), (1, -2)), handles((0, 0), (4, 0))),
    "astar_saves": (
        partial(search_board, np.ones((12, 12), bool), start=0, goal=143),
        handles((5.5, 5.5), (10.5, 5.5)),
        handles((0.5, 0.5), (10.5, 10.5)),
    ),
    "elbows_agree": (
        partial(reach_board, ke.TwoLinkArm(2, 1.2, 0.3), (2.0, 1.5)),
        handles((3.195, 0)),
        handles((3.5, 0)),
    ),
    "short_way_round": (
        partial(torus_board, (2.4, -0.5), (-2.2, 1.0)),
        handles((3.0, 0), (-3.0, 0)),
        handles((1, 0), (-1, 0)),
    ),
    "in_the_largest_hole": (
        SAMPLES,
        handles(largest_empty_ball(uniform_random(60, rng=0)).centre.tolist()),
        handles((0.5, 0.5)),
    ),
    "random_beats_halton": (SAMPLES, put(n=20), put(n=100)),
    "free_in_the_obstacle": (
        partial(slide_board, ROBOT, STONE),
        lambda made: drag(("polygon", 1, [shifted(ring_of(made, 1), (1.5, 1))]))(made),
        put(gone=0.5),
    ),
    "both_links_touch": (
        partial(arm_board, ARM, CELL, (2.4, 0.8)),
        in_square([-2.19, 1.33]),
        in_square([0.5, 0.3]),
    ),
    "missed_way": (partial(roadmap_board, HOUSE, n=60), put(seed=9), put(n=30, seed=9)),
    "long_way_round": (partial(properties_board, HOUSE, n=60), put(seed=11), put(seed=1)),
    "path_jumps": (
        partial(board, HALL),
        both(wall_moves((0.2, 0)), wall_moves((0.4, 0))),
        wall_moves((0, -2)),
    ),
    "many_nodes": (partial(board, HALL), put(step_size=0.1, seed=2), put(step_size=1.0)),
    "lucky_roadmap": (
        partial(board, HOUSE, planner="prm", samples=400),
        put(samples=100),
        put(samples=50, seed=9),
    ),
    "second_tree_pays": (RACE, handles((12.3, 3.3), (1.3, 0.7)), put(seed=0)),
    "only_one_finds": (
        partial(race_board, HALL, [only_short, straight]),
        handles((1, 1), (1, 10)),
        handles((1, 1), (3, 1)),
    ),
    "much_longer": (THEIRS, handles((10, 1), (11.5, 1)), handles((1.5, 2), (18, 9))),
    "more_samples_help": (PRM, handles((2.1, 21.5), (18.2, 1.8)), put(seed=2)),
    "detour": (PRM, handles((20.2, 19.2), (20.3, 11.9)), put(seed=2)),
    "three_arcs": (
        CURVES,
        drag(("handle", 2, [0, 20]), ("handle", 3, [-30, 20])),
        drag(("handle", 2, [40, 40])),
    ),
    "reverse_halves": (
        CURVES,
        drag(("handle", 2, [7, -8]), ("handle", 3, [4, 32])),
        drag(("handle", 2, [40, 40])),
    ),
    "mostly_backwards": (
        CAR,
        drag(("handle", 2, [183, 95]), ("handle", 3, [154, 87])),
        put(planner="you"),
    ),
    "small_tree": (
        CAR,
        drag(("handle", 2, [72, 237]), ("handle", 3, [101, 245])),
        put(seed=1),
    ),
    "without_waiting": (
        partial(moving_board, doorway(), nodes=60),
        handles((2, 2), (7, 2)),
        put(speed=1.5),
    ),
    "no_risk_no_way": (
        partial(chance_board, ke.Point(), UNSURE, (0.5, 7), (11.5, 7)),
        put(delta=0.0001),
        put(delta=0.5),
    ),
}
WITH = {
    "elbows_agree": ke.TwoLinkArm(2, 1.2, 0.3),
    "three_arcs": 20.0,
    "reverse_halves": 20.0,
}


def ring_of(made, number):
    return canvas_of(made).shown["polygons"][number]["rings"][0]


def challenge_called(name):
    """A challenge of the library; some are made for an arm or a radius."""
    made = getattr(challenges, name)
    return made(WITH[name]) if name in WITH else made


def state(made):
    """The one answer of a board that has come to rest."""
    canvas = canvas_of(made)
    assert canvas.drawing
    (answer,) = canvas.challenges.answers
    return answer


def test_every_challenge_has_its_ways():
    """And every message of the catalogue belongs to a challenge."""
    assert set(WAYS) == NAMES and len(NAMES) == 30
    sentences = {challenge_called(name).sentence for name in NAMES}
    tables = catalogue("en")["challenge"]
    assert sentences == {table["sentence"] for table in tables.values()}


@pytest.mark.parametrize("name", sorted(NAMES))
def test_a_challenge_can_be_reached_and_begins_unreached(name):
    """It answers both in words, and what was reached once stays done."""
    make, reach, miss = WAYS[name]
    made = challenge(make(), challenge_called(name))
    first = state(made)
    assert not first["now"] and not first["done"] and first["text"]
    miss(made)
    assert not state(made)["now"] and state(made)["text"]
    made = challenge(make(), challenge_called(name))
    reach(made)
    assert state(made)["now"] and state(made)["done"]
    assert state(made)["text"] != first["text"]


def few(made, kept):
    """Whether there are few points."""
    return made.n.value <= 10, f"{made.n.value} points"


def test_a_reader_poses_their_own():
    made = challenge(samples_board("halton", 30), Challenge("Have at most ten points.", few))
    assert state(made) == {
        "sentence": "Have at most ten points.",
        "now": False,
        "done": False,
        "text": "30 points",
    }
    made.n.value = 8
    assert state(made)["now"]
    made.n.value = 30
    assert not state(made)["now"] and state(made)["done"]


def test_a_drag_is_answered_with_the_drawing():
    """The answer travels with the drawing of each drag, and with that of a refused message."""
    made = challenge(samples_board("random", 60), challenges.in_the_largest_hole)
    page = Page(made.canvas)
    drawing = page.moves(("handle", 0, [0.2, 0.2]))
    assert drawing["challenges"] == made.canvas.challenges.answers
    assert page.moves(("handle", 99, [0, 0]))["challenges"] == drawing["challenges"]
    assert json.loads(json.dumps(drawing)) == drawing


def test_a_board_without_challenges_sends_none():
    assert Page(samples_board().canvas).moves(("handle", 0, [0.2, 0.2]))["challenges"] == []


def test_a_judge_that_fails_is_answered_in_words(caplog):
    """The board goes on, and the reason is logged."""
    made = challenge(samples_board(), Challenge("?", lambda made, kept: 1 / 0))
    assert not state(made)["now"] and "ZeroDivisionError" in state(made)["text"]
    assert "could not be judged" in caplog.text


def test_a_judge_may_ask_for_the_drawing_that_is_completed_later():
    """Each challenge is answered once, by the whole drawing."""
    seen = Challenge("See it.", lambda board, kept: ("efficient" in repr(board), "seen"))
    whole = Challenge("Wait.", lambda board, kept: (len(board.survey.places) == 100, "measured"))
    answers = challenge(properties_board(HALL, n=20), whole, seen).canvas.challenges.answers
    assert [(one["sentence"], one["now"]) for one in answers] == [
        ("Wait.", True),
        ("See it.", True),
    ]


def test_each_board_keeps_its_own_memory():
    """A challenge that compares with the scene before does not mix two boards."""
    one, other = (challenge(board(HALL), challenges.path_jumps) for _ in range(2))
    wall_moves((0.2, 0))(one)
    assert state(one)["text"] != state(other)["text"]


@pytest.mark.parametrize(
    "given", [("no board", few), (samples_board(), few), (samples_board(), "a sentence")]
)
def test_only_boards_have_challenges(given):
    with pytest.raises(InvalidParameter, match="challenge takes a board"):
        challenge(*given)


def test_a_record_has_the_sentences():
    made = challenge(samples_board("random", 60), challenges.in_the_largest_hole)
    data, _ = made._repr_mimebundle_()
    (record,) = unpack_records(json.loads(json.dumps(data[RECORD])))
    assert record["drawing"]["challenges"][0]["sentence"].startswith("drag q")


@pytest.mark.parametrize("lesson", [LESSONS[0], *LESSONS[2:]], ids=lambda lesson: lesson.stem)
def test_every_lesson_has_two_challenges(lesson):
    """Marked as optional by the board itself."""
    code = [
        "".join(cell["source"])
        for cell in json.loads(lesson.read_text(encoding="utf-8"))["cells"]
        if cell["cell_type"] == "code"
    ]
    used = {name for name in NAMES for source in code if f"{name}" in source}
    assert len(used) >= 2
