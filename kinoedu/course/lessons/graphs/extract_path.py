"""The exercise `extract_path`. Bullo & Smith, chapter 2."""

from collections.abc import Iterator

import numpy as np

from .... import graphs
from ....errors import InvalidGraph
from ...exercise import Axes, Case, Slip
from ...outcomes import Answer, Outcome
from ...shapes import Maybe, Record
from ...whole_shapes import Integer
from ...withheld import withheld
from ..shared.graph_slips import followed
from .on_graphs import NODES, GraphExercise
from .pictures import draw_pointers


class ExtractPath(GraphExercise):
    """Follow parents from a goal to its root, and return the nodes from the root to the goal."""

    name = "extract_path"
    kinds = ("root", "tree", "forest", "circle")
    given = Record(parent=NODES, goal=Integer())
    answer = Maybe(NODES)
    shown = staticmethod(graphs.extract_path)
    slips = (
        Slip("reversed", lambda parent, goal: (followed(parent, goal) or [])[::-1] or None),
        Slip("no_goal", lambda parent, goal: shortened(followed(parent, goal), slice(0, -1))),
        Slip("no_root", lambda parent, goal: shortened(followed(parent, goal), slice(1, None))),
        Slip(
            "root_none", lambda parent, goal: None if parent[goal] == -1 else followed(parent, goal)
        ),
        Slip("one_step", lambda parent, goal: [p for p in (parent[goal], goal) if p != -1]),
        Slip(
            "parents",
            lambda parent, goal: [parent[u] for u in followed(parent, goal) or []] or None,
        ),
        Slip(
            "any_circle",
            lambda parent, goal: (
                None
                if any(followed(parent, u) is None for u in range(len(parent)))
                else followed(parent, goal)
            ),
        ),
    )

    @staticmethod
    @withheld
    def reference(parent: list[int], goal: int) -> list[int] | None:
        """Return the library's path, or None where the parents lead to no root."""
        try:
            return [int(u) for u in graphs.extract_path(np.array(parent, np.int64), goal)]
        except InvalidGraph:
            return None

    source = reference

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield a few parents written by hand, then random trees, forests and cycles with tails."""
        for kind, parent, goal in (
            ("root", [-1, 0], 0),
            ("tree", [-1, 0, 1], 2),
            ("tree", [-1, 0, 0, 2], 3),
            ("tree", [2, 0, -1], 1),
            ("forest", [-1, 0, -1, 2], 3),
            ("root", [1, -1, 1], 1),
            ("circle", [1, 0], 0),
            ("circle", [0], 0),
            ("circle", [1, 2, 1, 0], 3),
            ("circle", [-1, 2, 1], 1),
            ("tree", [-1, 0, 3, 2], 1),
        ):
            yield Case(kind, {"parent": parent, "goal": goal})
        yield Case("tree", {"parent": list(range(-1, 59)), "goal": 59})
        for i, n in enumerate((4, 5, 6, 7, 8, 10, 12, 16, 24, 40, 60)):
            for kind in self.kinds:
                parent, goal = (draw_in_company if i % 2 else draw_parents)(kind, n, rng)
                yield Case(kind, {"parent": parent, "goal": goal})

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw an arrow from each parent to its child, the right path and the student's."""
        draw_pointers(
            self, case, outcome.value if isinstance(outcome, Answer) else None, self.truth(case), ax
        )


def shortened(path: list[int] | None, part: slice) -> list[int] | None:
    """Return a part of a path; None stays None."""
    return None if path is None else path[part]


def draw_in_company(kind: str, n: int, rng: np.random.Generator) -> tuple[list[int], int]:
    """Draw parents of n nodes and a goal, as `draw_parents` does, of which some stand apart.

    A tree stands beside a cycle that leads to the goal, and a cycle beside anything else.
    """
    name, size = rng.permutation(n), n - n // 4
    parent, goal = draw_parents(kind, size, rng)
    apart, _ = draw_parents("tree" if kind == "circle" else "circle", n - size, rng)
    joined = [*parent, *(p if p == -1 else p + size for p in apart)]
    renamed = [-1] * n
    for u, p in enumerate(joined):
        renamed[name[u]] = p if p == -1 else int(name[p])
    return renamed, int(name[goal])


def draw_parents(kind: str, n: int, rng: np.random.Generator) -> tuple[list[int], int]:
    """Draw parents of n nodes, numbered at random, and a goal.

    Where the goal is depends on the kind. "root": the root of the only tree. "tree": near the
    end of the only tree. "forest": near the end of the second of two trees. "circle": on a
    cycle or on its tail.
    """
    name, low = rng.permutation(n), n // 2 if kind == "forest" else 0
    parent = [-1] * n
    for i in range(1, n):
        above = int(rng.integers(max(i - 3, low if i > low else 0), i))
        if i != low:
            parent[name[i]] = int(name[i - 1 if kind == "circle" and i < n - 1 else above])
    if kind == "circle":
        parent[name[0]] = int(name[n - 2])
    return parent, int(name[0 if kind == "root" else n - 1 - int(rng.integers(2))])
