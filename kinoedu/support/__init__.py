"""Tools without robotics: time limits, progress, completed futures, safe reading and writing."""
