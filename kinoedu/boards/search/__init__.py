"""The board of searches on graphs and grids."""
