"""The table of bodies: what a page can answer without Python, and how it shows the answer."""

from ..compiled import Compiled
from ..geometry.rings import FAULTS
from ..messages import get_template
from ..support.json_fields import JsonObject
from .curves import LETTERS, CurveSettings, ShownCurves, show_curves
from .looks import DOT, HANDLES, LINE, Body, Look, Say, describe_body
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
    Look("edges", "edges", "tree", LINE, True, says="node", names=BRANCH),
    Look("others", "edges", "goal_tree", LINE, True, says="node", names=BRANCH),
    PATH,
)
ROADMAP = (
    Look("edges", "edges", "roadmap", 0.8, True, says="roadmap_edge", names=("u", "v")),
    Look("dots", "dots", "tree", DOT, says="roadmap_node", names=("node", "degree")),
    PATH,
)
PLAN_FACTS = ("length:.4g", "total:,", "iterations:,", "nodes:,")
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
BODIES = {**PLANNED, "nearest": NEAREST, "curves": CURVES}


def describe_bodies(language: str = "en") -> JsonObject:
    """What a page needs to know of the bodies, as plain data: their looks and their words."""
    return {
        "bodies": {name: describe_body(body, language) for name, body in BODIES.items()},
        "faults": FAULTS,
        "words": {key: get_template(key, language) for key in WORDS},
    }
