"""Forged logs: single changes of a run's log, which the proof must reject.

An entry is changed in place, so that an entry in progress remains that of its axis. The report is made
from the forged log, so the two agree and the report cannot reveal the change.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

from motionlang.kernel import Run
from motionlang.kernel.controller.motion.offset import OffsetMove
from motionlang.kernel.log import LoggedMove
from motionlang.kernel.planners import Profile
from tests.proof.forged.programs import PROGRAMS, ran

Entries = list[LoggedMove]


class Forged(NamedTuple):
    """One forged log: the program, the kind of change, and the number of its entry."""

    program: str
    kind: str
    entry: int

    def __str__(self) -> str:
        return f"{self.program}: entry {self.entry}: {self.kind}"


class Log(list[LoggedMove]):
    """A list of entries that replaces the log of a controller."""

    packed = 0

    def moved(self) -> set[int]:
        return {move.axis for move in self}


def _profile(move: LoggedMove) -> Profile:
    assert move.profile is not None
    return move.profile


def _end(move: LoggedMove) -> float:
    """Return the duration of an entry; 1 s if it is endless."""
    return min(_profile(move).duration, 1.0)


def _copy(move: LoggedMove) -> LoggedMove:
    """Return an equal entry."""
    made = (OffsetMove if move.overlaid else LoggedMove)(move.axis, move.command, move.line, move.target)
    for name in ("start_time", "profile", "scale", "zero", "ended", "offset", "commanded_speed", "action"):
        setattr(made, name, getattr(move, name))
    return made


def _set(name: str, change: Callable[[Any, LoggedMove], object]) -> Callable[[Entries, int], None]:
    """Return a function that changes one field of an entry."""

    def forge(entries: Entries, k: int) -> None:
        setattr(entries[k], name, change(getattr(entries[k], name), entries[k]))

    return forge


def _missing(entries: Entries, k: int) -> None:
    del entries[k]


def _twice(entries: Entries, k: int) -> None:
    entries.insert(k + 1, _copy(entries[k]))


def _swapped(entries: Entries, k: int) -> None:
    """Exchange the profiles of two entries with different motion."""
    others = [each for each in entries if _shape(each) != _shape(entries[k])]
    if others:
        entries[k].profile, others[0].profile = others[0].profile, entries[k].profile


def _shape(move: LoggedMove) -> tuple[float, float, float]:
    profile = _profile(move)
    return profile.start, profile.end, profile.duration


def _split(entries: Entries, k: int) -> None:
    """Replace one entry by two that both claim to be complete."""
    first, second, half = entries[k], _copy(entries[k]), 0.5 * _end(entries[k])
    profile = _profile(first)
    first.profile, second.profile = profile.cut(half), profile.after(half)
    second.start_time, second.ended, first.ended = first.start_time + half, first.ended, ""
    entries.insert(k + 1, second)


def _merged(entries: Entries, k: int) -> None:
    """Merge an entry with the next one of its axis."""
    following = next((each for each in entries[k + 1 :] if each.axis == entries[k].axis), None)
    if following is None:
        return
    done, rest = _profile(entries[k]), _profile(following)
    entries[k].profile, entries[k].ended = done.then(rest.scaled(done.end, 1.0)), following.ended
    entries.remove(following)


KINDS: dict[str, Callable[[Entries, int], None]] = {
    "begins later": _set("start_time", lambda time, _: time + 0.01),
    "begins sooner": _set("start_time", lambda time, move: time - 0.1 * _end(move)),
    "is of another axis": _set("axis", lambda axis, _: axis + 1 if axis < 2 else axis - 1),
    "lies farther on": _set("profile", lambda profile, _: profile.shifted(1.0)),
    "goes farther": _set("profile", lambda profile, _: profile.scaled(profile.start, 1.01)),
    "goes back": _set("profile", lambda profile, _: profile.scaled(profile.start, -1.0)),
    "ends sooner": _set("profile", lambda profile, move: profile.cut(0.9 * _end(move))),
    "ends in the middle": _set("profile", lambda profile, move: profile.cut(0.5 * _end(move))),
    "begins in the middle": _set("profile", lambda profile, move: profile.after(0.5 * _end(move))),
    "has the profile of another": _swapped,
    "is missing": _missing,
    "is there twice": _twice,
    "is told as two": _split,
    "is told with the next": _merged,
    "has run out": _set("ended", lambda _, __: ""),
    "is stopped": _set("ended", lambda _, __: "stop"),
    "is cancelled": _set("ended", lambda _, __: "cancel"),
    "is ended by a fault": _set("ended", lambda _, __: "fault"),
    "is replaced": _set("ended", lambda _, __: "retarget"),
    "goes on": _set("ended", lambda _, __: "continued"),
    "is of another line": _set("line", lambda line, _: line + 1),
    "has another scale": _set("scale", lambda scale, _: 2.0 * scale),
    "has another zero": _set("zero", lambda zero, _: zero + 1.0),
}


def candidates() -> Iterator[Forged]:
    """Yield all forged logs: each kind of change for some entries of each program.

    They are the first entry, the last one and one in between.
    """
    for program in PROGRAMS:
        count = len(ran(program).controller.log.moves)
        for kind in KINDS:
            for entry in sorted({0, count // 2, count - 1} & set(range(count))):
                yield Forged(program, kind, entry)


def chosen(count: int) -> list[Forged]:
    """Return `count` of all candidates, evenly spaced."""
    found = list(candidates())
    return [found[k * len(found) // count] for k in range(min(count, len(found)))]


def forge(each: Forged) -> tuple[Run, bool]:
    """Return the run with its forged log, and True if its reported motion differs."""
    result = ran(each.program)
    entries = Log(result.controller.log.moves)
    result.controller.log.moves = entries  # type: ignore[assignment]
    before = _report_rows(result)
    KINDS[each.kind](entries, each.entry)
    return result, _report_rows(result) != before


def _report_rows(result: Run) -> list[dict[str, object]]:
    """Return the rows of the report that describe the motion."""
    from motionlang.kernel.report import moves

    return list(moves(result))
