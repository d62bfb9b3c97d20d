"""Decompositions against an independent oracle in rational arithmetic, and against shapely."""

import json
import os
import subprocess
import sys
from fractions import Fraction
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
import shapely
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from matplotlib import pyplot as plt

import kinoedu as ke
from kinoedu.decomposition.free_space import edges_around, free_polygons
from kinoedu.decomposition.status import (
    ABOVE,
    HIGH,
    LOW,
    NOBODY,
    PARENT,
    insert_above,
    priority,
    remove,
)
from kinoedu.decomposition.sweep import events, new_sweep
from kinoedu.decomposition.trapezoidation import drain
from kinoedu.errors import InvalidParameter, InvalidPolygon, InvalidWorld, KinoeduError
from kinoedu.figures import draw_decomposition, draw_sweep
from kinoedu.worlds.polygon_world import edges_of, rings_of

CASES = json.loads(
    (Path(__file__).parent / "data" / "trapezoid" / "worlds.json").read_text(encoding="utf-8")
)["worlds"]
KINDS = [(kind, overlapping) for kind in ("lattice", "round") for overlapping in (False, True)]
SQUARE = [(0, 0), (8, 0), (8, 8), (0, 8)]


def box(x0, y0, x1, y1):
    """A box by two corners."""
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def diamond(x, y, r=1):
    """A square that stands on a corner."""
    return [(x - r, y), (x, y - r), (x + r, y), (x, y + r)]


# ---- the oracle ---------------------------------------------------------------------------------


def slabs(edges):
    """The cells, as rows of exact numbers, and the pairs that share a wall; O(n^2 log n).

    The edges (n, 5) must not cross. Between two consecutive x of vertices the free space is a stack
    of cells. A cell continues into the next slab, between the same two edges, unless a vertex lies
    on the wall between them.
    """
    edges = [tuple(map(Fraction, edge[:4])) for edge in edges.tolist()]
    columns = {}
    for x, y, _, _ in edges:
        columns.setdefault(x, set()).add(y)
    cells, walls, before = [], set(), {}
    for x, after in zip(sorted(columns), [*sorted(columns)[1:], None]):
        spanning = [
            e
            for e in edges
            if after is not None and min(e[0], e[2]) <= x and max(e[0], e[2]) >= after
        ]
        spanning.sort(key=lambda e: height(e, (x + after) / 2))
        pile = list(zip(spanning[::2], spanning[1::2]))
        goes_on = {
            pair
            for pair in pile
            if pair in before
            and not any(low_of(pair, x) <= y <= high_of(pair, x) for y in columns[x])
        }
        now = {pair: before[pair] for pair in goes_on}
        for pair in pile:
            if pair not in goes_on:
                now[pair] = len(cells)
                cells.append([x, None, low_of(pair, x), high_of(pair, x), None, None])
        for pair, cell in before.items():
            if pair not in goes_on:
                cells[cell][1], cells[cell][4], cells[cell][5] = (
                    x,
                    low_of(pair, x),
                    high_of(pair, x),
                )
                for other in now.keys() - goes_on:
                    if max(low_of(pair, x), low_of(other, x)) < min(
                        high_of(pair, x), high_of(other, x)
                    ):
                        walls.add((cell, now[other]))
        before = now
    order = sorted(range(len(cells)), key=lambda cell: cells[cell])
    number = {cell: i for i, cell in enumerate(order)}
    return [cells[cell] for cell in order], sorted((number[a], number[b]) for a, b in walls)


def height(edge, x):
    """The height of an edge at x."""
    return edge[1] + (x - edge[0]) * (edge[3] - edge[1]) / (edge[2] - edge[0])


def low_of(pair, x):
    """The height of the floor."""
    return height(pair[0], x)


def high_of(pair, x):
    """The height of the ceiling."""
    return height(pair[1], x)


def free_by_shapely(outer, obstacles):
    """The free space, with rooms, computed without the library."""
    solids = [
        shapely.Polygon(*o) if isinstance(o, tuple) else shapely.Polygon(o) for o in obstacles
    ]
    return shapely.Polygon(outer).difference(shapely.union_all(solids))


def assert_cuts(cut, free):
    """Assert that the cells cover the free space, to 1e-9 of its area, and do not overlap."""
    room = 1e-9 * max(free.area, 1e-300)
    assert (cut.areas > 0.0).all()
    assert abs(cut.areas.sum() - free.area) <= room
    cells = shapely.polygons(cut.outlines) if len(cut.areas) else []
    assert shapely.union_all(cells, grid_size=2.0**-40).symmetric_difference(free).area <= 1e-9
    near, far = shapely.STRtree(cells).query(cells) if len(cells) else ((), ())
    overlaps = [shapely.intersection(cells[i], cells[j]).area for i, j in zip(near, far) if i < j]
    assert max(overlaps, default=0.0) <= room


