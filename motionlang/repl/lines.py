"""A session without a terminal: lines from standard input, answers to standard output, troubles to standard error."""

from __future__ import annotations

import sys

from motionlang.repl.interrupt import Interrupts
from motionlang.repl.session import Session
from motionlang.source import Source


def read_lines(session: Session) -> int:
    """Execute every line of standard input; 1 if anything was wrong."""
    interrupts = Interrupts()
    session.interrupted = interrupts.pressed
    with interrupts:
        for raw in getattr(sys.stdin, "buffer", sys.stdin):
            line = raw if isinstance(raw, str) else Source.from_bytes("", raw).text
            session.feed(line.rstrip("\n"))
            if session.over or interrupts.pressed():
                break
        session.finish()
    return 1 if session.failed else 0
