"""Grading, by stage. Students' programs run in a sandbox and are judged outside it.

`assignments` defines the questions, `collect` finds and reads the submissions, `sandbox` runs them,
`judge` compares the answers with the reference, `report` writes the pages, and `export` writes
tables for other programs. `class_grading` takes a class through all stages.
"""
