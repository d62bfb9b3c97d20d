"""How large a terrain may be."""

from pathlib import Path

from ..errors import SceneTooLarge, UnreadableScene

MAX_CELLS = 25_000_000  # 5,000 x 5,000, which takes some 400 MB to read


def check_size(where: str | Path, columns: int, rows: int) -> None:
    """Refuse, before anything is decoded, a size that no terrain can have; `where` begins the
    message.

    Raises
    ------
    UnreadableScene, SceneTooLarge
        A side is not positive; the cells are more than `MAX_CELLS`.
    """
    if columns < 1 or rows < 1:
        raise UnreadableScene(
            f"{where}: expected at least one column and one row, got {columns} x {rows}"
        )
    if columns * rows > MAX_CELLS:
        raise SceneTooLarge(
            f"{where}: expected at most {MAX_CELLS:,} cells, got {columns:,} x {rows:,}; shrink it"
        )
