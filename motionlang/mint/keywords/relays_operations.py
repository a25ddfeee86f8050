"""Relays, pulses of outputs, spare analogue outputs and motor brakes: what a program switches beside OUT and DAC.

Relays and spare analogue outputs are channels of their own, from `FIRST` on in the log of what was switched.
"""

from __future__ import annotations

from motionlang.mint.keywords.io_inputs import BANK, LAST_CHANNEL, bits_of, checked
from motionlang.mint.keywords.io_outputs import LAST_ANALOGUE
from motionlang.mint.runtime.binding import axis_of
from motionlang.mint.runtime.changes import repeatable

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.controller.clock import Event
    from motionlang.mint.runtime.binding import Operation, Row
    from motionlang.mint.runtime.environment import Environment

FIRST = 1000
LAST_RELAY = 63
LAST_RELAY_BANK = LAST_RELAY // BANK


# --------------------------------------------------------------------------------------------------- pulses


def write_pulse(environment: Environment, row: Row) -> Operation:
    """PULSEOUTX: an output comes on for so many ms."""
    pulse = environment.controller.pulse

    def write(channel: int, milliseconds: float) -> None:
        pulse(checked(channel, LAST_CHANNEL, "output"), milliseconds / 1000.0)

    return write


# --------------------------------------------------------------------------------------------------- relays


def read_bank(environment: Environment, row: Row) -> Operation:
    """RELAYOUT."""
    outputs = environment.controller.outputs

    def read(bank: int) -> int:
        checked(bank, LAST_RELAY_BANK, "bank of relays")
        return bits_of(bank, lambda relay: outputs[FIRST + relay])

    return read


@repeatable
def write_bank(environment: Environment, row: Row) -> Operation:
    """RELAYOUT: a bank of relays, a bit each."""
    outputs = environment.controller.outputs

    def write(bank: int, bits: int) -> None:
        first = checked(bank, LAST_RELAY_BANK, "bank of relays") * BANK
        outputs.set_bank(FIRST + first, BANK, bits)

    return write


def _relay(row: Row, number: int) -> int:
    """The channel of a relay: of RELAYOUTX(relay), and of RELAY(bank), which is the first one of a bank."""
    if row.name == "RELAY":
        return FIRST + checked(number, LAST_RELAY_BANK, "bank of relays") * BANK
    return FIRST + checked(number, LAST_RELAY, "relay")


def read_relay(environment: Environment, row: Row) -> Operation:
    output = environment.controller.output
    return lambda number: int(output(_relay(row, number)) != 0)


@repeatable
def write_relay(environment: Environment, row: Row) -> Operation:
    """RELAY and RELAYOUTX."""
    set_output = environment.controller.set_output

    def write(number: int, value: int) -> None:
        set_output(_relay(row, number), value)

    return write


# --------------------------------------------------------------------------------- spare analogue outputs


def read_auxiliary(environment: Environment, row: Row) -> Operation:
    """AUXDAC."""
    outputs = environment.controller.analogue_outputs
    return lambda channel: float(outputs[FIRST + checked(channel, LAST_ANALOGUE, "spare analogue output")])


@repeatable
def write_auxiliary(environment: Environment, row: Row) -> Operation:
    """AUXDAC, percent."""
    set_output = environment.controller.set_analogue_output

    def write(channel: int, value: float) -> None:
        set_output(FIRST + checked(channel, LAST_ANALOGUE, "spare analogue output"), value)

    return write


# --------------------------------------------------------------------------------------------------- brakes

BY_HAND, BY_DRIVE = 0, 1
RELEASE, ENGAGE = 0, 1
NONE = -1


