"""The machine file: its whole vocabulary, read and checked.

`machine.toml` has plain keys (`controller.axes`), keys of an axis (`axis.0.travel`, `N` in the table) and tables of
things that happen (`[[input]]`). Every key has a default; one that does not exist, or a value of the wrong kind, is a
diagnostic with its line.
"""

from __future__ import annotations

from motionlang.errors import Diagnostic, ProgramError, nearest
from motionlang.lang.dialect import dialect, unknown_model

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from motionlang.source import Source

MAX_AXES = 64
# key -> (kind, help). A pair is two numbers, the first not above the second.
KEYS: dict[str, tuple[str, str]] = {
    "controller.model": ("text", "The model to behave like; empty for the dialect's own default."),
    "controller.axes": ("count", f"The number of axes, 1 to {MAX_AXES}."),
    "controller.instruction_time": ("time", "What one statement costs, 1e-9 to 1 second of machine time."),
    "run.until": ("time", "The machine time at which the scenario, and with it the run, ends, in seconds."),
    "axis.N.travel": ("pair", "The positions of the two limit switches, in user units."),
    "axis.N.forward_input": ("channel", "The input that shows the forward limit switch."),
    "axis.N.reverse_input": ("channel", "The input that shows the reverse limit switch."),
    "axis.N.home_switch": ("pair", "From where to where the home switch is active, in user units."),
    "axis.N.home_input": ("channel", "The input that shows the home switch."),
    "axis.N.enable_input": (
        "channel",
        "The input without which the drive cannot be enabled; it goes off with it.",
    ),
    "axis.N.index_every": ("positive", "The distance between index marks of the encoder, in user units."),
    "axis.N.motor": ("motor", "servo or stepper: on a MultiFlex a stepper has other settings at power-up."),
    "axis.N.start": (
        "number",
        "Where the machine stands at power-up, measured from its own zero, in user units.",
    ),
    "mint.readings.WORD": (
        "reading",
        "What a word of Mint reads whose value this program cannot know, such as DRIVEBUSVOLTS = 325, or "
        '{ "0" = 325, "1" = 326 } by what stands in its brackets.',
    ),
}
# The sections of a simulated motor and its loop; their keys are in `controller.servo.settings`.
SERVO = ("axis.N.plant.", "axis.N.servo.")
# The section of a dialect, whose words are the dialect's business.
_OF_DIALECTS = ("mint.readings.",)
# Tables of things that happen: table -> key -> (kind, help).
_WHEN = {
    "at": ("time", "The machine time at which it happens, in seconds."),
    "axis": ("channel", "The axis whose position decides."),
    "above": ("number", "Active from this position on, in user units."),
    "below": ("number", "Active up to this position, in user units."),
    "between": ("pair", "Active from the first position to the second, in user units."),
}
_TERMINAL = ("terminal", "The terminal at which that is done: 1, 2, 4 and so on up to 128; 1 unless given.")
_WRITTEN = {
    "value": ("number", "The value: a float in the comms array, elsewhere an integer where it is whole."),
    "as": ("view", "integer or float, to have it otherwise."),
    "text": ("text", "A text instead of a value, four characters an element, the first one highest."),
}
TABLES: dict[str, dict[str, tuple[str, str]]] = {
    "input": {
        "channel": ("channel", "The digital input."),
        "value": ("number", "The value while active, 1 unless given."),
        "for": ("positive", "How long it stays so, in seconds; for ever unless given."),
        "output": ("channel", "The digital output whose level it follows."),
        "delay": ("time", "How long after the output, in seconds; at once unless given."),
        **_WHEN,
    },
    "analogue": {
        "channel": ("channel", "The analogue input."),
        "value": ("number", "The value in percent."),
        "per_unit": (
            "number",
            "With an axis: what each user unit adds, from above, below or the first of between on; sampled at 1 kHz.",
        ),
        "for": ("positive", "How long it stays so, in seconds; for ever unless given."),
        **_WHEN,
    },
    "remote": {
        "bus": ("bus", "The bus of the remote node, 1 unless given."),
        "node": ("node", "The remote node."),
        "channel": ("channel", "Its digital input."),
        "analogue": ("channel", "Its analogue input, instead."),
        "encoder": ("channel", "Its encoder, instead."),
        "element": ("channel", "The element of its comms array, instead, 1 to 99."),
        "object": ("register", "The object of its dictionary, instead, such as 0x6041."),
        "sub": ("channel", "The sub-index of the object, 0 unless given."),
        "event": ("node event", "What becomes of the node, instead: live, dead or emergency."),
        "value": ("number", "The value: 1 unless given, percent, counts, or the code of the emergency."),
        "at": _WHEN["at"],
        "for": ("positive", "How long an input stays so, in seconds; for ever unless given."),
    },
    "bus": {
        "bus": ("bus", "The bus, 1 unless given."),
        "event": (
            "bus event",
            "operational, passive or off, which the bus then is; receive-overrun or transmit-overrun.",
        ),
        "at": _WHEN["at"],
    },
    "pdo": {
        "bus": ("bus", "The bus, 1 unless given."),
        "cobid": ("register", "The identifier of the process data, such as 0x182."),
        "bank": ("bit", "Its lower 32 bits, 0, as unless given, or its upper ones, 1."),
        "value": ("number", "What it brings."),
        "at": _WHEN["at"],
    },
    "modbus.server": {
        "id": ("channel", "The number by which the program knows the server."),
        "first": ("register", "Its first register, 0 unless given."),
        "last": ("register", "Its last register, 65535 unless given; others are refused."),
        "registers": ("registers", "What registers hold from the beginning, 0 unless given."),
        "at": ("time", "From when on it answers, in seconds; from the beginning unless given."),
        "for": ("positive", "How long it answers, in seconds; for ever unless given."),
    },
    "modbus.register": {
        "server": ("channel", "The server in which something changes."),
        "register": ("register", "The register, or the first of the two."),
        "value": ("number", "The value from then on."),
        "as": (
            "width",
            "word, one register; integer or float, two. A whole number is a word, another one a float.",
        ),
        "at": _WHEN["at"],
    },
    "coil": {
        "coil": ("register", "The coil of the controller that a Modbus client writes."),
        "value": ("number", "The value, 1 unless given."),
        "at": _WHEN["at"],
        "for": ("positive", "How long it stays so, in seconds; for ever unless given."),
    },
    "fault": {
        "axis": ("channel", "The axis that suffers it; none for controller."),
        "kind": ("fault", "following-error, error-input, forward-limit, reverse-limit, drive or controller."),
        "value": ("channel", "The bits that DRIVEERROR and MISCERROR then show; 1 unless given."),
        "line": (
            "line",
            "The line of the program that brings it about, when it is reached for the first time.",
        ),
        **{key: _WHEN[key] for key in ("at", "above", "below")},
    },
    "key": {
        "at": _WHEN["at"],
        "text": ("text", "Keys that the operator presses, for INKEY."),
        "for": ("positive", "How long the last one is held, in seconds, for READKEY; 0.1 unless given."),
        "terminal": _TERMINAL,
    },
    "encoder": {
        "channel": ("channel", "The encoder that something in the world turns, such as a conveyor."),
        "aux": ("channel", "The auxiliary encoder, instead."),
        "velocity": ("number", "How fast it turns, in counts a second, until another entry says otherwise."),
        "accel": ("positive", "How fast it comes to that, in counts/s²; at once unless given."),
        "index_every": ("positive", "The distance between its index marks, in counts; none unless given."),
        "at": _WHEN["at"],
    },
    "answer": {"text": ("text", "What the operator types at the next INPUT."), "terminal": _TERMINAL},
    "serial": {
        "port": ("port", "The serial port, 1 unless given."),
        "text": ("text", "The characters that come in there, for SERIALCHAR."),
        "at": _WHEN["at"],
    },
    "comms": {
        "at": _WHEN["at"],
        "element": ("channel", "The element of the comms array that the host writes, 1 to 99."),
        **_WRITTEN,
    },
    "dpr": {
        "at": _WHEN["at"],
        "address": ("dpr", "The address of the dual-port RAM that the host writes, 0 to 4095."),
        **_WRITTEN,
    },
    "netdata": {
        "at": _WHEN["at"],
        "element": ("channel", "The NetData location that the host writes, 0 to 999."),
        **_WRITTEN,
    },
}
REQUIRED = {
    "input": ("channel",),
    "analogue": ("channel", "value"),
    "remote": ("node",),
    "bus": ("event",),
    "pdo": ("cobid", "value"),
    "modbus.server": ("id",),
    "modbus.register": ("server", "register", "value"),
    "coil": ("coil",),
    "fault": ("kind",),
    "key": ("text",),
    "encoder": ("velocity",),
    "answer": ("text",),
    "serial": ("text",),
    "comms": ("element",),
    "netdata": ("element",),
    "dpr": ("address",),
}
VIEWS = ("integer", "float")
TERMINALS = (1, 2, 4, 8, 16, 32, 64, 128)
WIDTHS = ("word", "integer", "float")
NODE_EVENTS = ("live", "dead", "emergency")
BUS_EVENTS = ("operational", "passive", "off", "receive-overrun", "transmit-overrun")
# What an entry of [[remote]] is about.
_OF_A_NODE = ("channel", "analogue", "encoder", "element", "object", "event")
LAST_REGISTER = 65535
MOTORS = ("servo", "stepper")
FAULT_KINDS = ("following-error", "error-input", "forward-limit", "reverse-limit", "drive", "controller")


