"""Exports: grades for other programs, and the autograder for Gradescope."""
