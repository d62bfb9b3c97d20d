"""Meshes and Bench-MR maps: the polygons they become, against the solids; and named errors."""

import json
import warnings
from pathlib import Path

import numpy as np
import pytest
import shapely
import trimesh
from trimesh.transformations import rotation_matrix, translation_matrix

import kinoedu as ke
from kinoedu.errors import (
    InvalidParameter,
    InvalidPolygon,
    InvalidRobot,
    KinoeduError,
    MendedPolygons,
    UnknownFormat,
    UnreadableScene,
)
from kinoedu.files import mesh_outline, mesh_world, read_benchmr, read_mesh
from kinoedu.worlds.polygon_world import rings_of

BENCHMR = Path(__file__).parent / "data" / "benchmr"
KINDS = ("stl", "obj", "dae", "glb")

DAE = """<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
 <asset><created>2020-01-01T00:00:00</created><modified>2020-01-01T00:00:00</modified>
  <up_axis>{up}_UP</up_axis></asset>
 <library_geometries><geometry id="g"><mesh>
  <source id="p"><float_array id="a" count="12">0 0 0  4 0 0  0 2 0  0 0 1</float_array>
   <technique_common><accessor source="#a" count="4" stride="3">
    <param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
    </accessor>
   </technique_common></source>
  <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
  <triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/>
   <p>0 2 1 0 1 3 0 3 2 1 2 3</p></triangles>
 </mesh></geometry></library_geometries>
 <library_visual_scenes><visual_scene id="s">
  <node id="n1"><instance_geometry url="#g"/></node>
  <node id="n2"><translate>10 0 0</translate><rotate>0 0 1 90</rotate>
   <instance_geometry url="#g"/></node>
 </visual_scene></library_visual_scenes>
 <scene><instance_visual_scene url="#s"/></scene>
</COLLADA>"""


def saved(mesh, folder, kind, name="mesh"):
    """Write a mesh or a scene to a file."""
    data = mesh.export(file_type=kind)
    file = folder / f"{name}.{kind}"
    file.write_bytes(data if isinstance(data, bytes) else data.encode())
    return file


def area(solids):
    """The area that polygons with rooms cover, by shapely."""
    shapes = [shapely.Polygon(outline, rooms) for outline, rooms in solids]
    assert all(shape.is_valid for shape in shapes)
    return sum(shape.area for shape in shapes)


def corners(ring):
    """The corners of a ring, without order."""
    return {tuple(corner) for corner in (np.round(ring, 6) + 0.0).tolist()}


@pytest.mark.parametrize("kind", KINDS)
def test_a_box_is_its_rectangle_from_every_format(tmp_path, kind):
    """Projected and sliced, along each axis; without corners inside an edge."""
    file = saved(trimesh.creation.box((1, 2, 4)), tmp_path, kind)
    for options, (x, y) in (
        ({}, (1, 2)),
        ({"up": "y"}, (1, 4)),
        ({"up": "x"}, (2, 4)),
        ({"slice_at": 0.3}, (1, 2)),
    ):
        [(outline, rooms)] = read_mesh(file, **options)
        assert corners(outline) == {(sx * x / 2, sy * y / 2) for sx in (-1, 1) for sy in (-1, 1)}
        assert len(outline) == 4 and rooms == []
    assert isinstance(ke.read_world(file), type(ke.PolygonWorld(outline)))


@pytest.mark.parametrize("up", ["X", "Y", "Z"])
def test_bodies_stand_where_the_scene_puts_them_and_up_is_the_files_when_asked(tmp_path, up):
    """Two instances of a tetrahedron, one moved and rotated; each plane is right-handed."""
    file = tmp_path / "two.dae"
    file.write_text(DAE.format(up=up))
    left, right = (outline for outline, _ in read_mesh(file))
    assert corners(left) == {(0, 0), (4, 0), (0, 2)}
    assert corners(right) == {(10, 0), (10, 4), (8, 0)}
    seen = {
        "Z": [{(0, 0), (4, 0), (0, 2)}, {(10, 0), (10, 4), (8, 0)}],
        "Y": [{(0, 0), (4, 0), (0, -1)}, {(10, 0), (8, 0), (10, -1)}],
        "X": [{(-4, 0), (0, 0), (0, -1)}],  # one before the other
    }[up]
    assert [corners(outline) for outline, _ in read_mesh(file, up="file")] == seen


