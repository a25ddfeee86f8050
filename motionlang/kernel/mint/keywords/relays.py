"""Relays, output pulses, spare analogue outputs and motor brakes.

Relays and spare analogue outputs have channels of their own, from `FIRST` on, in the log of outputs.
"""

from __future__ import annotations

from functools import partial

from motionlang.kernel.controller.clock import TimedCall
from motionlang.kernel.lang.keyword import BANK, Actions, Keyword, value
from motionlang.kernel.mint.keywords.io_inputs import LAST_CHANNEL, bits_of, checked
from motionlang.kernel.mint.keywords.io_outputs import LAST_ANALOGUE
from motionlang.kernel.mint.runtime.binding import ByNumber, of, of_word
from motionlang.kernel.mint.runtime.changes import repeatable
from motionlang.kernel.mint.runtime.environment import Environment

FIRST = 1000
LAST_RELAY = 63
LAST_RELAY_BANK = LAST_RELAY // BANK


def bank_of_relays(bank: int) -> int:
    """Return the first relay of a bank."""
    return checked(bank, LAST_RELAY_BANK, "bank of relays") * BANK


def read_bank(environment: Environment, bank: int) -> int:
    """RELAYOUT: return a bank of relays as bits."""
    bank_of_relays(bank)
    outputs = environment.controller.outputs
    return bits_of(bank, lambda relay: outputs[FIRST + relay])


def write_bank(environment: Environment, bank: int, bits: int) -> None:
    """RELAYOUT: set a bank of relays, one bit per relay."""
    environment.controller.outputs.set_bank(FIRST + bank_of_relays(bank), BANK, bits)


def _relay(row: Keyword, number: int) -> int:
    """Return the channel of a relay; RELAY(bank) refers to the first one of a bank."""
    return FIRST + (bank_of_relays(number) if row.index == "bank" else checked(number, LAST_RELAY, "relay"))


def read_relay(environment: Environment, row: Keyword, number: int) -> int:
    return int(environment.controller.output(_relay(row, number)) != 0)


def write_relay(environment: Environment, row: Keyword, number: int, value: int) -> None:
    """RELAY and RELAYOUTX: switch a relay."""
    environment.controller.set_output(_relay(row, number), value)


def auxiliary(channel: int) -> int:
    """Return the channel of a spare analogue output."""
    return FIRST + checked(channel, LAST_ANALOGUE, "spare analogue output")


def write_auxiliary(environment: Environment, channel: int, value: float) -> None:
    """AUXDAC: set a spare analogue output in percent."""
    environment.controller.set_analogue_output(auxiliary(channel), value)


def write_pulse(environment: Environment, channel: int, milliseconds: float) -> None:
    """PULSEOUTX: turn an output on for a time in ms."""
    environment.controller.pulse(checked(channel, LAST_CHANNEL, "output"), milliseconds / 1000.0)


# --------------------------------------------------------------------------------------------------- brakes

BY_HAND, BY_DRIVE = 0, 1
RELEASE, ENGAGE = 0, 1
NONE = -1


class Brake:
    """The spring-applied brake of one motor, which an output releases.

    While it is engaged by hand, no move can begin.
    """

    def __init__(self, environment: Environment, axis: int) -> None:
        self._controller, self.axis = environment.controller, axis
        self.mode, self.output = BY_HAND, NONE
        self.delays = [0, 0]
        self.engaged = False
        self._scheduled: TimedCall | None = None

    def choose(self, mode: int) -> None:
        """Select control by the drive, which sets the brake at once, or by the program."""
        self.mode = mode
        if mode == BY_DRIVE:
            self.engage(not self._controller.is_enabled(self.axis))

    def assign(self, output: int) -> None:
        self.output = output
        self._show()

    def engage(self, engaged: bool) -> None:
        """Engage or release the brake now."""
        if self._scheduled is not None:
            self._scheduled.cancel()
            self._scheduled = None
        self.engaged = engaged
        self._controller.set_brake(self.axis, False)
        self._show()

    def engage_by_hand(self, engaged: bool) -> None:
        """MOTORBRAKE: engage or release the brake independently of the drive.

        The drive does not know that the brake is engaged, so it must not move the motor.
        """
        self.engage(engaged)
        if engaged:
            self._controller.set_brake(self.axis, True)

    def follow_drive(self) -> None:
        """Schedule the brake after the drive was switched.

        The delay is that of MOTORBRAKEDELAY in ms.
        """
        if self.mode != BY_DRIVE:
            return
        engaged = not self._controller.is_enabled(self.axis)
        clock, delay = self._controller.clock, self.delays[ENGAGE if engaged else RELEASE]
        if self._scheduled is not None:
            self._scheduled.cancel()
        self._scheduled = clock.at(clock.now + delay / 1000.0, lambda: self.engage(engaged))

    def _show(self) -> None:
        if self.output != NONE:
            self._controller.set_output(self.output, int(not self.engaged))


