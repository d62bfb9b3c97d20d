"""The table of bodies: what a page can answer without Python, and how it shows the answer."""

from typing import Any

from ..compiled import Compiled
from ..decomposition.trapezoidation import KINDS
from ..geometry.rings import FAULTS
from ..messages import get_template
from ..robots.arm import TOO_FAR, TOO_NEAR, WHY_UNREACHABLE
from ..support.json_fields import JsonObject
from .arms import ArmSettings, ShownArm, show_arm
from .bug_looks import WALKED
from .curves import LETTERS, CurveSettings, ShownCurves, show_curves
from .grids import GridSettings, show_grid
from .looks import DOT, HANDLES, IMAGE, LINE, LIST, TEXTS, Body, Look, Picture, Say, describe_body
from .nearest import NoSettings, ShownNearest, show_nearest
from .plans import (
    PairSettings,
    RoadmapSettings,
    ShownPlan,
    StarSettings,
    TreeSettings,
    show_prm,
    show_rrt,
    show_rrt_connect,
    show_rrt_star,
)
from .search_layers import ShownSearch
from .search_runs import STATES
from .searches import SearchSettings, show_astar, show_bfs, show_dfs, show_dijkstra
from .sweeps import MOST_JOINED, ShownSweep, show_sweep
from .terrains import (
    show_terrain_cells,
    show_terrain_grid,
    show_terrain_prm,
    show_terrain_rrt,
    show_terrain_rrt_connect,
    show_terrain_rrt_star,
)

WORDS = (
    "live.failed",
    "live.bad_link",
    "ring.repeats_first",
    *(f"not_free.{name}" for name in ("start", "goal", "outside", "touches", "margin")),
    *(f"ring.{fault}" for fault in FAULTS[1:]),
)

BRANCH = ("node", "parent")
PATH = Look("path", "path", "path", 3.0)
TREES = (
    Look("edges", "edges", "tree", LINE, True, says=(Say("board.note.node"),), names=BRANCH),
    Look("others", "edges", "goal_tree", LINE, True, says=(Say("board.note.node"),), names=BRANCH),
    PATH,
)
EDGE, NODE = (Say("board.note.roadmap_edge"),), (Say("board.note.roadmap_node"),)
ROADMAP = (
    Look("edges", "edges", "roadmap", 0.8, True, says=EDGE, names=("u", "v")),
    Look("dots", "dots", "tree", DOT, says=NODE, names=("node", "degree")),
    PATH,
)
PLAN_FACTS = ("length:.4g", "total:,", "iterations:,", "nodes:,")
GRID_FACTS = ("length:.4g", "total:,", "spacing:.6g", "nodes:,")
NODES, EDGES = "figure.nodes", "figure.edges"


def plan_body(
    function: Compiled,
    planner: str,
    settings: type,
    unit: str,
    layers: tuple[Look, ...],
    *reasons: str,
) -> Body:
    """The body of a planner, with the keys of the reasons why there is no path."""
    found = Say("figure.path", {"planner": planner, "unit": Say(unit)})
    failed = [Say("figure.no_path", {"planner": planner, "reason": Say(key)}) for key in reasons]
    return Body(
        function,
        settings,
        ShownPlan,
        PLAN_FACTS,
        (found, *failed),
        layers,
        title=planner,
        menu="board.planner",
        unit=unit,
        is_random=True,
    )


