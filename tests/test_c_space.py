"""C-space obstacles, against collision tests in the workspace and volumes of integral geometry."""

from itertools import product

import numpy as np
import pytest
import shapely

from kinoedu import Disk, Point, PolygonWorld, Terrain
from kinoedu.c_space import (
    Rounded,
    c_space_world,
    free_regions,
    grown_obstacles,
    shrunk_workspace,
    slide,
    translating_obstacles,
    turned,
    turning_obstacle,
    turning_volume,
)
from kinoedu.c_space.turning import slices_of
from kinoedu.collision import is_free, is_free_path
from kinoedu.errors import InvalidParameter, InvalidPolygon, InvalidWorld
from kinoedu.geometry import (
    convex_hull,
    convex_polygons_intersect,
    minkowski_difference,
    minkowski_sum,
)

L_SHAPE = [(0, 0), (3, 0), (3, 1), (1, 1), (1, 3), (0, 3)]
BOX = [(0, 0), (20, 0), (20, 14), (0, 14)]
HOOK = [(4, 3), (9, 3), (9, 10), (6, 10), (6, 9), (8, 9), (8, 4), (4, 4)]
NOTCHED = [(0, 0), (20, 0), (20, 14), (12, 14), (12, 9), (10, 9), (10, 14), (0, 14)]
TRIANGLE = [(-1, -1), (2, 0), (0, 1)]


def free_by_shapely(robot, boundary, obstacles, q):
    """Whether a robot at q is inside the boundary and touches nothing, in the workspace."""
    body = shapely.Polygon(np.asarray(robot) + q)
    return shapely.contains_properly(shapely.Polygon(boundary), body) and not any(
        body.intersects(shapely.Polygon(o)) for o in obstacles
    )


@pytest.mark.parametrize(
    "boundary",
    [BOX, NOTCHED, [(1, 0), (20, 3), (17, 14), (8, 13), (0, 8)]],
    ids=["box", "notched", "slanted"],
)
@pytest.mark.parametrize(
    "robot",
    [TRIANGLE, L_SHAPE, [(0, 0), (0.5, 0.1), (0.2, 0.7)]],
    ids=["triangle", "corner", "small"],
)
def test_a_point_is_as_free_as_the_robot_was(boundary, robot):
    """A point in c_space_world is free exactly where the robot is free in the world.

    At thousands of random positions, by shapely.
    """
    obstacles = [HOOK, [(14, 2), (17, 4), (15, 7)], [(15, 6), (18, 6), (18, 8), (15, 8)]]
    free = c_space_world(robot, PolygonWorld(boundary, obstacles))
    point, counts = Point(), [0, 0]
    for q in np.random.default_rng(0).uniform((-1, -1), (21, 15), size=(1500, 2)):
        answer = is_free(point, free, q, 0.0)
        assert answer == free_by_shapely(robot, boundary, obstacles, q)
        counts[int(answer)] += 1
    assert min(counts) > 100


def test_contact_is_contact():
    """On a lattice, where nothing is rounded, every position in contact is not free."""
    world_obstacles = [[(4, 4), (8, 4), (8, 7), (4, 7)], [(10, 2), (13, 2), (10, 6)]]
    for robot in ([(0, 0), (2, 0), (2, 1), (0, 1)], L_SHAPE, [(-1, 0), (1, -1), (1, 1)]):
        free = c_space_world(robot, PolygonWorld(BOX, world_obstacles))
        for q in product(range(-3, 23), range(-3, 17)):
            here = np.array(q, float)
            assert is_free(Point(), free, here, 0.0) == free_by_shapely(
                robot, BOX, world_obstacles, here
            )


def test_whole_motions_are_as_free():
    """A motion of the point is free exactly where the hull of the robot at both ends is."""
    obstacles, robot = [HOOK, [(14, 2), (17, 4), (15, 7)]], TRIANGLE
    free = c_space_world(robot, PolygonWorld(BOX, obstacles))
    rng = np.random.default_rng(1)
    for _ in range(400):
        a = rng.uniform((0, 0), (20, 14))
        b = a + rng.normal(size=2) * 2.0
        swept = convex_hull(np.concatenate([np.array(robot) + a, np.array(robot) + b]))
        assert is_free_path(Point(), free, a, b, 0.0) == free_by_shapely(
            swept, BOX, obstacles, (0, 0)
        )


