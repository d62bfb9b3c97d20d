"""The boards of an arm and of a sliding robot, without a browser."""

import io

import numpy as np
import pytest
from PIL import Image
from test_board import LET_GO, Page

import kinoedu as ke
from kinoedu.boards import arm_board, slide_board
from kinoedu.boards.arm.arm_drawn import links_in_contact
from kinoedu.boards.arm.glued import split_motions
from kinoedu.boards.core.drawing import Drawing, bodies, encode_drawing
from kinoedu.boards.geometry.slide import fraction_at
from kinoedu.c_space import slide
from kinoedu.collision import paint_configuration_space
from kinoedu.errors import InvalidParameter, InvalidPoint, InvalidPolygon, InvalidRobot
from kinoedu.geometry import minkowski_difference, point_polygon_distance
from kinoedu.robots import ArmChain
from kinoedu.robots.pulling import nearest_reachable, pull_arm
from kinoedu.spaces import torus_distance

ARM = ke.TwoLinkArm(1.5, 1.2, 0.2)
SQUARE = [(-4, -4), (4, -4), (4, 4), (-4, 4)]
TRIANGLE = [(1.2, 1.4), (2.6, 1.2), (2.2, 2.4)]
WORLD = ke.PolygonWorld(SQUARE, [TRIANGLE, ((0.4, 2.2), 0.4), ((0.2, -1.4), 0.3)])
ROBOT = [(-0.5, -0.4), (1, -0.2), (0.2, 1)]
HOUSE = [(2, 2), (4, 1.5), (5, 3), (4, 4), (2, 3.6)]


def layers_of(canvas, kind, colour):
    return [
        layer for layer in canvas.drawing.layers if (layer.kind, layer.colour) == (kind, colour)
    ]


def at(canvas):
    return [item["at"] for item in canvas._shown["handles"]]


# ---- what is drawn


def test_bodies_travel_with_all_their_corners():
    """A row holds a polygon's corners and its steps; the message has their number, and places."""
    body = bodies(
        np.arange(12.0).reshape(2, 3, 2), "robot", hatched=True, when=[0, 1], until=[1, 2]
    )
    about, (rows,) = encode_drawing(
        Drawing([body], places=[("handle", 0, np.array([1, 2]))]), (0, 0), 1.0
    )
    assert (
        about["layers"][0]["points"] == 3
        and about["layers"][0]["hatched"]
        and about["places"] == [["handle", 0, [1, 2]]]
    )
    assert np.frombuffer(rows, np.float32).reshape(2, 8)[1].tolist() == [6, 7, 8, 9, 10, 11, 1, 2]


def test_motions_are_cut_at_the_sides():
    """The pieces lie in the square, are connected, and have the short way's ends and length."""
    rng = np.random.default_rng(4)
    begins, ends = rng.uniform(-np.pi, np.pi, (2, 300, 2))
    for a, b in zip(begins, ends, strict=True):
        pieces = split_motions(a[None], b[None])
        assert 1 <= len(pieces) <= 3 and np.abs(pieces).max() <= np.pi * (1 + 1e-12)
        lengths = np.hypot(*(pieces[:, 1] - pieces[:, 0]).T)
        assert lengths.sum() == pytest.approx(torus_distance(a, b), rel=1e-9)
        assert np.allclose(pieces[0, 0], a) and np.allclose(np.cos(pieces[-1, 1] - b), 1)
        assert np.allclose(np.cos(pieces[1:, 0] - pieces[:-1, 1]), 1)
    across = split_motions(np.array([[3.0, 0.0]]), np.array([[-3.0, 0.0]]))
    assert np.allclose(across, [[[3, 0], [np.pi, 0]], [[-np.pi, 0], [-3, 0]]])
    assert split_motions(np.empty((0, 2)), np.empty((0, 2))).shape == (0, 2, 2)
    assert split_motions(np.ones((1, 2)), np.ones((1, 2))).shape[0] <= 1


# ---- pulling


@pytest.mark.parametrize(
    "arm", [ARM, ke.TwoLinkArm(1, 1, 0), ke.TwoLinkArm(0.5, 2, 0.1, base=(3, -2))]
)
def test_a_pulled_tip_goes_as_near_as_it_can(arm):
    """No sampled configuration brings the tip nearer; of two solutions the nearer to q is taken."""
    rng = np.random.default_rng(1)
    tips = np.array([arm.joints(q)[1] for q in rng.uniform(-np.pi, np.pi, (4000, 2))])
    for _ in range(100):
        q, p = rng.uniform(-np.pi, np.pi, 2), arm.base + rng.uniform(-4, 4, 2)
        after = pull_arm(arm, q, None, p)
        reached = np.hypot(*(arm.joints(after)[1] - p))
        assert reached <= np.hypot(*(tips - p).T).min() + 1e-9
        others = arm.inverse(nearest_reachable(arm, q, p))
        assert torus_distance(after, q) == min(torus_distance(other, q) for other in others)


