"""Judging: a student's functions run in the sandbox, and their answers are judged outside it."""
