"""Plans as files: what is written is read back equal, and what is wrong is refused by the name of
its field.
"""

import copy
import json
import subprocess
import sys

import numpy as np
import pytest

import kinoedu as ke
from kinoedu.cli import main
from kinoedu.errors import InvalidParameter, KinoeduError, UnknownFormat, UnreadableScene
from kinoedu.files import read_plan

SQUARE = [(0, 0), (10, 0), (10, 10), (0, 10)]
WORLD = ke.PolygonWorld(SQUARE, [[(4, 0), (6, 0), (6, 8), (4, 8)], ((8, 9), 0.5)])
BARRED = ke.PolygonWorld(SQUARE, [[(4, 0), (6, 0), (6, 10), (4, 10)]])
ENDS = ((1, 1), (9, 1))
TURNING = ke.Problem(
    ke.RigidPolygon([(-0.5, -0.1), (0.5, -0.1), (0.5, 0.1), (-0.5, 0.1)]),
    WORLD,
    (1, 1, 0),
    (9, 1, 3),
)
TURNING_AMONG_POLYGONS = TURNING._replace(
    world=ke.PolygonWorld(SQUARE, [[(4, 0), (6, 0), (5, 9.5)]])
)
ARM = ke.Problem(ke.TwoLinkArm(1, 0.5, 0.1, base=(2, 5)), WORLD, (1.0, 0.5), (-2.0, 1.0))
POINT = ke.Problem(ke.Point(), WORLD, *ENDS)
DRIVING = ke.Problem(
    ke.Car(0.8, 0.4, 0.5), ke.PolygonWorld(SQUARE, [((5, 5), 1)]), (1, 1, 0), (8, 7, 1)
)
PLANS = {
    "tree": lambda: ke.rrt(POINT, rng=0),
    "roadmap": lambda: ke.prm(POINT, n=60, rng=0),
    "walk": lambda: ke.bug1((1, 1), (9, 1), [[(4, 0), (6, 0), (6, 8), (4, 8)]], 0.5),
    "no path": lambda: ke.rrt(ke.Problem(ke.Point(), BARRED, *ENDS), max_nodes=40, rng=0),
    "terrain": lambda: ke.plan_on_grid(
        ke.Problem(ke.Point(), ke.Terrain(np.ones((4, 5))), (0.5, 0.5), (3.5, 2.5))
    ),
    "turning": lambda: ke.rrt(TURNING, rng=0),
    "arm": lambda: ke.rrt(ARM, rng=0),
    "cells with headings": lambda: ke.plan_by_cells_with_headings(TURNING_AMONG_POLYGONS),
    "recorded": lambda: ke.rrt(ke.Recorder(POINT), rng=0),
    "driven tree": lambda: ke.kinodynamic_rrt(DRIVING, rng=0),
    "driven tree that ends before": lambda: ke.kinodynamic_rrt(DRIVING, max_iterations=30, rng=0),
    "driven roadmap": lambda: ke.kinodynamic_prm(DRIVING, rng=0),
    "drive": lambda: ke.hybrid_astar(DRIVING),
}


def equal(a, b):
    """Whether two members of a plan hold the same numbers of the same types."""
    if isinstance(a, tuple):
        return type(a) is type(b) and all(map(equal, a, b))
    return np.array_equal(a, b) and np.asarray(a).dtype == np.asarray(b).dtype


@pytest.mark.parametrize("name", PLANS)
def test_a_plan_is_read_back_equal(name, tmp_path):
    """To the last bit, with the problem it answers where scenes can hold that; nothing is left
    beside the file.
    """
    plan = PLANS[name]()
    ke.write_plan(plan, tmp_path / "plan.json")
    again = ke.read_plan(tmp_path / "plan.json")
    for member in ("path", "cost", "tree", "roadmap", "walk", "trajectory"):
        assert equal(getattr(again, member), getattr(plan, member)), member
    assert (again.stats, again.reason, again.planner) == (plan.stats, plan.reason, plan.planner)
    assert [file.name for file in tmp_path.iterdir()] == ["plan.json"]
    if name != "walk":
        assert again.problem.goal.tolist() == plan.problem.goal.tolist()
        assert again.path is None or again.problem.is_free_path(again.path[0], again.path[1])


