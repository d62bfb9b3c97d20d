"""Scenes: what is written is read back equal; what is wrong is refused by the name of its field."""

import copy
import json
import os
import re
import time
from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import kinoedu as ke
import kinoedu.files
from kinoedu.errors import (
    InvalidGoal,
    InvalidParameter,
    InvalidPoint,
    InvalidPolygon,
    InvalidRobot,
    InvalidStart,
    InvalidWorld,
    KinoeduError,
    UnknownFormat,
    UnreadableScene,
)
from kinoedu.files import read_scene

SCENE = {
    "version": 1,
    "about": "a square with a triangle, a disc and a house with a room",
    "robot": {"kind": "disk", "radius": 0.25},
    "world": {
        "kind": "polygons",
        "boundary": [[0, 0], [20, 0], [20, 10], [10, 6], [0, 10]],
        "obstacles": [
            {"polygon": [[2, 2], [4, 2], [3, 4]]},
            {"centre": [14, 3], "radius": 1.5},
            {
                "polygon": [[5, 1], [9, 1], [9, 5], [5, 5]],
                "rooms": [[[6, 2], [8, 2], [8, 4], [6, 4]]],
            },
        ],
    },
    "start": [1, 1],
    "goal": [19, 1],
}


def written(tmp_path, scene):
    """A scene as a file."""
    file = tmp_path / "scene.json"
    file.write_text(scene if isinstance(scene, str) else json.dumps(scene), encoding="utf-8")
    return file


def equal(a, b):
    """Whether two records hold the same numbers."""
    if isinstance(a, tuple):
        return type(a) is type(b) and all(map(equal, a, b))
    return np.array_equal(a, b)


def changed(path, value):
    """The scene with one field replaced, or removed where value is None."""
    scene = copy.deepcopy(SCENE)
    *way, last = path
    place = scene
    for step in way:
        place = place[step]
    if value is None:
        del place[last]
    else:
        place[last] = value
    return scene


def test_a_scene_is_read(tmp_path):
    """Robot, world, start and goal are those of the file; rooms are free."""
    problem = ke.read_scene(written(tmp_path, SCENE))
    assert problem.robot.radius == 0.25
    assert problem.start.tolist() == [1, 1]
    assert problem.is_free(np.array([7.0, 3.0]))
    assert not problem.is_free(np.array([5.5, 3.0]))


PROBLEMS = [
    ke.Problem(
        ke.Point(), ke.PolygonWorld([(0, 0), (1, 0), (1, 1 / 3), (0, 1)]), (0.1, 0.1), (0.2, 0.3)
    ),
    ke.Problem(
        ke.Disk(0.1),
        ke.Terrain([[1, 1, 0], [0, 1, 1]], resolution=0.3, origin=(-1, 7)),
        (-0.85, 7.15),
        (-0.25, 7.45),
    ),
    ke.Problem(
        ke.Point(),
        ke.PolygonWorld([(0, 0), (9, 0), (9, 9), (0, 9)], [((4, 4), 1 / 3)]),
        (1, 1),
        (8, 8),
        clearance=0.1,
    ),
]


@pytest.mark.parametrize("problem", PROBLEMS, ids=["point", "terrain", "clearance"])
def test_what_is_written_is_read_back_equal(tmp_path, problem):
    """Every number to the last bit."""
    ke.write_scene(problem, tmp_path / "scene.json")
    assert equal(ke.read_scene(tmp_path / "scene.json"), problem)


def test_a_read_scene_is_written_and_read_back_equal(tmp_path):
    """Also with rooms and round obstacles."""
    problem = ke.read_scene(written(tmp_path, SCENE))
    ke.write_scene(problem, tmp_path / "again.json")
    assert equal(ke.read_scene(tmp_path / "again.json"), problem)