PLANNED = {
    "rrt": plan_body(show_rrt, "RRT", TreeSettings, NODES, TREES, "plan.tree_failed"),
    "rrt_star": plan_body(show_rrt_star, "RRT*", StarSettings, NODES, TREES, "plan.tree_failed"),
    "rrt_connect": plan_body(
        show_rrt_connect, "RRT-Connect", PairSettings, NODES, TREES, "plan.trees_failed"
    ),
    "prm": plan_body(
        show_prm,
        "PRM",
        RoadmapSettings,
        EDGES,
        ROADMAP,
        "plan.start_alone",
        "plan.goal_alone",
        "plan.parts_apart",
    ),
    "astar": plan_body(
        show_grid,
        "A*",
        GridSettings,
        NODES,
        TREES,
        "plan.grid_failed",
        "plan.start_off_grid",
        "plan.goal_off_grid",
    )._replace(facts=GRID_FACTS, is_random=False),
}
ON_TERRAIN = {
    f"terrain_{name}": PLANNED[planner]._replace(function=function)
    for name, planner, function in (
        ("rrt", "rrt", show_terrain_rrt),
        ("rrt_star", "rrt_star", show_terrain_rrt_star),
        ("rrt_connect", "rrt_connect", show_terrain_rrt_connect),
        ("prm", "prm", show_terrain_prm),
        ("astar", "astar", show_terrain_grid),
        ("cells", "astar", show_terrain_cells),
    )
}
NEAREST = Body(
    show_nearest,
    NoSettings,
    ShownNearest,
    ("distance:.4g", "number:d"),
    (Say("board.distance.inside"), Say("board.distance.edge"), Say("board.distance.vertex")),
    (
        Look("vertices", "labels", "obstacle", form="d"),
        Look("way", "edges", "tree", 2.5, dash=(6.0, 4.0)),
        Look("near", "dots", "tree", 6.0),
        Look("sizes", "labels", "tree", form=".4g"),
        Look("tangent", "arrows", "path", 3.0),
    ),
)
CURVES = Body(
    show_curves,
    CurveSettings,
    ShownCurves,
    (f"forward:{LETTERS}", "first:.3g", f"both:{LETTERS}", "second:.3g"),
    (Say("curves_board.text"),),
    (
        Look("forward", "edges", "tree", 2.0),
        Look("driven", "edges", "path", 4.0),
        Look("backed", "edges", "path", 4.0, dash=(7.0, 5.0)),
        Look("first", "arrows", "start", 3.0),
        Look("second", "arrows", "goal", 3.0),
        Look("noses", HANDLES),
    ),
)


def search_looks(informed: bool) -> tuple[Look, ...]:
    """The layers of a search, informed if it has a heuristic."""
    costs = Say("board.note.gh" if informed else "board.note.g")
    states = tuple(Say(f"board.note.{state}", {"costs": costs}) for state in STATES)
    names = ("node", "parent", "which", "g", "h", "f")[: 6 if informed else 4]
    steps = ("which:d", "nodes:d", "expanded:d", "frontier:d", "node:d")
    stays: Any = {"grows": True, "ends": True}
    return (
        Look("expanded", "cells", "cell", **stays),
        Look("waiting", "cells", "frontier", **stays),
        Look("now", "cells", "ink", **stays),
        Look("outlines", "edges", "outside", 0.6),
        Look("lines", "edges", "outside", 1.5),
        Look("parents", "arrows", "tree", 2.0, **stays),
        Look("spots", "dots", "ink", "rim"),
        Look("spots", "dots", "free", "radius"),
        Look("expanded_spots", "dots", "tree", "radius", **stays),
        Look("waiting_spots", "dots", "frontier", "radius", **stays),
        Look("spot_now", "dots", "ink", "large", **stays),
        Look("notes", "nodes", "ink", "reach", says=states, names=names, **stays),
        Look("from_start", "edges", "start", 2.0, dash=(4.0, 4.0)),
        Look("from_goal", "edges", "goal", 2.0, dash=(4.0, 4.0)),
        PATH,
        Look("numbers", "labels", form="d"),
        Look("moments", TEXTS, says=STEPS, names=steps),
    )


