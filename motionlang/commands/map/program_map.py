"""The map of a program, from its text alone or with what a run of it did."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from motionlang.commands.map.axes import AxisMap, axes
from motionlang.commands.map.channels import Channel, channels
from motionlang.commands.map.comments import Named, named, without_marks
from motionlang.commands.map.observed import Observed, Taken
from motionlang.commands.map.states import Diagrams, Transition, diagrams
from motionlang.commands.map.units import UnitMap, Variable, units, variables
from motionlang.kernel import Checked, Dialect, Program, Run, Source, dialect_for, run, settings_next_to
from motionlang.kernel.lang import Structure

# Seconds of machine time of a run without an end of its own.
UNTIL = 600.0
# A comment at the end of a line is a name if it is no longer than this.
MAX_COMMENT = 40


@dataclass(eq=False, slots=True)
class ProgramMap:
    """The map of a program: channels, axes, units, variables, diagrams of states.

    `unreached` are the first and last lines of statements that nothing reaches. `run` and `observed` are those of a run
    of the program, None without one.
    """

    source: Source
    language: Dialect
    structure: Structure
    channels: Sequence[Channel]
    axes: Sequence[AxisMap]
    units: Sequence[UnitMap]
    variables: Sequence[Variable]
    diagrams: Diagrams
    unreached: Sequence[tuple[int, int]]
    run: Run | None = None
    observed: Observed | None = None

    def meaning(self, title: str) -> str:
        """Return what a comment says about a unit, "" for none."""
        return next((each.meaning for each in self.units if each.title == title), "")

    def taken(self, transition: Transition) -> Taken | None:
        """Return how often and when the run has taken a transition, None if it has not."""
        return self.observed.taken.get(transition) if self.observed is not None else None


def program_map(program: Program, language: Dialect) -> ProgramMap:
    """Return the map of a program on the machine of its settings, without a run.

    Raises ProgramError with all errors of the text.
    """
    source, structure = program.source, program.structure
    listed, at_ends = _comments(source, language)
    names = named(listed)
    made, unreached = units(structure, {line: without_marks(text) for line, text in listed})
    drawn = diagrams(structure)
    return ProgramMap(
        source,
        language,
        structure,
        channels(structure, program.settings, names, at_ends, drawn.polled),
        axes(structure, names),
        made,
        variables(structure, program.names.definitions, names),
        drawn,
        unreached,
    )


def mapped(program: str | Source, machine: Mapping[str, object] | None = None) -> ProgramMap:
    """Return the map of a program by its path, on the given machine or on that of the file next to it.

    Raises OSError if a file cannot be read, ValueError for an unknown language and ProgramError for a wrong file.
    """
    source = program if isinstance(program, Source) else Source.read(program)
    settings = settings_next_to(program) if machine is None else machine
    language = dialect_for(source, None)
    return program_map(language.program(source, settings), language)


def channels_of(program: Program, language: Dialect) -> list[Channel]:
    """Return only the channels of a program; ProgramError with all errors of the text."""
    listed, at_ends = _comments(program.source, language)
    structure = program.structure
    return channels(structure, program.settings, named(listed), at_ends, diagrams(structure).polled)


def names_in_comments(source: Source, language: Dialect) -> list[Named]:
    """Return the names that the comments of a program list, also those of channels that it does not use."""
    return named(_comments(source, language)[0])


def map_of_run(
    source: Source,
    language: Dialect,
    settings: Checked,
    *,
    until: float | None = None,
    overrides: Mapping[str, float | str] | None = None,
) -> ProgramMap:
    """Return the map of a program with what a run of it does.

    The run ends after `until` seconds of machine time, by default after `run.until` of the settings or `UNTIL`. Raises
    ProgramError with all errors of the text, or for an override that names nothing.
    """
    program = language.program(source, settings)
    made = program_map(program, language)
    varied = program.with_values(overrides) if overrides else program
    varied.require()
    made.observed = observed = Observed(made.diagrams)
    end = until if until is not None or "run.until" in settings else UNTIL
    made.run = run(
        varied,
        machine=settings,
        until=end,
        overrides=overrides,
        observer=observed,
        begun=observed.attach,
    )
    if made.run.status == "ended":
        observed.ended()
    return made


def _comments(source: Source, language: Dialect) -> tuple[list[tuple[int, str]], dict[int, str]]:
    """Return the comments with a line of their own, and the short ones behind code, by line."""
    own: list[tuple[int, str]] = []
    behind: dict[int, str] = {}
    for kind, text, at in language.tokens(source.text):
        if kind != "comment":
            continue
        line, column = source.location(at)
        if source.line(line)[: column - 1].strip():
            shown = without_marks(text)
            if len(shown) <= MAX_COMMENT:
                behind[line] = shown
        else:
            own.append((line, text))
    return own, behind
