"""Files for other programs: ROS 2, OMPL.app, MovingAI; and drawings that are repaired."""

import json
import math
import warnings
from pathlib import Path

import numpy as np
import pytest
import shapely
import yaml

import kinoedu as ke
from kinoedu.cli import main
from kinoedu.errors import (
    InvalidParameter,
    InvalidPolygon,
    KinoeduError,
    MendedPolygons,
    SceneTooLarge,
    UnknownFormat,
    UnreadableScene,
)
from kinoedu.experiments import read_experiment, run
from kinoedu.files import (
    mesh_world,
    poses_along,
    read_scenario_problems,
    ros_path_text,
    write_ompl_app,
    write_scenario,
    write_world,
)
from kinoedu.files.meshes import UPRIGHT
from kinoedu.files.movingai import Query, read_scenario
from kinoedu.worlds.polygon_world import rings_of

GRID = Path(__file__).parent / "data" / "grid"
HALL = ke.PolygonWorld(
    [(0, 0), (10, 0), (10, 10), (0, 10)],
    [
        [(4, 0), (6, 0), (6, 8), (4, 8)],
        ((8, 8), 1.0),
        ([(1, 5), (3, 5), (3, 7), (1, 7)], [[(1.5, 5.5), (2.5, 5.5), (2.5, 6.5), (1.5, 6.5)]]),
    ],
)
PROBLEM = ke.Problem(ke.Disk(0.3), HALL, (1, 1), (9, 1))
PLAN = ke.rrt_connect(PROBLEM, rng=0)
ARM = ke.Problem(ke.TwoLinkArm(0.5, 0.5, 0.1, base=(2, 2)), HALL, (0, 0), (1, 0))
REACHING = ke.Plan(np.array([ARM.start, ARM.goal]), 1.0, problem=ARM)


def headings_of(path):
    """The yaw of each pose of a nav_msgs/Path, from its quaternion."""
    turned = [pose["pose"]["orientation"] for pose in path["poses"]]
    assert all(q["x"] == q["y"] == 0.0 for q in turned)
    assert all(math.hypot(q["z"], q["w"]) == pytest.approx(1.0) for q in turned)
    return [2.0 * math.atan2(q["z"], q["w"]) for q in turned]


def positions_of(path):
    """The positions of a nav_msgs/Path."""
    places = [pose["pose"]["position"] for pose in path["poses"]]
    return [(q["x"], q["y"]) for q in places]


def test_a_path_for_ros_has_its_points_and_headings(tmp_path):
    """All fields are numbers to any reader of YAML, and the frames are those of the map."""
    ke.write_plan(PLAN, tmp_path / "plan.yaml")
    path = yaml.safe_load((tmp_path / "plan.yaml").read_text())
    assert positions_of(path) == [tuple(q) for q in PLAN.path.tolist()]
    steps = np.diff(PLAN.path, axis=0)
    expected = np.arctan2(steps[:, 1], steps[:, 0])
    assert np.allclose(np.exp(1j * np.array(headings_of(path)[:-1])), np.exp(1j * expected))
    assert {pose["header"]["frame_id"] for pose in path["poses"]} == {"map"}
    assert path["header"] == {"stamp": {"sec": 0, "nanosec": 0}, "frame_id": "map"}
    numbers = [v for pose in path["poses"] for q in pose["pose"].values() for v in q.values()]
    assert all(type(v) is float for v in numbers)


@pytest.mark.parametrize("tiny", [1e-17, 1e20, -3e-300, 5.0])
def test_numbers_with_exponents_stay_numbers(tiny):
    """YAML 1.1 reads 1e-17 as text."""
    plan = ke.Plan(np.array([(tiny, 0.0), (tiny, 1.0)]), 1.0)
    assert positions_of(yaml.safe_load(ros_path_text(plan))) == [(tiny, 0.0), (tiny, 1.0)]


def test_a_pose_where_the_robot_waits_looks_where_it_goes_next():
    """Or at the goal where it came from; a motion of length 0 has no direction of its own."""
    path = np.array([(1, 1), (1, 1), (4, 4), (4, 4), (4, 9), (4, 9), (4, 9)], float)
    headings = poses_along(ke.Plan(path, 10.0))[:, 2]
    assert headings.tolist() == [np.pi / 4] * 2 + [np.pi / 2] * 5
    assert poses_along(ke.Plan(path[:2], 0.0)).tolist() == [[1.0, 1.0, 0.0]] * 2


