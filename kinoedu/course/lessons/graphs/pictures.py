"""Pictures of failing cases on graphs.

The right answer is solid and green, the student's is dashed and brown.
"""

from typing import Any

import numpy as np

from ....messages import get_message
from ...exercise import Axes, Case, Exercise, Given, format_value
from ...shapes import Value
from ..shared.random_graphs import as_graph, symmetric

MOST_LABELS = 30  # nodes that get labels
MOST_STEPS = 100  # edges of a path that are drawn; a longer path is only described
# functions import figures themselves: matplotlib is needed only where an answer is wrong


def draw_tree_answer(
    exercise: Exercise,
    case: Case,
    value: list[int] | None,
    far: Value,
    ax: Axes,
    wanted: list[int] | None = None,
) -> None:
    """Draw a graph, each node's distance from the start, and the student's tree.

    Parameters
    ----------
    far : distance of each node from the start in edges, infinite where it is not reached.
    wanted : the only right parents; None where ties may be broken either way.
    """
    from ....figures import palette

    neighbours, start = case.given["neighbours"], case.given["start"]
    places = draw_grey_graph(case, ax, highlight=[start])
    for u, d in enumerate(far):
        if u == start:
            text = get_message("graph_picture.start")
        elif d < np.inf:
            text = get_message("graph_picture.far", d=f"{d:.0f}")
        else:
            text = get_message("graph_picture.unreached")
        draw_label(places, u, text, ax, palette.TRUE)
    if value is not None and len(value) == len(neighbours):
        for u, p in enumerate(value):
            if 0 <= p < len(value) and p != u:
                good = (
                    u in neighbours[p]
                    and far[p] + 1 == far[u]
                    and (wanted is None or wanted[u] == p)
                )
                draw_pointer(
                    places, p, u, ax, palette.TRUE if good else palette.YOURS, "-" if good else "--"
                )
    draw_answer_note(value, ax)
    finish_picture(exercise, case, ax)


def draw_pointers(
    exercise: Exercise, case: Case, value: list[int] | None, truth: list[int] | None, ax: Axes
) -> None:
    """Draw the arrow from each parent to its child, the path from the root, and the student's."""
    from ....figures import palette

    parent = case.given["parent"]
    places = draw_grey_graph(case, ax, highlight=[case.given["goal"]])
    for u, p in enumerate(parent):
        if p >= 0 and p != u:
            draw_pointer(places, p, u, ax, palette.OUTSIDE, "-", width=1.8)
        elif p == -1:
            draw_label(places, u, get_message("graph_picture.root"), ax, palette.INK)
    draw_paths(places, truth, value, ax)
    finish_picture(exercise, case, ax)


def draw_path_answer(
    exercise: Exercise, case: Case, value: list[int] | None, truth: list[int] | None, ax: Axes
) -> None:
    """Draw a graph with its weights and estimates, a right path and the student's."""
    draw_question(case.given, value, truth, ax)
    draw_answer_note(exercise.as_asked(value, case), ax)
    finish_picture(exercise, case, ax)


def draw_misled(exercise: Exercise, value: Value, paths: tuple[Any, Any], ax: Axes) -> None:
    """Draw a graph with an estimate, the path that A* returns, and a shortest path."""
    from ....figures import palette, plane

    if value is None:
        plane.frame([(0, 0), (1, 1)], ax)
        plane.corner_note(get_message("picture.no_answer"), ax, colour=palette.YOURS)
    else:
        draw_question(
            dict(zip(("neighbours", "weights", "estimate", "start", "goal"), value)), *paths, ax
        )
        draw_answer_note(paths[0], ax)
    ax.set_axis_off()
    plane.title(exercise.message("picture"), ax)


def draw_question(given: Given, value: object, truth: object, ax: Axes) -> None:
    """Draw a graph with its start and goal, a right path and the student's."""
    from ....figures import palette

    start, goal = given["start"], given["goal"]
    places = draw_grey_graph(Case("", given), ax, highlight=[start, goal])
    for u in range(len(places)):
        text = [
            get_message(f"graph_picture.{name}") for name in ("start", "goal") if given[name] == u
        ]
        if "estimate" in given and len(places) <= 16:
            text.append(get_message("graph_picture.estimate", value=f"{given['estimate'][u]:.3g}"))
        draw_label(places, u, ", ".join(text), ax, palette.INK)
    draw_paths(places, truth, value, ax)


