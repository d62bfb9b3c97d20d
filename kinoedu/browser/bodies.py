"""The table of bodies: what a page can answer without Python, and how it shows the answer."""

from typing import Any, NamedTuple

import numpy as np

from ..compiled import Compiled
from ..geometry.rings import FAULTS
from ..messages import get_template
from ..support.json_fields import JsonObject
from .plans import show_prm, show_rrt, show_rrt_connect, show_rrt_star
from .scenes import pack_scene

LINE, DOT = "line", "dot"  # a width that falls with the number of steps; a size with that of dots


class Look(NamedTuple):
    """The look of a field of `Shown` as a layer of a drawing, `kinoedu.boards.core.drawing`.

    says, names : the key of the message of a row, and the names of its numbers.
    """

    field: str
    kind: str
    colour: str
    width: float | str
    grows: bool = False
    says: str = ""
    names: tuple[str, ...] = ()


class Body(NamedTuple):
    """A function from a scene, settings (n,) and a generator to `Shown`.

    settings : their names.
    unit : the key of the message that names a step.
    reasons : the keys of the messages that say why there is no path.
    """

    function: Compiled
    planner: str
    settings: tuple[str, ...]
    unit: str
    reasons: tuple[str, ...]
    layers: tuple[Look, ...]


BRANCH = ("node", "parent")
PATH = Look("path", "path", "path", 3.0)
TREES = (
    Look("edges", "edges", "tree", LINE, True, "node", BRANCH),
    Look("others", "edges", "goal_tree", LINE, True, "node", BRANCH),
    PATH,
)
ROADMAP = (
    Look("edges", "edges", "roadmap", 0.8, True, "roadmap_edge", ("u", "v")),
    Look("dots", "dots", "tree", DOT, False, "roadmap_node", ("node", "degree")),
    PATH,
)
TREE_SETTINGS = ("clearance", "step_size", "goal_bias", "max_nodes", "max_iterations")
TREE_REASONS, TREES_REASONS = ("plan.tree_failed",), ("plan.trees_failed",)
ROADMAP_REASONS = ("plan.start_alone", "plan.goal_alone", "plan.parts_apart")
NODES, EDGES = "figure.nodes", "figure.edges"
BODIES = {
    "rrt": Body(show_rrt, "RRT", TREE_SETTINGS, NODES, TREE_REASONS, TREES),
    "rrt_star": Body(show_rrt_star, "RRT*", (*TREE_SETTINGS, "gamma"), NODES, TREE_REASONS, TREES),
    "rrt_connect": Body(
        show_rrt_connect,
        "RRT-Connect",
        ("clearance", "step_size", "max_nodes", "max_iterations"),
        NODES,
        TREES_REASONS,
        TREES,
    ),
    "prm": Body(show_prm, "PRM", ("clearance", "n", "k"), EDGES, ROADMAP_REASONS, ROADMAP),
}
WORDS = (
    *(
        "figure.path",
        "figure.no_path",
        "live.failed",
        "live.bad_link",
        "board.planner",
        "ring.repeats_first",
    ),
    *(f"not_free.{name}" for name in ("start", "goal", "outside", "touches", "margin")),
    *(f"ring.{fault}" for fault in FAULTS[1:]),
)

EMPTY: dict[str, Any] = {"boundary": [], "polygons": [], "discs": [], "handles": []}
# arguments of the types that all bodies take
EXAMPLE = (pack_scene({**EMPTY, "lo": [0, 0], "hi": [1, 1]}), np.zeros(1), np.random.default_rng(0))


def describe_bodies(language: str = "en") -> JsonObject:
    """What a page needs to know of the bodies, as plain data: their looks and their words."""
    keys = {key for body in BODIES.values() for key in (body.unit, *body.reasons)}
    return {
        "bodies": {
            name: {
                "planner": body.planner,
                "unit": body.unit,
                "reasons": body.reasons,
                "layers": [describe_look(look, language) for look in body.layers],
            }
            for name, body in BODIES.items()
        },
        "faults": FAULTS,
        "words": {key: get_template(key, language) for key in sorted({*keys, *WORDS})},
    }


def describe_look(look: Look, language: str) -> JsonObject:
    """A look as plain data, with what its rows say."""
    says = [get_template(f"board.note.{look.says}", language)] if look.says else []
    return {**look._asdict(), "says": says}