@pytest.mark.parametrize(
    ("name", "header"),
    [
        ("tree", "x,y"),
        ("turning", "x,y,theta"),
        ("arm", "theta1,theta2"),
        ("terrain", "x,y"),
        ("no path", "x,y"),
    ],
)
def test_a_path_in_rows_has_names_and_every_bit(name, header, tmp_path):
    """One configuration a row; without a path the names alone."""
    plan = PLANS[name]()
    ke.write_plan(plan, tmp_path / "plan.CSV")
    first, *rows = (tmp_path / "plan.CSV").read_text().splitlines()
    assert first == header
    assert [[float(number) for number in row.split(",")] for row in rows] == (
        [] if plan.path is None else plan.path.tolist()
    )


def test_a_number_that_is_too_large_for_a_float_is_refused(tmp_path):
    """Python would read 1e400 as infinite."""
    file = tmp_path / "plan.json"
    ke.write_plan(PLANS["tree"](), file)
    text = file.read_text()
    cost = text.partition('"cost": ')[2].partition(",")[0]
    file.write_text(text.replace(f'"cost": {cost}', '"cost": 1e400'))
    with pytest.raises(UnreadableScene, match="cost must be a number below 1e308"):
        ke.read_plan(file)


def test_what_is_no_plan_or_no_such_file_is_refused(tmp_path):
    """And what was there before stays as it was."""
    plan = PLANS["tree"]()
    with pytest.raises(UnknownFormat, match=r"\.csv"):
        ke.write_plan(plan, tmp_path / "plan.txt")
    with pytest.raises(InvalidParameter, match="Plan"):
        ke.write_plan(plan.path, tmp_path / "plan.json")
    with pytest.raises(OSError, match="gone"):
        ke.write_plan(plan, tmp_path / "gone" / "plan.json")
    with pytest.raises(UnknownFormat, match="json"):
        ke.read_plan(tmp_path / "plan.csv")
    file = tmp_path / "plan.json"
    file.write_text("before")
    broken = ke.Plan(plan.path, plan.cost, stats={"nodes": "many"}, problem=plan.problem)
    with pytest.raises(ValueError, match="many"):
        ke.write_plan(broken, file)
    assert file.read_text() == "before" and list(tmp_path.iterdir()) == [file]


CHANGES = [
    (("version",), 2, "version"),
    (("version",), ..., "version"),
    (("path",), None, "both a path and its cost"),
    (("path",), [], "path"),
    (("path",), [1, 2], "path"),
    (("path", 0), [1], "path"),
    (("path", 0, 0), "a", "path"),
    (("cost",), True, "cost"),
    (("cost",), None, "cost"),
    (("stats", "nodes"), 1.5, "nodes"),
    (("stats",), [], "stats"),
    (("tree", "nodes"), [], "tree.nodes"),
    (("tree", "nodes"), [1, 2], "tree.nodes"),
    (("tree", "parent"), [0], "tree.parent"),
    (("tree", "parent", 1), 10**6, "tree.parent"),
    (("tree", "parent", 1), 0.5, "tree.parent"),
    (("tree", "parent", 1), -2, "tree.parent"),
    (("tree", "parents"), [], "parents"),
    (("roadmap",), {"nodes": [[0, 0]], "edges": [[0, 1]]}, "roadmap.edges"),
    (("roadmap",), {"nodes": [[0, 0]], "edges": [0]}, "roadmap.edges"),
    (
        ("trajectory",),
        {"start": [0, 0], "controls": [], "durations": [], "wheelbase": 1},
        "trajectory.start",
    ),
    (
        ("trajectory",),
        {"start": [0, 0, 0], "controls": [[1, 0]], "durations": [], "wheelbase": 1},
        "trajectory.durations",
    ),
    (
        ("trajectory",),
        {"start": [0, 0, 0], "controls": [[1, 0]], "durations": [-1], "wheelbase": 1},
        "trajectory.durations",
    ),
    (
        ("trajectory",),
        {"start": [0, 0, 0], "controls": [[1]], "durations": [1], "wheelbase": 1},
        "trajectory.controls",
    ),
    (
        ("trajectory",),
        {"start": [0, 0, 0], "controls": [], "durations": [], "wheelbase": 0},
        "trajectory.wheelbase",
    ),
    (
        ("tree",),
        {"nodes": [[0, 0, 0]], "parent": [-1], "controls": [], "durations": [0]},
        "tree.controls",
    ),
    (
        ("tree",),
        {"nodes": [[0, 0, 0]], "parent": [-1], "controls": [[0, 0]], "duration": [0]},
        "mean 'durations'",
    ),
    (("planner",), 3, "planner"),
    (("problem", "start", 0), 5, "start"),
    (("surplus",), 1, "surplus"),
]


