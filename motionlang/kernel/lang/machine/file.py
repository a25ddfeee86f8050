"""Reading of machine files, checked against the vocabulary.

An unknown key, or a value of the wrong kind, is a diagnostic with its line.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping

from motionlang.kernel.errors import Diagnostic, ProgramError
from motionlang.kernel.lang.dialect import Dialect, dialect, unknown_model
from motionlang.kernel.lang.machine.keys import (
    CHOICES,
    EXPECTED,
    KEYS,
    LAST_LINE,
    LAST_REGISTER,
    MAX_AXES,
    MEANT,
    NAMED,
    OF_A_NODE,
    OF_DIALECTS,
    REQUIRED,
    SERVO,
    SHORTEST_PERIOD,
    STOPS,
    TABLES,
)
from motionlang.kernel.lang.machine.switch import ASSUMPTIONS
from motionlang.kernel.lang.machine.switch import problem as reading_problem
from motionlang.kernel.log.records import EVENTS
from motionlang.kernel.servo import settings as servo
from motionlang.kernel.servo.settings import KEYS as SERVO_KEYS
from motionlang.kernel.servo.settings import mistakes as servo_mistakes
from motionlang.kernel.source import Source
from motionlang.kernel.tools import StackSpace, as_hint, nearest, shown

# So many keys of a section are listed in a hint.
MAX_KEYS = 6
# Every key of the vocabulary has fewer parts than this.
_MAX_DEPTH = 5
# A key with more parts is rejected before Python's reader sees it. The reader stores every prefix of a key,
# which takes 1.6 GB for one of 20 000 parts.
_MAX_COMPONENTS = 1000
# No valid machine file has more brackets open at once.
_MAX_OPEN = 100
_QUOTED = r'''"""[\s\S]*?"""|\'\'\'[\s\S]*?\'\'\'|"(?:\\.|[^"\\\n])*"|'[^'\n]*'|#[^\n]*'''
_COMPONENT = r"""(?:[\w-]+|"[^"\n]*"|'[^'\n]*')"""
_LONG_KEY = rf"(?<![\w-]){_COMPONENT}(?:[ \t]*\.[ \t]*{_COMPONENT}){{{_MAX_COMPONENTS}}}"
# The range of each kind of whole numbers.
_WHOLE = {"channel": (0, 999), "times": (1, 10_000), "node": (0, 255)}
# The values of each kind of choice; a TOML file has a flag as a truth value.
_CHOICES = {"event": EVENTS, **{kind: each for kind, each in CHOICES.items() if kind != "flag"}}
_WORDS = {"motor": "must be servo or stepper", "terminal": "must be 1, 2, 4, 8, 16, 32, 64 or 128"}


def read_machine(
    source: Source, *, is_layer: bool = False, language: Dialect | None = None
) -> dict[str, object]:
    """Return the settings of a machine file by dotted key, with tables as lists.

    The controller model must be one of `language`, or of any without it. A file that `is_layer`, such as a scenario,
    may name an input instead of its channel; `layered` looks the channel up in the file below. Raises ProgramError with
    every mistake.
    """
    tree = read_toml(source)
    settings: dict[str, object] = {}
    mistakes: list[Diagnostic] = []
    for key, value in flat(tree):
        problems = list(_problems(key, _with_some_channel(key, value) if is_layer else value, language))
        mistakes.extend(_located(source, key, *problem) for problem in problems)
        if not problems:
            settings[key] = value
    if any(".plant." in key or ".servo." in key for key in settings):
        for section, message, hint in servo_mistakes(settings):
            mistakes.append(_located(source, f"{section}.", message, hint, f"[{section}]"))
    if (wrong := stop_mistake(settings)) is not None:
        mistakes.append(_located(source, "run.stop", *wrong, "stop"))
    if mistakes:
        raise ProgramError(mistakes)
    return settings


def stop_mistake(settings: Mapping[str, object]) -> tuple[str, str] | None:
    """Return message and hint of a wrong `run.stop`, which is one event, text or line."""
    named = [key.removeprefix("run.stop.") for key in STOPS if key in settings]
    if len(named) > 1:
        return f"run.stop ends the run by one thing, not by {' and '.join(named)}", "leave one of them"
    if not named and "run.stop.times" in settings:
        return (
            "run.stop has times without what happens so often",
            'event = "input", prints = "TEXT" or line = N',
        )
    return None


