"""A session that continues in a copy of its process: when, and what the copy does.

No test makes a process.

`CALLS` has 11 statements: 1 is `For`, 2, 5 and 8 are calls in line 9, 3, 6 and 9 are in line 4 of the sub, 4, 7 and 10
in its line 5, and 11 prints.
"""

from __future__ import annotations

import os
import pickle
import socket
from collections.abc import Callable
from typing import Any, ClassVar

import pytest

from motionlang.debug import checkpoints
from motionlang.debug.breakpoints import Watched
from motionlang.debug.checkpoints import SLOW, Checkpoints, HandOver, receive, send
from motionlang.debug.debugger import Debugger, NotStopped
from motionlang.lang.machine.entries import entries
from tests.cases import cases
from tests.debug.test_debugger import CALLS, at, mint
from tests.debug.walks import go_to_number

TASK = "ParentTask"
# A statement, its time and the key of the copy that waits there.
KNOWN = [(2, 1e-5, 1), (6, 5e-5, 2)]


class Ticks:
    """A timer whose ticks come when the test makes them."""

    actions: ClassVar[list[Callable[[], object]]] = []

    def __init__(self, action: Callable[[], object]) -> None:
        self._action = action

    def start(self) -> None:
        self.actions.append(self._action)

    def end(self) -> None:
        self.actions.remove(self._action)


def tick(state: object) -> float:
    """Make a tick of all timers: a condition that is false."""
    for action in Ticks.actions:
        action()
    return 0.0


@pytest.fixture(autouse=True)
def ticks(monkeypatch: pytest.MonkeyPatch) -> None:
    """Replace the timer of runs, so that no run is copied because it is slow."""
    monkeypatch.setattr("motionlang.debug.replay.Ticks", Ticks)


def with_copies(text: str = CALLS, **how: object) -> tuple[Debugger, Checkpoints, list[int]]:
    """Return a session at its first statement, its copies and the keys of ended ones."""
    dropped: list[int] = []
    copies = Checkpoints(lambda *_: None, dropped.extend, lambda: None, lambda *_: None)
    debugger = mint(text, **how)  # type: ignore[arg-type]
    debugger.observe(copies, lambda fraction: None)
    debugger.start()
    return debugger, copies, dropped


def handed_over(command: Callable[[], object]) -> tuple[object, ...] | None:
    """Return the key of the copy that continues, and its work; None if there is none."""
    try:
        command()
    except HandOver as handover:
        return handover.key, *handover.then
    return None


@cases(
    "command, work",
    [
        (lambda debugger: debugger.step_back(), (2, "arrive", 8, "step", "")),
        (lambda debugger: go_to_number(debugger, 7), (2, "arrive", 7, "goto", "")),
        (lambda debugger: go_to_number(debugger, 6), (2, "arrive", 6, "goto", "")),
        (lambda debugger: go_to_number(debugger, 5), (1, "arrive", 5, "goto", "")),
        (lambda debugger: go_to_number(debugger, 1), None),
        (lambda debugger: debugger.go_back_to_line(5), (2, "arrive", 7, "goto", "")),
        (
            lambda debugger: debugger.last_change(("module", "total")),
            (2, "arrive", 7, "change", "this statement changes total"),
        ),
        (lambda debugger: debugger.reverse(), None),
        (lambda debugger: debugger.go_to_time(6e-5), (2, "time", 6e-5)),
        (lambda debugger: debugger.go_to_time(5e-5), (1, "time", 5e-5)),
        (lambda debugger: debugger.go_to_time(1e-5), None),
    ],
)  # fmt: skip
def test_the_last_copy_before_a_statement_or_a_time_continues(
    command: Callable[[Debugger], object], work: tuple[object, ...] | None
) -> None:
    """The stop is at statement 9, and copies wait at statements 2 and 6."""
    debugger, copies, _ = with_copies()
    go_to_number(debugger, 9)
    copies.known = list(KNOWN)
    assert handed_over(lambda: command(debugger)) == work
    debugger.abandon()


def test_hits_and_watched_values_are_found_by_running_again() -> None:
    """A copy does not have them."""
    debugger, copies, _ = with_copies()
    copies.known = list(KNOWN)
    debugger.set_breakpoints([at(debugger, 4)])
    assert handed_over(lambda: go_to_number(debugger, 7)) == (2, "arrive", 7, "goto", "")
    debugger.watched = [Watched(("module", "total"))]
    assert handed_over(lambda: go_to_number(debugger, 7)) is None
    assert handed_over(lambda: debugger.go_to_time(6e-5)) is None
    debugger.watched = []
    debugger.set_breakpoints([at(debugger, 4, hits="3"), at(debugger, 5)])
    assert handed_over(lambda: go_to_number(debugger, 7)) is None
    assert handed_over(lambda: debugger.go_to_time(6e-5)) is None
    debugger.abandon()


