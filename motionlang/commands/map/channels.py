"""Inputs, outputs and the other devices of a program: what reads and writes each of them, and its name."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from motionlang.kernel.lang import CHANNELS, READ, WRITE, ChannelUse, Named, Read, Structure
from motionlang.kernel.tools import ranges

# The keys of the machine file that assign an input to an axis.
_WIRED = re.compile(r"axis\.(\d+)\.(\w+)_input")
# The channels that a loop may poll, by the kind of reading.
DEVICES = {"input": "input", "analogue": "analogue input", "encoder": "encoder", "operator": "key"}
# The tables of the machine file whose entries may name a channel.
_TABLES = {"input": "input", "analogue input": "analog"}


@dataclass(eq=False, slots=True)
class Channel:
    """A channel: `kind` is one of `CHANNELS`, `number` its text, "?" for all that are known only at run time.

    The lists have lines: those that read and write it, those at which a task waits for it, and those that assign it to
    function of an axis. `starts` is what its change starts. `values` are the texts of what is written,
    `decides` the conditions that read it, each with its line. `names_at` are the offsets of the keywords that use it.
    """

    kind: str
    number: str
    name: str = ""
    named_by: str = ""
    reads: list[int] = field(default_factory=list)
    writes: list[int] = field(default_factory=list)
    waits: list[int] = field(default_factory=list)
    set_up: list[int] = field(default_factory=list)
    starts: list[str] = field(default_factory=list)
    values: list[str] = field(default_factory=list)
    names_at: set[int] = field(default_factory=set)
    decides: dict[str, None] = field(default_factory=dict)

    @property
    def title(self) -> str:
        """Its kind and number, such as "input 3"; an answer has a prompt in place of a number."""
        return self.kind if self.kind == "answer" else f"{self.kind} {self.number}".strip()

    @property
    def known_as(self) -> str:
        """Its kind, number and name, such as "input 3 (start)"."""
        return f"{self.title} ({self.name})" if self.name else self.title

    @property
    def direction(self) -> str:
        """ "in" or "out"; "in/out" of what a program may write and read."""
        if "output" in self.kind:
            return "out"
        is_read = bool(self.reads or self.waits or self.starts)
        if self.writes:
            return "in/out" if is_read else "out"
        return "in" if is_read or "input" in self.kind else ""

    @property
    def is_used(self) -> bool:
        """False if the program neither uses it nor is started by it."""
        return bool(self.lines or self.starts)

    @property
    def lines(self) -> list[int]:
        """All lines that use it."""
        return sorted({*self.reads, *self.writes, *self.waits, *self.set_up})

    def sentences(self) -> list[str]:
        """Return what it is and where it is used, a sentence each."""
        found = [self.known_as]
        for word, at in (("waited for", self.waits), ("read", self.reads), ("written", self.writes)):
            if at:
                found.append(
                    f"{word} at line {ranges(at)}" if len(at) == 1 else f"{word} at lines {ranges(at)}"
                )
        return found + [f"starts {each}" for each in self.starts]


def channels(
    structure: Structure,
    settings: Mapping[str, object],
    names: Sequence[Named],
    comments: Mapping[int, str],
) -> list[Channel]:
    """Return the channels of a program, in the order of `CHANNELS` and their numbers.

    `names` are those of the comments that list channels, `comments` the comments at the end of lines with code.
    """
    found: dict[tuple[str, str], Channel] = {}
    in_loops = polled(structure)
    uses = [
        (use, bool(statement.waits) or _is_polled(use, in_loops.get(statement.line, ())), statement.condition)
        for statement in structure.statements.values()
        for use in statement.channels
    ]
    outputs = {use.number for use, *_ in uses if use.channel == "output" and use.access == WRITE}
    for use, waits, condition in uses:
        kind = use.channel
        if kind == "digital" or (kind == "input" and structure.has_one_series):
            kind = "output" if use.number in outputs else "input"
        channel = found.setdefault((kind, use.number), Channel(kind, use.number))
        if kind == "answer":
            channel.name, channel.named_by = use.number, "program"
        channel.names_at.add(use.name_at)
        line = structure.line(use.at)
        _enter(channel, use, line, waits)
        if condition and use.access == READ:
            channel.decides[f"{line}: {condition}"] = None
    for key, value in settings.items():
        wired = _WIRED.fullmatch(key)
        if wired is not None and isinstance(value, int):
            given = found.setdefault(("input", str(value)), Channel("input", str(value)))
            given.starts.append(f"{wired[2].replace('_', ' ')} of axis {wired[1]} (machine file)")
    for unit in structure.units:
        for trigger in unit.triggers:
            place = trigger.channel, trigger.number
            found.setdefault(place, Channel(*place)).starts.append(unit.title)
    for channel in found.values():
        _name(channel, settings, names, comments)
    return sorted(found.values(), key=order_of)


def polled(structure: Structure) -> dict[int, set[Read]]:
    """Map the lines of each loop that waits for a reading to what it reads.

    If it also waits in another way, only the readings that end it count.
    """
    elsewhere = {
        each.line
        for each in structure.statements.values()
        if each.waits not in ("", "time") or any(use.role == "call" for use in each.uses)
    }
    found: dict[int, set[Read]] = {}
    for loop in structure.waits.all():
        readings = loop.leaves if loop.lines & elsewhere else loop.leaves | loop.within
        for line in loop.lines:
            found.setdefault(line, set()).update(readings)
    return found


def only_named(names: Iterable[Named], channels: Iterable[Channel]) -> list[Named]:
    """Return the inputs and outputs that comments name and a program does not use.

    A channel whose number is only known while the program runs may be any of its kind, and so may one of a bank that is
    read.
    """
    channels = list(channels)
    used = {(each.kind, each.number) for each in channels}
    open_ended = {kind for kind, number in used if not number.isdecimal()}
    banks = [each.kind for each in channels if each.kind.endswith(" bank") and (each.reads or each.waits)]
    open_ended |= {kind.removesuffix(" bank") for kind in banks}
    return [
        each
        for each in names
        if each.kind in ("input", "output")
        and each.kind not in open_ended
        and (each.kind, str(each.number)) not in used
    ]


def _is_polled(use: ChannelUse, readings: Iterable[Read]) -> bool:
    """True if a loop that tests these readings polls a channel."""
    return any(
        DEVICES.get(kind) == use.channel and use.number in (str(number), "0" if number is None else "")
        for kind, number in readings
    )


def _enter(channel: Channel, use: ChannelUse, line: int, waits: bool) -> None:
    if use.access == READ:
        _add(channel.waits if waits else channel.reads, line)
    elif use.access == WRITE:
        _add(channel.writes, line)
        if use.value and use.value not in channel.values:
            channel.values.append(use.value)
    else:
        _add(channel.set_up, line)
        if use.value and use.value not in channel.starts:
            channel.starts.append(use.value)
    if use.alias and not channel.name:
        channel.name, channel.named_by = use.alias, "program"


def _add(lines: list[int], line: int) -> None:
    if line not in lines:
        lines.append(line)
        lines.sort()


def _name(
    channel: Channel, settings: Mapping[str, object], names: Iterable[Named], comments: Mapping[int, str]
) -> None:
    """Name a channel by the machine file, by a list in comments, or by the comment on its only line."""
    if channel.name or not channel.number.isdecimal():
        return
    entries = settings.get(_TABLES.get(channel.kind, ""), [])
    for entry in entries if isinstance(entries, list) else []:
        if str(entry.get("channel")) == channel.number and entry.get("name"):
            channel.name, channel.named_by = str(entry["name"]), "machine file"
            return
    for each in names:
        if each.kind == channel.kind and str(each.number) == channel.number:
            channel.name, channel.named_by = each.name, f"comment, line {each.line}"
            return
    lines = [line for line in channel.lines if line in comments]
    if len(lines) == 1:
        channel.name, channel.named_by = comments[lines[0]], f"comment, line {lines[0]}"


def order_of(channel: Channel) -> tuple[int, list[tuple[bool, int, str]]]:
    """Return the place of a channel among others, by kind and number."""
    parts = channel.number.split(", ")
    numbers = [(not each.isdecimal(), int(each) if each.isdecimal() else 0, each) for each in parts]
    return CHANNELS.index(channel.kind) if channel.kind in CHANNELS else len(CHANNELS), numbers
