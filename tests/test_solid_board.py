"""The board of solids: Python's answers to a plane and a place; figures of configuration space."""

import io

import numpy as np
import pytest
from matplotlib import pyplot as plt
from PIL import Image
from trimesh import Trimesh

from kinoedu import PolygonWorld
from kinoedu.boards import solid_board, turning_board
from kinoedu.boards.geometry.solid import shape
from kinoedu.c_space import turned, turning_obstacle
from kinoedu.errors import InvalidParameter, InvalidPoint
from kinoedu.figures import (
    draw_c_obstacle,
    draw_grown,
    draw_mesh,
    draw_turning_obstacle,
    torus_mesh,
)
from kinoedu.figures.solid import cut_mesh
from kinoedu.geometry import convex_hull, minkowski_difference

ROBOT = [(-1, -0.5), (2, -0.5), (2, 0.5), (-1, 0.5)]
OBSTACLE = [(3, 3), (6, 3), (6, 5), (3, 5)]
CORNER = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]


def test_the_plane_says_whether_the_robot_touches():
    """A move of the plane or the point is answered at once, by text, shapes and cut."""
    board = turning_board(ROBOT, OBSTACLE, place=(1.5, 4))
    assert "touches" in repr(board)  # its right edge is at 3.5
    board.theta = np.pi / 2
    assert "free" in board.section["text"] and board.section["theta"] == np.pi / 2
    board.place = [4, 4]
    assert "touches" in board.section["text"] and board.section["place"] == [4, 4]
    cut = np.array(board.cut).reshape(-1, 2)
    assert np.allclose(
        convex_hull(cut), minkowski_difference(OBSTACLE, turned(ROBOT, np.pi / 2)), atol=1e-6
    )


@pytest.mark.parametrize("theta", [-np.pi, -np.pi / 2, -0.4, 0.0, 0.3, np.pi])
def test_a_cut_is_whole_at_every_height(theta):
    """Also at the ends and at critical angles, where faces lie in the plane."""
    cut = cut_mesh(turning_obstacle(ROBOT, OBSTACLE), theta)[:, :, :2].reshape(-1, 2)
    slice_ = minkowski_difference(OBSTACLE, turned(ROBOT, theta))
    for corner in slice_:
        assert np.linalg.norm(cut - corner, axis=1).min() < 0.03


def test_a_page_moves_the_plane_and_the_point_and_nothing_else():
    """Angles beyond the solid are clamped; invalid places are ignored."""
    board = turning_board(ROBOT, OBSTACLE, place=(1, 1))
    board.set_state({"theta": 99.0, "place": [2, 3], "words": {}, "section": {}})
    assert board.theta == np.pi and board.place == [2, 3] and board.words and board.section["text"]
    for wrong in (
        {"theta": float("nan")},
        {"place": ["x", 1]},
        {"place": [1, 2, 3]},
        {"theta": "up"},
    ):
        board.set_state(wrong)
    assert board.theta == np.pi and board.place == [2, 3]


def test_each_question_of_a_page_is_answered_once(caplog):
    """Also where plane and point have both moved, or the section fails or is interrupted."""
    asked = []

    def section(theta, place):
        asked.append(theta)
        if theta == 1.0:
            raise ZeroDivisionError("no section here")
        if theta == 1.2:
            raise KeyboardInterrupt
        return {"text": f"{theta:g} {place[0]:g}", "shapes": []}

    board = solid_board(turning_obstacle(ROBOT, OBSTACLE), section=section, place=(1, 1))
    board.set_state({"theta": 0.5, "place": [2, 3]})
    assert asked == [0.0, 0.5] and board.section["text"] == "0.5 2"
    board.set_state({"theta": 1.0})
    assert "no section here" in board.section["text"] and board.section["theta"] == 1.0
    assert "could not answer" in caplog.text
    with pytest.raises(KeyboardInterrupt):
        board.set_state({"theta": 1.2})
    assert "KeyboardInterrupt" in board.section["text"] and board.section["theta"] == 1.2
    board.set_state({"theta": 1.5})
    assert board.section["text"] == "1.5 2" and asked == [0.0, 0.5, 1.0, 1.2, 1.5]
    cut = np.array(board.cut).reshape(-1, 2)
    board.set_state({"place": [4, 4]})
    assert np.array_equal(cut, np.array(board.cut).reshape(-1, 2))
    assert np.array_equal(cut, cut_mesh(board._mesh, 1.5)[:, :, :2].reshape(-1, 2))