def test_pulls_that_say_nothing_about_an_angle():
    """On the base every heading fits: the arm keeps its own; equal links fold up."""
    q, equal = np.array([0.7, 1.0]), ke.TwoLinkArm(1, 1, 0)
    assert pull_arm(equal, q, None, equal.base).tolist() == [0.7, -np.pi]
    assert np.hypot(*ARM.joints(pull_arm(ARM, q, None, ARM.base))[1]) == pytest.approx(0.3)
    assert pull_arm(ARM, q, ARM.base, None).tolist() == q.tolist()
    assert pull_arm(ARM, q, None, None) is q


def test_a_pulled_elbow_turns_link_1():
    """Link 2 keeps its angle to link 1; with a pulled tip both headings are taken."""
    q = np.array([0.7, 1.0])
    assert pull_arm(ARM, q, np.array([0, -5]), None) == pytest.approx([-np.pi / 2, 1.0])
    elbow, tip = ARM.joints((2.0, -1.5))
    assert pull_arm(ARM, q, elbow, tip) == pytest.approx([2.0, -1.5])


# ---- the arm's board


def test_both_pictures_show_one_configuration():
    """A pull in the workspace moves q in the square and the other way round, on every page."""
    made = arm_board(ARM, WORLD, q=(0.6, 0.3))
    workspace, square = Page(made.canvas), Page(made.square)
    assert repr(made) == "ArmBoard(q = (0.60, 0.30): link 2 is in contact)"
    reply = workspace.moves(("handle", 1, [0.5, -2]))
    assert made.canvas.drawing.message == reply["text"] and at(made.square) == [made.q.tolist()]
    assert ARM.joints(made.q)[1] == pytest.approx([0.5, -2]) and square.sent[-1][0]["to"] is None
    assert reply["places"] == [
        ["handle", 0, ARM.joints(made.q)[0].tolist()],
        ["handle", 1, ARM.joints(made.q)[1].tolist()],
    ]
    answered = square.moves(("handle", 0, [4.0, -1.0]))
    assert made.q == pytest.approx([4.0 - 2 * np.pi, -1.0]) and answered["places"] == [
        ["handle", 0, made.q.tolist()]
    ]
    assert at(made.canvas) == [joint.tolist() for joint in ARM.joints(made.q)]
    assert workspace.sent[-1][0]["text"].startswith("q = (-2.28, -1.00)")


def test_what_stands_still_is_not_taken_for_a_pull():
    """Answering again, or storing an answered scene, changes no bit of q."""
    made = arm_board(ARM, WORLD, q=(0.6, 0.3))
    Page(made.canvas).moves(("handle", 1, [0.1234, -1.9]))
    q = made.q.copy()
    for canvas in (made.canvas, made.square):
        canvas.refresh()
        canvas.keep()
    assert (made.q == q).all()
    made.canvas.scene = made.canvas.home
    assert made.q == pytest.approx([0.6, 0.3], abs=1e-12)


def test_a_picture_that_is_let_go_undoes_nothing_of_the_other():
    """A disc is released after q was dragged in the square: q stays, and both scenes say so."""
    made = arm_board(ARM, WORLD, q=(0.6, 0.3))
    workspace, square = Page(made.canvas), Page(made.square)
    workspace.moves(("disc", 0, [3, -3]))
    old = made.canvas.shown
    square.moves(("handle", 0, [2.0, 1.0]))
    made.canvas.set_state({"scene": old})  # a page says where it had things
    workspace.says(LET_GO)
    assert made.q.tolist() == [2.0, 1.0] and made.canvas.scene["discs"][0]["at"] == [3, -3]
    for canvas in (made.canvas, made.square):
        assert canvas.scene == canvas.shown
    assert at(made.square) == [[2.0, 1.0]]
    assert at(made.canvas) == [joint.tolist() for joint in ARM.joints(made.q)]


def test_a_tip_out_of_reach_says_why():
    """Too far and too near; the arm goes to the nearest place."""
    made = arm_board(ARM, WORLD)
    page = Page(made.canvas)
    assert "the links together reach only 2.7" in page.moves(("handle", 1, [0, 3.5]))["text"]
    assert ARM.joints(made.q)[1] == pytest.approx([0, 2.7])
    assert "folded up the arm still reaches 0.3 away" in page.moves(("handle", 1, [0.1, 0]))["text"]


