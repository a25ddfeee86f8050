"""The progress of an exploration on a terminal, and its end by Ctrl-C."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager

from motionlang.cli.signals import SIGNALS
from motionlang.exploration import Interrupted
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