def test_a_robot_that_fits_nowhere_is_refused():
    """So are round obstacles, terrains and invalid polygons."""
    with pytest.raises(InvalidWorld, match="fits nowhere"):
        c_space_world(2 * np.array(BOX), PolygonWorld(BOX))
    with pytest.raises(InvalidWorld, match="fits nowhere"):  # it touches both sides
        c_space_world([(0, 0), (20, 0), (20, 1)], PolygonWorld(BOX))
    with pytest.raises(InvalidWorld, match="the world has round obstacles, 1,"):
        c_space_world(TRIANGLE, PolygonWorld(BOX, [((5, 5), 1)]))
    with pytest.raises(InvalidWorld, match="TerrainRecord"):
        c_space_world(TRIANGLE, Terrain(np.ones((3, 3))))
    with pytest.raises(InvalidPolygon, match="robot"):
        c_space_world([(0, 0), (1, 1)], PolygonWorld(BOX))
    with pytest.raises(InvalidPolygon, match="obstacle 1"):
        translating_obstacles(TRIANGLE, [HOOK, [(0, 0), (1, 1)]])


def test_parts_of_shapes_that_are_not_convex_make_up_the_whole():
    """The union of convex differences is the union of mirrored robots over the obstacle."""
    parts = translating_obstacles(L_SHAPE, [HOOK])
    whole = shapely.union_all(
        shapely.polygons(parts)
        if len({len(p) for p in parts}) == 1
        else [shapely.Polygon(p) for p in parts]
    )
    for q in np.random.default_rng(2).uniform((-1, -1), (12, 12), size=(800, 2)):
        assert whole.intersects(shapely.Point(q)) == shapely.Polygon(
            np.array(L_SHAPE) + q
        ).intersects(shapely.Polygon(HOOK))
    assert translating_obstacles(L_SHAPE, []) == []


# ---- sliding ------------------------------------------------------------------------------------


def random_polygon(rng, size=1.0):
    """A convex polygon with integer or with arbitrary coordinates."""
    while True:
        points = rng.integers(-5, 5, (7, 2)) if rng.random() < 0.5 else rng.normal(size=(7, 2))
        hull = convex_hull(size * points)
        if len(hull) > 2:
            return hull


def test_a_sliding_robot_always_touches_and_never_enters():
    """All along its way, which is the boundary of the difference, once round."""
    rng = np.random.default_rng(3)
    for _ in range(60):
        robot, obstacle = random_polygon(rng), random_polygon(rng) + rng.normal(size=2)
        way = slide(robot, obstacle)
        assert np.allclose(
            convex_hull(way.corners), minkowski_difference(obstacle, robot), atol=1e-13
        )
        for share in np.linspace(0.0, 1.0, 23):
            q, _ = way.at(share)
            body, solid = shapely.Polygon(robot + q), shapely.Polygon(obstacle)
            assert body.distance(solid) < 1e-12
            assert body.intersection(solid).area < 1e-11


def test_stretches_name_what_touches_what():
    """In the middle of each stretch the given vertex lies on the given edge; EE if parallel."""
    rng = np.random.default_rng(4)
    kinds = set()
    for _ in range(60):
        way = slide(random_polygon(rng), random_polygon(rng))
        middles = (way.corners + np.roll(way.corners, -1, axis=0)) / 2.0
        for q, kind, r, o in zip(middles, way.kind, way.robot_part, way.obstacle_part):
            robot_edge = shapely.LineString(q + way.robot[[r, (r + 1) % len(way.robot)]])
            obstacle_edge = shapely.LineString(way.obstacle[[o, (o + 1) % len(way.obstacle)]])
            robot_vertex, obstacle_vertex = (
                shapely.Point(q + way.robot[r]),
                shapely.Point(way.obstacle[o]),
            )
            pair = {
                "EV": (robot_edge, obstacle_vertex),
                "VE": (robot_vertex, obstacle_edge),
                "EE": (robot_edge, obstacle_edge),
            }
            assert shapely.distance(*pair[kind]) < 1e-12
            u, v = np.diff(robot_edge.coords, axis=0)[0], np.diff(obstacle_edge.coords, axis=0)[0]
            opposed = abs(u[0] * v[1] - u[1] * v[0]) < 1e-12 and u @ v < 0.0  # face to face
            assert (kind == "EE") == opposed
            kinds.add(str(kind))
    assert kinds == {"EV", "VE", "EE"}


