"""Two reports of runs compared: how long, what moved, what was printed, what else is otherwise.

Moves are aligned by their axis, command and distance, prints by their words, and not by their numbers; the line of a
move may be another one. What follows a longer move later is no difference of its own: only what lies between two moves
is compared.
"""

from __future__ import annotations

import heapq
import json
import re
from typing import Any

from motionlang.diff.align import aligned
from motionlang.diff.tolerance import EXACT, Tolerance

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    Report = Mapping[str, Any]
    Move = dict[str, Any]

_FIGURES = re.compile(r"-?\d[\d.]*(?:e-?\d+)?")
_LINE = re.compile(r"\bline \d+")
# The fields that are compared by themselves, and those that say where something stands and not what it is.
OWN = ("schema", "program", "time", "status", "moves", "output", "diagnostics", "readings")
PLACES = ("line", "column")


class LineChange:
    """What is otherwise with the moves of one line: how many, which figures, how much time that makes together.

    `figures` has for each field that differs its first old and new value; `duration` and `wait` are sums, s: of the
    moves themselves, and of what lies between them and what was before.
    """

    __slots__ = ("axis", "command", "count", "duration", "figures", "first", "new", "old", "wait")

    def __init__(self, old: int, new: int, axis: int, command: str, first: float) -> None:
        self.old, self.new, self.axis, self.command, self.first = old, new, axis, command, first
        self.count = 0
        self.figures: dict[str, tuple[Any, Any]] = {}
        self.duration = self.wait = 0.0


class Difference:
    """How one report differs from another; `same` where it does not."""

    __slots__ = ("errors", "gone", "lines", "moved", "moves", "new", "others", "prints", "status", "time")

    def __init__(self) -> None:
        self.time: tuple[float, float] | None = None
        self.status: tuple[str, str] | None = None
        self.moves = (0, 0)
        self.lines: list[LineChange] = []
        self.gone: list[Move] = []
        self.new: list[Move] = []
        # Lines that have become other ones, which is no difference.
        self.moved: dict[int, int] = {}
        self.prints: list[tuple[int | None, int | None, str, str]] = []
        self.errors: list[tuple[str, str]] = []
        self.others: list[str] = []

    @property
    def same(self) -> bool:
        """Whether nothing is otherwise."""
        return not (
            self.time
            or self.status
            or self.lines
            or self.gone
            or self.new
            or self.prints
            or self.errors
            or self.others
        )

    @property
    def first(self) -> tuple[float, int] | None:
        """When and on which axis the motion is first otherwise, as far as reports tell."""
        times = [(each["start_time"], each["axis"]) for each in (*self.gone, *self.new)]
        times += [(each.first, each.axis) for each in self.lines]
        return min(times, default=None)


# What a move must have to be compared, and what kind of value that is.
_NEEDED = {"axis": int, "command": str, "line": int, "start_time": float, "phases": list}


def check(report: object) -> None:
    """ValueError where something is no report of a run, or has lost a part."""
    if not isinstance(report, dict) or not str(report.get("schema", "")).startswith("motionlang.report/"):
        raise ValueError("it is no report of a run")
    for name in ("moves", "output", "diagnostics"):
        if not isinstance(report.get(name, []), list):
            raise ValueError(f"its {name} are no list")
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
            raise ValueError(f"its move {number} lacks {', '.join(lacks) or 'a part of a phase'}")


def difference(old: Report, new: Report, tolerance: Tolerance = EXACT) -> Difference:
    """How `new` differs from `old`, both as `motionlang.report/1`; ValueError where one of them is none."""
    check(old)
    check(new)
    found = Difference()
    if not tolerance.same(old.get("time"), new.get("time"), "time"):
        found.time = old.get("time", 0.0), new.get("time", 0.0)
    if old.get("status") != new.get("status"):
        found.status = str(old.get("status")), str(new.get("status"))
    _moves(found, old.get("moves", []), new.get("moves", []), tolerance)
    _prints(found, old.get("output", []), new.get("output", []))
    _errors(found, old.get("diagnostics", []), new.get("diagnostics", []))
    for name in sorted(old.keys() | new.keys()):
        if name not in OWN:
            found.others += _others(name, old.get(name), new.get(name), tolerance)
    return found


# ------------------------------------------------------------------------------------------------------ moves


def _by_content(move: Any) -> tuple[object, ...]:
    return move["axis"], move["command"], _rounded(move["distance"]), move.get("ended", "")


def _by_kind(move: Any) -> tuple[object, ...]:
    return move["axis"], move["command"]


def _rounded(value: object) -> object:
    return round(value, 6) + 0.0 if isinstance(value, float) else value


