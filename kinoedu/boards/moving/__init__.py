"""Boards of moving obstacles and of obstacles at uncertain places."""
