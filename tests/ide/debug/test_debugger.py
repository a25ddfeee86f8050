"""The debugger: forward and backward, breakpoints, moments, manual changes."""

from __future__ import annotations

import threading

import pytest

from motionlang.ide.debug.breakpoints import Breakpoint, Watched
from motionlang.ide.debug.debugger import Debugger
from motionlang.ide.debug.moments import search
from motionlang.kernel import ProgramError, Source, dialect, entries, run

CALLS = """\
Dim total As Integer
Sub Add(ByVal n As Integer)
  Dim twice As Integer
  twice = 2 * n
  total = total + twice
End Sub
Dim i As Integer
For i = 1 To 3
  Add(i)
Next
Print total
"""
# To 100 at 50 uu/s with 500 uu/s²: 0.1 s of ramp over 2.5, 1.9 s at speed, 0.1 s of ramp.
MOVE = """\
SPEED(0) = 50 : ACCEL(0) = 500 : DECEL(0) = 500
OUTX(2) = 1
MOVEA(0) = 100
GO(0)
PAUSE IDLE(0)
Print POS(0)
"""
MACROS = """\
MD1,AA1,AR10
AL0
MC1
MC1
TR10
"""


def mint(text: str, settings: dict[str, object] | None = None, **how: object) -> Debugger:
    return Debugger(Source("a.mnt", text), dialect("mint"), settings, **how)  # type: ignore[arg-type]


def mccl(text: str) -> Debugger:
    return Debugger(Source("a.mcl", text), dialect("mccl"))


def line_of(debugger: Debugger) -> int:
    assert debugger.stop is not None
    return debugger.stop.line


def at(
    debugger: Debugger, line: int, condition: str = "", hits: str = "", message: str | None = None
) -> Breakpoint:
    return Breakpoint(debugger.offsets_at(line), condition, hits, message)


def value(debugger: Debugger, text: str) -> object:
    found = debugger.state().evaluate(text)
    return getattr(found, "value", found)


# ------------------------------------------------------------------------------------------------------- steps


def test_steps_go_into_a_sub_over_it_and_out_of_it() -> None:
    debugger = mint(CALLS)
    debugger.start()
    lines = [line_of(debugger)]
    for step in (debugger.step_in, debugger.step_in, debugger.step_in, debugger.step_out, debugger.next):
        step()
        lines.append(line_of(debugger))
    assert lines == [8, 9, 4, 5, 9, 9]
    assert value(debugger, "total") == 6


def test_steps_back_are_the_steps_forward_in_reverse() -> None:
    debugger = mint(CALLS)
    stops = [debugger.start()]
    while (stop := debugger.step_in()) is not None:
        stops.append(stop)
    numbers = [stop.number for stop in stops if stop is not None]
    assert numbers == list(range(1, 12))  # For, three times a call with two statements, Print
    back = []
    while (stop := debugger.step_back()) is not None and stop.reason != "start":
        back.append(stop.line)
    assert back == [11, 9, 9, 9, 8]  # over the calls


def test_back_before_the_first_statement_stays_there() -> None:
    debugger = mint(CALLS)
    debugger.start()
    for command in (debugger.step_back, debugger.reverse, debugger.step_back):
        stop = command()
        assert stop is not None
        assert (stop.number, stop.reason) == (1, "start")


def test_a_step_back_returns_from_the_end_to_the_last_statement() -> None:
    debugger = mint(CALLS)
    debugger.start()
    assert debugger.go_on() is None
    stop = debugger.step_back()
    assert stop is not None
    assert stop.line == 11


def test_macros_of_mccl_are_calls() -> None:
    debugger = mccl(MACROS)
    debugger.start()
    lines = []
    for _ in range(5):
        lines.append(line_of(debugger))
        debugger.next()
    assert lines == [1, 2, 3, 4, 5]
    assert value(debugger, "R10") == 2


# ------------------------------------------------------------------------------------------------- breakpoints


def test_hits_are_counted_from_the_start_of_the_program() -> None:
    debugger = mint(CALLS)
    debugger.start()
    debugger.next()
    debugger.next()
    debugger.set_breakpoints([at(debugger, 9, hits="3")])
    debugger.go_on()
    assert value(debugger, "i") == 3
    assert debugger.go_on() is None
    debugger.reverse()
    assert value(debugger, "i") == 3


def test_reverse_goes_to_the_last_hit_before_the_stop() -> None:
    debugger = mint(CALLS)
    debugger.start()
    debugger.go_on()
    debugger.set_breakpoints([at(debugger, 5)])
    found = []
    for _ in range(4):
        stop = debugger.reverse()
        assert stop is not None
        found.append((stop.line, stop.reason))
    assert found == [(5, "breakpoint")] * 3 + [(8, "start")]


@pytest.mark.parametrize("text", ["n = ", "= 1", "n ! 2", "(n", "x" * 2000, "1 2", "-" * 300 + "1"])
def test_a_condition_that_is_none_is_rejected(text: str) -> None:
    with pytest.raises(ValueError, match=r"\w"):
        Breakpoint((1,), text)


