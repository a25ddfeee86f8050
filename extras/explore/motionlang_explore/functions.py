"""The functions for other Python programs that need an exploration: `motionlang.map`, `explore` and others."""

from __future__ import annotations

import os
from collections.abc import Iterable

from motionlang.functions import Program, Settings, source_of
from motionlang.kernel import CheckedSettings, Source, checked_settings, dialect_for, settings_next_to
from motionlang.kernel.failures import allowed
from motionlang_explore.cover import Coverage, covered
from motionlang_explore.exploration import Exploration, explored
from motionlang_explore.improve import Improvement, improver_of
from motionlang_explore.map.program_map import ProgramMap, map_of_machine, mapped


def map(
    program: Program,
    *,
    machine: Settings | None = None,
    run: bool = True,
) -> ProgramMap:
    """Return what a machine does, and what its program is made of: channels, axes, units, variables.

    The program is played, as in `explore`: `behaviour` has the cycle, the states, what handlers do, and what never ran.
    Without `run` it is not, and `behaviour` is None. `machine` is as in the function `run`; its inputs, answers and the
    like are not used. Raises OSError if a file cannot be read, ValueError for an unknown language and ProgramError for
    a program with errors.
    """
    source = program if isinstance(program, Source) else Source.read(program)
    settings = CheckedSettings(
        checked_settings(machine) if machine is not None else settings_next_to(program)
    )
    if run:
        return map_of_machine(source, dialect_for(source, None), settings)
    return mapped(source, settings)


def cover(program: Program, *, until: float | None = None) -> Coverage:
    """Return which statements and conditions of a program its runs reach, in its own world and in its scenarios.

    `until` ends each run, as in `run`. Raises OSError if a file cannot be read, ValueError for an unknown language and
    ProgramError for a program or a machine file with errors.
    """
    return covered(program if isinstance(program, Source) else os.fspath(program), until=until)


def explore(program: Program) -> Exploration:
    """Return the states in which a program waits, what leads from one to the next, and its cycles.

    The program is played: each input, key, answer and number of a host that it reads is changed, with the settings of
    the machine file next to it but for its inputs, answers and the like. `nodes` are the states with their
    transitions, `cycles` the cycles, the likeliest first, and `world` the entries of a machine file with which one
    runs. `str` shows all of it.

    Raises OSError if a file cannot be read, ValueError for an unknown language and ProgramError for a program or a
    machine file with errors.
    """
    return explored(source_of(program))


def improve(
    program: Program,
    *,
    machine: Settings | None = None,
    by: float = 0.0,
    edits: int = 0,
    cycle: str = "",
    also: Iterable[str] = (),
    allow: Iterable[str] = (),
) -> Improvement:
    """Return a shorter cycle of a program within the limits of its machine, as edits of its numbers.

    `machine` is as for `run`. `by` is the wanted share, such as 0.1: the fewest edits that gain it; or `edits` is
    how many edits there may be. `cycle` names what repeats, such as "cycle(12)". `also` are numbers of the process
    that are changed, too, such as "SPEED[0]@9". `allow` has the events that a good run may have, as `--allow`.
    Raises ValueError if there is no cycle or no limit, and the errors of `run`.
    """
    program = program if isinstance(program, Source) else os.fspath(program)
    return improver_of(program, machine, cycle=cycle, also=also, allow=allowed(allow)).improved(by, edits)