STEPS = (Say("search_board.before"), Say("search_board.growing"))
OUTCOMES = (Say("search_board.found"), Say("search_board.failed"))
SEARCH_FACTS = (
    *("expanded:d", "nodes:d", "frontier:d", "cost:.4g", "edges:d", "start:d", "goal:d", "total:d"),
    *("radius", "rim", "large", "reach"),
)
SEARCHED = {
    f"search_{name}": Body(
        function,
        SearchSettings,
        ShownSearch,
        SEARCH_FACTS,
        (*OUTCOMES, *(Say("search_board.between", {"outcome": say}) for say in OUTCOMES)),
        search_looks(name == "astar"),
        title=Say(f"search_board.{name}"),
        menu="search_board.search",
        unit="search_board.unit",
    )
    for name, function in (
        ("bfs", show_bfs),
        ("dfs", show_dfs),
        ("dijkstra", show_dijkstra),
        ("astar", show_astar),
    )
}
JOINED = tuple("abcdef"[:MOST_JOINED])  # the names of the cells that a cell is joined to
LISTED = [", ".join(f"{{{name}}}" for name in JOINED[:count]) for count in range(MOST_JOINED + 1)]
LISTED.append(f"{LISTED[-1]}, ...")
NEIGHBOURS = (
    Say("board.note.alone"),
    *(Say("board.note.joined", {"cells": cells}) for cells in LISTED[1:]),
)
EVENTS = (*KINDS.values(), "a touch", "{vertices} vertices")
NAME_OF_EDGE = (Say("sweep_board.name"),)
SWEPT = Body(
    show_sweep,
    NoSettings,
    ShownSweep,
    ("x:.4g", "closed:d", "open:d"),
    (Say("sweep_board.before"), Say("sweep_board.now"), Say("sweep_board.ended")),
    (
        Look(
            "closed",
            "cells",
            "cell",
            says=tuple(Say("board.note.cell", {"joined": joined}) for joined in NEIGHBOURS),
            names=("which", "number", "left", "right", *JOINED),
        ),
        Look("closed_sides", "edges", "tree", 1.5),
        Look("open_sides", "edges", "tree", 1.8, dash=(6.0, 5.0)),
        Look("numbers", "labels", "tree", form="d"),
        Look("line", "edges", "ink", 2.0),
        Look("floors", "edges", "floor", 4.0),
        Look("ceilings", "edges", "ceiling", 4.0),
        Look("met", "dots", "ink", 3.5),
        Look("now", "dots", "path", 6.0),
        Look("crossings", "dots", "ink", 3.0),
        Look("floor_names", "labels", "floor", says=NAME_OF_EDGE, names=("number:d",)),
        Look("ceiling_names", "labels", "ceiling", says=NAME_OF_EDGE, names=("number:d",)),
        Look(
            "event",
            LIST,
            says=tuple(Say("sweep_board.event", {"event": event}) for event in EVENTS),
            names=("which:d", "vertices:d"),
        ),
        Look("status", LIST, says=(Say("sweep_board.edge"),), names=("number:d",)),
    ),
    warns=(Say("sweep_board.overlap"),),
)
CONTACTS = (
    Say("figure.no_link_in_contact"),
    *(Say("figure.link_in_contact", {"link": link}) for link in (1, 2)),
    Say("arm_board.both"),
)
HERE = tuple(Say("arm_board.result", {"contact": contact}) for contact in CONTACTS)
HINDERED = tuple(
    Say("arm_board.out_of_reach", {"reason": WHY_UNREACHABLE[why]}) for why in (TOO_FAR, TOO_NEAR)
)
FREE_AND_HIT = tuple(Say(f"figure.link_{link}") for link in range(3))
SQUARE = Picture(
    tuple(
        Say("arm_board.in_square", {"first": "{across}", "second": "{up}", "link": link})
        for link in FREE_AND_HIT
    ),
    (
        Look("regions", "labels", says=FREE_AND_HIT, names=("which:d",)),
        Look("sights", "edges", "ink", 1.2, dash=(2.0, 5.0)),
        Look("spot", HANDLES),
        Look("image", IMAGE),
    ),
    "hit",
)
ARM = Body(
    show_arm,
    ArmSettings,
    ShownArm,
    (
        *("first:.2f", "second:.2f", "across:.0f", "up:.0f"),
        *("far:.6g", "inner:.6g", "outer:.6g", "hit"),
    ),
    (
        *HERE,
        *(Say("arm_board.two", {"first": a, "then": b}) for b in HINDERED for a in HERE),
    ),
    (
        Look("free_links", "bodies", "free_link", 2.0),
        Look("first_hit", "bodies", "ink", 2.0, hatched=True),
        Look("second_hit", "bodies", "hit", 2.0, hatched=True),
        Look("base", "dots", "ink", 8.0),
        Look("joints", "dots", "ink", 7.0),
        Look("joints", "dots", "free", 4.5),
        Look("names", "labels", says=(Say("arm_board.link"),), names=("number:d",)),
        Look("grips", HANDLES),
    ),
    beside=SQUARE,
)
BODIES = {
    **PLANNED,
    **ON_TERRAIN,
    **SEARCHED,
    **WALKED,
    "nearest": NEAREST,
    "curves": CURVES,
    "sweep": SWEPT,
    "arm": ARM,
}


def describe_bodies(language: str = "en") -> JsonObject:
    """What a page needs to know of the bodies, as plain data: their looks and their words."""
    return {
        "bodies": {name: describe_body(body, language) for name, body in BODIES.items()},
        "faults": FAULTS,
        "words": {key: get_template(key, language) for key in WORDS},
    }
