"""The map of a program: what its text says, and what the machine does when it is played."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from motionlang.commands.channels import Channel, channels, in_bank, only_named, order_of
from motionlang.kernel import Dialect, Program, Source, dialect, dialect_for, settings_next_to
from motionlang.kernel.lang import Structure, comments_of, names_in_comments, remarks, without_marks
from motionlang_explore.exploration import (
    PIECE,
    SECONDS,
    Change,
    Exploration,
    Progress,
    explore,
    without_world,
)
from motionlang_explore.map.axes import AxisMap, axes
from motionlang_explore.map.behaviour import MachineBehaviour, behaviour_of
from motionlang_explore.map.names import ReaderNames
from motionlang_explore.map.units import MapVariable, UnitMap, UnreachedRow, units, variables


@dataclass(eq=False, slots=True)
class ProgramMap:
    """The map of a program: channels, axes, units and variables; `behaviour` is that of the machine, None if unknown.

    `unreached` are the lines of statements that nothing leads to.
    """

    source: Source
    language: Dialect
    structure: Structure
    channels: Sequence[Channel]
    axes: Sequence[AxisMap]
    units: Sequence[UnitMap]
    variables: Sequence[MapVariable]
    unreached: Sequence[UnreachedRow]
    behaviour: MachineBehaviour | None = None


def program_map(program: Program, language: Dialect) -> ProgramMap:
    """Return the map of a program on the machine of its settings, from its text.

    Raises ProgramError with all errors of the text.
    """
    source, structure = program.source, program.structure
    names = names_in_comments(source, language)
    heads = {line: without_marks(text) for line, text in comments_of(source, language)[0]}
    made, unreached = units(structure, heads)
    used = channels(structure, program.settings, names, remarks(source, language), language.has_one_series)
    unused = {(each.kind, str(each.number)): each for each in only_named(names, used)}
    only = (Channel(*key, each.name, f"comment, line {each.line}") for key, each in unused.items())
    return ProgramMap(
        source,
        language,
        structure,
        sorted((*used, *in_bank(names, used), *only), key=order_of),
        axes(structure, names),
        made,
        variables(structure, program.names.definitions, names),
        unreached,
    )


def map_of_machine(
    source: Source,
    language: Dialect,
    settings: Mapping[str, object],
    *,
    overrides: Mapping[str, float | str] | None = None,
    progress: Progress = lambda share, playing: None,
    keeps: bool = False,
    seconds: float = SECONDS,
    used: Callable[[], float] = lambda: 0.0,
    most: float = PIECE,
) -> ProgramMap:
    """Return the map of a program with what the machine does when it is played.

    `settings` are those of its machine file; inputs, answers and the like are found by the exploration. `progress` is
    called with the share of the trials and what is played; `keeps`, `seconds`, `used` and `most` are those of
    `explore`. Raises ProgramError with all errors of the text, or for an override that names nothing.
    """
    kept = without_world(settings)
    program = language.program(source, kept, is_debug=True)
    program = program.with_values(overrides) if overrides else program
    program.require()
    found = explore(program, kept, seconds=seconds, used=used, progress=progress, keeps=keeps, most=most)
    return map_of_exploration(found)


def map_of_exploration(exploration: Exploration) -> ProgramMap:
    """Return the map of a program that was explored."""
    made = program_map(exploration.program, dialect(exploration.program.language))
    _wait_as_played(made, exploration)
    _decide_as_played(made, exploration)
    names = ReaderNames(made.channels, made.axes, made.variables)
    made.behaviour = behaviour_of(exploration, made.structure, names, made.unreached)
    return made


def _wait_as_played(made: ProgramMap, exploration: Exploration) -> None:
    """Tell the lines at which the machine has waited for a channel from those that only read it, where it has come."""
    structure, played = made.structure, defaultdict[str, set[int]](set)
    loops = sorted((loop.lines for loop in structure.waits.all()), key=len)
    for node in exploration.nodes:
        for at, read in node.reads.items():
            line = structure.line(at)
            around = {line, *next((lines for lines in loops if line in lines), ())}
            for channel in read:
                played[Change(*channel, 0.0).subject] |= around
    begun = {structure.line(at) for at in exploration.begun}
    waiting = (each for each in structure.statements.values() if each.waits)
    waits = {use.name_at: each.line for each in waiting for use in each.channels}
    for one in made.channels:
        lines = sorted({*one.reads, *one.waits})
        own = {waits[at] for at in one.names_at if at in waits}
        known = {line for line in lines if line in own | played[one.title]} | ({*one.waits} - begun)
        one.waits, one.reads = sorted(known), [line for line in lines if line not in known]


def _decide_as_played(made: ProgramMap, exploration: Exploration) -> None:
    """Tell the conditions that each channel has decided by way of variables, too."""
    statements, found = made.structure.statements, defaultdict[str, dict[str, None]](dict)
    for at, decided in sorted(exploration.decided.items()):
        statement = statements.get(at)
        # A wait is checked while any task runs.
        if statement is not None and statement.condition and not statement.waits and "~" in statement.form:
            for channel in decided:
                found[Change(*channel, 0.0).subject][f"{statement.line}: {statement.condition}"] = None
    for one in made.channels:
        own = one.decides | found["a key" if one.kind == "key" else one.title]
        one.decides = dict(sorted(own.items(), key=lambda each: int(each[0].partition(":")[0])))


def mapped(program: str | Source, machine: Mapping[str, object] | None = None) -> ProgramMap:
    """Return the map of a program by its path, on the given machine or on that of the file next to it.

    Raises OSError if a file cannot be read, ValueError for an unknown language and ProgramError for a wrong file.
    """
    source = program if isinstance(program, Source) else Source.read(program)
    settings = settings_next_to(program) if machine is None else machine
    language = dialect_for(source, None)
    return program_map(language.program(source, settings), language)
