"""Planners for worlds with moving obstacles."""
