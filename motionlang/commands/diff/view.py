"""The effect of a change as text.

Time comes first, followed by lines, printed output, errors and the rest.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import fsum
from typing import TYPE_CHECKING, Any

from motionlang.commands.diff.charged import Charge
from motionlang.commands.diff.literals import ChangedLiteral
from motionlang.commands.diff.reports import Difference, LineChange
from motionlang.commands.diff.tolerance import FIELDS
from motionlang.kernel.tools import clipped, count_of
from motionlang.views.table import Column, Document, Table
from motionlang.views.terminal import printable, styled

if TYPE_CHECKING:
    from motionlang.commands.diff.motion import Divergence

UNITS = {"time": "s", "position": "uu", "speed": "uu/s"}
# Figures of a motor that have no unit in `UNITS`.
MOTOR_UNITS = {"peak_output": "V", "rms_torque": "N m"}
# The largest number of entries of a kind that are listed, and of lines that a time difference is attributed
# to.
MAX_LINES, MAX_CHARGED = 12, 4


def diff_document(
    found: Difference,
    diverged: Divergence | None,
    charges: Sequence[Charge],
    changed: Sequence[ChangedLiteral],
    kept: Sequence[tuple[str, object, object]],
) -> Document:
    """Return the difference of two runs as data; a value that changed is `old` and `new`."""
    none = None, None
    pairs = {"status": found.status or none, "time": found.time or none, "cycle": found.cycle or none}
    values = {
        f"{side}_{name}": pair[k] for name, pair in pairs.items() for k, side in enumerate(("old", "new"))
    }
    figures = [
        {"line": number, "figure": name, "old": was, "new": is_}
        for number, each in enumerate(found.lines)
        for name, (was, is_) in each.figures.items()
    ]
    moves = (
        "axis",
        "command",
        "line",
        "profile",
        "start_time",
        "duration",
        "start",
        "end",
        "distance",
        "peak_speed",
    )
    tables = (
        _records(
            "lines", ("old", "new", "axis", "command", "count", "first_time", "duration", "wait"), found.lines
        ),
        _records("literals", ("address", "old_address", "old", "new"), changed),
        _pairs("quantities", ("name", "old", "new"), kept),
        _records("time_by_line", ("old", "new", "seconds"), charges),
        _records("figures", ("line", "figure", "old", "new"), figures),
        _records("removed_moves", moves, found.removed),
        _records("added_moves", moves, found.new),
        _pairs("prints", ("old", "new", "old_text", "new_text"), found.prints),
        _events_table(found.events),
        _pairs("errors", ("change", "message"), found.errors),
        _pairs("others", ("text",), [(text,) for text in found.others]),
        _records(
            "divergence",
            ("time", "axis", "max_difference", "max_difference_at"),
            [diverged] if diverged else [],
        ),
    )
    return Document(tables, {"equal": found.same, **values})


def _records(name: str, keys: Sequence[str], rows: Sequence[object]) -> Table:
    return Table(name, list(map(Column, keys)), rows)


def _pairs(name: str, keys: Sequence[str], rows: Sequence[Sequence[object]]) -> Table:
    return _records(name, keys, [dict(zip(keys, row, strict=True)) for row in rows])


def _events_table(events: Sequence[tuple[Any, Any, float]]) -> Table:
    """Return the events that changed; the figures of one that is missing are None."""
    names = ("time", "kind", "axis", "line", "value", "limit", "text")
    rows = []
    for was, is_, later in events:
        row: dict[str, Any] = {f"old_{name}": (was or {}).get(name) for name in names}
        rows.append(row | {f"new_{name}": (is_ or {}).get(name) for name in names} | {"shift": later})
    keys = [f"{side}_{name}" for side in ("old", "new") for name in names]
    return _records("events", [*keys, "shift"], rows)


def diff_lines(
    found: Difference,
    diverged: Divergence | None = None,
    charges: Sequence[Charge] = (),
    *,
    colour: bool = False,
    most: int = MAX_LINES,
) -> list[str]:
    """Return the difference as lines of text; none if there is no difference.

    `charges` attribute a difference in time to program lines.
    """
    out: list[str] = []
    if found.status is not None:
        out.append(f"the run: {found.status[0]} → {found.status[1]}")
    if found.time is not None:
        was, is_ = found.time
        percent = f", {_percent(100.0 * (is_ - was) / was)} %" if was else ""
        out.append(styled(f"time: {was:.6f} → {is_:.6f} s ({is_ - was:+.6f} s{percent})", "bold", colour))
        if charges:
            out.append(f"by line: {_charged(charges, MAX_CHARGED if most == MAX_LINES else most)}")
    if found.cycle is not None:
        out.append(styled(_cycle(*found.cycle, charges), "bold", colour))
    out += _first([_line(*each) for each in _together(found.lines)], most, "lines")
    out += _first([f"missing: {_move(each)}" for each in found.removed], most, "missing moves")
    out += _first([f"new: {_move(each)}" for each in found.new], most, "new moves")
    out += [_tail(found.tail)] if found.tail else []
    out += _first([_print(*each) for each in found.prints], most, "printed lines")
    out += _first([_event(*each) for each in found.events], most, "events")
    out += _first([_error(*each) for each in found.errors], most, "errors")
    out += _first(found.others, most, "others")
    if diverged is not None:
        out.append(
            f"the motion diverges at {diverged.time:.6f} s: axis {diverged.axis}, by at most "
            f"{diverged.max_difference:.6g} uu (at {diverged.max_difference_at:.6f} s)"
        )
    elif found.first is not None and out:
        out.append(f"the motion first differs at {found.first[0]:.6f} s, on axis {found.first[1]}")
    elif found.is_commanded:
        out.append("only the commanded speed differs, the motion does not")
    return out


def _cycle(was: float, is_: float, charges: Sequence[Charge]) -> str:
    """Return the periods of two cycles, with the line that takes most of what one is longer or shorter."""
    explains = next((each for each in charges if each.text and each.seconds * (is_ - was) > 0.0), None)
    line = f": {_location(explains)} {printable(clipped(explains.text))}" if explains else ""
    return f"cycle {was:.5g} → {is_:.5g} s, {is_ - was:+.4f} s{line}"


def _percent(value: float) -> str:
    """Return a percentage with two digits; from 100 on, a whole number."""
    return f"{value:+.2g}" if abs(value) < 99.5 else f"{value:+.0f}"


def literal_lines(changed: Sequence[ChangedLiteral], most: int) -> list[str]:
    """Return a line for each literal whose value changed."""
    lines = [
        f"{each.address}: {each.old} → {each.new}" + (f", was {each.old_address}" if each.old_address else "")
        for each in changed
    ]
    return _first(lines, most, "literals")


def _charged(charges: Sequence[Charge], most: int) -> str:
    charged = [f"{_location(each)} {each.seconds:+.6f} s" for each in charges[:most]]
    if len(charges) > most:
        rest = fsum(each.seconds for each in charges[most:])
        charged.append(f"{len(charges) - most} more {rest:+.6f} s")
    return ", ".join(charged)


def _location(charge: Charge) -> str:
    old, new = charge.old, charge.new
    if old == new:
        return f"line {new}" if new else "no line"
    if old is None:
        return f"line {new} (new)"
    return f"line {old} (missing)" if new is None else f"line {old} (now {new})"


def _first(lines: list[str], most: int, what: str) -> list[str]:
    return lines if len(lines) <= most else [*lines[:most], f"and {len(lines) - most} more {what}"]


def _together(changes: Sequence[LineChange]) -> list[list[LineChange]]:
    """Group equal changes of several axes, such as segments of a path.

    Moves of an axis list are grouped, too. The largest changes in time come first.
    """
    found: dict[tuple[object, ...], list[LineChange]] = {}
    for each in sorted(changes, key=lambda each: (-abs(each.duration + each.wait), each.new, each.axis)):
        same = each.old, each.new, each.command, each.count, each.first_time, each.duration, each.wait
        found.setdefault(same, []).append(each)
    return list(found.values())


def _line(change: LineChange, *others: LineChange) -> str:
    """Return the text of a change, or of equal changes of several axes in `others`.

    Values that differ between the axes are shown with their axis.
    """
    where = f"line {change.old}" if change.old == change.new else f"line {change.old}, now {change.new}"
    moves = count_of(change.count, "move")
    changes = (change, *others)
    axes = f"axes {', '.join(str(each.axis) for each in changes)}" if others else f"axis {change.axis}"
    shared = [
        name
        for name, pair in change.figures.items()
        if all(each.figures.get(name) == pair for each in others)
    ]
    figures = [_figure(name, *change.figures[name]) for name in shared]
    for each in changes:
        own = [_figure(name, *pair) for name, pair in each.figures.items() if name not in shared]
        figures += [f"axis {each.axis} {figure}" for figure in own]
    sums = []
    if change.duration:
        sums.append(f"{change.duration:+.6f} s in motion")
    if change.wait:
        sums.append(f"{change.wait:+.6f} s before it")
    if change.count > 1 and sums:
        sums[-1] += " together"
    return f"{where}: {change.command} of {axes}, {moves}{' each' if others else ''}: {', '.join((*figures, *sums))}"


def _figure(name: str, was: Any, is_: Any) -> str:
    if name in MOTOR_UNITS or name.endswith("distance"):
        unit = MOTOR_UNITS.get(name, "uu")
    else:
        unit = UNITS.get(FIELDS.get(name, "time" if isinstance(was, float) else ""), "")
    one, other = _value(was), _value(is_)
    if one == other and isinstance(was, float) and isinstance(is_, float):
        one, other = f"{was:.12g}", f"{is_:.12g}"
    return f"{name.replace('_', ' ')} {one} → {other}{f' {unit}' if unit else ''}"


def _value(value: object) -> str:
    return "none" if value is None else f"{value:.6g}" if isinstance(value, float) else str(value)


def _move(move: dict[str, Any]) -> str:
    return (
        f"line {move['line']}: {move['command']} of axis {move['axis']} by {_value(move['distance'])} uu "
        f"at {move['start_time']:.6f} s"
    )


def _tail(seconds: float) -> str:
    return f"the run ends {seconds:+.6f} s after its last motion"


def _error(change: str, message: str) -> str:
    return f"{'missing' if change == 'removed' else 'new'}: {printable(message)}"


def _event(was: Any, is_: Any, later: float) -> str:
    if was is None or is_ is None:
        return f"{'missing' if is_ is None else 'new'}: {_happened(was if is_ is None else is_)}"
    figures = [
        f"{name} {_value(was.get(name))} → {_value(is_.get(name))}"
        for name in ("value", "limit", "text")
        if was.get(name) != is_.get(name)
    ]
    if later:
        figures.append(f"{later:+.6f} s")
    return f"{_happened(was)}: {', '.join(figures)}"


def _happened(event: Any) -> str:
    about = f"event {event['kind']}"
    if event.get("axis") is not None:
        about += f" of axis {event['axis']}"
    if event.get("line"):
        about += f", line {event['line']}"
    if event.get("text"):
        about += f", {printable(event['text'])}"
    return f"{about}, at {event['time']:.6f} s"


def _print(old: int | None, new: int | None, was: str, is_: str) -> str:
    if old is None:
        return f"new: printed line {new}, {printable(is_)!r}"
    if new is None:
        return f"missing: printed line {old}, {printable(was)!r}"
    return f"printed line {new}: {printable(was)!r} → {printable(is_)!r}"


def quantity_lines(kept: Sequence[tuple[str, object, object]]) -> list[str]:
    """Return a line for each quantity of two runs: name, both values, and the change of a number."""
    lines = []
    for name, old, new in kept:
        change = ""
        if isinstance(old, float) and isinstance(new, float):
            percent = f", {_percent(100.0 * (new - old) / old)} %" if old else ""
            change = f" ({new - old:+.6g}{percent})"
        lines.append(f"{name}: {_shown(old)} → {_shown(new)}{change}")
    return lines


def _shown(value: object) -> str:
    return f"{value:.6g}" if isinstance(value, float) else "none" if value is None else printable(str(value))
