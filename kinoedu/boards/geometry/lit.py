"""The lines of the sweep that its board shows as they run."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from ...decomposition import Step, sweep
from ...decomposition.crossing import handle_event
from ...decomposition.trapezoidation import drain, edges_on_line
from ...worlds.polygon_world import PolygonWorldRecord
from ..tracing.code_run import CodeRun, Look, trace_lines


def trace_sweep(
    world: PolygonWorldRecord, steps: Sequence[Step], names: dict[tuple[float, ...], int]
) -> CodeRun:
    """The lines that handle the events of a sweep; `names` are the numbers of the edges."""
    met = np.cumsum([len(step.vertices) for step in steps])

    def list_status(state: Any) -> list[int]:
        rows = state.ends[edges_on_line(state.nodes, state.sides)]
        return [names.get(tuple(row), -1) for row in rows.tolist()]

    look = Look(
        {"p": "(float(x), float(y))", "status": "list_status(sweep)"},
        names={"list_status": list_status, "count": lambda n: np.searchsorted(met, n, "right")},
        colours={"p": "path"},
        progress="count(now)",
        hidden=("ends",),
    )
    return trace_lines(handle_event, look, lambda _: list(sweep(world)), drain)