def test_poses_are_as_close_as_asked():
    """On the path's motions, its own points among them."""
    poses = poses_along(PLAN, 0.2)
    gaps = np.linalg.norm(np.diff(poses[:, :2], axis=0), axis=1)
    assert gaps.max() <= 0.2 + 1e-9
    line = shapely.LineString(PLAN.path)
    assert all(line.distance(shapely.Point(q)) < 1e-9 for q in poses[:, :2])
    assert {tuple(q) for q in PLAN.path.tolist()} <= {tuple(q) for q in poses[:, :2].tolist()}


def test_a_cars_poses_follow_its_drive():
    """And the arcs between the poses of a tree of curves."""
    room = ke.PolygonWorld([(0, 0), (20, 0), (20, 20), (0, 20)])
    car = ke.Problem(ke.Car(2, 1, 1.4), room, (4, 4, 0), (14, 12, 1.5))
    drive = ke.hybrid_astar(car)
    poses = poses_along(drive)
    assert np.linalg.norm(np.diff(poses[:, :2], axis=0), axis=1).max() <= 1.4 / 20 + 1e-9
    assert np.allclose(poses[[0, -1]], drive.trajectory.poses[[0, -1]])
    curved = poses_along(ke.rrt(car, rng=0))
    moves = np.diff(curved[:, :2], axis=0)
    ways = np.column_stack([np.cos(curved[:-1, 2]), np.sin(curved[:-1, 2])])
    across = np.abs(moves[:, 0] * ways[:, 1] - moves[:, 1] * ways[:, 0])
    assert across.max() < 0.1 * np.linalg.norm(moves, axis=1).max()


def test_no_path_is_a_file_without_poses(tmp_path):
    """It is an answer too, and the file says so."""
    none = ke.Plan(None, np.inf, problem=PROBLEM)
    for name in ("plan.yaml", "plan.path"):
        ke.write_plan(none, tmp_path / name)
    assert yaml.safe_load((tmp_path / "plan.yaml").read_text())["poses"] == []
    assert (tmp_path / "plan.path").read_text() == ""


def test_the_command_line_saves_for_other_programs(tmp_path, capsys):
    """--save by the name's ending."""
    ke.write_scene(PROBLEM, tmp_path / "hall.json")
    for name in ("plan.yaml", "plan.path"):
        assert main(["plan", str(tmp_path / "hall.json"), "--save", str(tmp_path / name)]) == 0
    poses = np.loadtxt(tmp_path / "plan.path")
    assert poses.shape[1] == 3 and poses[0, :2].tolist() == [1.0, 1.0]
    assert main(["plan", str(tmp_path / "hall.json"), "--save", str(tmp_path / "p.txt")]) == 2
    assert "a plan ends in .json, .csv, .yaml or .path" in capsys.readouterr().err


@pytest.mark.parametrize("name", ["maze-32-32-2.map", "empty-8-8.map"])
@pytest.mark.parametrize("ending", [".map", ".yaml"])
def test_a_map_is_read_again_as_it_was_written(name, ending, tmp_path):
    """Cell by cell, the right way up; for ROS with its resolution and place."""
    world = ke.read_world(GRID / name)
    if ending == ".yaml":
        world = ke.Terrain(world.free, resolution=0.05, origin=(-3.5, 1e-7))
    write_world(world, tmp_path / f"out{ending}")
    again = ke.read_world(tmp_path / f"out{ending}")
    assert np.array_equal(again.free, world.free)
    assert (again.resolution, again.origin.tolist()) == (world.resolution, world.origin.tolist())


def test_small_numbers_of_a_map_are_numbers_in_every_yaml(tmp_path):
    """1e-05 is text to a YAML 1.1 parser, such as Python's."""
    world = ke.Terrain([[1, 0]], resolution=1e-5, origin=(-1e-7, 0))
    write_world(world, tmp_path / "small.yaml")
    settings = yaml.safe_load((tmp_path / "small.yaml").read_text())
    assert (settings["resolution"], settings["origin"]) == (1e-5, [-1e-7, 0.0, 0.0])


