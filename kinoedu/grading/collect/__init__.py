"""Collecting: find whose each file is, and read the cells of a submission; nothing is run."""
