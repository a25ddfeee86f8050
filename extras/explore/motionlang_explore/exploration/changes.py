"""Changes of the world: an input, a level, a number of a host, a key, an answer, each at its moment."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Hashable, Iterable, Mapping
from typing import NamedTuple

from motionlang.kernel.lang import DRIVES
from motionlang.kernel.tools import count_of
from motionlang_explore.identification import Entry

# The tables of the machine file with the changes of the world, and those of them that have texts, and no numbers.
TABLES = ("input", "analogue", "comms", "netdata", "modbus.register", "key", "answer")
TEXTS = ("key", "answer")
# The tables whose whole numbers are integers.
WHOLE = ("netdata", "modbus.register")
# A channel of the world: its table, and its number there, 0 for a key or an answer.
Channel = tuple[str, int]
# The number of a Modbus register is that in its server, and so many for each number of the server.
REGISTERS = 65536


class Moment(NamedTuple):
    """The moment of a change of an input: so long after a change at rest, s, while a line moves an axis.

    With a period, `every`, s, the input comes and goes so many times. `line` is 0 at rest.
    """

    delay: float = 0.0
    axis: int = 0
    line: int = 0
    times: int = 1
    every: float = 0.0

    def __str__(self) -> str:
        often = f" {count_of(self.times, 'time')}" if self.every and self.times > 1 else ""
        return f"{often} while axis {self.axis} moves (line {self.line})" if self.line else often


AT_REST = Moment()


class Change(NamedTuple):
    """A change of the world: an input, an analogue input, a number of a host, a Modbus register, a key, or an answer.

    A key and an answer have the number 0, and their text as the value; `prompt` is the question. `keys_of` splits the
    number of a register. Only an input changes at another `moment` than at rest.
    """

    table: str
    number: int
    value: float | str
    prompt: str = ""
    moment: Moment = AT_REST

    @property
    def channel(self) -> Channel:
        """The channel that changes."""
        return self.table, self.number

    @property
    def kind(self) -> Hashable:
        """An input and its level, or another channel and any value of it, at whatever moment."""
        value = self.value if self.table == "input" else None
        return self.table, self.number, self.prompt, value

    def levels(self, time: float) -> list[tuple[float, float]]:
        """Return the times and levels of an input that changes at a time, and comes and goes from then on."""
        assert isinstance(self.value, (int, float))
        every = self.moment.every
        if not every:
            return [(time, self.value)]
        return [
            each
            for start in (time + k * every for k in range(self.moment.times))
            for each in ((start, self.value), (start + every / 2, 1 - self.value))
        ]

    @property
    def subject(self) -> str:
        """The name of what is changed."""
        if self.table in TEXTS:
            return "a key" if self.table == "key" else f"an answer to {self.prompt!r}"
        keys = keys_of(self.table, self.number)
        server = f" of server {keys['server']}" if "server" in keys else ""
        return f"{DRIVES[self.table][0]} {keys[DRIVES[self.table][1]]}{server}"

    def __str__(self) -> str:
        if self.table == "input":
            level, other = ("on", "off") if self.value else ("off", "on")
            again = f" and {other} again" if self.moment.every and self.moment.times == 1 else ""
            return f"{self.subject} {level}{again}{self.moment}"
        if self.table == "key":
            return f"key {self.value}".replace("{Enter}", " Enter").replace("\r", "Enter")
        if self.table == "answer":
            return f"{self.prompt!r} {self.value}"
        assert isinstance(self.value, (int, float))
        return f"{self.subject} = {self.value:.10g}"


def in_words(changes: Iterable[Change]) -> str:
    """Return changes in words; those in the middle of a move come later."""
    text = ""
    for each in changes:
        text += f"{', then ' if each.moment.line else ' and '}{each}" if text else str(each)
    return text


# Changes with their times, in order.
Timeline = tuple[tuple[float, Change], ...]


def made_at(time: float, changes: Iterable[Change]) -> Timeline:
    """Return changes with their times: at rest at a time, or at another moment that counts from it."""
    return tuple((time + each.moment.delay, each) for each in changes)


def merged(base: Mapping[str, object], tables: Mapping[str, object]) -> dict[str, object]:
    """Return settings with the entries of some tables added to their own."""
    added = {
        table: [*entries(base, table), *entries(tables, table)] if table in TABLES else value
        for table, value in tables.items()
    }
    return {**base, **added}


def entries(settings: Mapping[str, object], table: str) -> list[Entry]:
    """Return the entries of a table of settings."""
    found: list[Entry] = settings.get(table, [])  # type: ignore[assignment]
    return found


def given_in(settings: Mapping[str, object]) -> set[Channel]:
    """Return the channels that settings have entries for, as table and number; answers and keys have the number 0."""
    return {(table, number_in(table, each)) for table in TABLES for each in entries(settings, table)}


def keys_of(table: str, number: int) -> Entry:
    """Return the keys of an entry that name a channel by its number, none for a key or an answer."""
    if table == "modbus.register":
        server, number = divmod(number, REGISTERS)
        return {"server": server, "register": number}
    return {DRIVES[table][1]: number} if DRIVES[table][1] else {}


def number_in(table: str, entry: Entry) -> int:
    """Return the number of the channel of an entry, 0 for a key or an answer."""
    server: int = entry.get("server", 0)  # type: ignore[assignment]
    number: int = entry.get(DRIVES[table][1], 0)  # type: ignore[assignment]
    return server * REGISTERS + number


def tables_of(timeline: Timeline, since: float = 0.0) -> dict[str, object]:
    """Return the tables of a machine file with the changes of a timeline; their times count from `since`."""
    tables: dict[str, list[dict[str, object]]] = defaultdict(list)
    for time, change in timeline:
        entry = keys_of(change.table, change.number)
        if change.table == "input":
            tables["input"] += (
                entry | {"at": at - since, "value": level} for at, level in change.levels(time)
            )
            continue
        if change.table != "answer":
            entry["at"] = time - since
        elif change.prompt:
            entry["prompt"] = change.prompt
        tables[change.table].append(entry | {_value_key(change.table): change.value})
    return dict(tables)


def made_by(table: str, entry: Entry) -> tuple[float, Change]:
    """Return the change that an entry makes, with its time; an answer has none."""
    value: float | str = entry.get(_value_key(table), 1.0)  # type: ignore[assignment]
    prompt, at = str(entry.get("prompt", "")), float(entry.get("at", 0.0))  # type: ignore[arg-type]
    return at, Change(table, number_in(table, entry), value, prompt)


def _value_key(table: str) -> str:
    return "text" if table in TEXTS else "value"


def is_about(change: Change, entry: Entry) -> bool:
    """True if an entry makes a change."""
    value = entry[_value_key(change.table)]
    return value == change.value and number_in(change.table, entry) == change.number


def levels_at(timeline: Timeline, time: float) -> dict[int, float]:
    """Return the levels of the inputs that a timeline has changed by a time."""
    return {
        change.number: level
        for at, change in timeline
        if change.table == "input"
        for start, level in change.levels(at)
        if start <= time + 1e-9
    }


def channel_levels(timeline: Timeline, time: float) -> dict[Channel, float]:
    """Return the levels of the inputs, analogue ones too, that a timeline has changed by a time."""
    inputs = {("input", number): level for number, level in levels_at(timeline, time).items()}
    analogue = ((at, each) for at, each in timeline if each.table == "analogue")
    return inputs | {each.channel: float(each.value) for at, each in analogue if at <= time}
