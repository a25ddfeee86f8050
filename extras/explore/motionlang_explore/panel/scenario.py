"""A run by hand as a scenario: what was done, as entries of a machine file, and what was over when it was saved.

What is expected is what the scenario does when it is run, which `motionlang verify` repeats.
"""

from __future__ import annotations

import os
import re
from collections import defaultdict
from collections.abc import Mapping, Sequence
from itertools import count
from math import ceil
from typing import NamedTuple

from motionlang.commands.scenarios import Scenario, unmet
from motionlang.kernel import ProgramError, Run, Source, read_machine, run, settings_next_to
from motionlang.kernel.lang import layered
from motionlang.kernel.tracks import axes_of
from motionlang_explore.exploration import Change, Entry, number_in, tables_of
from motionlang_explore.panel.play import RELEASE, Play, PlayRecord
from motionlang_explore.scenario_text import error_codes, positions, scenario_text, write_scenario

# A printed line is expected within so many seconds.
NEAR = 0.05
# The digits of a time, s.
DIGITS = 4
# A run that only waits at its end may be so many times as long.
SPARE = 10
# So many printed lines are expected at most, from the first and the last ones.
MAX_PRINTS = 40
_SEQUENCE = re.compile(r"\x1b(?:\[[0-9;?]*[A-Za-z]|[^\[])|[\x00-\x1f\x7f]")


class NotSaved(Exception):
    """The run cannot be a scenario; the text says why."""


class Saved(NamedTuple):
    """The file of a scenario, and how its run differs from the one by hand, "" if it does not."""

    path: str
    difference: str


def save(file: str, play: Play) -> Saved:
    """Write the run so far as a scenario of a program.

    Raises NotSaved, and OSError if the file cannot be written. Called in the thread of the run.
    """
    program = play.program
    if play.overrides:
        raise NotSaved(f"--set {next(iter(play.overrides))} is not in the program: write the value into it")
    try:
        if Source.read(file).text != program.source.text:
            raise NotSaved(f"{os.path.basename(file)} has changed: restart, and save then")
        below = settings_next_to(file)
    except ProgramError as error:
        raise NotSaved(f"the machine file: {error.diagnostics[0].message}") from None
    below.pop("expect", None)
    above = world_of(play, below)
    made, is_timed = run(file, dialect=program.language, machine=layered(below, above)), True
    # If the machine then only waits, times are not needed: the scenario passes with other speeds in the program.
    longer = above | {"run.until": SPARE * (ceil(play.now) + 1.0)}
    untimed = run(file, dialect=program.language, machine=layered(below, longer))
    if not _difference(play, untimed):
        above, made, is_timed = longer, untimed, False
    when = f"at {play.now:.2f} s" if play.result is None else "at its end"
    about = f"{program.source.name} as it was operated by hand, saved {when} by motionlang panel."
    text = scenario_text(about, above, expected(made, is_timed=is_timed))
    try:
        read_machine(Source(file, text), is_layer=True)
    except ProgramError as error:
        raise NotSaved(f"a scenario cannot have this: {error.diagnostics[0].message}") from None
    path = write_scenario(file, (f"hand-{number}" for number in count(1)), text)
    scenario = Scenario(file, path)
    wrong = unmet(scenario.run(), scenario.expected)
    return Saved(path, wrong[0] if wrong else _difference(play, made))


def world_of(play: Play, below: Mapping[str, object]) -> dict[str, object]:
    """Return the settings of a scenario: what a hand did, and what the machine file next to the program lacks."""
    record, settings, now = play.record, play.settings, play.now
    above: dict[str, object] = {
        key: value for key, value in settings.items() if below.get(key) != value and key != "expect"
    }
    above["run.until"] = round(now, DIGITS) if play.result is None else ceil(now) + 1.0
    done = PlayRecord(
        [each for each in record.changes if each[0] < now or play.result is not None], record.answers
    )
    taken = {change.number for _, change in done.changes if change.table == "input"} & play.driven
    made = [
        ((time, change), asked)
        for (time, change), asked in zip(
            done.changes, [*play.asked, *[None] * len(done.changes)], strict=False
        )
        if change.table != RELEASE and not (change.table == "input" and change.number in taken)
    ]
    made += [((time, Change("answer", 0, text)), None) for time, text in done.answers]
    for table, entries in _tables(made).items():
        given: Sequence[Entry] = settings.get(table, ())  # type: ignore[assignment]
        numbers = {number_in(table, each) for each in entries}
        mine = [each for each in given if number_in(table, each) in numbers]
        others = [each for each in above.get(table, ()) if each not in mine]  # type: ignore[attr-defined]
        above[table] = [*others, *mine, *entries]
    if taken:
        others = [each for each in above.get("input", ()) if each["channel"] not in taken]  # type: ignore[attr-defined]
        above["input"] = [*others, *_history(play, taken, now)]
    return above


