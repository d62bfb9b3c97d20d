"""Planners that grow trees: RRT, two trees that meet, and trees whose paths become shortest."""
