"""The board of a tree that is rewired."""
