"""Planners that find a path whenever there is one: by cells, and by sight."""
