"""Draft of a machine file: the world in which a program does its work, found by playing it.

A program from a machine waits for a world that no file describes. The exploration plays it: it finds the states in
which the program waits, what leads on, and the cycle that a person would name, with a world in which it runs. This
folder writes that world down as a machine file whose entries are marked as guesses, and a scenario for each choice of a
menu.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from math import fsum, inf

from motionlang.commands.quantities import CYCLE
from motionlang.kernel import Run
from motionlang.kernel.tools import listed
from motionlang_explore.exploration import (
    TABLES,
    Change,
    Entry,
    Exploration,
    FoundWorld,
    MachineCycle,
    RestState,
    StateNode,
    asks,
    entries,
)

# The tables of choices.
CHOICES = ("answer", "key")
# Keys that are no letters in a file name.
_SPOKEN = {"\r": " enter ", "+": " plus ", "-": " minus ", "*": " star ", "#": " hash ", "?": " question "}
# A run of a program that never ends is over after so many cycles.
MAX_CYCLES = 10


@dataclass
class Draft:
    """The world of a machine file: its entries by table, the cycle, and a run with them.

    `given` are settings of a person or of a recording; those of a recording that was too short are guesses, too.
    `comments` has what was measured, by the text of the entry.
    """

    exploration: Exploration
    world: FoundWorld
    run: Run
    given: Mapping[str, object]
    comments: Mapping[str, str] = field(default_factory=dict)

    @property
    def count(self) -> int:
        """The number of guessed entries and axes."""
        found = sum(len(self.entries(table)) for table in TABLES) + len(self.exploration.switches.axes)
        measured = (each for table in TABLES for each in entries(self.given, table))
        return found + sum("guess" in each for each in measured)

    def entries(self, table: str) -> list[Entry]:
        """Return the guessed entries of a table."""
        return entries(self.world.settings, table)


def slug(text: str) -> str:
    """Return a text as a part of a file name: words of letters and digits with dashes between them."""
    spoken = re.sub(r"(?<=\w)-", " ", text)
    words = "".join(_SPOKEN.get(each, each.lower() if each.isalnum() else " ") for each in spoken).split()
    return "-".join(words)


def draft(
    exploration: Exploration, chosen: MachineCycle | None, until: float, given: Mapping[str, object]
) -> Draft:
    """Return the world of a cycle of an exploration, by default the likeliest, with its run up to a time limit."""
    world = exploration.world if chosen is None else exploration.world_of([chosen])
    return Draft(exploration, world, exploration.run(world.settings, until), given)


@dataclass(frozen=True)
class Choice:
    """A way through the menus of a program that moves an axis: what is chosen, and the cycle."""

    changes: tuple[Change, ...]
    cycle: MachineCycle

    @property
    def name(self) -> str:
        """The name of its scenario, such as "choice-2-1"."""
        return "-".join(["choice", *(slug(str(each.value)) for each in self.changes)])

    def __str__(self) -> str:
        return ", ".join(
            f'"{each.prompt or "INPUT"}" {each.value}' if each.table == "answer" else str(each)
            for each in self.changes
        )


def choices(exploration: Exploration) -> list[Choice]:
    """Return the likeliest cycle of each way through the menus of a program, in the order of the menus.

    A menu is a state from which several answers, or keys, lead on in different ways. Where they lead to the same state,
    they are a choice if another line moves an axis then.
    """
    menus: dict[RestState | None, StateNode] = {}
    for node in exploration.nodes:
        found = {change for each in node.transitions if (change := _chosen(each.causes)) is not None}
        if len(found) > 1:
            menus[node.state] = node
    ways: dict[tuple[Change, ...], Choice] = {}
    for cycle in exploration.cycles:
        if cycle.work and cycle.repeats and (choice := _choice(cycle, menus)) is not None:
            ways.setdefault(choice.changes, choice)
    moved = frozenset[int]().union(*(each.cycle.work for each in ways.values()))
    for cycle, trial in exploration.variants() if menus else ():
        varied = _choice(cycle, menus)
        lines = {each.line for each in trial.moves if not each.is_homing}
        if varied is not None and not lines <= moved | cycle.visit.moved:
            ways.setdefault(varied.changes, varied)
            moved |= lines
    shortest = [way for way in ways if not any(_is_within(other, way) for other in ways if other != way)]
    return [ways[way] for way in sorted(shortest, key=lambda way: [str(each.value) for each in way])]


def _choice(cycle: MachineCycle, menus: Mapping[RestState | None, StateNode]) -> Choice | None:
    """Return what is chosen in the menus of a cycle, from the first one on that the program comes to, if any."""
    transitions = list(cycle.transitions)
    at = [k for k, each in enumerate(transitions) if each.source in menus]
    if not at:
        return None
    first = min(at, key=lambda k: len(menus[transitions[k].source].first.timeline))
    made = [
        change
        for each in transitions[first:] + transitions[:first]
        if each.source in menus and (change := _chosen(each.causes)) is not None
    ]
    return Choice(tuple(made), cycle) if made else None


def _chosen(causes: tuple[Change, ...]) -> Change | None:
    """Return the answer or key among some changes."""
    return next((each for each in causes if each.table in CHOICES), None)


def _is_within(way: tuple[Change, ...], other: tuple[Change, ...]) -> bool:
    """True if another way makes the choices of a way, and more."""
    return len(way) < len(other) and not Counter(way) - Counter(other)


def ending(result: Run) -> dict[str, object]:
    """Return the settings below `run.stop` that end a run of a program without an end; empty if it has one.

    It ends after some cycles, by what happens once in each or by a move, or where the program asks for one more answer.
    """
    if asks(result):
        return {"event": "input"}
    cycle = result.cycle
    if cycle is None or result.status not in ("until", "fault"):
        return {}
    times = min(cycle.count, MAX_CYCLES)
    begun = min(cycle.count, MAX_CYCLES + 1)  # a move begins: the cycles before are whole
    name = CYCLE.fullmatch(cycle.name)
    line, _, text, _ = (None,) * 4 if name is None else name.groups()
    if text:
        return {"prints": text, "times": times}
    if line:
        return {"line": int(line), "times": begun}
    return at_last_move(result, cycle.times[times] if times < len(cycle.times) else inf)


def at_last_move(result: Run, until: float = inf) -> dict[str, object]:
    """Return the settings below `run.stop` that end a run with its last move that begins before a time, s."""
    moves = [(each.line, each.axis) for each in result.machine.log.moves if each.start_time < until]
    return {"line": moves[-1][0], "times": moves.count(moves[-1])} if moves else {}


def cycle_text(exploration: Exploration, cycle: MachineCycle, seconds: float | None = None) -> str:
    """Return what a cycle consists of: its states, what changes in it, the axes that it moves, and its time."""
    states = [
        min(exploration.line(at) for at in place.statements)
        for each in cycle.states
        for place in (each or ())[:1]
    ]
    changed = dict.fromkeys(
        str(each) if each.table in CHOICES else each.subject
        for transition in cycle.transitions
        for each in transition.causes
    )
    axes = sorted({axis for line in cycle.work for axis in exploration.axes[line]})
    time = fsum(each.seconds for each in cycle.transitions) if seconds is None else seconds
    parts = [" → ".join(map(str, states)) or "work without a rest"]
    parts += [", ".join(_grouped(changed))] if changed else []
    parts += [f"{'axes' if len(axes) > 1 else 'axis'} {listed(axes)}"] if axes else []
    return ", ".join([*parts, *([f"{time:.4g} s"] if time else [])])


def _grouped(names: Mapping[str, None]) -> Iterator[str]:
    """Yield the inputs together, and then the others."""
    inputs = [int(each.removeprefix("input ")) for each in names if each.startswith("input ")]
    if inputs:
        yield f"{'inputs' if len(inputs) > 1 else 'input'} {listed(sorted(inputs))}"
    yield from (each for each in names if not each.startswith("input "))
