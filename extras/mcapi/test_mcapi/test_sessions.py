"""Calls of a host and what they return, as lines of the port: `sessions.txt`.

`== title` begins a session, `; ` a comment with the figures by hand. `board` powers up a board with the settings of a
machine file; constants are numbers, see `motionlang_mcapi/table.py`. Behind `->` are the result of a call and what it
returns. `ascii` is a line of a host on the other interface, carried out; `advance` lets time pass, and `now` is the
time. A move of 5000 counts at 100 000 counts/s² never reaches 40 000 counts/s: it takes twice the root of s/a.
`pytest --update` rewrites what is returned.
"""

from __future__ import annotations

import json
from pathlib import Path

from motionlang_mcapi import Mcapi
from test_mcapi.conftest import ask
from tests.cases import repeat, sessions

FILE = Path(__file__).with_name("sessions.txt")


def returned(host: Mcapi, line: str) -> str | None:
    """Carry out a line, and return what the host gets."""
    verb, _, rest = line.partition(" ")
    if verb == "advance":
        host.advance(float(rest))
    elif verb == "ascii":
        port = host.board.console.open(echo=False)
        port.feed(rest.encode() + b"\r")
        host.board.console.run_until(lambda: not port.busy, 1.0)
        assert b"?" not in port.take()
    else:
        return f"{host.now:.9g}" if verb == "now" else ask(host, line)
    return None


def replayed(session: str) -> str:
    """Return a session with what its calls return now."""
    host = None
    shown = []
    for text in session.splitlines():
        line, found = text.partition(" ->")[0], None
        if line == "board" or line.startswith("board "):
            host = Mcapi.virtual(json.loads(line[6:] or "{}"))
        elif host is not None:
            found = returned(host, line)
        shown.append(text if found is None else f"{line} -> {found}")
    return "\n".join(shown) + "\n"


@sessions(FILE)
def test_calls_return_what_is_written(path: Path, session: str, update: bool) -> None:
    repeat(path, session, replayed, update)
