"""Outcomes kept in a folder, a file for each run, each written whole or not at all: what was
stopped can be gone on with.
"""

import json
import os
import tempfile
from pathlib import Path

from ..support.whole_files import written_whole
from .cells import NOT_RUN, OUT_OF_TIME, Cell, Outcome


class Store:
    """The outcomes in a folder; without a folder there are none, and none are kept. Raises OSError
    where it cannot be written.
    """

    def __init__(self, folder: str | os.PathLike[str] | None) -> None:
        self.folder = None if folder is None else Path(folder) / "runs"
        if self.folder is not None:
            self.folder.mkdir(parents=True, exist_ok=True)
            tempfile.TemporaryFile(dir=self.folder).close()

    def read(self, cell: Cell) -> Outcome | None:
        """The outcome of a run made before; None where there is none, it is damaged, or the run had
        less time than it has now.
        """
        if self.folder is None:
            return None
        try:
            outcome = Outcome(
                **json.loads((self.folder / f"{cell.key}.json").read_text(encoding="utf-8"))
            )
        except (OSError, ValueError, TypeError):
            return None
        return (
            None if outcome.status == OUT_OF_TIME and outcome.seconds < cell.time_limit else outcome
        )

    def write(self, cell: Cell, outcome: Outcome) -> None:
        """Keep an outcome; a run that was not run is tried again another time. Raises OSError."""
        if self.folder is not None and outcome.status != NOT_RUN:
            with written_whole(self.folder / f"{cell.key}.json") as part:
                part.write_text(json.dumps(outcome._asdict()), encoding="utf-8")