@pytest.mark.parametrize(("way", "value", "says"), CHANGES, ids=lambda value: str(value)[:30])
def test_a_wrong_file_is_refused_by_its_field(way, value, says, tmp_path):
    """With the file's name."""
    file = tmp_path / "plan.json"
    ke.write_plan(PLANS["tree"](), file)
    whole = json.loads(file.read_text())
    wrong = copy.deepcopy(whole)
    place = wrong
    for step in way[:-1]:
        place = place[step]
    if value is ...:
        del place[way[-1]]
    else:
        place[way[-1]] = value
    file.write_text(json.dumps(wrong))
    with pytest.raises(KinoeduError, match=rf"plan\.json.*{says}"):
        ke.read_plan(file)


def test_a_plan_cut_short_is_refused(tmp_path):
    """At any byte."""
    file = tmp_path / "plan.json"
    ke.write_plan(PLANS["no path"](), file)
    data = file.read_bytes()
    for end in range(0, len(data), len(data) // 30):
        file.write_bytes(data[:end])
        with pytest.raises(UnreadableScene):
            ke.read_plan(file)


def test_the_command_line_saves(tmp_path, capsys):
    """As JSON and as CSV; a wrong ending is refused before anything is planned."""
    scene = tmp_path / "scene.json"
    ke.write_scene(POINT, scene)
    for name in ("plan.json", "plan.csv"):
        assert main(["plan", str(scene), "--save", str(tmp_path / name)]) == 0
        assert f"saved in {tmp_path / name}" in capsys.readouterr().out
    rows = (tmp_path / "plan.csv").read_text().splitlines()[1:]
    assert len(rows) == len(ke.read_plan(tmp_path / "plan.json").path)
    for wrong in (tmp_path / "plan.png", scene, tmp_path / "gone" / "plan.json"):
        assert main(["plan", str(scene), "--save", str(wrong)]) == 2
        assert capsys.readouterr().err.startswith("kinoedu: --save")


def empty_plan(**parts) -> str:
    """A plan's file without a path."""
    missing = dict.fromkeys(("cost", "path", "tree", "roadmap", "walk", "problem"))
    plan = {"version": 1, "planner": "mine", "reason": "", "stats": {}, **missing, **parts}
    return json.dumps(plan)


def test_large_counts_are_read_to_the_last_digit(tmp_path):
    """They are integers, and never floats."""
    stats = {"nodes": 2**53 + 1, "checks": 10**400}
    (tmp_path / "plan.json").write_text(empty_plan(stats=stats))
    assert read_plan(tmp_path / "plan.json").stats == stats


def test_only_a_parent_is_none_of_the_nodes(tmp_path):
    """An edge to -1 was drawn to the last node."""
    roadmap = {"nodes": [[0, 0], [1, 1]], "edges": [[-1, 0]]}
    (tmp_path / "plan.json").write_text(empty_plan(roadmap=roadmap))
    with pytest.raises(UnreadableScene, match="edges"):
        read_plan(tmp_path / "plan.json")


def test_a_plan_is_not_taken_for_a_scene(tmp_path):
    """The message says where the plan has one."""
    ke.write_plan(PLANS["tree"](), tmp_path / "plan.json")
    with pytest.raises(UnreadableScene, match="is a plan, for read_plan; its 'problem' is a"):
        ke.read_problem(tmp_path / "plan.json")


def test_mended_polygons_are_a_line_of_the_command(tmp_path):
    """As an error is, without the place in the code."""
    ring = [[1, 1], [3, 3], [3, 1], [1, 3]]  # crosses itself
    outline = [[0, 0], [9, 0], [9, 0.1], [0, 0.1]]
    scene = {"polygons": [ring, outline, [[x, y + 9] for x, y in outline]]}
    file = tmp_path / "hall.json"
    file.write_text(json.dumps({**scene, "start": [5, 5], "goal": [8, 8]}), encoding="utf-8")
    ran = subprocess.run(
        [sys.executable, "-m", "kinoedu", "plan", str(file)], capture_output=True, text=True
    )
    assert ran.returncode == 0
    warned = [line for line in ran.stderr.splitlines() if not line.endswith("...")]
    assert warned == [
        f"kinoedu: warning: {file}: polygon 0 crosses or touches itself: the region it encloses is "
        "solid"
    ]
