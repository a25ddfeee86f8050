"""Differences as scenarios: each passes on A and fails on B."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping

from motionlang.commands.quantities import values_of
from motionlang.commands.scenarios import unmet
from motionlang.comparison.texts import plain
from motionlang.kernel import Run, run
from motionlang.kernel.files import create
from motionlang_explore.diff.ways import FoundDifference, WaysCompared
from motionlang_explore.diff.ways_view import Names, found_words, way_words
from motionlang_explore.exploration import (
    Entry,
    Exploration,
    tables_of,
)
from motionlang_explore.init import slug
from motionlang_explore.scenario_text import WITHIN, error_codes, positions, scenario_text

# A scenario ends so long after its difference shows, s, and after what B does instead.
BEYOND = 1.0
# So many letters of a way are in the name of a scenario.
MAX_NAME = 48


def write_scenarios(
    found: WaysCompared, names: Names, folder: str
) -> tuple[list[str], list[FoundDifference]]:
    """Write a scenario for each difference, and return their paths, and the differences that no expectation shows.

    Raises OSError if a file cannot be written.
    """
    os.makedirs(folder, exist_ok=True)
    paths: list[str] = []
    left: list[FoundDifference] = []
    for each in found.differences:
        text = _text(found, each, names)
        if text is None:
            left.append(each)
            continue
        stem = slug(way_words(each.way, names).removeprefix("start; "))[:MAX_NAME].strip("-")
        path = os.path.join(folder, f"{len(paths) + 1:02d}-{stem}.toml")
        create(path, text.encode())
        paths.append(path)
    return paths, left


def _text(found: WaysCompared, each: FoundDifference, names: Names) -> str | None:
    shown = [acts[0].begin for acts in (each.difference.a, each.difference.b) if acts]
    timeline = each.timelines[0]
    last = max((time for time, _ in timeline), default=0.0)
    until = round(max(shown, default=min(each.a.time, each.b.time)) + BEYOND, 2)
    tables = each.way.tables if each.way.world is not None else tables_of(timeline)
    a, b = found.a, found.b
    common = {key: value for key, value in a.settings.items() if b.settings.get(key) == value}
    for end in dict.fromkeys((max(until, last + BEYOND), round(min(each.a.time, each.b.time), 2))):
        made = [_run(one, {**tables, "run.until": end}) for one in (a, b)]
        expected = list(_expected(*made))
        if any(unmet(made[1], [entry]) for entry in expected) and not unmet(made[0], [*expected]):
            head = f"{way_words(each.way, names)}: {found_words(each)}. It passes on A, and fails on B."
            return scenario_text(head, {**common, "run.until": end, **tables}, expected)
    return None


def _run(one: Exploration, settings: Mapping[str, object]) -> Run:
    machine = {**one.settings, **settings}
    return run(one.program.source, dialect=one.program.language, machine=machine)


def _expected(a: Run, b: Run) -> Iterator[Entry]:
    """Yield what a run of A has done, as expectations: first what that of B has not done."""
    status: Entry = {"status": a.status}
    if a.status in ("ended", "until", "fault", "stopped"):
        yield status
    for code in error_codes(a):
        yield {"diagnostic": code}
    mine, others = ([plain(text) for text in one.output if plain(text)] for one in (a, b))
    for text in dict.fromkeys(mine):
        if text not in others:
            yield {"prints": text}
    for text in dict.fromkeys(others):
        if not any(text in line for line in mine):
            yield {"never_prints": text}
    outputs = sorted({each.channel for one in (a, b) for each in one.machine.log.outputs})
    axes = sorted({move.axis for one in (a, b) for move in one.machine.log.moves})
    quantities = ["moves", *(f"switched.{each}" for each in outputs), *(f"peak.{each}" for each in axes)]
    before, after = values_of(a, quantities), values_of(b, quantities)
    for name, value in before.items():
        if value != after[name] and isinstance(value, (int, float)):
            yield {"quantity": name, "value": value, "within": WITHIN}
    yield from positions(a, axes)
