"""Machine-file entries as texts: `--input 2=1@0.5`, `--answer "Turns=200"`.

A text becomes an entry of `[[input]]`, `[[analogue]]`, `[[answer]]` or `[[key]]`, so an option can do exactly
what the machine file can. The entries override the machine file as a scenario does (`layers.py`).

    CHANNEL[=VALUE][@WHEN]   an input; CHANNEL is a number or a name of the machine file
    CHANNEL=outN[+DELAY]     a digital input that follows output N
    WHEN                     S, S..E, every P, S every P or S..E every P, in seconds
    [PROMPT=]TEXT            an answer to INPUT
    TEXT[@S]                 keys
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence

from motionlang.kernel.lang.dialect import Dialect
from motionlang.kernel.lang.keyword import BANK
from motionlang.kernel.lang.machine.file import first_mistake
from motionlang.kernel.lang.machine.keys import SHORTEST_PERIOD
from motionlang.kernel.lang.machine.layers import layered
from motionlang.kernel.lang.program import Program
from motionlang.kernel.tools import clipped, nearest

Entry = dict[str, object]
Value = float | int | bool | str
# As a caller gives them: texts, or values by channel, name or prompt.
Given = Iterable[Value] | Mapping[str | int, Value | Iterable[Value]] | Value

INPUT_FORM = "write 2=1@0.5, 2=1@0.5..0.9, 2=1@every 1.2 or 2=out4+0.3"
ANALOG_FORM = "write 0=25@1 or 0=25@1..3"
KEYS_FORM = "write R@0.5"
_TIME = r"(?:\d+\.\d+|\d+|\.\d+)(?:[eE][+-]?\d+)?"
_WHEN = re.compile(rf"\s*(?:({_TIME})(?:\s*\.\.\s*({_TIME}))?)?\s*(?:\bevery\s+({_TIME}))?\s*", re.IGNORECASE)
_OUTPUT = re.compile(rf"\s*out\s*(\d{{1,3}})\s*(?:\+\s*({_TIME}))?\s*", re.IGNORECASE)
_LEVELS = {"1": 1, "on": 1, "true": 1, "0": 0, "off": 0, "false": 0}


class WrongEntry(ValueError):
    """A text that is not an entry: the error, and a `hint` with the correct form."""

    def __init__(self, message: str, hint: str) -> None:
        super().__init__(f"{message}; {hint}")
        self.message, self.hint = message, hint


def with_entries(
    settings: Mapping[str, object],
    inputs: Given = (),
    analog: Given = (),
    answers: Given = (),
    keys: Given = (),
) -> dict[str, object]:
    """Return machine-file settings with further entries on top; raise WrongEntry.

    An input entry replaces all entries of its channel in the machine file. An answer to any INPUT replaces
    all answers; an answer with a prompt replaces those with the same prompt.
    """
    stop = {key: value for key, value in settings.items() if key.startswith("run.stop.")}
    return stop | layered(settings, entries(settings, inputs, analog, answers, keys))


def check_inputs_are_read(
    program: Program, language: Dialect, settings: Mapping[str, object], given: Mapping[str, object]
) -> None:
    """Raise WrongEntry for an input in `given` that the program never reads.

    A program that computes the number of an input or of a bank may read any, and the machine file may connect an input
    to a switch.
    """
    tokens = [(kind, text) for kind, text, _ in language.tokens(program.source.text)]
    uses = [use for _, use in program.structure.inputs()]
    banks = [use.number for use in uses if use.channel == "input bank"]
    is_computed = not all(use.number.isdecimal() for use in uses)
    if banks:
        statements = program.structure.statements.values()
        functions = {use.row.function for each in statements for use in each.uses if use.row is not None}
        is_computed |= "default_bank" in functions
    if is_computed or any("@" in text for _, text in tokens):
        return
    numbers = Counter(number for _, text in tokens for number in text.split("."))
    numbers -= Counter(banks)
    read = {int(use.number) for use in uses if use.channel == "input"}
    read |= {int(bank) * BANK + k for bank in set(banks) for k in range(BANK)}
    switches = {value for key, value in settings.items() if key.endswith("_input")}
    for entry in given.get("input", ()):  # type: ignore[attr-defined]
        channel = entry["channel"]
        if channel not in read | switches and str(channel) not in numbers:
            listed = _spans(sorted(read))
            hint = f"it reads {listed}" if listed else "it reads no input"
            raise WrongEntry(f"--input {channel}: the program never reads input {channel}", hint)


def _spans(channels: Sequence[int]) -> str:
    """Return channels in increasing order as text, those of a bank as a span."""
    spans: list[list[int]] = []
    for each in channels:
        if spans and each == spans[-1][-1] + 1:
            spans[-1].append(each)
        else:
            spans.append([each])
    return ", ".join(
        f"{each[0]} to {each[-1]}" if len(each) > 2 else ", ".join(map(str, each)) for each in spans
    )


def entries(
    settings: Mapping[str, object],
    inputs: Given = (),
    analog: Given = (),
    answers: Given = (),
    keys: Given = (),
) -> dict[str, object]:
    """Parse the texts and return the entries by table.

    The settings of the machine file provide the names of channels. Raises WrongEntry for an invalid text.
    """
    above: dict[str, object] = {
        "input": [e for text in _texts(inputs) for e in _input(text, _names(settings, "input"))],
        "analogue": [_analog(text, _names(settings, "analogue")) for text in _texts(analog)],
        "answer": [_answer(text) for text in _texts(answers)],
        "key": [_key(text) for text in _texts(keys)],
    }
    above = {table: entries for table, entries in above.items() if entries}
    mistake = first_mistake(above)
    if mistake:
        message, _, hint = mistake.removesuffix(")").partition(" (")
        raise WrongEntry(message, hint)
    return above


def _texts(given: Given) -> list[str]:
    """Return the texts from a list or a mapping.

    The keys of a mapping are channels, names or prompts.
    """
    if isinstance(given, (str, int, float)):
        return [_text(given)]
    if not hasattr(given, "items"):
        return [_text(each) for each in given]
    found = []
    for name, values in given.items():
        for value in [values] if isinstance(values, (str, int, float)) else values:
            found.append(f"{name}={_text(value)}")
    return found


def _text(value: Value) -> str:
    return str(int(value)) if isinstance(value, bool) else str(value)


def _names(settings: Mapping[str, object], table: str) -> dict[str, int]:
    """Return the channels with a name in the machine file, by name in lower case."""
    entries: Iterable[Mapping[str, object]] = settings.get(table, ())  # type: ignore[assignment]
    return {str(each["name"]).lower(): each["channel"] for each in entries if "name" in each}  # type: ignore[misc]


def _quoted(text: str) -> str:
    """Return a text in quotes, shortened to fit a message."""
    return f'"{clipped(text.strip())}"'


def _channel(text: str, names: Mapping[str, int], what: str, form: str) -> int:
    """Return the number of a channel given as a number or a name."""
    name = text.strip()
    if name.isascii() and name.isdigit() and len(name) <= 3:
        return int(name)
    if name.lower() in names:
        return names[name.lower()]
    if not name or not (name[0].isalpha() or name[0] == "_"):
        raise WrongEntry(f"{_quoted(text)} is not {what}", form)
    near = nearest(name.lower(), names)
    hint = f"did you mean {near}?" if near else "write its number, or add name = to its entry"
    raise WrongEntry(f"the machine file names no {what.partition(' ')[2]} {clipped(name)}", hint)


def _input(text: str, names: Mapping[str, int]) -> list[Entry]:
    """Return the entries of one `--input`; a pulse to 0 takes three."""
    head, at, when = text.partition("@")
    name, equals, value = head.partition("=")
    channel = _channel(name, names, "an input", INPUT_FORM)
    output = _OUTPUT.fullmatch(value) if not at else None
    if output is not None:
        delay = float(output[2]) if output[2] else 0.0
        return [{"channel": channel, "output": int(output[1]), "delay": delay}]
    level = _LEVELS.get(value.strip().lower()) if equals else 1
    if level is None:
        raise WrongEntry(f"{_quoted(value)} is not a level of input {channel}: 0 or 1", INPUT_FORM)
    begin, end, every = _times(when, INPUT_FORM) if at else (None, None, None)
    entry: Entry = {"channel": channel, "value": level}
    if every is not None:
        if not level:
            raise WrongEntry(f"{_quoted(text)}: only a pulse of 1 repeats", INPUT_FORM)
        begin = every if begin is None else begin
        return [
            {**entry, "at": begin, "for": every / 2 if end is None else _length(begin, end), "every": every}
        ]
    if begin is None or end is None:
        return [entry if begin is None else {**entry, "at": begin}]
    if level:
        return [{**entry, "at": begin, "for": _length(begin, end)}]
    _length(begin, end)
    return [
        {"channel": channel, "value": 1, "at": 0.0},
        {"channel": channel, "value": 0, "at": begin},
        {"channel": channel, "value": 1, "at": end},
    ]


def _analog(text: str, names: Mapping[str, int]) -> Entry:
    head, at, when = text.partition("@")
    name, _, value = head.partition("=")
    channel = _channel(name, names, "an analogue input", ANALOG_FORM)
    if not re.fullmatch(f"[+-]?{_TIME}", value.strip()):
        raise WrongEntry(f"{_quoted(value)} is not a value of analogue input {channel}", ANALOG_FORM)
    entry: Entry = {"channel": channel, "value": float(value)}
    begin, end, every = _times(when, ANALOG_FORM) if at else (None, None, None)
    if every is not None:
        raise WrongEntry(f"{_quoted(text)}: an analogue input does not repeat", ANALOG_FORM)
    if begin is not None:
        entry["at"] = begin
    if begin is not None and end is not None:
        entry["for"] = _length(begin, end)
    return entry


def _answer(text: str) -> Entry:
    prompt, equals, answer = text.partition("=")
    if not equals:
        return {"text": text}
    prompt = prompt.strip()
    return {"text": answer, "prompt": prompt} if prompt else {"text": answer}


def _key(text: str) -> Entry:
    keys, at, when = text.rpartition("@")
    if not at:
        keys, when = text, "0"
    if not keys:
        raise WrongEntry(f"{_quoted(text)} has no keys", KEYS_FORM)
    begin, end, every = _times(when, KEYS_FORM)
    if begin is None or end is not None or every is not None:
        raise WrongEntry(f"{_quoted(when)} is not a time", KEYS_FORM)
    return {"text": keys, "at": begin}


def _times(text: str, form: str) -> tuple[float | None, float | None, float | None]:
    """Return the start, the end and the period of `0.5..0.9 every 2`.

    Each is None if it is omitted.
    """
    found = _WHEN.fullmatch(text)
    if found is None or not text.strip():
        raise WrongEntry(f"{_quoted(text)} is not a time", form)
    begin, end, every = (None if each is None else float(each) for each in found.groups())
    if every is not None and every < SHORTEST_PERIOD:
        raise WrongEntry(f"a period is at least {SHORTEST_PERIOD:.10g} s, not {every:.10g} s", form)
    return begin, end, every


def _length(begin: float, end: float) -> float:
    """Return the duration of a pulse, s; WrongEntry if it ends before it begins."""
    if not end > begin:
        raise WrongEntry(
            f"the pulse ends at {end:.10g} s, not after it begins at {begin:.10g} s", "write 0.5..0.9"
        )
    return round(end - begin, 12)
