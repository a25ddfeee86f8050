"""The exploration of a program: the search, then worlds, then what a long run in them brings, within a budget."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import fsum, inf

from motionlang.kernel import Program, Source, dialect_for, settings_next_to
from motionlang_explore.exploration.changes import (
    TABLES,
)
from motionlang_explore.exploration.exploration import Exploration
from motionlang_explore.exploration.further import goes_further
from motionlang_explore.exploration.search import Explorer, Progress
from motionlang_explore.exploration.simple import better_world, lasting_world, listed
from motionlang_explore.exploration.trials import (
    SEARCH,
    SECOND,
    Interrupted,
)
from motionlang_explore.exploration.world import ENOUGH, WHOLE, FoundWorld

# An exploration takes so long on an ordinary core, s, and one that shows what a good piece is so long at most.
SECONDS, PIECE = 5.0, 30.0
# The share of the work before a long run in the world, and that behind what each of some such runs comes to; what is
# left of the share of the search is for the rest.
FIRST, BEHIND, FURTHER = 0.3, 0.05, 4


def explore(
    program: Program,
    machine: Mapping[str, object] | None = None,
    *,
    seconds: float = SECONDS,
    used: Callable[[], float] = lambda: 0.0,
    progress: Progress = lambda share, playing: None,
    keeps: bool = False,
    most: float = 0.0,
) -> Exploration:
    """Explore a program, a debug build, in a world with the settings that a person gave.

    It does the work of so many `seconds` of an ordinary core, of up to `most` where no good piece is found, or none
    that comes again by itself. `used`
    returns the share of the user's time that is over, by which it ends. `progress` is called with the share of the work
    and what is played. Raises Interrupted, with the run, at Ctrl-C; with `keeps` the first one ends the search, and
    `interrupted` has that run.
    """
    work = seconds * SECOND
    explorer = Explorer(program, machine or {}, work, used, progress)
    try:
        explorer.explore(FIRST * work)
        found, left = Exploration(explorer), FURTHER
        while left and used() < SEARCH and goes_further(explorer, found.world):
            explorer.explore(BEHIND * work)
            found, left = Exploration(explorer, before=found), left - 1
        if left and explorer.explore(left * BEHIND * work):
            found = Exploration(explorer, before=found)
        if used() < SEARCH:
            found.world = better_world(explorer, found.world, found.cycles)
            is_found = not (found.fault_of(found.world.run) or listed(found.world.settings))
            if most > seconds and used() < SEARCH and not is_found:
                explorer.whole = explorer.trials.limit = most * SECOND
                explorer.explore(FIRST * most * SECOND)
                found = Exploration(explorer)
                found.world = better_world(explorer, found.world, found.cycles)
            found.world = lasting_world(explorer, _until_it_repeats(explorer, found.world))
    except Interrupted as at:
        if not keeps:
            raise
        found = Exploration(explorer, at.result)
    explorer.trials.limit = inf  # what is asked of the result is no part of it
    return found


def _until_it_repeats(explorer: Explorer, world: FoundWorld) -> FoundWorld:
    """Return a world with a longer run, if its own may be too short to have its cycle several times.

    It is if the cycle of the states takes long, or if the work says something that the repetition does not say.
    """
    run, period = world.run, fsum(each.seconds for each in world.cycle.transitions)
    found, prints = run.cycle, run.machine.log.prints
    is_short = (
        found is None
        or ENOUGH * period > run.time
        or any(
            each.time > found.times[0] and explorer.line(each.at) not in found.lines
            for each in prints
            if each.at >= 0
        )
    )
    if run.status != "until" or run.time >= WHOLE or not (is_short and len(run.machine.log.moves)):
        return world
    explorer.trials.limit = explorer.trials.work + SECOND
    return world._replace(run=explorer.trials.run_in(world.settings, WHOLE)[0])


def explored(source: Source, switches: Mapping[str, object] | None = None) -> Exploration:
    """Explore a program with the settings of the machine file next to it, but for its inputs, answers and the like.

    `switches` are those of its axes, where that file has none.

    Raises ProgramError for a program or a machine file with errors.
    """
    settings = {**(switches or {}), **without_world(settings_next_to(source.name))}
    program = dialect_for(source, None).program(source, settings, is_debug=True)
    program.require()
    return explore(program, settings)


def without_world(settings: Mapping[str, object]) -> dict[str, object]:
    """Return the settings of a machine file without the entries that an exploration finds by itself."""
    return {key: value for key, value in settings.items() if key not in TABLES}
