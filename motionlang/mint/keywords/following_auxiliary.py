"""Auxiliary encoders: turned by the machine file's `[[encoder]]`, or virtual: then they run at AUXENCODERSPEED."""

from __future__ import annotations

from motionlang.controller.io.encoder import AUXILIARY
from motionlang.mint.keywords.io_inputs import checked
from motionlang.mint.keywords.sensing_operations import Encoders
from motionlang.mint.runtime.changes import moving

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.mint.runtime.binding import Row
    from motionlang.mint.runtime.environment import Environment

    Operation = Callable[..., object]

LAST_ENCODER = 63
# The AUXENCODERMODE of a virtual axis.
VIRTUAL = 8


class AuxEncoders(Encoders):
    """The auxiliary encoders, which are no axis's."""

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        self.modes: dict[int, int] = {}
        self._speeds: dict[int, float] = {}

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


def read_position(environment: Environment, row: Row) -> Operation:
    encoders = environment.part(AuxEncoders)
    return encoders.changes.comparable(lambda channel: encoders.read(_channel(channel)), encoders.until)


def write_position(environment: Environment, row: Row) -> Operation:
    encoders = environment.part(AuxEncoders)
    return lambda channel, value: encoders.write(_channel(channel), value)


@moving
def read_velocity(environment: Environment, row: Row) -> Operation:
    encoders = environment.part(AuxEncoders)
    return lambda channel: encoders.speed(_channel(channel))


def read_mode(environment: Environment, row: Row) -> Operation:
    modes = environment.part(AuxEncoders).modes
    return lambda channel: modes.get(_channel(channel), 0)


def write_mode(environment: Environment, row: Row) -> Operation:
    """AUXENCODERMODE: 8 makes the encoder a virtual axis; any other mode has no effect, which the report says."""
    encoders, without_effect = environment.part(AuxEncoders), environment.machine.without_effect

    def write(channel: int, mode: int) -> None:
        row.check(mode)
        encoders.set_mode(_channel(channel), mode)
        if mode not in (0, VIRTUAL):
            without_effect.setdefault(row.name, [])

    return write


def read_speed(environment: Environment, row: Row) -> Operation:
    encoders = environment.part(AuxEncoders)
    return lambda channel: encoders.virtual_speed(_channel(channel))


def write_speed(environment: Environment, row: Row) -> Operation:
    """AUXENCODERSPEED: a virtual encoder runs at so many units a second from now on."""
    encoders = environment.part(AuxEncoders)

    def write(channel: int, speed: float) -> None:
        row.check(speed)
        encoders.turn(_channel(channel), speed)

    return write


def read_setting(environment: Environment, row: Row) -> Operation:
    """AUXENCODERSCALE, -PRESCALE and -WRAP."""
    encoders, name, whole = environment.part(AuxEncoders), row.name[3:], row.unit == "integer"

    def read(channel: int) -> float:
        value = encoders.setting(name, _channel(channel))
        return int(value) if whole else value

    return read


def write_setting(environment: Environment, row: Row) -> Operation:
    """AUXENCODERSCALE, -PRESCALE and -WRAP."""
    encoders, name = environment.part(AuxEncoders), row.name[3:]

    def write(channel: int, value: float) -> None:
        row.check(value)
        encoders.set(name, _channel(channel), value)

    return write


OPERATIONS = {
    "following.auxiliary.position": {"read": read_position, "write": write_position},
    "following.auxiliary.velocity": {"read": read_velocity},
    "following.auxiliary.speed": {"read": read_speed, "write": write_speed},
    "following.auxiliary.mode": {"read": read_mode, "write": write_mode},
    "following.auxiliary.setting": {"read": read_setting, "write": write_setting},
}