def test_a_step_back_beyond_what_is_remembered_continues_in_the_copy_before() -> None:
    """The run has stopped at statement 11 alone, so the one before is not known."""
    debugger, copies, _ = with_copies()
    debugger.set_breakpoints([at(debugger, 11)])
    debugger.go_on()
    copies.known = list(KNOWN)
    assert handed_over(debugger.step_back) == (2, "back", 11, TASK, 1)
    copies.known = []
    stop = debugger.step_back()
    assert stop is not None
    assert (stop.number, stop.reason) == (8, "step")
    debugger.abandon()


@cases(
    "begin, work, number, reason, text",
    [
        (3, ("arrive", 7, "pause", "x"), 7, "pause", "x"),
        (7, ("arrive", 7, "goto", ""), 7, "goto", ""),
        (3, ("time", 5e-5), 5, "goto", ""),
        (3, ("time", 5.5e-5), 7, "goto", ""),
        (3, ("time", 1.0), 11, "goto", ""),
        (6, ("back", 9, TASK, 1), 8, "step", ""),
        (6, ("back", 8, TASK, 1), 5, "step", ""),
        (6, ("back", 8, TASK, 2), 7, "step", ""),
        (6, ("back", 8, "Other", 1), 7, "step", ""),
        (1, ("back", 1, TASK, 1), 1, "step", ""),
    ],
)
def test_a_copy_does_the_work_that_remains(
    begin: int, work: tuple[Any, ...], number: int, reason: str, text: str
) -> None:
    """The copy waits at statement `begin`."""
    debugger = mint(CALLS)
    debugger.start()
    go_to_number(debugger, begin)
    stop = debugger.resume(work)
    assert stop is not None
    assert stop is debugger.stop
    assert (stop.number, stop.reason, stop.text) == (number, reason, text)
    # The statements before the stop are known, as after a run without copies.
    back = debugger.step_back()
    assert back is not None
    assert back.number == {1: 1, 5: 2, 7: 6, 8: 5, 11: 8}[number]
    debugger.abandon()


def test_a_copy_that_does_not_remember_enough_runs_again() -> None:
    """It stopped at statement 11 alone; the last one in at most one call was 8."""
    debugger, copies, _ = with_copies()
    debugger.set_breakpoints([at(debugger, 11)])
    debugger.go_on()
    copies.known = [*KNOWN, (10, 1e-4, 3), (11, 1.3e-4, 4)]
    assert handed_over(lambda: debugger.resume(("back", 11, TASK, 1))) == (3, "back", 11, TASK, 1)
    copies.known = []
    stop = debugger.resume(("back", 11, TASK, 1))
    assert stop is not None
    assert (stop.number, stop.reason) == (8, "step")
    debugger.abandon()


def test_a_copy_that_is_revived_has_the_state_of_the_session() -> None:
    shown: list[str] = []
    messages: list[str] = []
    debugger, copies, _ = with_copies("Print 5\n" + CALLS, show=shown.append, log_message=messages.append)
    debugger.set_breakpoints([at(debugger, 6, message="{n}"), at(debugger, 10)])
    for _ in range(2):
        debugger.go_on()
    debugger.assign(("module", "total"), 100)
    copies.known, copies.last_key = list(KNOWN), 7
    state = debugger.state_for_copy()
    assert (shown, messages) == (["5\n"], ["1"])
    assert {name: each for name, each in state.items() if name != "journal"} == {
        "shown": 2, "logged": 5, "copies": (KNOWN, 7),
    }  # fmt: skip
    other, others, _ = with_copies("Print 5\n" + CALLS, show=shown.append, log_message=messages.append)
    other.abandon()
    other.revive(pickle.loads(pickle.dumps(state)))
    again = other.state_for_copy()
    assert (others.known, others.last_key, again["shown"], again["logged"]) == (KNOWN, 7, 2, 5)
    (change,) = other.journal.changes
    assert (change.statement, other.journal.answers) == (6, [])
    with pytest.raises(NotStopped):
        other.state()
    debugger.abandon()


