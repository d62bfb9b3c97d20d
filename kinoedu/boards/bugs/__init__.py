"""The board of bugs and their walks."""
