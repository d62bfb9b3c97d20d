"""Assignments: the questions of one, and the secret from which hidden cases are drawn."""
