"""The debugger on programs that wait without an end: limited work.

Work is the number of events that the clocks of all runs of the debugger have fired.
"""

from __future__ import annotations

from collections.abc import Callable

import pytest

from motionlang.controller.clock import Clock, WatchedClock
from motionlang.debug import patience, replay
from motionlang.debug.breakpoints import Breakpoint
from motionlang.debug.debugger import Debugger
from motionlang.debug.moments import search
from motionlang.execution import dialect
from motionlang.source import Source

# A spline of 0.3 s that begins again when it ends, and an input that never rises. 1000 s have thousands of splines.
ENDLESS = """\
Dim path(4) As Float = 3, 5, -5, 8
SPLINETABLE(0, path, NULL, NULL) : SPLINETIME(0) = 100
SPLINE(0) = 4
GO(0)
OUTX(1) = 1
PAUSE INX(0)
OUTX(2) = 1
"""
END = 1000.0
FEW = 60


@pytest.fixture
def fired(monkeypatch: pytest.MonkeyPatch) -> Callable[[], int]:
    """Return how many events have fired, in all runs.

    Commands wait for few advances of the clock.
    """
    clocks: list[Clock] = []
    make = Clock.__init__

    def made(self: Clock) -> None:
        make(self)
        clocks.append(self)

    monkeypatch.setattr(Clock, "__init__", made)
    monkeypatch.setattr(patience, "ADVANCES", FEW)
    return lambda: sum(each.fired for each in clocks)


def debug(text: str = ENDLESS, interrupted: Callable[[], bool] | None = None) -> Debugger:
    return Debugger(Source("a.mnt", text), dialect("mint"), {}, until=END, interrupted=interrupted)


def at_the_wait(interrupted: Callable[[], bool] | None = None) -> Debugger:
    debugger = debug(interrupted=interrupted)
    debugger.set_breakpoints([Breakpoint(debugger.offsets_at(6))])
    stop = debugger.start(stop_on_entry=False)
    assert stop is not None
    assert stop.line == 6
    debugger.set_breakpoints([])
    return debugger


# Each advance fires at most one event here, and a pause ends a run after `replay.PAUSE` advances.
LIMIT = FEW + replay.PAUSE + 10


def test_the_run_itself_fires_many_events(fired: Callable[[], int]) -> None:
    assert debug().start() is not None
    debugger = at_the_wait()
    assert debugger.go_on() is None
    assert fired() > 10 * LIMIT


def test_a_time_in_an_endless_wait_is_reached_without_the_rest_of_the_run(fired: Callable[[], int]) -> None:
    debugger = debug()
    debugger.start()
    stop = debugger.go_to_time(1.0)
    assert stop is not None
    assert (stop.line, stop.text) == (6, "")
    assert fired() < LIMIT
    debugger.abandon()


@pytest.mark.parametrize("step", [Debugger.step_in, Debugger.next, Debugger.step_out])
def test_a_step_stays_at_an_endless_wait(
    step: Callable[[Debugger], object], fired: Callable[[], int]
) -> None:
    debugger = at_the_wait()
    step(debugger)
    assert debugger.stop is not None
    assert (debugger.stop.line, debugger.stop.reason) == (6, "pause")
    assert "line 6 still waits at" in debugger.stop.text
    assert fired() < LIMIT
    debugger.abandon()


def test_a_step_stops_in_another_task_if_its_own_waits(fired: Callable[[], int]) -> None:
    """The other task executes two statements each 20 ms, and the program waits."""
    other = "Task Other\nLoop\nWAIT(20)\nOUTX(3) = Not OUTX(3)\nEnd Loop\nEnd Task\n"
    debugger = debug(ENDLESS.replace("PAUSE", "Run Other\nPAUSE") + "End\n" + other)
    debugger.set_breakpoints([Breakpoint(debugger.offsets_at(7))])
    debugger.start(stop_on_entry=False)
    debugger.set_breakpoints([])
    stop = debugger.next()
    assert stop is not None
    assert (stop.reason, stop.task.upper()) == ("pause", "OTHER")
    assert stop.time < END / 10
    debugger.abandon()


