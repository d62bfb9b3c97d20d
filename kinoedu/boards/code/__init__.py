"""The board that shows the code of a function beside a picture of its variables."""