def assert_equals_slabs(cut, world):
    """Assert the same cells, to 1e-12, order and pairs as `slabs`; for worlds without overlaps."""
    cells, pairs = slabs(world.edges)
    assert len(cut.trapezoids) == len(cells)
    assert np.allclose(
        cut.trapezoids, np.array(cells, float).reshape(-1, 6), rtol=1e-12, atol=1e-12
    )
    assert cut.adjacency.tolist() == [list(pair) for pair in pairs]


def has_overlaps(world):
    """Whether the obstacles must be united."""
    return not drain(new_sweep(world.edges))


# ---- textbook cases -----------------------------------------------------------------------------


@pytest.mark.parametrize("case", CASES, ids=lambda case: case["id"])
def test_shared_cases(case):
    """Number, areas, coordinates, order and adjacency equal the exact ones, and the formula.

    The formula is for general position.
    """
    world, expected = ke.PolygonWorld(case["outer"], case["holes"]), case["expected"]
    cut = ke.trapezoidation(world)
    assert (
        len(cut.trapezoids)
        == expected["n_trapezoids"]
        == case.get("n_formula", expected["n_trapezoids"])
    )
    assert np.allclose(cut.trapezoids, expected["trapezoids"], atol=1e-8)
    assert np.allclose(np.sort(cut.areas), expected["areas"], atol=1e-8)
    assert cut.areas.sum() == pytest.approx(expected["free_area"], rel=1e-9)
    assert cut.adjacency.tolist() == expected["adjacency"]
    assert_equals_slabs(cut, world)


TOUCHING = {
    "a hole on the floor, at a corner": ([[(4, 0), (6, 4), (2, 4)]], 5, 4),
    "a hole on the floor, along an edge": ([box(3, 0, 5, 4)], 3, 2),
    "two diamonds that share a vertex": ([diamond(2, 4), diamond(4, 4)], 10, 10),
    "two diamonds, one on the other": ([diamond(4, 3), diamond(4, 5)], 8, 8),
    "two boxes flush at a vertical side": ([box(2, 2, 4, 6), box(4, 2, 6, 6)], 6, 6),
    "two boxes flush at part of a vertical side": ([box(2, 1, 4, 5), box(4, 3, 6, 7)], 6, 6),
    "a box on a box": ([box(2, 2, 4, 4), box(2, 4, 4, 6)], 4, 4),
    "a corner on a slanted edge": ([[(1, 1), (7, 1), (7, 7)], [(4, 4), (3, 7), (2, 7)]], 8, 8),
    "a wall across": ([box(3, 0, 5, 8)], 2, 0),
    "a wall across by corners alone": ([[(4, 0), (5, 4), (4, 8), (3, 4)]], 6, 4),
    "all covered": ([box(-1, -1, 9, 9)], 0, 0),
    "all covered exactly": ([box(0, 0, 8, 8)], 0, 0),
    "all outside": ([box(9, 0, 10, 8)], 1, 0),
    "one in another": ([box(1, 1, 7, 7), box(3, 3, 5, 5)], 4, 4),
    "a cross": ([box(3, 1, 5, 7), box(1, 3, 7, 5)], 8, 8),
    "the same twice": ([diamond(4, 4), diamond(4, 4)], 6, 6),
    "a room": ([(box(1, 1, 7, 7), [box(2, 2, 6, 6)])], 5, 4),
    "a room in a room": (
        [(box(1, 1, 7, 7), [box(2, 2, 6, 6)]), (box(3, 3, 5, 5), [diamond(4, 4, 0.5)])], 10, 9
    ),
    "a room that touches the outside at a corner": (
        [(box(1, 1, 7, 7), [[(1, 4), (3, 3), (3, 5)]])], 5, 4
    ),
    "a straight vertex": ([[(2, 2), (4, 2), (6, 2), (6, 5), (2, 5)]], 5, 5),
}  # fmt: skip


@pytest.mark.parametrize("name", TOUCHING)
def test_what_touches_and_what_overlaps(name):
    """The numbers of cells and pairs are those by hand; walls of length zero give no neighbours.

    Area and cover are checked by shapely.
    """
    obstacles, cells, pairs = TOUCHING[name]
    world = ke.PolygonWorld(SQUARE, obstacles)
    cut = ke.trapezoidation(world)
    assert (len(cut.trapezoids), len(cut.adjacency)) == (cells, pairs)
    assert_cuts(cut, free_by_shapely(SQUARE, obstacles))
    assert (cut.walls[:, 0, 1] < cut.walls[:, 1, 1]).all()
    if not has_overlaps(world):
        assert_equals_slabs(cut, world)


