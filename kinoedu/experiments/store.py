"""Outcomes in a folder, one file for each run, written atomically, to resume an experiment."""

import json
import os
import tempfile
from pathlib import Path

from ..support.whole_files import written_whole
from .cells import FOUND, NO_PATH, OUT_OF_TIME, WRONG, Cell, Outcome

STORED = (FOUND, NO_PATH, WRONG, OUT_OF_TIME)  # what could not be run is tried again


class Store:
    """The outcomes in a folder; without a folder nothing is stored.

    Raises
    ------
    OSError
        Where the folder cannot be written.
    """

    def __init__(self, folder: str | os.PathLike[str] | None) -> None:
        self.folder = None if folder is None else Path(folder) / "runs"
        if self.folder is not None:
            self.folder.mkdir(parents=True, exist_ok=True)
            tempfile.TemporaryFile(dir=self.folder).close()

    def read(self, cell: Cell) -> Outcome | None:
        """Outcome of an earlier run, or None.

        None stands for a missing or damaged file, for a run that was stopped after less time than
        it has now, and for one that took longer than that.
        """
        if self.folder is None:
            return None
        try:
            text = (self.folder / f"{cell.key}.json").read_text(encoding="utf-8")
            outcome = Outcome(**json.loads(text))
        except (OSError, ValueError, TypeError, RecursionError):
            return None
        if outcome.status not in STORED or not has_kinds(outcome):
            return None
        if outcome.status == OUT_OF_TIME:
            return outcome if outcome.seconds >= cell.time_limit else None
        return outcome if outcome.seconds <= cell.time_limit else None

    def write(self, cell: Cell, outcome: Outcome) -> None:
        """Store an outcome, except of a cell that could not be run. Raises OSError."""
        if self.folder is not None and outcome.status in STORED:
            with written_whole(self.folder / f"{cell.key}.json") as part:
                part.write_text(json.dumps(outcome._asdict()), encoding="utf-8")


def has_kinds(outcome: Outcome) -> bool:
    """Whether every value of an outcome has the kind that it is written with."""
    counts = (outcome.motions, outcome.places, outcome.nodes, outcome.iterations)
    return (
        all(isinstance(text, str) for text in (outcome.status, outcome.reason, outcome.path))
        and all(isinstance(x, int | float) for x in (outcome.cost, outcome.seconds))
        and all(count is None or isinstance(count, int) for count in counts)
    )