def _tables(made: Sequence[tuple[tuple[float, Change], float | None]]) -> dict[str, list[Entry]]:
    """Return the entries of changes, each with how long the program had asked for it, None if it did not.

    An input that goes back while the program does not ask for that has been pressed `for` so long.
    """
    tables: dict[str, list[Entry]] = defaultdict(list)
    # The entry that has changed an input last when the program asked for it, and when.
    pressed: dict[int, tuple[float, Entry]] = {}
    for (time, change), asked in made:
        is_input = change.table == "input"
        if is_input and asked is None and change.number in pressed:
            since, entry = pressed.pop(change.number)
            if entry["level"] != change.value and time == since:  # a switch that was thrown twice
                tables["input"].remove(entry)
                continue
            if entry["level"] != change.value:
                entry["for"] = _exact(time - since)
                continue
        ((table, entries),) = tables_of(((time, change),)).items()
        assert isinstance(entries, list)
        if asked is not None:
            entry = {key: value for key, value in entries[0].items() if key not in ("at", "value")}
            value = {"level" if is_input else "value": change.value} if "value" in entries[0] else {}
            entries = [entry | {"asked": _exact(asked)} | value | {"times": 1}]
            if is_input:
                pressed[change.number] = time, entries[0]
        tables[table] += entries
    return tables


def _exact(seconds: float) -> float:
    """Return a time to the nearest millisecond."""
    return round(seconds, 3)


def _history(play: Play, taken: set[int], now: float) -> list[Entry]:
    """Return all changes of inputs that both the machine file and a hand have changed."""
    assert play.machine is not None
    return [
        {"channel": each.channel, "at": round(each.time, DIGITS), "value": each.value}
        for each in play.machine.log.inputs
        if each.channel in taken and each.time < now
    ]


# ----------------------------------------------------------------------------------------------------- expectations


def expected(made: Run, *, is_timed: bool) -> list[Entry]:
    """Return what a run has printed and moved, and how it was when it ended; when, if `is_timed`."""
    prints = [(each.time, text) for each in made.machine.log.prints if (text := _longest(each.text))]
    if len(prints) > MAX_PRINTS:
        prints = prints[: MAX_PRINTS // 2] + prints[-MAX_PRINTS // 2 :]
    found: list[Entry] = [
        {"prints": text, "after": _rounded(max(time - NEAR, 0.0)), "before": _rounded(time + NEAR)}
        for time, text in prints
    ]
    if not is_timed:
        found = [{"prints": text} for text in dict.fromkeys(text for _, text in prints)]
    found.append({"quantity": "moves", "value": len(made.machine.log.moves)})
    found += positions(made, axes_of(made.controller))
    codes = error_codes(made)
    found += [{"diagnostic": code} for code in codes]
    if not codes:
        found.append({"status": made.status})
    return found


def _longest(text: str) -> str:
    """Return the longest part of a printed line between sequences for a screen."""
    return max((each.strip() for each in _SEQUENCE.split(text)), key=len)


def _rounded(time: float) -> float:
    return round(time, 2)


def _difference(play: Play, made: Run) -> str:
    """Return how the run of a scenario differs from the one by hand; "" if it does not."""
    assert play.machine is not None
    log, other = play.machine.log, made.machine.log
    if [each.text for each in log.prints] != [each.text for each in other.prints]:
        return "it prints other lines"
    if len(log.moves) != len(other.moves):
        return f"it makes {len(other.moves)} moves, not {len(log.moves)}"
    return ""
