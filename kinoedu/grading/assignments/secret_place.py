"""The usual place of a course's secret: the user's data folder, outside every repository."""

from pathlib import Path


def default_secret_file() -> Path:
    """The path of the file, which need not exist yet."""
    import platformdirs

    return Path(platformdirs.user_data_dir("kinoedu", appauthor=False)) / "course_secret"
