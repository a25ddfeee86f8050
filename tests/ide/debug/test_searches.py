"""The statement of each moment and each time, and when the log is searched.

`READS` has 12 statements of 10 µs: number n, in line n + 1, begins at (n - 1) · 10 µs. Times are in units of 10 µs.
"""

from __future__ import annotations

from math import ceil

import pytest

from motionlang.ide.debug import debugger as module
from motionlang.ide.debug.breakpoints import Watched
from motionlang.ide.debug.debugger import Debugger, Stop
from motionlang.ide.debug.moments import Occurrence, complaints, search
from motionlang.kernel import Machine
from tests.cases import cases
from tests.ide.debug.test_debugger import CALLS, at, mccl, mint
from tests.ide.debug.walks import go_to_number

COUNT = 12
READS = "Dim k As Integer\n" + "k = INX(5)\n" * COUNT
UNIT = 1e-5


@pytest.fixture(autouse=True)
def four(monkeypatch: pytest.MonkeyPatch) -> None:
    """Search the log every 4 statements."""
    monkeypatch.setattr(module, "STRIDE", 4)


def shown(stop: Stop | None) -> tuple[int, int, str, str, float | None] | None:
    """Return number, line, reason, text and moment of a stop."""
    if stop is None:
        return None
    return stop.number, stop.line, stop.reason, stop.text, stop.moment


def rising(time: float) -> Debugger:
    """Return a session of `READS` that stops when input 5 rises at a time."""
    debugger = mint(READS, {"input": [{"channel": 5, "at": time * UNIT, "value": 1}]})
    debugger.searches = [search("input 5 rises", range(8))]
    return debugger


MOMENTS = [0.0, 0.5, 1.0, 1.5, 2.0, 3.0, 3.5, 4.0, 5.5, 7.0, 8.0, 9.5, 10.0, 11.0]


@cases("time", MOMENTS)
def test_the_statement_after_a_moment(time: float) -> None:
    """Statement ceil(time) + 1 sees the input, and the next one is the stop.

    An input at time 0 is on before statement 1. After the last statement, it is the stop itself.
    """
    debugger = rising(time)
    number = 1 if time == 0.0 else min(ceil(time) + 2, COUNT)
    text = f"input 5 rises at {time * UNIT:.9g} s"
    earlier = time * UNIT if time < number - 1 else None
    assert shown(debugger.start(False)) == (number, number + 1, "moment", text, earlier)
    assert debugger.go_on() is None
    assert shown(debugger.reverse()) == (number, number + 1, "moment", text, None)
    assert shown(debugger.reverse()) == (1, 2, "start", "this is the first statement", None)


@cases("time", [*MOMENTS, 500.0])
def test_the_statement_at_a_time(time: float) -> None:
    """Statement ceil(time) + 1 is the first at or after the time.

    If there is none, the stop is the last one. It is the same from before, from after and from the end.
    """
    debugger = mint(READS)
    wanted = min(ceil(time) + 1, COUNT)
    for begin in (1, COUNT, None):
        debugger.start() if begin == 1 else debugger.go_on() if begin is None else go_to_number(
            debugger, begin
        )
        assert shown(debugger.go_to_time(time * UNIT)) == (wanted, wanted + 1, "goto", "", None)


@pytest.mark.parametrize("count", [10, 11, 12, 13])
def test_a_time_shortly_before_the_end(count: int) -> None:
    """The times of statements 1, 5, 9 and 13 are compared; 10 is the first at 90 µs."""
    debugger = mint("Dim k As Integer\n" + "k = INX(5)\n" * count)
    debugger.start()
    assert shown(debugger.go_to_time(8.5 * UNIT)) == (10, 11, "goto", "", None)
    debugger.abandon()


def test_the_first_of_the_last_statements_at_a_time() -> None:
    """Statement 11 is a call at 100 µs, and 12, in the sub, begins at the same time."""
    debugger = mint("Dim k As Integer\nSub Last\n  k = 1\nEnd Sub\n" + "k = INX(5)\n" * 10 + "Last\n")
    debugger.start()
    last = go_to_number(debugger, 12)
    assert last is not None
    assert shown(debugger.go_to_time(last.time)) == (11, 15, "goto", "", None)
    debugger.abandon()


def recorded(debugger: Debugger) -> list[tuple[float, float]]:
    """Return the intervals of the following searches of the log."""
    intervals: list[tuple[float, float]] = []

    def find(machine: Machine, after: float, until: float) -> list[Occurrence]:
        intervals.append((round(after / UNIT, 3), round(until / UNIT, 3)))
        return []

    debugger.searches = [find]
    return intervals


