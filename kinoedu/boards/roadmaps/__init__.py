"""Boards of roadmaps: their growth and their quality."""
