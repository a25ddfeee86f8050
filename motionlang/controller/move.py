"""A move: what was asked for, by which line, and what became of it."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.profile import Profile


class Move:
    """One entry of the move buffer and, once started, of the controller's log.

    `target` is the end point in counts, fixed when the move is loaded. `profile` and `start_time` are set when it
    starts. `ended` is "" for a move that ran out by itself, else what cut it short: "stop", "cancel", "fault",
    "retarget". `offset` is how far the axis's zero was moved while the move ran: the profile stays as planned.
    """

    __slots__ = (
        "axis",
        "command",
        "ended",
        "line",
        "offset",
        "profile",
        "released",
        "scale",
        "start_time",
        "target",
        "zero",
    )

    def __init__(self, axis: int, command: str, line: int, target: float) -> None:
        self.axis, self.command, self.line, self.target = axis, command, line, target
        self.released = False
        self.start_time = 0.0
        self.profile: Profile | None = None
        self.scale = 1.0
        self.zero = 0.0
        self.ended = ""
        self.offset = 0.0
