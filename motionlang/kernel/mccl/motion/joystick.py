"""Joysticks: an axis jogs at the gain times the voltage beyond the deadband."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.mccl.axis import flags
from motionlang.kernel.mccl.axis.axis import AxisState
from motionlang.kernel.mccl.axis.motor import check_on
from motionlang.kernel.mccl.axis.volts import volts

if TYPE_CHECKING:
    from motionlang.kernel.mccl.runtime.board import Board


class Joysticks:
    """The joysticks of all axes: the joystick of an axis is the input with its number."""

    def __init__(self, board: Board) -> None:
        self._board = board
        self._lines: dict[int, int] = {}
        board.controller.analogue_inputs.listen(self._moved)

    def switch_on(self, axis: AxisState, line: int) -> None:
        """Make the axis follow its joystick; raise Rejected if the axis is off."""
        check_on(self._board, axis)
        axis.jogging, axis.running = True, False
        axis.flags |= flags.JOG_ENABLED
        self._lines[axis.number] = line
        self._follow(axis)

    def switch_off(self, axis: AxisState) -> None:
        """Stop following the joystick, and stop the axis."""
        if axis.jogging:
            axis.jogging = False
            axis.flags &= ~flags.JOG_ENABLED
            self._board.controller.stop(axis.number)

    def velocity(self, axis: AxisState) -> float:
        """Return the velocity that the joystick commands, counts/s."""
        jog = axis.jog
        deflection = volts(self._board.controller.analogue_input(axis.number)) - jog.offset
        if abs(deflection) <= jog.deadband:
            return 0.0
        velocity = jog.gain * deflection
        return velocity if abs(velocity) >= jog.minimum else 0.0

    def update(self, axis: AxisState) -> None:
        """Take the velocity that the joystick commands now, if the axis follows it."""
        if axis.jogging:
            self._follow(axis)

    def _moved(self, channel: int, value: float) -> None:
        axis = self._board.axes.get(channel)
        if axis is not None:
            self.update(axis)

    def _follow(self, axis: AxisState) -> None:
        """Ramp to the commanded velocity at JA without changing the axis's own rates."""
        controller, number = self._board.controller, axis.number
        velocity = self.velocity(axis)
        if velocity == 0.0 and controller.is_idle(number):
            return
        stored = {name: controller.setting(number, name) for name in ("accel", "decel")}
        for name in stored:
            controller.configure(number, name, axis.jog.accel)
        try:
            if velocity:
                controller.jog(number, velocity, "JN", self._lines.get(number, 0))
            else:
                controller.stop(number)
        finally:
            for name, value in stored.items():
                controller.configure(number, name, value)
