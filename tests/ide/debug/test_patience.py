"""The debugger on programs that wait without an end: limited work.

Work is the number of events that the clocks of all runs of the debugger have fired.
"""

from __future__ import annotations

from collections.abc import Callable

import pytest

from motionlang.ide.debug import debugger, replay
from motionlang.ide.debug.breakpoints import Breakpoint, Watched
from motionlang.ide.debug.debugger import Debugger
from motionlang.ide.debug.moments import search
from motionlang.kernel import Source, dialect
from motionlang.kernel.controller import Clock
from motionlang.kernel.controller.clock import WatchedClock
from tests.ide.debug.test_debugger import mint

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
    monkeypatch.setattr(debugger, "ADVANCES", FEW)
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
    monkeypatch.setattr("motionlang.ide.debug.debugger.STRIDE", FEW)
    debugger = at_the_wait()
    debugger.searches = [search("axis 0 starts", range(8))]
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
    assert (stop.line, stop.reason, stop.text) == (6, "pause", "")
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


# The clock advances to each second, when an input changes.
SECONDS: dict[str, object] = {
    "input": [{"channel": 5, "at": float(each), "value": each % 2} for each in range(1, 41)]
}
RISING: dict[str, object] = {"input": [*SECONDS["input"], {"channel": 0, "at": 13.5, "value": 1}]}  # type: ignore[misc]
WAITS = "WAIT({})\nOUTX(1) = 1\nPAUSE INX(0)\nOUTX(2) = 1\n"


@pytest.fixture
def brief(monkeypatch: pytest.MonkeyPatch) -> None:
    """Commands wait for 4 advances of the clock, and 2 more for another task."""
    monkeypatch.setattr(debugger, "ADVANCES", 4)
    monkeypatch.setattr(debugger, "PAUSE", 2)


@pytest.mark.usefixtures("brief")
@pytest.mark.parametrize(("waited", "until"), [(0, 8), (3, 11), (4, 13), (5, 15)])
def test_a_step_waits_as_long_as_the_run_before_it(waited: int, until: int) -> None:
    """The step sees advance n = `waited` + 1 first, and waits for max(n, 4) more.

    It ends at the third advance after these: n + max(n, 4) + 3.
    """
    debugger = mint(WAITS.format(1000 * waited), SECONDS, until=45.0)
    debugger.start()
    debugger.go_to_line(3)
    stop = debugger.next()
    assert stop is not None
    assert (stop.line, stop.reason, stop.text) == (3, "pause", f"line 3 still waits at {until} s")
    debugger.abandon()


@pytest.mark.usefixtures("brief")
@pytest.mark.parametrize(("time", "line"), [(0.5, 3), (5.0, 3), (5.5, 4), (13.5, 4), (14.0, 4)])
def test_a_time_waits_as_long_again_for_a_statement(time: float, line: int) -> None:
    """The wait ends at the 14th advance, at 13.5 s.

    For a time of 5 s, advance 5 is the first, and the 13th the last; for 5.5 s they are 6 and 15.
    """
    debugger = mint(WAITS.format(0), RISING, until=45.0)
    debugger.start()
    stop = debugger.go_to_time(time)
    assert stop is not None
    assert (stop.line, stop.reason, stop.text) == (line, "goto", "")
    debugger.abandon()


OTHER = """\
Run Other
OUTX(1) = 1
PAUSE INX(1)
End
Task Other
Loop
PAUSE INX(5) = 1
OUTX(3) = 1
PAUSE INX(5) = 0
End Loop
End Task
"""


@pytest.mark.usefixtures("brief")
def test_a_step_ends_at_the_first_statement_of_another_task_after_its_wait() -> None:
    """It waits up to advance 5; the other task goes on at 6 s, with two statements."""
    debugger = mint(OTHER, SECONDS, until=45.0)
    debugger.start()
    debugger.go_to_line(3)
    stop = debugger.next()
    assert stop is not None
    assert (stop.line, stop.task, stop.text) == (7, "other", "line 3 still waits at 6.00002 s")
    debugger.abandon()


@pytest.mark.usefixtures("brief")
def test_a_run_to_a_change_waits_without_an_end() -> None:
    debugger = mint(OTHER, RISING, until=45.0)
    debugger.start()
    debugger.go_to_line(2)
    debugger.watched = [Watched(("machine", "input 0"))]
    stop = debugger.go_on()
    assert stop is not None
    assert (stop.reason, stop.text) == ("change", "input 0 changes from 0 to 1 before line 7")
    assert stop.time == pytest.approx(14.00002)
    assert debugger.go_on() is None


@pytest.mark.usefixtures("brief")
def test_a_step_ends_while_motion_continues_after_the_program() -> None:
    """The clock advances to GO, at 30 µs, and to the ends of 7 splines of 0.3 s."""
    debugger = debug(ENDLESS.replace("PAUSE INX(0)\nOUTX(2) = 1\n", ""))
    debugger.start()
    debugger.go_to_line(5)
    stop = debugger.next()
    assert stop is not None
    text = "the program has ended, but motion continues at 2.10003 s"
    assert (stop.line, stop.reason, stop.text) == (5, "pause", text)
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
