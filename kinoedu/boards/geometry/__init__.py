"""Boards of the geometry of the plane: nearest points, samples, sweep lines, slides and solids."""
