"""Relays, pulses of outputs, spare analogue outputs and motor brakes."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

_BRAKE = "MOTORBRAKEOUTPUT(0) = 4\nMOTORBRAKEMODE(0) = 1\nDRIVEENABLE(0) = _OFF\nPRINT OUTX(4)"


def _word(
    name: str, short: str, access: str, index: str, unit: str, verb: str, help: str, example: str,
    default: float = 0.0, low: float | None = None, high: float | None = None,
) -> Keyword:  # fmt: skip
    kind = "reading" if access == "R" else "setting"
    return Keyword(name, short, kind, access, index, unit, f"relays.{verb}", help, example, default=default,
                   low=low, high=high, group="io")  # fmt: skip


ROWS = (
    Keyword("PULSEOUTX", "", "setting", "W", "channel", "ms", "relays.pulse",
            "Turn an output on for some milliseconds, from now on; the program goes on meanwhile.",
            "PULSEOUTX(3) = 50\nPRINT OUTX(3)\nWAIT = 50\nPRINT OUTX(3)", low=0, high=2147483647.0, group="io"),
    _word("RELAY", "", "RW", "bank", "bool", "relay", "The relay of the controller, or the first one of a bank.",
          "RELAY = _ON\nPRINT RELAY", low=0, high=1),
    _word("RELAYOUT", "", "RW", "bank", "bits", "bank", "The relays of a bank as bits.",
          "RELAYOUT(0) = 5\nPRINT RELAYOUT(0)"),
    _word("RELAYOUTX", "", "RW", "relay", "bool", "relay", "One relay: 1 is closed.",
          "RELAYOUTX(2) = _ON\nPRINT RELAYOUTX(2)", low=0, high=1),
    _word("AUXDAC", "ad", "RW", "channel", "%", "auxiliary", "A spare analogue output in percent of its range.",
          "AUXDAC(0) = 25.5\nPRINT AUXDAC(0)", low=-100.0, high=100.0),
    _word("MOTORBRAKE", "", "W", "axis", "bool", "brake",
          "Set (1) or lift (0) the brake of the motor by hand; an axis whose brake is set so takes no move.",
          "MOTORBRAKEOUTPUT(0) = 4\nMOTORBRAKE(0) = _ON\nPRINT OUTX(4)", low=0, high=1),
    _word("MOTORBRAKESTATUS", "", "R", "axis", "integer", "brake_status", "1 while the brake of the motor is set.",
          "MOTORBRAKE(0) = _ON\nPRINT MOTORBRAKESTATUS(0)"),
    _word("MOTORBRAKEMODE", "", "RW", "axis", "integer", "brake_mode",
          "0: only MOTORBRAKE sets the brake; 1: it is lifted while the drive is enabled.", _BRAKE, low=0, high=1),
    _word("MOTORBRAKEOUTPUT", "", "RW", "axis", "integer", "brake_output",
          "The output that lifts the brake, on while the motor is free; -1 for none.", _BRAKE, -1.0, -1, 999),
    _word("MOTORBRAKEDELAY", "", "RW", "axis, delay", "ms", "brake_delay",
          "How long after the drive the brake follows: delay 0 when it is lifted, 1 when it is set.",
          "MOTORBRAKEDELAY(0, 1) = 40\nPRINT MOTORBRAKEDELAY(0, 1)", low=0, high=2147483647.0),
)  # fmt: skip