def test_a_way_begins_and_ends_at_one_place():
    """Fractions from 0 to 1 are proportional to length; others are refused.

    A point slides round a segment, but not round a point.
    """
    way = slide([(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 0), (3, 0), (3, 2), (0, 2)])
    assert np.allclose(way.at(0.0)[0], way.at(1.0)[0]) and way.kind.tolist() == ["EE"] * 4
    assert way.at(0.5)[0].tolist() == [3.0, 2.0]
    assert slide((0, 0), [(0, 0), (1, 0)]).kind.tolist() == ["VE", "VE"]
    for wrong in (-0.1, 1.1, np.nan, [0.5]):
        with pytest.raises(ValueError, match="fraction"):
            way.at(wrong)
    with pytest.raises(InvalidParameter, match="second vertex"):
        slide((0, 0), (1, 1))


def test_the_star_algorithm_of_the_book():
    """LaValle's example 4.14: a triangle round a rectangle gives seven edges."""
    way = slide([(-1, -1), (1, 0), (0, 1)], [(0, 0), (4, 0), (4, 2), (0, 2)])
    assert len(way.corners) == 7 and sorted(way.kind.tolist()) == ["EV"] * 3 + ["VE"] * 4
    assert convex_polygons_intersect(minkowski_sum(way.robot, way.corners[0]), way.obstacle)
    assert np.allclose(turned(TRIANGLE, np.pi / 2), [(1, -1), (0, 2), (-1, 0)])


# ---- turning ------------------------------------------------------------------------------------


def assert_closed(mesh):
    """Assert a closed surface without folds, oriented outward, homeomorphic to a sphere."""
    assert mesh.is_watertight and mesh.is_winding_consistent and mesh.volume > 0.0
    assert mesh.euler_number == 2
    assert mesh.area_faces.min() > 0.0


def test_the_solid_is_closed_and_has_the_volume_of_integral_geometry():
    """For any two convex polygons; the error decreases with the square of the step."""
    rng = np.random.default_rng(5)
    for _ in range(8):
        robot, obstacle = random_polygon(rng, 0.6), random_polygon(rng) + 3.0
        truth = turning_volume(robot, obstacle)
        errors = []
        for n in (36, 144):
            mesh = turning_obstacle(robot, obstacle, n_angles=n)
            assert_closed(mesh)
            assert np.ptp(mesh.vertices[:, 2]) == 2 * np.pi
            errors.append(abs(mesh.volume / truth - 1.0))
        assert errors[0] < 0.02 and errors[1] < errors[0] / 4.0 + 1e-6


@pytest.mark.parametrize("theta", [-3.1, -np.pi / 2 + 0.01, -0.3, 0.2, 0.7, 1.5, 3.0])
def test_a_section_is_the_slice(theta):
    """The section of the mesh is the difference at that angle, within the stated error."""
    robot, obstacle = (
        np.array([(-1.0, -0.5), (2.0, -0.5), (2.0, 0.5), (-1.0, 0.5)]),
        np.array([(3, 3), (6, 4), (5, 6), (3, 5)]),
    )
    mesh = turning_obstacle(robot, obstacle, n_angles=90)
    section = mesh.section((0, 0, 1), (0, 0, theta))
    slice_ = shapely.Polygon(minkowski_difference(obstacle, turned(robot, theta)))
    cut = shapely.Polygon(convex_hull(section.vertices[:, :2]))
    step = 2 * np.pi / 90
    promised = np.hypot(2.0, 0.5) * step**2 / 8.0 + 3.0 * step / 16.0
    assert slice_.hausdorff_distance(cut) <= promised
    fine = turning_obstacle(robot, obstacle, n_angles=900).section((0, 0, 1), (0, 0, theta))
    assert (
        slice_.hausdorff_distance(shapely.Polygon(convex_hull(fine.vertices[:, :2])))
        <= promised / 10.0
    )


