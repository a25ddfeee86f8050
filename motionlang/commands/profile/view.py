"""The time of a run as text: by cause, line, sub and task, with mutual waits."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from math import fsum

from motionlang.commands.profile.critical_path import About
from motionlang.commands.profile.motions import MOVING
from motionlang.commands.profile.profile import Share, TimeProfile
from motionlang.kernel.tools import clipped
from motionlang.views.formatting import clock_time
from motionlang.views.table import Column, Document, Table
from motionlang.views.terminal import printable, styled

# The largest number of lines in the table.
MAX_LINES = 20
MAX_NAME = 40


def render_profile(
    made: TimeProfile, *, width: int = 100, colour: bool = False, everything: bool = False
) -> str:
    """Return the profile as text that ends with a newline.

    `everything` adds all lines and the program listing.
    """
    whole = made.seconds
    cycle = made.run.cycle
    head = f"time profile of {clock_time(whole)}" + (f", cycle {cycle}" if cycle else "")
    sections = [
        [styled(head, "bold", colour)],
        kinds_table(made).lines(width, colour=colour),
    ]
    slacks = made.slacks()
    if slacks:
        sections.append([_slack(row.axis, row.other, row.seconds) for row in slacks])
    sections.append(_lines(made, width, colour, everything))
    waits = waits_table(made)
    if waits.rows:
        waits.rows = waits.rows if everything else waits.rows[:MAX_LINES]
        sections.append(waits.lines(width, colour=colour))
    subs = subs_table(made)
    if len(subs.rows) > 1:
        sections.append(subs.lines(width, colour=colour))
    if made.has_tasks and len(made.tasks) > 1:
        sections.append(tasks_table(made).lines(width, colour=colour))
    if everything:
        sections.append(_listing(made, whole, colour))
    return "\n\n".join("\n".join(section) for section in sections) + "\n"


def profile_document(made: TimeProfile) -> Document:
    """Return the profile as data."""
    slack = (Column("axis"), Column("other"), Column("seconds"))
    path = tuple(
        map(Column, ("begin", "end", "cause", "line", "sub", "callers", "task", "axes", "wait_line"))
    )
    tables = (
        lines_table(made),
        kinds_table(made),
        waits_table(made),
        subs_table(made),
        tasks_table(made),
        *causes_tables(made),
        Table("slack", slack, made.slacks()),
        Table("critical_path", path, list(map(_link, made.spans()))),
    )
    cycle = made.run.cycle
    values = {"program": made.run.source.name, "time": made.run.time, "cycle": cycle and cycle.as_dict()}
    return Document(tables, values)


def _link(span: tuple[float, float, About]) -> dict[str, object]:
    """Return a link of the critical path as a row."""
    begin, end, (cause, position, task, axes, waited) = span
    return {
        "begin": begin,
        "end": end,
        "cause": cause,
        "line": position.line,
        "sub": position.sub,
        "callers": position.callers,
        "task": task,
        "axes": axes,
        "wait_line": waited,
    }


def kinds_table(made: TimeProfile) -> Table:
    """Return the time of a run by the kind of its cause."""
    columns = (
        Column("name", "cause", left=True, style="word"),
        *_own(made),
        Column("", get=lambda share: _phases(share.causes), left=True),
    )
    return Table("kinds", columns, made.kinds())


def lines_table(made: TimeProfile) -> Table:
    """Return the time of a run by line."""

    def total(names: Sequence[str] = ()) -> Callable[[Share], float | None]:
        """Return the seconds of a line for some causes; without names, for all that is a wait."""

        def of(share: Share) -> float | None:
            found = [share.causes[name] for name in names or _waiting(share.causes) if name in share.causes]
            return fsum(found) if found else None

        return of

    columns = (
        *_place(made),
        *_own(made),
        Column("moving", unit="s", get=total(MOVING), text=_seconds),
        Column("dwell", unit="s", get=total(("dwell",)), text=_seconds, drop=2),
        Column("waiting", unit="s", get=total(), text=_seconds),
        Column("computing", unit="s", get=total(("computing",)), text=_seconds, drop=1),
        _source(made),
    )
    return Table("lines", columns, [share for share in made.lines() if share.line])


def waits_table(made: TimeProfile) -> Table:
    """Return the lines at which the program waits, with what it waits for."""
    line, sub = _place(made)
    seconds, share = _own(made)
    columns = (
        replace(line, title="at line"),
        sub,
        replace(seconds, title="waits"),
        share,
        Column("", "for", get=_awaited, left=True),
        _source(made),
    )
    return Table("waits", columns, made.waited_lines())


def subs_table(made: TimeProfile) -> Table:
    """Return the time of a run by sub, of its own and with that of what it calls."""
    columns = (
        Column("name", "sub", left=True, style="word"),
        Column("seconds", "self", "s", text=_seconds),
        Column("", get=lambda share: _percentage(share.seconds, made.seconds)),
        Column("total", unit="s", text=_seconds),
        Column("", get=lambda share: _percentage(share.total, made.seconds)),
    )
    return Table("subs", columns, made.subs())


def tasks_table(made: TimeProfile) -> Table:
    """Return the time of each task."""
    columns = (
        Column("name", "task", left=True, style="word"),
        Column("begin", data=True),
        Column("end", data=True),
        Column("life", unit="s", text=_seconds),
        Column("computing", unit="s", text=_seconds),
        Column("ready", unit="s", text=_seconds),
        Column("", "waiting for", get=lambda task: _waited(task.waiting), left=True),
    )
    return Table("tasks", columns, made.tasks)


def causes_tables(made: TimeProfile) -> tuple[Table, Table]:
    """Return the seconds of each cause at each line, and of each wait of a task, as data."""
    rows = [
        {"line": share.line, "cause": cause, "seconds": seconds}
        for share in made.lines()
        for cause, seconds in share.causes.items()
    ]
    waits = [
        {"task": task.name, "cause": cause, "seconds": seconds}
        for task in made.tasks
        for cause, seconds in task.waiting.items()
    ]
    by_line, by_task = (tuple(map(Column, (place, "cause", "seconds"))) for place in ("line", "task"))
    return Table("causes", by_line, rows), Table("task_waits", by_task, waits)


def _own(made: TimeProfile) -> tuple[Column, Column]:
    """Return the columns of the seconds of a share, and of its percentage of the whole."""
    return (
        Column("seconds", unit="s", text=_seconds),
        Column("", get=lambda share: _percentage(share.seconds, made.seconds)),
    )


def _place(made: TimeProfile) -> tuple[Column, Column]:
    return (
        Column("line"),
        Column("sub", get=lambda share: made.sub(share.line), left=True, drop=3, style="word"),
    )


def _source(made: TimeProfile) -> Column:
    def shortened(share: Share) -> str:
        return printable(clipped(made.run.source.line(share.line).strip(), MAX_NAME))

    return Column("", get=shortened, left=True, drop=4)


def _waiting(causes: Mapping[str, float]) -> list[str]:
    return [cause for cause in causes if cause not in (*MOVING, "dwell", "computing")]


def _phases(causes: Mapping[str, float]) -> str:
    if len(causes) < 2:
        return ""
    return ", ".join(f"{name} {_seconds(causes[name])}" for name in MOVING if name in causes)


def _slack(axis: int, other: int, seconds: float) -> str:
    return f"axis {axis} waits for axis {other}: {_seconds(seconds)} s"


def _lines(made: TimeProfile, width: int, colour: bool, everything: bool) -> list[str]:
    table = lines_table(made)
    if not everything and len(table.rows) > MAX_LINES:
        rest = table.rows[MAX_LINES:]
        table.rows = table.rows[:MAX_LINES]
        seconds = _seconds(fsum(share.seconds for share in rest))
        table.notes.append(f"… and {len(rest)} more lines, {seconds} s: --all shows all")
    return table.lines(width, colour=colour)


def _awaited(share: Share) -> str:
    """Return the causes that a line waits for, with seconds if there are several."""
    causes = share.causes
    names = sorted(causes, key=lambda name: (-causes[name], name))
    shown = [name.removeprefix("waiting for ").removeprefix("travel of ") for name in names]
    if len(names) < 2:
        return "".join(shown)
    return ", ".join(f"{word} {_seconds(causes[name])}" for word, name in zip(shown, names, strict=True))


def _waited(waiting: Mapping[str, float]) -> str:
    causes = sorted(waiting.items(), key=lambda item: -item[1])
    return ", ".join(f"{name} {_seconds(seconds)}" for name, seconds in causes if seconds)


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
    return f"{value:.4f}"


def _percentage(value: float, whole: float) -> str:
    return f"{value / whole:.1%}" if whole else ""