# ----------------------------------------------------------------------------------------------------- moments


def test_a_position_is_found_in_the_middle_of_a_wait() -> None:
    """20 uu are a ramp of 2.5 uu in 0.1 s and 17.5 uu at 50 uu/s: 0.45 s after GO."""
    debugger = mint(MOVE)
    debugger.searches = [search("position(0) > 20", range(8))]
    stop = debugger.start(False)
    assert stop is not None
    begin = 5e-5  # five statements before GO
    assert f"{0.45 + begin:.5f}" in stop.text
    assert stop.moment == pytest.approx(0.45 + begin, abs=1e-8)
    assert (stop.line, stop.reason) == (6, "moment")
    assert debugger.go_on() is None


def test_the_stop_is_the_first_statement_after_a_moment_of_several() -> None:
    """Position 20 is reached 0.45 s after the first GO, in its wait of 2.1 s."""
    debugger = mint(MOVE + "n = 1\nMOVEA(0) = 0\nGO(0)\nPAUSE IDLE(0)\nn = 2\n")
    debugger.searches = [search("position(0) > 20", range(8))]
    stop = debugger.start(False)
    assert stop is not None
    assert stop.line == 6
    assert stop.time == pytest.approx(2.10005, abs=1e-4)
    assert debugger.go_on() is None
    stop = debugger.reverse()
    assert stop is not None
    assert (stop.line, stop.reason) == (6, "moment")


def test_changes_of_a_variable_are_found_backward_in_reverse() -> None:
    """`total` becomes 2, 6 and 12: the stops are behind the three additions."""
    debugger = mint(CALLS)
    debugger.start()
    debugger.watched = [Watched(("module", "total"))]
    forward = []
    while (stop := debugger.go_on()) is not None:
        forward.append((stop.number, stop.text))
    assert [text.split(" before ")[0] for _, text in forward] == [
        "total changes from 0 to 2", "total changes from 2 to 6", "total changes from 6 to 12",
    ]  # fmt: skip
    backward = []
    while (stop := debugger.reverse()) is not None and stop.reason != "start":
        backward.append((stop.number, stop.text))
    assert backward == forward[::-1]


@pytest.mark.parametrize(
    ("name", "line"), [("output 2", 2), ("axis 0", 4), ("input 5", None), ("OUTPUT  2", 2)]
)
def test_the_last_change_of_a_channel_or_an_axis(name: str, line: int | None) -> None:
    """OUTX sets the output and GO begins the move; nothing has changed the input."""
    debugger = mint(MOVE)
    debugger.start()
    debugger.set_breakpoints([at(debugger, 5)])
    debugger.go_on()
    stop = debugger.last_change(debugger.state().path_of(name))
    assert stop is not None
    assert (stop.line if stop.reason == "change" else None) == line


def test_an_axis_changes_again_when_it_is_given_a_target() -> None:
    debugger = mint(MOVE + "MOVEA(0) = 50\nPrint 1\n")
    debugger.start()
    debugger.go_to_time(2.5)
    stop = debugger.last_change(debugger.state().path_of("axis 0"))
    assert stop is not None
    assert stop.line == 7


@pytest.mark.parametrize("name", ["nothing", "axis 99", "output", "axis -1", ""])
def test_what_has_no_changes_is_rejected(name: str) -> None:
    debugger = mint(MOVE)
    debugger.start()
    debugger.next()
    with pytest.raises(ValueError, match="there is no"):
        debugger.state().path_of(name)


def test_a_line_is_reached_forward_and_back() -> None:
    """The sub adds 2, 4 and 6 to the total in line 5."""
    debugger = mint(CALLS)
    debugger.start()
    totals = []
    for go in [debugger.go_to_line] * 3 + [debugger.go_back_to_line] * 2:
        stop = go(5)
        assert stop is not None
        totals.append((stop.line, value(debugger, "total")))
    assert totals == [(5, 0), (5, 2), (5, 6), (5, 2), (5, 0)]
    stop = debugger.go_back_to_line(5)
    assert stop is not None
    assert (stop.text, value(debugger, "total")) == ("line 5 has not begun before", 0)


def test_a_line_that_does_not_begin_again_changes_nothing() -> None:
    output: list[str] = []
    debugger = mint(CALLS, show=output.append)
    debugger.start()
    debugger.go_to_line(11)
    stop = debugger.go_to_line(9)
    assert stop is not None
    assert (stop.line, stop.text, output) == (11, "line 9 does not begin again", [])
    debugger.go_on()
    assert output == ["12\n"]


# ----------------------------------------------------------------------------------------------------- changes


def test_an_assignment_is_replayed_and_truncates_later_ones() -> None:
    output: list[str] = []
    debugger = mint(CALLS, show=output.append)
    debugger.start()
    debugger.assign(("module", "total"), 100)
    debugger.next()
    second = debugger.stop
    debugger.assign(("module", "total"), 500)
    debugger.step_back()
    assert value(debugger, "total") == 100
    debugger.assign(("module", "total"), 1000)
    assert [change.statement for change in debugger.journal.changes] == [1, 1]
    assert second is not None
    debugger.go_on()
    assert "".join(output) == "1012\n"  # 1000 + 2 + 4 + 6