def _with_some_channel(key: str, value: object) -> object:
    """Return a layer's entries with a placeholder channel where they have only a name."""
    if key not in NAMED or not isinstance(value, list) or not all(isinstance(each, dict) for each in value):
        return value
    return [{"channel": 0, **each} if "name" in each else each for each in value]


def read_toml(source: Source) -> dict[str, object]:
    """Return the parsed TOML of a machine file, unchecked.

    Raises ProgramError if the text is not TOML.
    """
    import tomllib

    if source.text.count(".") >= _MAX_COMPONENTS:
        _refuse_long_keys(source)
    if source.text.count("[") + source.text.count("{") > _MAX_OPEN:
        _refuse_nesting(source)
    try:
        with StackSpace():
            return tomllib.loads(source.text)
    except tomllib.TOMLDecodeError as error:
        raise ProgramError([_toml_mistake(source, error)]) from None
    except ValueError:
        raise ProgramError([_too_many_digits(source)]) from None


def read_value(text: str) -> object:
    """Return one value written as in a machine file; raise ProgramError if invalid."""
    return read_toml(Source("value", f"value = {text}"))["value"]


def _keys_below(key: str) -> str:
    """Return a hint for an unknown key: some keys of its section, or the sections."""
    section, below = generic(key), list[str]()
    while section and not below:
        section = section.rpartition(".")[0]
        below = [each for each in KEYS if each.startswith(f"{section}.")]
    begins = ", ".join(below[:MAX_KEYS] or dict.fromkeys(each.partition(".")[0] for each in KEYS))
    more = " …" if len(below) > MAX_KEYS else ""
    known = (
        f"a key of {section.removesuffix('.N')} is {begins}{more}" if below else f"a key begins with {begins}"
    )
    return f"{known}; docs/machine-file.md lists all"


def _nearest_key(key: str, keys: Iterable[str]) -> str | None:
    """Return the most similar key: by its last part within its section, or else by its section."""
    section, _, last = key.rpartition(".")
    sections: dict[str, dict[str, str]] = {}
    for each in keys:
        above, _, name = each.rpartition(".")
        sections.setdefault(above, {})[name] = each
    if section not in sections:
        section = nearest(section, sections) or ""
    near = nearest(last, sections[section])
    if near is None and MEANT.get(last) in sections[section]:
        near = MEANT[last]
    return sections[section][near] if near else None


def check_setting(key: str, value: object, language: Dialect | None = None) -> tuple[str, str] | None:
    """Return the problem of one plain setting and a hint, or None if it is valid.

    `language` is that of the program, if it is known.
    """
    row = KEYS.get(generic(key))
    if row is None and generic(key).startswith(SERVO):
        return servo.setting_problem(key, generic(key), value)
    if row is None:
        near = _nearest_key(generic(key), (*KEYS, *TABLES, *SERVO_KEYS))
        words = f"did you mean {near}?" if near else _keys_below(key)
        return f"there is no key {key}", words
    if key.startswith(ASSUMPTIONS):
        return reading_problem(key, value)
    problem = _kind_problem(row[0], value)
    if problem is None and key == "controller.axes" and not 1 <= value <= MAX_AXES:  # type: ignore[operator]
        problem = f"must be 1 to {MAX_AXES}"
    if problem is None and key == "controller.instruction_time" and not 1e-9 <= value <= 1.0:  # type: ignore[operator]
        problem = "must be 1e-9 to 1 second"
    if problem is None and key == "controller.model" and value:
        return unknown_model(str(value), language)
    if problem is None and key.startswith(OF_DIALECTS):
        return dialect(key.partition(".")[0]).setting_problem(key, value)
    return None if problem is None else (f"{key} {problem}, not {shown(value)}", as_hint(row[1]))


def first_mistake(settings: Mapping[str, object]) -> str:
    """Return the first problem, with a hint, of settings from a Python program.

    Returns an empty text if all are valid.
    """
    for key, value in settings.items():
        for message, hint, *_ in _problems(key, value):
            return f"{message} ({hint})"
    wrong = stop_mistake(settings)
    return "" if wrong is None else f"{wrong[0]} ({wrong[1]})"