def test_a_copy_makes_another_one_before_it_continues(monkeypatch: pytest.MonkeyPatch) -> None:
    """This process is the copy, then the copy of the copy, and then it continues.

    Each gets its state by the channel that the front has of it.
    """
    fronts: list[socket.socket] = []
    make, forks, stored, revived = socket.socketpair, iter([0, 0, 1]), list[int](), list[bytes]()

    def pair() -> tuple[socket.socket, socket.socket]:
        near, far = make()
        fronts.append(near.dup())
        return near, far

    def fork() -> int:
        result = next(forks)
        if result == 0:
            send(fronts[-1], b"state %d" % len(fronts))
        return result

    def revive(channel: socket.socket, state: bytes) -> None:
        send(fronts[1], b"more")
        revived.extend([state, receive(channel) or b""])
        channel.close()

    monkeypatch.setattr(socket, "socketpair", pair)
    monkeypatch.setattr(checkpoints, "_fork", fork)
    left: list[bool] = []
    copies = Checkpoints(
        lambda key, channel: stored.append(key), lambda keys: None, lambda: left.append(True), revive
    )
    copies.last_key = 4
    assert copies.take(7, 1.0) is True
    assert (stored, revived, left, copies.known) == ([5], [b"state 2", b"more"], [True], [])
    for each in fronts:
        each.close()


def test_a_copy_ends_with_the_channel_of_its_front(monkeypatch: pytest.MonkeyPatch) -> None:
    """The process would end with status 0."""

    def leave(status: int) -> None:
        raise SystemExit(status)

    near, far = socket.socketpair()
    monkeypatch.setattr(socket, "socketpair", lambda: (near, far))
    monkeypatch.setattr(checkpoints, "_fork", lambda: 0)
    monkeypatch.setattr(os, "_exit", leave)
    copies = Checkpoints(lambda *_: None, lambda keys: None, lambda: None, lambda *_: None)
    with far, pytest.raises(SystemExit) as caught:
        copies.take(7, 1.0)
    assert caught.value.code == 0


# ------------------------------------------------------------------------------------------- copies that end


def test_a_change_ends_the_copies_from_its_statement_on() -> None:
    debugger, copies, dropped = with_copies()
    go_to_number(debugger, 6)
    for change in (
        lambda: debugger.assign(("module", "total"), 5),
        lambda: debugger.enter(entries({}, inputs="3=1")),
    ):
        copies.known = [*KNOWN, (9, 9e-5, 3)]
        change()
        assert (copies.known, dropped) == (KNOWN[:1], [2, 3])
        dropped.clear()
    debugger.abandon()


def test_a_restart_ends_all_copies() -> None:
    debugger, copies, dropped = with_copies()
    copies.known = [(0, 0.0, 1), (1, 0.0, 2)]
    debugger.restart(debugger.source)
    assert (copies.known, dropped) == ([], [1, 2])
    debugger.abandon()


# ------------------------------------------------------------------------------------------------------ ticks


def ticking() -> tuple[Debugger, list[tuple[int, float]], list[float]]:
    """Return a session with a tick at each hit of line 5, its copies and progress."""
    taken: list[tuple[int, float]] = []
    fractions: list[float] = []

    class Taken(Checkpoints):
        def take(self, number: int, time: float) -> bool:
            taken.append((number, time))
            return False

    debugger = mint(CALLS.replace("To 3", "To 5"))
    debugger.observe(
        Taken(lambda *_: None, lambda keys: None, lambda: None, lambda *_: None), fractions.append
    )
    place = at(debugger, 5)
    place.condition = tick
    debugger.set_breakpoints([place])
    return debugger, taken, fractions


def test_a_run_is_copied_from_its_third_tick_on() -> None:
    """Line 5 is at statements 4, 7, 10, 13 and 16, each 40 µs after the last.

    A run forward reports no progress.
    """
    debugger, taken, fractions = ticking()
    assert debugger.start(False) is None
    assert (SLOW, [number for number, _ in taken]) == (3, [10, 13, 16])
    assert [time for _, time in taken] == pytest.approx([1e-4, 1.4e-4, 1.8e-4])
    assert fractions == []


def test_a_search_reports_its_progress_and_is_not_copied() -> None:
    """It runs up to the end, which counts as statement 18."""
    debugger, taken, fractions = ticking()
    debugger.start(False)
    taken.clear()
    stop = debugger.reverse()
    assert stop is not None
    assert (stop.number, taken, fractions) == (1, [], [10 / 18, 13 / 18, 16 / 18])
    debugger.go_on()
    assert len(fractions) == 3  # a run forward reports none


def test_a_replay_reports_its_progress_and_is_copied() -> None:
    """Hits that are counted are compared in a replay, too: up to statement 14."""
    debugger, taken, fractions = ticking()
    debugger.start()
    (place,) = debugger.breakpoints
    place.is_counted = True
    go_to_number(debugger, 14)
    assert [number for number, _ in taken] == [10, 13]
    assert fractions == [10 / 14, 13 / 14]
    debugger.go_on()
    assert len(fractions) == 2
    debugger.start()
    go_to_number(debugger, 11)
    fractions.clear()
    debugger.resume(("arrive", 14, "goto", ""))
    debugger.go_on()
    assert fractions == []
    debugger.abandon()
