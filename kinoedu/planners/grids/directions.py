"""The eight moves of a grid: the straight ones first, then the diagonal ones."""

# west, east, south, north, southwest, southeast, northwest, northeast
COLUMN_STEP = (-1, 1, 0, 0, -1, 1, -1, 1)
ROW_STEP = (0, 0, -1, 1, -1, -1, 1, 1)
STRAIGHT = 4  # moves below this number are straight
SQRT2 = 2.0**0.5  # the length of a diagonal move
