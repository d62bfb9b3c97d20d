"""Runs of a function line by line: what its variables and its questions were, as layers."""
