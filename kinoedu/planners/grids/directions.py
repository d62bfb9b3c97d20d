"""The eight moves of a grid: the straight ones first, then the diagonal ones."""

from ...compiled import callable_from_compiled

# west, east, south, north, southwest, southeast, northwest, northeast
COLUMN_STEP = (-1, 1, 0, 0, -1, 1, -1, 1)
ROW_STEP = (0, 0, -1, 1, -1, -1, 1, 1)
STRAIGHT = 4  # moves below this number are straight
SQRT2 = 2.0**0.5  # the length of a diagonal move


@callable_from_compiled
def moves_between(a: int, b: int, columns: int) -> tuple[int, int]:
    """How many columns and rows node b is from node a."""
    # the halves keep a product from rounding below a whole row; a division takes ten times as long
    per_row = 1.0 / columns
    up = int((b + 0.5) * per_row) - int((a + 0.5) * per_row)
    return b - a - up * columns, up