def test_y_is_up_in_a_dae_that_names_no_axis(tmp_path):
    """As in one that names it."""
    named = DAE.format(up="Y")
    read = []
    for text in (named, named.replace("<up_axis>Y_UP</up_axis>", "")):
        (tmp_path / "two.dae").write_text(text)
        read.append([corners(outline) for outline, _ in read_mesh(tmp_path / "two.dae", up="file")])
    assert read[0] == read[1]


def solids_at_random(rng):
    """Random boxes, pipes and pyramids, as a mesh and as tests of points at a height."""
    meshes, tests = [], []
    for _ in range(6):
        x, y, turn = *rng.uniform(-4, 4, 2), rng.uniform(0, 3)
        a, b, h = rng.uniform(0.5, 3, 3)
        kind = rng.integers(4)
        place = translation_matrix((x, y, 0)) @ rotation_matrix(turn, (0, 0, 1))
        cos, sin = np.cos(turn), np.sin(turn)

        def local(p, x=x, y=y, cos=cos, sin=sin):
            return np.abs(
                np.stack(
                    [
                        cos * (p[:, 0] - x) + sin * (p[:, 1] - y),
                        cos * (p[:, 1] - y) - sin * (p[:, 0] - x),
                    ],
                    axis=1,
                )
            )

        if kind < 2:
            meshes.append(trimesh.creation.box((a, b, h), transform=place))
            tests.append(
                lambda p, z, half=(a / 2, b / 2), h=h, local=local: (
                    (local(p) < half).all(axis=1) & (abs(z) < h / 2)
                )
            )
        elif kind == 2:
            meshes.append(
                trimesh.creation.annulus(a / 2, a, h, sections=4, transform=place)
            )  # square rings, corners on the axes
            tests.append(
                lambda p, z, a=a, h=h, local=local: (
                    (local(p).sum(axis=1) < a) & (local(p).sum(axis=1) > a / 2) & (abs(z) < h / 2)
                )
            )
        else:
            pyramid = trimesh.convex.convex_hull(
                [(a, a, 0), (-a, a, 0), (a, -a, 0), (-a, -a, 0), (0, 0, h)]
            )
            meshes.append(pyramid.apply_transform(place))
            tests.append(
                lambda p, z, a=a, h=h, local=local: (
                    (local(p).max(axis=1) < a * (1 - max(z, 0) / h)) & (0 <= z < h)
                )
            )
    return trimesh.util.concatenate(meshes), tests


@pytest.mark.parametrize("seed", range(8))
def test_slices_and_shadows_hold_the_points_of_the_solids(tmp_path, seed):
    """For overlapping bodies with holes; a projection is the union of all slices."""
    rng = np.random.default_rng(seed)
    mesh, tests = solids_at_random(rng)
    file = saved(mesh, tmp_path, ("stl", "obj", "glb")[seed % 3])
    points = rng.uniform(-7, 7, (3000, 2))
    for height in (None, 0.1, float(rng.uniform(0.0, 0.3))):
        heights = np.linspace(-2, 3, 300) if height is None else [height]
        inside = np.any([test(points, z) for z in heights for test in tests], axis=0)
        shape = shapely.union_all(
            [shapely.Polygon(*solid) for solid in read_mesh(file, slice_at=height)]
        )
        near = shapely.distance(shape.boundary, shapely.points(points)) < (
            0.05 if height is None else 1e-4
        )
        assert np.array_equal(shapely.contains_xy(shape, points)[~near], inside[~near])
        assert 0.02 < inside.mean() < 0.98


