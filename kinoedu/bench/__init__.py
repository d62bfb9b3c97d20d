"""The table of speed measurements: benchmark scripts, run one by one, and their results."""

from .pages import as_markdown, as_table, totals
from .peers import install_peer, named_peers
from .pictures import PICTURES, draw_folder
from .ratios import Ratio, append_ratios, read_ratios
from .rows import BENCHMARKS, Row, read_rows, select_rows
from .running import Outcome, run_row
from .surroundings import load, surroundings

__all__ = [
    "BENCHMARKS",
    "PICTURES",
    "Outcome",
    "Ratio",
    "Row",
    "append_ratios",
    "as_markdown",
    "as_table",
    "draw_folder",
    "install_peer",
    "load",
    "named_peers",
    "read_ratios",
    "read_rows",
    "run_row",
    "select_rows",
    "surroundings",
    "totals",
]
