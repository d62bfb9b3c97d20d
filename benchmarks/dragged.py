"""Every board, in a few lines of a notebook, and what is dragged on it: see board.py."""

from pathlib import Path

HOUSE = Path(__file__).resolve().parent.parent
YARD = """
import numpy as np
import kinoedu as ke
obstacles = [[(2, 3), (3.5, 2.6), (3.9, 6.5), (2.4, 6.1)],
             [(5, 0.6), (6.2, 0.9), (6, 4.4), (5.2, 4.6)],
             [(5, 6), (7.2, 5.8), (8, 7.6), (6.2, 7.2), (5.4, 8.2)],
             [(8, 2), (10.4, 2.4), (10, 3.4), (9.2, 3.1), (8.8, 4.8), (7.8, 4.6)], ((10, 6.2), 0.9)]
world = ke.PolygonWorld([(0, 0), (12, 0), (12, 9), (0, 9)], obstacles)
yard = ke.Problem(ke.Point(), world, (1, 1), (11, 8))
"""
TOWN = f"""
import kinoedu as ke
town = ke.read_problem({str(HOUSE / "notebooks" / "maps" / "Paris_1_256.map")!r}, query=324)
"""
OWN = """
def straight(problem):
    problem.is_free_path(problem.start, problem.goal)
    return [problem.start, problem.goal]
"""
GRAPH = """
import numpy as np
from kinoedu.boards import search_board
from kinoedu.graphs import Graph
nodes = np.random.default_rng(1).random((30, 2))
apart = ((nodes[:, None] - nodes) ** 2).sum(axis=2)
near = {tuple(sorted((i, int(j)))) for i in range(30) for j in np.argsort(apart[i])[1:4]}
"""
WALL = "[(6, 3), (9, 3), (9, 7), (6, 7), (7, 5)]"
STREET = """
import numpy as np
import kinoedu as ke
walls = [[(70, 0), (90, 0), (90, 90), (70, 90)], [(150, 70), (170, 70), (170, 160), (150, 160)]]
world = ke.PolygonWorld([(0, 0), (240, 0), (240, 160), (0, 160)], walls)
street = ke.Problem(ke.Car(30, 10, 20), world, (25, 30, np.pi / 2), (200, 90, np.pi / 2))
"""
CROSSING = """
import kinoedu as ke
hall = ke.PolygonWorld([(0, 0), (12, 0), (12, 9), (0, 9)], [[(5, 3), (7, 3), (7, 6), (5, 6)]])
discs = [ke.Moving(0.6, [0, 10], [(9, 7), (2, 7)]), ke.Moving(0.6, [0, 10], [(3, 1), (3, 8)])]
crossing = ke.TimedProblem(ke.Disk(0.4), ke.MovingWorld(hall, discs), start=(1, 4), goal=(11, 4))
"""
UNSURE = """
import kinoedu as ke
edge = [(0, 0), (12, 0), (12, 8), (0, 8)]
unsure = ke.UncertainWorld(edge, [((4.5, 3), 1), ((8, 4), 1.2)], 0.2)
"""
CODE = """
import numpy as np
from kinoedu.boards import code_board
def midpoint(a, b):
    middle = a
    for k in range(100):
        middle = a + (b - a) * k / 100
    return middle
"""
ARM = """
import kinoedu as ke
solids = [[(1.2, 1.4), (2.6, 1.2), (2.2, 2.4)], [(-2.4, 0.4), (-1.2, 0.6), (-1.4, 1.8)],
          ((0.4, 2.2), 0.4), ((0.2, -1.4), 0.3)]
world = ke.PolygonWorld([(-4, -4), (4, -4), (4, 4), (-4, 4)], solids)
arm = ke.TwoLinkArm(1.5, 1.2, 0.2)
"""
TRIANGLES = "[[(1, 2), (1, 0), (3, 0)], [(2, 3), (4, 1), (5, 2)]]"
SOLID = """
from kinoedu.boards import turning_board
needle = [(-0.2, -0.2), (2, -0.2), (2, 0.2), (-0.2, 0.2)]
"""


def coded(code: str, board: str) -> str:
    """The code that shows a board with its box "code" checked."""
    return f"{code}shown = {board}\nshown.code.value = True\nshown"