@pytest.mark.parametrize(
    ("path", "value", "error", "message"),
    [
        (["version"], 2, UnreadableScene, "version must be 1"),
        (["version"], None, UnreadableScene, "lacks 'version'"),
        (["goal"], None, UnreadableScene, "lacks 'goal'"),
        (["gaol"], [1, 1], UnreadableScene, "did you mean 'goal'"),
        (
            ["robot", "radus"],
            1,
            UnreadableScene,
            "scene.robot has an unknown key 'radus'; did you mean 'radius'",
        ),
        (["robot", "radius"], -1, InvalidRobot, "radius"),
        (["robot", "radius"], True, UnreadableScene, "scene.robot.radius must be a number"),
        (["robot", "kind"], "tank", UnreadableScene, "point, disk"),
        (["robot"], "disk", UnreadableScene, "scene.robot"),
        (["world", "obstacles", 1, "radius"], 0, InvalidWorld, "obstacle 1"),
        (
            ["world", "obstacles", 1, "radius"],
            "big",
            UnreadableScene,
            r"scene.world.obstacles\[1\].radius must be a number",
        ),
        (["world", "obstacles", 0, "polygon"], [[2, 2], [4, 2]], InvalidPolygon, "obstacle 0"),
        (
            ["world", "obstacles", 0, "polygon"],
            [[2, 2], [4, 4], [4, 2], [2, 4]],
            InvalidPolygon,
            "crosses",
        ),
        (["world", "obstacles", 0, "polygon", 0], [2, "x"], UnreadableScene, r"polygon\[0\]\[1\]"),
        (["world", "boundary"], [[0, 0, 0]], InvalidPolygon, "boundary"),
        (["world", "boundary", 0], [1e160, 0], InvalidPoint, "1e150"),
        (["world", "obstacles", 2, "rooms"], [[[6, 2], [18, 2], [8, 4]]], InvalidPolygon, "room"),
        (["start"], [1, None], UnreadableScene, r"scene.start\[1\]"),
        (["start"], [1], InvalidPoint, "start must be 2 numbers"),
        (["start"], [3, 3], InvalidStart, "not free"),
        (["goal"], [99, 1], InvalidGoal, "inside the world"),
        (["clearance"], -1, InvalidParameter, "clearance"),
    ],
)
def test_what_is_wrong_is_named(tmp_path, path, value, error, message):
    """The error's kind, the field and the file."""
    with pytest.raises(error, match=message) as caught:
        ke.read_scene(written(tmp_path, changed(path, value)))
    assert "scene.json" in str(caught.value)


@pytest.mark.parametrize(
    "text",
    [
        "",
        "{",
        "[]",
        "null",
        '{"version": 1, "version": 1}',
        "[" * 100_000,
        '{"start": NaN}',
        "\x00",
        "1" * 5000,
        '{"a": 1e999}',
    ],
)
def test_what_is_no_scene_is_refused(tmp_path, text):
    """By UnreadableScene, whatever the text."""
    with pytest.raises(UnreadableScene):
        ke.read_scene(written(tmp_path, text))


@given(st.data())
@settings(
    derandomize=True,
    deadline=None,
    max_examples=300,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)
def test_a_damaged_scene_raises_only_named_errors(tmp_path, data):
    """A few characters changed anywhere: it is read, or refused by name."""
    text = list(json.dumps(SCENE))
    for _ in range(data.draw(st.integers(1, 3))):
        text[data.draw(st.integers(0, len(text) - 1))] = data.draw(
            st.sampled_from('0123456789-.eE"{}[],:xy \\N')
        )
    file = written(tmp_path, "".join(text))
    with suppress(KinoeduError):
        problem = ke.read_scene(file)
        assert problem.is_free(problem.start)


def test_other_extensions_are_refused(tmp_path):
    """For reading and for writing."""
    with pytest.raises(UnknownFormat):
        ke.read_scene(tmp_path / "scene.yaml")
    with pytest.raises(UnknownFormat):
        ke.write_scene(PROBLEMS[0], tmp_path / "scene.txt")


def test_nothing_is_written_half(tmp_path, monkeypatch):
    """Where writing fails the old scene stays, and no piece of the new one."""
    file = tmp_path / "scene.json"
    ke.write_scene(PROBLEMS[0], file)
    before = file.read_bytes()

    def full(*_args, **_options):
        raise OSError("no space left")

    monkeypatch.setattr(json, "dump", full)
    with pytest.raises(OSError, match="no space"):
        ke.write_scene(PROBLEMS[1], file)
    assert file.read_bytes() == before
    assert os.listdir(tmp_path) == ["scene.json"]


def test_a_map_beside_a_scene(tmp_path):
    """A scene may name a map by its file."""
    (tmp_path / "corner.map").write_text("type octile\nheight 2\nwidth 3\nmap\n..@\n...\n")
    scene = {
        "version": 1,
        "robot": {"kind": "point"},
        "world": {"kind": "map", "file": "corner.map"},
        "start": [0.5, 0.5],
        "goal": [2.5, 0.5],
    }
    assert ke.read_scene(written(tmp_path, scene)).world.free.tolist() == [
        [True, True, True],
        [True, True, False],
    ]


def test_a_terrain_has_a_row(tmp_path):
    scene = {**SCENE, "world": {"kind": "terrain", "rows": []}}
    with pytest.raises(UnreadableScene, match="at least one row"):
        ke.read_scene(written(tmp_path, scene))


def test_the_documented_scene_is_a_scene(tmp_path):
    """The example in the docs reads as it stands."""
    page = (Path(__file__).parent.parent / "docs" / "files.md").read_text(encoding="utf-8")
    assert (
        ke.read_scene(written(tmp_path, page.split("```json")[1].split("```")[0])).robot.radius
        == 0.25
    )


def test_every_function_of_the_page_is_where_it_says():
    """In `kinoedu.files`; those of the first paragraph are at the top level, and no others."""
    page = (Path(__file__).parent.parent / "docs" / "files.md").read_text(encoding="utf-8")
    named = set(re.findall(r"`(\w+)\(", page)) | {"read_mesh", "mesh_outline", "read_plan"}
    assert named <= set(kinoedu.files.__all__)
    top = page.split("also at the top level")[1].split(".\n")[0]
    listed = set(re.findall(r"`(\w+)`", top))
    assert len(listed) == 7
    assert {name for name in kinoedu.files.__all__ if hasattr(ke, name)} == listed


