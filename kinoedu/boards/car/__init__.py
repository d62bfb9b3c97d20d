"""Boards of the car and of its curves."""
