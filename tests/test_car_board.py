"""The car's board without a browser: setting poses, refusals, drawings, and driving by keys."""

import io
import math

import numpy as np
import pytest
from matplotlib import pyplot as plt
from PIL import Image
from test_board import Page
from test_planning_boards import layers_of, shown

import kinoedu as ke
from kinoedu import figures
from kinoedu.boards import Challenge, car_board, challenge
from kinoedu.boards.car.car import DRAGGED
from kinoedu.boards.car.car_drawn import STEPS, make_ride, place_shapes
from kinoedu.boards.car.car_poses import tip_of
from kinoedu.boards.car.driving import MOMENT, NOTCHES, continue_drive, start_drive
from kinoedu.collision import is_free_drive, is_free_trajectory
from kinoedu.errors import InvalidParameter
from kinoedu.figures.ackermann import steered_wheels
from kinoedu.figures.robots import outline_at

RIM = [(0, 0), (24, 0), (24, 16), (0, 16)]
WALL = [(9, 0), (11, 0), (11, 8), (9, 8)]
START, GOAL = (3.0, 3.0, math.pi / 2), (20.0, 9.0, -math.pi / 2)
UP, DOWN, LEFT, RIGHT = "ArrowUp", "ArrowDown", "ArrowLeft", "ArrowRight"


def problem_of(*obstacles, start=START, goal=GOAL, car=None, **given):
    """A small car between two poses, by default with a wall between them."""
    return ke.Problem(
        car or ke.Car(3, 1, 2), ke.PolygonWorld(RIM, obstacles or [WALL]), start, goal, **given
    )


def keys(page, *held, times=1, seq=0):
    """Hold keys for some moments; returns the last drawing that is answered."""
    for _ in range(times):
        drawing = page.says({"kind": "keys", "from": "page", "seq": seq, "held": list(held)})[-1]
    return drawing


def at(made, number):
    """The place of a handle."""
    return made.canvas._shown["handles"][number]["at"]


# ---- planning


