"""The destinations of `.goto`, as a user types them: a time or a line."""

from __future__ import annotations

from collections.abc import Callable
from math import nan

from motionlang.ide.debug.debugger import Debugger, Stop


def destination(debugger: Debugger, text: str) -> Callable[[], Stop | None]:
    """Return the command that goes to a time, "2.5", or to a line, "line 12".

    Raises ValueError for any other text.
    """
    word, _, rest = text.strip().partition(" ")
    if word.lower() == "line" and rest.strip().isdecimal():
        line = debugger.line_for(int(rest.strip()[:9]))
        if line is None:
            raise ValueError(f"there is no statement in line {rest.strip()} or below")
        return lambda: debugger.go_to_line(line)
    try:
        time = float(text)
    except ValueError:
        time = nan
    if not 0.0 <= time < 1e9:
        raise ValueError(f"{text[:40]} is no time, such as 2.5, and no line, such as line 12")
    return lambda: debugger.go_to_time(time)
