"""Digital inputs: active levels, debouncing, latched edges, and events.

A bank is 32 channels. The value of an input in the machine file is its electrical level, and INSTATE shows
it. A debounced bank is sampled every millisecond: INSTATE shows the last sample, and the state of an input
changes when INPUTDEBOUNCE consecutive samples have a new level. IN and INX show the state after INPUTDEBOUNCE and
INPUTACTIVELEVEL. If the INPUTMODE bit of the input is set, they show whether an edge came since the last read.
"""

from __future__ import annotations

from collections.abc import Callable
from math import ceil

from motionlang.kernel.controller.clock import TimedCall
from motionlang.kernel.errors import Rejected
from motionlang.kernel.lang.keyword import BANK, Actions, Keyword
from motionlang.kernel.mint.keywords.defaults import PATTERNS
from motionlang.kernel.mint.keywords.event_kinds import NUMBERS
from motionlang.kernel.mint.runtime.binding import Operation, of, of_word
from motionlang.kernel.mint.runtime.environment import Environment
from motionlang.kernel.tools import signed
from motionlang.kernel.traced import bits

LAST_CHANNEL = NUMBERS["in"][-1]
# Seconds between two samples of an input [MN1270 p. 95]; a change at the moment of a sample is in that sample.
SAMPLE = 1e-3
_SAME = 1e-6
# INPUTDEBOUNCE where inputs are not debounced.
UNDEBOUNCED = 1


