"""Names of places in figures keep off paths and off each other."""

import numpy as np
import pytest
from matplotlib import pyplot as plt

from kinoedu import Point, PolygonWorld, Problem, Terrain
from kinoedu.figures import draw_plan, draw_problem
from kinoedu.figures.names import move_names_off, write_name
from kinoedu.problems import Plan

ROOM = PolygonWorld([(0, 0), (20, 0), (20, 12), (0, 12)])
PROBLEM = Problem(Point(), ROOM, start=(4, 6), goal=(16, 6))


@pytest.fixture
def ax():
    figure, ax = plt.subplots(figsize=(6.0, 4.0), dpi=72)
    yield ax
    plt.close(figure)


def sides(ax):
    """The sides of all names, by name: 1 right or -1 left, 1 above or -1 below."""
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
