"""Travel limits and the amplifier-fault input of an axis: causes and effects.

If the machine file has switches, they are the hard limits; the channels of the axis trip them as well. A hard
or soft limit has no effect until LN enables it. A trip sets the trip bit and the motor-error bit, and the
axis then accepts no motion command until MN.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.controller.faults import (
    ERROR_INPUT,
    FOLLOWING_ERROR,
    LIMIT_FORWARD,
    LIMIT_REVERSE,
    SOFT_LIMIT_FORWARD,
    SOFT_LIMIT_REVERSE,
)
from motionlang.kernel.controller.triggers.conditions import Undirected
from motionlang.kernel.controller.triggers.limit import Limit
from motionlang.kernel.mccl.axis import flags
from motionlang.kernel.mccl.axis.axis import AxisState
from motionlang.kernel.mccl.axis.inputs import ORDER, SWITCHES, channel_of, is_channel_active

if TYPE_CHECKING:
    from motionlang.kernel.mccl.runtime.board import Board

HARD_PLUS, HARD_MINUS, SOFT_HIGH, SOFT_LOW = 1, 2, 4, 8
ALL = 15
_HARD_ACTIONS = {0: "off", 1: "abort", 2: "stop"}
_SOFT_ACTIONS = {0: "off", 4: "abort", 8: "stop"}
# From bits of LN and LF to the enable bits of the status word.
_ENABLE_BITS = {
    HARD_PLUS: flags.HARD_PLUS_ENABLED,
    HARD_MINUS: flags.HARD_MINUS_ENABLED,
    SOFT_HIGH: flags.SOFT_HIGH_ENABLED,
    SOFT_LOW: flags.SOFT_LOW_ENABLED,
}
# From bits of the controller's faults to bits of the status word.
_FAULT_BITS = {
    LIMIT_FORWARD: flags.HARD_PLUS_TRIPPED,
    LIMIT_REVERSE: flags.HARD_MINUS_TRIPPED,
    SOFT_LIMIT_FORWARD: flags.SOFT_HIGH_TRIPPED,
    SOFT_LIMIT_REVERSE: flags.SOFT_LOW_TRIPPED,
    FOLLOWING_ERROR: flags.FOLLOWING_ERROR,
    ERROR_INPUT: flags.AMPLIFIER_FAULT,
}


class AxisLimits:
    """The four limits of one axis, and its amplifier-fault input.

    The board's reset of the axis, which follows, disables them.
    """

    def __init__(self, board: Board, axis: AxisState) -> None:
        self._board, self._axis = board, axis
        self._hard = {HARD_PLUS: self._switch(1, LIMIT_FORWARD), HARD_MINUS: self._switch(-1, LIMIT_REVERSE)}
        self._soft = {
            SOFT_HIGH: self._new(1, SOFT_LIMIT_FORWARD),
            SOFT_LOW: self._new(-1, SOFT_LIMIT_REVERSE),
        }
        self._amplifier = Undirected(board.controller.axes[axis.number], ERROR_INPUT, "off")

    def set_mode(self, mode: int) -> None:
        """Set the effect of a tripped limit (LM)."""
        self._axis.limit_mode = mode
        for limit in self._hard.values():
            limit.action = _HARD_ACTIONS.get(mode & 3, "stop")
        for limit in self._soft.values():
            limit.action = _SOFT_ACTIONS.get(mode & 12, "stop")
        for name in SWITCHES:  # LM may have inverted them
            self.check(name)

    def enable(self, which: int) -> None:
        """Enable limits by their bits in `which` (LN)."""
        for bit, shown in _ENABLE_BITS.items():
            if which & bit:
                self._axis.flags |= shown
                self._limit(bit).enabled = True
        self.set_soft_limits()

    def disable(self, which: int) -> None:
        """Disable limits by their bits in `which` (LF)."""
        for bit, shown in _ENABLE_BITS.items():
            if which & bit:
                self._axis.flags &= ~shown
                self._limit(bit).enabled = False
        self.set_soft_limits()

    def set_soft_limits(self) -> None:
        """Set the enabled soft limits at the positions of HL and LL."""
        axis = self._axis
        for bit, position in ((SOFT_HIGH, axis.soft_high), (SOFT_LOW, axis.soft_low)):
            limit = self._soft[bit]
            limit.set_position(position if limit.enabled else None)

    @property
    def watches_amplifier(self) -> bool:
        """True if the amplifier-fault input switches the motor off."""
        return self._amplifier.enabled

    def watch_amplifier(self, on: bool) -> None:
        """Set whether the amplifier-fault input switches the motor off (FN, FF)."""
        self._amplifier.enabled = on

    def check(self, name: str) -> None:
        """Update the limits after the level or the meaning of an input has changed."""
        active = is_channel_active(self._board, self._axis, name)
        if name == "limit_plus":
            self._hard[HARD_PLUS].set_active(active)
        elif name == "limit_minus":
            self._hard[HARD_MINUS].set_active(active)
        elif name == "amplifier_fault":
            self._amplifier.set_active(active)

    def happened(self) -> None:
        """Set the status bits for a fault that the controller has raised."""
        axis, faults = self._axis, self._board.controller.faults(self._axis.number)
        for bit, shown in _FAULT_BITS.items():
            if faults & bit:
                axis.flags |= shown | flags.MOTOR_ERROR
        axis.running = False

    def _limit(self, bit: int) -> Limit:
        return self._hard[bit] if bit in self._hard else self._soft[bit]

    def _switch(self, sign: int, bit: int) -> Limit:
        """Return the machine's own switch, or create one that only the channel trips."""
        for limit in self._board.controller.axes[self._axis.number].limits:
            if limit.physical and limit.bit == bit:
                return limit
        return self._new(sign, bit, True)

    def _new(self, sign: int, bit: int, physical: bool = False) -> Limit:
        controller, number = self._board.controller, self._axis.number
        return controller.add_limit(number, sign, bit, "off", physical)


class LimitInputs:
    """Updates the limits of an axis when one of its channels changes."""

    def __init__(self, board: Board) -> None:
        self._board = board
        self._names = {channel_of(number, name): (number, name) for number in board.numbers for name in ORDER}
        board.controller.inputs.listeners.append(lambda channel, value: self.check(channel))

    def check(self, channel: int) -> None:
        """Update the limits after the level or polarity of a channel has changed."""
        found = self._names.get(channel)
        if found is None:
            return
        number, name = found
        if name == "home":
            self._board.home_changed(number)
        else:
            self._board.limits[number].check(name)
