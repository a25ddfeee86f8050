"""The exploration of a program that a command line names, its progress on a terminal, and its end by Ctrl-C."""

from __future__ import annotations

import os
import sys
import textwrap
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from time import monotonic
from typing import Any, TypedDict

from motionlang.cli.command import Refused, option
from motionlang.cli.option_groups import ProgramOptions
from motionlang.cli.readers import wall_time
from motionlang.cli.signals import SIGNALS
from motionlang.kernel import ProgramError
from motionlang.views.progress import Progress
from motionlang_explore.exploration import SECONDS, Exploration, Interrupted, explore, without_world


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


# What an exploration plays of each part of a world, and what it does not.
PLAYED = (
    (
        "inputs",
        "each at rest and in a move, counted, up to three of one condition",
        "two that pulse together",
    ),
    ("analogue inputs", "levels on both sides of each comparison", "forces that follow a stroke"),
    (
        "keys, answers, hosts",
        "values at which comparisons turn, and usual ones",
        "changes in the middle of a move",
    ),
    ("axes", "home switches, latches, inputs that are limits", "following errors, drive faults, travel"),
    ("encoders", "one steady speed", "other speeds"),
)


def played_lines() -> str:
    """Return the table of what is played as lines for the help of a command."""
    rows = (f"  {part}: {played}; not: {missing}" for part, played, missing in PLAYED)
    wrapped = (textwrap.fill(each, 78, subsequent_indent="    ") for each in rows)
    return "what is played of a world, and what is not:\n" + "\n".join(wrapped) + "\n"


class PlayTime(TypedDict):
    """The limits of an exploration: the work of so many seconds, and the share of the user's time that is over."""

    seconds: float
    used: Callable[[], float]


def seconds_option(usual: float = SECONDS, before: str = "") -> Any:
    """Return the option `--seconds` of a command that plays for so long by default."""
    about = f"{before}play for at most S seconds, so that the result depends on the machine"
    return option("S", f"{about} (by default about {usual:g})", read=wall_time)


def play_time(seconds: float | None, usual: float = SECONDS) -> PlayTime:
    """Return the limits of an exploration of some seconds of real time, or of the usual work."""
    if seconds is None:
        return {"seconds": usual, "used": lambda: 0.0}
    began = monotonic()
    return {"seconds": seconds, "used": lambda: (monotonic() - began) / seconds}


def explored_program(
    given: ProgramOptions, seconds: float | None, switches: Mapping[str, object] | None = None
) -> Exploration:
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
            return explore(program, settings, progress=progress, **play_time(seconds))
    except ProgramError as error:
        raise Refused(error.diagnostics, source=source, file=given.file) from None
