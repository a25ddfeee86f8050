"""Modbus: the program as a client of servers.

The machine file defines the servers. A register is a word of 16 bits. An Integer or a Float takes two
registers, the lower half first, as in Mint's own server (ABB AN00198 p. 5). Requests take no time.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from math import inf
from struct import pack, unpack

from motionlang.kernel.controller.io.asking import AskedRule, Responder
from motionlang.kernel.controller.io.reads import ReadObserver
from motionlang.kernel.errors import Rejected
from motionlang.kernel.lang.keyword import Actions, Keyword
from motionlang.kernel.lang.machine.keys import DRIVES
from motionlang.kernel.mint.runtime.binding import Maker, of
from motionlang.kernel.mint.runtime.changes import repeatable
from motionlang.kernel.mint.runtime.environment import Environment
from motionlang.kernel.traced import reading

Entry = Mapping[str, object]


LAST = 65535
_LARGEST_FLOAT = 3.4028235677973366e38  # larger numbers round to infinity in 32 bits


class RegisterServer:
    """One server: its registers `first` to `last`, and the times when it answers."""

    def __init__(self, first: int = 0, last: int = LAST, begin: float = 0.0, end: float = inf) -> None:
        self.first, self.last, self.begin, self.end = first, last, begin, end
        self.words: dict[int, int] = {}
        self.written: set[int] = set()


class Servers:
    """The servers of the machine file; if it defines none, every server exists."""

    def __init__(self, environment: Environment) -> None:
        self._clock, self._machine = environment.clock, environment.machine
        self._controller = environment.controller
        self.observer: ReadObserver | None = None
        self.traces = False
        self._servers: dict[int, RegisterServer] = {}
        for entry in self._entries("modbus.server"):
            self._declare(entry)
        for entry in self._entries("modbus.register"):
            self._schedule(entry)
        self._named = bool(self._servers)
        self._machine.written.append(self.written)
        self._machine.receivers["modbus.register"] = self._schedule
        self._controller.reads.join(self)

    def _entries(self, table: str) -> Sequence[Entry]:
        return self._machine.settings.get(table, ())  # type: ignore[return-value]

    def _declare(self, entry: Entry) -> None:
        begin: float = entry.get("at", 0.0)  # type: ignore[assignment]
        end: float = begin + entry.get("for", inf)  # type: ignore[operator]
        first: int = entry.get("first", 0)  # type: ignore[assignment]
        last: int = entry.get("last", LAST)  # type: ignore[assignment]
        server = self._servers[entry["id"]] = RegisterServer(first, last, begin, end)  # type: ignore[index]
        given: Mapping[str, int] = entry.get("registers", {})  # type: ignore[assignment]
        server.words.update((int(register), word & LAST) for register, word in given.items())
        for time in (begin, end):
            if self._clock.now < time < inf:
                self._clock.at(time, _nothing)  # tasks that wait for the server check again

    def _schedule(self, entry: Entry, since: float = 0.0) -> None:
        """Schedule a change of registers from the machine file; its times count from `since`.

        It is not made by a client, so it may also change registers that clients cannot write.
        """
        server = self._servers.setdefault(entry["server"], RegisterServer())  # type: ignore[arg-type]
        register: int = entry["register"]  # type: ignore[assignment]
        if "asked" in entry:
            self._answer(server, entry, register, since)
            return
        change = partial(_put, server, register, _words(entry))
        stimuli = self._controller.stimuli
        stimuli.add("modbus.register", entry, change, since, at_once=True)

    def _answer(self, server: RegisterServer, entry: Entry, register: int, since: float) -> None:
        """Write an entry when the program asks for its register and it has another value."""
        number: int = entry["server"]  # type: ignore[assignment]

        def current(count: int = 2) -> list[int]:
            return [server.words.get(register + k, 0) for k in range(count)]

        def other(rule: AskedRule) -> list[int] | None:
            words = _words(rule.stimulus.entry)
            return None if words == current(len(words)) else words

        def put(rule: AskedRule, words: object) -> None:
            _put(server, register, words)  # type: ignore[arg-type]

        def name(rule: AskedRule, words: object) -> str:
            what = f"{DRIVES['modbus.register'][0]} {register} of server {number}"
            return f"{what} = {rule.stimulus.entry['value']:.10g}"

        responder = Responder(name, current, other, put)
        key = number * (LAST + 1) + register
        self._controller.answering().add("modbus.register", key, entry, since, responder)

    # ------------------------------------------------------------------------------------------ the client's side

    def read(self, number: int, register: int, count: int) -> list[int]:
        """Return registers of a server; raise Rejected if it does not answer."""
        if self.observer is not None:
            self.observer("modbus.register", number * (LAST + 1) + register)
        words = self._reached(number, register, count).words
        found = [words.get(register + k, 0) for k in range(count)]
        if self.traces:
            found = [
                reading(word, "modbus.register", number * (LAST + 1) + register + k)
                for k, word in enumerate(found)
            ]
        return found

    def write(self, number: int, register: int, value: float, width: str) -> None:
        words = words_of(value, width)
        server = self._reached(number, register, len(words))
        server.written.update(range(register, register + len(words)))
        before = [server.words.get(register + k, 0) for k in range(len(words))]
        if words != before:
            target = f"{DRIVES['modbus.register'][0]} {register} of server {number}"
            self._machine.log.write(self._clock.now, target, value)
        _put(server, register, words)

    def _reached(self, number: int, register: int, count: int) -> RegisterServer:
        server = self._servers.get(number)
        if server is None and not self._named:
            self._machine.notes.setdefault(
                f"Modbus server {number}: no [[modbus.server]] of the machine file says what it holds, so its "
                "registers are 0 until the program writes them"
            )
            server = self._servers[number] = RegisterServer()
        if server is None or not server.begin <= self._clock.now < server.end:
            known = ", ".join(map(str, self._servers))
            hint = (
                f"the machine file has the servers {known}" if server is None else "its at and for say when"
            )
            raise Rejected("no-connection", f"Modbus server {number} does not answer", hint)
        if not server.first <= register <= register + count - 1 <= server.last:
            what = f"register {register}" if count == 1 else f"registers {register} and {register + 1}"
            limits = f"its registers are {server.first} to {server.last}"
            raise Rejected("channel", f"Modbus server {number} rejects {what}", limits)
        return server

    def written(self) -> list[dict[str, object]]:
        """Return the registers that the program wrote, as rows of the report."""
        return [
            {"server": number, "kind": "register", "number": register, "value": server.words[register]}
            for number, server in sorted(self._servers.items())
            for register in sorted(server.written)
        ]


def _put(server: RegisterServer, register: int, words: Sequence[int]) -> None:
    for k, word in enumerate(words):
        server.words[register + k] = word


def _nothing() -> None:
    """Do nothing: the event only makes tasks check again."""


def _words(entry: Entry) -> list[int]:
    value: float = entry["value"]  # type: ignore[assignment]
    return words_of(value, str(entry.get("as", "word" if isinstance(value, int) else "float")))


def words_of(value: float, width: str) -> list[int]:
    """Return a "word", an "integer" or a "float" as registers, the lowest half first."""
    if width == "word":
        return [int(value) & LAST]
    whole = int(value) & 0xFFFFFFFF if width == "integer" else _bits(value)
    return [whole & LAST, whole >> 16]


def _bits(value: float) -> int:
    if not abs(value) < _LARGEST_FLOAT:
        value = inf if value > 0 else -inf if value < 0 else value
    bits: int = unpack("<I", pack("<f", value))[0]
    return bits


# ----------------------------------------------------------------------------------------------- operations


def read_word(servers: Servers, server: int, register: int) -> int:
    return servers.read(server, register, 1)[0]


def unpacked(code: str) -> Maker:
    """Make an operation that reads two registers of a server as one number."""

    def read(servers: Servers, server: int, register: int) -> object:
        return unpack(code, pack("<HH", *servers.read(server, register, 2)))[0]

    return of(Servers, read)


def writes(width: str) -> Maker:
    """Make an operation that writes a value to a server; for widths see `words_of`."""

    def write(servers: Servers, server: int, register: int, value: float) -> None:
        servers.write(server, register, value, width)

    return repeatable(of(Servers, write))


# ------------------------------------------------------------------------------------------------- keywords

# MODBUSTCP16: one register of a server. The other keywords use two.
_WORD = Actions(read=of(Servers, read_word), write=writes("word"))
_WHOLE = Actions(read=unpacked("<i"), write=writes("integer"))
_REAL = Actions(read=unpacked("<f"), write=writes("float"))

_CLIENT = (
    ("MODBUSTCP16", "integer", _WORD, -32768, 65535, "1234",
     "One register of a Modbus server, 0 to 65535; a negative value is written as its two's complement."),
    ("MODBUSTCP32", "integer", _WHOLE, None, None, "123456",
     "Two registers of a Modbus server as an Integer, the lower half in the first."),
    ("MODBUSTCPFLOAT", "number", _REAL, None, None, "2.5",
     "Two registers of a Modbus server as a 32-bit float, the lower half in the first."),
)  # fmt: skip


ROWS = (
    *(
        Keyword(name, "", "setting", "RW", "server, register", unit, actions, help,
                f"{name}(4, 6) = {value}\nPRINT {name}(4, 6)", default=0.0, low=low, high=high, group="comms")
        for name, unit, actions, low, high, value, help in _CLIENT
    ),
)  # fmt: skip
