"""Every planner that makes a plan of a problem: one row each.

The command line, the boards, experiments and the code that is compiled ahead read this table. A
new planner is one file in its family and one row here.
"""

import inspect
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

from ..problems import Plan
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
    """A planner: its function and what the rest of the house needs to know of it.

    Parameters
    ----------
    name : as boards and the command line call it (there with dashes).
    function : of a problem and keywords.
    about : one line of help.
    options : the settings it takes, as the function's keywords. The names of settings are `step`,
        `nodes`, `neighbours`, `spacing` and `iterations`.
    robots : the robots for which it is compiled ahead.
    quick : keywords of a short run that calls everything a long run calls.
    board : the settings that a board of the plane offers; None where it is not on that board.
    car_board : the iterations that a car's board begins with; None where it is not on that board.
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
        """Whether it draws random numbers."""
        return "rng" in inspect.signature(self.function).parameters

    def plan(self, problem: Any, *, seed: int = 0, **settings: Any) -> Plan:
        """Plan with settings by their common names; `seed` serves planners that are random."""
        return self.run(problem, seed, {self.options[name]: v for name, v in settings.items()})

    def quick_plan(self, problem: Any) -> Plan:
        """A short run."""
        return self.run(problem, 0, self.quick)

    def run(self, problem: Any, seed: int, keywords: Mapping[str, Any]) -> Plan:
        """Call the function."""
        random = {"rng": seed} if self.is_random else {}
        return self.function(problem, **keywords, **random)


STEP, ITERATIONS = {"step": "step", "nodes": "max_nodes"}, {"iterations": "max_iterations"}
SAMPLES = {"nodes": "n", "neighbours": "k"}

ROWS = (
    Planner(
        "rrt",
        rrt,
        "a tree that grows at random; any scene",
        STEP | ITERATIONS,
        ALL,
        {"max_nodes": 50},
        board=("step",),
        car_board=1000,
    ),
    Planner(
        "rrt_connect",
        rrt_connect,
        "a tree from either end; any scene",
        STEP,
        ALL,
        {"max_nodes": 500},
    ),
    Planner(
        "rrt_star",
        rrt_star,
        "a tree whose paths become shortest; any scene",
        STEP,
        (POINT,),
        {"max_nodes": 200},
    ),
    Planner(
        "informed_rrt_star",
        informed_rrt_star,
        "the same; later samples only where a shorter path can pass",
        STEP,
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
        "a roadmap with more neighbours as it grows; any scene",
        {"nodes": "n"},
        (),
        {"n": 20},
    ),
    Planner("tree_roadmap", tree_roadmap, "a roadmap of trees; any scene", {}, (), {}),
    Planner(
        "astar",
        plan_on_grid,
        "a search on a grid; for a point or a disk",
        {"spacing": "spacing"},
        (POINT,),
        {},
        board=(),
    ),
    Planner(
        "kinodynamic_rrt",
        kinodynamic_rrt,
        "a tree of drives, for a car",
        ITERATIONS,
        (CAR,),
        {"max_iterations": 50},
        car_board=1000,
    ),
    Planner(
        "kinodynamic_prm",
        kinodynamic_prm,
        "a roadmap of drives, for a car",
        {"iterations": "iterations"},
        (CAR,),
        {"iterations": 20},
        car_board=350,
    ),
    Planner(
        "sst",
        sst,
        "a sparse tree of ever shorter drives, for a car",
        ITERATIONS,
        (CAR,),
        {"max_iterations": 50},
    ),
    Planner(
        "hybrid_astar",
        hybrid_astar,
        "a search among short drives, for a car",
        {"spacing": "spacing"},
        (CAR,),
        {},
    ),
    Planner(
        "visibility",
        plan_by_visibility,
        "from corner to corner; the shortest path, but only for a point *",
        {},
        (POINT,),
        {},
    ),
    Planner(
        "decomposition",
        plan_by_decomposition,
        "cells of the free space; exact, but only for a point *",
        {},
        (POINT,),
        {},
    ),
    Planner(
        "cells_with_headings",
        plan_by_cells_with_headings,
        "cells for each of many headings; for a turning polygon *",
        {},
        (),
        {},
    ),
    Planner(
        "receding_horizon",
        receding_horizon,
        "for a point that sees only what is near *",
        {},
        (POINT,),
        {"max_moves": 2},
    ),
)
PLANNERS = {planner.name: planner for planner in ROWS}