def test_cells_of_polygons_are_free_where_their_whole_square_is(tmp_path):
    """shapely is the judge; no path on the map meets an obstacle."""
    write_world(HALL, tmp_path / "hall.yaml", resolution=0.5)
    free = ke.read_world(tmp_path / "hall.yaml").free
    solids = [shapely.Polygon(rings[0], rings[1:]) for rings in rings_of(HALL)[1:]]
    solids.append(shapely.Point(8, 8).buffer(1.0, 64))
    for j in range(20):
        for i in range(20):
            cell = shapely.box(0.5 * i, 0.5 * j, 0.5 * i + 0.5, 0.5 * j + 0.5)
            meets = any(cell.intersects(solid) for solid in solids)
            meets |= i in (0, 19) or j in (0, 19)
            assert not (free[j, i] and meets), (i, j)
    assert free.sum() > 100


def test_a_world_keeps_its_place_in_cells(tmp_path):
    """The cells begin at its lower left corner; the circles round the corners of two are free."""
    room = ke.PolygonWorld([(10, 20), (13.9, 20), (13.9, 23), (10, 23)])
    write_world(room, tmp_path / "room.yaml", resolution=1.0)
    terrain = ke.read_world(tmp_path / "room.yaml")
    assert terrain.origin.tolist() == [10, 20]
    assert terrain.free.astype(int).tolist() == [[0, 0, 0, 0], [0, 1, 1, 0], [0, 0, 0, 0]]


QUERY = Query("x.map", np.array([0.5, 0.5]), np.array([1.5, 0.5]), 1.0, 3, 2)


@pytest.mark.parametrize(
    ("write", "error", "words"),
    [
        (lambda to: write_world(HALL, to / "a.map"), InvalidParameter, "give resolution="),
        (lambda to: write_world(HALL, to / "a.png"), UnknownFormat, "ends in .map"),
        *(
            (lambda to, side=side: write_world(HALL, to / "a.map", resolution=side), error, words)
            for side, error, words in (
                (1e-4, SceneTooLarge, "100000 x 100000 cells are"),
                (1e-300, SceneTooLarge, "1e\\+301 x 1e\\+301 cells are"),
                (5e-324, SceneTooLarge, "inf x inf cells are"),
            )
        ),
        (lambda to: write_world(3, to / "a.map"), InvalidParameter, "takes a Terrain"),
        (
            lambda to: write_world(ke.Terrain([[1, 1]], cost=[[1, 2]]), to / "a.map"),
            InvalidParameter,
            "hold no costs",
        ),
        (
            lambda to: write_world(ke.Terrain([[1]]), to / "a.map", resolution=2.0),
            InvalidParameter,
            "its own resolution",
        ),
        (lambda to: write_world(ke.Terrain([[1]]), to / "a b.yaml"), InvalidParameter, "letters"),
        (lambda to: write_ompl_app(PROBLEM, to / "a.json"), UnknownFormat, "ends in .cfg"),
        (lambda to: write_ompl_app(3, to / "a.cfg"), InvalidParameter, "takes a Problem"),
        (lambda to: write_ompl_app(PROBLEM, to / "a#1.cfg"), InvalidParameter, "begins a comment"),
        (
            lambda to: write_ompl_app(PROBLEM._replace(robot=ke.Point()), to / "a.cfg"),
            InvalidParameter,
            "moves a body",
        ),
        (
            lambda to: write_ompl_app(PROBLEM._replace(world=ke.Terrain([[1]])), to / "a.cfg"),
            InvalidParameter,
            "among polygons",
        ),
        (
            lambda to: write_ompl_app(PROBLEM._replace(clearance=1.0), to / "a.cfg"),
            InvalidParameter,
            "no clearance",
        ),
        (lambda to: write_scenario([], to / "a.txt"), UnknownFormat, "ends in .scen"),
        (lambda to: write_scenario([3], to / "a.scen"), InvalidParameter, "holds Query records"),
        (
            lambda to: write_scenario(QUERY.length, to / "a.scen"),
            InvalidParameter,
            "must be a list",
        ),
        *(
            (lambda to, q=query: write_scenario([q], to / "a.scen"), InvalidParameter, words)
            for query, words in (
                (QUERY._replace(start=np.array([np.nan, 0.5])), "centre of a cell"),
                (QUERY._replace(goal=np.array([0.5, np.inf])), "centre of a cell"),
                (QUERY._replace(start=np.array([3.5, 0.5])), "centre of a cell"),
                (QUERY._replace(goal=np.array([0.5, -0.5])), "centre of a cell"),
                (QUERY._replace(map_name=" x.map"), "without blanks"),
                (QUERY._replace(map_name=None), "name is text"),
                (QUERY._replace(length=1e18), "less than 1e.18, got 1e.18"),
                (QUERY._replace(length=-1.0), "zero or more"),
                (QUERY._replace(length="3"), "zero or more, and less than 1e.18, got '3'"),
                (QUERY._replace(columns=3.0), "a map's side must be a whole number"),
            )
        ),
        (lambda to: ke.read_problem(GRID / "empty-8-8.map", query=0.5), InvalidParameter, "query"),
        (lambda to: ros_path_text(3), InvalidParameter, "a path is written of a plan"),
        (lambda to: ros_path_text(PLAN, frame="a b"), InvalidParameter, "frame must be a name"),
        (lambda to: ros_path_text(PLAN, frame=3), InvalidParameter, "frame must be a name"),
        (lambda to: poses_along(REACHING), InvalidParameter, "not of an arm"),
        (lambda to: poses_along(PLAN, 0.0), InvalidParameter, "spacing must be a positive"),
        (
            lambda to: read_scenario_problems(GRID / "empty-8-8-even-1.scen", [0, 0]),
            InvalidParameter,
            "each once",
        ),
        (
            lambda to: read_scenario_problems(GRID / "empty-8-8-even-1.scen", 3),
            InvalidParameter,
            "queries must be a list",
        ),
        (
            lambda to: read_scenario_problems(GRID / "empty-8-8-even-1.scen", [10**6]),
            InvalidParameter,
            "a query of .*empty-8-8-even-1.scen must be a whole number from 0 to",
        ),
        (lambda to: read_scenario_problems(GRID / "empty-8-8.map"), UnknownFormat, "ends in .scen"),
    ],
)
def test_what_another_program_cannot_hold_is_refused(write, error, words, tmp_path):
    """By name, and nothing is written."""
    with pytest.raises(error, match=words):
        write(tmp_path)
    assert list(tmp_path.iterdir()) == []