def read_machine(source: Source) -> dict[str, object]:
    """The settings of a machine file by their dotted keys, tables as lists; ProgramError with every mistake."""
    import tomllib

    try:
        tree = tomllib.loads(source.text)
    except tomllib.TOMLDecodeError as error:
        raise ProgramError([_toml_mistake(error)]) from None
    settings: dict[str, object] = {}
    mistakes: list[Diagnostic] = []
    for key, value in _flatten(tree):
        problems = list(_problems(key, value))
        mistakes.extend(_located(source, key, *problem) for problem in problems)
        if not problems:
            settings[key] = value
    if any(".plant." in key or ".servo." in key for key in settings):
        from motionlang.controller.servo.settings import mistakes as servo_mistakes

        for place, message, hint in servo_mistakes(settings):
            mistakes.append(_located(source, f"{place}.", message, hint, f"[{place}]"))
    if mistakes:
        raise ProgramError(mistakes)
    return settings


def check_setting(key: str, value: object) -> tuple[str, str] | None:
    """What is wrong with one plain setting, and a hint; None when nothing is."""
    row = KEYS.get(_generic(key))
    if row is None and _generic(key).startswith(SERVO):
        from motionlang.controller.servo import settings as servo

        return servo.setting_problem(key, _generic(key), value)
    if row is None:
        from motionlang.controller.servo.settings import KEYS as SERVO_KEYS

        near = nearest(_generic(key), (*KEYS, *TABLES, *SERVO_KEYS))
        words = f"did you mean {near}?" if near else f"the keys are {', '.join((*KEYS, *TABLES))}"
        return f"there is no key {key}", words
    problem = _kind_problem(row[0], value)
    if problem is None and key == "controller.axes" and not 1 <= value <= MAX_AXES:  # type: ignore[operator]
        problem = f"must be 1 to {MAX_AXES}"
    if problem is None and key == "controller.instruction_time" and not 1e-9 <= value <= 1.0:  # type: ignore[operator]
        problem = "must be 1e-9 to 1 second"
    if problem is None and key == "controller.model" and value:
        return unknown_model(str(value))
    if problem is None and key.startswith(_OF_DIALECTS):
        return dialect(key.partition(".")[0]).setting_problem(key, value)
    return None if problem is None else (f"{key} {problem}, not {value!r}", row[1])


