"""The board of a robot that explores."""