def test_a_problem_for_ompl_app_has_the_obstacles_and_the_ends(tmp_path):
    """Its meshes are all that is solid to shapely; a disc's polygon contains the disc."""
    import configparser

    write_ompl_app(PROBLEM, tmp_path / "hall.cfg")
    settings = configparser.ConfigParser()
    settings.read(tmp_path / "hall.cfg")
    problem = settings["problem"]
    assert [float(problem[f"start.{c}"]) for c in ("x", "y", "theta")] == [1.0, 1.0, 0.0]
    assert [float(problem[f"volume.max.{c}"]) for c in "xy"] == [10.0, 10.0]
    assert {problem["robot"], problem["world"]} == {"hall_robot.obj", "hall_env.obj"}
    assert set(settings["benchmark"]) == {"time_limit", "mem_limit", "run_count"}
    assert set(settings["planner"]) == {"rrt", "prm"}
    made = mesh_world(tmp_path / problem["world"])
    solid = shapely.union_all([shapely.Polygon(r[0], r[1:]) for r in rings_of(made)[1:]])
    free = shapely.box(0, 0, 10, 10).difference(solid).area
    assert free == pytest.approx(100.0 - math.pi - 16.0 - 3.0, rel=1e-3)
    outline = ke.files.mesh_outline(tmp_path / problem["robot"])
    assert shapely.Polygon(outline).buffer(1e-9).contains(shapely.Point(0, 0).buffer(0.3, 64))


@pytest.mark.parametrize("outline", [[(0, 0), (9, 0), (0, 9)], [(0, 0), (9, 0), (3, 3), (0, 9)]])
def test_a_body_in_ompl_app_cannot_leave_the_world(outline, tmp_path):
    """Round the outline, of any shape, there is a wall; also where there are no obstacles."""
    problem = ke.Problem(ke.Disk(0.3), ke.PolygonWorld(outline), (1, 1), (2, 1))
    write_ompl_app(problem, tmp_path / "corner.cfg")
    made = mesh_world(tmp_path / "corner_env.obj")
    wall = shapely.union_all([shapely.Polygon(r[0], r[1:]) for r in rings_of(made)[1:]])
    assert wall.area == pytest.approx(10.8**2 - shapely.Polygon(outline).area)
    assert wall.buffer(1e-9).contains(shapely.Polygon(outline).exterior)