def first_mistake(settings: Mapping[str, object]) -> str:
    """What is wrong with settings that a program gives, and a hint; empty when nothing is."""
    for key, value in settings.items():
        for message, hint, *_ in _problems(key, value):
            return f"{message} ({hint})"
    return ""


def _problems(key: str, value: object) -> Iterator[tuple[str, str, str, int]]:
    """Message, hint, the name to look for and in which entry, of each mistake in one key or table."""
    if key not in TABLES:
        problem = check_setting(key, value)
        if problem is not None:
            yield (*problem, key, 0)
        return
    if not isinstance(value, list) or not all(isinstance(entry, dict) for entry in value):
        yield f"{key} is a table of entries", f"write [[{key}]] above each", key, 0
        return
    for number, entry in enumerate(value):
        for each in _entry_problems(key, entry):
            yield (*each, number)


def _entry_problems(table: str, entry: Mapping[str, object]) -> Iterator[tuple[str, str, str]]:
    rows = TABLES[table]
    for name, value in entry.items():
        if name not in rows:
            near = nearest(name, rows)
            words = f"did you mean {near}?" if near else f"its keys are {', '.join(rows)}"
            yield f"[[{table}]] has no key {name}", words, name
            continue
        problem = _kind_problem(rows[name][0], value)
        if problem is not None:
            yield f"{name} of [[{table}]] {problem}, not {value!r}", rows[name][1], name
    for name in REQUIRED[table]:
        if name not in entry:
            yield f"[[{table}]] needs {name}", rows[name][1], f"[[{table}]]"
    yield from _when_problems(table, entry)
    if table == "fault" and "axis" not in entry and entry.get("kind") != "controller":
        yield "[[fault]] needs axis", rows["axis"][1], "[[fault]]"
    if table == "remote":
        yield from _remote_problems(entry)
    first, last = entry.get("first"), entry.get("last", LAST_REGISTER)
    if isinstance(first, int) and isinstance(last, int) and last < first <= LAST_REGISTER:
        yield f"[[{table}]] ends before it begins", "last is its last register", "last"
    if "per_unit" in entry and "axis" not in entry:
        yield f"[[{table}]] needs the axis whose position decides", "add axis = N", "per_unit"
    if table == "encoder" and ("channel" in entry) is ("aux" in entry):
        yield "[[encoder]] needs a channel or an aux", "channel = 2 is an encoder", "[[encoder]]"
    if table in ("comms", "netdata", "dpr"):
        yield from _written_problems(table, entry)


