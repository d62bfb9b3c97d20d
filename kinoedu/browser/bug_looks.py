"""What the bodies of the bugs say, and how a walk and its plot look."""

from ..compiled import Compiled
from ..planners.bugs import bug0, bug1, bug2, bug2_prelim, bug_base
from .bugs import (
    BugSettings,
    show_bug0,
    show_bug1,
    show_bug2,
    show_bug2_prelim,
    show_bug_base,
)
from .looks import TEXTS, Body, Look, Picture, Say
from .walks import MOST_NAMES, ShownWalk

LETTERS = "abcdef"[:MOST_NAMES]  # the blanks of the names of one point
LISTED = [", ".join(f"{{{letter}}}" for letter in LETTERS[: k + 1]) for k in range(MOST_NAMES)]
NAMES = tuple(Say("bug_board.names", {"names": names}) for names in LISTED)
NAMED = ("which:d", *(f"{letter}:H|L" for letter in LETTERS))
LEGS, NUMBERS = (Say("board.note.walk"),), ("travelled", "distance")
FREE, ALONG = ("tree", 2.5), ("path", 5.0)  # towards the goal; along a wall: colour, width


def walk_looks(prefix: str = "") -> tuple[Look, ...]:
    """A walk in the world, or in its plot."""
    return (
        Look(f"{prefix}free", "edges", *FREE, grows=True, says=LEGS, names=NUMBERS),
        Look(f"{prefix}along", "edges", *ALONG, grows=True, says=LEGS, names=NUMBERS),
    )


def mark_looks(prefix: str = "") -> tuple[Look, ...]:
    """Where walls were hit and left."""
    return (
        Look(f"{prefix}marks", "dots", "contact", 5.0, grows=True),
        Look(f"{prefix}names", "labels", "contact", grows=True, says=NAMES, names=NAMED),
    )


def robot_looks(prefix: str = "") -> tuple[Look, ...]:
    """The robot at each step."""
    return (
        Look(f"{prefix}robot", "dots", "free", 7.5, grows=True, ends=True),
        Look(f"{prefix}robot", "dots", "robot", 6.0, grows=True, ends=True),
    )


AXES = (
    Look("grid", "edges", "outside", 0.7),
    Look("axes", "edges", "ink", 1.5),
    Look("below", "labels", form=".6g"),
    Look("beside", "labels", form=".6g"),
    Look(
        "titles",
        "labels",
        says=(Say("bug_board.distance"), Say("bug_board.way")),
        names=("which:d",),
    ),
)


def walked_body(function: Compiled, name: str, reasons: tuple[str, ...]) -> Body:
    """The body of a bug, with the reasons why it fails, the first of which is empty."""
    reached = Say("bug_board.reached", {"bug": name})
    failed = [Say("bug_board.failed", {"bug": name, "reason": why}) for why in reasons[1:]]
    doing = tuple(Say(f"bug_board.{does}", {"bug": name}) for does in ("free", "along"))
    moments = Look("moments", TEXTS, says=doing, names=("which:d", "travelled:.4g", "distance:.4g"))
    return Body(
        function,
        BugSettings,
        ShownWalk,
        ("length:.4g", "hits:d", "total"),
        (reached, *failed),
        (
            Look("sight", "edges", "ink", 1.0, dash=(2.0, 5.0)),
            *walk_looks(),
            Look("directions", "arrows", "ink", 1.5, grows=True),
            *mark_looks(),
            Look("touched", "edges", "contact", 4.0, grows=True, ends=True),
            Look("feels", "dots", "contact", 9.5, grows=True, ends=True),
            *robot_looks(),
            moments,
        ),
        warns=(Say("bug.start", {"near": ""}), Say("bug.goal"), Say("bug_board.united")),
        beside=Picture(
            (Say("bug_board.nothing"),) * len(reasons),
            (
                *AXES,
                *walk_looks("plotted_"),
                *mark_looks("plotted_"),
                *robot_looks("plotted_"),
                moments,
            ),
        ),
        title=name,
        menu="bug_board.bug",
        unit="bug_board.unit",
    )


ROWS = {
    "bug_base": (show_bug_base, "BugBase", bug_base.REASONS),
    "bug0": (show_bug0, "Bug 0", bug0.REASONS),
    "bug1": (show_bug1, "Bug 1", bug1.REASONS),
    "bug2_prelim": (show_bug2_prelim, "Bug 2.prelim", bug2_prelim.REASONS),
    "bug2": (show_bug2, "Bug 2", bug2.REASONS),
}
REASONS = {key: reasons for key, (_, _, reasons) in ROWS.items()}
WALKED = {key: walked_body(*row) for key, row in ROWS.items()}
