"""Planners for a car: trees and roadmaps of random drives, and A* over cells of poses."""
