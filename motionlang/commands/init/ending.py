"""The end of a run of a program that never ends: a question, or a number of its cycles."""

from __future__ import annotations

import re
from collections import Counter

from motionlang.kernel import Run

# A run that repeats ends after so many cycles.
MAX_CYCLES = 10
_ESCAPES = re.compile(r"\x1b(?:\[[0-9;?]*[A-Za-z]|[^\[])|[\x00-\x08\x0b-\x1f\x7f]")
_FIGURE = re.compile(r"[-+]?\d")


def plain(text: str) -> str:
    """Return a printed line without escape codes and control characters."""
    return _ESCAPES.sub("", text).strip()


def wording(text: str) -> str:
    """Return the words of a printed line up to its first figure."""
    return _FIGURE.split(plain(text))[0].strip()


def asks(run: Run) -> bool:
    """True if the run ended because the program asks for a line and no answer is left."""
    scheduler = run.machine.scheduler
    tasks = () if scheduler is None else scheduler.tasks
    waits = [task.wait for task in tasks if not task.done and task.wait is not None]
    return run.status in ("fault", "until") and any(wait.cause == "operator" for wait in waits)


def ending(run: Run) -> dict[str, object]:
    """Return the settings below `run.stop` that end such a run by what it does; empty if nothing repeats.

    An endless program ends after some of its cycles: by a text that it prints again and again, or else by a line that
    moves, one of those outside the inner loops, which move least often.
    """
    if asks(run):
        return {"event": "input"}
    if run.status != "until":
        return {}
    lines = [each.text for each in run.machine.log.prints if each.time < run.time]
    for text in reversed(dict.fromkeys(map(wording, reversed(lines)))):
        count = sum(text in each for each in lines)
        if len(text) > 1 and count > 1:
            return {"prints": text, "times": min(count, MAX_CYCLES)}
    # A homing makes several moves by itself.
    table = run.dialect.table()
    moves = Counter(
        (move.line, move.axis)
        for move in run.machine.log.moves
        if move.line and not table.homes(move.command)
    )
    often: dict[int, int] = {}
    for (line, _), times in moves.items():
        often[line] = max(times, often.get(line, 0))
    fewest = min((times for times in often.values() if times > 1), default=0)
    last = next((move.line for move in reversed(run.machine.log.moves) if often.get(move.line) == fewest), 0)
    return {"line": last, "times": min(fewest, MAX_CYCLES)} if fewest else {}