def _when_problems(table: str, entry: Mapping[str, object]) -> Iterator[tuple[str, str, str]]:
    """An entry comes about in one way: by time, by a position, by a line, or by an output."""
    where = [name for name in ("above", "below", "between", "line", "output") if name in entry]
    if len(where) > 1 or (where and "at" in entry):
        ways = (
            "line, or one of above, below" if table == "fault" else "output, or one of above, below, between"
        )
        what = "comes about" if table == "fault" else "is active"
        yield f"[[{table}]] {what} in one way only", f"give at, {ways}", where[0]
    if where and where[0] not in ("line", "output") and table != "fault" and "axis" not in entry:
        yield f"[[{table}]] needs the axis whose position decides", "add axis = N", where[0]


def _remote_problems(entry: Mapping[str, object]) -> Iterator[tuple[str, str, str]]:
    what = [name for name in _OF_A_NODE if name in entry]
    if len(what) != 1:
        yield (
            "[[remote]] needs a channel, an analogue, an encoder, an element, an object or an event",
            "one of them; channel = 0 is a digital input",
            "[[remote]]",
        )
    elif "for" in entry and what[0] not in ("channel", "analogue"):
        yield f"[[remote]] with {what[0]} takes no for", TABLES["remote"]["for"][1], "for"
    element = entry.get("element", 1)
    if isinstance(element, int) and not 1 <= element <= 99:
        yield (
            f"element of [[remote]] must be 1 to 99, not {element}",
            TABLES["remote"]["element"][1],
            "element",
        )


def _written_problems(table: str, entry: Mapping[str, object]) -> Iterator[tuple[str, str, str]]:
    low, high = (1, 99) if table == "comms" else (0, 999)
    element = entry.get("element")
    if isinstance(element, int) and not low <= element <= high:
        yield (
            f"element of [[{table}]] must be {low} to {high}, not {element}",
            TABLES[table]["element"][1],
            "element",
        )
    if ("value" in entry) is ("text" in entry):
        yield f"[[{table}]] needs a value or a text", 'value = 2.5, or text = "ABCD"', f"[[{table}]]"


