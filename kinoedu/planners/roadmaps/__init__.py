"""Planners that build a roadmap once and search it: PRM and its kin, and what a roadmap is
worth.
"""