@pytest.mark.parametrize("watches", [False, True])
def test_the_log_is_searched_at_every_fourth_statement_and_at_the_end(watches: bool) -> None:
    """Statements 4, 8 and 12 are at 3, 7 and 11; the last one ends at 12."""
    debugger = mint(READS)
    debugger.watched = [Watched(("module", "k"))] if watches else []
    intervals = recorded(debugger)
    assert debugger.start(False) is None
    assert intervals == [(-1e5, 3.0), (-1e5, 7.0), (-1e5, 11.0), (-1e5, 12.0)]


def test_the_log_is_searched_from_the_stop_on() -> None:
    """A step searches up to its statement; then statements 6 and 10, and the end.

    A search from a stop on includes its own time, at which the statement may cause something.
    """
    debugger = mint(READS)
    debugger.start()
    intervals = recorded(debugger)
    debugger.step_in()
    debugger.go_on()
    assert intervals == [(0.0, 1.0), (1.0, 1.0), (1.0, 5.0), (1.0, 9.0), (1.0, 12.0)]


def test_what_the_statement_causes_at_which_it_stops_is_found() -> None:
    """The step comes to the statement that the second error has the time of."""
    debugger = mccl("9MR1\nAL1\n9MR2\nTR0\n")
    debugger.searches = [complaints]
    texts = []
    debugger.start()
    for go_on in (debugger.go_on, debugger.step_in, debugger.go_on):
        stop = go_on()
        assert stop is not None
        texts.append((stop.line, stop.text.partition(",")[2]))
    assert texts == [(2, " line 1 at 1e-05 s"), (3, ""), (4, " line 3 at 3e-05 s")]
    debugger.abandon()


def test_the_log_of_a_wait_is_searched_when_it_has_doubled() -> None:
    """An input changes at each second, and the clock advances to it.

    When it is about to advance for the 4th, 8th, 16th and 32nd time, 3, 7, 15 and 31 s have been reached.
    """
    inputs = [{"channel": 5, "at": float(each), "value": each % 2} for each in range(1, 41)]
    debugger = mint("OUTX(1) = 1\nPAUSE INX(0)\nOUTX(2) = 1\n", {"input": inputs}, until=45.0)
    intervals = recorded(debugger)
    assert debugger.start(False) is None
    assert [until for _, until in intervals] == [3e5, 7e5, 15e5, 31e5, 40e5]


BLINKS = READS.replace("k = INX(5)\n", "OUTX(2) = 1\nOUTX(2) = 0\nk = k + 1\n", 2)


def test_breakpoints_and_moments_forward_and_backward() -> None:
    """Statements 1, 2, 4 and 5 switch the output; the next one is the stop.

    The breakpoints are at statements 3 and 8. At statement 3, forward finds the moment and backward the breakpoint.
    """
    debugger = mint(BLINKS)
    debugger.searches = [search("output 2 changes", range(8))]
    debugger.set_breakpoints([at(debugger, 4), at(debugger, 9)])
    forward, backward = [], []
    stop = debugger.start(False)
    while stop is not None:
        forward.append((stop.number, stop.reason, stop.text))
        stop = debugger.go_on()
    assert forward == [
        (2, "moment", "output 2 rises at 0 s"),
        (3, "moment", "output 2 falls at 1e-05 s"),
        (5, "moment", "output 2 rises at 3e-05 s"),
        (6, "moment", "output 2 falls at 4e-05 s"),
        (8, "breakpoint", ""),
    ]
    while (stop := debugger.reverse()) is not None and stop.reason != "start":
        backward.append((stop.number, stop.reason, stop.text))
    assert backward == [*forward[:1], (3, "breakpoint", ""), *forward[2:]][::-1]


def test_a_line_counts_the_hits_on_the_path_to_it() -> None:
    """Line 5 is at statements 4, 7 and 10, and two of them are before statement 8."""
    debugger = mint(CALLS)
    debugger.start()
    debugger.set_breakpoints([at(debugger, 5, hits="3")])
    for number in (2, 5, 8):
        assert shown(debugger.go_to_line(9)) == (number, 9, "goto", "", None)
    stop = debugger.go_on()
    assert stop is not None
    assert (stop.number, stop.reason) == (10, "breakpoint")
    debugger.abandon()


