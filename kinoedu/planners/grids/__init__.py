"""Planners on grids laid over the plane."""
