"""The board of RRT*, whose tree is rewired."""