class Brakes:
    """The brake of every axis, created on first use."""

    def __init__(self, environment: Environment) -> None:
        self._environment = environment
        self._brakes = ByNumber(lambda axis: Brake(environment, axis))
        environment.controller.listeners.append(self._on_event, "switched")

    def brake(self, axis: int) -> Brake:
        return self._brakes[axis]

    def default(self, axis: int) -> None:
        """Reset the axis to its defaults (DEFAULT)."""
        self._brakes.pop(axis, None)
        self._environment.controller.set_brake(axis, False)

    def _on_event(self, what: str, axis: int) -> None:
        if what == "switched" and axis in self._brakes:
            self._brakes[axis].follow_drive()


def _delay(which: int) -> int:
    return checked(which, ENGAGE, "delay of a brake")


def write_delay(brakes: Brakes, axis: int, which: int, milliseconds: float) -> None:
    """MOTORBRAKEDELAY: set a delay in ms."""
    brakes.brake(axis).delays[_delay(which)] = int(milliseconds)


# ------------------------------------------------------------------------------------------------- keywords

_RELAY = Actions(read=of_word(Environment, read_relay), write=repeatable(of_word(Environment, write_relay)))
_BANK = Actions(read=of(Environment, read_bank), write=repeatable(of(Environment, write_bank)))
_AUXILIARY = Actions(
    read=of(Environment, lambda e, channel: float(e.controller.analogue_outputs[auxiliary(channel)])),
    write=repeatable(of(Environment, write_auxiliary)),
)
_BRAKE_ACTIONS = Actions(
    write=of(Brakes, lambda brakes, axis, on: brakes.brake(axis).engage_by_hand(bool(on)))
)
_BRAKE_MODE = Actions(
    read=of(Brakes, lambda brakes, axis: brakes.brake(axis).mode),
    write=of(Brakes, lambda brakes, axis, mode: brakes.brake(axis).choose(mode)),
)
_BRAKE_OUTPUT = Actions(
    read=of(Brakes, lambda brakes, axis: brakes.brake(axis).output),
    write=of(Brakes, lambda brakes, axis, output: brakes.brake(axis).assign(output)),
)
_BRAKE_DELAY = Actions(
    read=of(Brakes, lambda brakes, axis, which: brakes.brake(axis).delays[_delay(which)]),
    write=of(Brakes, write_delay),
)

_BRAKE = "MOTORBRAKEOUTPUT(0) = 4\nMOTORBRAKEMODE(0) = 1\nDRIVEENABLE(0) = _OFF\nPRINT OUTX(4)"

_word = partial(value, group="io")


ROWS = (
    Keyword("PULSEOUTX", "", "setting", "W", "channel", "ms", Actions(write=of(Environment, write_pulse)),
            "Turn an output on for some milliseconds, from now on; the program goes on meanwhile.",
            "PULSEOUTX(3) = 50\nPRINT OUTX(3)\nWAIT = 50\nPRINT OUTX(3)", low=0, high=2147483647.0, group="io",
            channel="output"),
    _word("RELAY", "", "RW", "bank", "bool", _RELAY, "The relay of the controller, or the first one of a bank.",
          "RELAY = _ON\nPRINT RELAY", low=0, high=1, channel="relay"),
    _word("RELAYOUT", "", "RW", "bank", "bits", _BANK, "The relays of a bank as bits.",
          "RELAYOUT(0) = 5\nPRINT RELAYOUT(0)", channel="relay bank"),
    _word("RELAYOUTX", "", "RW", "relay", "bool", _RELAY, "One relay: 1 is closed.",
          "RELAYOUTX(2) = _ON\nPRINT RELAYOUTX(2)", low=0, high=1),
    _word("AUXDAC", "ad", "RW", "channel", "%", _AUXILIARY, "A spare analogue output in percent of its range.",
          "AUXDAC(0) = 25.5\nPRINT AUXDAC(0)", low=-100.0, high=100.0, channel="auxiliary analogue output"),
    _word("MOTORBRAKE", "", "W", "axis", "bool", _BRAKE_ACTIONS,
          "Set (1) or lift (0) the brake of the motor by hand; an axis whose brake is set so takes no move.",
          "MOTORBRAKEOUTPUT(0) = 4\nMOTORBRAKE(0) = _ON\nPRINT OUTX(4)", low=0, high=1),
    _word("MOTORBRAKESTATUS", "", "R", "axis", "integer",
          Actions(read=of(Brakes, lambda brakes, axis: int(brakes.brake(axis).engaged))),
          "1 while the brake of the motor is set.",
          "MOTORBRAKE(0) = _ON\nPRINT MOTORBRAKESTATUS(0)"),
    _word("MOTORBRAKEMODE", "", "RW", "axis", "integer", _BRAKE_MODE,
          "0: only MOTORBRAKE sets the brake; 1: it is lifted while the drive is enabled.", _BRAKE, low=0, high=1),
    _word("MOTORBRAKEOUTPUT", "", "RW", "axis", "integer", _BRAKE_OUTPUT,
          "The output that lifts the brake, on while the motor is free; -1 for none.", _BRAKE, -1.0, -1, 999,
          selects="output"),
    _word("MOTORBRAKEDELAY", "", "RW", "axis, delay", "ms", _BRAKE_DELAY,
          "Delay of the brake behind the drive: delay 0 when the brake is released, 1 when it is set.",
          "MOTORBRAKEDELAY(0, 1) = 40\nPRINT MOTORBRAKEDELAY(0, 1)", low=0, high=2147483647.0),
)  # fmt: skip
