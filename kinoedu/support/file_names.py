"""Names of files that any disk can hold, made from any text."""

import hashlib
import re

PLAIN = re.compile(r"[a-z0-9][a-z0-9._-]{0,58}[a-z0-9]|[a-z0-9]")
OURS = re.compile(r".*-[0-9a-f]{8}")  # what `file_name` makes of other texts
TAKEN = re.compile(r"(con|nul|aux|prn|com\d|lpt\d)(\..*)?")  # names that Windows reserves


def file_name(text: str) -> str:
    """A name that any disk can hold, and that no other text has.

    >>> file_name("ann"), file_name("../Ann"), file_name("ann "), file_name("con")
    ('ann', 'Ann-eb825571', 'ann-c10969e7', 'con-1143da2b')
    """
    if PLAIN.fullmatch(text) and not TAKEN.fullmatch(text) and not OURS.fullmatch(text):
        return text
    readable = re.sub(r"[^A-Za-z0-9]+", "_", text).strip("_")[:40]
    digest = hashlib.sha256(text.encode("utf-8", "surrogatepass")).hexdigest()
    return f"{readable or 'name'}-{digest[:8]}"
