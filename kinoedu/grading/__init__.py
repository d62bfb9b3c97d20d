"""Grading: submissions are run where they can do no harm, and judged where they are not.

`submissions` finds out what is whose, `sandbox` and `inside` run it, `asking` hears what comes out,
`grading` judges one, and `running` a whole class.
"""
