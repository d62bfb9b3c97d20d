"""The largest size of a terrain."""

from pathlib import Path

from ..errors import SceneTooLarge, UnreadableScene

MAX_CELLS = 25_000_000  # 5,000 x 5,000; reading them takes about 400 MB


def check_size(where: str | Path, columns: int, rows: int) -> None:
    """Check the size of a terrain before anything is decoded; `where` begins the message.

    Raises
    ------
    UnreadableScene
        Where a side is not positive.
    SceneTooLarge
        Where there are more than `MAX_CELLS` cells.
    """
    if columns < 1 or rows < 1:
        raise UnreadableScene(
            f"{where}: expected at least one column and one row, got {columns} x {rows}"
        )
    if columns * rows > MAX_CELLS:
        raise SceneTooLarge(
            f"{where}: expected at most {MAX_CELLS:,} cells, got {columns:,} x {rows:,}; shrink it"
        )
