"""Plots of an experiment: for each problem medians, fractions of runs, and costs over nodes."""

import os
import re
from functools import partial
from pathlib import Path

from ..messages import get_message
from .table import Table


def save_plots(table: Table, folder: str | os.PathLike[str]) -> list[Path]:
    """Draw a table into PNG files of a folder.

    Returns
    -------
    list of Path
        The files.

    Raises
    ------
    OSError
    """
    # imported here, since only plots need matplotlib
    from ..figures import draw_convergence, draw_ecdf, draw_medians, save_panels

    saved: list[Path] = []
    for number, problem in enumerate(table.problems(), start=1):
        runs = table.of(problem)
        bars = [
            partial(draw_medians, runs.values(what), label=get_message(f"comparisons.{what}"))
            for what in ("cost", "motions", "seconds")
        ]
        shares = [
            partial(draw_ecdf, runs.values(what), label=get_message(f"comparisons.{what}"))
            for what in ("cost", "seconds")
        ]
        growth = [partial(draw_convergence, runs.growth(), label=get_message("comparisons.cost"))]
        safe = re.sub(r"[^\w-]+", "_", problem)[:50]  # the number keeps files apart
        height = 1.6 + 0.55 * len(runs.values("cost"))
        for kind, panels, size in (
            ("medians", bars, (6.4, height)),
            ("ecdf", shares, (7.6, 4.8)),
            ("growth", growth, (8.0, 4.8)),
        ):
            if runs.values("cost") and (kind != "growth" or runs.growth()):
                saved.append(Path(folder) / f"{number}_{safe}_{kind}.png")
                save_panels(
                    panels,
                    saved[-1],
                    size=size,
                    title=get_message(f"comparisons.{kind}", problem=problem),
                )
    return saved
