"""The exploration of a program that a command line names, its progress on a terminal, and its end by Ctrl-C."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from time import monotonic

from motionlang.cli.command import Refused
from motionlang.cli.option_groups import ProgramOptions
from motionlang.cli.signals import SIGNALS
from motionlang.exploration import Exploration, Interrupted, explore, without_world
from motionlang.kernel import ProgramError
from motionlang.views.progress import Progress


@contextmanager
def playing(name: str) -> Iterator[Progress]:
    """Show the progress of what is played in the block; Ctrl-C ends the command with the run that it has ended."""
    progress = Progress(sys.stderr, os.path.basename(name))
    try:
        yield progress
    except Interrupted as interrupted:
        SIGNALS.end_with(interrupted.result)
        raise
    finally:
        progress.done()


def time_used(seconds: float | None) -> Callable[[], float]:
    """Return what gives the share of so many seconds of real time that is over; 0 if there is no such limit."""
    began = monotonic()
    return lambda: 0.0 if seconds is None else (monotonic() - began) / seconds


def explored_program(given: ProgramOptions, switches: Mapping[str, object] | None = None) -> Exploration:
    """Explore the program that a command line names; Refused if it has errors.

    `switches` are those of its axes, where its machine has none.
    """
    source = given.source()
    settings = {**(switches or {}), **without_world(given.settings())}
    try:
        with playing(source.name) as progress:
            program = given.known_language().program(source, settings, is_debug=True)
            program = program.with_values(given.overrides())
            program.require()
            return explore(program, settings, progress=progress)
    except ProgramError as error:
        raise Refused(error.diagnostics, source=source, file=given.file) from None
