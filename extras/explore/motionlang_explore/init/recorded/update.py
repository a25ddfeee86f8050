"""A machine file that exists, with what a recording measured or a search found: guesses are replaced, nothing else.

An entry of `input` or `analogue` with `guess = true` is a line of the draft, and so are the switches of an axis with
`guess = true`. These lines are replaced. An entry of a person stays; a sentence says where the recording differs.
Channels without an entry are added.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import NamedTuple

from motionlang.kernel import Program, Run
from motionlang_explore.exploration import TABLES, Entry, entries
from motionlang_explore.init.recorded.drafting import (
    Refined,
    check_program,
    outcome,
    power_up_of,
    program_run,
    refined,
    rules_in_words,
    unread,
)
from motionlang_explore.init.recorded.recording import MeasuredRecording
from motionlang_explore.init.recorded.unrecorded import Tables, subject
from motionlang_explore.scenario_text import inline, toml_value

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
    known, guesses = _known(settings, raw)
    base = {key: value for key, value in known.items() if key not in MEASURED}
    recording, sentences = power_up_of(program, raw, base)
    sentences += unread(program, raw, guesses)

    def play(measured: Mapping[str, object], tables: Tables, end: float) -> Run:
        world = _with(known, measured)
        for table, mine in tables.items():
            world[table] = [*entries(world, table), *mine]
        return program_run(program, world, end)

    found = refined(recording, guesses, _guessed_switches(settings), play)
    sentences += check_program(program, found, recording)
    measured = found.given
    sentences += found.sentences
    sentences += outcome(play(measured, found.tables, until), found.recording)
    sentences += rules_in_words(found.rules)
    for table in MEASURED:
        for channel in _channels(measured, table):
            mine, theirs = _about(settings, table, channel), _about(measured, table, channel)
            if mine and not _is_guess(mine) and not _agree(mine, theirs):
                shown = " and ".join(map(inline, theirs))
                sentences.append(f"{table} {channel} stays as it is; the recording has {shown}")
    lines = _text(text, settings, found)
    for table in TABLES:
        lines = _fitted(lines, guesses.get(table, []), found.tables.get(table, []), found.comments)
    return FileUpdate("\n".join(lines), sentences)


def searched(text: str, settings: Mapping[str, object], found: Mapping[str, object]) -> str:
    """Return a machine file, given as text and settings, with other guesses: those of a world that was found."""
    lines = text.split("\n")
    for table in MEASURED:
        for channel in sorted({*_channels(settings, table), *_channels(found, table)}):
            about, guesses = _about(settings, table, channel), _about(found, table, channel)
            made = [_line({**each, "guess": True}, {}, about) for each in guesses]
            if not about:
                lines = _added(lines, table, made)
            elif _is_guess(about):
                lines = _replaced(lines, table, channel, made)
    for table in TABLES:
        mine = [each for each in entries(settings, table) if "guess" in each]
        before = [{key: value for key, value in each.items() if key != "guess"} for each in mine]
        if table not in MEASURED:
            lines = _fitted(lines, before, entries(found, table), {})
    return "\n".join(lines)


def changed_in_words(before: Mapping[str, object], after: Mapping[str, object]) -> str:
    """Return what the entries that differ between the settings of two machine files change; "" if none differ."""
    found: dict[str, tuple[list[Entry], list[Entry]]] = {}
    for table in TABLES:
        for k, settings in enumerate((before, after)):
            for each in entries(settings, table):
                found.setdefault(subject(table, each), ([], []))[k].append(each)
    return ", ".join(each for each, (old, new) in found.items() if old != new)


def true_settings(settings: Mapping[str, object]) -> dict[str, object]:
    """Return settings without the guesses of init about channels; the switches of axes are not searched again."""
    found: dict[str, object] = {}
    for key, value in settings.items():
        if key in TABLES:
            found[key] = [each for each in entries(settings, key) if "guess" not in each]
        elif not (key.startswith("run.") or key == "expect"):
            found[key] = value
    return {key: value for key, value in found.items() if value != []}


def _known(
    settings: Mapping[str, object], raw: MeasuredRecording
) -> tuple[dict[str, object], dict[str, list[Entry]]]:
    """Return settings without the guesses that no column has, and those; the recording says where a run ends."""
    columns: dict[str, set[object]] = {"input": {*raw.inputs}, "analogue": {*raw.analogue}}
    known = {key: value for key, value in settings.items() if key != "run.stop"}
    guesses: dict[str, list[Entry]] = {}
    for table in TABLES:
        mine = [
            each
            for each in entries(settings, table)
            if each.get("guess") and each.get("channel") not in columns.get(table, set())
        ]
        if mine:
            known[table] = [each for each in entries(settings, table) if each not in mine]
            guesses[table] = [{key: value for key, value in each.items() if key != "guess"} for each in mine]
    return known, guesses


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


def _text(text: str, settings: Mapping[str, object], found: Refined) -> list[str]:
    """Return the lines of a machine file with measured ones in place of guesses; all others stay."""
    lines, measured, comments = text.split("\n"), found.given, found.comments
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
        key = f"axis.{axis}.{line.partition('=')[0].strip()}" if axis else ""
        if key in measured and not key.endswith(".guess"):
            lines[k] = f"{line.partition('=')[0].rstrip()} = {toml_value(measured[key])}    # {comments[key]}"
    return lines


def _fitted(
    lines: list[str], before: list[Entry], after: list[Entry], comments: Mapping[str, str]
) -> list[str]:
    """Return lines with guesses of one table as they agree with the recording, if their lines are those of a draft."""
    gone = [inline({**each, "guess": True}) for each in before if each not in after]
    made = [_line({**each, "guess": True}, comments, []) for each in after if each not in before]
    kept = [inline({**each, "guess": True}) for each in before if each in after]
    at = [k for k, line in enumerate(lines) if any(each in line for each in gone or kept[-1:])]
    if not made or len(at) != len(gone or kept[-1:]):
        return lines
    above = [line for k, line in enumerate(lines[: at[-1] + 1]) if not gone or k not in at]
    return [*above, *made, *lines[at[-1] + 1 :]]


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
    body, _, comment = line.strip().partition("    # ")
    pairs = re.findall(r"(\w+) = (\[[^\]]*\]|\"(?:[^\"\\]|\\.)*\"|[^,}\s]+)", body)
    return [*([f"# {comment}"] if comment else []), *(f"{key} = {value}" for key, value in pairs)]


def _last(lines: list[str]) -> int:
    return max((k for k, line in enumerate(lines) if line.strip()), default=-1)
