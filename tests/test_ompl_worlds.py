"""The worlds of OMPL's tests: every query solved, and lengths held against shortest paths computed
without kinoedu.
"""

from itertools import pairwise
from math import acos, atan2, hypot, pi, sqrt
from pathlib import Path

import networkx
import numpy as np
import pytest
import shapely
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import dijkstra

import kinoedu as ke

DATA = Path(__file__).parent / "data" / "ompl_tests"
DISCS = np.loadtxt(DATA / "circle_obstacles.txt", skiprows=2)[:, 1:]
QUERIES = np.array(
    [line.split()[2:] for line in (DATA / "circle_queries.txt").read_text().splitlines()], float
).reshape(-1, 2, 2)
LO = np.minimum(QUERIES.min(axis=(0, 1)), (DISCS[:, :2] - DISCS[:, 2:]).min(axis=0)) - 1.0
HI = np.maximum(QUERIES.max(axis=(0, 1)), (DISCS[:, :2] + DISCS[:, 2:]).max(axis=0)) + 1.0
WORLD = ke.PolygonWorld(
    [LO, (HI[0], LO[1]), HI, (LO[0], HI[1])], [((x, y), r) for x, y, r in DISCS.tolist()]
)
TOUCH = 1e-9


def problem_of(query):
    """A point among the discs."""
    return ke.Problem(ke.Point(), WORLD, *query)


def entered(a, b, discs):
    """Which discs a segment enters: those whose centres are nearer to it than their radius.
    Touching is not entering.
    """
    way = b - a
    t = np.clip(((discs[:, :2] - a) @ way) / (way @ way), 0.0, 1.0)
    return np.hypot(*(a + t[:, None] * way - discs[:, :2]).T) < discs[:, 2] - TOUCH


def tangents(c, d):
    """The touching points of the common tangents of two discs, or of a point (radius 0) and a disc:
    pairs of points.
    """
    (x1, y1, r1), (x2, y2, r2) = c, d
    apart, heading = hypot(x2 - x1, y2 - y1), atan2(y2 - y1, x2 - x1)
    for side in (1, -1):
        for sign in (1, -1):
            if apart <= abs(r1 - sign * r2) or (r2 == 0.0 and sign < 0):
                continue
            angle = heading + side * acos((r1 - sign * r2) / apart)
            normal = np.array([np.cos(angle), np.sin(angle)])
            yield np.array([x1, y1]) + r1 * normal, np.array([x2, y2]) + sign * r2 * normal


class TangentGraph:
    """Shortest paths among discs: straight along common tangents, and round discs where no other
    disc covers the arc.
    """

    def __init__(self, discs):
        self.discs = discs
        self.points = [[] for _ in discs]  # angle and node number, of each disc's touching points
        self.edges, self.size = [], 0
        for i in range(len(discs)):
            for j in range(i):
                for p, q in tangents(discs[i], discs[j]):
                    self.line(p, q, i, j)

    def node(self, point, disc):
        """A new node on a disc."""
        x, y, _ = self.discs[disc]
        self.points[disc].append((atan2(point[1] - y, point[0] - x) % (2 * pi), self.size))
        self.size += 1
        return self.size - 1

    def line(self, p, q, i, j):
        """An edge along a tangent, where it enters no disc."""
        if not entered(p, q, self.discs).any():
            self.edges.append((self.node(p, i), self.node(q, j), float(np.hypot(*(q - p)))))

    def covered(self, disc):
        """The arcs of a disc that lie in others, as pairs of angles; a whole turn where one
        swallows it.
        """
        x, y, r = self.discs[disc]
        for k, (ox, oy, o) in enumerate(self.discs):
            apart = hypot(ox - x, oy - y)
            if k == disc or apart >= r + o or apart + o <= r:
                continue
            half = (
                pi
                if apart + r <= o
                else acos(np.clip((apart * apart + r * r - o * o) / (2 * apart * r), -1, 1))
            )
            middle = atan2(oy - y, ox - x)
            yield middle - half, middle + half

    def arcs(self):
        """Edges round discs between neighbouring touching points, where no other disc covers the
        way.
        """
        for disc, touching in enumerate(self.points):
            around, blocked = sorted(touching), list(self.covered(disc))
            for (a, u), (b, v) in zip(
                around, around[1:] + [(angle + 2 * pi, node) for angle, node in around[:1]]
            ):
                inside = any(self.overlap(a, b, low, high) for low, high in blocked)
                if not inside and u != v:
                    yield u, v, self.discs[disc][2] * (b - a)

    @staticmethod
    def overlap(a, b, low, high):
        """Whether an arc from a to b and one from low to high share more than an end, whole turns
        apart or not.
        """
        return any(
            min(b, high + turn) - max(a, low + turn) > TOUCH
            for turn in (-2 * pi, 0.0, 2 * pi, 4 * pi)
        )

    def shortest(self, start, goal):
        """The length of the shortest path that may touch discs."""
        if not entered(start, goal, self.discs).any():
            return float(np.hypot(*(goal - start)))
        points, edges, size = [list(p) for p in self.points], list(self.edges), self.size
        ends = []
        for place in (start, goal):
            ends.append(self.size)
            self.size += 1
            for disc in range(len(self.discs)):
                for p, q in tangents(self.discs[disc], (*place, 0.0)):
                    if not entered(p, q, self.discs).any():
                        self.edges.append((self.node(p, disc), ends[-1], float(np.hypot(*(q - p)))))
        u, v, length = zip(*self.edges, *self.arcs())
        graph = coo_matrix((length, (u, v)), shape=(self.size, self.size)).tocsr()
        cost = dijkstra(graph, directed=False, indices=ends[0])[ends[1]]
        self.points, self.edges, self.size = points, edges, size
        return float(cost)