@pytest.mark.parametrize(("name", "given"), [("total", "text"), ("total", 3e9), ("i", None)])
def test_a_value_that_a_type_does_not_allow_is_rejected(name: str, given: object) -> None:
    debugger = mint(CALLS)
    debugger.start()
    with pytest.raises(ValueError, match=r"\w"):
        debugger.assign(("module", name), given)


def test_an_input_given_at_a_stop_is_replayed() -> None:
    text = "Dim n As Integer\nn = 1\nPAUSE INX(3)\nn = 2\nPrint TIME\n"
    plain = run(Source("a.mnt", text), inputs="3=1@0.5")
    debugger = mint(text)
    debugger.start()
    debugger.enter(entries({}, inputs="3=1@0.5"))
    for _ in range(2):
        assert debugger.go_on() is None
        assert debugger.run is not None
        assert debugger.run.status == "ended"
        assert debugger.run.time == plain.time
        debugger.step_back()


def test_input_is_asked_for_once() -> None:
    prompts: list[str] = []

    def ask(prompt: str) -> str:
        prompts.append(prompt)
        return "7"

    output: list[str] = []
    debugger = mint('Dim n As Integer\nINPUT "turns", n\nPrint n * 2\n', ask=ask, show=output.append)
    debugger.start()
    debugger.go_on()
    debugger.step_back()
    debugger.reverse()
    debugger.go_on()
    assert len(prompts) == 1
    assert "".join(output).endswith("14\n")


def test_a_restart_keeps_time_and_journal() -> None:
    debugger = mint(MOVE)
    debugger.start()
    debugger.go_to_time(0.00004)
    stop = debugger.restart(Source("a.mnt", MOVE.replace("= 100", "= 40")))
    assert stop is not None
    assert stop.time == pytest.approx(0.00004)
    debugger.go_on()
    assert debugger.run is not None
    assert debugger.run.machine.terminal.lines == ["40.0000"]


def test_a_restart_makes_the_changes_of_the_journal_again() -> None:
    """The user sets 100 before the loop, which then adds 3, 6, 9 instead of 2, 4, 6."""
    output: list[str] = []
    debugger = mint(CALLS, show=output.append)
    debugger.start()
    debugger.assign(("module", "total"), 100)
    debugger.next()
    debugger.restart(Source("a.mnt", CALLS.replace("2 * n", "3 * n")))
    debugger.go_on()
    assert output == ["118\n"]


def test_a_restart_with_errors_leaves_everything_as_it_is() -> None:
    debugger = mint(CALLS)
    before = debugger.start()
    with pytest.raises(ProgramError):
        debugger.restart(Source("a.mnt", "Dim\n"))
    assert debugger.stop is before
    assert debugger.next() is not None


# ------------------------------------------------------------------------------------------------ everything else


def test_a_program_that_never_ends_can_be_paused_and_stepped_back() -> None:
    debugger = mint("Dim n As Integer\nLoop\n  n = n + 1\n  If n > 9 Then n = 0\nEnd Loop\n")
    debugger.start()
    threading.Timer(0.0, debugger.pause).start()
    stop = debugger.go_on()
    while stop is not None and stop.number < 100:
        threading.Timer(0.01, debugger.pause).start()
        stop = debugger.go_on()
    assert stop is not None
    assert stop.reason == "pause"
    back = debugger.step_back()
    assert back is not None
    assert back.number < stop.number
    debugger.abandon()


def test_an_axis_is_shown_at_the_time_of_the_stop() -> None:
    """GO is the sixth statement of 10 µs each; after the ramp the axis has 50 uu/s."""
    debugger = mint(MOVE.replace("PAUSE IDLE(0)", "While IDLE(0) = 0 : TIME = 0 : End While"))
    debugger.start()
    debugger.go_to_time(1.0)
    state = debugger.state()
    axis = {each.name: each.value for each in state.axes()[0].value}  # type: ignore[attr-defined]
    assert axis["position"] == pytest.approx(2.5 + 50 * (state.time - 0.1 - 5e-5), abs=1e-6)
    assert axis["velocity"] == pytest.approx(50.0)
    assert axis["target"] == pytest.approx(100.0)
    debugger.abandon()


def test_a_loaded_move_is_not_released_before_its_go() -> None:
    """GO has released the first two of three moves; the first has left the buffer."""
    debugger = mint("SPEED(0) = 50\nMOVEA(0) = 100\nMOVEA(0) = 0\nGO(0)\nMOVEA(0) = 7\nPRINT 1\n")
    debugger.start()
    debugger.go_to_line(6)
    (axis,) = [each for each in debugger.state().axes() if each.name == "axis 0"]
    assert isinstance(axis.value, list)
    (buffer,) = [each for each in axis.value if each.name == "buffer"]
    shown = [each.value for each in buffer.value]
    assert shown == ["MOVEA, line 3", "MOVEA, line 5, not released"]
