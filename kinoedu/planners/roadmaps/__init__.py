"""Planners that build a roadmap and search it, such as PRM, and measures of a roadmap's quality."""
