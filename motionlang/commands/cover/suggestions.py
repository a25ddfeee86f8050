"""Scenarios for what no run of a program has reached, for `motionlang cover --suggest`.

An exploration of the program (`exploration`) has the states in which it waits, and the transitions between them.
Each transition that leads further than the runs so far becomes a world on top of the program's own: the changes that
lead there, and its causes. So do the cycle of the program, and what other keys and answers lead to.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from motionlang.commands.cover import Coverage, coverage
from motionlang.commands.cover.worlds import CutOff, Event, Worlds
from motionlang.commands.init import ending, slug
from motionlang.commands.scenario_text import error_codes, positions, scenario_text
from motionlang.commands.scenarios import unmet
from motionlang.exploration import LENGTH, Change, Entry, Exploration, entries, number_in, plain, tables_of
from motionlang.kernel import ProgramError, Run, Source, read_machine, run
from motionlang.kernel.lang import layered, names_in_comments
from motionlang.kernel.report import axes as axes_of
from motionlang.kernel.tools import ranges

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
    """A world: its name, settings on top of the program's own, and the lines that it is the first to reach."""

    name: str
    settings: dict[str, object]
    text: str
    reaches: list[int]


class Search:
    """The worlds of a program that reach more than its runs; `own` are the settings of its machine file.

    `before` are the events that its runs have reached already, `limit` is the time limit of a world.
    """

    def __init__(
        self,
        worlds: Worlds,
        exploration: Exploration,
        own: dict[str, object],
        before: Counter[Event],
        limit: float,
    ) -> None:
        self.worlds, self.exploration, self.own, self.limit = worlds, exploration, own, limit
        self.events = before.copy()
        # What all runs together have reached.
        self.coverage = self._covered()
        self.found: list[SuggestedWorld] = []
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

    def _covered(self) -> Coverage:
        program = self.worlds.program
        return coverage(program.structure, program.offsets, self.events)

    def _candidates(self) -> Iterator[tuple[str, dict[str, object]]]:
        """Yield names and settings: of the cycle, of each transition, and of other keys and answers."""
        exploration, world = self.exploration, self.exploration.world
        target = exploration.program.target
        model = {"controller.model": target.model} if target.model else {}
        added = {**exploration.switches.settings, **model}
        added = {key: value for key, value in added.items() if key not in self.own}

        def settings(tables: Mapping[str, object], until: float) -> dict[str, object]:
            return {**added, **self._above(tables), "run.until": round(min(until, self.limit), 2)}

        yield "work", settings(world.settings, world.run.time)
        transitions = [each for node in exploration.nodes for each in node.transitions]
        transitions.sort(key=lambda each: len(each.visit.timeline) + len(each.causes))
        for each in transitions:
            tables = tables_of(each.visit.changed(each.causes))
            yield (
                self._name(each.causes, (act.words for act in each.acts if not act.subject)),
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
        """Run a world, and yield it if it reaches something new and its expectations hold."""
        world = self.worlds.run(layered(self.own, settings))
        self.work += world.events.total()
        if not any(event not in self.events for event in world.events):
            return
        before = self.coverage
        events, self.events = self.events, self.events + world.events
        found = self._covered()
        reaches = sorted(before.missed.keys() - found.missed.keys())
        if world.is_cut:  # the scenario ends where its run did
            settings = {**settings, "run.until": round(world.result.time, 2)}
        suggestion = SuggestedWorld(name, settings, "", reaches)
        text = self._verified(suggestion, world.result) if found.reached > before.reached else None
        if text is None:
            self.events = events
            return
        self.coverage = found
        suggestion.text = text
        self.found.append(suggestion)
        yield suggestion

    def _verified(self, suggestion: SuggestedWorld, result: Run) -> str | None:
        """Return the text of a scenario that `verify` passes, without prints if it must be; None if it does not."""
        program, stop = self.exploration.program, ending(result)
        lines = ranges(suggestion.reaches)
        name = program.source.name.rpartition("/")[2]
        reaches = f"lines {lines}" if lines else "more"
        about = f"A world of {name}, found by motionlang cover --suggest. It reaches {reaches}. {REVIEW}"
        settings = suggestion.settings | {f"run.stop.{key}": value for key, value in stop.items()}
        for has_prints in (True, False):
            text = scenario_text(about, settings, _expected(result, bool(stop), has_prints))
            above = read_machine(Source(f"{suggestion.name}.toml", text), is_layer=True)
            expected: list[Entry] = above.pop("expect", [])  # type: ignore[assignment]
            try:
                again = run(program.source, dialect=self.worlds.language, machine=layered(self.own, above))
            except ProgramError:
                return None
            if again.status == "interrupted":
                raise CutOff(again, Counter())
            if not unmet(again, list(expected)):
                return text
        return None


def _expected(result: Run, stops: bool, has_prints: bool) -> Iterator[Entry]:
    """Yield what a run has done, as expectations: no time, no figure and, if it `stops` itself, only its events.

    The positions at a time limit depend on the speed of the machine, so they are none.
    """
    status = "stopped" if stops else result.status
    if status in ("ended", "until", "stopped", "fault"):
        yield {"status": status}
    for code in error_codes(result):
        # An error of a file is nothing that the machine does.
        if code == "beyond-limit" or not (stops or code == "machine-file"):
            yield {"diagnostic": code}
    if has_prints:
        for text in list(dict.fromkeys(filter(None, map(_wording, result.output))))[-MAX_LINES:]:
            yield {"prints": text}
    if stops or status in ("until", "stopped"):
        return
    rows: Iterable[dict[str, Any]] = axes_of(result)
    yield from positions(result, (axis["axis"] for axis in rows))


def _wording(text: str) -> str:
    """Return the words of a printed line up to its first figure."""
    words = plain(text)
    return words[: next((k for k, letter in enumerate(words) if letter.isdigit()), len(words))].strip(" -+")