def test_a_car_for_ompl_app_is_a_kinematic_car(tmp_path):
    """With its headings."""
    car = ke.Problem(ke.Car(1, 0.5, 0.6), HALL, (1, 1, 0.5), (9, 1, -1))
    write_ompl_app(car, tmp_path / "car.cfg")
    text = (tmp_path / "car.cfg").read_text()
    assert "control = kinematic_car" in text and "goal.theta = -1.0" in text
    assert "rrt=" in text and "prm" not in text


@pytest.mark.parametrize("name", ["maze-32-32-2-even-1", "empty-8-8-even-1"])
def test_a_scenario_is_read_again_as_it_was_written(name, tmp_path):
    """Every query: the map's name, the cells, the length."""
    queries = read_scenario(GRID / f"{name}.scen")
    write_scenario(queries, tmp_path / "again.scen")
    again = read_scenario(tmp_path / "again.scen")
    assert len(again) == len(queries) > 0
    for one, other in zip(queries, again):
        assert one.map_name == other.map_name and one.rows == other.rows
        assert np.array_equal(one.start, other.start) and np.array_equal(one.goal, other.goal)
        assert other.length == pytest.approx(one.length, abs=1e-8)
    half = queries[0]._replace(start=np.array([0.7, 0.5]))
    with pytest.raises(InvalidParameter, match="not the centre of a cell"):
        write_scenario([half], tmp_path / "half.scen")


def test_a_scenario_is_an_experiment(tmp_path):
    """Each query a problem with its number, and A* finds the lengths that the scenario says."""
    for file in GRID.glob("maze-32-32-2*"):
        (tmp_path / file.name).write_bytes(file.read_bytes())
    scenario = "maze-32-32-2-even-1.scen"
    (tmp_path / "maze.toml").write_text(
        f'[problems.maze]\nscenario = "{scenario}"\nqueries = [0, 5, 11]\n'
        '[planners."A*"]\nplanner = "plan_on_grid"\n'
    )
    table = run(read_experiment(tmp_path / "maze.toml"), where="here")
    assert table.problems() == ["maze 0", "maze 5", "maze 11"]
    queries = read_scenario(tmp_path / scenario)
    assert table.column("cost") == pytest.approx([queries[k].length for k in (0, 5, 11)])
    problems = read_scenario_problems(tmp_path / scenario)
    assert len(problems) == len(queries) and "maze-32-32-2-even-1 0" in problems
    last = len(queries) - 1
    assert list(read_scenario_problems(tmp_path / scenario, [last])) == [list(problems)[last]]
    wrong = (tmp_path / "maze.toml").read_text().replace("[0, 5, 11]", '["a"]')
    (tmp_path / "wrong.toml").write_text(wrong)
    with pytest.raises(KinoeduError, match=r"a query of .* must be a whole number"):
        read_experiment(tmp_path / "wrong.toml")


def test_upright_axes_are_turned_and_never_mirrored():
    """docs/files.md says so, and its picture shows it."""
    for axes in UPRIGHT.values():
        turned = np.zeros((3, 3))
        for row, (axis, sign) in enumerate(axes):
            turned[row, axis] = sign
        assert np.linalg.det(turned) == pytest.approx(1.0)


SQUARE = [[0, 0], [10, 0], [10, 10], [0, 10]]
DRAWN = {
    "version": 1,
    "robot": {"kind": "point"},
    "world": {
        "kind": "polygons",
        "boundary": [*SQUARE, SQUARE[0]],
        "obstacles": [
            {"polygon": [[2, 2], [4, 2], [4, 2], [4, 4], [2, 4], [2, 2]]},
            {"centre": [8, 8], "radius": 0.5},
            {"polygon": [[5, 5], [7, 7], [7, 5], [5, 7]]},
            {"polygon": [[4, 4], [2, 4], [2, 2], [4, 2]]},
            {
                "polygon": [[1, 7], [3, 7], [3, 9], [3, 9], [1, 9]],
                "rooms": [[[1.5, 7.5], [2.5, 7.5], [2.5, 7.5], [2.5, 8.5]]],
            },
        ],
    },
    "start": [1, 1],
    "goal": [9, 1],
}