def _problems(
    key: str, value: object, language: Dialect | None = None
) -> Iterator[tuple[str, str, str, int]]:
    """Yield the mistakes in one key or table.

    Each has a message, a hint, the name to search for in the file and the index of its entry.
    """
    if key not in TABLES:
        problem = check_setting(key, value, language)
        if problem is not None:
            yield (*problem, key, 0)
        return
    if not isinstance(value, list) or not all(isinstance(entry, dict) for entry in value):
        yield f"{key} is a table of entries", f"write [[{key}]] above each entry", key, 0
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
            yield f"{name} of [[{table}]] {problem}, not {shown(value)}", as_hint(rows[name][1]), name
    for name in REQUIRED[table]:
        if name not in entry:
            yield f"[[{table}]] needs {name}", as_hint(rows[name][1]), f"[[{table}]]"
    yield from _when_problems(table, entry)
    if table == "fault" and "axis" not in entry and entry.get("kind") != "controller":
        yield "[[fault]] needs axis", as_hint(rows["axis"][1]), "[[fault]]"
    if "every" in rows and "asked" not in entry:
        yield from _again_problems(table, entry)
    if table == "remote":
        yield from _remote_problems(entry)
    first, last = entry.get("first"), entry.get("last", LAST_REGISTER)
    if isinstance(first, int) and isinstance(last, int) and last < first <= LAST_REGISTER:
        yield f"[[{table}]] has its last register before the first", "last must not be below first", "last"
    if "per_unit" in entry and "axis" not in entry:
        yield f"[[{table}]] needs an axis", "add axis = N", "per_unit"
    if table == "encoder" and ("channel" in entry) is ("aux" in entry):
        yield "[[encoder]] needs a channel or an aux", "channel = 2 is an encoder", "[[encoder]]"
    if table == "expect":
        yield from _expect_problems(entry)
    if table in ("comms", "netdata"):
        yield from _written_problems(table, entry)


def _when_problems(table: str, entry: Mapping[str, object]) -> Iterator[tuple[str, str, str]]:
    """Check that an entry has one trigger: a time, a position, a line or an output."""
    rows = TABLES[table]
    where = [
        name for name in ("above", "below", "between", "line", "output") if name in entry and name in rows
    ]
    if "asked" in entry and "asked" in rows:
        yield from _asked_problems(table, entry)
        return
    if len(where) > 1 or (where and "at" in entry):
        regions = ", ".join(name for name in ("above", "below", "between") if name in rows)
        others = [name for name in ("line", "output") if name in rows]
        triggers = f"{', '.join(['at', *others])}, or one of {regions}" if regions else "at or output"
        what = "is active" if table in NAMED else "occurs"
        yield f"[[{table}]] {what} by one trigger only", f"give {triggers}", where[0]
    if where and where[0] not in ("line", "output") and table != "fault" and "axis" not in entry:
        yield f"[[{table}]] needs an axis", "add axis = N", where[0]
    if "axis" in entry and table in ("input", "analogue") and where in ([], ["output"]):
        hint = "add above, below or between, or remove axis"
        yield f"axis of [[{table}]] has no effect without a position", hint, "axis"
    is_region = bool(where) and where[0] in ("above", "below", "between")
    if table == "input" and is_region and entry.get("value") == 0:
        hint = f"let {where[0]} name the positions at which it is on, and remove value"
        yield "[[input]] with value = 0 is on at no position", hint, "value"
    is_repeated = "every" in entry and "between" not in entry  # reported by itself
    if "for" in entry and is_region and not is_repeated:
        hint = f"it is active where {where[0]} says: remove for"
        yield f"for of [[{table}]] has no effect with a position", hint, "for"
    for name in ("delay", "level"):
        if name in entry and name in rows and "output" in rows and "output" not in entry:
            hint = "output = 1 is the output after whose change it happens"
            yield f"{name} of [[{table}]] has no effect without an output", hint, name
    if table == "analogue" and "times" in entry:
        hint = "add asked, the time after which it changes once the program asks for it"
        yield "times of [[analogue]] has no effect without asked", hint, "times"
    if table == "input" and "level" in entry and "output" in entry and "for" not in entry:
        hint = "add for, or write value = 0 for an input that is off while the output is on"
        yield "level of [[input]] has no effect without for", hint, "level"


