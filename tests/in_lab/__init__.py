"""Boards and lessons in a real JupyterLab: one page of it for all files."""
