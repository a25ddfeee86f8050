"""Inputs, outputs and the other devices of a program: what reads and writes each of them, and its name."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace

from motionlang.kernel import Dialect, Program
from motionlang.kernel.lang import (
    CHANNELS,
    READ,
    WRITE,
    ChannelUse,
    Named,
    Read,
    Structure,
    names_in_comments,
    remarks,
)
from motionlang.kernel.tools import ranges

# In the form of a statement: a call, in the head of a sub a parameter, an assignment to a variable, a result or TIME,
# and what else gives a value.
_CALL, _PARAMETER = re.compile(r"!~(\w+)\(([^()]*)\)"), re.compile(r"Parameter \w+ \w+ ~(\w+)")
_ASSIGNS = re.compile(r"(?:!?~|(?=TIME ))(\w+) = (.+)", re.DOTALL)
_GIVES = re.compile(r"(?:For \(|Input .*?)~(\w+)", re.DOTALL)
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
    remarks: Mapping[int, tuple[str, str]],
    has_one_series: bool,
) -> list[Channel]:
    """Return the channels of a program, in the order of `CHANNELS` and their numbers.

    `names` are those of the comments that list channels, `remarks` the names behind code, by line, with the
    number of a channel or "".
    """
    found: dict[tuple[str, str], Channel] = {}
    in_loops, parameters = polled(structure), _given_numbers(structure)
    uses = [
        (
            each,
            bool(statement.waits) or _is_polled(use, in_loops.get(statement.line, ())),
            statement.condition,
        )
        for statement in structure.statements.values()
        for use in statement.channels
        for each in _with_number(use, parameters)
    ]
    outputs = {use.number for use, *_ in uses if use.channel == "output" and use.access == WRITE}
    for use, waits, condition in uses:
        kind = use.channel
        if kind == "digital" or (kind == "input" and has_one_series):
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
    _name(found.values(), settings, names, remarks)
    return sorted(found.values(), key=order_of)


def _with_number(use: ChannelUse, given: Mapping[str, Sequence[str]]) -> list[ChannelUse]:
    """Return the use of a channel, of each one if its number is a variable with known values."""
    numbers = given.get(use.alias.lower(), ()) if use.number == "?" else ()
    return [replace(use, number=each, alias="") for each in numbers] or [use]


def _parameters_of(structure: Structure) -> dict[str, list[str]]:
    """Return the names of the parameters of each sub, all in small letters."""
    return {unit.name.lower(): _PARAMETER.findall(unit.head) for unit in structure.units}


def _given_numbers(structure: Structure) -> dict[str, list[str]]:
    """Map variables, and parameters of subs, to the numbers that the program gives them, if all are known."""
    names = _parameters_of(structure)
    found: dict[str, dict[str, None]] = {}
    for each in structure.statements.values():
        assigned = _ASSIGNS.fullmatch(each.form)
        given = [(name, "") for name in _GIVES.findall(each.form)]
        given += [(assigned[1], assigned[2])] if assigned is not None else []
        for name, values in _CALL.findall(each.form):
            given += zip(names.get(name, ()), values.split(", "), strict=False)
        for name, value in given:
            found.setdefault(name, {})[value] = None
    return {name: list(known) for name, known in found.items() if all(map(str.isdecimal, known))}


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
    read, or written with more than 0.
    """
    channels = list(channels)
    used = {(each.kind, each.number) for each in channels}
    open_ended = {kind for kind, number in used if not number.isdecimal()} | _banks(channels).keys()
    return [
        each
        for each in names
        if each.kind in ("input", "output")
        and each.kind not in open_ended
        and (each.kind, str(each.number)) not in used
    ]