def test_only_what_overlaps_is_united():
    """Where obstacles only touch, cells keep the given coordinates, to the last bit."""
    third = 1.0 / 3.0
    world = ke.PolygonWorld(
        SQUARE, [[(1, third), (2 + third, third), (2, 1)], [(2 + third, third), (5, third), (4, 3)]]
    )
    assert not has_overlaps(world)
    assert set(ke.trapezoidation(world).trapezoids[:, 0]) <= set(world.edges[:, 0])
    for name in (
        "a box on a box",
        "one in another",
        "all outside",
        "a cross",
        "the same twice",
        "all covered exactly",
    ):
        assert has_overlaps(ke.PolygonWorld(SQUARE, TOUCHING[name][0])), name


def test_rings_that_begin_at_one_point_stay_apart():
    """Two obstacles with the same first vertex are two rings."""
    world = ke.PolygonWorld(SQUARE, [[(4, 4), (6, 4), (6, 6)], [(4, 4), (2, 4), (2, 2)]])
    assert [len(ring) for rings in rings_of(world) for ring in rings] == [4, 3, 3]
    assert_cuts(
        ke.trapezoidation(world),
        free_by_shapely(SQUARE, [[(4, 4), (6, 4), (6, 6)], [(4, 4), (2, 4), (2, 2)]]),
    )


def test_a_fan_at_one_point():
    """Fifty triangles with a common left corner, and fifty with a common right corner."""
    rng, angles = np.random.default_rng(0), np.linspace(-1.4, 1.4, 200)
    rays = np.column_stack([np.cos(angles), np.sin(angles)])
    fans = [[(4, 4), *(4 + way * rays[i : i + 2])] for way in (-1, 1) for i in range(0, 200, 4)]
    world = ke.PolygonWorld(SQUARE, [fans[i] for i in rng.permutation(len(fans))])
    assert not has_overlaps(world)
    cut = ke.trapezoidation(world)
    assert_cuts(cut, free_by_shapely(SQUARE, fans))
    assert_equals_slabs(cut, world)


@pytest.mark.parametrize("size", [1e-120, 1e-30, 1.0, 1e30, 1e120, 1e148])
@pytest.mark.parametrize("shift", [0.0, 1e6])
def test_any_unit_of_length(size, shift):
    """A world of any admissible size, also far from the origin, has the same number of cells.

    Its overlaps are united.
    """
    outer, *obstacles = (
        shift + np.array(ring, float)
        for ring in (SQUARE, [(3, 3), (6, 2), (5, 4)], [(3, 2), (6, 3), (5, 5)])
    )
    if shift * size > 1e150:
        return
    for count, cells in ((1, 5), (2, 9)):
        world = ke.PolygonWorld(outer * size, [o * size for o in obstacles[:count]])
        assert has_overlaps(world) == (count == 2)
        assert len(ke.trapezoidation(world).trapezoids) == cells
        cut = ke.triangulation(world)
        corners = np.unique(cut.triangles.reshape(-1, 2), axis=0)
        assert len(cut.triangles) == len(corners)  # by Euler, with one obstacle within
        assert ((cut.triangles >= outer.min() * size) & (cut.triangles <= outer.max() * size)).all()


def test_combs_of_ten_thousand_vertices():
    """A lying comb has a long status, a standing one as many cells as teeth; exact areas."""
    k = 4999
    teeth = np.where(np.arange(k) % 2 == 0, 1.0, 50.0) + np.random.default_rng(0).uniform(0, 1, k)
    lying = np.concatenate(
        [[(0.0, -1.0), (60.0, -1.0)], np.column_stack([teeth, np.arange(k)]), [(0.0, k + 1.0)]]
    )
    for ring in (np.repeat(lying, 2, axis=0)[::2], lying[::-1, ::-1]):
        state = new_sweep(edges_of(ring[::-1], 0))
        assert drain(state)
        cells = state.cells[: state.sizes[0]]
        area = (
            (cells[:, 1] - cells[:, 0])
            * (cells[:, 3] - cells[:, 2] + cells[:, 5] - cells[:, 4])
            / 2
        ).sum()
        assert area == pytest.approx(shapely.Polygon(ring).area, rel=1e-12)


# ---- random worlds ------------------------------------------------------------------------------


def random_polygon(rng, kind):
    """Corners on a lattice, with many contacts and collinear points; or on a circle of any size."""
    if kind == "wide":
        return rng.integers(0, 9, (3, 2))
    if kind == "lattice":
        return rng.integers(0, 7, 2) + rng.integers(0, 4, (rng.integers(3, 6), 2))
    angles = np.sort(rng.uniform(0, 2 * np.pi, rng.integers(3, 8)))
    return rng.uniform(0, 8, 2) + rng.uniform(0.1, 2) * np.column_stack(
        [np.cos(angles), np.sin(angles)]
    )


