"""Complete planners, which find a path whenever there is one: by cells, and by visibility."""
