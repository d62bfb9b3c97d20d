"""Collecting: which file is whose, and what a submission's cells are; nothing of it is run."""
