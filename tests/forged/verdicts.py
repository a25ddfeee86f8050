"""Verdicts on forged planners: same, rejected, failed or passed."""

from __future__ import annotations

import signal
import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from math import inf
from types import FrameType
from typing import NamedTuple

from motionlang.kernel import Run, Source
from tests.forged.programs import PROGRAMS
from tests.proof import prove, run

# Times of a run at which the motion of two planners is compared, and the relative difference allowed.
MOMENTS, TOLERANCE = 101, 1e-5
# Verdicts; the last one applies to several programs; one rejection decides.
RANKS = ("same", "failed", "passed")
# Seconds after which an endless forged planner is abandoned.
MAX_SECONDS = 5.0


class Entry(NamedTuple):
    """An entry of the log: axis, start, duration and end.

    The duration is inf for a motion in progress at the end of the run.
    """

    axis: int
    start: float
    duration: float
    end: float

    def is_like(self, other: Entry) -> bool:
        """True if both entries have equal axes, durations and ends, within rounding."""
        return self.ends_like(other) and (
            self.duration == other.duration
            or abs(self.duration - other.duration) <= TOLERANCE * max(1.0, min(self.duration, other.duration))
        )

    def ends_like(self, other: Entry) -> bool:
        """True if both entries have equal axes and ends, within rounding."""
        return self.axis == other.axis and abs(self.end - other.end) <= TOLERANCE * max(1.0, abs(self.end))


class Motion(NamedTuple):
    """Positions and speeds of all axes at some times and at the end, and log entries.

    `time` is the end of the run; `called` are the functions that the run called.
    """

    time: float
    states: tuple[tuple[float, float], ...]
    ends: tuple[float, ...]
    entries: tuple[Entry, ...]
    called: frozenset[str] = frozenset()

    def ends_like(self, other: Motion) -> bool:
        """True if all axes end at the same positions, within rounding."""
        return len(self.ends) == len(other.ends) and all(
            abs(a - b) <= TOLERANCE * max(1.0, abs(a)) for a, b in zip(self.ends, other.ends, strict=True)
        )

    def differs(self, other: Motion) -> bool:
        """True if the other motion differs by more than rounding and longer waits."""
        if not self.ends_like(other) or len(self.states) != len(other.states):
            return True
        if len(self.entries) != len(other.entries):
            return True
        if not all(a.is_like(b) for a, b in zip(self.entries, other.entries, strict=True)):
            return True
        sizes = [max(1.0, *(abs(state[which]) for state in self.states)) for which in (0, 1)]
        return any(
            not abs(a[which] - b[which]) <= TOLERANCE * sizes[which]
            for a, b in zip(self.states, other.states, strict=True)
            for which in (0, 1)
        )


class Verdict(NamedTuple):
    """A verdict: "same", "rejected", "failed" or "passed".

    `program` and `message` are the program that led to it, and the reason. A planner that "passed" may be slow, which
    the proof does not cover: the tests of planners have to reject it.
    """

    kind: str
    program: str = ""
    message: str = ""


class Endless(Exception):
    """Raised if a program takes too long."""


def ran(name: str) -> Run:
    """Return the run of a program, prepared for a proof."""
    machine = {"controller.instruction_time": 1e-9}
    return run(Source(name, PROGRAMS[name]), machine=machine, until=60.0)


def motion(result: Run, times: list[float]) -> Motion:
    axes = [a for a in result.controller.axes.values() if len(a.profiles) > 1]
    states = tuple((a.at(time).position, a.at(time).velocity) for a in axes for time in times)
    entries = []
    for move in result.controller.log.moves:
        assert move.profile is not None
        left = result.time - move.start_time
        length, end = move.profile.duration, move.profile.position(min(move.profile.duration, left))
        length = inf if length > left * (1.0 + TOLERANCE) else length
        entries.append(Entry(move.axis, move.start_time, length, end))
    return Motion(result.time, states, tuple(a.position(result.time) for a in axes), tuple(entries))


def honest(names: Iterable[str] = PROGRAMS) -> dict[str, Motion]:
    """Return the motion of programs with the real planners."""
    found = {}
    for name in names:
        called: set[str] = set()

        def note(frame: FrameType, event: str, _: object, called: set[str] = called) -> None:
            if event == "call":
                called.add(frame.f_code.co_qualname)

        sys.setprofile(note)
        try:
            result = ran(name)
            states = motion(result, _times(result.time))
        finally:
            sys.setprofile(None)
        found[name] = states._replace(called=frozenset(called))
    return found


def verdict(motions: dict[str, Motion], function: str = "") -> Verdict:
    """Return the verdict on the present planner, given the real motion of programs.

    Only programs that call `function` run. The first rejected program decides. Otherwise the planner passes if it
    changes the motion of any program.
    """
    worst = Verdict("same")
    for name, before in motions.items():
        if function and function not in before.called:
            continue
        found = _of_program(name, before)
        if found.kind == "rejected":
            return found
        if RANKS.index(found.kind) > RANKS.index(worst.kind):
            worst = found
    return worst


def _of_program(name: str, before: Motion) -> Verdict:
    try:
        with _limited():
            result = ran(name)
            after = motion(result, _times(before.time))
            if result.status == "fault" or result.crash is not None or result.diagnostics:
                messages = [each.message for each in result.diagnostics]
                return Verdict("failed", name, f"{result.status} {messages[:1]}")
            violations = prove(result).violations
    except Exception as error:
        return Verdict("failed", name, repr(error))
    if violations:
        return Verdict("rejected", name, violations[0].message)
    if not before.differs(after):
        return Verdict("same")
    return Verdict("passed", name)


def _times(end: float) -> list[float]:
    return [end * k / (MOMENTS - 1) for k in range(MOMENTS)]


@contextmanager
def _limited() -> Iterator[None]:
    """Raise `Endless` if the block exceeds the time limit."""

    def give_up(number: int, frame: FrameType | None) -> None:
        raise Endless

    before: Callable[[int, FrameType | None], object] | int | None = signal.signal(signal.SIGALRM, give_up)
    signal.setitimer(signal.ITIMER_REAL, MAX_SECONDS)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)
