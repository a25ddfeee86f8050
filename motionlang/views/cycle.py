"""The time of a run as text: by cause, line, sub and task, with mutual waits."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import fsum

from motionlang.analysis.cycle.motions import MOVING
from motionlang.analysis.cycle.profile import Share, TimeProfile
from motionlang.views.grid import Column, grid
from motionlang.views.terminal import printable, styled
from motionlang.views.words import clock_time

# The largest number of lines in the table.
MAX_LINES = 20
MAX_NAME = 40

_KINDS = (
    Column("cause", align="<", style="word"),
    Column("seconds", "s"),
    Column(""),
    Column("", align="<"),
)
_LINES = (
    Column("line"),
    Column("sub", align="<", drop=3, style="word"),
    Column("seconds", "s"),
    Column(""),
    Column("moving", "s"),
    Column("dwell", "s", drop=2),
    Column("waiting", "s"),
    Column("computing", "s", drop=1),
    Column("", align="<", drop=4),
)
_WAITS = (
    Column("at line"),
    Column("sub", align="<", drop=3, style="word"),
    Column("waits", "s"),
    Column(""),
    Column("for", align="<"),
    Column("", align="<", drop=4),
)
_SUBS = (
    Column("sub", align="<", style="word"),
    Column("self", "s"),
    Column(""),
    Column("total", "s"),
    Column(""),
)
_TASKS = (
    Column("task", align="<", style="word"),
    Column("life", "s"),
    Column("computing", "s"),
    Column("ready", "s"),
    Column("waiting for", align="<"),
)


def render_profile(
    made: TimeProfile, *, width: int = 100, colour: bool = False, everything: bool = False
) -> str:
    """Return the profile as text that ends with a newline.

    `everything` adds all lines and the program listing.
    """
    whole = made.seconds
    sections = [
        [styled(f"time profile of {clock_time(whole)}", "bold", colour)],
        _kinds(made, whole, width, colour),
    ]
    slacks = made.slacks()
    if slacks:
        sections.append([_slack(row.axis, row.other, row.seconds) for row in slacks])
    sections.append(_lines(made, whole, width, colour, everything))
    waits = made.waited_lines()
    if waits:
        sections.append(_waits(made, waits, whole, width, colour, everything))
    subs = made.subs()
    if len(subs) > 1:
        sections.append(grid(_SUBS, [_sub(share, whole) for share in subs], width=width, colour=colour))
    if made.has_tasks and len(made.tasks) > 1:
        sections.append(
            grid(_TASKS, [_task(made, k) for k in range(len(made.tasks))], width=width, colour=colour)
        )
    if everything:
        sections.append(_listing(made, whole, colour))
    return "\n\n".join("\n".join(section) for section in sections) + "\n"


def _kinds(made: TimeProfile, whole: float, width: int, colour: bool) -> list[str]:
    rows = [
        [share.name, _seconds(share.seconds), _percentage(share.seconds, whole), _causes(share.causes)]
        for share in made.kinds()
    ]
    return grid(_KINDS, rows, width=width, colour=colour)


def _causes(causes: Mapping[str, float]) -> str:
    """Return the duration of each phase of a move."""
    if len(causes) < 2:
        return ""
    return ", ".join(f"{name} {_seconds(causes[name])}" for name in MOVING if name in causes)


def _slack(axis: int, other: int, seconds: float) -> str:
    return f"axis {axis} waits for axis {other}: {_seconds(seconds)} s"


def _lines(made: TimeProfile, whole: float, width: int, colour: bool, everything: bool) -> list[str]:
    shares = [share for share in made.lines() if share.line]
    shown = shares if everything else shares[:MAX_LINES]
    lines = grid(_LINES, [_line(made, share, whole) for share in shown], width=width, colour=colour)
    if len(shown) < len(shares):
        rest = fsum(share.seconds for share in shares[len(shown) :])
        more = f"… and {len(shares) - len(shown)} more lines, {_seconds(rest)} s: --all shows all"
        lines.append(styled(more, "dim", colour))
    return lines


def _line(made: TimeProfile, share: Share, whole: float) -> list[str]:
    causes = share.causes
    waiting = [cause for cause in causes if cause not in (*MOVING, "dwell", "computing")]
    return [
        str(share.line),
        made.sub(share.line),
        _seconds(share.seconds),
        _percentage(share.seconds, whole),
        _sum(causes, MOVING),
        _sum(causes, ("dwell",)),
        _sum(causes, waiting),
        _sum(causes, ("computing",)),
        _source(made, share.line),
    ]


def _waits(
    made: TimeProfile, shares: Sequence[Share], whole: float, width: int, colour: bool, everything: bool
) -> list[str]:
    """Return a table of the lines at which the program waits, with the causes."""
    rows = [
        [
            str(share.line),
            made.sub(share.line),
            _seconds(share.seconds),
            _percentage(share.seconds, whole),
            _awaited(share.causes),
            _source(made, share.line),
        ]
        for share in (shares if everything else shares[:MAX_LINES])
    ]
    return grid(_WAITS, rows, width=width, colour=colour)


def _awaited(causes: Mapping[str, float]) -> str:
    """Return the causes that a line waits for, with seconds if there are several."""
    names = sorted(causes, key=lambda name: (-causes[name], name))
    shown = [name.removeprefix("waiting for ").removeprefix("travel of ") for name in names]
    if len(names) < 2:
        return "".join(shown)
    return ", ".join(f"{word} {_seconds(causes[name])}" for word, name in zip(shown, names, strict=True))


def _source(made: TimeProfile, line: int) -> str:
    source = made.run.source.line(line).strip()
    return printable(source if len(source) <= MAX_NAME else f"{source[: MAX_NAME - 1]}…")


def _sum(causes: Mapping[str, float], names: Sequence[str]) -> str:
    found = [causes[name] for name in names if name in causes]
    return _seconds(fsum(found)) if found else ""


def _sub(share: Share, whole: float) -> list[str]:
    return [
        share.name,
        _seconds(share.seconds),
        _percentage(share.seconds, whole),
        _seconds(share.total),
        _percentage(share.total, whole),
    ]


def _task(made: TimeProfile, number: int) -> list[str]:
    task = made.tasks[number]
    causes = sorted(task.waiting.items(), key=lambda item: -item[1])
    waiting = ", ".join(f"{name} {_seconds(seconds)}" for name, seconds in causes if seconds)
    return [task.name, _seconds(task.life), _seconds(task.computing), _seconds(task.ready), waiting]


def _listing(made: TimeProfile, whole: float, colour: bool) -> list[str]:
    """Return the program with the time, s, and its share before each line."""
    by_line = {share.line: share.seconds for share in made.lines()}
    lines = made.run.source.text.rstrip("\n").split("\n")
    out = []
    for number, text in enumerate(lines, 1):
        seconds = by_line.get(number)
        head = f"{_seconds(seconds):>10}  {_percentage(seconds, whole):>6}" if seconds else " " * 18
        out.append(f"{styled(head, 'word', colour)}  {number:>4}  {printable(text)}".rstrip())
    return out


def _seconds(value: float) -> str:
    """Format seconds for a column."""
    return f"{value:.4f}"


def _percentage(value: float, whole: float) -> str:
    return f"{value / whole:.1%}" if whole else ""
