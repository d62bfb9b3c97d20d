"""Where a course's secret is unless its instructor says otherwise: with the user's own data, far
from every repository.
"""

from pathlib import Path


def usual_secret() -> Path:
    """The file; it need not be there yet."""
    import platformdirs

    return Path(platformdirs.user_data_dir("kinoedu", appauthor=False)) / "course_secret"