def _asked_problems(table: str, entry: Mapping[str, object]) -> Iterator[tuple[str, str, str]]:
    """Check that an entry that acts when asked has no other trigger."""
    others = ["axis", "above", "below", "between", "per_unit", "output", "delay", "every"]
    if table == "input":
        others.append("value")
    else:
        others.append("level")
    for name in (each for each in others if each in entry and each in TABLES[table]):
        hint = f"remove asked or {name}"
        if name == "value":
            hint = "it changes to its other level; level = 1 lets it change to that one only"
        yield f"{name} of [[{table}]] has no effect with asked", hint, name
    asked = entry["asked"]
    if "times" not in entry and not _kind_problem("positive", asked) and asked < SHORTEST_PERIOD:  # type: ignore[operator]
        yield _too_often(table, "asked", asked)


def _too_often(table: str, name: str, value: object) -> tuple[str, str, str]:
    return (
        f"{name} of [[{table}]] must be at least {SHORTEST_PERIOD:.10g} s without times, not {shown(value)}",
        "times = 1000 says how often it happens",
        name,
    )


def _again_problems(table: str, entry: Mapping[str, object]) -> Iterator[tuple[str, str, str]]:
    """Check that a repeated entry ends before it begins again."""
    every, between, length = entry.get("every"), entry.get("between"), entry.get("for")
    again = [name for name in ("every", "times") if name in entry]
    if again and "output" in entry:
        hint = f"remove {' and '.join(again)}: it happens after each change of the output"
        yield f"{again[0]} of [[{table}]] has no effect with an output", hint, again[0]
        return
    if every is None:
        if again:
            yield f"[[{table}]] has times without every", "every = 0.5 is the period", "times"
        return
    if between is not None and "times" not in entry:
        yield f"[[{table}]] with between needs times", "times = 50 is how many there are", "every"
        return
    if table == "input" and between is None and (length is None or "above" in entry or "below" in entry):
        words = "give for (a duration) or between (two positions of an axis)"
        yield f"[[{table}]] needs a duration to repeat", words, "every"
        return
    if _kind_problem("number", every):
        return
    spans = isinstance(between, list) and _is_pair(between)
    last = between[1] - between[0] if spans else length  # type: ignore[index]
    if "times" not in entry and every < SHORTEST_PERIOD:  # type: ignore[operator]
        yield _too_often(table, "every", every)
    elif not _kind_problem("number", last) and every <= last:  # type: ignore[operator]
        yield f"[[{table}]] repeats before it ends", f"every must be more than {last:.10g}", "every"


def _remote_problems(entry: Mapping[str, object]) -> Iterator[tuple[str, str, str]]:
    what = [name for name in OF_A_NODE if name in entry]
    if len(what) != 1:
        yield (
            "[[remote]] needs a channel, an analogue or an event",
            "give one of them; channel = 0 is a digital input",
            "[[remote]]",
        )
    elif "for" in entry and what[0] not in ("channel", "analogue"):
        yield f"[[remote]] with {what[0]} takes no for", TABLES["remote"]["for"][1], "for"
    elif what[0] == "event" and "value" in entry:
        yield "[[remote]] with event takes no value", TABLES["remote"]["event"][1], "value"


def _expect_problems(entry: Mapping[str, object]) -> Iterator[tuple[str, str, str]]:
    """Check that an entry expects one thing and has only keys that apply to it."""
    what = [name for name in EXPECTED if name in entry]
    if len(what) != 1:
        yield f"[[expect]] expects one thing: {', '.join(EXPECTED)}", "write an entry for each", "[[expect]]"
        return
    for name in entry:
        if name in TABLES["expect"] and name != what[0] and name not in EXPECTED[what[0]]:
            yield f"{name} of [[expect]] has no effect on {what[0]}", TABLES["expect"][name][1], name
    if what[0] == "position" and "axis" not in entry:
        yield "[[expect]] needs the axis of the position", "add axis = N", "position"
    if what[0] == "quantity" and not {"value", "at_least", "at_most"} & entry.keys():
        yield "[[expect]] needs the value of the quantity", "add value, at_least or at_most", "quantity"


