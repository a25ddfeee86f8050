"""Comparison of two reports: duration, motion, prints, and other fields.

Moves are aligned by their axis, command and distance; the line of a move may differ. Prints are aligned by
their words, regardless of the numbers in them. A shift caused by a longer earlier move is not a difference:
only the time between two moves is compared.

Endless programs are compared by their cycle. Their runs end somewhere in it: a move that is cut off there, what only
one of the runs still reached, and where the axes are then is no difference.
"""

from __future__ import annotations

import json
import re
from bisect import bisect_right
from collections.abc import Callable, Iterator, Mapping
from math import inf
from typing import Any

from motionlang.commands.diff.align import aligned, common
from motionlang.commands.diff.timeline import Timeline
from motionlang.commands.diff.tolerance import EXACT, Tolerance
from motionlang.kernel.report import END_OF_RUN, SCHEMA

Report = Mapping[str, Any]
Move = dict[str, Any]

_FIGURES = re.compile(r"-?\d[\d.]*(?:e-?\d+)?")
_LINE = re.compile(r"\bline \d+")
# The fields that are compared separately, and those for positions instead of contents.
OWN = (
    "schema",
    "program",
    "time",
    "status",
    "moves",
    "output",
    "events",
    "diagnostics",
    "cycle",
    "assumptions",
)
LOCATION_FIELDS = ("line", "column")
# The fields of an axis that say where a run has ended.
POSITIONS = ("position", "wrapped_position", "counts", "motor")
# Fields of a move for its command: if no other one differs, the motion does not.
COMMANDED = frozenset(("commanded_speed",))
# Events whose figures are positions; those of the others are speeds.
POSITION_EVENTS = ("limit", "soft limit", "following error")


class LineChange:
    """The differences of the moves of one line: their number, figures, and total time.

    `figures` has the first old and new value of each field that differs. `duration` and `wait` are sums in
    seconds: `duration` of the moves themselves, `wait` of the time between each move and the one before it.
    """

    __slots__ = ("axis", "command", "count", "duration", "figures", "first_time", "new", "old", "wait")

    def __init__(self, old: int, new: int, axis: int, command: str, first_time: float) -> None:
        self.old, self.new, self.axis, self.command = old, new, axis, command
        self.first_time = first_time
        self.count = 0
        self.figures: dict[str, tuple[Any, Any]] = {}
        self.duration = self.wait = 0.0

    @property
    def is_motion(self) -> bool:
        """True if the motion differs, and not only the command."""
        return bool(self.wait) or not self.figures.keys() <= COMMANDED


class Difference:
    """The difference between two reports; `same` if there is none."""

    def __init__(self) -> None:
        self.time: tuple[float, float] | None = None
        self.cycle: tuple[float, float] | None = None  # the periods, s
        self.status: tuple[str, str] | None = None
        self.moves = (0, 0)
        self.lines: list[LineChange] = []
        self.removed: list[Move] = []
        self.new: list[Move] = []
        # Lines with new numbers, which is no difference.
        self.moved: dict[int, int] = {}
        # How much later the run ends after its last motion.
        self.tail = 0.0
        self.prints: list[tuple[int | None, int | None, str, str]] = []
        # The old and the new event; None if it was removed or added. For events that shift by themselves: by
        # how much.
        self.events: list[tuple[Move | None, Move | None, float]] = []
        self.errors: list[tuple[str, str]] = []
        # Differences in other fields of the report.
        self.others: list[str] = []
        # When moves began and ended, on which axis, and how much later that is.
        self.later: list[tuple[float, int, float]] = []

    @property
    def same(self) -> bool:
        """True if there is no difference."""
        return not (
            self.time
            or self.cycle
            or self.status
            or self.lines
            or self.removed
            or self.new
            or self.tail
            or self.prints
            or self.events
            or self.errors
            or self.others
        )

    @property
    def first(self) -> tuple[float, int] | None:
        """Time and axis of the first difference in motion that the reports show."""
        times = [(each["start_time"], each["axis"]) for each in (*self.removed, *self.new)]
        times += [(each.first_time, each.axis) for each in self.lines if each.is_motion]
        return min(times, default=None)

    @property
    def is_commanded(self) -> bool:
        """True if moves differ in their commands but not in their motion."""
        return bool(self.lines) and self.first is None


# The fields of a move that a comparison needs, and their types.
_NEEDED = {"axis": int, "command": str, "line": int, "start_time": float, "phases": list}