def test_a_sub_that_works_is_stepped_over_however_long_it_takes(fired: Callable[[], int]) -> None:
    """There are 100 waits of 1 s, with more than 3 splines in each.

    Together they are more advances than a command waits without a statement.
    """
    text = (
        ENDLESS.replace("PAUSE INX(0)", "Work")
        + "End\nSub Work\nDim i As Integer\nFor i = 1 To 100\nWAIT(1000)\nNext\nEnd Sub\n"
    )
    debugger = debug(text)
    debugger.set_breakpoints([Breakpoint(debugger.offsets_at(6))])
    debugger.start(stop_on_entry=False)
    stop = debugger.next()
    assert stop is not None
    assert (stop.line, stop.reason) == (7, "step")
    assert stop.time == pytest.approx(100.0, abs=0.01)
    debugger.abandon()


def test_a_moment_in_an_endless_wait_is_found_without_the_rest_of_the_run(
    fired: Callable[[], int], monkeypatch: pytest.MonkeyPatch
) -> None:
    """The second spline starts in the wait, where the log is searched."""
    monkeypatch.setattr("motionlang.debug.debugger.STRIDE", FEW)
    debugger = at_the_wait()
    debugger.searches = [search("axis 0 starts")]
    stop = debugger.go_on()
    assert stop is not None
    assert (stop.line, stop.reason) == (6, "moment")
    assert "axis 0 starts SPLINE at" in stop.text
    assert fired() < 3 * LIMIT
    debugger.abandon()


def test_a_time_is_reached_without_statements_after_it(fired: Callable[[], int]) -> None:
    """Statements begin each 0.5 s, and the search does not wait for many."""
    debugger = debug(ENDLESS.replace("PAUSE INX(0)", "Loop\nWAIT(500)\nEnd Loop"))
    debugger.start()
    stop = debugger.go_to_time(2.0)
    assert stop is not None
    assert 2.0 <= stop.time < 2.51
    assert fired() < LIMIT
    debugger.abandon()


def test_a_pause_ends_an_endless_wait(fired: Callable[[], int]) -> None:
    debugger = at_the_wait()
    debugger.pause()
    stop = debugger.go_on()
    assert stop is not None
    assert (stop.line, stop.reason) == (6, "pause")
    assert fired() < LIMIT
    debugger.abandon()


def test_ctrl_c_pauses_a_run(fired: Callable[[], int], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(replay, "POLL", 0.0)
    pressed: list[bool] = []
    debugger = debug(interrupted=lambda: bool(pressed))
    debugger.start()
    pressed.append(True)
    stop = debugger.go_on()
    assert stop is not None
    assert stop.reason == "pause"
    debugger.abandon()


def test_ctrl_c_in_an_endless_wait_stops_at_its_statement(
    fired: Callable[[], int], monkeypatch: pytest.MonkeyPatch
) -> None:
    """The key is pressed until the command ends, and ends only the first run."""
    monkeypatch.setattr(replay, "POLL", 0.0)
    pressed: list[bool] = []
    debugger = at_the_wait(lambda: bool(pressed))
    pressed.append(True)
    stop = debugger.go_on()
    assert stop is not None
    assert (stop.line, stop.reason) == (6, "pause")
    debugger.abandon()


def _times(clock: Clock) -> list[object]:
    """Advance a clock with seven events: one is cancelled, and one makes another."""
    found: list[object] = []

    def note(time: float) -> bool:
        found.append((time, clock.now))
        return time != 2.0  # this one wakes a task

    for time in (0.5, 1.0, 1.0, 2.0, 3.0):
        clock.at(time, lambda time=time: note(time))  # type: ignore[misc]
    clock.at(0.75, lambda: found.append("cancelled")).cancel()
    clock.at(0.8, lambda: clock.at(0.9, lambda: found.append("made")))
    clock.advance(1.5)
    found.append((clock.now, clock.horizon))
    found.append((clock.advance_to_news(2.5), clock.now, clock.horizon))
    found.append((clock.advance_to_news(2.5), clock.now, clock.fired, clock.made))
    return found


def test_a_watched_clock_is_an_ordinary_one_that_reports_its_times() -> None:
    seen: list[float] = []
    assert _times(WatchedClock(seen.append)) == _times(Clock())
    assert seen == [0.5, 0.8, 0.9, 1.0, 1.5, 2.0, 2.5]