def test_read_problem_wants_each_thing_once(tmp_path):
    """A scene takes no start of another; a map without scenario needs one; queries are counted."""
    (tmp_path / "corner.map").write_text("type octile\nheight 2\nwidth 3\nmap\n..@\n...\n")
    with pytest.raises(InvalidParameter, match="no scenario"):
        ke.read_problem(tmp_path / "corner.map")
    with pytest.raises(InvalidParameter, match="both start and goal"):
        ke.read_problem(tmp_path / "corner.map", start=(0.5, 0.5))
    with pytest.raises(InvalidParameter, match="has its own"):
        ke.read_problem(written(tmp_path, SCENE), start=np.ones(2), goal=(2, 2))
    (tmp_path / "corner.scen").write_text(
        "version 1\n0\tcorner.map\t3\t2\t0\t0\t2\t1\t2.41421356\n"
    )
    assert ke.read_problem(tmp_path / "corner.map").goal.tolist() == [2.5, 0.5]
    for number in (-1, 1):
        with pytest.raises(InvalidParameter, match=rf"a query of .*0 to 0, got {number}"):
            ke.read_problem(tmp_path / "corner.map", query=number)
    (tmp_path / "corner.map").write_text("type octile\nheight 2\nwidth 4\nmap\n..@.\n....\n")
    with pytest.raises(UnreadableScene, match=r"query 0 is for a map of 3 x 2 .*has 4 x 2"):
        ke.read_problem(tmp_path / "corner.map")


@pytest.mark.parametrize("query", [None, 0])
def test_a_picture_is_asked_for_a_start_and_not_for_a_scenario(tmp_path, query):
    """Only maps have scenarios."""
    (tmp_path / "room.pgm").write_bytes(b"P5 2 2 255\n" + b"\xff" * 4)
    with pytest.raises(InvalidParameter, match=r"room\.pgm: it is only a world; give a start"):
        ke.read_problem(tmp_path / "room.pgm", query=query)


@pytest.mark.parametrize(
    ("length", "wheelbase", "behind"),
    [(3.93, 3.63, 0.30000000000000004), (0.35000000000000003, 0.2, 0.1)],
)
def test_a_car_is_read_back_equal_whatever_its_length_rounds_to(
    tmp_path, length, wheelbase, behind
):
    """The length is the sum of two rounded parts; the front axle may be at the very front."""
    world = ke.PolygonWorld([(-9, -9), (9, -9), (9, 9), (-9, 9)])
    car = ke.Car(length, 0.1, wheelbase, rear_overhang=behind)
    ke.write_scene(ke.Problem(car, world, (0, 0, 1), (4, 0, -2)), tmp_path / "car.json")
    read = ke.read_scene(tmp_path / "car.json").robot
    assert np.array_equal(read.outline, car.outline) and read.wheelbase == car.wheelbase


@pytest.mark.parametrize("sizes", [(30, 10, 20), (4.689, 1.942, 2.8), (0.3, 0.1, 0.07)])
def test_a_car_in_a_scene(tmp_path, sizes):
    """A car is written and read back, with what it steers and its speeds; what is left out has
    Car's defaults.
    """
    world = ke.PolygonWorld([(-50, -50), (50, -50), (50, 50), (-50, 50)])
    for car in (
        ke.Car(*sizes),
        ke.Car(*sizes, rear_overhang=0.02, max_steering=0.75, speeds=(1, 2.5)),
    ):
        ke.write_scene(ke.Problem(car, world, (0, 0, 1), (20, 0, -2)), tmp_path / "car.json")
        read = ke.read_scene(tmp_path / "car.json").robot
        assert np.allclose(read.outline, car.outline, rtol=1e-15, atol=1e-15) and np.array_equal(
            read.speeds, car.speeds
        )
        assert (read.wheelbase, read.max_steering, read.radius) == (
            car.wheelbase,
            car.max_steering,
            car.radius,
        )
    scene = json.loads((tmp_path / "car.json").read_text(encoding="utf-8"))
    scene["robot"] = {"kind": "car", "length": 30, "width": 10, "wheelbase": 20}
    assert np.array_equal(
        ke.read_scene(written(tmp_path, scene)).robot.outline, ke.Car(30, 10, 20).outline
    )


def test_a_repeated_key_among_many_is_found_at_once(tmp_path):
    """It took time that grew with the square of their number."""
    keys = ", ".join(f'"{min(i, 39_998)}": 1' for i in range(40_000))
    (tmp_path / "scene.json").write_text(f"{{{keys}}}")
    began = time.process_time()
    with pytest.raises(UnreadableScene, match="twice: '39998'"):
        read_scene(tmp_path / "scene.json")
    assert time.process_time() - began < 3.0
