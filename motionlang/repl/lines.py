"""A session without a terminal.

It reads lines from standard input, writes answers to standard output and errors to standard error.
"""

from __future__ import annotations

import sys

from motionlang.kernel import Source
from motionlang.repl.interrupt import Interrupts
from motionlang.repl.session import Session


def read_lines(session: Session) -> int:
    """Execute every line of standard input; return 1 if any had an error.

    An INPUT takes the next line. Ctrl-C ends the command cleanly and then raises KeyboardInterrupt, because no user
    can continue the session.
    """
    interrupts = Interrupts()
    session.interrupted = interrupts.pressed
    lines = map(_text, getattr(sys.stdin, "buffer", sys.stdin))
    session.ask = lambda begun: next(lines, None)
    for line in lines:
        with interrupts:
            session.feed(line)
            if interrupts.pressed():
                raise KeyboardInterrupt
        if session.over:
            break
    session.finish()
    return 1 if session.failed else 0


def _text(raw: str | bytes) -> str:
    return (raw if isinstance(raw, str) else Source.from_bytes("", raw).text).rstrip("\n")