def _moves(found: Difference, old: list[Move], new: list[Move], tolerance: Tolerance) -> None:
    found.moves = len(old), len(new)
    changes: dict[tuple[int, int, int, str], LineChange] = {}
    lines: dict[int, set[int]] = {}
    gaps = _Gaps()
    for i, j in aligned(old, new, _by_content, _by_kind):
        if i is None or j is None:
            if j is None and i is not None:
                found.gone.append(old[i])
            elif j is not None:
                found.new.append(new[j])
            continue
        a, b = old[i], new[j]
        lines.setdefault(a["line"], set()).add(b["line"])
        wait = gaps.between(a, b)
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


class _Gaps:
    """How much later a move begins after the last that was over before it, than it did: not its own, but a wait's."""

    __slots__ = ("_ends", "_last")

    def __init__(self) -> None:
        self._ends: list[tuple[float, float]] = []
        self._last = (0.0, 0.0)

    def between(self, a: Move, b: Move) -> float:
        start: float = a["start_time"]
        while self._ends and self._ends[0][0] <= start + 1e-9:
            self._last = max(self._last, heapq.heappop(self._ends))
        shift = b["start_time"] - start
        wait: float = shift - self._last[1]
        if a["duration"] is not None and b["duration"] is not None:
            heapq.heappush(self._ends, (start + a["duration"], shift + b["duration"] - a["duration"]))
        return wait


def _figures(a: Move, b: Move, tolerance: Tolerance) -> Iterator[tuple[str, Any, Any]]:
    """The fields in which two moves differ, with both values."""
    for name in ("duration", "distance", "start", "end", "peak_speed", "profile", "ended"):
        if not tolerance.same(a.get(name), b.get(name), name):
            yield name, a.get(name), b.get(name)
    one, other = a.get("phases", []), b.get("phases", [])
    names, others = [each["name"] for each in one], [each["name"] for each in other]
    if names != others:
        yield "phases", ", ".join(names), ", ".join(others)
    else:
        for was, is_ in zip(one, other, strict=True):
            if not tolerance.same(was["duration"], is_["duration"], "duration"):
                yield was["name"], was["duration"], is_["duration"]
            elif not tolerance.same(was["distance"], is_["distance"], "distance"):
                yield f"{was['name']} distance", was["distance"], is_["distance"]
    motor, other_motor = a.get("motor") or {}, b.get("motor") or {}
    for name in sorted(motor.keys() | other_motor.keys()):
        if not tolerance.same(motor.get(name), other_motor.get(name), name):
            yield name, motor.get(name), other_motor.get(name)


# ------------------------------------------------------------------------------------------------- everything else


def _prints(found: Difference, old: list[str], new: list[str]) -> None:
    for i, j in aligned(old, new, str, lambda text: _FIGURES.sub("", str(text))):
        was, is_ = "" if i is None else old[i], "" if j is None else new[j]
        if i is None or j is None or was != is_:
            found.prints.append((None if i is None else i + 1, None if j is None else j + 1, was, is_))


def _errors(found: Difference, old: list[Move], new: list[Move]) -> None:
    """Diagnostics by what they say; where they stand may be another place."""
    told = [f"{each['severity']}[{each['code']}]: {_LINE.sub('line', each['message'])}" for each in old]
    tells = [f"{each['severity']}[{each['code']}]: {_LINE.sub('line', each['message'])}" for each in new]
    for i, j in aligned(told, tells, str):
        if j is None and i is not None:
            found.errors.append(("gone", told[i]))
        elif i is None and j is not None:
            found.errors.append(("new", tells[j]))


def _others(place: str, old: object, new: object, tolerance: Tolerance, field: str = "") -> Iterator[str]:
    """Every difference between two JSON values, by the place in the document at which it is."""
    if isinstance(old, dict) and isinstance(new, dict):
        for name in sorted(old.keys() | new.keys()):
            if name in PLACES:
                continue
            if name not in old or name not in new:
                yield f"{place}.{name} is {'new' if name not in old else 'missing'}"
            else:
                yield from _others(f"{place}.{name}", old[name], new[name], tolerance, name)
    elif isinstance(old, list) and isinstance(new, list):
        if len(old) != len(new):
            yield f"{place} has {len(new)} entries instead of {len(old)}"
        for i, (one, other) in enumerate(zip(old, new, strict=False)):
            yield from _others(f"{place}[{i}]", one, other, tolerance, field)
    elif old is None or new is None:
        if old is not new:
            yield f"{place} is {'new' if old is None else 'missing'}"
    elif isinstance(old, str) and isinstance(new, str) and _LINE.sub("", old) == _LINE.sub("", new):
        return
    elif not tolerance.same(old, new, field):
        yield f"{place} is {json.dumps(new)} instead of {json.dumps(old)}"
