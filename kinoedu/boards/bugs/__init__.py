"""The board of the bugs."""