def test_holes_are_rooms_and_a_robot_fits_inside(tmp_path):
    """The projection of a pipe is a ring; a body in its hole is an obstacle in a room."""
    pipe = trimesh.creation.annulus(3, 4, 1, sections=32)
    post = trimesh.creation.cylinder(1, 1, sections=16)
    file = saved(trimesh.util.concatenate([pipe, post]), tmp_path, "stl")
    for options in ({}, {"slice_at": 0.25}):
        solids = read_mesh(file, **options)
        assert [(len(outline), [len(room) for room in rooms]) for outline, rooms in solids] == [
            (32, [32]),
            (16, []),
        ]
        world = mesh_world(file, margin=1.0, **options)
        assert ke.Problem(ke.Disk(0.9), world, (2, 0), (-2, 0)).is_free(np.array([0.0, 2.0]))
        assert ke.rrt(ke.Problem(ke.Disk(0.5), world, (2, 0), (-2, 0)), rng=0).path is not None
        assert (
            ke.rrt(ke.Problem(ke.Point(), world, (2, 0), (4.5, 0)), max_nodes=300, rng=0).path
            is None
        )
    with pytest.raises(InvalidRobot, match="got 2"):
        mesh_outline(file)
    outline = mesh_outline(saved(pipe, tmp_path, "obj"), reference=(1, 2))
    assert shapely.Polygon(outline).area == pytest.approx(
        shapely.Polygon(solids[0][0]).area, rel=1e-6
    )
    assert outline.mean(axis=0) == pytest.approx((-1, -2), abs=1e-6)


def test_a_cavity_is_free_in_a_slice_and_covered_from_above(tmp_path):
    """In a hollow box, whose inner surface faces inwards."""
    inner = trimesh.creation.box((2, 2, 2))
    inner.invert()
    file = saved(
        trimesh.util.concatenate([trimesh.creation.box((4, 4, 4)), inner]), tmp_path, "stl"
    )
    assert (
        area(read_mesh(file, slice_at=0.0)),
        area(read_mesh(file, slice_at=1.5)),
        area(read_mesh(file)),
    ) == (12, 16, 16)


def test_a_slice_through_faces_and_corners_has_what_is_just_above(tmp_path):
    """Where one box stands on another, the upper one counts; at the very top there is nothing."""
    tower = trimesh.util.concatenate(
        [
            trimesh.creation.box((4, 4, 1)),
            trimesh.creation.box((2, 2, 1), transform=translation_matrix((0, 0, 1))),
        ]
    )
    file = saved(tower, tmp_path, "glb")
    assert (
        area(read_mesh(file, slice_at=0.5)),
        area(read_mesh(file, slice_at=-0.5)),
        area(read_mesh(file)),
    ) == (4, 16, 16)
    for height in (1.5, -0.6, np.nan, (0, 1), "low"):
        with pytest.raises(KinoeduError):
            read_mesh(file, slice_at=height)


def test_thousands_of_triangles(tmp_path):
    """A ball of 20,480 triangles has one outline, as large as the circle."""
    file = saved(trimesh.creation.icosphere(5), tmp_path, "stl")
    for options in ({}, {"slice_at": 0.001}):
        solids = read_mesh(file, **options)
        assert (
            len(solids) == 1
            and solids[0][1] == []
            and area(solids) == pytest.approx(np.pi, rel=2e-3)
        )


@pytest.mark.parametrize("scale", [1e-120, 1e-5, 1e120])
def test_any_unit_will_do(tmp_path, scale):
    """Tiny and huge meshes keep their shape."""
    file = tmp_path / "tile.obj"
    points = np.array([(0, 0, 1), (2, 0, 1), (2, 1, 1), (0, 1, 1)]) * scale
    file.write_text(
        "".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in points.tolist()) + "f 1 2 3\nf 1 3 4\n"
    )
    [(outline, _)] = read_mesh(file)
    assert (np.ptp(outline, axis=0) / scale).tolist() == pytest.approx([2, 1], rel=1e-11)


