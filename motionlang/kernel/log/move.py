"""A move: its command, its line, and its outcome."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.planners import Profile

if TYPE_CHECKING:
    from motionlang.kernel.controller.queue.action import Action


# Pieces of a profile after which the move continues as a new entry of the log.
MAX_PIECES = 500
# The value of `ended` of a move that continues as another entry.
CONTINUED = "continued"


class LoggedMove:
    """An entry of the move buffer and, once started, of the controller's log.

    `target` is the end point in counts. A relative entry also has the `base` that it was counted from: its
    target moves with the position of the axis when it starts. `profile` and `start_time` are set when it
    starts. `ended` is "" for a complete move. It is "stop", "cancel", "fault" or "retarget" for one cut
    short, or `CONTINUED` if it continues as another entry. `offset` is how far the axis's zero was moved
    during the move: the profile stays as planned. `action` makes it something other than a move to a
    position. `speed` is the speed that it was loaded with; None means the axis's speed when it starts. `rates` are
    its own acceleration and deceleration, `rates_in_force` those of its present plan, counts/s²; `overridden` is true
    if the axis's override multiplies its speed. `chain` is the number of the calls that led to
    its statement, -1 until it is loaded or starts.
    """

    __slots__ = (
        "action",
        "axis",
        "base",
        "chain",
        "command",
        "commanded_speed",
        "ended",
        "id",
        "line",
        "offset",
        "overridden",
        "profile",
        "rates",
        "rates_in_force",
        "released",
        "scale",
        "speed",
        "start_time",
        "target",
        "zero",
    )

    # True if it is superposed on another entry, which continues.
    overlaid = False
    # True if it follows another axis or an encoder.
    follows = False

    def __init__(self, axis: int, command: str, line: int, target: float) -> None:
        self.axis, self.command, self.line, self.target = axis, command, line, target
        self.action: Action | None = None
        self.commanded_speed: float | None = None  # the commanded speed, before its axis's limit, counts/s
        self.base: float | None = None
        self.id = 0
        self.chain = -1
        self.speed: float | None = None
        self.rates: tuple[float | None, float | None] | None = None
        self.rates_in_force: tuple[float, float] | None = None
        self.overridden = False
        self.released = False
        self.start_time = 0.0
        self.profile: Profile | None = None
        self.scale = 1.0
        self.zero = 0.0
        self.ended = ""
        self.offset = 0.0

    def to_user(self, position: float) -> float:
        """Convert a position in counts to user units at the time of the move."""
        return (position - self.zero) / (self.scale or 1.0)

    def size_to_user(self, size: float) -> float:
        """Convert a distance or a speed in counts to user units at the time of the move, without its sign."""
        return abs(size / (self.scale or 1.0))

    def until(self, time: float) -> Profile:
        """Return the motion of the move up to a machine time."""
        assert self.profile is not None
        return self.profile.cut(time - self.start_time)


def keeps_rates(move: LoggedMove | None) -> bool:
    """True if a move uses the rates of its axis, unlike a table or following."""
    return move is None or move.action is None or move.action.keeps_rates