def _kind_problem(kind: str, value: object) -> str | None:
    number = isinstance(value, (int, float)) and not isinstance(value, bool)
    finite = number and abs(value) < 1e300  # type: ignore[arg-type]
    whole = number and isinstance(value, int)
    tests = {
        "text": (isinstance(value, str), "must be a text"),
        "count": (whole, "must be a whole number"),
        "channel": (whole and 0 <= value < 1000, "must be a whole number from 0 to 999"),  # type: ignore[operator]
        "number": (finite, "must be a number"),
        "time": (finite and value >= 0, "must be a time, 0 or more"),  # type: ignore[operator]
        "positive": (finite and value > 0, "must be a number above 0"),  # type: ignore[operator]
        "pair": (_is_pair(value), "must be two numbers, the lower first"),
        "reading": (finite or isinstance(value, (bool, str)), "must be a number, a text, true or false"),
        "line": (whole and value > 0, "must be the number of a line"),  # type: ignore[operator]
        "register": (whole and 0 <= value <= LAST_REGISTER, f"must be 0 to {LAST_REGISTER}, whole"),  # type: ignore[operator]
        "registers": (_are_registers(value), 'must be words by their registers, such as { "6" = 1234 }'),
        "bus": (whole and 1 <= value <= 2, "must be 1 or 2"),  # type: ignore[operator]
        "node": (whole and 0 <= value <= 255, "must be a whole number from 0 to 255"),  # type: ignore[operator]
        "port": (whole and 1 <= value <= 8, "must be a whole number from 1 to 8"),  # type: ignore[operator]
        "dpr": (whole and 0 <= value <= 4095, "must be a whole number from 0 to 4095"),  # type: ignore[operator]
        "bit": (whole and 0 <= value <= 1, "must be 0 or 1"),  # type: ignore[operator]
        "terminal": (value in TERMINALS, "must be 1, 2, 4, 8, 16, 32, 64 or 128"),
        "width": (value in WIDTHS, f"must be one of {', '.join(WIDTHS)}"),
        "node event": (value in NODE_EVENTS, f"must be one of {', '.join(NODE_EVENTS)}"),
        "bus event": (value in BUS_EVENTS, f"must be one of {', '.join(BUS_EVENTS)}"),
        "view": (value in VIEWS, f"must be one of {', '.join(VIEWS)}"),
        "motor": (value in MOTORS, f"must be {' or '.join(MOTORS)}"),
        "fault": (value in FAULT_KINDS, f"must be one of {', '.join(FAULT_KINDS)}"),
    }
    fits, words = tests[kind]
    return None if fits else words


def _is_pair(value: object) -> bool:
    if not isinstance(value, list) or len(value) != 2:
        return False
    return all(_kind_problem("number", each) is None for each in value) and value[0] <= value[1]


def _are_registers(value: object) -> bool:
    """Words, signed or not, by the numbers of their registers."""
    return isinstance(value, dict) and all(
        str(name).isdecimal()
        and int(name) <= LAST_REGISTER
        and isinstance(word, int)
        and -(LAST_REGISTER // 2) - 1 <= word <= LAST_REGISTER
        for name, word in value.items()
    )


def _generic(key: str) -> str:
    """`axis.3.travel` as the table has it."""
    parts = key.split(".")
    if parts[0] == "axis" and len(parts) > 2 and parts[1].isdigit():
        parts[1] = "N"
    if parts[:2] == ["mint", "readings"] and len(parts) > 2:
        parts[2:] = ["WORD"]
    return ".".join(parts)


def _flatten(tree: Mapping[str, object], prefix: str = "") -> Iterator[tuple[str, object]]:
    for key, value in tree.items():
        if isinstance(value, dict):
            yield from _flatten(value, f"{prefix}{key}.")
        else:
            yield prefix + key, value


def _located(source: Source, key: str, message: str, hint: str, name: str, entry: int = 0) -> Diagnostic:
    """The diagnostic on the line that has the mistake, as far as the file's own spelling shows it.

    Of a table it is looked for in one entry, whose `[[key]]` stands in where the line is not found.
    """
    here, seen = "", -1
    place = 0, 0, 1
    for number, line in enumerate(source.text.split("\n"), 1):
        text = line.strip()
        column = len(line) - len(line.lstrip()) + 1
        if text.startswith("["):
            header = text.partition("#")[0].replace(" ", "")
            here = header.strip("[]")
            seen += header == f"[[{key}]]"
            if (header == f"[[{key}]]" and seen == entry) or (header == name and seen < 0):
                place = number, column, len(text.partition("#")[0].strip())
            continue
        word = text.split("=")[0].strip(' "')
        full = f"{here}.{word}" if here else word
        within = "{" in text and key.startswith(f"{full}.")  # a table in one line
        if word and (full == key or within or (here == key and word == name and seen == entry)):
            return Diagnostic("machine-file", message, number, column, length=len(word), hint=hint)
    return Diagnostic("machine-file", message, *place[:2], length=place[2], hint=hint)


def _toml_mistake(error: Exception) -> Diagnostic:
    import re

    text = str(error)
    place = re.search(r"\(at line (\d+), column (\d+)\)", text)
    line, column = (int(place[1]), int(place[2])) if place else (0, 0)
    return Diagnostic("machine-file", text.split(" (at ")[0], line, column, hint="the machine file is TOML")