def test_a_board_shows_any_mesh():
    """Its cut by default, its colours, or a given section; the picture is a PNG."""
    torus = torus_mesh(np.eye(12, dtype=int))
    plain = solid_board(torus)
    assert (
        plain.place is None
        and len(plain.faces) == len(torus.faces) * 12
        and len(plain.cut) == len(plain.section["shapes"]) > 0
    )
    own = solid_board(
        torus,
        section=lambda theta, place: {"text": f"{theta:.1f} {place[0]:g}", "shapes": []},
        place=(7, 8),
    )
    own.theta = 0.5
    assert own.section["text"] == "0.5 7"
    assert (
        Image.open(io.BytesIO(plain.picture())).size == Image.open(io.BytesIO(own.picture())).size
    )
    assert shape([(0, 0), (1, 1)], line="ink", closed=False)["points"] == [[0, 0], [1, 1]]
    for wrong in (None, [1, 2]):
        with pytest.raises(InvalidParameter, match="triangles"):
            solid_board(wrong)
    with pytest.raises(InvalidPoint):
        solid_board(torus, place=(1, 2, 3))


def test_a_torus_has_the_colours_of_its_cells():
    """Cell (j, i) is two triangles between its angles; wrong images are refused."""
    image = np.zeros((5, 7), int)
    image[3, 2], image[1, 6] = 1, 2
    mesh = torus_mesh(image)
    colours = mesh.visual.face_colors.reshape(5, 7, 2, 4)
    assert (colours[3, 2] == colours[3, 2, 0]).all() and len(
        np.unique(colours.reshape(-1, 4), axis=0)
    ) == 3
    assert mesh.is_watertight and mesh.euler_number == 0 and mesh.volume > 0
    middle = mesh.triangles.reshape(5, 7, 6, 3)[3, 2].mean(axis=0)
    assert np.arctan2(middle[1], middle[0]) == pytest.approx(2 * np.pi * 2.5 / 7, abs=0.2)
    for wrong in (np.zeros((2, 5)), np.full((4, 4), 3), [1, 2, 3]):
        with pytest.raises(InvalidPoint, match="image"):
            torus_mesh(wrong)


def test_a_mesh_is_cut_with_and_without_axes():
    """The plane and the cut are drawn in both."""
    box = torus_mesh(np.zeros((3, 3), int))
    assert len(draw_mesh(box, theta=0.1)) == len(draw_mesh(box, theta=0.1, axes=False)) == 3
    plt.close("all")


@pytest.mark.filterwarnings("error")
def test_a_face_without_an_area_has_a_colour():
    """A mesh from a file may have one."""
    flat = Trimesh(
        [(0, 0, 0), (1, 0, 0), (0, 1, 0), (2, 0, 0)], [(0, 1, 2), (0, 1, 3)], process=False
    )
    assert np.frombuffer(solid_board(flat).colours, np.uint8).min() > 0


def test_figures_are_drawn():
    """Convex or not, in given or new axes; also a world without free space."""
    world = PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [OBSTACLE, ((1, 1), 0.5)])
    _, ax = plt.subplots()
    assert draw_c_obstacle(CORNER, CORNER, ax) and draw_c_obstacle(ROBOT, OBSTACLE)
    assert draw_grown(0.5, world) and draw_grown(3.5, world)
    assert draw_turning_obstacle(CORNER, OBSTACLE, 0.5) and draw_mesh(
        torus_mesh(np.eye(6, dtype=int)), axes=False
    )
    plt.close("all")
