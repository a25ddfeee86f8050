"""The digital inputs of an axis, as channels.

They are home switch, limit switches, amplifier fault, index, auxiliary and user inputs. A MultiFlex has four
channels per axis from channel 17 on. The limits are the second and third, as two telescope axes are wired. We
infer that home is the first and the amplifier fault the fourth. The channels of axes beyond the fourth, which
follow the outputs, and those of the auxiliary and user inputs are our choice. The switches of the machine
file, home and travel, also work without a channel. The index input is on where the encoder has a mark.
"""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.controller.faults import LIMIT_FORWARD, LIMIT_REVERSE
from motionlang.kernel.mccl.axis.axis import AxisState

if TYPE_CHECKING:
    from motionlang.kernel.mccl.runtime.board import Board

FIRST, PER_AXIS, LAST_AXIS, BEYOND = 17, 4, 4, 49
ORDER = ("home", "limit_plus", "limit_minus", "amplifier_fault")
# Inputs with one channel per axis, counted from here.
SINGLE = {"auxiliary": 200, "user_1": 216, "user_2": 232}
# Limit switches that the machine file gives by position, by the fault of the controller.
SWITCHES = {"limit_plus": LIMIT_FORWARD, "limit_minus": LIMIT_REVERSE}
# Half the width of an index mark, counts.
MARK = 0.5
# The bit of LM that makes the limit switches normally closed.
INVERTED = 128


@cache
def channel_of(axis: int, name: str) -> int:
    """Return the channel of an axis's input."""
    if name in SINGLE:
        return SINGLE[name] + axis
    first = FIRST + PER_AXIS * (axis - 1) if axis <= LAST_AXIS else BEYOND + PER_AXIS * (axis - LAST_AXIS - 1)
    return first + ORDER.index(name)


def is_input_of_axis(board: Board, channel: int) -> bool:
    """True if an axis of the board has an input with this channel."""
    return any(channel_of(number, name) == channel for number in board.numbers for name in (*ORDER, *SINGLE))


def is_active(board: Board, axis: AxisState, name: str) -> bool:
    """True if the input is logically on.

    An input that nothing drives is off, whatever its polarity.
    """
    return bool(active_bits(board, axis, {name: 1}))


def active_bits(board: Board, axis: AxisState, bits: dict[str, int]) -> int:
    """Return the bits of the inputs that are on."""
    limits = board.controller.axes[axis.number].limits
    closed = [each.bit for each in limits if each.physical and each.passed] if limits else ()
    at_home = board.controller.is_on_home_switch(axis.number)
    drives = board.drives_inputs
    if not (drives or at_home or closed):
        return 0
    found = 0
    for name, bit in bits.items():
        if (drives and is_channel_active(board, axis, name)) or (
            (name == "home" and at_home) or (closed and SWITCHES.get(name) in closed)
        ):
            found |= bit
    return found


def is_channel_active(board: Board, axis: AxisState, name: str) -> bool:
    """True if the channel of the input is on, regardless of any switch."""
    channel = channel_of(axis.number, name)
    if not board.is_driven(channel):
        return False
    on = (board.controller.input(channel) != 0) is not (channel in board.controller.inputs.active_low)
    if name.startswith("limit"):
        return on is not bool(axis.limit_mode & INVERTED)
    return on


def index_input(board: Board, axis: AxisState) -> tuple[bool, float]:
    """Return True if the encoder is on an index mark, and until when that holds.

    The time is valid if nothing else happens.
    """
    controller, number = board.controller, axis.number
    a = controller.axes[number]
    every = a.index_pitch
    if every <= 0.0:
        return False, INFINITY
    zero = a.datum + a.index_origin
    here = controller.position(number) - zero
    mark = round(here / every) * every
    on = abs(here - mark) <= MARK
    edges = (mark - MARK, mark + MARK) if on else _between(here, mark, every)
    if controller.is_still(number):
        return on, INFINITY
    return on, min(controller.crossing_time(number, zero + edge) for edge in edges)


def _between(here: float, mark: float, every: float) -> tuple[float, float]:
    """Return the edges of the two marks around a position between marks.

    `mark` is the nearer mark.
    """
    low = mark if mark < here else mark - every
    return low + MARK, low + every - MARK
