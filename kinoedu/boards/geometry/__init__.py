"""Boards of geometry: distances, samples, the sweep line, C-obstacles in the plane and in 3-D."""
