"""Challenges of lesson 4, on `search_board`."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

from ...graphs import Expansion, extract_path
from ..core.challenge import Answer, posed
from ..search.search import SearchBoard, heuristic_to, list_expansions

DETOUR, SAVING = 3.0, 3.0


@posed
def depth_first_detour(board: SearchBoard, kept: dict[str, Any]) -> Answer:
    """The path of the depth-first search is three times as long as the shortest."""
    deep, short = (cost_of(board, run(board, name)) for name in ("dfs", "dijkstra"))
    if short == 0.0 or deep is None or short is None:
        return "no_way", {}
    values = {"deep": f"{deep:.3g}", "short": f"{short:.3g}", "ratio": f"{deep / short:.2g}"}
    return "reached" if deep >= DETOUR * short else "not_yet", values


@posed
def astar_saves(board: SearchBoard, kept: dict[str, Any]) -> Answer:
    """A* expands a third of the nodes that Dijkstra's algorithm expands."""
    guided, blind = (run(board, name) for name in ("astar", "dijkstra"))
    if cost_of(board, blind) in (None, 0.0):
        return "no_way", {}
    values = {"guided": len(guided), "blind": len(blind)}
    return "reached" if SAVING * len(guided) <= len(blind) else "not_yet", values


def run(board: SearchBoard, search: str) -> list[Expansion]:
    """The expansions of a search between the ends that the board shows."""
    goal = board.ends[1]
    guess = heuristic_to(board.graph, goal) if search == "astar" else None
    return list_expansions(board.graph, search, *board.ends, guess)


def cost_of(board: SearchBoard, moments: list[Expansion]) -> float | None:
    """The cost of the path that a search has found, or None."""
    goal = board.ends[1]
    if moments[-1].node != goal:
        return None
    path = extract_path(moments[-1].parent, goal).tolist()
    return float(sum(board.graph.weight(u, v) for u, v in pairwise(path)))