@pytest.mark.parametrize("planner", ["kinodynamic_rrt", "kinodynamic_prm", "rrt"])
def test_a_planner_grows_and_then_the_car_drives(planner):
    """Layers grow in order with a text per step; the last body is at the trajectory's end."""
    made = car_board(problem_of(), planner, rng=3)
    drawing, plan = made.canvas.drawing, made.plan
    assert not drawing.warning and len(drawing.step_texts) == drawing.total > STEPS
    for layer in drawing.layers:
        assert layer.when is None or (
            len(layer.when) == len(layer.rows) and (np.diff(layer.when) >= 0).all()
        )
        assert layer.until is None or (layer.until > layer.when).all()
    (body,) = layers_of(made.canvas, "bodies", "robot")
    trajectory = ke.planners.trajectory_along(plan)
    begin = drawing.total - STEPS
    for step, pose in ((0, plan.path[0]), (begin, plan.path[0]), (drawing.total, plan.path[-1])):
        (row,) = shown(body, step)
        assert np.allclose(row[:8].reshape(4, 2), outline_at(plan.problem.robot, pose), atol=1e-9)
    (row,) = shown(body, begin + STEPS // 4)
    assert np.allclose(
        row[:8].reshape(4, 2),
        outline_at(plan.problem.robot, trajectory.at(trajectory.duration / 4)),
        atol=1e-9,
    )
    assert Image.open(io.BytesIO(made.picture())).width > 300


def test_the_same_seed_is_the_same_scene():
    """Another seed gives another; planners are the library's, with the iterations chosen."""
    made, again = car_board(problem_of(), rng=5), car_board(problem_of(), rng=5)
    assert made.canvas._reply.whole.buffers == again.canvas._reply.whole.buffers
    again.seed.value = 6
    assert made.canvas._reply.whole.buffers != again.canvas._reply.whole.buffers
    same = ke.kinodynamic_rrt(problem_of(), max_iterations=1000, rng=5)
    assert np.array_equal(made.plan.tree.nodes, same.tree.nodes)
    made.planner.value = "kinodynamic_prm"
    assert made.iterations.value == 350 and len(made.plan.roadmap.edges) > 350
    made.planner.value = "rrt"
    assert np.array_equal(made.plan.path, ke.rrt(problem_of(), max_iterations=1000, rng=5).path)
    made.planner.value = "you"
    assert (
        made.plan is None
        and made.seed.layout.display == "none"
        and made.iterations.layout.display == "none"
    )


def test_without_a_path_the_board_says_why():
    """Behind a closed wall a tree's car drives to the nearest pose; along curves it stands."""
    closed = [(9, -1), (11, -1), (11, 17), (9, 17)]
    made = car_board(problem_of(closed), max_iterations=60)
    assert "no path, " in made.canvas.drawing.text and made.canvas.drawing.total > 100
    made.planner.value = "rrt"
    assert "no path, " in repr(made) and made.canvas.drawing.total <= 100


@pytest.mark.parametrize("slower", [1.0, 2.7])
@pytest.mark.parametrize("planner", DRAGGED)
def test_while_dragged_a_tree_has_its_first_iterations(planner, slower, monkeypatch):
    """It says so, and on a slower computer they are fewer; at rest the same tree has grown on, and
    challenges are judged by it.
    """
    monkeypatch.setitem(DRAGGED, "rrt", 20)  # with those that it has, it finds a path here
    monkeypatch.setattr("kinoedu.boards.car.car.slowdown", lambda: slower)
    made = car_board(problem_of(goal=(20.0, 14.0, 0.0)), planner, rng=3)
    nodes = Challenge("Grow.", lambda board, _: (board.plan is not None, str(count(board.plan))))
    challenge(made, nodes)
    page = Page(made.canvas)
    brief = page.moves(("handle", 2, [20.0, 13.0]))
    first = nodes_of(made.plan)
    assert (
        f"the first {math.ceil(DRAGGED[planner] / slower)} of" in brief["text"] and brief["brief"]
    )
    (whole,) = page.says({"kind": "hello", "from": "page"})
    grown = nodes_of(made.plan)
    assert len(grown) > len(first) and np.array_equal(grown[: len(first)], first)
    assert "the first" not in whole["text"] and not whole["brief"]
    assert [brief["challenges"][0]["text"], whole["challenges"][0]["text"]] == [
        str(len(first)),
        str(len(grown)),
    ]
    same = getattr(ke.planners, planner)(made.problem, rng=3)
    assert np.array_equal(grown, nodes_of(same))


def nodes_of(plan):
    """The nodes of a plan's tree or roadmap."""
    return (plan.tree or plan.roadmap).nodes


def count(plan):
    return len(nodes_of(plan))


# ---- start and goal poses


def test_a_place_keeps_its_heading_and_a_tip_turns_it():
    """To the last digit; the tip moves with its place, and returns to its distance."""
    made = car_board(problem_of(), "you")
    page = Page(made.canvas)
    page.moves(("handle", 2, [19.0, 12.0]))
    assert made.problem.goal.tolist() == [19.0, 12.0, GOAL[2]]
    assert at(made, 3) == tip_of(made.problem.robot, made.problem.goal).tolist()
    page.moves(("handle", 3, [19.0, 14.0]))
    assert made.problem.goal.tolist() == [19.0, 12.0, math.pi / 2]
    page.moves(("handle", 2, [18.0, 8.0]), ("handle", 3, [17.0, 8.0]))
    assert made.problem.goal[2] == pytest.approx(math.pi) or made.problem.goal[2] == pytest.approx(
        -math.pi
    )
    home = made.canvas.home["handles"]
    page.moves(*(("handle", k, home[k]["at"]) for k in range(5)))
    assert made.problem.goal.tolist() == list(GOAL) and made.problem.start.tolist() == list(START)


@pytest.mark.parametrize("planner", ["kinodynamic_rrt", "you"])
def test_what_is_not_free_is_refused_with_the_reason(planner):
    """Problem, plan and places stay; so with an obstacle, also one that crosses itself."""
    made = car_board(problem_of(), planner)
    page, problem, scene = Page(made.canvas), made.problem, made.canvas._shown
    plan = made.plan
    for wrong, reason in (
        (("handle", 2, [10.0, 5.0]), "the goal (10.0, 5.0"),
        (("handle", 0, [0.2, 3.0]), "the start (0.2, 3.0"),
        (("polygon", 0, [[(x - 6.0, y) for x, y in WALL]]), "the start"),
        (("polygon", 0, [[WALL[0], WALL[2], WALL[1], WALL[3]]]), "crosses"),
    ):
        for _ in range(2):  # a hand that stays there hatches one car, not more
            answer = page.moves(wrong)
            assert reason in answer["warning"] and (
                "not free" in answer["warning"] or reason == "crosses"
            )
        hatched = sum(layer["hatched"] for layer in answer["layers"])
        assert hatched == (wrong[0] == "handle")
        assert made.problem is problem and made.canvas._shown == scene and made.plan is plan
    page.moves(("handle", 2, [19.0, 12.0]))
    assert not made.canvas.drawing.warning and made.problem.goal[0] == 19.0


def test_a_car_among_bitmaps_and_one_that_only_goes_forward():
    """A bitmap lies beneath; a car without a reverse gear ignores ArrowDown."""
    car = ke.Car(3, 1, 2, speeds=(1.0,))
    made = car_board(ke.Problem(car, ke.Terrain(np.ones((16, 24), bool)), START, GOAL), "you")
    assert made.canvas.bitmap and not made.canvas.drawing.warning
    page = Page(made.canvas)
    keys(page, DOWN, times=3)
    assert made.driven.length == 0.0
    keys(page, UP, times=3)
    assert made.driven.length == pytest.approx(3 * MOMENT * 2)


@pytest.mark.parametrize(
    "wrong", [{"planner": "astar"}, {"view": "below"}, {"max_iterations": 0}, {"rng": -1}]
)
def test_what_makes_no_sense_is_refused(wrong):
    """Errors are raised before anything is shown, also for a problem of another robot."""
    with pytest.raises(InvalidParameter):
        car_board(problem_of(), **wrong)
    with pytest.raises(InvalidParameter, match="Car"):
        car_board(ke.Problem(ke.Point(), ke.PolygonWorld(RIM), (1, 1), (2, 2)))


# ---- driving


def test_driving_messages_replayed_are_the_cars_closed_form():
    """Moment by moment `Car.move` gives the board's pose; a control held on is one control."""
    made = car_board(problem_of(start=(3, 3, 0.3)), "you")
    page, car, rng = Page(made.canvas), made.problem.robot, np.random.default_rng(1)
    pose, notch, controls = np.array([3, 3, 0.3]), 0, set()
    for _ in range(60):
        held = {key for key in (UP, DOWN, LEFT, RIGHT) if rng.random() < 0.4}
        notch = int(np.clip(notch + (LEFT in held) - (RIGHT in held), -NOTCHES, NOTCHES))
        v, phi = float((UP in held) - (DOWN in held)), notch * car.max_steering / NOTCHES
        if v:
            t = MOMENT * car.wheelbase
            if not is_free_drive(car, made.problem.world, pose, v * t, car.curvature(phi), 0.0):
                continue
            pose = car.move(pose, v, phi, t)
            controls.add((v, phi))
        drawing = keys(page, *held, seq=4)
        assert (drawing["seq"], drawing["to"], drawing["warning"]) == (4, "page", "")
        assert np.allclose(made.driven.poses[-1], pose, atol=1e-9)
    assert {tuple(control) for control in made.driven.controls.tolist()} == controls
    straight = car_board(problem_of(), "you")
    keys(Page(straight.canvas), UP, times=7)
    assert straight.driven.controls.tolist() == [
        [1.0, 0.0]
    ] and straight.driven.length == pytest.approx(7 * MOMENT * 2)


@pytest.mark.parametrize("notch", [0, 3, -5, 8])
def test_a_wall_stops_the_car_where_it_would_touch(notch):
    """The drive is free, slightly farther it is not; the board says so; the car can drive back."""
    problem = problem_of(start=(6, 2.5, 0.0), goal=(20, 12, 0))
    drive = start_drive(problem)._replace(notch=notch)
    for _ in range(100):
        drive = continue_drive(problem, drive, {UP})
    assert drive.stopped
    robot, world, trajectory = problem.robot, problem.world, drive.trajectory
    assert is_free_trajectory(robot, world, trajectory)
    farther = trajectory._replace(durations=trajectory.durations + 1e-5)
    assert not is_free_trajectory(robot, world, farther)
    again = continue_drive(problem, drive, {UP})
    assert (
        again.stopped
        and again.trajectory.length - trajectory.length < 1e-6
        and len(again.trajectory.controls) == 1
    )
    back = continue_drive(problem, again, {DOWN})
    assert not back.stopped and back.trajectory.length > trajectory.length + 0.1
    assert is_free_trajectory(robot, world, back.trajectory)


def test_contact_and_arrival_are_told():
    """By stripes and in words; the goal's tolerance is the planners'."""
    made = car_board(problem_of(goal=(3, 8, math.pi / 2)), "you")
    page = Page(made.canvas)
    assert "at the goal" not in keys(page, UP, times=30)["text"]
    assert "at the goal" in keys(page, UP, times=12)["text"]
    drawing = keys(page, UP, times=60)
    assert "Contact" in drawing["text"] and any(layer["hatched"] for layer in drawing["layers"])
    assert "Contact" not in keys(page, DOWN)["text"]


def test_keys_take_the_wheel_from_a_planner_and_a_new_start_begins_anew():
    """A moved goal keeps the drive; a moved start or obstacle, and a reset, do not."""
    made = car_board(problem_of())
    page = Page(made.canvas)
    keys(page, UP, LEFT, times=4)
    assert made.planner.value == "you" and made.plan is None and len(made.driven.controls) == 4
    middle = outline_at(made.problem.robot, made.driven.poses[-1]).mean(axis=0)
    assert np.allclose(at(made, 4), middle)
    page.moves(("handle", 2, [19.0, 12.0]))
    assert len(made.driven.controls) == 4
    for moved in (
        [("handle", 0, [4.0, 3.0])],
        [("polygon", 0, [[(x, y + 0.5) for x, y in WALL]])],
        [("handle", 4, made.canvas.home["handles"][4]["at"])],
    ):
        keys(page, UP, times=2)
        assert len(made.driven.controls)
        page.moves(*moved)
        assert (
            len(made.driven.controls) == 0
            and made.driven.start.tolist() == made.problem.start.tolist()
        )
        page.moves(("handle", 0, list(START[:2])))


@pytest.mark.parametrize("held", [None, "ArrowUp", [1, {}], ["Escape"], {"ArrowUp": 1}])
def test_keys_that_make_no_sense_move_nothing_and_are_answered(held):
    """A page waits for an answer to each message with a number."""
    made = car_board(problem_of(), "you")
    page = Page(made.canvas)
    assert len(page.says({"kind": "keys", "from": "page", "seq": 1, "held": held})) == 1
    assert made.driven.length == 0.0
    assert page.says({"kind": "keys", "from": "page", "held": ["ArrowUp"]}) == []
    plain = ke.board(ke.Problem(ke.Point(), ke.PolygonWorld(RIM), (1, 1), (2, 2)))
    assert (
        Page(plain.canvas).says({"kind": "keys", "from": "page", "seq": 1, "held": ["ArrowUp"]})
        == []
    )


# ---- drawing


@pytest.mark.parametrize("phi", [0.0, 1e-9, 0.4, -0.7])
def test_all_wheels_turn_round_one_centre(phi):
    """Front wheels have the angles of `wheel_angles`; every axis goes through the centre."""
    car, pose = ke.Car(30, 10, 20), np.array([3.0, 4.0, 2.0])
    wheels = steered_wheels(car, pose, phi)
    centre = car.turning_centre(pose, phi)
    for wheel in wheels:
        along = wheel[1] - wheel[0]
        axis = (
            np.array([-math.sin(2.0), math.cos(2.0)]) if phi == 0.0 else centre - wheel.mean(axis=0)
        )
        assert abs(along @ axis) < 1e-6 * np.linalg.norm(along) * np.linalg.norm(axis)
        assert along @ (math.cos(2.0), math.sin(2.0)) > 0.0
    here = place_shapes(np.array([steered_wheels(car, np.zeros(3), phi)]), pose[None])[0]
    assert np.allclose(here, wheels, atol=1e-9)


def test_an_eye_goes_with_the_car():
    """At each step the view is centred on the body, also in a picture."""
    made = car_board(problem_of(), view="followed", rng=3)
    drawing = made.canvas.drawing
    (eye,) = (layer for layer in drawing.layers if layer.kind == "eye")
    ride = make_ride(made.plan.trajectory)
    assert np.allclose(
        eye.rows[50, :2], outline_at(made.problem.robot, ride.poses[50]).mean(axis=0)
    )
    assert eye.when[0] == 0 and eye.when[-1] == drawing.total
    followed = made.picture()
    made.view.value = "above"
    assert (
        "eye" not in [layer.kind for layer in made.canvas.drawing.layers]
        and made.picture() != followed
    )


@pytest.mark.parametrize("moves", range(14))
def test_a_strip_shows_each_move_or_the_last_and_others(moves):
    """With at most as many moves as pictures all are there; none of a car that stands still."""
    controls = [((-1.0) ** k, 0.1) for k in range(moves)]
    drive = ke.Trajectory(
        ke.Car(30, 10, 20), (0, 0, 0), controls or np.empty((0, 2)), [9.0] * moves
    )
    plt.close("all")  # those of other tests
    figures.draw_moves(ke.Car(30, 10, 20), drive)
    axes = [ax for number in plt.get_fignums() for ax in plt.figure(number).axes]
    plt.close("all")
    numbers = [int(ax.get_title().split()[1]) for ax in axes if ax.get_visible()]
    assert len(numbers) == min(moves, 8) and numbers[-1:] == ([moves] if moves else [])
    assert moves > 8 or numbers == list(range(1, moves + 1))