def test_a_drawing_with_repeated_corners_is_repaired_on_request(tmp_path):
    """It says which polygons it mended, and how; otherwise the first is refused by name."""
    file = tmp_path / "drawn.json"
    file.write_text(json.dumps(DRAWN))
    with pytest.raises(InvalidPolygon, match="boundary"):
        ke.read_scene(file)
    said = (
        r"world\.boundary repeats 1.*polygon 0 repeats 2.*polygon 2 crosses.*polygon 3 is polygon "
        r"0 again.*obstacles\[4\]\.polygon repeats 1.*obstacles\[4\]\.rooms\[0\] repeats 1"
    )
    with pytest.warns(MendedPolygons, match=said):
        problem = ke.read_problem(file, repair=True)
    areas = [shapely.Polygon(r[0], r[1:]).area for r in rings_of(problem.world)[1:]]
    assert sorted(areas) == pytest.approx([1.0, 1.0, 3.5, 4.0])
    assert len(problem.world.obstacles.radius[problem.world.obstacles.radius > 0]) == 1


def test_repaired_obstacles_keep_their_order(tmp_path):
    """An obstacle with rooms stays before those that follow it, also where one was mended."""
    file = tmp_path / "drawn.json"
    obstacles = DRAWN["world"]["obstacles"]
    rooms = next(item for item in obstacles if "rooms" in item)
    world = {**DRAWN["world"], "obstacles": [rooms, *(o for o in obstacles if o is not rooms)]}
    file.write_text(json.dumps({**DRAWN, "world": world}))
    with pytest.warns(MendedPolygons):
        problem = ke.read_problem(file, repair=True)
    assert [len(rings) - 1 for rings in rings_of(problem.world)[1:]] == [1, 0, 0, 0]


def test_a_right_scene_is_not_mended(tmp_path):
    """No warning, and the same problem to the last bit."""
    ke.write_scene(PROBLEM, tmp_path / "hall.json")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        again = ke.read_scene(tmp_path / "hall.json", repair=True)
    for one, other in zip(rings_of(again.world), rings_of(HALL)):
        assert all(np.array_equal(a, b) for a, b in zip(one, other))
    terrain = ke.Problem(ke.Point(), ke.Terrain([[1, 1]]), (0.5, 0.5), (1.5, 0.5))
    ke.write_scene(terrain, tmp_path / "terrain.json")
    assert ke.read_scene(tmp_path / "terrain.json", repair=True).start.tolist() == [0.5, 0.5]


@pytest.mark.parametrize(
    "change",
    [
        {"world": 3},
        {"world": {"kind": "polygons"}},
        {"world": {"kind": "polygons", "boundary": SQUARE, "obstacles": 3}},
        {"world": {"kind": "polygons", "boundary": SQUARE, "obstacles": [{"polygon": [3]}]}},
        {"world": {"kind": "polygons", "boundary": SQUARE, "obstacles": [{"polygon": [[1, 1]]}]}},
        {"world": {"kind": "polygons", "boundary": SQUARE, "obstacles": [5]}},
    ],
)
def test_a_scene_beyond_repair_is_a_named_error(change, tmp_path):
    """As without repair."""
    file = tmp_path / "broken.json"
    file.write_text(json.dumps({**DRAWN, **change}))
    for repair in (False, True):
        with pytest.raises(KinoeduError):
            ke.read_scene(file, repair=repair)


def test_a_length_is_written_to_its_last_bit(tmp_path):
    """Eight decimals, as MovingAI's own files, where they say it all."""
    ends = np.array([0.5, 0.5]), np.array([1.5, 1.5])
    query = Query("m", *ends, math.sqrt(2.0), 3, 3)
    lengths = [math.sqrt(2.0), 5e-324, 1e-100, 3e17, math.nextafter(1e18, 0.0), 2.5]
    write_scenario([query._replace(length=length) for length in lengths], tmp_path / "a.scen")
    assert [one.length for one in read_scenario(tmp_path / "a.scen")] == lengths
    assert (tmp_path / "a.scen").read_text().endswith("\t2.50000000\n")
    with pytest.raises(InvalidParameter):
        write_scenario([query._replace(map_name="a\tb")], tmp_path / "b.scen")


def test_a_scenario_names_its_map(tmp_path):
    (tmp_path / "a.scen").write_text("version 1\n0\tmaps/\t3\t3\t0\t0\t1\t1\t1.0\n")
    with pytest.raises(UnreadableScene, match="name of a map"):
        read_scenario_problems(tmp_path / "a.scen")