def in_bank(names: Iterable[Named], channels: Iterable[Channel]) -> list[Channel]:
    """Return the inputs and outputs that comments name and a program uses by their bank alone, if it has one."""
    channels = list(channels)
    used, banks = {(each.kind, each.number) for each in channels}, _banks(channels)
    found: dict[tuple[str, int], Channel] = {}
    for each in names:
        key, own = (each.kind, each.number), banks.get(each.kind, [])
        if len(own) == 1 and (each.kind, str(each.number)) not in used and key not in found:
            bank, named_by = own[0], f"comment, line {each.line}"
            lines = [*bank.reads], [*bank.writes], [*bank.waits]
            found[key] = Channel(each.kind, str(each.number), each.name, named_by, *lines)
    return list(found.values())


def _banks(channels: Iterable[Channel]) -> dict[str, list[Channel]]:
    """Return the banks that are read, or written with more than 0, by the kind of their channels."""
    found: dict[str, list[Channel]] = {}
    for each in channels:
        is_used = each.reads or each.waits or any(value != "0" for value in each.values)
        if each.kind.endswith(" bank") and is_used:
            found.setdefault(each.kind.removesuffix(" bank"), []).append(each)
    return found


def _is_polled(use: ChannelUse, readings: Iterable[Read]) -> bool:
    return any(
        DEVICES.get(kind) == use.channel and use.number in (str(number), "0" if number is None else "")
        for kind, number in readings
    )


def _enter(channel: Channel, use: ChannelUse, line: int, waits: bool) -> None:
    if use.access == READ:
        _add(channel.waits if waits else channel.reads, line)
    elif use.access == WRITE:
        _add(channel.writes, line)
        value = f"on for {use.value} ms" if use.unit == "ms" else use.value
        if use.value and value not in channel.values:
            channel.values.append(value)
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
    channels: Collection[Channel],
    settings: Mapping[str, object],
    names: Sequence[Named],
    remarks: Mapping[int, tuple[str, str]],
) -> None:
    """Name channels by the machine file, by a list in comments, or by the remark on the only reading of one alone.

    A remark such as "3 = gate" names that channel of its line. A number in a list of channels names the input, or the
    output if no input has it.
    """
    listed = {(each.kind, str(each.number)): each for each in reversed(names)}
    inputs = {each.number for each in channels if each.kind == "input"}
    users = Counter(line for each in channels for line in each.lines)
    for channel in channels:
        kind, number = channel.kind, channel.number
        if channel.name or not number.isdecimal():
            continue
        entries = settings.get(_TABLES.get(kind, ""), [])
        given = (
            (each for each in entries if str(each.get("channel")) == number)
            if isinstance(entries, list)
            else ()
        )
        name = next((str(each["name"]) for each in given if each.get("name")), "")
        is_either = kind == "input" or (kind == "output" and number not in inputs)
        others = {"comms element": "network data"} | ({kind: "channel"} if is_either else {})
        found = listed.get((kind, number)) or listed.get((others.get(kind, ""), number))
        numbered = (at for at in channel.lines if remarks.get(at, ("", ""))[0] == number)
        line = next(numbered, channel.lines[0] if len(channel.names_at) == 1 and channel.lines else 0)
        remark = remarks.get(line, ("?", ""))
        if name:
            channel.name, channel.named_by = name, "machine file"
        elif found is not None:
            channel.name, channel.named_by = found.name, f"comment, line {found.line}"
        elif remark[0] == number or (not remark[0] and users[line] == 1 and line not in channel.writes):
            channel.name, channel.named_by = remark[1], f"comment, line {line}"


def order_of(channel: Channel) -> tuple[int, list[tuple[bool, int, str]]]:
    """Return the place of a channel among others, by kind and number."""
    parts = channel.number.split(", ")
    numbers = [(not each.isdecimal(), int(each) if each.isdecimal() else 0, each) for each in parts]
    return CHANNELS.index(channel.kind) if channel.kind in CHANNELS else len(CHANNELS), numbers


def channels_of(program: Program, language: Dialect) -> list[Channel]:
    """Return only the channels of a program; ProgramError with all errors of the text."""
    source = program.source
    names = names_in_comments(source, language)
    return channels(
        program.structure, program.settings, names, remarks(source, language), language.has_one_series
    )