def test_corners_of_the_mesh_are_corners_of_slices():
    """Each vertex lies on the boundary of the difference at its angle, also for parallel edges."""
    for robot, obstacle in (
        (BOX, BOX),
        (TRIANGLE, TRIANGLE),
        (TRIANGLE, -np.array(TRIANGLE)),
        (TRIANGLE, BOX),
    ):
        mesh = turning_obstacle(robot, obstacle, n_angles=12)
        assert_closed(mesh)
        thetas = {
            slice_.theta
            for slice_ in slices_of(convex_hull(robot), convex_hull(obstacle), np.pi / 6)
        }
        assert max(np.diff(sorted(thetas))) <= np.pi / 6 + 1e-12
        for x, y, theta in (
            v for v in mesh.vertices if v[2] in thetas
        ):  # the others are middles of what is swept
            slice_ = shapely.Polygon(minkowski_difference(obstacle, turned(robot, theta)))
            assert slice_.exterior.distance(shapely.Point(x, y)) < 1e-12


def test_shapes_that_are_not_convex_are_solids_of_their_parts():
    """All are closed; a configuration is in one of them where the robot touches the obstacle."""
    mesh = turning_obstacle(L_SHAPE, HOOK, n_angles=180)
    bodies = mesh.split(only_watertight=False)
    assert mesh.is_watertight and len(bodies) > 1 and all(body.is_watertight for body in bodies)
    rng = np.random.default_rng(6)
    for theta in rng.uniform(-np.pi, np.pi, 12):
        cuts = [body.section((0, 0, 1), (0, 0, theta)) for body in bodies]
        cut = shapely.union_all([shapely.Polygon(convex_hull(c.vertices[:, :2])) for c in cuts])
        robot = turned(L_SHAPE, theta)
        for q in rng.uniform((0, 0), (12, 12), size=(60, 2)):
            if cut.exterior.distance(shapely.Point(q)) > 0.01:
                assert cut.intersects(shapely.Point(q)) == shapely.Polygon(robot + q).intersects(
                    shapely.Polygon(HOOK)
                )


@pytest.mark.parametrize("ending", ["stl", "glb", "ply"])
def test_a_solid_goes_to_a_file_and_back(tmp_path, ending):
    """It is still closed, with the same volume to the precision of the format."""
    import trimesh

    mesh = turning_obstacle(TRIANGLE, [(3, 3), (6, 3), (6, 5), (3, 5)])
    mesh.export(tmp_path / f"solid.{ending}")
    back = trimesh.load_mesh(tmp_path / f"solid.{ending}")
    back.merge_vertices()
    assert back.is_watertight and back.volume == pytest.approx(mesh.volume, rel=1e-5)


def test_wrong_numbers_of_angles_are_refused():
    """An integer of at least three is required; shapes without area are refused too."""
    for wrong in (2, 0, -5, 10.0, True, "many"):
        with pytest.raises(InvalidParameter, match="n_angles"):
            turning_obstacle(TRIANGLE, BOX, n_angles=wrong)
    with pytest.raises(InvalidPolygon, match="obstacle"):
        turning_obstacle(TRIANGLE, [(0, 0), (1, 1)])
    with pytest.raises(InvalidPolygon, match="robot must be convex"):
        turning_volume(L_SHAPE, BOX)


# ---- discs --------------------------------------------------------------------------------------


def test_a_grown_polygon_is_measured_in_closed_form():
    """Area A + p r + pi r^2 (Steiner), perimeter p + 2 pi r; also for a segment and a point.

    The polyline encloses the shape.
    """
    square = Rounded(np.array([(0.0, 0), (2, 0), (2, 2), (0, 2)]), 0.5)
    assert square.area == 4 + 8 * 0.5 + np.pi * 0.25 and square.perimeter == 8 + np.pi
    assert Rounded(np.array([(0.0, 0), (3, 0)]), 1.0).area == 6 + np.pi
    assert Rounded(np.array([(1.0, 2)]), 2.0).area == 4 * np.pi
    rng = np.random.default_rng(7)
    for _ in range(40):
        shape = Rounded(
            convex_hull(rng.normal(size=(rng.integers(1, 8), 2))), rng.uniform(0.1, 2.0)
        )
        for tolerance in (0.1, 0.01, 1e-4):
            line = shapely.Polygon(shape.polyline(tolerance))
            core = shapely.MultiPoint(shape.corners).convex_hull
            assert (
                line.is_valid
                and 0.0 <= line.area - shape.area <= 1.01 * shape.perimeter * tolerance
            )
            far = shapely.distance(core, shapely.points(shapely.get_coordinates(line)))
            assert far.min() >= shape.radius * (
                1 - 1e-12
            ) and far.max() <= shape.radius + tolerance * (1 + 1e-9)
        assert shape.arcs[:, 3].sum() == pytest.approx(2 * np.pi)
        ends = shape.corners + shape.radius * np.column_stack(
            [np.cos(shape.arcs[:, 2]), np.sin(shape.arcs[:, 2])]
        )
        assert np.allclose(shape.segments[:, 1], np.roll(ends, -1, axis=0))


