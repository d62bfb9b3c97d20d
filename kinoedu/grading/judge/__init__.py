"""Judging: a student's functions are called in the sandbox, and their answers judged outside."""
