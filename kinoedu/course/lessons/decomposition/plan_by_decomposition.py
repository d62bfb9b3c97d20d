"""The exercise on a path from cell to cell, judged motion by motion. Bullo & Smith, chapter 2."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from ....decomposition import trapezoidation
from ....geometry.checks import Array
from ....graphs import Graph, bfs, bfs_path
from ....worlds import PolygonWorld
from ...exercise import RIGHT, Axes, Case, Exercise, Restated, Verdict, format_value
from ...outcomes import Answer, Outcome
from ...shapes import Maybe, Numbers, Record, Value
from ...whole_shapes import Integers
from ...withheld import withheld
from ..geometry.lines import POINT
from ..shared.random_shapes import sizes
from ..shared.random_worlds import general_world, round_polygon
from .cells import CELLS
from .pictures import draw_cell_path, set_title

TRIANGLE = np.array([(0, 0), (4, -2), (8, 4)], float)  # with two slanted cells
HALL = np.array([(0, 0), (16, 0), (16, 10), (0, 10)], float)
# a bar from the left wall: the only way is round its right end
BAR = np.array([(0, 4), (14, 4), (14, 6), (0, 6)], float)
FENCE = np.array([(7, 0), (9, 0), (9, 10), (7, 10)], float)  # from floor to ceiling
# the way round its end is narrow
LONG_BAR = np.array([(0, 4), (15.995, 4), (15.995, 6), (0, 6)], float)
SLIT = [FENCE * [1, 0.5], FENCE * [1, 0.4999] + [0, 5.001]]
DIAMONDS = [  # with some thirty cells on the way
    np.array([(x - 0.4, 5), (x, 4.5), (x + 0.4, 5), (x, 5.5)], float) for x in range(2, 15)
]
# neither wall at x = 5 contains the other
STEP = np.array([(0, 2), (5, 0), (5, 3), (9, 5), (5, 9), (5, 4)], float)


@withheld
def through_cells(
    start: Array, goal: Array, trapezoids: Array, pairs: NDArray[np.int64]
) -> Array | None:
    """Path through the centres of cells and the middles of their walls, (k, 2), or None."""
    cells = bfs_path(
        Graph(len(trapezoids), pairs),
        int(cells_containing(start, trapezoids)[0]),
        int(cells_containing(goal, trapezoids)[0]),
    )
    if cells is None:
        return None
    path = [start]
    for i, j in zip(cells, cells[1:]):
        path += [centre(trapezoids[i]), middle(trapezoids[i], trapezoids[j])]
    return np.array([*path, *([centre(trapezoids[cells[-1]])] if len(cells) > 1 else []), goal])


def centre(cell: Array) -> Array:
    """Centre of a trapezoid: the middle of its middle vertical line."""
    return np.array([(cell[0] + cell[1]) / 2, cell[2:].mean()])


def middle(a: Array, b: Array) -> Array:
    """Middle of the wall between two trapezoids."""
    x, low, high = shared_wall(a, b)
    return np.array([x, (low + high) / 2])


def shared_wall(a: Array, b: Array) -> tuple[float, float, float]:
    """Wall between two neighbours: its x, its lower and its upper end."""
    left, right = (a, b) if a[1] == b[0] else (b, a)
    return left[1], max(left[4], right[2]), min(left[5], right[3])


def floors_and_ceilings(cells: Array, x: float) -> Array:
    """Heights of the floor and the ceiling of each cell at x, (2, n)."""
    share = (x - cells[:, 0]) / (cells[:, 1] - cells[:, 0])
    return cells[:, 2:4].T + share * (cells[:, 4:6] - cells[:, 2:4]).T


def cells_containing(q: Array, cells: Array) -> NDArray[np.int64]:
    """Cells, walls included, with q above their floor and below their ceiling."""
    low, high = floors_and_ceilings(cells, q[0])
    return np.flatnonzero(
        (cells[:, 0] <= q[0]) & (q[0] <= cells[:, 1]) & (low < q[1]) & (q[1] < high)
    )


def is_free(a: Array, b: Array, cells: Array) -> bool:
    """Whether a motion touches no obstacle.

    In each cell it must stay off floor and ceiling, and it must change cells through walls. The
    motion is split at all walls; both ends of each part must lie in one cell. A vertical motion
    needs one cell on the left that contains both ends, and one on the right; along a wall these are
    two different cells.
    """
    a, b = (a, b) if a[0] <= b[0] else (b, a)
    walls = np.unique(cells[:, :2])
    walls = walls[(a[0] < walls) & (walls < b[0])]
    stops = [
        a,
        *(np.array([x, a[1] + (x - a[0]) / (b[0] - a[0]) * (b[1] - a[1])]) for x in walls),
        b,
    ]
    for q, r in [*((q, q) for q in stops), *zip(stops, stops[1:])]:
        shared = np.intersect1d(cells_containing(q, cells), cells_containing(r, cells))
        if q[0] == r[0] and not (
            (cells[shared, 0] < q[0]).any() and (cells[shared, 1] > q[0]).any()
        ):
            return False
        if len(shared) == 0:
            return False
    return True


def put_start(path: Array, start: Array, *others: Value) -> Array:
    """Return a path with the start put before it; one that begins with the start loses it."""
    if len(path) and np.array_equal(path[0], start):
        return path[1:]
    return np.vstack([start, path])


class PlanByDecomposition(Exercise):
    """A path from start to goal through the cells, or None where there is no way."""

    name = "plan_by_decomposition"
    lesson = "03_decomposition"
    kinds = ("same", "next", "turn", "far", "none")
    given = Record(start=POINT, goal=POINT, trapezoids=CELLS, pairs=Integers(("m", 2)))
    answer = Maybe(Numbers(("k", 2)))
    source = staticmethod(through_cells)

    changes = (
        Restated("from_goal", answer=lambda path, *given: path[::-1]),
        Restated("without_start", answer=lambda path, *given: path[1:], usual_answer=put_start),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """One cell, two cells, round a tip, across a world, and into another room.

        Round a tip, start and goal lie one above the other.
        """
        for boundary, obstacles, start, goal in (
            (HALL, [], (1, 1), (15, 9)),
            (TRIANGLE, [], (2, 0.25), (6, 2.5)),
            (HALL, [BAR], (15, 2), (3, 2)),
            (STEP, [], (2, 2), (7, 6)),
            (HALL, [BAR], (3, 2), (3, 8)),
            (HALL, [FENCE], (3, 5), (13, 5)),
            (HALL, [mirror(BAR)], (13, 8), (13, 2)),
            (HALL, [LONG_BAR], (3, 2), (3, 8)),
            (HALL, SLIT, (3, 2), (13, 8)),
            (HALL, DIAMONDS, (0.5, 5), (15.5, 5)),
        ):
            cells, pairs = shuffled_cells(rng, boundary, obstacles, shuffle=False)
            yield case(np.array(start, float), np.array(goal, float), cells, pairs)
        for size in sizes(4):
            world = general_world(rng, int(rng.integers(2, 6)), size)
            cells, pairs = shuffled_cells(rng, **world)
            reached = bfs(Graph(len(cells), pairs), 0).cost
            yield case(inside(rng, cells[0]), inside(rng, cells[0]), cells, pairs)
            i, j = pairs[rng.integers(len(pairs))]
            yield case(inside(rng, cells[i]), inside(rng, cells[j]), cells, pairs)
            far = int(np.argmax(reached))
            yield case(inside(rng, cells[0]), inside(rng, cells[far]), cells, pairs)
            scale, bar = size / 16, mirror(BAR) if rng.random() < 0.5 else BAR
            tip, two = shuffled_cells(rng, scale * HALL, [scale * bar])
            order = np.argsort(tip[:, 1] - tip[:, 0])  # the short cell lies at the tip
            yield case(inside(rng, tip[order[-1]]), inside(rng, tip[order[-2]]), tip, two)
            apart, joined = shuffled_cells(rng, scale * HALL, [scale * FENCE])
            yield case(inside(rng, apart[0]), inside(rng, apart[1]), apart, joined)
            ring = round_polygon(rng, int(rng.integers(4, 7)), 0.3 * size)
            cells, pairs = shuffled_cells(rng, round_polygon(rng, 7, size), [(ring, [0.6 * ring])])
            ends = apart_cells(cells, pairs)
            yield case(inside(rng, cells[ends[0]]), inside(rng, cells[ends[1]]), cells, pairs)

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Check that None is answered exactly where there is no way; else that the path is free."""
        given, wanted = case.given, self.describe_expected(case)
        if value is None and case.kind == "none":
            return RIGHT
        if value is None:
            return Verdict(0.0, "none_in_one" if case.kind == "same" else "none", wanted)
        if case.kind == "none":
            return Verdict(0.0, "apart", wanted)
        if (
            len(value) == 0
            or not np.isfinite(value).all()
            or not np.array_equal(value[0], given["start"])
        ):
            return Verdict(0.0, "start", wanted)
        if not np.array_equal(value[-1], given["goal"]):
            return Verdict(0.0, "goal", wanted)
        for a, b in zip(value, value[1:]):
            if not is_free(a, b, given["trapezoids"]):
                along = a[0] == b[0] and a[0] in given["trapezoids"][:, :2]
                rule = "wall" if along else "cell" if case.kind == "same" else "free"
                return Verdict(0.0, rule, wanted)
        return RIGHT

    def describe_expected(self, case: Case) -> str:
        """Description by one right path."""
        path = through_cells(*case.given.values())
        return (
            self.message("wanted", path=format_value(self.as_asked(path, case)))
            if path is not None
            else "None"
        )

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the cells, a right path, and the student's path with its motion that is not free."""
        value = outcome.value if isinstance(outcome, Answer) else None
        draw_cell_path(case.given, through_cells(*case.given.values()), value, ax, is_free)
        set_title(self, case, ax)


