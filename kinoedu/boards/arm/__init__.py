"""Boards of the two-link arm and of its angles."""