GOAL, WALL_2 = "handle-1", "polygon-2"
# by name: the code, and the things that are dragged on its first canvas
BOARDS: dict[str, tuple[str, tuple[str, ...]]] = {
    "RRT": (YARD + "ke.board(yard)", (GOAL, WALL_2)),
    "RRT in a town": (TOWN + "ke.board(town)", (GOAL,)),
    "RRT-Connect": (YARD + 'ke.board(yard, "rrt_connect")', (GOAL, WALL_2)),
    "RRT*": (YARD + 'ke.board(yard, "rrt_star")', (GOAL, WALL_2)),
    "PRM": (YARD + 'ke.board(yard, "prm")', (GOAL, WALL_2)),
    "A*": (YARD + 'ke.board(yard, "astar")', (GOAL, WALL_2)),
    "A* in a town": (TOWN + 'ke.board(town, "astar")', (GOAL,)),
    "a reader's planner": (YARD + OWN + "ke.board(yard, straight)", (GOAL,)),
    "RRT with its code": (coded(YARD, "ke.board(yard)"), (GOAL,)),
    "A* with its code": (coded(YARD, 'ke.board(yard, "astar")'), (GOAL,)),
    "race, 1,000 nodes": (YARD + "ke.boards.race_board(yard, nodes=1000)", (GOAL, WALL_2)),
    "rewiring, 1,000 nodes": (YARD + "ke.boards.rewiring_board(yard, nodes=1000)", (GOAL, WALL_2)),
    "roadmap, 1,000 nodes": (YARD + "ke.boards.roadmap_board(yard, n=1000)", (GOAL, WALL_2)),
    "roadmap's properties": (YARD + "ke.boards.properties_board(yard, n=300)", (WALL_2,)),
    "exploring": (YARD + "ke.boards.exploring_board(yard)", (GOAL, WALL_2)),
    "bug": (
        f"from kinoedu.boards import bug_board\nbug_board((0, 0), (5, 3), {TRIANGLES})",
        (GOAL, "polygon-0"),
    ),
    "sweep": (
        YARD + "room = [(0, 0), (12, 0), (12, 9), (0, 9)]\n"
        "ke.boards.sweep_board(ke.PolygonWorld(room, obstacles[:4]))",
        ("handle-0", WALL_2),
    ),
    "search": (
        GRAPH + 'search_board(Graph(nodes=nodes, edges=sorted(near)), search="astar")',
        (GOAL, "handle-9"),
    ),
    "distance": (
        f"from kinoedu.boards import distance_board\ndistance_board({WALL}, q=(3, 3))",
        ("handle-0", "polygon-0"),
    ),
    "samples": ("from kinoedu.boards import samples_board\nsamples_board()", ("handle-0",)),
    "slide": (
        "from kinoedu.boards import slide_board\n"
        "slide_board([(0, 0), (1, 0), (0, 1)], [(2, 2), (4, 2), (4, 3), (2, 3)])",
        ("handle-0", "polygon-0"),
    ),
    "reach": (ARM + "ke.boards.reach_board(arm, p=(1.5, 1))", ("handle-0",)),
    "torus": ("import kinoedu as ke\nke.boards.torus_board((2, 0), (-2, 0))", ("handle-0",)),
    "curves": (
        "import kinoedu as ke\nke.boards.curves_board((0, 0, 0), (30, 40, -2.5), radius=20)",
        ("handle-0", "handle-1"),
    ),
    "car, kinodynamic RRT": (
        STREET + "ke.boards.car_board(street)",
        ("handle-2", "handle-3", "polygon-0"),
    ),
    "car, RRT": (STREET + 'ke.boards.car_board(street, "rrt")', ("handle-2",)),
    "car, kinodynamic PRM": (
        STREET + 'ke.boards.car_board(street, "kinodynamic_prm")',
        ("handle-2",),
    ),
    "car with its code": (coded(STREET, "ke.boards.car_board(street)"), ("handle-2",)),
    "moving obstacles": (CROSSING + "ke.boards.moving_board(crossing)", (GOAL, "polygon-0")),
    "chances": (
        UNSURE + "ke.boards.chance_board(ke.Point(), unsure, (1, 3), (11, 4))",
        (GOAL,),
    ),
    "code": (CODE + "code_board(midpoint, np.array([0.0, 0]), np.array([4.0, 2]))", (GOAL,)),
    "solid": (
        SOLID + "turning_board(needle, [(4, 1), (6, 1.5), (5, 3.5)], place=(3, 2))",
        ("slider",),
    ),
    "arm": (
        ARM + "ke.boards.arm_board(arm, world, q=(0.6, 0.3))",
        ("disc-0", "polygon-1", "handle-1"),
    ),
}