def test_a_dragged_obstacle_is_painted_anew():
    """The page gets the image of the changed world, and none where nothing moved."""
    made = arm_board(ARM, WORLD, q=(0.6, 0.3))
    page, before = Page(made.canvas), made.square.bitmap
    assert before == paint_configuration_space(ARM, WORLD).tobytes()
    page.moves(("disc", 0, [1.1, 0.6]))
    moved = ke.PolygonWorld(SQUARE, [TRIANGLE, ((1.1, 0.6), 0.4), ((0.2, -1.4), 0.3)])
    assert made.square.bitmap == paint_configuration_space(ARM, moved).tobytes() != before
    assert made.canvas.drawing.message == "q = (0.60, 0.30): links 1 and 2 are in contact"
    assert made.square.drawing.message.endswith("link 1 hits")
    kept = made.image
    page.moves(("handle", 1, [1, -2]))
    assert made.image is kept
    assert (
        page.moves(("polygon", 0, [[TRIANGLE[0], TRIANGLE[1], TRIANGLE[0]]]))["warning"]
        and made.image is kept
    )


def test_links_in_contact_are_striped_in_the_colours_of_the_square():
    """Free links are plain; the second is tested by itself when the first is in contact."""
    made = arm_board(ARM, WORLD, q=(0.6, 0.3))
    assert [
        (layer.colour, layer.hatched)
        for layer in made.canvas.drawing.layers
        if layer.kind == "bodies"
    ] == [("free_link", False), ("hit", True)]
    rng = np.random.default_rng(2)
    crowded = ke.PolygonWorld(
        SQUARE, [TRIANGLE, ((0.4, 1.4), 0.4), ((0.2, -1.2), 0.3), ((-2, 0.5), 0.5)]
    )
    seen = set()
    for q in rng.uniform(-np.pi, np.pi, (200, 2)):
        hits = links_in_contact(ARM, q, crowded)
        alone = [ArmChain([1.5], 0.2), ArmChain([1.2], 0.2, base=ARM.joints(q)[0])]
        angles = [q[:1], [q.sum()]]
        assert hits == [i + 1 for i in range(2) if ke.link_in_contact(alone[i], angles[i], crowded)]
        seen.add(tuple(hits))
    assert seen == {(), (1,), (2,), (1, 2)}


def test_a_plan_rides_in_both_pictures():
    """From q to the goal across the side, free, in equal steps; a goal in contact is reported."""
    made = arm_board(ARM, WORLD, q=(-0.5, 2.6), goal=(0.8, -2.5))
    assert "RRT: a path of length" in repr(made) and made.plan.path is not None
    assert made.canvas.drawing.total == made.square.drawing.total == 120
    (ride,) = layers_of(made.canvas, "bodies", "robot")
    assert ride.when.tolist() == np.repeat(np.arange(121), 2).tolist()
    page = Page(made.square)
    page.moves(("handle", 1, [0.6, 0.3]))
    assert (
        "the goal (0.6, 0.3) is not free" in repr(made)
        and made.plan is None
        and made.canvas.drawing.total == 0
    )
    page.moves(("handle", 1, [-0.5, -3.0]))
    assert made.plan.path[-1].tolist() == [-0.5, -3.0] and made.goal.tolist() == [-0.5, -3.0]


def test_a_planner_that_is_for_points_says_so_on_the_board():
    """Though it draws no random numbers, and takes no seed."""
    made = arm_board(ARM, WORLD, q=(0.0, 0.0), goal=(-2.0, 0.5), planner=ke.plan_by_visibility)
    assert made.plan is None and "visibility roadmap moves a point" in made.canvas.drawing.text


def test_a_readers_planner_is_judged_on_the_torus():
    """A straight motion in collision is reported, a free one is drawn."""
    straight = arm_board(
        ARM, WORLD, q=(0, 0), goal=(2.3, 0), planner=lambda problem: [problem.start, problem.goal]
    )
    assert "motion 1 of your path" in repr(straight)
    made = arm_board(
        ARM, WORLD, q=(0, 0), goal=(-0.2, 0), planner=lambda problem: [problem.start, problem.goal]
    )
    assert "length 0.2, 0 motions checked" in repr(made) and made.canvas.drawing.total == 120


def test_what_is_no_arm_is_refused():
    """An error is raised before anything is shown; a terrain is painted too."""
    with pytest.raises(InvalidRobot):
        arm_board(ke.Disk(1), WORLD)
    with pytest.raises(InvalidRobot, match="two"):
        arm_board(ArmChain([1, 1, 1], 0.1), WORLD, q=(0, 0, 0))
    with pytest.raises(InvalidPoint, match="q must be 2"):
        arm_board(ARM, WORLD, q=(0, 0, 0))
    with pytest.raises(InvalidParameter):
        arm_board(ARM, WORLD, rng=-1)
    free = np.ones((16, 16), bool)
    free[10:12, 10:12] = False
    made = arm_board(ARM, ke.Terrain(free, resolution=0.5, origin=(-4, -4)), q=(0.7, 0))
    assert "links 1 and 2 are in contact" in repr(made) and made.canvas.scene["size"] == [16, 16]