class Inputs:
    """All digital inputs of one program.

    `listeners` are called with (channel, on) at every change of a state. `shows_levels` is true while no input
    reports edges and none is debounced: then each shows its level, after INPUTACTIVELEVEL.
    """

    def __init__(self, environment: Environment) -> None:
        self._controller = environment.controller
        self._environment = environment
        self._patterns: dict[tuple[str, int], int] = {}
        self._debounce: dict[int, int] = {}
        self.shows_levels = True
        # The levels that the program has been notified of.
        levels = self._controller.inputs
        self._levels = {channel: levels[channel] != 0 for channel in levels.touched}
        # Levels of debounced channels that changed since their last sample: the sampled level, and the next sample.
        self._sampled: dict[int, tuple[bool, int, TimedCall]] = {}
        # Channels whose new level has too few samples: the level that they still show, and the event of its change.
        self._debouncing: dict[int, tuple[bool, TimedCall]] = {}
        self._edges: set[int] = set()
        self.listeners: list[Callable[[int, bool], None]] = []
        self._controller.inputs.listeners.append(self._level_changed)

    # -------------------------------------------------------------------------------------------- settings

    def pattern(self, name: str, bank: int) -> int:
        return self._patterns.get((name, bank), PATTERNS[name])

    def set_pattern(self, name: str, bank: int, bits: int) -> None:
        self._patterns[name, bank] = bits
        self._simplify()

    def debounce(self, bank: int) -> int:
        return self._debounce.get(bank, UNDEBOUNCED)

    def set_debounce(self, bank: int, samples: int) -> None:
        """Set the number of samples for debouncing a bank.

        Without debouncing its inputs show their levels immediately.
        """
        self._debounce[bank] = samples
        self._simplify()
        if samples > UNDEBOUNCED:
            return
        for channel in sorted({*self._sampled, *self._debouncing}):
            if channel // BANK == bank:
                shown = self.is_on(channel)
                self._forget(channel)
                if self.is_on(channel) is not shown:
                    self._state_changed(channel, not shown)

    def _simplify(self) -> None:
        edges = any(bits for (name, _), bits in self._patterns.items() if name == "INPUTMODE")
        self.shows_levels = not edges and max(self._debounce.values(), default=UNDEBOUNCED) == UNDEBOUNCED

    def active_level(self, bank: int) -> int:
        low = self._controller.inputs.active_low
        return signed(sum(1 << k for k in range(BANK) if bank * BANK + k not in low))

    def set_active_level(self, bank: int, bits: int) -> None:
        inputs = self._controller.inputs
        here = range(bank * BANK, (bank + 1) * BANK)
        low = {channel for channel in here if not bits >> (channel - here[0]) & 1}
        inputs.set_active_low((inputs.active_low - set(here)) | low)

    # --------------------------------------------------------------------------------------------- reading

    def is_on(self, channel: int) -> bool:
        """Return the state of an input, after debouncing and INPUTACTIVELEVEL."""
        debouncing = self._debouncing.get(channel)
        shown = self.level(channel) if debouncing is None else debouncing[0]
        return shown is not (channel in self._controller.inputs.active_low)

    def level(self, channel: int) -> bool:
        """Return the electrical level of an input.

        This is the level of the last sample if the bank is debounced, otherwise the present level.
        """
        sampled = self._sampled.get(channel)
        return self._controller.inputs[channel] != 0 if sampled is None else sampled[0]

    def read(self, channel: int) -> bool:
        """Return the state of an input, or its latched edge, which the read clears."""
        if not self._bit("INPUTMODE", channel):
            return self.is_on(channel)
        self._controller.inputs.note_read(channel)
        found = channel in self._edges
        if found:
            self._edges.discard(channel)
            self._environment.acts += 1
        return found

    def traced(self, word: int, first: int, count: int = 1) -> int:
        """Return a word with the states of inputs, from `first` on, as a number that knows them if the run traces."""
        inputs = self._controller.inputs
        return bits(word, "input", first, count, inputs.present) if inputs.traces else word

    def _bit(self, name: str, channel: int) -> int:
        return self.pattern(name, channel // BANK) >> channel % BANK & 1

    # --------------------------------------------------------------------------------------------- changes

    def _level_changed(self, channel: int, value: float) -> None:
        level, known = value != 0, self._levels.get(channel, False)
        self._levels[channel] = level
        # If the level is known, INPUTACTIVELEVEL has changed.
        if level is known or self.debounce(channel // BANK) == UNDEBOUNCED:
            self._state_changed(channel, self.is_on(channel))
        elif channel not in self._sampled:
            clock = self._controller.clock
            sample = ceil(clock.now / SAMPLE - _SAME)
            event = clock.at(max(clock.now, sample * SAMPLE), lambda: self._sample(channel))
            self._sampled[channel] = known, sample, event

    def _sample(self, channel: int) -> None:
        """Take the sample of a channel whose level changed since its last sample."""
        before, sample, event = self._sampled.pop(channel)
        event.cancel()
        if self.level(channel) is before:
            return  # the level is back
        debouncing = self._debouncing.pop(channel, None)
        if debouncing is not None:
            debouncing[1].cancel()  # it bounced: the input shows this level already
            return
        clock = self._controller.clock
        due = (sample + self.debounce(channel // BANK) - 1) * SAMPLE
        self._debouncing[channel] = before, clock.at(max(clock.now, due), lambda: self._settled(channel))

    def _settled(self, channel: int) -> None:
        sampled = self._sampled.get(channel)
        if sampled is not None and sampled[1] * SAMPLE <= self._controller.clock.now:
            self._sample(channel)  # the last sample is due at this moment, too
        if channel in self._debouncing:
            del self._debouncing[channel]
            self._state_changed(channel, self.is_on(channel))

    def _forget(self, channel: int) -> None:
        for pending in (self._sampled.pop(channel, None), self._debouncing.pop(channel, None)):
            if pending is not None:
                pending[-1].cancel()

    def _state_changed(self, channel: int, on: bool) -> None:
        if self._bit("INPUTPOSTRIGGER" if on else "INPUTNEGTRIGGER", channel):
            self._edges.add(channel)
            if self._bit("IMASK", channel):
                self._environment.events.raise_("in", channel)
        for listener in tuple(self.listeners):
            listener(channel, on)


def bits_of(bank: int, is_on: Callable[[int], object]) -> int:
    """Return the channels of a bank as an Integer."""
    checked(bank, LAST_CHANNEL // BANK, "bank")
    first = bank * BANK
    return signed(sum(1 << k for k in range(BANK) if is_on(first + k)))


def checked(number: int, last: int = LAST_CHANNEL, what: str = "input") -> int:
    """Return the number; raise Rejected if no such channel or bank exists."""
    if not 0 <= number <= last:
        raise Rejected("channel", f"there is no {what} {number}", f"they are numbered 0 to {last}")
    return number


# ----------------------------------------------------------------------------------------------- operations


def read_bank(environment: Environment, row: Keyword) -> Operation:
    inputs = environment.component(Inputs)
    return lambda bank: inputs.traced(bits_of(bank, inputs.read), bank * BANK, BANK)


def read_bit(environment: Environment, row: Keyword) -> Operation:
    """INX: make the operation that reads an input."""
    inputs, levels = environment.component(Inputs), environment.controller.inputs

    def read(channel: int) -> int:
        if inputs.shows_levels and 0 <= channel <= LAST_CHANNEL and not levels.traces:
            return 1 if levels.inverted(channel) else 0
        return inputs.traced(int(inputs.read(checked(channel))), channel)

    return read


def read_level_bank(environment: Environment, row: Keyword) -> Operation:
    inputs = environment.component(Inputs)
    return lambda bank: inputs.traced(bits_of(bank, inputs.level), bank * BANK, BANK)


def read_level_bit(environment: Environment, row: Keyword) -> Operation:
    inputs = environment.component(Inputs)
    return lambda channel: inputs.traced(int(inputs.level(checked(channel))), channel)


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
            "The digital inputs of a bank as bits; default: bank 0. Reading clears latched edges.",
            "PRINT IN(0) & 3", default=0.0, group="io", driven="input"),
    Keyword("INX", "", "reading", "R", "input", "bool", Actions(read=read_bit),
            "One digital input: 1 when it is active or, with its INPUTMODE bit set, when its edge has come.",
            "PRINT INX(3)", default=0.0, group="io", driven="input", meant="DI INPUTX"),
    Keyword("INSTATE", "", "reading", "R", "bank", "bits", Actions(read=read_level_bank),
            "The electrical levels of a bank of inputs, whatever their active level and edges. With debouncing they "
            "are those of the last sample.",
            "PRINT INSTATE(0)", default=0.0, group="io", driven="input"),
    Keyword("INSTATEX", "isx", "reading", "R", "input", "bool", Actions(read=read_level_bit),
            "The electrical level of one input; with debouncing, at the last sample.",
            "PRINT INSTATEX(3)", default=0.0, group="io", driven="input"),
    Keyword("INPUTACTIVELEVEL", "", "setting", "RW", "bank", "bits", _ACTIVE_LEVEL,
            "Bit pattern of the inputs that are active while their level is high; the others are active low.",
            "INPUTACTIVELEVEL(0) = 0xFFFE\nPRINT INX(0)", default=-1.0, group="io"),
    Keyword("INPUTDEBOUNCE", "idb", "setting", "RW", "bank", "integer", _DEBOUNCE,
            "Number of consecutive samples, 1 ms apart, with the new level before the state of an input follows. "
            "1 is no debouncing.",
            "INPUTDEBOUNCE(0) = 5\nPRINT INPUTDEBOUNCE(0)", default=float(UNDEBOUNCED), low=1, high=10,
            group="io"),
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