def random_world(rng, kind, overlapping):
    """A world, and the boundary and the obstacles from which it was made."""
    outer, obstacles = (
        SQUARE if rng.random() < 0.7 else rng.integers(0, 9, (rng.integers(3, 8), 2)).tolist(),
        [],
    )
    for _ in range(rng.integers(0, 9)):
        polygon = random_polygon(rng, kind)
        try:
            ke.PolygonWorld(polygon)
        except KinoeduError:
            continue
        shape = shapely.Polygon(polygon)
        if overlapping or not any(
            shape.intersection(shapely.Polygon(o)).area > 0 for o in obstacles
        ):
            obstacles.append(polygon)
    try:
        return ke.PolygonWorld(outer, obstacles), outer, obstacles
    except InvalidPolygon:
        return random_world(rng, kind, overlapping)


@pytest.mark.parametrize(("kind", "overlapping"), KINDS)
def test_a_thousand_random_worlds(kind, overlapping):
    """250 of each kind: the cells cover the free space without overlaps.

    Overlapping obstacles are detected exactly where they exist.
    """
    rng = np.random.default_rng(7)
    for _ in range(250):
        world, outer, obstacles = random_world(rng, kind, overlapping)
        assert_cuts(ke.trapezoidation(world), free_by_shapely(outer, obstacles))
        shapes = [shapely.Polygon(o) for o in obstacles]
        rims = [shapely.Polygon(outer).exterior, *(s.exterior for s in shapes)]
        clear = (
            all(shapely.Polygon(outer).covers(s) for s in shapes)
            and not any(
                a.intersection(b).area > 0 for i, a in enumerate(shapes) for b in shapes[:i]
            )
            and not any(has_slanted_overlap(a, b) for i, a in enumerate(rims) for b in rims[:i])
        )
        if kind == "lattice":  # where shapely's own rounding cannot blur the question
            assert has_overlaps(world) != clear


def has_slanted_overlap(a, b):
    """Whether two rings share a segment that is not vertical."""
    shared = shapely.intersection(a, b)
    return any(
        part.length > 0 and np.ptp(shapely.get_coordinates(part)[:, 0]) > 0
        for part in shapely.get_parts(shared)
    )


@pytest.mark.parametrize("kind", ["lattice", "round"])
def test_random_worlds_equal_slabs(kind):
    """Cells, order and neighbours equal those of rational arithmetic."""
    rng, tried = np.random.default_rng(11), 0
    while tried < 60:
        world, _, _ = random_world(rng, kind, overlapping=False)
        if not has_overlaps(world):
            assert_equals_slabs(ke.trapezoidation(world), world)
            tried += 1


@settings(max_examples=60, deadline=None, suppress_health_check=list(HealthCheck))
@given(
    st.lists(
        st.lists(
            st.tuples(st.integers(0, 8), st.integers(0, 8)), min_size=3, max_size=5, unique=True
        ),
        max_size=4,
    ),
    st.sampled_from([1.0, 0.1, 1e-3, 1e6]),
)
def test_generated_worlds(polygons, scale):
    """Any small world on a lattice; Hypothesis reduces a failure to the smallest world."""
    outer, obstacles = (np.array(SQUARE) * scale).tolist(), []
    for polygon in polygons:
        try:
            ke.PolygonWorld(polygon)
        except KinoeduError:
            continue
        obstacles.append((np.array(polygon) * scale).tolist())
    try:
        world = ke.PolygonWorld(outer, obstacles)
    except KinoeduError:  # scaled by 0.1, a straight angle may become a spike that crosses
        return
    cut, free = ke.trapezoidation(world), free_by_shapely(outer, obstacles)
    assert cut.areas.sum() == pytest.approx(free.area, rel=1e-9, abs=1e-9 * scale * scale)
    if not has_overlaps(world):
        assert_equals_slabs(ke.trapezoidation(ke.PolygonWorld(SQUARE)), ke.PolygonWorld(SQUARE))
        cells, pairs = slabs(world.edges)
        assert len(cells) == len(cut.trapezoids)
        assert cut.adjacency.tolist() == [list(pair) for pair in pairs]


# ---- the sweep and its status -------------------------------------------------------------------


