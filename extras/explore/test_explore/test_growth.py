"""Each command takes twice the work for a program of twice the length: counted in calls, not in seconds."""

from __future__ import annotations

from functools import partial

import pytest

from motionlang.cli import main
from motionlang.kernel import Source, dialect_of
from motionlang_explore.diff.changed import changed_programs
from motionlang_explore.exploration import explore
from motionlang_explore.map.behaviour import behaviour_of
from motionlang_explore.map.names import ReaderNames
from motionlang_explore.map.program_map import program_map
from motionlang_explore.map.view.text import render
from tests.test_growth import LONG, SHAPES, UNTIL, folder, is_linear, measure  # noqa: F401

COMMANDS = ("map", "cover", "explore")
# The shapes of the normal run, in which each command has some.
OF_COMMANDS = {
    "map": ("labels.prg", "events.mnt"),
    "cover": ("ifs.mnt", "jumps.mcl"),
    "explore": ("select.mnt", "table.mcl"),
    "changes": ("flat.mnt", "tasks.mnt", "events.mnt"),
}
# Each of so many tasks and handlers looks at what each other one does, so a run to their end is no measure.
MANY_TASKS = ("tasks.mnt", "events.mnt")
# The trials of an exploration, whose number may depend on the program.
TRIALS = 8


def _work(command: str, name: str, text: str) -> None:
    """Carry out a command on a program; its file is in the current folder."""
    arguments = {"map": ["map", name, "--no-run"], "cover": ["cover", name, *UNTIL]}
    if command == "explore":
        _explore(name, text)
    elif command == "changes":
        _changes(name, text)
    else:
        main(arguments[command])


def _changes(name: str, text: str) -> None:
    """Find what `diff --explore` takes for changed in two equal programs."""
    language = dialect_of(name)
    assert language is not None
    changed_programs(*(language.program(Source(name, each), is_debug=True) for each in (text, text)))


def _explore(name: str, text: str) -> None:
    """Do what `init` and `cover --suggest` do first, and show it as `map` does."""
    language = dialect_of(name)
    assert language is not None
    program = language.program(Source(name, text), is_debug=True)
    made = program_map(program, language)
    shares: list[float] = []
    found = explore(
        program,
        used=lambda: float(len(shares) >= TRIALS),
        progress=lambda share, playing: shares.append(share),
    )
    names = ReaderNames(made.channels, made.axes, made.variables)
    made.behaviour = behaviour_of(found, made.structure, names, made.unreached)
    render(made, width=80)


def _is_linear(command: str, calls: list[int]) -> bool:
    """True if twice the length is twice the work; an exploration may need another trial at one length."""
    if command == "explore":
        return calls[-1] <= 2.3 ** (len(calls) - 1) * calls[0]
    return is_linear(calls)


@pytest.mark.parametrize(
    ("command", "shape"),
    [
        # An exploration makes as many trials for each length.
        pytest.param(command, shape, marks=pytest.mark.slow if command == "explore" else ())
        for command, shapes in OF_COMMANDS.items()
        for shape in shapes
    ],
)
def test_a_program_of_twice_the_length_is_twice_the_work(command: str, shape: str) -> None:
    calls = measure(partial(_work, command), shape, (30, 60, 120))
    assert _is_linear(command, calls), calls


@pytest.mark.parametrize("sizes", LONG, ids=str)
@pytest.mark.parametrize("command", COMMANDS)
def test_all_shapes_of_long_programs_are_twice_the_work(command: str, sizes: tuple[int, ...]) -> None:
    shapes = [each for each in SHAPES if command != "explore" or each not in MANY_TASKS]
    calls = {shape: measure(partial(_work, command), shape, sizes) for shape in shapes}
    assert [f"{shape}: {each}" for shape, each in calls.items() if not _is_linear(command, each)] == []
