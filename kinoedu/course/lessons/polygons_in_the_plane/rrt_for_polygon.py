"""The exercise on an RRT for a polygon that rotates: lesson 9's planner in (x, y, theta)."""

from collections.abc import Iterator

import numpy as np

from ....problems import Problem
from ....robots import RigidPolygon
from ....worlds import PolygonWorld
from ...exercise import Case
from ...shapes import Value
from ..shared.planned import StudentProblem
from ..shared.small_problems import SQUARE, box
from ..trees.rrt import Rrt, aim_at_goal, grow_tree, with_bias, with_step

STICK = RigidPolygon([(-1.0, -0.2), (1.0, -0.2), (1.0, 0.2), (-1.0, 0.2)])
NEEDLE = RigidPolygon([(-0.5, -0.002), (0.5, -0.002), (0.5, 0.002), (-0.5, 0.002)])
TILE = RigidPolygon([(-0.25, -0.25), (0.25, -0.25), (0.25, 0.25), (-0.25, 0.25)])
STEP, BIAS, OFTEN = 2.0, 0.2, 0.5
LONG = 3.0  # another step


def make_problem(
    start: Value, goal: Value, *obstacles: Value, robot: Value = STICK
) -> StudentProblem:
    """Return the problem of a stick, or another robot, among obstacles in a room of 10 x 10."""
    return StudentProblem(Problem(robot, PolygonWorld(SQUARE, obstacles), start, goal))


TASKS = {
    "same": make_problem((4, 5, 1), (4, 5, 1)),
    "room": make_problem((2, 3, 0), (8, 7, 1)),
    "seam": make_problem((5, 5, 3.0), (5.5, 5, -3.0)),  # the short way leads across pi
    "door": make_problem((2.5, 5, 0), (7.5, 5, 0), box(4.9, 0, 5.1, 4), box(4.9, 6, 5.1, 10)),
    "wall": make_problem((2, 2, 1.57), (8, 2, 1.57), box(4, 0, 6, 7.5)),
    "sealed": make_problem(
        (2, 2, 0), (8.85, 8.85, 0), box(7.5, 7.5, 10, 7.7), box(7.5, 7.5, 7.7, 10)
    ),
}
# a step from the start is always free
FAR_FROM_WALLS = make_problem(
    (5, 5, 0), (8.85, 8.85, 0), box(7.5, 7.5, 10, 7.7), box(7.5, 7.5, 7.7, 10)
)
# a sheet that fits between sampled points of a motion
SHEET = make_problem((4.3, 2, 1.57), (5.9, 2, 1.57), box(5, 0, 5.002, 7.5), robot=NEEDLE)
# in the last step straight to the goal the tile's lower side touches a box
GRAZED = make_problem((2, 5, 0), (7, 5, 0), box(6.4, 3, 6.6, 4.75), robot=TILE)


class RrtForPolygon(Rrt):
    """Grow one tree in SE(2)."""

    name = "rrt_for_polygon"
    lesson = "11_polygons_in_the_plane"
    kinds = ("same", "room", "seam", "door", "wall", "sealed")
    shared = ("rrt", "planner", "exercise")

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield every task twice, then runs straight to the goal with and without a path.

        The second wall is a thin one, and the second closed corner has a larger bias. Of the last
        runs one has just enough iterations, two have goal bias 0, one of them for one step, and one
        needs no iteration; in one a motion touches a box.
        """
        for tasks, bias in ((TASKS, BIAS), ({**TASKS, "wall": SHEET}, OFTEN)):
            for kind in tasks:
                case = self.make_case(kind, tasks[kind], rng)
                given = {**case.given, "goal_bias": bias if kind == "sealed" else BIAS}
                yield case._replace(given=given)
        for kind in ("room", "sealed"):
            yield aim_at_goal(self.make_case(kind, TASKS[kind], rng))
        straight = aim_at_goal(self.make_case("room", TASKS["room"], rng))
        added = len(grow_tree(*straight.given.values())[0]) - 2  # start and goal are not drawn
        yield straight._replace(given={**straight.given, "iterations": added})
        yield with_bias(self.make_case("sealed", TASKS["sealed"], rng), 0.0, iterations=60)
        yield with_bias(self.make_case("sealed", FAR_FROM_WALLS, rng), 0.0, iterations=1)
        yield aim_at_goal(self.make_case("sealed", GRAZED, rng))
        # the goal is exactly one step away
        yield aim_at_goal(self.make_case("room", make_problem((3, 5, 0), (5, 5, 0)), rng))
        yield with_step(self.make_case("room", TASKS["room"], rng), LONG)
        # the goal is more than the usual step away, and less than this one
        near = self.make_case("room", make_problem((3, 5, 0), (5.5, 5, 0)), rng)
        yield with_step(aim_at_goal(near), LONG)

    def uses_chance(self, case: Case) -> bool:
        """Whether anything is drawn: the goal is more than a step away."""
        return case.kind != "seam" and super().uses_chance(case)

    def make_case(self, kind: str, problem: StudentProblem, rng: np.random.Generator) -> Case:
        """Return a case, with fewer iterations where no path exists."""
        most = 300 if kind == "sealed" else 800
        given = {
            "problem": problem,
            "step": STEP,
            "goal_bias": BIAS,
            "iterations": most,
            "rng": int(rng.integers(1000)),
        }
        return Case(kind, given)
