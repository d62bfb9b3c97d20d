"""Boards of roadmaps: how they grow, and how well they serve."""