def case(start: Array, goal: Array, cells: Array, pairs: NDArray[np.int64]) -> Case:
    """Case of a problem, with its kind."""
    i, j = int(cells_containing(start, cells)[0]), int(cells_containing(goal, cells)[0])
    way = bfs_path(Graph(len(cells), pairs), i, j)
    kind = "none"
    if way is not None:
        back = any(
            doubles_back(cells[a], cells[b], cells[c]) for a, b, c in zip(way, way[1:], way[2:])
        )
        kind = {1: "same", 2: "next"}.get(len(way), "turn" if back else "far")
    return Case(kind, {"start": start, "goal": goal, "trapezoids": cells, "pairs": pairs})


def doubles_back(a: Array, b: Array, c: Array) -> bool:
    """Whether the path from a through b to c leaves b on the side from which it came."""
    return bool((a[1] == b[0]) == (c[1] == b[0]))


def shuffled_cells(
    rng: np.random.Generator, boundary: Array, obstacles: list[Value], *, shuffle: bool = True
) -> tuple[Array, NDArray[np.int64]]:
    """Cells of a world and their neighbours, in random order."""
    done = trapezoidation(PolygonWorld(boundary, obstacles))
    order = rng.permutation(len(done.trapezoids)) if shuffle else np.arange(len(done.trapezoids))
    return done.trapezoids[order], np.sort(np.argsort(order)[done.adjacency], axis=1).reshape(-1, 2)


def inside(rng: np.random.Generator, cell: Array) -> Array:
    """Random point well inside a cell, with few digits where the cell is large enough."""
    x = cell[0] + rng.uniform(0.25, 0.75) * (cell[1] - cell[0])
    low, high = floors_and_ceilings(cell[None], x)[:, 0]
    q = np.array([x, low + rng.uniform(0.25, 0.75) * (high - low)])
    return (
        np.round(q, 3)
        if len(cells_containing(np.round(q, 3), cell[None])) and cell[1] - cell[0] > 0.1
        else q
    )


def mirror(ring: Array) -> Array:
    """Reflect a ring of the hall left to right."""
    return np.array([16, 0]) + (ring * [-1, 1])[::-1]


def apart_cells(cells: Array, pairs: NDArray[np.int64]) -> tuple[int, int]:
    """Two cells that are not connected."""
    reached = np.isfinite(bfs(Graph(len(cells), pairs), 0).cost)
    return 0, int(np.flatnonzero(~reached)[0])
