"""Auxiliary encoders: turned by the machine file's `[[encoder]]`, or virtual: then they run at AUXENCODERSPEED."""

from __future__ import annotations

from motionlang.controller.io.encoder import AUXILIARY
from motionlang.mint.keywords.io_inputs import checked
from motionlang.mint.keywords.sensing_operations import (
    Encoders,
    compared,
    read_setting,
    read_speed,
    write_encoder,
    write_setting,
)
from motionlang.mint.runtime.binding import Row, of, of_word
from motionlang.mint.runtime.changes import moving
from motionlang.mint.runtime.environment import Environment

LAST_ENCODER = 63
# The AUXENCODERMODE of a virtual axis.
VIRTUAL = 8


class AuxEncoders(Encoders):
    """The auxiliary encoders, which are no axis's."""

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        self.machine = environment.machine
        self.modes: dict[int, int] = {}
        self._speeds: dict[int, float] = {}

    def checked(self, channel: int) -> int:
        return _channel(channel)

    def track(self, channel: int) -> int:
        return AUXILIARY + channel

    def counts(self, channel: int) -> float:
        return self._controller.encoder_position(AUXILIARY + channel)

    def velocity(self, channel: int) -> float:
        return self._controller.encoder_velocity(AUXILIARY + channel)

    def virtual_speed(self, channel: int) -> float:
        """The speed that was given to an encoder as a virtual axis, in its units."""
        return self._speeds.get(channel, 0.0)

    def turn(self, channel: int, speed: float) -> None:
        """Give an encoder a speed, in its units: a virtual one runs at it from now on."""
        self._speeds[channel] = speed
        if self.modes.get(channel) == VIRTUAL:
            self._controller.drive_encoder(AUXILIARY + channel, speed * self.per_unit(channel))

    def set_mode(self, channel: int, mode: int) -> None:
        """Make an encoder a virtual axis, or no longer one: then it stands."""
        before = self.modes.get(channel, 0)
        self.modes[channel] = mode
        if mode == VIRTUAL:
            self.turn(channel, self.virtual_speed(channel))
        elif before == VIRTUAL:
            self._controller.drive_encoder(AUXILIARY + channel, 0.0)


def _channel(channel: int) -> int:
    return checked(channel, LAST_ENCODER, "auxiliary encoder")


# ----------------------------------------------------------------------------------------------- operations


def write_mode(encoders: AuxEncoders, row: Row, channel: int, mode: int) -> None:
    """AUXENCODERMODE: 8 makes the encoder a virtual axis; any other mode has no effect, which the report says."""
    encoders.set_mode(_channel(channel), mode)
    if mode not in (0, VIRTUAL):
        encoders.machine.without_effect.setdefault(row.name, [])


OPERATIONS = {
    "following.auxiliary.position": {"read": compared(AuxEncoders), "write": of(AuxEncoders, write_encoder)},
    "following.auxiliary.velocity": {"read": moving(of(AuxEncoders, read_speed))},
    "following.auxiliary.speed": {
        "read": of(AuxEncoders, lambda encoders, channel: encoders.virtual_speed(_channel(channel))),
        "write": of(AuxEncoders, lambda encoders, channel, speed: encoders.turn(_channel(channel), speed)),
    },
    "following.auxiliary.mode": {
        "read": of(AuxEncoders, lambda encoders, channel: encoders.modes.get(_channel(channel), 0)),
        "write": of_word(AuxEncoders, write_mode),
    },
    "following.auxiliary.setting": {
        "read": of_word(AuxEncoders, read_setting),
        "write": of_word(AuxEncoders, write_setting),
    },
}
