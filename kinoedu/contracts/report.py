"""What a check found: promises that were kept and promises that were broken, in plain words."""

from dataclasses import dataclass
from typing import NamedTuple

MOST = 3  # cases that are printed for each promise; `where` has all


class Finding(NamedTuple):
    """One promise, and where it was broken.

    Attributes
    ----------
    name : a short name, such as "free".
    promise : the promise in words.
    tried : in how many cases it was tried; 0 where none came to it.
    where : the cases in which it was broken, each with what happened.
    """

    name: str
    promise: str
    tried: int
    where: tuple[str, ...] = ()

    @property
    def kept(self) -> bool:
        """Whether it was tried and never broken."""
        return self.tried > 0 and not self.where

    @property
    def lines(self) -> list[str]:
        """The finding as lines of text."""
        mark = "broken" if self.where else "kept" if self.tried else "-"
        cases = [f"            {case}" for case in self.where[:MOST]]
        more = len(self.where) - MOST
        return [
            f"  {mark:<7} {self.promise}",
            *cases,
            *([f"            and {more} more"] if more > 0 else []),
        ]


@dataclass(frozen=True, eq=False, repr=False)
class Report:
    """The result of a check.

    Attributes
    ----------
    name : of what was checked.
    findings : one for each promise, in a fixed order.
    notes : what is worth knowing and breaks no promise.
    """

    name: str
    findings: tuple[Finding, ...]
    notes: tuple[str, ...] = ()

    @property
    def passed(self) -> bool:
        """Whether no promise was broken."""
        return not self.broken

    @property
    def broken(self) -> tuple[str, ...]:
        """The names of the broken promises."""
        return tuple(finding.name for finding in self.findings if finding.where)

    def __getitem__(self, name: str) -> Finding:
        return {finding.name: finding for finding in self.findings}[name]

    def __repr__(self) -> str:
        tried = [finding for finding in self.findings if finding.tried]
        kept = sum(finding.kept for finding in tried)
        return "\n".join(
            [
                f"{self.name}: {kept} of {len(tried)} promises kept",
                *(line for finding in self.findings for line in finding.lines),
                *(f"  note    {note}" for note in self.notes),
            ]
        )