@pytest.mark.parametrize("seed", range(6))
def test_steps_drained_are_the_decomposition(seed):
    """The steps close exactly its cells, each after it was opened.

    The status alternates floors and ceilings, in order.
    """
    world, _, _ = random_world(
        np.random.default_rng(seed), ("lattice", "round")[seed % 2], overlapping=seed > 3
    )
    steps, cut = list(ke.sweep(world)), ke.trapezoidation(world)
    closed = np.concatenate([np.empty((0, 6)), *(step.closed for step in steps)])
    opened = np.concatenate([np.empty((0, 3)), *(step.opened for step in steps)])
    assert sorted(closed.tolist()) == sorted(cut.trapezoids.tolist())
    assert sorted(opened.tolist()) == sorted(cut.trapezoids[:, [0, 2, 3]].tolist())
    assert [step.x for step in steps] == sorted(set(cut.edges[:, 0]) | set(cut.edges[:, 2]))
    for step, after in pairwise(steps):
        middle = (step.x + after.x) / 2
        heights = [a[1] + (middle - a[0]) * (a[3] - a[1]) / (a[2] - a[0]) for a in step.status]
        assert len(heights) % 2 == 0 and heights == sorted(heights)
        assert (step.status[:, 0] <= step.x).all() and (step.status[:, 2] >= after.x).all()
        assert (step.closed[:, 1] == step.x).all() and (step.opened[:, 0] == step.x).all()
        assert (step.vertices[:, 0] == step.x).all() and (np.diff(step.vertices[:, 1]) >= 0).all()
    assert (
        len(steps[-1].status) == 0 and len(steps[-1].opened) == 0
        if steps
        else len(cut.trapezoids) == 0
    )


def test_the_types_of_vertices():
    """The corners of a triangle have the types of sweep.py; two on one line have none."""
    kinds = [step.kind for step in ke.sweep(ke.PolygonWorld(SQUARE, [[(3, 3), (6, 2), (5, 4)]]))]
    assert kinds == ["2 vertices", "an obstacle begins", "a bend", "an obstacle ends", "2 vertices"]
    tilted = [step.kind for step in ke.sweep(ke.PolygonWorld([(0, 1), (4, 0), (8, 2), (5, 6)]))]
    assert tilted == ["a room begins", "a bend", "a bend", "a room ends"]