def end_of(report: Report) -> Move:
    """Return the end of a run, as a move that begins there."""
    return {"start_time": report.get("time", 0.0), "duration": None}


def checked(report: object) -> dict[str, Any]:
    """Return a report; raise ValueError if it is none, is incomplete, or has another version."""
    if not isinstance(report, dict) or not str(report.get("schema", "")).startswith("motionlang.report/"):
        raise ValueError("it is not a report of a run")
    if report["schema"] != SCHEMA:
        raise ValueError(f"its schema is {report['schema']}, and only {SCHEMA} can be read")
    for name in ("moves", "output", "events", "diagnostics"):
        if not isinstance(report.get(name, []), list):
            raise ValueError(f"its {name} are not a list")
    for number, event in enumerate(report.get("events", [])):
        if not isinstance(event, dict) or not {"kind", "time"} <= event.keys():
            raise ValueError(f"its event {number} has no kind or time")
    for number, move in enumerate(report.get("moves", [])):
        lacks = [
            name
            for name, kind in _NEEDED.items()
            if not isinstance(move, dict) or not isinstance(move.get(name), kind)
        ]
        lacks += [name for name in ("duration", "distance") if isinstance(move, dict) and name not in move]
        phases = move["phases"] if not lacks else []
        if lacks or not all(
            isinstance(each, dict) and {"name", "duration", "distance"} <= each.keys() for each in phases
        ):
            raise ValueError(f"its move {number} lacks {', '.join(lacks) or 'a field of a phase'}")
    return report


def difference(old: Report, new: Report, tolerance: Tolerance = EXACT) -> Difference:
    """Compare two reports; ValueError if one of them is not a report."""
    old, new = checked(old), checked(new)
    found = Difference()
    if not tolerance.same(old.get("time"), new.get("time"), "time"):
        found.time = old.get("time", 0.0), new.get("time", 0.0)
    if old.get("status") != new.get("status"):
        found.status = str(old.get("status")), str(new.get("status"))
    line = Timeline()
    cycles: list[Any] = [each.get("cycle") for each in (old, new)]
    is_cut = all(cycles) and "ended" not in (old.get("status"), new.get("status"))
    was, is_ = (
        _whole(each.get("moves", []), cycle if is_cut else None)
        for each, cycle in zip((old, new), cycles, strict=True)
    )
    _moves(found, was, is_, tolerance, line, is_cut)
    if all(cycles) and (found.lines or found.removed or found.new):
        one, other = (each["period"] for each in cycles)
        found.cycle = None if tolerance.same(one, other, "time") else (one, other)
    tail = line.wait(end_of(old), end_of(new))
    if found.time is not None and not tolerance.same(found.time[0] + tail, found.time[0], "time"):
        found.tail = tail
    _prints(found, old.get("output", []), new.get("output", []), is_cut)
    _events(found, old.get("events", []), new.get("events", []), tolerance, is_cut)
    _errors(found, old.get("diagnostics", []), new.get("diagnostics", []))
    for name in sorted(old.keys() | new.keys()):
        values = [each.get(name) for each in (old, new)]
        if is_cut and name == "axes":
            values = [_at_any_time(each) for each in values]
        if name not in OWN:
            found.others += _others(name, values[0], values[1], tolerance)
    return found


def _whole(moves: list[Move], cycle: Mapping[str, Any] | None) -> list[Move]:
    if cycle is None:
        return moves
    return [each for each in moves if each.get("ended") != END_OF_RUN or each["line"] not in cycle["lines"]]


def _at_any_time(axes: Any) -> Any:
    return [{name: value for name, value in each.items() if name not in POSITIONS} for each in axes or ()]


def _both_reach(
    pairs: list[tuple[int | None, int | None]], is_cut: bool
) -> list[tuple[int | None, int | None]]:
    """Return aligned entries, of runs that are cut off without what only one of them has at its end."""
    end = len(pairs)
    while is_cut and end and None in pairs[end - 1]:
        end -= 1
    return pairs[:end]


# ------------------------------------------------------------------------------------------------------ moves


def _by_figures(move: Any) -> tuple[object, ...]:
    return *_by_content(move), _rounded(move["duration"]), _rounded(move.get("peak_speed"))


def _by_content(move: Any) -> tuple[object, ...]:
    return move["axis"], move["command"], _rounded(move["distance"]), move.get("ended", "")