class Brake:
    """The brake of one motor, a spring that its output lifts; one that is set by hand lets no move begin."""

    __slots__ = ("_controller", "_due", "axis", "delays", "engaged", "mode", "output")

    def __init__(self, environment: Environment, axis: int) -> None:
        self._controller, self.axis = environment.controller, axis
        self.mode, self.output = BY_HAND, NONE
        self.delays = [0, 0]
        self.engaged = False
        self._due: Event | None = None

    def choose(self, mode: int) -> None:
        """Let the drive decide from now on, which sets the brake at once, or the program."""
        self.mode = mode
        if mode == BY_DRIVE:
            self.engage(not self._controller.is_enabled(self.axis))

    def assign(self, output: int) -> None:
        self.output = output
        self._show()

    def engage(self, engaged: bool) -> None:
        """Set or lift the brake now."""
        if self._due is not None:
            self._due.cancel()
            self._due = None
        self.engaged = engaged
        self._controller.set_brake(self.axis, False)
        self._show()

    def engage_by_hand(self, engaged: bool) -> None:
        """The same by MOTORBRAKE: the drive does not know of it, and must not move the motor."""
        self.engage(engaged)
        if engaged:
            self._controller.set_brake(self.axis, True)

    def follow_drive(self) -> None:
        """The drive was switched: the brake follows, so many milliseconds later."""
        if self.mode != BY_DRIVE:
            return
        engaged = not self._controller.is_enabled(self.axis)
        clock, delay = self._controller.clock, self.delays[ENGAGE if engaged else RELEASE]
        if self._due is not None:
            self._due.cancel()
        self._due = clock.at(clock.now + delay / 1000.0, lambda: self.engage(engaged))

    def _show(self) -> None:
        if self.output != NONE:
            self._controller.set_output(self.output, int(not self.engaged))


class Brakes:
    """The brake of every axis, from its first use on."""

    def __init__(self, environment: Environment) -> None:
        self._environment = environment
        self._brakes: dict[int, Brake] = {}
        environment.controller.listeners.append(self._heard, "switched")

    def brake(self, axis: int) -> Brake:
        if axis_of(self._environment, axis) not in self._brakes:
            self._brakes[axis] = Brake(self._environment, axis)
        return self._brakes[axis]

    def default(self, axis: int) -> None:
        """DEFAULT."""
        self._brakes.pop(axis, None)
        self._environment.controller.set_brake(axis, False)

    def _heard(self, what: str, axis: int) -> None:
        if what == "switched" and axis in self._brakes:
            self._brakes[axis].follow_drive()


def write_brake(environment: Environment, row: Row) -> Operation:
    """MOTORBRAKE: engage the brake by hand, or release it."""
    brake = environment.part(Brakes).brake

    def write(axis: int, engaged: int) -> None:
        brake(axis).engage_by_hand(bool(engaged))

    return write


def read_brake_status(environment: Environment, row: Row) -> Operation:
    brake = environment.part(Brakes).brake
    return lambda axis: int(brake(axis).engaged)


def read_brake_mode(environment: Environment, row: Row) -> Operation:
    brake = environment.part(Brakes).brake
    return lambda axis: brake(axis).mode


def write_brake_mode(environment: Environment, row: Row) -> Operation:
    """MOTORBRAKEMODE."""
    brake = environment.part(Brakes).brake

    def write(axis: int, mode: int) -> None:
        brake(axis).choose(mode)

    return write


def read_brake_output(environment: Environment, row: Row) -> Operation:
    brake = environment.part(Brakes).brake
    return lambda axis: brake(axis).output


def write_brake_output(environment: Environment, row: Row) -> Operation:
    """MOTORBRAKEOUTPUT."""
    brake = environment.part(Brakes).brake

    def write(axis: int, output: int) -> None:
        brake(axis).assign(output)

    return write


def read_brake_delay(environment: Environment, row: Row) -> Operation:
    brake = environment.part(Brakes).brake
    return lambda axis, which: brake(axis).delays[checked(which, ENGAGE, "delay of a brake")]


def write_brake_delay(environment: Environment, row: Row) -> Operation:
    """MOTORBRAKEDELAY, ms."""
    brake = environment.part(Brakes).brake

    def write(axis: int, which: int, milliseconds: float) -> None:
        brake(axis).delays[checked(which, ENGAGE, "delay of a brake")] = int(milliseconds)

    return write


OPERATIONS = {
    "relays.pulse": {"write": write_pulse},
    "relays.relay": {"read": read_relay, "write": write_relay},
    "relays.bank": {"read": read_bank, "write": write_bank},
    "relays.auxiliary": {"read": read_auxiliary, "write": write_auxiliary},
    "relays.brake": {"write": write_brake},
    "relays.brake_status": {"read": read_brake_status},
    "relays.brake_mode": {"read": read_brake_mode, "write": write_brake_mode},
    "relays.brake_output": {"read": read_brake_output, "write": write_brake_output},
    "relays.brake_delay": {"read": read_brake_delay, "write": write_brake_delay},
}