def _written_problems(table: str, entry: Mapping[str, object]) -> Iterator[tuple[str, str, str]]:
    low, high = (1, 99) if table == "comms" else (0, 999)
    element = entry.get("element")
    if isinstance(element, int) and not low <= element <= high:
        yield (
            f"element of [[{table}]] must be {low} to {high}, not {shown(element)}",
            TABLES[table]["element"][1],
            "element",
        )
    if ("value" in entry) is ("text" in entry):
        yield f"[[{table}]] needs a value or a text", 'value = 2.5, or text = "ABCD"', f"[[{table}]]"


def _kind_problem(kind: str, value: object) -> str | None:
    number = isinstance(value, (int, float)) and not isinstance(value, bool)
    finite = number and abs(value) < 1e300  # type: ignore[arg-type]
    whole = number and isinstance(value, int)
    if kind in _WHOLE:
        low, high = _WHOLE[kind]
        fits = whole and low <= value <= high  # type: ignore[operator]
        return None if fits else f"must be a whole number from {low} to {high}"
    if kind in _CHOICES:
        words = _WORDS.get(kind) or f"must be one of {', '.join(map(str, _CHOICES[kind]))}"
        return None if value in _CHOICES[kind] else words
    tests = {
        "text": (isinstance(value, str), "must be a text"),
        "names": (
            isinstance(value, list) and all(isinstance(each, str) for each in value),
            'must be a list of texts, such as ["SPEED[0]@9"]',
        ),
        "flag": (isinstance(value, bool), "must be true or false"),
        "count": (whole, "must be a whole number"),
        "number": (finite, "must be a number"),
        "percentage": (finite and abs(value) <= 100, "must be a percentage, -100 to 100"),  # type: ignore[arg-type]
        "time": (finite and value >= 0, "must be a time, 0 or more"),  # type: ignore[operator]
        "positive": (finite and value > 0, "must be a number above 0"),  # type: ignore[operator]
        "pair": (_is_pair(value), "must be two numbers, the lower first"),
        "reading": (finite or isinstance(value, (bool, str)), "must be a number, a text, true or false"),
        "line": (whole and 0 < value <= LAST_LINE, "must be the number of a line"),  # type: ignore[operator]
        "register": (whole and 0 <= value <= LAST_REGISTER, f"must be 0 to {LAST_REGISTER}, whole"),  # type: ignore[operator]
        "registers": (_are_registers(value), 'must be registers with 16-bit values, such as { "6" = 1234 }'),
        "bus": (whole and 1 <= value <= 2, "must be 1 or 2"),  # type: ignore[operator]
        "level": (finite and value in (0, 1), "must be 0 or 1"),
        "bit": (whole and 0 <= value <= 1, "must be 0 or 1"),  # type: ignore[operator]
    }
    fits, words = tests[kind]
    return None if fits else words


def _is_pair(value: object) -> bool:
    if not isinstance(value, list) or len(value) != 2:
        return False
    return all(_kind_problem("number", each) is None for each in value) and value[0] <= value[1]


