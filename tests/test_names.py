"""Names in figures keep off paths, obstacles, arrows and each other, and lie where they belong."""

import numpy as np
import pytest
import shapely
from matplotlib import pyplot as plt

from kinoedu import Disk, Graph, Point, PolygonWorld, Problem, Terrain
from kinoedu.boards import search_board
from kinoedu.boards.core.drawing import Drawing, arrows, edges, path_edges
from kinoedu.boards.core.printed import draw_board, print_layer
from kinoedu.figures import draw_moment, draw_plan, draw_problem
from kinoedu.figures.arms import name_region
from kinoedu.figures.names import (
    move_names_off,
    move_names_off_points,
    spread,
    write_beside_names,
    write_name,
)
from kinoedu.figures.plane import inward
from kinoedu.problems import Plan
from kinoedu.problems.in_time import TimedProblem
from kinoedu.worlds import Moving, MovingWorld

ROOM = PolygonWorld([(0, 0), (20, 0), (20, 12), (0, 12)])
ACROSS = [(14, 9), (14, 3), (6, 9), (6, 3)]  # through the sides of (10, 6)
STRAIGHT = [(14, 6), (10, 3), (6, 6), (10, 9)]
PROBLEM = Problem(Point(), ROOM, start=(4, 6), goal=(16, 6))


@pytest.fixture
def ax():
    figure, ax = plt.subplots(figsize=(6.0, 4.0), dpi=72)
    yield ax
    plt.close(figure)


def sides(ax):
    """The sides of all names, by name: 1 right, 0 or -1 left, 1 above, 0 or -1 below."""
    return {text.get_text(): tuple(np.sign(text.xyann).astype(int)) for text in ax.texts}


@pytest.mark.parametrize(
    ("corner", "start", "goal"),
    [((10, 6), (1, 1), (-1, 1)), ((10, 9), (1, -1), (-1, -1)), ((10, 3), (1, 1), (-1, 1))],
)
def test_names_keep_off_the_path(ax, corner, start, goal):
    """A path that climbs from the start has its name below, any other has it above."""
    path = np.array([(4, 6), corner, (16, 6)], float)
    draw_plan(Plan(path, 12.0, problem=PROBLEM), ax)
    assert sides(ax) == {"start": start, "goal": goal}
    ax.figure.canvas.draw()
    pixels = ax.transData.transform(path)
    line = np.concatenate([np.linspace(a, b, 500) for a, b in zip(pixels, pixels[1:])])
    for text in ax.texts:
        assert not any(text.get_window_extent().contains(*pixel) for pixel in line)


@pytest.mark.parametrize(("gap", "side"), [(1.0, (-1, 1)), (8.0, (1, -1))])
def test_a_name_that_is_moved_is_nearest_to_its_own_place(ax, gap, side):
    """Below on the right another place would be nearer, if it is close; else the name is there."""
    ax.set(xlim=(0, 20), ylim=(0, 12))
    path = np.array([(12, 9), (9, 6), (9 + gap, 6)], float)
    for at, name in ((path[1], "L1"), (path[2], "H2")):
        write_name(at, name, "black", (1, 1), ax)
    move_names_off(path, ax)
    assert sides(ax)["L1"] == side


def test_names_keep_off_a_path_that_grows(ax):
    """It is drawn piece by piece; the edges of a tree are no path."""
    draw_problem(PROBLEM, ax)
    pieces = np.array([[(4, 6), (7, 9)], [(7, 9), (16, 6)]], float)
    for layer, side in ((edges(pieces, "tree"), (1, 1)), (path_edges(pieces)[-1], (1, -1))):
        move_names_off_points(print_layer(layer, ax, Drawing([])), ax)
        assert sides(ax)["start"] == side


def test_a_name_keeps_off_the_path_at_least(ax):
    """Where a line passes on each of its sides; without the path it stays where it is."""
    draw_problem(PROBLEM, ax)
    write_name((10, 6), "p", "black", (1, 1), ax)
    lines = np.concatenate([spread(np.array([(10, 6), to])) for to in (*ACROSS, *STRAIGHT)])
    move_names_off_points(lines, ax)
    assert sides(ax)["p"] == (1, 1)
    move_names_off_points(lines, ax, spread(np.array([(10, 6), ACROSS[0]])))
    assert sides(ax)["p"] == (1, -1)


@pytest.mark.parametrize("free", range(4))
def test_a_name_is_straight_beside_its_place_where_that_alone_is_free(ax, free):
    """Right, below, left or above, in the middle."""
    ax.set(xlim=(0, 20), ylim=(0, 12))
    write_name((10, 6), "p", "black", (1, 1), ax)
    lines = [*ACROSS, *(to for k, to in enumerate(STRAIGHT) if k != free)]
    points = np.concatenate([spread(np.array([(10, 6), to])) for to in lines])
    move_names_off_points(points, ax)
    assert sides(ax)["p"] == ((1, 0), (0, -1), (-1, 0), (0, 1))[free]
    ax.figure.canvas.draw()
    (text,) = ax.texts
    pixels = ax.transData.transform(points)
    assert not any(text.get_window_extent().contains(*pixel) for pixel in pixels)