def draw_costs(exercise: Exercise, case: Case, value: Value, truth: Value, ax: Axes) -> None:
    """Draw a graph with its weights and costs, and the student's costs where they differ."""
    from ....figures import palette

    places = draw_grey_graph(case, ax, highlight=[case.given["start"]])
    fits = value is not None and not isinstance(truth, ValueError) and len(value) == len(truth)
    for u in range(len(places)):
        if isinstance(truth, ValueError):
            text = get_message("graph_picture.start") if u == case.given["start"] else ""
            draw_label(places, u, text, ax, palette.INK)
        elif fits and not (
            value[u] == truth[u] or abs(value[u] - truth[u]) <= 1e-6 * (1.0 + abs(truth[u]))
        ):
            text = get_message(
                "graph_picture.cost",
                value=format_value(truth[u]),
                yours=format_value(float(value[u])),
            )
            draw_label(places, u, text, ax, palette.YOURS)
        else:
            draw_label(places, u, format_value(truth[u]), ax, palette.TRUE)
    draw_answer_note(value, ax)
    finish_picture(exercise, case, ax)


def draw_grey_graph(case: Case, ax: Axes, *, highlight: list[int]) -> Value:
    """Draw the graph in grey on a circle; an edge in both directions is one line.

    Returns
    -------
    Positions of the nodes, shape (n, 2).
    """
    from ....figures import graphs, palette, plane
    from ....graphs import Graph

    neighbours = case.given.get("neighbours", [[] for _ in case.given.get("parent", [])])
    weights: Any = case.given.get("weights")
    graph = as_graph(neighbours)
    if symmetric(neighbours, weights):
        once = graph.edges[:, 0] <= graph.edges[:, 1]
        graph = Graph(graph.size, graph.edges[once])
    places = graphs.layout(graph)
    plane.frame(np.vstack([places, [(-1.0, -1.0), (1.0, 1.0)]]), ax, margin=0.14)
    graphs.draw_graph(graph, ax, highlight=highlight)
    for u, v in graph.edges.tolist() if weights is not None and graph.size <= 16 else []:
        (x, y), aside = places[v] - places[u], graphs.bend(graph, u, v) / 2
        weight = weights[u][neighbours[u].index(v)]  # the Graph refuses negative weights
        at = (places[u] + places[v]) / 2 + aside * np.array([y, -x])
        graphs.write_beside(at, f"{weight:.3g}", ax, (0, -5), palette.INK, "center")
    return places


def draw_paths(places: Value, truth: Value, value: Value, ax: Axes) -> None:
    """Draw a right path, wide and green, and over it the student's, dashed and brown."""
    from ....figures import graphs, palette

    for path, colour, width, style in (
        (truth, palette.TRUE, 7.0, "-"),
        (value, palette.YOURS, 2.8, "--"),
    ):
        nodes = [u for u in (path or [])[:MOST_STEPS] if 0 <= u < len(places)]
        for u, v in zip(nodes[:-1], nodes[1:]):
            for artist in graphs.draw_link(
                places[u], places[v], ax, colour, arrow=True, width=width, gap=11.0
            ):
                artist.set(linestyle=style, zorder=4 if style == "-" else 5)


def draw_pointer(
    places: Value, p: int, u: int, ax: Axes, colour: str, style: str, *, width: float = 2.8
) -> None:
    """Draw an arrow from a parent to its child."""
    from ....figures import graphs

    for artist in graphs.draw_link(
        places[p], places[u], ax, colour, arrow=True, width=width, gap=12.0, bend=0.12
    ):
        artist.set(linestyle=style, zorder=4)


def draw_label(places: Value, u: int, text: str, ax: Axes, colour: str) -> None:
    """Write a label outside the circle of nodes, unless there are too many nodes for labels."""
    from ....figures import graphs

    if not text or len(places) > MOST_LABELS:
        return
    x, y = places[u] / np.sqrt((places[u] * places[u]).sum())
    side = "left" if x > 0.3 else "right" if x < -0.3 else "center"
    graphs.write_beside(places[u], text, ax, (18 * x, 24 * y - 5), colour, side)


def draw_answer_note(value: object, ax: Axes) -> None:
    """Write the student's answer in the corner, shortened to 60 characters."""
    from ....figures import palette, plane

    text = (
        get_message("picture.no_answer")
        if value is None
        else get_message("picture.yours", value=format_value(value))
    )
    plane.corner_note(text if len(text) <= 60 else text[:57] + "...", ax, colour=palette.YOURS)


def finish_picture(exercise: Exercise, case: Case, ax: Axes) -> None:
    """Hide the axes, since positions mean nothing here, and set the title."""
    from ....figures import plane

    ax.set_axis_off()
    plane.title(exercise.message(f"pictures.{case.kind}"), ax)
