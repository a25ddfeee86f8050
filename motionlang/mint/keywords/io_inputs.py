"""Digital inputs: active levels, debouncing, latched edges, and events.

A bank is 32 channels. The value of an input in the machine file is its electrical level, and INSTATE shows
it. IN and INX show the state after INPUTDEBOUNCE and INPUTACTIVELEVEL or, if the INPUTMODE bit of the input
is set, an edge that came since the last read.
"""

from __future__ import annotations

from motionlang.controller.faults import Refusal
from motionlang.lang.keyword import Actions, Keyword
from motionlang.mint.keywords.defaults import PATTERNS
from motionlang.mint.runtime.binding import of, of_word

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.controller.clock import Event
    from motionlang.mint.runtime.binding import Operation
    from motionlang.mint.runtime.environment import Environment


BANK = 32
LAST_CHANNEL = 999
# Seconds between two samples of an input.
SAMPLE = 1e-3


class Inputs:
    """All digital inputs of one program.

    `listeners` are called with (channel, on) at every change of a state.
    """

    def __init__(self, environment: Environment) -> None:
        self._controller = environment.controller
        self._environment = environment
        self._patterns: dict[tuple[str, int], int] = {}
        self._debounce: dict[int, int] = {}
        # Channels that are being debounced: the state that they still show, and the event of its change.
        self._held: dict[int, tuple[bool, Event]] = {}
        self._edges: set[int] = set()
        self.listeners: list[Callable[[int, bool], None]] = []
        self._controller.inputs.listeners.append(self._level_changed)

    # -------------------------------------------------------------------------------------------- settings

    def pattern(self, name: str, bank: int) -> int:
        return self._patterns.get((name, bank), PATTERNS[name])

    def set_pattern(self, name: str, bank: int, bits: int) -> None:
        self._patterns[name, bank] = bits

    def debounce(self, bank: int) -> int:
        return self._debounce.get(bank, 0)

    def set_debounce(self, bank: int, samples: int) -> None:
        self._debounce[bank] = samples

    def active_level(self, bank: int) -> int:
        low = self._controller.inputs.active_low
        return _signed(sum(1 << k for k in range(BANK) if bank * BANK + k not in low))

    def set_active_level(self, bank: int, bits: int) -> None:
        inputs = self._controller.inputs
        here = range(bank * BANK, (bank + 1) * BANK)
        low = {channel for channel in here if not bits >> (channel - here[0]) & 1}
        inputs.set_active_low((inputs.active_low - set(here)) | low)

    # --------------------------------------------------------------------------------------------- reading

    def is_on(self, channel: int) -> bool:
        """Return the state of an input."""
        held = self._held.get(channel)
        return self._controller.inputs.inverted(channel) if held is None else held[0]

    def read(self, channel: int) -> bool:
        """Return the state of an input, or its latched edge, which reading clears."""
        if not self._bit("INPUTMODE", channel):
            return self.is_on(channel)
        found = channel in self._edges
        if found:
            self._edges.discard(channel)
            self._environment.acts += 1
        return found

    def _bit(self, name: str, channel: int) -> int:
        return self.pattern(name, channel // BANK) >> channel % BANK & 1

    # --------------------------------------------------------------------------------------------- changes

    def _level_changed(self, channel: int, value: float) -> None:
        samples = self._debounce.get(channel // BANK, 0)
        if not samples:
            self._state_changed(channel, self.is_on(channel))
            return
        clock, state = self._controller.clock, self._controller.inputs.inverted(channel)
        held = self._held.pop(channel, None)
        if held is not None:
            held[1].cancel()
            if held[0] is state:
                return  # the input has bounced back
        event = clock.at(clock.now + samples * SAMPLE, lambda: self._settled(channel))
        self._held[channel] = (not state, event)

    def _settled(self, channel: int) -> None:
        del self._held[channel]
        self._state_changed(channel, self.is_on(channel))

    def _state_changed(self, channel: int, on: bool) -> None:
        if self._bit("INPUTPOSTRIGGER" if on else "INPUTNEGTRIGGER", channel):
            self._edges.add(channel)
            if self._bit("IMASK", channel):
                self._environment.events.raise_("in", channel)
        for listener in tuple(self.listeners):
            listener(channel, on)


def _signed(bits: int) -> int:
    return bits - (1 << BANK) if bits >> (BANK - 1) & 1 else bits


def bits_of(bank: int, is_on: Callable[[int], object]) -> int:
    """Return the channels of a bank as an Integer."""
    checked(bank, LAST_CHANNEL // BANK, "bank")
    first = bank * BANK
    return _signed(sum(1 << k for k in range(BANK) if is_on(first + k)))


def checked(number: int, last: int = LAST_CHANNEL, what: str = "input") -> int:
    """Return the number; raise Refusal if there is no such channel or bank."""
    if not 0 <= number <= last:
        raise Refusal("channel", f"there is no {what} {number}", f"they are numbered 0 to {last}")
    return number


# ----------------------------------------------------------------------------------------------- operations


def read_bank(environment: Environment, row: Keyword) -> Operation:
    inputs = environment.part(Inputs)
    return lambda bank: bits_of(bank, inputs.read)


def read_bit(environment: Environment, row: Keyword) -> Operation:
    inputs = environment.part(Inputs)
    return lambda channel: int(inputs.read(checked(channel)))


def read_level_bank(environment: Environment, row: Keyword) -> Operation:
    levels = environment.controller.inputs
    return lambda bank: bits_of(bank, levels.__getitem__)


def read_level_bit(environment: Environment, row: Keyword) -> Operation:
    levels = environment.controller.inputs
    return lambda channel: int(levels[checked(channel)] != 0)


def _bank(bank: int) -> int:
    return checked(bank, LAST_CHANNEL // BANK, "bank")


# ------------------------------------------------------------------------------------------------- keywords

_ACTIVE_LEVEL = Actions(
    read=of(Inputs, lambda inputs, bank: inputs.active_level(_bank(bank))),
    write=of(Inputs, lambda inputs, bank, bits: inputs.set_active_level(_bank(bank), bits)),
)
# Samples for which an input must be stable.
_DEBOUNCE = Actions(
    read=of(Inputs, lambda inputs, bank: inputs.debounce(_bank(bank))),
    write=of(Inputs, lambda inputs, bank, samples: inputs.set_debounce(_bank(bank), samples)),
)
_PATTERN = Actions(
    read=of_word(Inputs, lambda inputs, row, bank: inputs.pattern(row.name, _bank(bank))),
    write=of_word(Inputs, lambda inputs, row, bank, bits: inputs.set_pattern(row.name, _bank(bank), bits)),
)


def _pattern(name: str, help: str, example: str) -> Keyword:
    return Keyword(name, "", "setting", "RW", "bank", "bits", _PATTERN, help, example,
                   default=float(PATTERNS[name]), group="io")  # fmt: skip


ROWS = (
    Keyword("IN", "", "reading", "R", "bank", "bits", Actions(read=read_bank),
            "The digital inputs of a bank as bits, bank 0 when none is given; edges that are latched are read off.",
            "PRINT IN(0) & 3", default=0.0, group="io", driven="input"),
    Keyword("INX", "", "reading", "R", "input", "bool", Actions(read=read_bit),
            "One digital input: 1 when it is active or, with its INPUTMODE bit set, when its edge has come.",
            "PRINT INX(3)", default=0.0, group="io", driven="input"),
    Keyword("INSTATE", "", "reading", "R", "bank", "bits", Actions(read=read_level_bank),
            "The electrical levels of a bank of inputs, whatever their active level, debouncing and edges.",
            "PRINT INSTATE(0)", default=0.0, group="io", driven="input"),
    Keyword("INSTATEX", "isx", "reading", "R", "input", "bool", Actions(read=read_level_bit),
            "The electrical level of one input.",
            "PRINT INSTATEX(3)", default=0.0, group="io", driven="input"),
    Keyword("INPUTACTIVELEVEL", "", "setting", "RW", "bank", "bits", _ACTIVE_LEVEL,
            "Bit pattern of the inputs that are active while their level is high; the others are active low.",
            "INPUTACTIVELEVEL(0) = 0xFFFE\nPRINT INX(0)", default=-1.0, group="io"),
    Keyword("INPUTDEBOUNCE", "", "setting", "RW", "bank", "integer", _DEBOUNCE,
            "How many samples of 1 ms the inputs of a bank must stay the same before their state follows.",
            "INPUTDEBOUNCE(0) = 5\nPRINT INPUTDEBOUNCE(0)", default=0.0, low=0, high=1000, group="io"),
    _pattern("INPUTMODE", "Bit pattern of the inputs that report their edges (1) instead of their state (0).",
             "INPUTMODE(0) = 8\nPRINT INX(3)"),
    _pattern("INPUTPOSTRIGGER", "Bit pattern of the inputs whose becoming active is an edge and an event.",
             "INPUTPOSTRIGGER(0) = 8\nPRINT INPUTPOSTRIGGER(0)"),
    _pattern("INPUTNEGTRIGGER", "Bit pattern of the inputs whose becoming inactive is an edge and an event.",
             "INPUTNEGTRIGGER(0) = 8\nPRINT INPUTNEGTRIGGER(0)"),
    _pattern("IMASK", "Bit pattern of the inputs that may raise an event IN0, IN1 …",
             "IMASK(0) = 8\nPRINT IMASK(0)"),
)  # fmt: skip
# The event sources of each kind, created for programs that handle these events.
SOURCES = {"in": Inputs}
