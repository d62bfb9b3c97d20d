"""The table of all planners that take a problem and return a plan.

The command line, the boards, experiments and ahead-of-time compilation read this table. A new
planner needs one file in its family and one row here (docs/contributing.md).
"""

import inspect
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

from ..problems import Plan
from ..problems.protocols import ProblemLike
from .driving.hybrid_astar import hybrid_astar
from .driving.kinodynamic_prm import kinodynamic_prm
from .driving.kinodynamic_rrt import kinodynamic_rrt
from .driving.sst import sst
from .exact.by_decomposition import plan_by_decomposition
from .exact.cells_with_headings import plan_by_cells_with_headings
from .exact.visibility import plan_by_visibility
from .exploring.receding_horizon import receding_horizon
from .grids.grid import plan_on_grid
from .roadmaps.prm import prm, prm_star
from .trees.rrt import rrt
from .trees.rrt_connect import rrt_connect
from .trees.rrt_star import informed_rrt_star, rrt_star
from .trees.tree_roadmap import tree_roadmap

POINT, DISK, CAR = "point", "disk", "car"
TRANSLATING, TURNING, ARM = "translating polygon", "turning polygon", "arm"
ALL = (POINT, DISK, TRANSLATING, TURNING, ARM, CAR)


class Planner(NamedTuple):
    """A planner: its function, its settings, and where it is used.

    Parameters
    ----------
    name : the name on boards and on the command line (there with dashes).
    function : takes a problem and keywords, returns a Plan.
    about : one line of help; * marks a planner for polygonal obstacles only, ** one for polygonal
        and round obstacles only.
    options : the function's keyword for each setting that it takes. The names of settings are
        `step_size`, `nodes`, `neighbours`, `spacing` and `iterations`.
    robots : the robots for which the planner is compiled ahead of time.
    quick : keywords of a short run that calls all functions of a long run.
    board : the settings that the planar board offers; None where the planner is not on that board.
    car_board : the initial number of iterations on the car board; None where it is not on that
        board.
    """

    name: str
    function: Callable[..., Plan]
    about: str
    options: Mapping[str, str]
    robots: tuple[str, ...]
    quick: Mapping[str, Any]
    board: tuple[str, ...] | None = None
    car_board: int | None = None

    @property
    def is_random(self) -> bool:
        """Whether the planner draws random numbers."""
        return "rng" in inspect.signature(self.function).parameters

    def default(self, setting: str) -> Any:
        """The function's default for a setting."""
        return inspect.signature(self.function).parameters[self.options[setting]].default

    def plan(self, problem: Any, *, seed: int = 0, **settings: Any) -> Plan:
        """Plan with settings by their common names; `seed` is for random planners."""
        return self.run(problem, seed, {self.options[name]: v for name, v in settings.items()})

    def quick_plan(self, problem: ProblemLike) -> Plan:
        """Plan with the keywords of the short run."""
        return self.run(problem, 0, self.quick)

    def run(self, problem: ProblemLike, seed: int, keywords: Mapping[str, Any]) -> Plan:
        """Call the function, with a random generator where it takes one."""
        random = {"rng": seed} if self.is_random else {}
        return self.function(problem, **keywords, **random)


TREE = {"step_size": "step_size", "nodes": "max_nodes"}
ITERATIONS = {"iterations": "max_iterations"}
SAMPLES = {"nodes": "n", "neighbours": "k"}

ROWS = (
    Planner(
        "rrt",
        rrt,
        "a random tree from the start; any scene",
        TREE | ITERATIONS,
        ALL,
        {"max_nodes": 50},
        board=("step_size",),
        car_board=1000,
    ),
    Planner(
        "rrt_connect",
        rrt_connect,
        "two random trees, from start and goal; any scene",
        TREE,
        ALL,
        {"max_nodes": 500},
        board=("step_size",),
    ),
    Planner(
        "rrt_star",
        rrt_star,
        "a random tree whose paths converge to the shortest; any scene",
        TREE,
        (POINT,),
        {"max_nodes": 200},
        board=("step_size", "nodes"),
    ),
    Planner(
        "informed_rrt_star",
        informed_rrt_star,
        "rrt-star that samples only where a shorter path can pass",
        TREE,
        (POINT,),
        {"max_nodes": 200},
    ),
    Planner(
        "prm",
        prm,
        "a roadmap of random samples; any scene",
        SAMPLES,
        ALL,
        {"n": 20},
        board=("nodes",),
    ),
    Planner(
        "prm_star",
        prm_star,
        "prm whose number of neighbours grows with the nodes; any scene",
        {"nodes": "n"},
        (),
        {"n": 20},
    ),
    Planner("tree_roadmap", tree_roadmap, "a roadmap of random trees; any scene", {}, (), {}),
    Planner(
        "astar",
        plan_on_grid,
        "A* on a grid; for a point or a disk",
        {"spacing": "spacing"},
        (POINT,),
        {},
        board=(),
    ),
    Planner(
        "kinodynamic_rrt",
        kinodynamic_rrt,
        "a random tree of drives; for a car",
        ITERATIONS,
        (CAR,),
        {"max_iterations": 50},
        car_board=1000,
    ),
    Planner(
        "kinodynamic_prm",
        kinodynamic_prm,
        "a roadmap of drives; for a car",
        {"iterations": "n"},
        (CAR,),
        {"n": 20},
        car_board=350,
    ),
    Planner(
        "sst",
        sst,
        "a sparse tree of drives whose paths become shorter; for a car",
        ITERATIONS,
        (CAR,),
        {"max_iterations": 50},
    ),
    Planner(
        "hybrid_astar",
        hybrid_astar,
        "A* over short drives; for a car",
        {"spacing": "spacing"},
        (CAR,),
        {},
    ),
    Planner(
        "visibility",
        plan_by_visibility,
        "the shortest path, from corner to corner; for a point *",
        {},
        (POINT,),
        {},
    ),
    Planner(
        "decomposition",
        plan_by_decomposition,
        "a path through the cells of the free space; exact; for a point *",
        {},
        (POINT,),
        {},
    ),
    Planner(
        "cells_with_headings",
        plan_by_cells_with_headings,
        "a roadmap of free headings in the cells of a point; for a turning polygon *",
        {},
        (),
        {},
    ),
    Planner(
        "receding_horizon",
        receding_horizon,
        "plans again as a range sensor sees more obstacles; for a point or a disk **",
        {},
        (POINT,),
        {"max_moves": 2},
    ),
)
PLANNERS = {planner.name: planner for planner in ROWS}
