"""Pictures as files, written whole or not at all, without a display."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from pathlib import Path
from textwrap import fill
from typing import Any

from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from ..errors import UnknownFormat
from ..problems import Plan
from ..support.whole_files import written_whole
from . import palette
from .drawing import axes_for, draw_plan, figure_size


def save_plan(plan: Plan, path: str | os.PathLike[str], *, dpi: int = 120) -> None:
    """Draw a plan into a file whose name ends in .png, .svg or .pdf.

    Raises
    ------
    UnknownFormat, OSError
        As `save_figure`.
    """
    figure = Figure(figsize=figure_size(plan.problem.world), layout="constrained")
    FigureCanvasAgg(figure)
    draw_plan(plan, axes_for(plan.problem.world, figure.add_subplot()))
    save_figure(figure, path, dpi=dpi)


def save_panels(
    panels: Sequence[Callable[[Axes], Any]],
    path: str | os.PathLike[str],
    *,
    size: tuple[float, float],
    title: str,
    dpi: int = 120,
) -> None:
    """Draw panels side by side, with one y axis and one title, into a file.

    Parameters
    ----------
    path : a file name that ends in .png, .svg or .pdf.
    size : of each panel, in inches.

    Raises
    ------
    UnknownFormat, OSError
        As `save_figure`.
    """
    figure = Figure(figsize=(size[0] * len(panels), size[1]), layout="constrained")
    FigureCanvasAgg(figure)
    for draw, ax in zip(panels, figure.subplots(1, len(panels), squeeze=False, sharey=True)[0]):
        draw(ax)
    figure.suptitle(fill(title, int(10 * size[0] * len(panels))), fontsize=palette.TEXT_SIZE + 1)
    save_figure(figure, path, dpi=dpi)


def save_figure(figure: Figure, path: str | os.PathLike[str], *, dpi: int) -> None:
    """Write a figure into a file, whole or not at all.

    Raises
    ------
    UnknownFormat
        Where the file name extension is not that of a picture.
    OSError
        Where the file cannot be written.
    """
    file = Path(path)
    kind = file.suffix[1:].lower()
    if kind not in figure.canvas.get_supported_filetypes():
        got = file.suffix or "no ending"
        raise UnknownFormat(f"{file}: a picture ends in .png, .svg or .pdf, got {got}")
    with written_whole(file) as part:
        figure.savefig(part, format=kind, dpi=dpi)