def _are_registers(value: object) -> bool:
    """True if the value maps register numbers to words, signed or unsigned."""
    return isinstance(value, dict) and all(
        _is_number(str(name))
        and int(name) <= LAST_REGISTER
        and isinstance(word, int)
        and -(LAST_REGISTER // 2) - 1 <= word <= LAST_REGISTER
        for name, word in value.items()
    )


def _is_number(text: str) -> bool:
    """True if a key segment is a number of at most 6 digits without leading zeros."""
    return text.isascii() and text.isdigit() and len(text) <= 6 and (text == "0" or text[0] != "0")


def generic(key: str) -> str:
    """Return the key in the spelling of the table.

    For example, `axis.3.travel` is `axis.N.travel`.
    """
    components = key.split(".")
    if components[0] == "axis" and len(components) > 2 and _is_number(components[1]):
        components[1] = "N"
    if components[:2] == ["mint", "values"] and len(components) > 2:
        components[2:] = ["KEYWORD"]
    if components[:2] == ["mint", "words"] and len(components) == 3:
        components[2:] = ["WORD"]
    if components[:2] == ["mccl", "codes"] and len(components) > 2:
        components[2:] = ["COMMAND"]
    if components[0] == "assumptions" and len(components) > 1:
        components[1:] = ["NAME"]
    return ".".join(components)


def flat(tree: Mapping[str, object], prefix: str = "") -> Iterator[tuple[str, object]]:
    """Yield the values by dotted key; tables nested too deep are not split."""
    for key, value in tree.items():
        if isinstance(value, Mapping) and prefix.count(".") < _MAX_DEPTH:
            yield from flat(value, f"{prefix}{key}.")
        else:
            yield f"{prefix}{key}", value


def _located(source: Source, key: str, message: str, hint: str, name: str, entry: int = 0) -> Diagnostic:
    """Return the diagnostic with the line of the mistake, searched for in the text.

    A mistake in a table is searched for in one entry. If its line is not found, the diagnostic has the line
    of that entry's `[[key]]`. A mistake in a section, or in a value nested too deep, has the first line of
    the section.
    """
    here, seen = "", -1
    location = 0, 0, 1
    inside = f"{key.removesuffix('.')}."
    for number, line in enumerate(source.text.split("\n"), 1):
        text = line.strip()
        column = len(line) - len(line.lstrip()) + 1
        if text.startswith("["):
            header = text.partition("#")[0].replace(" ", "")
            here = header.strip("[]").replace('"', "").replace("'", "")
            seen += header == f"[[{key}]]"
            if (header == f"[[{key}]]" and seen == entry) or (header == name and seen < 0):
                location = number, column, len(text.partition("#")[0].strip())
            continue
        if "=" not in text or text.startswith("#"):
            continue
        word = text.split("=")[0].strip(" \"'")
        full = f"{here}.{word}" if here else word
        within = "{" in text and key.startswith(f"{full}.")  # a table in one line
        if full == key or within or (here == key and word == name and seen == entry):
            return Diagnostic("machine-file", message, number, column, length=len(word), hint=hint)
        if full.startswith(inside) and not location[0]:
            location = number, column, len(word)
    return Diagnostic("machine-file", message, *location[:2], length=location[2], hint=hint)


def _refuse_long_keys(source: Source) -> None:
    found = re.search(_LONG_KEY, source.text)
    if found is not None:
        location, hint = source.location(found.start()), f"no key has more than {_MAX_DEPTH + 1}"
        raise ProgramError.of("machine-file", "a key has too many parts", *location, hint=hint)


def _toml_mistake(source: Source, error: Exception) -> Diagnostic:
    text = str(error)
    found = re.search(r"\(at line (\d+), column (\d+)\)", text)
    line, column = (int(found[1]), int(found[2])) if found else source.location(len(source.text.rstrip()))
    return Diagnostic(
        "machine-file", as_hint(text.split(" (at ")[0]), line, column, hint="the machine file must be TOML"
    )


def _too_many_digits(source: Source) -> Diagnostic:
    """Return the diagnostic for a number with more digits than Python can parse."""
    digits = re.search("[0-9_]{1000,}", source.text)
    line, column = source.location(digits.start()) if digits else (0, 0)
    return Diagnostic("machine-file", "a number has too many digits", line, column, hint="1e6 is a million")


def _refuse_nesting(source: Source) -> None:
    """Raise ProgramError if too many brackets are open.

    Brackets in strings and comments do not count.
    """
    plain = re.sub(_QUOTED, lambda found: " " * len(found[0]), source.text)
    most, deepest = _deepest(plain)
    if most > _MAX_OPEN:
        hint = "the values of a machine file are at most lists of numbers"
        raise ProgramError.of(
            "machine-file", "values are nested too deeply", *source.location(deepest), hint=hint
        )


def _deepest(text: str) -> tuple[int, int]:
    """Return the largest number of open brackets and the offset at which it occurs."""
    open_now, most, deepest = 0, 0, 0
    for offset, letter in enumerate(text):
        open_now += (letter in "[{") - (letter in "]}")
        if open_now > most:
            most, deepest = open_now, offset
    return most, deepest