@pytest.fixture(scope="module")
def optima():
    """The shortest length of each query."""
    graph = TangentGraph(DISCS)
    return [graph.shortest(start, goal) for start, goal in QUERIES]


def assert_free(path):
    """No segment touches a disc, by plain formulas; all of it is within the walls."""
    assert not any(entered(a, b, DISCS).any() for a, b in pairwise(path) if (a != b).any())
    assert shapely.box(*LO, *HI).contains_properly(shapely.LineString(path))


def test_the_tangent_graph_knows_simple_answers():
    """Round one disc: two tangents and an arc; between two that overlap there is no way."""
    one = TangentGraph(np.array([(0.0, 0.0, 1.0)]))
    start, goal = np.array([-2.0, 0.0]), np.array([2.0, 0.0])
    assert one.shortest(start, goal) == pytest.approx(2 * sqrt(3) + pi - 2 * acos(0.5))
    two = TangentGraph(np.array([(0.0, 0.0, 1.0), (0.0, 1.5, 1.0)]))
    assert two.shortest(start, goal) == pytest.approx(
        2 * sqrt(3) + pi - 2 * acos(0.5)
    )  # below both
    up = np.array([0.0, 0.75])
    assert two.shortest(start + up, goal + up) > 2 * sqrt(
        2.0**2 + 1.0**2
    )  # past the far side of the nearer disc


@pytest.mark.parametrize("planner", ["rrt_connect", "rrt_star", "prm"])
def test_all_queries_among_70_discs(planner, optima):
    """Every query that has an answer is solved; no path is shorter than the shortest; on the whole
    they are close to it.
    """
    options = {"rrt_connect": {}, "rrt_star": {"max_nodes": 3000}, "prm": {"n": 1500}}[planner]
    assert len(QUERIES) == 100 and np.isfinite(optima).all()
    ratios = []
    for number, (query, optimum) in enumerate(zip(QUERIES, optima)):
        plan = getattr(ke, planner)(problem_of(query), rng=number, **options)
        assert plan.path is not None, (number, plan.reason)
        assert_free(plan.path)
        assert plan.cost >= optimum * (1 - 1e-9), number
        ratios.append(plan.cost / optimum)
    assert np.median(ratios) < {"rrt_connect": 1.6, "rrt_star": 1.06, "prm": 1.12}[planner]


def test_shortcuts_come_close_to_the_shortest(optima):
    """Never shorter than the tangent graph's paths, nor longer than the tree's; mostly near, unless
    the tree went another way.
    """
    ratios = []
    for number, (query, optimum) in enumerate(zip(QUERIES[:40], optima)):
        grown = ke.rrt_connect(problem_of(query), rng=number)
        plan = ke.shortcut(grown, tries=400, rng=number)
        assert_free(plan.path)
        assert grown.cost >= plan.cost >= optimum * (1 - 1e-9)
        ratios.append(plan.cost / optimum)
    assert np.median(ratios) < 1.25


def test_the_grid_of_15_by_15():
    """A* costs what networkx's Dijkstra does, with eight moves past free cells; and from every free
    cell to the end.
    """
    blocked = np.loadtxt(DATA / "env1.txt", skiprows=4, dtype=int) == 1
    free = ~blocked[::-1]
    moves = networkx.Graph()
    for j, i in np.argwhere(free).tolist():
        for dj, di in ((0, 1), (1, 0), (1, 1), (1, -1)):
            row, column = j + dj, i + di
            if (
                0 <= row < 15
                and 0 <= column < 15
                and free[row, column]
                and free[j, column]
                and free[row, i]
            ):
                moves.add_edge((j, i), (row, column), weight=hypot(dj, di))
    end = (14, 14) if free[14, 14] else (0, 14)
    costs = networkx.single_source_dijkstra_path_length(moves, end)
    terrain = ke.Terrain(free)
    for j, i in np.argwhere(free).tolist():
        plan = ke.plan_on_grid(
            ke.Problem(ke.Point(), terrain, (i + 0.5, j + 0.5), (end[1] + 0.5, end[0] + 0.5))
        )
        assert plan.cost == pytest.approx(costs.get((j, i), np.inf), rel=1e-12)
    assert len(costs) == free.sum()
