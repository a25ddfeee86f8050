"""The drive's serial port: the two parameters and the op-code of a PVT move.

The framing of the serial protocol is defined in another document. A message here is the content of a parameter.
"""

from __future__ import annotations

from collections.abc import Sequence

from motionlang.lab.pvt.drive import serial
from motionlang.lab.pvt.drive.drive import Drive


class PortRefused(Exception):
    """The drive's serial port has rejected a request."""


class SerialPort:
    """Parameters 0xC8 and 0x115 and op-code 17 of one drive."""

    def __init__(self, drive: Drive) -> None:
        self.drive = drive
        self.configuration = 0

    def write(self, parameter: int, message: Sequence[int]) -> None:
        """Write a parameter; raise `PortRefused` if it is rejected.

        Writing a point to a full buffer is an overflow.
        """
        if parameter == serial.TRAJECTORY_PARAMETER:
            if list(message) not in ([0], [serial.PVT_CONFIGURATION]):
                raise PortRefused(f"trajectory configuration {list(message)} is not simulated: 3 is PVT")
            self.configuration = message[0]
        elif parameter == serial.PARAMETER:
            self._fill(message)
        else:
            raise PortRefused(f"parameter {parameter:#x} is not simulated")

    def read(self, parameter: int) -> tuple[int, ...]:
        if parameter == serial.TRAJECTORY_PARAMETER:
            return (self.configuration,)
        if parameter == serial.PARAMETER:
            return serial.status_words(self.drive.buffer.free)
        raise PortRefused(f"parameter {parameter:#x} is not simulated")

    def command(self, opcode: int) -> None:
        """Execute an op-code: 17 starts the move in the buffer."""
        if opcode != serial.START_OPCODE:
            raise PortRefused(f"op-code {opcode} is not simulated: {serial.START_OPCODE} starts a move")
        if self.configuration != serial.PVT_CONFIGURATION:
            raise PortRefused("parameter 0xC8 must be 3 (PVT interpolation) before a PVT move starts")
        self.drive.start()

    def _fill(self, message: Sequence[int]) -> None:
        try:
            content = serial.decode(message)
        except serial.BadWord as problem:
            raise PortRefused(str(problem)) from None
        if not isinstance(content, serial.BufferCommand):
            self.drive.add(content)
        elif content.code == serial.CLEAR:
            self.drive.clear()
        else:
            self.drive.pop(content.data)
