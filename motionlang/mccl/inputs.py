"""The inputs of an axis: home switch, limit switches, amplifier fault.

They are digital channels. A MultiFlex has four an axis from channel 17 on, the limits second and third (two telescope
axes are wired so); that home is the first and the amplifier fault the fourth is inferred. Axes beyond the fourth have
no channels of their own there; theirs count on from 1000. The home switch of the machine file is seen without a
channel too.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mccl.axis import AxisState
    from motionlang.mccl.board import Board

FIRST, PER_AXIS, LAST_AXIS, BEYOND = 17, 4, 4, 1000
ORDER = ("home", "limit_plus", "limit_minus", "amplifier_fault")
# Bit of LM that says the limit switches are closed until tripped.
INVERTED = 128


def channel_of(axis: int, name: str) -> int:
    """The channel of an axis's input."""
    first = FIRST if axis <= LAST_AXIS else BEYOND
    return first + PER_AXIS * (axis - 1) + ORDER.index(name)


def is_active(board: Board, axis: AxisState, name: str) -> bool:
    """Whether the input is on, in terms of logic; an input that nothing drives is off whatever its polarity."""
    channel = channel_of(axis.number, name)
    if name == "home" and board.controller.axes[axis.number].home:
        return True
    if not board.is_driven(channel):
        return False
    on = (board.controller.input(channel) != 0) is not (channel in board.low_true)
    if name.startswith("limit"):
        return on is not bool(axis.limit_mode & INVERTED)
    return on
