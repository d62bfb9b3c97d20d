"""Pictures as files, written whole or not at all, without a display."""

import os
from pathlib import Path

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from ..problems import Plan
from ..whole_file import written_whole
from .drawing import axes_for, draw_plan, figure_size


def save_plan(plan: Plan, path: str | os.PathLike[str], *, dpi: int = 120) -> None:
    """Draw a plan into a file whose name ends in .png, .svg or .pdf. Raises OSError where it cannot be written."""
    file = Path(path)
    figure = Figure(figsize=figure_size(plan.problem.world), layout="constrained")
    FigureCanvasAgg(figure)
    draw_plan(plan, axes_for(plan.problem.world, figure.add_subplot()))
    with written_whole(file) as part:
        figure.savefig(part, format=file.suffix[1:].lower(), dpi=dpi)
