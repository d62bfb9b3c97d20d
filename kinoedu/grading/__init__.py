"""Grading, by stage. Students' programs run where they can do no harm, and are judged elsewhere.

`assignments` knows the questions, `collect` reads what was handed in, `sandbox` runs it, `judge`
compares the answers with the truth, `report` writes the pages, and `export` the tables for other
programs. `class_grading` takes a whole class through all stages.
"""