@pytest.mark.parametrize("offset", [0.0, 1e6, -1e9, 2.0**40])
def test_a_mesh_far_from_the_origin_is_as_exact_as_its_floats(tmp_path, offset):
    """In its projection and in a slice."""
    box = np.add(trimesh.creation.box((2.2, 1.6, 1.0)).vertices, (1.3, 0.7, 0.0))
    corners = [(offset + x, offset / 2 + y, z) for x, y, z in box]
    faces = trimesh.creation.box().faces + 1
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in np.array(corners).tolist()]
    lines += [f"f {a} {b} {c}" for a, b, c in faces]
    file = tmp_path / "far.obj"
    file.write_text("\n".join(lines))
    x, y = np.array(corners)[:, :2].T
    digit = 1e-11 + np.spacing(abs(offset))
    for solids in (read_mesh(file), read_mesh(file, slice_at=0.1)):
        ((outline, _),) = solids
        assert outline.min(axis=0) == pytest.approx([x.min(), y.min()], rel=0, abs=digit)
        assert outline.max(axis=0) == pytest.approx([x.max(), y.max()], rel=0, abs=digit)
        assert len(outline) == 4


@pytest.mark.parametrize("kind", KINDS)
def test_meshes_cut_short_are_refused(tmp_path, kind):
    """In every format and at any byte; but an .obj between two lines has fewer triangles."""
    data = saved(trimesh.creation.box((1, 2, 4)), tmp_path, kind).read_bytes()
    file = tmp_path / f"cut.{kind}"
    for end in range(0, len(data) - 2, max(1, len(data) // 40)):
        file.write_bytes(data[:end])
        if kind == "obj" and b"\nf" in data[:end]:
            continue
        with pytest.raises(UnreadableScene, match=r"cut\."):
            read_mesh(file)


@pytest.mark.parametrize(
    ("name", "text", "options", "says"),
    [
        (
            "x.stl",
            "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
            "0\nendloop\nendfacet\n",
            {},
            "endsolid",
        ),
        ("x.stl", "solid x\nendsolid x\n", {}, "x.stl"),
        ("x.obj", "v 0 0 0\nv 1 0 0\nf 1 2\n", {}, "fewer than three"),
        ("x.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", {}, "damage"),
        ("x.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", {"up": "y"}, "no area"),
        ("x.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", {}, "no area"),
        ("x.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n", {}, "finite"),
        ("x.obj", "v 0 0 0\nv 1e200 0 0\nv 0 1 0\nf 1 2 3\n", {}, "1e150"),
        ("x.obj", "v 0 0 0\nv 1 0 1\nv 0 1 1\nf 1 2 3\n", {"slice_at": 0.5}, "not closed"),
        ("x.obj", "v 0 0 0\n", {}, "no triangles"),
        ("x.ply", "", {}, "expected .dae"),
        ("x.obj", "", {"up": "w"}, "up must be"),
    ],
)
def test_what_is_wrong_with_a_mesh_is_said(tmp_path, name, text, options, says):
    """A named error names the file."""
    (tmp_path / name).write_text(text)
    with pytest.raises(KinoeduError, match=says):
        read_mesh(tmp_path / name, **options)


def test_a_scene_may_name_meshes(tmp_path):
    """Robot and world are read from files beside the scene, and written as polygons."""
    saved(trimesh.creation.box((4, 1, 1)), tmp_path, "stl", "sofa")
    saved(trimesh.creation.box((1, 6, 3)), tmp_path, "glb", "wall")
    scene = {
        "version": 1,
        "robot": {
            "kind": "mesh",
            "file": "sofa.stl",
            "slice_at": 0.0,
            "reference": [-2, 0],
            "turn_weight": 2.0,
        },
        "world": {
            "kind": "mesh",
            "file": "wall.glb",
            "boundary": [[-9, -9], [9, -9], [9, 9], [-9, 9]],
        },
        "start": [-7, 0, 0],
        "goal": [3, 0, 0],
    }
    file = tmp_path / "scene.json"
    file.write_text(json.dumps(scene))
    problem = ke.read_scene(file)
    assert problem.robot.turn_weight == 2.0 and corners(problem.robot.outline) == {
        (0, -0.5),
        (4, -0.5),
        (4, 0.5),
        (0, 0.5),
    }
    assert ke.rrt_connect(problem, rng=0).path is not None
    ke.write_scene(problem, tmp_path / "again.json")
    assert np.array_equal(ke.read_scene(tmp_path / "again.json").world.edges, problem.world.edges)
    del scene["robot"]["reference"], scene["robot"]["turn_weight"]
    file.write_text(json.dumps({**scene, "start": [-5, 0, 0]}))
    assert corners(ke.read_scene(file).robot.outline) == {
        (-2, -0.5),
        (2, -0.5),
        (2, 0.5),
        (-2, 0.5),
    }
    for thing, key, value, says in (
        ("robot", "file", "gone.stl", "gone.stl"),
        ("world", "up", "w", "up must be"),
        ("world", "margins", 1, "margin"),
    ):
        wrong = json.loads(file.read_text())
        wrong[thing][key] = value
        (tmp_path / "wrong.json").write_text(json.dumps(wrong))
        with pytest.raises(KinoeduError, match=says):
            ke.read_scene(tmp_path / "wrong.json")


# -- Bench-MR


@pytest.mark.parametrize(
    ("name", "bad"),
    [
        ("parking1", [12]),
        ("parking2", []),
        ("warehouse", [0, 9, 10, 19, 45, 46, 82, 83]),
        ("car", []),
        ("warehouse_robot", []),
    ],
)
def test_benchmr_maps_are_read_upright_and_mended(name, bad):
    """y is flipped, the union is that of the drawing, and a warning lists the repairs."""
    file = BENCHMR / f"{name}.json"
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        world = ke.read_world(file)
    messages = " ".join(str(warning.message) for warning in caught)
    assert [i for i in range(100) if f"polygon {i} crosses" in messages] == bad
    assert all(warning.category is MendedPolygons for warning in caught) and name in messages + name
    drawn = [np.array(polygon) for polygon in json.loads(file.read_text())["polygons"]]
    bottom = max(polygon[:, 1].max() for polygon in drawn)
    upright = shapely.union_all(
        [shapely.Polygon(polygon * (1, -1) + (0, bottom)).buffer(0) for polygon in drawn]
    )
    read = shapely.union_all([shapely.Polygon(rings[0]) for rings in rings_of(world)[1:]])
    assert read.symmetric_difference(upright).area < 1e-9 * upright.area
    assert len(rings_of(world)) == len(drawn) + 1


def test_a_car_parks_in_a_benchmr_lot():
    """From lane to lane, with the car's outline among the cars of the lot."""
    with pytest.warns(MendedPolygons):
        world = ke.read_world(BENCHMR / "parking1.json")
    car = rings_of(ke.read_world(BENCHMR / "car.json"))[1][0] - (2.0, 1.2)
    free = [
        q
        for q in np.random.default_rng(0).uniform(world.lo, world.hi, (4000, 2))
        if _clear(world, car, q)
    ]
    problem = ke.Problem(ke.RigidPolygon(car), world, (*free[0], 0.0), (*free[-1], 0.0))
    assert problem.is_free(problem.start)


def _clear(world, car, q):
    """Whether the car at q, heading 0, is free, by shapely."""
    body = shapely.Polygon(car + q)
    return shapely.box(*world.lo, *world.hi).contains_properly(body) and not any(
        body.intersects(shapely.Polygon(rings[0])) for rings in rings_of(world)[1:]
    )


def drawn(tmp_path, **content):
    """Write a map to a file."""
    file = tmp_path / "map.json"
    file.write_text(json.dumps(content))
    return file


def test_start_goal_and_heading_turn_with_the_map(tmp_path):
    """They are given with y down; a planner may be given others."""
    square = [[4, 4], [6, 4], [6, 6], [4, 6]]
    frame = [[0, 0], [0, 10], [0.1, 10], [0.1, 0]], [[9.9, 0], [9.9, 10], [10, 10], [10, 0]]
    file = drawn(tmp_path, polygons=[square, *frame], start=[1, 2, 0.5], goal=[9, 8, -0.5])
    world, start, goal = read_benchmr(file)
    assert start.tolist() == [1, 8, -0.5] and goal.tolist() == [9, 2, 0.5]
    assert ke.read_problem(
        file, robot=ke.RigidPolygon([(0, 0), (0.2, 0), (0, 0.2)])
    ).start.tolist() == [1, 8, -0.5]
    assert ke.read_problem(file, start=(1, 1), goal=(2, 2)).goal.tolist() == [2, 2]
    with pytest.raises(InvalidParameter, match=r"its start is x, y and a heading, .* give a start"):
        ke.read_problem(file)
    wide = read_benchmr(file, boundary=[(-1, -1), (12, -1), (12, 12), (-1, 12)]).world
    assert wide.hi.tolist() == [12, 12] and world.hi.tolist() == [10, 10]


def test_bow_ties_repeats_and_twins_are_mended(tmp_path):
    """The region that a bow tie encloses is solid; a repeated corner or polygon counts once."""
    bow = [[0, 0], [4, 4], [4, 0], [0, 4]]
    twice = [[6, 0], [8, 0], [8, 0], [8, 2], [6, 0]]
    triangle = [[10, 0], [12, 0], [11, 2]]
    file = drawn(
        tmp_path,
        polygons=[bow, twice, triangle, triangle[::-1], [triangle[1], triangle[2], triangle[0]]],
    )
    with pytest.warns(
        MendedPolygons, match="polygon 0 crosses.*n 1 repeats 2.*n 3 is polygon 2.*n 4 is polygon 2"
    ):
        world = ke.read_world(file)
    rings = rings_of(world)[1:]
    assert sum(shapely.Polygon(ring).area for (ring,) in rings) == pytest.approx(8 + 2 + 2)
    points = np.array([(0.5, 1.0), (3.5, 3.0), (2.0, 1.0), (7.5, 1.0), (6.5, 1.5)])
    turned = points * (1, -1) + (0, 4)
    assert [ke.Problem(ke.Point(), world, (2, 0.5), (2, 0.5)).is_free(q) for q in turned] == [
        False,
        False,
        True,
        False,
        True,
    ]


@pytest.mark.parametrize(
    ("content", "error", "says"),
    [
        ({"polygons": []}, UnreadableScene, "at least one"),
        ({"polygons": 3}, UnreadableScene, "list"),
        ({"polygons": [[[0, 0], [1, 0]]]}, InvalidPolygon, "polygon 0"),
        ({"polygons": [[[0, 0], [1, 0], [2, 0]]]}, InvalidPolygon, "polygon 0"),
        ({"polygons": [[[0, 0], [1, 0], [0, 1, 2]]]}, KinoeduError, "polygons"),
        ({"polygons": [[]]}, KinoeduError, "polygons"),
        ({"polygons": [[[0, 0], [1, 0], [0, 1]]], "strat": [1, 2]}, UnreadableScene, "start"),
        ({"polygons": [[[0, 0], [1, 0], [0, 1]]], "start": [1]}, UnreadableScene, "start"),
        ({"version": 1}, UnknownFormat, "read_scene"),
    ],
)
def test_wrong_maps_are_refused(tmp_path, content, error, says):
    """By a named error with the number of the polygon."""
    with pytest.raises(error, match=says):
        ke.read_world(drawn(tmp_path, **content))


def test_margin_and_boundary_exclude_each_other(tmp_path):
    """Only one of them determines the boundary."""
    file = saved(trimesh.creation.box(), tmp_path, "stl")
    assert mesh_world(file).hi.tolist() == pytest.approx([0.6, 0.6])
    with pytest.raises(InvalidParameter, match="not both"):
        mesh_world(file, boundary=[(-2, -2), (2, -2), (2, 2), (-2, 2)], margin=1)


def test_a_byte_order_mark_costs_no_vertex(tmp_path):
    """Trimesh would take the first line for a comment, and number the vertices from the second."""
    text = "\ufeffv 0 0 0\nv 1 0 0\nv 1 1 0\nv 5 5 0\nf 1 2 3\n"
    (tmp_path / "m.obj").write_text(text, encoding="utf-8")
    ((outline, holes),) = read_mesh(tmp_path / "m.obj")
    assert sorted(outline.tolist()) == [[0, 0], [1, 0], [1, 1]] and holes == []
