"""The planners' board: a problem to drag, planned anew, raced, or planned by a reader's own
planner.
"""
