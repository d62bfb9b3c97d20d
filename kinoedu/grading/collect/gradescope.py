"""Gradescope's list of who handed in which folder: submission_metadata.yml."""

from collections.abc import Iterator
from typing import Any, NamedTuple


class Submitter(NamedTuple):
    """A student in the list: the id, which is a number, an address or a name, and the name."""

    id: str
    name: str


def read_submitters(data: bytes) -> dict[str, list[Submitter]]:
    """The submitters of each folder in the list, several for a group; folders without are left out.

    All values are read as text, so that an id keeps its leading zeros.
    """
    import yaml

    try:
        entries = yaml.load(data, Loader=yaml.BaseLoader)
    except (yaml.YAMLError, ValueError, RecursionError):
        return {}
    return dict(find_submitters(entries)) if isinstance(entries, dict) else {}


def find_submitters(entries: dict[Any, Any]) -> Iterator[tuple[str, list[Submitter]]]:
    """Yield each folder that has submitters with an id, and these."""
    for folder, entry in entries.items():
        several = entry.get(":submitters") if isinstance(entry, dict) else None
        known = map(read_submitter, several if isinstance(several, list) else [])
        if submitters := [one for one in known if one.id]:
            yield str(folder), submitters


def read_submitter(entry: Any) -> Submitter:
    """A submitter, whose id is empty where there is none."""
    fields = entry if isinstance(entry, dict) else {}
    sid, address, name = (read_word(fields.get(key)) for key in (":sid", ":email", ":name"))
    return Submitter(sid or address or name, name)


def read_word(value: Any) -> str:
    """A value as text; empty where YAML says that there is none."""
    return value if isinstance(value, str) and value not in ("~", "null") else ""
