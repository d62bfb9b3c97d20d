"""Planners for a robot that sees no farther than its sensor."""
