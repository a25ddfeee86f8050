"""The inputs of an axis: home switch, limit switches, amplifier fault, index, auxiliary and user inputs.

They are digital channels. A MultiFlex has four an axis from channel 17 on, the limits second and third (two telescope
axes are wired so); that home is the first and the amplifier fault the fourth is inferred. Where the inputs of axes
beyond the fourth are, behind the outputs, and the auxiliary and user inputs, is our choice. The switches of the
machine file, home and travel, are seen without a channel too, and the index input is where the encoder has a mark.
"""

from __future__ import annotations

from motionlang.controller.faults import LIMIT_FORWARD, LIMIT_REVERSE

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mccl.axis.axis import AxisState
    from motionlang.mccl.runtime.board import Board

FIRST, PER_AXIS, LAST_AXIS, BEYOND = 17, 4, 4, 49
ORDER = ("home", "limit_plus", "limit_minus", "amplifier_fault")
# Inputs that have one channel an axis, counted from here.
SINGLE = {"auxiliary": 200, "user_1": 216, "user_2": 232}
# Limit switches that the machine file gives by their position, by the fault of the controller.
SWITCHES = {"limit_plus": LIMIT_FORWARD, "limit_minus": LIMIT_REVERSE}
# Half the width of an index mark, counts.
MARK = 0.5
INFINITY = float("inf")
# Bit of LM that says the limit switches are closed until tripped.
INVERTED = 128


def channel_of(axis: int, name: str) -> int:
    """The channel of an axis's input."""
    if name in SINGLE:
        return SINGLE[name] + axis
    first = FIRST + PER_AXIS * (axis - 1) if axis <= LAST_AXIS else BEYOND + PER_AXIS * (axis - LAST_AXIS - 1)
    return first + ORDER.index(name)


def is_active(board: Board, axis: AxisState, name: str) -> bool:
    """Whether the input is on, in terms of logic; an input that nothing drives is off whatever its polarity."""
    a = board.controller.axes[axis.number]
    if name == "home" and board.controller.is_on_home_switch(axis.number):
        return True
    bit = SWITCHES.get(name)
    if bit is not None and any(each.bit == bit and each.physical and each.passed for each in a.limits):
        return True
    return is_channel_active(board, axis, name)


def is_channel_active(board: Board, axis: AxisState, name: str) -> bool:
    """The same, of the channel of the input alone."""
    channel = channel_of(axis.number, name)
    if not board.is_driven(channel):
        return False
    on = (board.controller.input(channel) != 0) is not (channel in board.low_true)
    if name.startswith("limit"):
        return on is not bool(axis.limit_mode & INVERTED)
    return on


def index_input(board: Board, axis: AxisState) -> tuple[bool, float]:
    """Whether the encoder is on one of its marks, and until when that is so if nothing else happens."""
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
    """The edges of the marks on either side of a place on none; `mark` is the nearer one."""
    low = mark if mark < here else mark - every
    return low + MARK, low + every - MARK
