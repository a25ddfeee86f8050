"""A machine file that exists, with what a recording measured: guesses are replaced, and nothing else.

An entry of `input` or `analogue` with `guess = true` is a line of the draft, and so are the switches of an axis with
`guess = true`. These lines are replaced. An entry of a person stays; a sentence says where the recording differs.
Channels without an entry are added.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import NamedTuple

from motionlang.commands.explore import Entry, entries
from motionlang.commands.init.file import inline, toml_value
from motionlang.commands.init.recorded.axes import axis_remarks, switches
from motionlang.commands.init.recorded.drafting import (
    check_program,
    entries_of,
    of_clock,
    outcome,
    power_up_of,
    program_run,
    rules_in_words,
)
from motionlang.commands.init.recorded.recording import MeasuredRecording
from motionlang.kernel import Program

MEASURED = ("input", "analogue")
# A figure of a person agrees with the measured one within this share, or this size.
SAME_SHARE, SAME = 0.05, 0.02
_SECTION = re.compile(r"\s*\[axis\.(\d+)\]")
_TABLE = re.compile(r"\s*(input|analogue)\s*=\s*\[")


class FileUpdate(NamedTuple):
    """The new text of a machine file, and sentences about the recording and the run with it."""

    text: str
    sentences: list[str]


def update(
    program: Program, raw: MeasuredRecording, text: str, settings: Mapping[str, object], until: float
) -> FileUpdate:
    """Return a machine file, given as text and settings, with what a recording measured."""
    base = {key: value for key, value in settings.items() if key not in MEASURED}
    recording, sentences = power_up_of(program, raw, base)
    rules, measured, comments = entries_of(recording)
    world = _with(settings, measured)
    result = program_run(program, world, until)
    check_program(program, result, recording)
    recording, more = of_clock(result, recording)
    if more:
        sentences += more
        rules, measured, comments = entries_of(recording)
        world = _with(settings, measured)
        result = program_run(program, world, until)
    found, texts = switches(result, recording, _guessed_switches(settings))
    if found:
        comments |= texts
        world |= found
        result = program_run(program, world, until)
    sentences += axis_remarks(result, recording)
    sentences += outcome(result, recording)
    sentences += rules_in_words(rules)
    for table in MEASURED:
        for channel in _channels(measured, table):
            mine, theirs = _about(settings, table, channel), _about(measured, table, channel)
            if mine and not _is_guess(mine) and not _agree(mine, theirs):
                shown = " and ".join(map(inline, theirs))
                sentences.append(f"{table} {channel} stays as it is; the recording has {shown}")
    return FileUpdate(_text(text, settings, measured, found, comments), sentences)


def _with(settings: Mapping[str, object], measured: Mapping[str, object]) -> dict[str, object]:
    """Return settings with measured entries in place of guesses, and for channels without an entry."""
    world = dict(settings)
    for table in MEASURED:
        kept = [
            each for each in entries(settings, table) if not _is_replaced(settings, measured, table, each)
        ]
        mine = {each["channel"] for each in kept}
        made = [*kept, *(each for each in entries(measured, table) if each["channel"] not in mine)]
        if made:
            world[table] = made
    return world


def _is_replaced(
    settings: Mapping[str, object], measured: Mapping[str, object], table: str, entry: Entry
) -> bool:
    channel = int(str(entry["channel"]))
    return channel in _channels(measured, table) and _is_guess(_about(settings, table, channel))


def _channels(settings: Mapping[str, object], table: str) -> list[int]:
    return list(dict.fromkeys(int(str(each["channel"])) for each in entries(settings, table)))


def _about(settings: Mapping[str, object], table: str, channel: int) -> list[Entry]:
    return [each for each in entries(settings, table) if each["channel"] == channel]


def _is_guess(about: list[Entry]) -> bool:
    """True if all entries of a channel are guesses."""
    return all("guess" in each for each in about)


def _agree(mine: list[Entry], theirs: list[Entry]) -> bool:
    """True if the entries of a person are the measured ones, but for small differences of figures."""
    if len(mine) != len(theirs):
        return False
    for one, other in zip(mine, theirs, strict=True):
        keys = (one.keys() | other.keys()) - {"name", "guess", "times"}
        for key in keys:
            a, b = one.get(key), other.get(key)
            if isinstance(a, (int, float)) and isinstance(b, (int, float)):
                if abs(a - b) > max(SAME, SAME_SHARE * abs(a)):
                    return False
            elif a != b and not (isinstance(a, list) and isinstance(b, list)):
                return False
    return True


def _guessed_switches(settings: Mapping[str, object]) -> dict[int, dict[str, object]]:
    found: dict[int, dict[str, object]] = {}
    for key, value in settings.items():
        parts = key.split(".")
        is_switch = parts[0] == "axis" and parts[2:] in (["home_switch"], ["index_every"])
        if is_switch and settings.get(f"axis.{parts[1]}.guess"):
            found.setdefault(int(parts[1]), {})[parts[2]] = value
    return found


# ------------------------------------------------------------------------------------------ the text


def _text(
    text: str,
    settings: Mapping[str, object],
    measured: Mapping[str, object],
    found: Mapping[str, object],
    comments: Mapping[str, str],
) -> str:
    """Return the text of a machine file with measured lines in place of guesses; all others stay."""
    lines = text.split("\n")
    for table in MEASURED:
        for channel in _channels(measured, table):
            about = _about(settings, table, channel)
            made = [_line(each, comments, about) for each in _about(measured, table, channel)]
            if about and _is_guess(about):
                lines = _replaced(lines, table, channel, made)
            elif not about:
                lines = _added(lines, table, made)
    axis = ""
    for k, line in enumerate(lines):
        section = _SECTION.match(line)
        axis = section[1] if section is not None else "" if line.startswith("[") else axis
        key = f"axis.{axis}.{line.partition('=')[0].strip()}" if axis else line.partition("=")[0].strip()
        if key in found and not key.endswith(".guess"):
            lines[k] = f"{line.partition('=')[0].rstrip()} = {toml_value(found[key])}    # {comments[key]}"
    return "\n".join(lines)


def _line(entry: Entry, comments: Mapping[str, str], about: list[Entry]) -> str:
    """Return the line of an entry, with the name that a person gave the channel."""
    names = [each["name"] for each in about if "name" in each]
    named = {"channel": entry["channel"], "name": names[0], **entry} if names else entry
    comment = comments.get(inline(entry), "")
    return f"  {inline(named)}," + (f"    # {comment}" if comment else "")


def _replaced(lines: list[str], table: str, channel: int, made: list[str]) -> list[str]:
    """Return lines with others for the entries of a channel, whose comments stay above them."""
    found: list[str] = []
    own = re.compile(rf"\s*\{{\s*channel\s*=\s*{channel}\b.*\}}\s*,?\s*(#.*)?$")
    inside, left = "", made
    for line in lines:
        start = _TABLE.match(line)
        inside = start[1] if start is not None else "" if line.startswith("]") else inside
        match = own.match(line) if inside == table else None
        if match is None:
            found.append(line)
            continue
        if match[1] and match[1] not in "".join(left):
            found.append(f"  {match[1]}")
        found += left
        left = []
    return found if not left else lines


def _added(lines: list[str], table: str, made: list[str]) -> list[str]:
    """Return lines with entries at the end of their table, which is added before the first section if need be."""
    inside = ""
    for k, line in enumerate(lines):
        start = _TABLE.match(line)
        inside = start[1] if start is not None else inside
        if inside == table and line.startswith("]"):
            return [*lines[:k], *made, *lines[k:]]
        inside = "" if line.startswith("]") else inside
    if any(re.match(rf"\s*\[\[{table}\]\]", line) for line in lines):
        blocks = [block for each in made for block in ("", f"[[{table}]]", *_block(each))]
        return [*lines[: _last(lines) + 1], *blocks, ""]
    first = next((k for k, line in enumerate(lines) if line.startswith("[")), _last(lines) + 1)
    return [*lines[:first], f"{table} = [", *made, "]", "", *lines[first:]]


def _block(line: str) -> list[str]:
    """Return an inline entry as the lines of a block."""
    body, _, comment = line.strip().partition("    # ")
    pairs = re.findall(r"(\w+) = (\[[^\]]*\]|\"(?:[^\"\\]|\\.)*\"|[^,}\s]+)", body)
    return [*([f"# {comment}"] if comment else []), *(f"{key} = {value}" for key, value in pairs)]


def _last(lines: list[str]) -> int:
    return max((k for k, line in enumerate(lines) if line.strip()), default=-1)
