"""Boards: problems to play with in a notebook."""

from .explorer import Explorer

__all__ = ["Explorer"]