def test_the_interpreted_sweep_is_the_compiled_one():
    """Interpreted code, and a process without compiled code, give the same bits."""
    rng = np.random.default_rng(3)
    worlds = [
        random_world(rng, kind, kind == "lattice")[0] for kind in ("lattice", "round", "round")
    ]
    for world in worlds[1:]:
        one, other = new_sweep(world.edges), new_sweep(world.edges)
        assert drain(one) == drain.py_func(other)
        assert np.array_equal(one.sizes, other.sizes) and np.array_equal(
            one.pairs[: one.sizes[2]], other.pairs[: one.sizes[2]]
        )
        assert list(events.py_func(new_sweep(world.edges))) == list(events(new_sweep(world.edges)))
    code = "import test_decomposition as t; print(t.digest())"
    environment = {**os.environ, "NUMBA_DISABLE_JIT": "1"}
    done = subprocess.run(
        [sys.executable, "-c", code],
        env=environment,
        cwd=Path(__file__).parent,
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.strip() == digest()


def digest():
    """All numbers of a few decompositions, as text."""
    worlds = [ke.PolygonWorld(case["outer"], case["holes"]) for case in CASES] + [
        ke.PolygonWorld(SQUARE, TOUCHING["a cross"][0])
    ]
    cuts = [ke.trapezoidation(world) for world in worlds]
    return repr(
        [[cut.trapezoids.tolist(), cut.adjacency.tolist(), cut.walls.tolist()] for cut in cuts]
    )


def test_the_status_is_a_treap():
    """Insertions and removals keep its order, its heap property and a depth of O(log n)."""
    rng, nodes, order = np.random.default_rng(0), np.zeros((10_001, 6), np.int64), []
    for node in range(1, 10_001):
        at = int(rng.integers(0, len(order) + 1))
        insert_above(nodes, order[at - 1] if at else NOBODY, node)
        order.insert(at, node)
        if node % 5 == 0:
            remove(nodes, order.pop(int(rng.integers(0, len(order)))))
    walk, node = [], nodes[NOBODY, ABOVE]
    while node != NOBODY:
        walk.append(node)
        node = nodes[node, ABOVE]
    assert walk == order

    deepest, stack, inorder = 0, [(nodes[NOBODY, HIGH], 1, False)], []
    while stack:
        node, depth, passed = stack.pop()
        if node == NOBODY:
            continue
        if passed:
            inorder.append(node)
            continue
        deepest = max(deepest, depth)
        for child in (nodes[node, LOW], nodes[node, HIGH]):
            assert child == NOBODY or (
                priority(child) < priority(node) and nodes[child, PARENT] == node
            )
        stack += [
            (nodes[node, HIGH], depth + 1, False),
            (node, depth, True),
            (nodes[node, LOW], depth + 1, False),
        ]
    assert inorder == order
    assert deepest <= 4 * np.log2(len(order))
    for node in order:
        remove(nodes, node)
    assert (nodes[NOBODY] == 0).all()


def test_nodes_inserted_in_order_make_no_list():
    """Insertions from bottom to top, as in many sweeps, keep a depth of O(log n) too."""
    nodes = np.zeros((4097, 6), np.int64)
    for node in range(1, 4097):
        insert_above(nodes, node - 1, node)

    def depth(node):
        return 0 if node == NOBODY else 1 + max(depth(nodes[node, LOW]), depth(nodes[node, HIGH]))

    assert depth(nodes[NOBODY, HIGH]) <= 48


# ---- point location, roadmap, triangles ---------------------------------------------------------


def test_cells_at_a_point():
    """Inside a cell one; on a wall both; at a corner of walls all; elsewhere none."""
    cut = ke.trapezoidation(ke.PolygonWorld(SQUARE, [box(3, 3, 5, 5)]))
    assert [cut.cells_at(q).tolist() for q in ((1, 1), (4, 1), (4, 7), (7, 7))] == [
        [0],
        [1],
        [2],
        [3],
    ]
    assert cut.cells_at((3, 1)).tolist() == [0, 1]
    assert cut.cells_at((3, 3)).tolist() == [0, 1]
    assert cut.cells_at((4, 3)).tolist() == [1]
    assert cut.cells_at((4, 4)).tolist() == [] == cut.cells_at((9, 9)).tolist()
    slanted = ke.trapezoidation(ke.PolygonWorld([(0, 0), (3, 1), (0, 1)]))
    assert slanted.cells_at((0.3, np.nextafter(0.1, 0))).tolist() == (
        [0] if Fraction(np.nextafter(0.1, 0)) * 3 >= Fraction(0.3) else []
    )


@pytest.mark.parametrize(
    "cut_by", [ke.trapezoidation, ke.triangulation], ids=["trapezoids", "triangles"]
)
def test_cells_at_agrees_with_shapely(cut_by):
    """A random point lies in one cell where it is free, otherwise in none."""
    rng = np.random.default_rng(5)
    for kind in ("lattice", "round") * 4:
        world, outer, obstacles = random_world(rng, kind, overlapping=True)
        cut, free = cut_by(world), free_by_shapely(outer, obstacles)
        for q in rng.uniform(0, 8, (30, 2)):
            assert len(cut.cells_at(q)) == free.contains(shapely.Point(q))
        assert all(
            cut.cells_at(centre).tolist() == [i] for i, centre in enumerate(cut.centres[:20])
        )


def test_triangles_cut_the_same_space():
    """Triangles cover the free space, and are neighbours exactly where they share an edge."""
    rng = np.random.default_rng(9)
    for kind in ("lattice", "round") * 10:
        world, outer, obstacles = random_world(rng, kind, overlapping=True)
        cut = ke.triangulation(world)
        assert_cuts(cut, free_by_shapely(outer, obstacles))
        sides = [
            {frozenset(map(tuple, t[[i, i - 1]].tolist())) for i in range(3)} for t in cut.triangles
        ]
        shared = [
            [i, j] for i, a in enumerate(sides) for j, b in enumerate(sides) if i < j and a & b
        ]
        assert cut.adjacency.tolist() == shared
        for (i, j), wall in zip(cut.adjacency, cut.walls):
            assert frozenset(map(tuple, wall.tolist())) in sides[i] & sides[j]


@pytest.mark.parametrize(
    "cut_by", [ke.trapezoidation, ke.triangulation], ids=["trapezoids", "triangles"]
)
def test_roadmap_edges_are_free(cut_by):
    """Nodes are the centres of cells and the midpoints of walls, and every edge touches nothing."""
    rng = np.random.default_rng(2)
    for kind in ("lattice", "round") * 5:
        world, _, _ = random_world(rng, kind, overlapping=False)
        cut = cut_by(world)
        if not len(cut.areas):
            continue
        roadmap = ke.decomposition_roadmap(cut)
        assert len(roadmap.nodes) == len(cut.areas) + len(cut.adjacency) and len(
            roadmap.edges
        ) == 2 * len(cut.adjacency)
        problem = ke.Problem(ke.Point(), world, cut.centres[0], cut.centres[-1])
        assert all(
            problem.is_free_path(roadmap.nodes[i], roadmap.nodes[j]) for i, j in roadmap.edges
        )
    assert np.array_equal(
        ke.decomposition_roadmap(world).edges,
        ke.decomposition_roadmap(ke.trapezoidation(world)).edges,
    )


# ---- planning -----------------------------------------------------------------------------------


@pytest.mark.parametrize(("kind", "overlapping"), [*KINDS[1:], ("wide", False), ("wide", True)])
def test_a_plan_is_found_exactly_when_there_is_one(kind, overlapping):
    """A free path where start and goal lie in one region of the free space; otherwise a reason.

    Start and goal are also on walls and at corners of cells.
    """
    rng, found = np.random.default_rng(13), {True: 0, False: 0}
    while sum(found.values()) < 60:
        world, outer, obstacles = random_world(rng, kind, overlapping)
        pieces = [p for p in shapely.get_parts(free_by_shapely(outer, obstacles)) if p.area > 1e-6]
        try:
            problem = ke.Problem(
                ke.Point(),
                world,
                *rng.choice([0.5, 0.25, 0.125, 0.3], (2, 1)) * rng.integers(0, 33, (2, 2)),
            )
        except KinoeduError:
            continue
        start, goal = (
            [p.contains(shapely.Point(q)) for p in pieces] for q in (problem.start, problem.goal)
        )
        plan = ke.plan_by_decomposition(problem)
        assert (plan.path is not None) == (start == goal), plan.reason
        found[start == goal] += 1
        if plan.path is None:
            assert plan.reason.startswith("there is no path: the start lies in a part of")
            continue
        assert np.array_equal(plan.path[0], problem.start) and np.array_equal(
            plan.path[-1], problem.goal
        )
        assert all(problem.is_free_path(a, b) for a, b in pairwise(plan.path))
        assert plan.cost == pytest.approx(sum(np.hypot(*(b - a)) for a, b in pairwise(plan.path)))
    assert found[False] >= 5 or kind != "wide"


def test_no_path_is_told_with_the_parts():
    """For a goal in a closed room: the numbers of cells reached, and the roadmap."""
    room = (box(2, 2, 6, 6), [box(3, 3, 5, 5)])
    plan = ke.plan_by_decomposition(
        ke.Problem(ke.Point(), ke.PolygonWorld(SQUARE, [room]), (1, 1), (4, 4))
    )
    assert plan.path is None and plan.cost == np.inf
    assert (
        plan.reason == "there is no path: the start lies in a part of 4 cells that does not touch "
        "the goal's part of 1"
    )
    assert plan.stats["cells"] == 5 and len(plan.roadmap.nodes) == 5 + 4 + 2


def test_within_one_cell_the_way_is_straight():
    """Start and goal in one cell, or on its wall, are joined directly; equal ones at cost 0."""
    world = ke.PolygonWorld(SQUARE, [box(3, 3, 5, 5)])
    assert len(ke.plan_by_decomposition(ke.Problem(ke.Point(), world, (1, 1), (3, 7))).path) == 2
    assert ke.plan_by_decomposition(ke.Problem(ke.Point(), world, (1, 1), (1, 1))).cost == 0.0


def test_a_passage_at_the_end_of_precision():
    """A gap of one float between two obstacles is not a wall: a free path, or a reason."""
    gap = np.nextafter(4.0, 5)
    world = ke.PolygonWorld(SQUARE, [box(3, 0, 5, 4), box(3, gap, 5, 8)])
    assert len(ke.trapezoidation(world).trapezoids) == 3
    plan = ke.plan_by_decomposition(ke.Problem(ke.Point(), world, (1, 1), (7, 7)))
    assert plan.path is None and "narrower than floats can represent" in plan.reason


def test_a_corner_that_touches_a_rounded_edge_shuts_one_passage():
    """The crossing of the others rounds the edge, so that a wall without length is left."""
    bar, pillar, corner = (
        [(0, 4), (6, 2), (4, 6), (1, 6)],
        box(5, 1, 6, 3),
        [(3, 0), (3.5, 0), (3, 3)],
    )
    world = ke.PolygonWorld(box(0, 0, 6, 6), [pillar, bar, corner])
    plan = ke.plan_by_decomposition(ke.Problem(ke.Point(), world, (1, 1), (4, 1)))
    assert plan.path is None
    assert "at 1 of the walls between cells are shut, or narrower" in plan.reason


def test_a_wall_shorter_than_floats_can_represent_has_equal_ends():
    """Its length is positive in rational arithmetic, so its cells are neighbours."""
    triangles = np.array([[(3, 6), (5, 4), (6, 2)], [(4, 5), (7, 4), (8, 2)]]) / 10.0
    world = ke.PolygonWorld(box(0, 0, 1, 1), triangles)
    assert not has_overlaps(world)
    cut = ke.trapezoidation(world)
    (short,) = np.flatnonzero(cut.walls[:, 0, 1] == cut.walls[:, 1, 1])
    assert cut.walls[short].tolist() == [[0.4, 0.5], [0.4, 0.5]]
    cells, pairs = slabs(world.edges)
    assert cut.adjacency.tolist() == [list(pair) for pair in pairs]
    left, right = (cells[i] for i in pairs[short])
    assert 0 < min(left[5], right[3]) - max(left[4], right[2]) < 1e-16


def test_a_recorder_sees_every_motion():
    """The path is the same, and each edge of the roadmap is tested once."""
    problem = ke.Problem(ke.Point(), ke.PolygonWorld(SQUARE, [box(3, 0, 5, 5)]), (1, 1), (7, 1))
    recorder = ke.Recorder(problem)
    seen, unseen = ke.plan_by_decomposition(recorder), ke.plan_by_decomposition(problem)
    assert np.array_equal(seen.path, unseen.path) and seen.stats == unseen.stats
    assert recorder.counts()["is_free_path"] == unseen.stats["checks"] == len(unseen.roadmap.edges)


# ---- what is refused ----------------------------------------------------------------------------


@pytest.mark.parametrize(
    "ask", [ke.trapezoidation, ke.triangulation, ke.sweep, ke.decomposition_roadmap]
)
def test_worlds_that_are_no_polygons_are_refused(ask):
    """InvalidWorld with advice: round obstacles, terrains, other objects."""
    with pytest.raises(InvalidWorld, match="the world has round obstacles, 1,"):
        ask(ke.PolygonWorld(SQUARE, [((4, 4), 1)]))
    for other in (ke.Terrain([[1, 1], [1, 1]]), SQUARE, None):
        with pytest.raises(InvalidWorld, match="PolygonWorld"):
            ask(other)


@pytest.mark.parametrize(
    ("problem", "says"),
    [
        (lambda world: ke.Problem(ke.Disk(0.1), world, (1, 1), (2, 2)), "grow the obstacles"),
        (
            lambda world: ke.Problem(ke.Point(), world, (1, 1), (2, 2), clearance=0.1),
            "grow the obstacles",
        ),
        (
            lambda world: ke.Problem(ke.Point(), ke.Terrain([[1] * 4] * 4), (1, 1), (2, 2)),
            "PolygonWorld",
        ),
        (
            lambda world: ke.Recorder(ke.Problem(ke.Disk(0.1), world, (1, 1), (2, 2))),
            "grow the obstacles",
        ),
        (lambda world: object(), "Problem"),
    ],
)
def test_problems_it_cannot_plan_for_are_refused(problem, says):
    """InvalidParameter with advice."""
    with pytest.raises(InvalidParameter, match=says):
        ke.plan_by_decomposition(problem(ke.PolygonWorld(SQUARE)))


def test_free_polygons_on_a_grid():
    """After a union on a grid, edges do not cross, and the solid is on their left."""
    world = ke.PolygonWorld(SQUARE, [diamond(3.3, 4.1), diamond(4.2, 4.7)])
    edges = edges_around(free_polygons(world, 2.0**-20)[0])
    assert drain(new_sweep(edges))
    assert (edges[:, :4] % 2.0**-20 == 0).all()


# ---- figures ------------------------------------------------------------------------------------


def test_figures_show_the_cells():
    """As many outlines as requested, as many numbers as fit, and nothing else on the axes."""
    cut = ke.trapezoidation(ke.PolygonWorld(SQUARE, [box(3, 3, 5, 5)]))
    for upto, shown in ((None, 4), (2, 2), (0, 0), (99, 4)):
        artists = draw_decomposition(cut, upto=upto, neighbours=True)
        ax = artists[0].axes
        assert [text.get_text() for text in ax.texts] == [str(i) for i in range(shown)]
        assert len(ax.collections[0].get_paths()) == shown
        assert ax.get_title() == (
            f"the first {shown} of 4 trapezoids"
            if shown < 4
            else "4 trapezoids, 4 pairs of neighbours"
        )
        plt.close()
    assert not draw_decomposition(ke.triangulation(cut.world), numbers=False)[0].axes.texts
    plt.close()


def test_figures_show_the_sweep():
    """At every event: the line at its x, and the floors and ceilings that it crosses."""
    world = ke.PolygonWorld(SQUARE, [[(3, 3), (6, 2), (5, 4)]])
    steps = list(ke.sweep(world))
    for k, step in enumerate(steps, start=1):
        ax = draw_sweep(steps[:k], world)[0].axes
        assert f"x = {step.x:.4g}, {step.kind}" in ax.get_title()
        labels = [text.get_text() for text in ax.get_legend().get_texts()]
        assert labels == [f"floors: {len(step.status) // 2}", f"ceilings: {len(step.status) // 2}"]
        plt.close()