def _by_kind(move: Any) -> tuple[object, ...]:
    return move["axis"], move["command"]


def _at_lines(old: list[Move], new: list[Move], content: Callable[[Any], Any]) -> Callable[[Any], Any]:
    """Return a key of a move by content and its line in the new program, if certain.

    Reports have no program text. A line is recognised by the moves that it commands, in the order of the
    lines.
    """
    here = [_lines_of(moves) for moves in (old, new)]
    pairs = common([kinds for _, kinds in here[0]], [kinds for _, kinds in here[1]]) or []
    now = {here[0][i][0]: here[1][j][0] for i, j in pairs}
    known, olds = set(now.values()), {id(move) for move in old}

    def key(move: Any) -> tuple[object, ...]:
        line = move["line"]
        if id(move) in olds:
            return now.get(line, -line), *content(move)
        return line if line in known else None, *content(move)

    return key


def _lines_of(moves: list[Move]) -> list[tuple[int, frozenset[object]]]:
    found: dict[int, set[object]] = {}
    for move in moves:
        found.setdefault(move["line"], set()).add((move["axis"], move["command"]))
    return [(line, frozenset(found[line])) for line in sorted(found)]


def _rounded(value: object) -> object:
    return round(value, 6) + 0.0 if isinstance(value, float) else value


def _moves(
    found: Difference, old: list[Move], new: list[Move], tolerance: Tolerance, line: Timeline, is_cut: bool
) -> None:
    found.moves = len(old), len(new)
    changes: dict[tuple[int, int, int, str], LineChange] = {}
    lines: dict[int, set[int]] = {}
    exact = _at_lines(old, new, _by_figures)
    for i, j in _both_reach(aligned(old, new, exact, _by_figures, _by_content, _by_kind), is_cut):
        if i is None or j is None:
            if i is not None:
                found.removed.append(old[i])
                line.alone(old[i], 0)
            elif j is not None:
                found.new.append(new[j])
                line.alone(new[j], 1)
            continue
        a, b = old[i], new[j]
        lines.setdefault(a["line"], set()).add(b["line"])
        wait = line.wait(a, b)
        found.later += _moments(a, b)
        figures = {name: pair for name, *pair in _figures(a, b, tolerance)}
        later = not tolerance.same(a["start_time"] + wait, a["start_time"], "start_time") and abs(wait) > 1e-9
        if not figures and not later:
            continue
        key = a["line"], b["line"], a["axis"], a["command"]
        change = changes.get(key)
        if change is None:
            change = changes[key] = LineChange(*key, b["start_time"])
        change.count += 1
        change.duration += (b["duration"] or 0.0) - (a["duration"] or 0.0) if "duration" in figures else 0.0
        change.wait += wait if later else 0.0
        for name, (was, is_) in figures.items():
            change.figures.setdefault(name, (was, is_))
    found.lines = list(changes.values())
    found.moved = {was: next(iter(now)) for was, now in lines.items() if len(now) == 1 and now != {was}}


def _moments(a: Move, b: Move) -> list[tuple[float, int, float]]:
    begin, shift = a["start_time"], b["start_time"] - a["start_time"]
    if a["duration"] is None or b["duration"] is None:
        return [(begin, a["axis"], shift)]
    return [
        (begin, a["axis"], shift),
        (begin + a["duration"], a["axis"], shift + b["duration"] - a["duration"]),
    ]


def _figures(a: Move, b: Move, tolerance: Tolerance) -> Iterator[tuple[str, Any, Any]]:
    for name in ("duration", "distance", "start", "end", "peak_speed", "commanded_speed", "profile", "ended"):
        was, is_ = a.get(name), b.get(name)
        if (was != is_ or was.__class__ is not is_.__class__) and not tolerance.same(was, is_, name):
            yield name, was, is_
    one, other = a.get("phases", []), b.get("phases", [])
    if one != other:
        yield from _phases(one, other, tolerance)
    motor, other_motor = a.get("motor") or {}, b.get("motor") or {}
    for name in sorted(motor.keys() | other_motor.keys()):
        if not tolerance.same(motor.get(name), other_motor.get(name), name):
            yield name, motor.get(name), other_motor.get(name)


