"""Gradescope's list of who handed in which folder: submission_metadata.yml."""

from collections.abc import Iterator
from typing import Any, NamedTuple


class Submitter(NamedTuple):
    """A student in the list: the id, which is a number, an address or a name, and the name."""

    id: str
    name: str


def read_submitters(data: bytes) -> dict[str, Submitter]:
    """The first submitter of each folder in the list; folders without one are left out.

    All values are read as text, so that an id keeps its leading zeros.
    """
    import yaml

    try:
        entries = yaml.load(data, Loader=yaml.BaseLoader)
    except (yaml.YAMLError, ValueError, RecursionError):
        return {}
    return dict(find_submitters(entries)) if isinstance(entries, dict) else {}


def find_submitters(entries: dict[Any, Any]) -> Iterator[tuple[str, Submitter]]:
    """Yield each folder that has a submitter with a name, and the first of them."""
    for folder, entry in entries.items():
        several = entry.get(":submitters") if isinstance(entry, dict) else None
        first = several[0] if isinstance(several, list) and several else None
        if isinstance(first, dict):
            sid, address, name = (read_word(first.get(key)) for key in (":sid", ":email", ":name"))
            if any((sid, address, name)):
                yield str(folder), Submitter(sid or address or name, name)


def read_word(value: Any) -> str:
    """A value as text; empty where YAML says that there is none."""
    return value if isinstance(value, str) and value not in ("~", "null") else ""