# ---- the sliding robot


def test_the_reference_point_stays_on_the_c_obstacle():
    """q moves to the nearest boundary point of the Minkowski difference, and the slider follows."""
    made = slide_board(ROBOT, HOUSE)
    page, rim = Page(made.canvas), minkowski_difference(HOUSE, ROBOT)
    for p in np.random.default_rng(3).uniform(-1, 7, (40, 2)):
        page.moves(("handle", 0, p.tolist()))
        q = np.array(at(made.canvas)[0])
        corners = np.stack([rim, np.roll(rim, -1, axis=0)], axis=1)
        assert min(point_to_segment(q, a, b) for a, b in corners) < 1e-9
        nearest = min(point_to_segment(p, a, b) for a, b in corners)
        assert np.hypot(*(q - p)) == pytest.approx(nearest, abs=1e-9)
        page.says(LET_GO)
        assert made.gone.value == pytest.approx(made.share, abs=0.001) and made.slide.at(
            made.share
        )[0] == pytest.approx(q)


def point_to_segment(p, a, b):
    share = np.clip((p - a) @ (b - a) / ((b - a) @ (b - a)), 0, 1)
    return np.hypot(*(a + share * (b - a) - p))


def test_share_at_undoes_at():
    """For every fraction except the ends, which are the same place."""
    way = slide(ROBOT, HOUSE)
    for share in np.linspace(0.001, 0.999, 101):
        assert fraction_at(way, way.at(share)[0]) == pytest.approx(share, abs=1e-9)


def test_the_words_say_what_touches():
    """For every fraction the named features touch, and robot and obstacle only touch."""
    made = slide_board(ROBOT, HOUSE)
    kinds = set()
    for share in np.linspace(0.003, 0.997, 83):
        made.gone.value = share
        (q, stretch), way = made.slide.at(made.share), made.slide
        kind, robot = way.kind[stretch], way.robot + q
        kinds.add(str(kind))
        assert f"({kind})" in repr(made) and f"{way.robot_part[stretch]} of the robot" in repr(made)
        vertex = (
            robot[way.robot_part[stretch]]
            if kind[0] == "V"
            else way.obstacle[way.obstacle_part[stretch]]
        )
        other = way.obstacle if kind[0] == "V" else robot
        assert point_polygon_distance(vertex, other) < 1e-9
    assert kinds == {"EV", "VE"}


def test_dragged_vertices_change_the_way():
    """Both polygons' vertices; a dragged copy; a polygon that is not convex is reported."""
    made = slide_board(ROBOT, HOUSE)
    page, home = Page(made.canvas), made._home
    grown = [*HOUSE[:2], (7, 3), *HOUSE[3:]]
    page.moves(("polygon", 0, [grown]))
    assert np.allclose(made.slide.corners, slide(ROBOT, grown).corners)
    off = np.array(ROBOT) + np.array([0.3, 0.2])
    page.moves(("polygon", 1, [(off + home).tolist()]))
    assert np.allclose(made.slide.corners, slide(off, grown).corners)
    bent = [HOUSE[0], HOUSE[1], (3, 3), HOUSE[3], HOUSE[4]]
    assert "convex" in page.moves(("polygon", 0, [bent]))["warning"]
    assert page.moves(("polygon", 0, [HOUSE]))["warning"] == ""


def test_a_slider_set_to_its_notch_moves_nothing():
    """The browser may move the slider by half a notch without the reader."""
    made = slide_board(ROBOT, HOUSE)
    Page(made.canvas).moves(("handle", 0, [6, 3.3]))
    share = made.share
    made.gone.value = round(share / 0.002) * 0.002
    assert made.share == share


def test_what_cannot_slide_is_refused():
    """An error is raised before anything is shown."""
    with pytest.raises(InvalidPolygon):
        slide_board([(0, 0), (2, 0), (1, 0.2), (1, 2)], HOUSE)
    with pytest.raises(InvalidParameter):
        slide_board([(0, 0)], [(1, 1)])


@pytest.mark.parametrize(
    "make", [lambda: arm_board(ARM, WORLD, q=(0.6, 0.3)), lambda: slide_board(ROBOT, HOUSE)]
)
def test_a_notebook_keeps_text_and_a_small_picture(make):
    """They replace the board where there is no JavaScript."""
    made = make()
    data, _ = made._repr_mimebundle_()
    assert data["text/plain"] == repr(made) and len(data["image/png"]) < 60_000
    assert Image.open(io.BytesIO(made.picture())).size[0] > 300