def test_a_search_ends_before_the_statement_of_the_stop() -> None:
    """The stop is before `Print`, so nothing is shown."""
    output: list[str] = []
    debugger = mint(CALLS, show=output.append)
    debugger.start()
    debugger.go_to_line(11)
    debugger.go_back_to_line(5)
    debugger.go_to_line(11)
    debugger.last_change(("module", "total"))
    debugger.go_to_line(11)
    debugger.set_breakpoints([at(debugger, 4)])
    debugger.reverse()
    assert output == []
    debugger.abandon()


def test_log_points_print_once_at_a_statement_where_the_program_stops_again() -> None:
    """Line 4 prints at statement 3, again after a change before it."""
    messages: list[str] = []
    debugger = mint(CALLS, log_message=messages.append)
    debugger.set_breakpoints([at(debugger, 4, message="{n}"), at(debugger, 5)])
    debugger.start(False)
    go_to_number(debugger, 2)
    debugger.go_on()
    assert (shown(debugger.stop), messages) == ((4, 5, "breakpoint", "", None), ["1"])
    go_to_number(debugger, 2)
    debugger.assign(("module", "total"), 7)
    debugger.go_on()
    assert messages == ["1", "1"]
    debugger.abandon()


def test_errors_stop_the_program_and_warnings_do_not() -> None:
    """A move that no GO starts is a warning, at the end of the run."""
    debugger = mint("MOVEA(0) = 5\nPrint 1\n")
    debugger.stops_at_errors = True
    assert debugger.start(False) is None
    assert debugger.run is not None
    assert [each.severity for each in debugger.run.diagnostics] == ["warning"]
    debugger = mccl("AL1\n99MR5\nAL2\nTR0\n")
    debugger.stops_at_errors = True
    debugger.searches = [complaints]
    stop = debugger.start(False)
    assert stop is not None
    text = "there is no axis 99 (?-15: axis not assigned), line 2 at 2e-05 s"
    assert (stop.line, stop.reason, stop.text) == (3, "exception", text)
    assert debugger.go_on() is None  # it has been reported, and did not end the program


def test_a_step_back_to_the_first_statement_of_the_program() -> None:
    """The run has stopped first at statement 2, in the sub, and remembers no other."""
    debugger = mint("Dim n As Integer\nSub Work\n  n = 1\nEnd Sub\nWork\nn = 2\n")
    debugger.set_breakpoints([at(debugger, 3)])
    assert shown(debugger.start(False)) == (2, 3, "breakpoint", "", None)
    assert shown(debugger.step_out()) == (3, 6, "step", "", None)
    assert shown(debugger.step_back()) == (1, 5, "step", "", None)
    debugger.abandon()


def test_a_step_out_of_a_sub_goes_over_the_rest_of_it() -> None:
    """Statement 3 is the first of the sub, and 5 the next call in the loop."""
    debugger = mint(CALLS)
    debugger.start()
    go_to_number(debugger, 3)
    assert shown(debugger.step_out()) == (5, 9, "step", "", None)
    debugger.abandon()


def test_a_time_is_reached_without_the_statements_after_it() -> None:
    """INPUT is at 40 µs, after the stop at 20 µs."""
    asked: list[str] = []
    program = READS.replace("k = INX(5)\n" * 5, "k = INX(5)\n" * 4 + "INPUT k\n", 1)

    def ask(prompt: str) -> str:
        asked.append(prompt)
        return "7"

    debugger = mint(program, ask=ask)
    debugger.start()
    assert shown(debugger.go_to_time(2 * UNIT)) == (3, 4, "goto", "", None)
    assert asked == []
    debugger.abandon()


def test_a_step_back_from_the_second_statement_that_begins_a_task() -> None:
    """The program waits in its first statement, and the handler of an input begins."""
    settings: dict[str, object] = {"input": [{"channel": 1, "at": 0.02, "value": 1}]}
    debugger = mint("PAUSE INX(9)\nEnd\nEvent IN1\n  OUTX(1) = 1\nEnd Event\n", settings, until=0.1)
    debugger.start()
    assert shown(debugger.go_to_line(4)) == (2, 4, "goto", "", None)
    assert shown(debugger.step_back()) == (1, 1, "step", "", None)
    debugger.abandon()


def test_a_program_that_changes_an_axis_stops_without_its_values() -> None:
    """GO in line 4 begins the move, which changes target and buffer."""
    debugger = mint("SPEED(0) = 50\nMOVEA(0) = 100\nPrint 1\nGO(0)\nPrint 2\n")
    debugger.watched = [Watched(("machine", "axis 0"))]
    debugger.start()
    texts = []
    while (stop := debugger.go_on()) is not None:
        texts.append((stop.line, stop.text))
    assert texts == [(3, "axis 0 changes before line 3"), (5, "axis 0 changes before line 5")]
