"""Planners among obstacles that move."""
