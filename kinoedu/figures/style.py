"""The style of figures in a notebook: the course's colours and sizes, and pictures that are sharp.

`kinoedu.figures` applies it when it is imported in a notebook; scripts are not touched. What a
reader has set stays.
"""

import base64
import io
import sys
from typing import Any

import matplotlib as mpl
import numpy as np
from cycler import cycler
from matplotlib.figure import Figure
from numpy.typing import NDArray
from PIL import Image

from . import palette

Levels = NDArray[np.int64]  # (n, 3): red, green and blue, from 0 to 255
Numbers = NDArray[np.uint32]  # colours as 0xRRGGBB
INLINE = ("inline", "module://matplotlib_inline.backend_inline")
SHARP = 2  # pixels of a picture for one of the page
COLOURS = 256  # of a stored picture; one of more than MANY keeps all of them
MANY = 2**16
FAR = 64  # levels by which a colour may change, but for a share of RIMS of the pixels
RIMS = 0.002
TOGETHER = 4096  # colours that are compared at once
LEVEL = 8  # of compression: files are 4 % larger than with 9, in less than half the time

SETTINGS: dict[str, Any] = {
    "font.size": palette.TEXT_SIZE,
    "axes.titlesize": palette.TEXT_SIZE + 1,
    "axes.labelsize": palette.TEXT_SIZE,
    "xtick.labelsize": palette.TEXT_SIZE - 1,
    "ytick.labelsize": palette.TEXT_SIZE - 1,
    "legend.fontsize": palette.TEXT_SIZE - 1,
    "axes.prop_cycle": cycler(color=palette.METHODS),
    "boxplot.medianprops.color": palette.METHODS[1],
    "image.cmap": "cividis",
    "grid.color": palette.GRID["color"],
    "figure.dpi": 72.0,
}


def apply_style() -> None:
    """Apply the style to the notebook that runs, if one does."""
    shell = running_shell()
    if shell is None or mpl.get_backend().lower() not in INLINE:
        return
    now: Any = mpl.rcParams
    default: Any = mpl.rcParamsDefault
    now.update({name: value for name, value in SETTINGS.items() if now[name] == default[name]})
    from matplotlib_inline.backend_inline import InlineBackend

    if set(InlineBackend.instance().figure_formats) == {"png"}:
        shell.display_formatter.formatters["image/png"].for_type(Figure, print_sharp)


def running_shell() -> Any:
    """The IPython shell, or None without one."""
    ipython = sys.modules.get("IPython")
    return None if ipython is None else ipython.get_ipython()


def print_sharp(figure: Figure) -> tuple[str, dict[str, int | str]] | None:
    """A figure as a PNG in base64, and the size at which it is to be shown, with its alt text.

    None for a figure without axes.
    """
    if not figure.axes and not figure.lines:
        return None
    from IPython.core.pylabtools import print_figure

    dpi = SHARP * figure.dpi
    data: Any = print_figure(figure, fmt="png", dpi=dpi, pil_kwargs={"compress_level": 0})
    picture = keep_few_colours(Image.open(io.BytesIO(data)).convert("RGB"))
    width, height = (size // SHARP for size in picture.size)
    about: dict[str, int | str] = {"width": width, "height": height}
    if alt := describe_figure(figure):
        about["alt"] = alt
    return base64.b64encode(as_png(picture)).decode("ascii"), about


def describe_figure(figure: Figure) -> str:
    """A text in place of a figure: its titles, in one line.

    >>> figure = Figure()
    >>> _ = figure.add_subplot().set_title("Two arms\\nwith one tip")
    >>> describe_figure(figure)
    'Two arms with one tip'
    """
    titles = [figure.get_suptitle(), *(ax.get_title() for ax in figure.axes)]
    return "; ".join(" ".join(title.split()) for title in titles if title.strip())


def keep_few_colours(picture: Image.Image) -> Image.Image:
    """A picture with its most frequent colours only: its file is about a third of the size.

    The frequent colours are kept exactly; those of rims become the nearest of them. Where this
    would change a whole part of the picture, a smooth shade say, all colours give way a little.
    """
    found, counts = np.unique(number_colours(picture), return_counts=True)
    if len(found) > MANY:
        return picture
    frequent = found[np.argsort(-counts, kind="stable")[:COLOURS]]
    kept = use_colours(picture, levels_of(frequent))
    apart = np.asarray(kept.convert("RGB"), int) - np.asarray(picture, int)
    is_like_it = (np.abs(apart).max(axis=2) > FAR).mean() < RIMS
    return kept if is_like_it else picture.quantize(COLOURS)


def use_colours(picture: Image.Image, colours: Levels) -> Image.Image:
    """A picture with each colour replaced by the nearest of at most 256, levels (n, 3)."""
    numbers = number_colours(picture)
    found = np.unique(numbers)
    nearest = np.empty(2**24, np.uint8)  # of each colour that the picture has
    for part in np.split(found, range(TOGETHER, len(found), TOGETHER)):
        apart = ((levels_of(part)[:, None] - colours) ** 2).sum(axis=2)
        nearest[part] = apart.argmin(axis=1)
    small = Image.fromarray(nearest[numbers])
    small.putpalette(colours.ravel().tolist())
    return small


def as_png(picture: Image.Image) -> bytes:
    """A picture as a small PNG file."""
    stream = io.BytesIO()
    picture.save(stream, "png", compress_level=LEVEL)
    return stream.getvalue()


def number_colours(picture: Image.Image) -> Numbers:
    """The colour of each pixel as a number, 0xRRGGBB, shape (height, width)."""
    red, green, blue = np.moveaxis(np.asarray(picture, np.uint32), 2, 0)
    return (red << 16) | (green << 8) | blue


def levels_of(numbers: Numbers) -> Levels:
    """The levels of colours 0xRRGGBB, shape (n, 3)."""
    return np.column_stack([numbers >> 16, (numbers >> 8) & 255, numbers & 255]).astype(np.int64)