def _phases(one: list[Move], other: list[Move], tolerance: Tolerance) -> Iterator[tuple[str, Any, Any]]:
    names, others = [each["name"] for each in one], [each["name"] for each in other]
    if names != others:
        yield "phases", ", ".join(names), ", ".join(others)
        return
    for was, is_ in zip(one, other, strict=True):
        if not tolerance.same(was["duration"], is_["duration"], "duration"):
            yield was["name"], was["duration"], is_["duration"]
        elif not tolerance.same(was["distance"], is_["distance"], "distance"):
            yield f"{was['name']} distance", was["distance"], is_["distance"]


# ----------------------------------------------------------------------------------------------- other fields


def _prints(found: Difference, old: list[str], new: list[str], is_cut: bool) -> None:
    for i, j in _both_reach(aligned(old, new, str, lambda text: _FIGURES.sub("", str(text))), is_cut):
        was, is_ = "" if i is None else old[i], "" if j is None else new[j]
        if i is None or j is None or was != is_:
            found.prints.append((None if i is None else i + 1, None if j is None else j + 1, was, is_))


def _events(found: Difference, old: list[Move], new: list[Move], tolerance: Tolerance, is_cut: bool) -> None:
    shifts = sorted(found.later)
    for i, j in _both_reach(aligned(old, new, _by_happening, _by_axis), is_cut):
        was, is_ = None if i is None else old[i], None if j is None else new[j]
        later = 0.0
        differs = was is None or is_ is None
        if was is not None and is_ is not None:
            kind = "position" if was["kind"] in POSITION_EVENTS else "peak_speed"
            differs = was.get("text") != is_.get("text") or not all(
                tolerance.same(was.get(name), is_.get(name), kind) for name in ("value", "limit")
            )
            shift = is_["time"] - was["time"]
            if not any(
                tolerance.same(was["time"] + each, is_["time"], "time") for each in _later(shifts, was)
            ):
                later, differs = shift, True
        if differs:
            found.events.append((was, is_, later))


def _later(shifts: list[tuple[float, int, float]], event: Move) -> list[float]:
    """Return the shifts that are accepted for an event.

    They are 0, the shift of the last motion, and the shift of the last motion of the event's axis.
    """
    found = [0.0]
    index = bisect_right(shifts, (event["time"] + 1e-9, inf)) - 1
    if index >= 0:
        found.append(shifts[index][2])
    while index >= 0 and shifts[index][1] != event.get("axis"):
        index -= 1
    return [*found, shifts[index][2]] if index >= 0 else found


def _by_happening(event: Any) -> tuple[object, ...]:
    return (
        event["kind"],
        event.get("axis"),
        _rounded(event.get("value")),
        _rounded(event.get("limit")),
        event.get("text"),
    )


def _by_axis(event: Any) -> tuple[object, ...]:
    return event["kind"], event.get("axis")


def _errors(found: Difference, old: list[Move], new: list[Move]) -> None:
    before = [f"{each['severity']}[{each['code']}]: {_LINE.sub('line', each['message'])}" for each in old]
    after = [f"{each['severity']}[{each['code']}]: {_LINE.sub('line', each['message'])}" for each in new]
    for i, j in aligned(before, after, str):
        if j is None and i is not None:
            found.errors.append(("removed", before[i]))
        elif i is None and j is not None:
            found.errors.append(("added", after[j]))


def _others(path: str, old: object, new: object, tolerance: Tolerance, field: str = "") -> Iterator[str]:
    if isinstance(old, dict) and isinstance(new, dict):
        for name in sorted(old.keys() | new.keys()):
            if name in LOCATION_FIELDS:
                continue
            if name not in old or name not in new:
                yield f"{path}.{name} is {'new' if name not in old else 'missing'}"
            else:
                yield from _others(f"{path}.{name}", old[name], new[name], tolerance, name)
    elif isinstance(old, list) and isinstance(new, list):
        if len(old) != len(new):
            yield f"{path} has {len(new)} entries instead of {len(old)}"
        for i, (one, other) in enumerate(zip(old, new, strict=False)):
            yield from _others(f"{path}[{i}]", one, other, tolerance, field)
    elif old is None or new is None:
        if old is not new:
            yield f"{path} is {'new' if old is None else 'missing'}"
    elif isinstance(old, str) and isinstance(new, str) and _LINE.sub("", old) == _LINE.sub("", new):
        return
    elif not tolerance.same(old, new, field):
        yield f"{path} is {json.dumps(new)} instead of {json.dumps(old)}"