def test_a_corner_that_is_nearly_straight_is_no_full_turn():
    """A corner may be convex by so little that the rounded directions of its edges turn back."""
    rng, found = np.random.default_rng(0), 0
    while found < 3:
        a, c = rng.uniform(1.0, 9.0, (2, 2))
        along = c - a
        middle = a + rng.uniform(0.1, 0.9) * along
        far = (a + c) / 2 + 0.5 * np.array([-along[1], along[0]])
        hull = convex_hull([a, middle, c, far])
        sides = np.roll(hull, -1, axis=0) - hull
        turns = np.diff(np.unwrap(np.arctan2(sides[:, 1], sides[:, 0])))
        if len(hull) == 4 and (turns < 0.0).any():
            found += 1
            assert Rounded(hull, 1.0).arcs[:, 3].sum() == pytest.approx(2 * np.pi)
            assert shapely.is_valid(shapely.Polygon(Rounded(hull, 1.0).polyline(1e-4)))


def test_a_disk_is_free_where_its_centre_is_in_a_free_region():
    """By collision tests at thousands of positions, except within the tolerance of the outline."""
    world = PolygonWorld(NOTCHED, [HOOK, [(14, 2), (17, 4), (15, 7)], ((3, 11), 1.5)])
    for radius in (0.3, 0.8, 1.2):
        regions = [
            shapely.Polygon(ring, rooms)
            for ring, *rooms in free_regions(radius, world, tolerance=1e-3)
        ]
        free = shapely.union_all(regions)
        inside = grown_obstacles(radius, world)
        for q in np.random.default_rng(8).uniform((0, 0), (20, 14), size=(1200, 2)):
            answer = is_free(Disk(radius), world, q, 0.0)
            if free.boundary.distance(shapely.Point(q)) > 2e-3:
                assert answer == free.contains(shapely.Point(q))
            touched = any(
                shapely.MultiPoint(s.corners).convex_hull.distance(shapely.Point(q)) <= s.radius
                for s in inside
            )
            assert answer <= (not touched)
            assert not free.contains(shapely.Point(q)) or answer  # never free by rounding


def test_a_workspace_shrinks_falls_apart_and_vanishes():
    """A rectangle stays one, exactly; a dumbbell becomes two regions; a small room vanishes.

    Arcs appear at reflex vertices.
    """
    (region,) = shrunk_workspace(1.0, BOX)
    assert region.tolist() == [[1, 1], [19, 1], [19, 13], [1, 13]]
    dumbbell = [
        (0, 0),
        (5, 0),
        (5, 2),
        (8, 2),
        (8, 0),
        (13, 0),
        (13, 5),
        (8, 5),
        (8, 3),
        (5, 3),
        (5, 5),
        (0, 5),
    ]
    assert len(shrunk_workspace(0.4, dumbbell)) == 1 and len(shrunk_workspace(0.6, dumbbell)) == 2
    assert shrunk_workspace(2.5, dumbbell) == [] and shrunk_workspace(7.0, BOX) == []
    room = [
        (0, 0),
        (6, 0),
        (6, 3),
        (3, 3),
        (3, 6),
        (0, 6),
    ]  # shrunk by 1: two arms of 4 x 1, 1 x 3, and the corner round (3, 3)
    areas = [shapely.Polygon(ring).area for ring in shrunk_workspace(1.0, room, tolerance=1e-6)]
    assert areas == [pytest.approx(4 + 4 - 1 + (1 - np.pi / 4), abs=1e-5)]
    for wrong in (0.0, -1.0, np.nan, [1.0], "r"):
        with pytest.raises(ValueError, match="radius"):
            shrunk_workspace(wrong, BOX)
    with pytest.raises(ValueError, match="tolerance"):
        shrunk_workspace(1.0, BOX, tolerance=0.0)
