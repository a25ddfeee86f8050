"""Scenarios for what no run of a program has reached, for `motionlang cover --suggest`.

An exploration of the program (`exploration`) has the states in which it waits, and the transitions between them.
Each transition that leads further than the runs so far becomes a world on top of the program's own: the changes that
lead there, and its causes. So do the cycle of the program, and what other keys and answers lead to.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from math import floor
from typing import Any

from motionlang.commands.scenarios import unmet
from motionlang.comparison.texts import plain
from motionlang.kernel import Run, Source, read_machine
from motionlang.kernel.lang import layered, names_in_comments
from motionlang.kernel.report import axes as axes_of
from motionlang.kernel.tools import lines_words
from motionlang_explore.cover import Coverage, coverage
from motionlang_explore.cover.worlds import Event, Worlds
from motionlang_explore.exploration import (
    LENGTH,
    Change,
    Entry,
    Exploration,
    entries,
    number_in,
    tables_of,
)
from motionlang_explore.init import ending, slug
from motionlang_explore.scenario_text import error_codes, positions, scenario_text

# The time limit of a world, s.
UNTIL = 300.0
# A world goes on for so long after its last transition, s.
BEYOND = 2.0
# Simple worlds are tried up to so many events in all.
MOST = 2_000_000
# The printed lines that a scenario expects, the last ones, and the tolerance of positions, uu.
MAX_LINES, WITHIN = 4, 0.001
# So many causes are in the name of a scenario.
MAX_NAMED = 3
# The longest name of a scenario.
MAX_NAME = 40
REVIEW = "The expectations are what the program does in it: check whether they are what it should do."


@dataclass
class SuggestedWorld:
    """A world: its name, the text of its scenario, and the lines that it is the first to reach."""

    name: str
    text: str
    reaches: list[int]


class Search:
    """The worlds of a program that reach more than its runs; `own` are the settings of its machine file.

    `before` are the events that its runs have reached already, `until` is the time limit of all runs, if it is given.
    """

    def __init__(
        self,
        worlds: Worlds,
        exploration: Exploration,
        own: dict[str, object],
        before: Counter[Event],
        until: float | None,
    ) -> None:
        self.worlds, self.exploration, self.own, self.until = worlds, exploration, own, until
        self.events = before
        # What all runs together have reached.
        self.coverage = self._covered()
        # The events of all worlds.
        self.work = 0
        names = names_in_comments(exploration.program.source, worlds.language)
        self._names = {(each.kind, str(each.number)): each.name for each in names}

    def run(self) -> Iterator[SuggestedWorld]:
        """Yield the worlds that reach something new."""
        for name, settings in self._candidates():
            if self.coverage.reached == self.coverage.total:
                return
            yield from self._try(name, settings)

    def _covered(self, more: Mapping[Event, int] | None = None) -> Coverage:
        program = self.worlds.program
        return coverage(program.structure, program.offsets, self.events + Counter(more))

    def _candidates(self) -> Iterator[tuple[str, dict[str, object]]]:
        """Yield names and settings: of the cycle, of each transition, and of other keys and answers."""
        exploration, world = self.exploration, self.exploration.world
        target = exploration.program.target
        model = {"controller.model": target.model} if target.model else {}
        added = {**exploration.switches.settings, **model}
        added = {key: value for key, value in added.items() if key not in self.own}

        def settings(tables: Mapping[str, object], until: float) -> dict[str, object]:
            limit = round(min(until, UNTIL), 2) if self.until is None else self.until
            return {**added, **self._above(tables), "run.until": limit}

        yield "work", settings(world.settings, world.run.time)
        transitions = [each for node in exploration.nodes for each in node.transitions]
        transitions.sort(key=lambda each: len(each.visit.timeline) + len(each.causes))
        for each in transitions:
            tables = tables_of(each.visit.changed(each.causes))
            yield (
                self._name(each.causes, each.said),
                settings(tables, each.visit.change_time + each.seconds + BEYOND),
            )
        for cycle, trial in exploration.variants():
            varied = next(each for each in cycle.transitions if each.causes)
            said = (each.text for each in trial.prints)
            yield self._name(varied.causes, said), settings(tables_of(trial.timeline), trial.time)
        for (table, number), varied_world in (
            exploration.neighbours() if exploration.interrupted is None else ()
        ):
            if self.work > MOST:
                return
            yield self._name([Change(table, number, 1.0)], ()), settings(varied_world, LENGTH)

    def _above(self, tables: Mapping[str, object]) -> dict[str, object]:
        """Return tables on top of the program's own: other inputs and levels that it drives are off."""
        above = dict(tables)
        for table in ("input", "analogue"):
            mine = {number_in(table, each) for each in entries(tables, table)}
            driven = dict.fromkeys(number_in(table, each) for each in entries(self.own, table))
            off: list[Entry] = [
                {"channel": each, "at": 0.0, "value": 0} for each in driven if each not in mine
            ]
            if made := [*entries(tables, table), *off]:
                above[table] = made
        return above

    def _name(self, causes: Iterable[Change], said: Iterable[str]) -> str:
        """Return the name of a scenario by what changes in it and what it says then, such as "guard-open-on-alarm"."""
        parts = []
        for each in list(causes)[:MAX_NAMED]:
            name = self._names.get(("input", str(each.number)), "") if each.table == "input" else ""
            parts.append(slug(str(each).replace(each.subject, name) if name else str(each)))
        words = "-and-".join(parts).split("-")
        words += [each for each in slug(_wording(next(iter(said), ""))).split("-") if each not in words]
        name = ""
        for word in filter(None, words):
            if len(name) + 1 + len(word) > MAX_NAME:
                break
            name += f"-{word}" if name else word
        return name.removesuffix("-and") or "by-itself"

    def _try(self, name: str, settings: dict[str, object]) -> Iterator[SuggestedWorld]:
        """Run a world, and yield a scenario of it if it reaches something new and its expectations hold.

        The scenario stops itself, unless what the world reaches comes later.
        """
        world = self.worlds.run(layered(self.own, settings))
        self.work += world.events.total()
        if not any(event not in self.events for event in world.events):
            return
        before, wanted = self.coverage.reached, self._covered(world.events).reached
        if wanted == before:
            return
        if world.is_cut:  # the scenario ends where its run did
            settings = {**settings, "run.until": floor(world.result.time * 100) / 100}
        stop = {f"run.stop.{key}": value for key, value in ending(world.result).items()}
        for ends, least in ((stop, wanted), ({}, before + 1)):
            suggestion = self._written(name, {**settings, **ends}, least)
            if suggestion is not None:
                yield suggestion
                return

    def _written(self, name: str, settings: Mapping[str, object], least: int) -> SuggestedWorld | None:
        """Return a scenario that `verify` passes, without prints if it must be; None if it fails or reaches less.

        What it reaches is what a run of its text does.
        """
        path = f"{name}.toml"
        above = read_machine(Source(path, scenario_text("", settings, ())), is_layer=True)
        played = self.worlds.run(layered(self.own, above))
        found = self._covered(played.events)
        if found.reached < least:
            return None
        reaches = sorted(self.coverage.missed.keys() - found.missed.keys())
        program = self.exploration.program.source.name.rpartition("/")[2]
        more = lines_words(reaches) or "more"
        about = f"A world of {program}, found by motionlang cover --suggest. It reaches {more}. {REVIEW}"
        for has_prints in (True, False):
            expected = [*_expected(played.result, has_prints)]
            if not unmet(played.result, [*expected]):
                self.events += played.events
                self.coverage = found
                return SuggestedWorld(name, scenario_text(about, settings, expected), reaches)
        return None


def _expected(result: Run, has_prints: bool) -> Iterator[Entry]:
    """Yield what a run has done, as expectations: no time, no figure and, if it was stopped, only its events.

    The positions at a time limit depend on the speed of the machine, so they are none.
    """
    if result.status in ("ended", "until", "stopped", "fault"):
        yield {"status": result.status}
    for code in error_codes(result):
        # An error of a file is nothing that the machine does.
        if code != "machine-file":
            yield {"diagnostic": code}
    if has_prints:
        for text in list(dict.fromkeys(filter(None, map(_wording, result.output))))[-MAX_LINES:]:
            yield {"prints": text}
    if result.status in ("until", "stopped"):
        return
    rows: Iterable[dict[str, Any]] = axes_of(result)
    yield from positions(result, (axis["axis"] for axis in rows))


def _wording(text: str) -> str:
    """Return the words of a printed line up to its first figure."""
    words = plain(text)
    return words[: next((k for k, letter in enumerate(words) if letter.isdigit()), len(words))].strip(" -+")
