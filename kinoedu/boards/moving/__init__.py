"""Boards of obstacles that move, and of those whose places are uncertain."""
