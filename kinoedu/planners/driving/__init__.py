"""Planners for a car: trees and roadmaps of drives, and A* over cells of poses."""