def test_names_keep_off_obstacles(ax):
    """Of polygons and of a bitmap; beside a place that is walled in the name stays."""
    walls = [[(1, 4), (4, 4), (4, 6), (1, 6)], [(9, 2), (11, 2), (11, 4), (9, 4)]]
    world = PolygonWorld([(0, 0), (12, 0), (12, 8), (0, 8)], walls)
    draw_problem(Problem(Point(), world, start=(1, 3.5), goal=(11, 4.5)), ax)
    assert sides(ax) == {"start": (1, -1), "goal": (-1, 1)}
    ax.clear()
    free = np.ones((24, 36), bool)
    free[7:9, 3:12] = False
    draw_problem(Problem(Point(), Terrain(free), start=(3.5, 6.5), goal=(20.5, 12.5)), ax)
    assert sides(ax) == {"start": (1, -1), "goal": (1, 1)}
    ax.clear()
    free[:] = False
    free[5, 5] = free[6, 5] = True
    draw_problem(Problem(Point(), Terrain(free), start=(5.5, 5.5), goal=(5.5, 6.5)), ax)
    assert sides(ax)["start"] == (1, 1)


def test_names_keep_off_moving_obstacles(ax):
    """Where a ball stands on a name it is on another side; when the ball has gone it is back."""
    hall = PolygonWorld([(0, 0), (20, 0), (20, 12), (0, 12)])
    ball = Moving(1.0, [0, 10], [(5.0, 7.0), (15.0, 7.0)])
    problem = TimedProblem(Disk(0.3), MovingWorld(hall, [ball]), start=(3, 6), goal=(17, 6))
    for t, start, goal in ((0, (1, -1), (-1, 1)), (5, (1, 1), (-1, 1)), (10, (1, 1), (-1, -1))):
        ax.clear()
        draw_moment(problem, t, ax)
        assert sides(ax).items() >= {"start": start, "goal": goal}.items()


def test_names_on_boards_keep_off_arrows(ax):
    """Of all arrows of a layer at once."""
    draw_problem(PROBLEM, ax)
    write_name((10, 6), "p", "black", (1, 1), ax)
    layer = arrows([(10, 6), (10, 6)], [(4, 3), (-4, 3)], "tree")
    move_names_off_points(print_layer(layer, ax, Drawing([])), ax)
    assert sides(ax)["p"] == (1, -1)


def test_a_second_name_of_a_place_is_on_another_side(ax):
    """The first is not moved for it."""
    for write, name in ((write_name, "p"), (write_beside_names, "3.5"), (write_beside_names, "x")):
        side = ((1, 1),) if write is write_name else ()
        write((10, 6), name, "black", *side, ax)
    assert sides(ax) == {"p": (1, 1), "3.5": (1, -1), "x": (-1, 1)}


def test_the_name_of_a_start_in_a_corner_of_a_graph_is_off_its_edges():
    """Left of it, where the board has room: places are those of the picture that is stored."""
    nodes = [(0, 2), (2, 4), (2, 2.2), (2, 0), (10, 2)]
    graph = Graph(nodes=nodes, edges=[(0, 1), (0, 2), (0, 3), (3, 4)])
    made = search_board(graph, search="bfs", start=0, goal=4).canvas
    made.refresh()
    (ax,) = draw_board(made.scene, made.drawing).axes
    assert sides(ax)["start"][0] == -1


@pytest.mark.parametrize("step", [1, -1])
def test_numbers_of_vertices_are_inside(step):
    """Also where the polygon is not convex, whichever way its vertices go round."""
    ring = np.array([(0, 0), (6, 0), (6, 4), (4, 4), (4, 2), (2, 2), (2, 5), (0, 5)], float)[::step]
    beside = ring + 0.1 * inward(ring)
    assert shapely.contains_xy(shapely.Polygon(ring), *beside.T).all()


def test_the_name_of_a_region_lies_or_stands_where_it_fits(ax):
    """In a narrow stripe it stands; in a region without room it is missing."""
    stripe, tiny = np.zeros((200, 200), bool), np.zeros((200, 200), bool)
    stripe[:, 30:56] = tiny[50:54, 50:54] = True
    (lying,), (standing,) = (name_region(one, "link 1 hits", ax) for one in (~stripe, stripe))
    assert (lying.get_rotation(), standing.get_rotation()) == (0.0, 90.0)
    assert name_region(tiny, "link 1 hits", ax) == []


def test_two_names_do_not_cover_each_other(ax):
    """The second gives way, also to a mark that is written as other marks are."""
    draw_problem(PROBLEM, ax)
    write_name((4.1, 6.1), "q_new", "black", (1, 1), ax)
    move_names_off(np.zeros((1, 2)), ax)
    ax.figure.canvas.draw()
    boxes = [text.get_window_extent() for text in ax.texts]
    assert not any(a.overlaps(b) for i, a in enumerate(boxes) for b in boxes[:i])


@pytest.mark.parametrize("path", [np.empty((0, 2)), np.array([(4.0, 6)]), np.full((2, 2), 4.0)])
def test_a_path_without_length_moves_no_name(ax, path):
    draw_problem(PROBLEM, ax)
    before = sides(ax)
    move_names_off(path, ax)
    assert sides(ax) == before


def test_a_name_without_a_free_side_stays(ax):
    """Where lines lie on all sides, and where the other sides are out of the picture."""
    draw_problem(PROBLEM, ax)
    around = [(x, y) for x in np.linspace(2, 6, 9) for y in (4.8, 5.4, 6.6, 7.2)]
    before = sides(ax)
    move_names_off(np.array(around), ax)
    assert sides(ax)["start"] == before["start"]
    corner = Problem(Point(), ROOM, start=(0.1, 0.1), goal=(16, 6))
    ax.clear()
    draw_problem(corner, ax)
    move_names_off(np.array([(0.1, 0.1), (6.0, 4.0)]), ax)
    assert sides(ax)["start"] == (1, 1)
