"""The state at a stop."""

from __future__ import annotations

import pytest

from motionlang.ide.debug.breakpoints import Watched
from motionlang.ide.debug.debugger import Debugger
from motionlang.ide.debug.expressions import WrongExpression
from motionlang.ide.debug.moments import search
from motionlang.ide.debug.values import shown
from tests.cases import cases
from tests.ide.debug.test_debugger import CALLS, MOVE, at, line_of, mccl, mint, value
from tests.ide.debug.walks import go_to_number

# What an expression can read, in the order of the completions.
READINGS = [
    "position",
    "pos",
    "velocity",
    "vel",
    "target",
    "idle",
    "input",
    "in",
    "inx",
    "output",
    "out",
    "outx",
    "time",
]


def axis(debugger: Debugger, number: int = 0) -> dict[str, str]:
    """Return the state of an axis as text by name."""
    (found,) = [each for each in debugger.state().axes() if each.name == f"axis {number}"]
    assert isinstance(found.value, list)
    return {each.name: shown(each.value).strip('"') for each in found.value}


def test_an_axis_before_during_and_after_a_move() -> None:
    """A scale of 2 counts per unit; the move of 100 uu has a ramp of 0.1 s to 50 uu/s."""
    debugger = mint("SCALE(0) = 2\n" + MOVE + "DRIVEENABLE(0) = 0\nPrint 2\n")
    debugger.start()
    debugger.go_to_line(4)
    before = axis(debugger)
    assert (before["position"], before["velocity"], before["target"]) == ("0", "0", "0")
    assert (before["state"], before["faults"], before["buffer"]) == ("idle", "none", "()")
    debugger.searches = [search("velocity(0) >= 25", range(8))]
    debugger.go_on()
    found = axis(debugger)
    assert (found["state"], found["target"]) == ("idle", "100")
    assert [name.partition(" at ")[0] for name in found][-2:] == ["position", "velocity"]
    position, velocity = [text for name, text in found.items() if " at " in name]
    # Half of the ramp: 0.05 s at 500 uu/s².
    assert float(position) == pytest.approx(0.625, abs=1e-3)
    assert float(velocity) == pytest.approx(25.0, abs=1e-3)
    debugger.go_to_line(9)
    assert axis(debugger)["state"] == "off"
    debugger.abandon()


def test_an_axis_in_motion_and_one_without_an_end() -> None:
    debugger = mint("JOG(0) = 5\nWAIT = 100\nPrint 1\nWAIT = 1000\n")
    debugger.start()
    debugger.go_to_line(3)
    found = axis(debugger)
    assert (found["state"], found["target"]) == ("moving", "-")
    assert float(found["velocity"]) == pytest.approx(5.0)
    assert value(debugger, "velocity(0)") == pytest.approx(5.0)
    assert (value(debugger, "idle(0)"), value(debugger, "idle(1)")) == (0.0, 1.0)
    debugger.abandon()


def test_the_time_at_a_stop_and_at_the_end() -> None:
    debugger = mint("WAIT = 250\nPrint 1\n")
    debugger.start()
    debugger.go_to_line(2)
    assert value(debugger, "time") == pytest.approx(0.25, abs=1e-3)
    assert debugger.go_on() is None
    assert value(debugger, "time") == pytest.approx(0.25, abs=1e-3)


def test_the_lines_of_an_axis_in_order() -> None:
    """That of a motor is listed after its demand, the moment of the stop at the end."""
    debugger = mint(MOVE)
    debugger.searches = [search("output 2 rises", range(8))]
    debugger.start(False)
    assert list(axis(debugger)) == [
        "position", "velocity", "target", "state", "faults", "buffer", "position at 3e-05 s", "velocity at 3e-05 s",
    ]  # fmt: skip
    motor = mint(MOVE, {"axis.0.plant.inertia": 2e-5})
    motor.start()
    motor.go_to_line(6)
    assert list(axis(motor))[:3] == ["position", "measured position", "velocity"]


def test_an_axis_is_idle_if_it_is_at_rest_and_its_move_has_ended() -> None:
    """SUSPEND stops the axis; its move has not ended."""
    debugger = mint("SPEED(0) = 5\nMOVEA(0) = 10\nGO(0)\nWAIT(100)\nSUSPEND(0) = 1\nWAIT(1000)\nPrint 1\n")
    debugger.start()
    for line, idle, velocity in ((2, 1.0, 0.0), (5, 0.0, 5.0), (7, 0.0, 0.0)):
        debugger.go_to_line(line)
        assert (value(debugger, "idle(0)"), value(debugger, "velocity(0)")) == (idle, velocity)
    debugger.abandon()


TASKS = """\
Run Blink
WAIT(100)
OUTX(2) = 1
OUTX(2) = 0
End
Task Blink
  PAUSE INX(2)
End Task
Event IN1
  OUTX(1) = 1
  WAIT(50)
End Event
"""


def test_tasks_with_their_waits_and_calls() -> None:
    debugger = mint(TASKS, {"input": [{"channel": 1, "at": 0.02, "value": 1}]})
    debugger.start()

    def shown_tasks() -> list[tuple[str, str, bool, list[tuple[str, int]]]]:
        state = debugger.state()
        return [
            (
                each.name, each.why, each.is_handler,
                [(call.name, debugger.location_of(call.offset)[0]) for call in state.frames(each.task)],
            )
            for each in state.tasks()
        ]  # fmt: skip

    found = []
    for line in (2, 11, 3):
        debugger.go_to_line(line)
        found.append(shown_tasks())
    debugger.go_on()
    found.append(shown_tasks())
    blink = ("blink", "waits until INX(2)", False, [("Blink", 7)])
    assert found == [
        [("ParentTask", "", False, [("main", 2)]), ("blink", "", False, [("Blink", 7)])],
        [("in", "", True, [("IN1", 11)]), ("ParentTask", "waits for 0.1 s", False, [("main", 2)]), blink],
        [("ParentTask", "", False, [("main", 3)]), blink],
        [blink],
    ]


def test_channels_that_have_had_a_value() -> None:
    settings: dict[str, object] = {
        "input": [{"channel": 5, "at": 0.0, "value": 1}],
        "analogue": [{"channel": 1, "at": 0.0, "value": 25.0}],
    }
    debugger = mint("OUTX(2) = 1\nOUTX(2) = 0\nOUTX(3) = 1\nDAC(0) = 12.5\nPrint 1\n", settings)
    debugger.start()
    debugger.go_to_line(5)
    state = debugger.state()
    assert [(each.name, each.value) for each in state.inputs()] == [
        ("input 5", 1),
        ("analogue input 1", 25.0),
    ]
    found = [(each.name, each.value) for each in state.outputs()]
    assert found[:2] == [("output 2", 0), ("output 3", 1)]
    assert found[2][0].startswith("analogue output")
    for text, wanted in (("output(3)", 1.0), ("output(2)", 0.0), ("input(5)", 1.0), ("input(4)", 0.0)):
        assert value(debugger, text) == wanted


ARRAYS = """\
Dim a(3) As Integer, k As Integer, text As String
Dim late As Float
a(1) = 7 : a(3) = 9
k = 1
text = "x"
Print a(1)
"""


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("a(1) + a(3)", 16.0),
        ("A(k)", 7.0),
        ("a(k + 2) = 9", 1.0),
        ('text = "x"', 1.0),
        ("TEXT", "x"),
        ("time > 0", 1.0),
    ],
)
def test_an_expression_over_variables(text: str, wanted: object) -> None:
    debugger = mint(ARRAYS)
    debugger.start()
    debugger.go_to_line(6)
    assert value(debugger, text) == wanted


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("a(4)", "there is no a(4)"),
        ("a + 1", "a is an array"),
        ("k(1)", "there is no k(1)"),
        ("position(99)", "there is no axis 99"),
    ],
)
def test_an_expression_without_a_value(text: str, message: str) -> None:
    debugger = mint(ARRAYS + "GO(0)\nPrint 1\n")
    debugger.start()
    debugger.go_to_line(8)
    with pytest.raises(WrongExpression) as caught:
        debugger.state().evaluate(text)
    assert str(caught.value) == message


def test_names_for_completion() -> None:
    """Those of the call come before those of the program; none is listed twice."""
    debugger = mint(CALLS)
    debugger.start()
    debugger.go_to_line(5)
    names = debugger.state().names()
    assert names == ["n", "twice", "total", "i", *READINGS]
    debugger.step_in()


@pytest.mark.parametrize(
    ("path", "message"),
    [
        (("module", "nothing"), "there is no variable nothing here"),
        (("local5", "n"), "there is no variable n here"),
        (("local1", "n"), "there is no variable n here"),
        (("module", "a"), "a cannot be set; set one of its elements"),
    ],
)
def test_a_variable_that_cannot_be_assigned(path: tuple[str, ...], message: str) -> None:
    debugger = mint(ARRAYS)
    debugger.start()
    with pytest.raises(ValueError, match=message):
        debugger.assign(path, 1)
    assert debugger.assign(("module", "a", "a(2)"), 5).value == 5
    assert debugger.journal.changes[0].statement == 1


def test_lines_and_their_locations() -> None:
    """Lines 1, 6 and 7 of the program are declarations and an end."""
    debugger = mint(CALLS)
    assert debugger.lines == [4, 5, 8, 9, 11]
    assert [debugger.line_for(line) for line in (1, 5, 6, 11, 12)] == [4, 5, 8, 11, None]
    (offset,) = debugger.offsets_at(5)
    assert debugger.location_of(offset)[:2] == (5, 3)
    # The name behind it is no statement.
    assert debugger.location_of(offset + 8)[:2] == (5, 11)
    assert debugger.offsets_at(6) == ()


def test_several_statements_of_a_line_are_one_place() -> None:
    """A breakpoint stops at the first of them; a macro of MCCL begins at its own."""
    debugger = mint("Dim k As Integer\nk = 1 : k = 2 : k = 3\nPrint k\n")
    assert len(debugger.offsets_at(2)) == 1
    debugger.set_breakpoints([at(debugger, 2)])
    debugger.start(False)
    assert value(debugger, "k") == 0
    assert debugger.go_on() is None
    assert len(mccl("MD1,AA1,AR10\nMC1\n").offsets_at(1)) == 2


# ------------------------------------------------------------------------------------------------- long programs

LOOP = """\
Dim k As Integer, n As Integer
For k = 1 To 200
  n = n + 1
  If k = 150 Then OUTX(2) = 1
Next
Print n
"""


@pytest.fixture
def short(monkeypatch: pytest.MonkeyPatch) -> None:
    """Search the log every 16 statements, and take a snapshot 8 statements before a stop."""
    monkeypatch.setattr("motionlang.ide.debug.debugger.STRIDE", 16)
    monkeypatch.setattr("motionlang.ide.debug.replay.NEAR", 8)


@pytest.mark.usefixtures("short")
def test_a_moment_far_ahead_is_found_at_its_statement() -> None:
    debugger = mint(LOOP)
    debugger.searches = [search("output 2 rises", range(8))]
    stop = debugger.start(False)
    assert stop is not None
    assert value(debugger, "k") in (150, 151)
    here = stop.number
    assert debugger.go_on() is None
    back = debugger.reverse()
    assert back is not None
    assert (back.number, back.reason) == (here, "moment")
    debugger.watched = [Watched(("machine", "output 2"))]
    debugger.searches = []
    first = debugger.reverse()
    assert first is not None
    assert first.number in (1, here)


@pytest.mark.usefixtures("short")
def test_a_step_back_over_a_long_call() -> None:
    """A call of 200 iterations is longer than what is remembered before a stop."""
    text = "Dim n As Integer\nSub Count()\n  Dim k As Integer\n  For k = 1 To 200\n    n = n + 1\n  Next\nEnd Sub\n"
    debugger = mint(text + "n = 1000\nCount()\nPrint n\n")
    debugger.start()
    debugger.go_to_line(10)
    assert value(debugger, "n") == 1200
    for line, count in ((9, 1000), (8, 0)):
        stop = debugger.step_back()
        assert stop is not None
        assert (stop.line, value(debugger, "n")) == (line, count)
    stop = debugger.step_back()
    assert stop is not None
    assert (stop.line, stop.reason) == (8, "start")


@pytest.mark.usefixtures("short")
def test_the_statement_of_the_last_change() -> None:
    debugger = mint(LOOP)
    debugger.start()
    debugger.go_to_line(6)
    stop = debugger.last_change(("machine", "output 2"))
    assert stop is not None
    assert (stop.line, value(debugger, "k")) == (4, 150)
    stop = debugger.last_change(("module", "n"))
    assert stop is not None
    assert (stop.line, value(debugger, "n"), stop.text) == (3, 149, "this statement changes n")


def test_a_statement_by_its_number() -> None:
    debugger = mint(CALLS)
    debugger.start()
    for number, line in ((3, 4), (0, 8), (-5, 8), (2, 9)):
        go_to_number(debugger, number)
        assert line_of(debugger) == line


# -------------------------------------------------------------------------------------------------- checkpoints


def test_a_search_backwards_prints_no_log_point() -> None:
    messages: list[str] = []
    debugger = mint(CALLS, log_message=messages.append)
    debugger.start()
    debugger.go_to_line(11)
    debugger.set_breakpoints([at(debugger, 5, message="{n}"), at(debugger, 8)])
    stop = debugger.reverse()
    assert stop is not None
    assert (stop.line, messages) == (8, [])


def test_a_step_back_from_the_first_statement_of_a_task() -> None:
    """It goes to the statement before, of another task."""
    debugger = mint("Run Blink\nWAIT(100)\nEnd\nTask Blink\n  OUTX(1) = 1\nEnd Task\n")
    debugger.start()
    first = debugger.go_to_line(5)
    assert first is not None
    back = debugger.step_back()
    assert back is not None
    assert (back.number, back.task) == (first.number - 1, "ParentTask")
    debugger.abandon()


@cases(
    "name, found",
    [
        ("R10", ("R10", "register", 7)),
        ("r10", ("R10", "register", 7)),
        ("R0", ("R0", "accumulator", 5)),
        ("R255", ("R255", "register", 9)),
        ("R77", ("R77", "register", 0)),
        ("R256", None),
        ("R", None),
        ("Rx", None),
        ("X10", None),
        ("X", None),
        ("10", None),
    ],
)
def test_a_register_is_known_by_its_number(name: str, found: tuple[str, str, int] | None) -> None:
    """Registers 0 to 255; the first is the accumulator."""
    debugger = mccl("AL7,AR10,AL9,AR255,AL5\nTR10\n")
    debugger.start()
    debugger.go_to_line(2)
    each = debugger.state().named(name)
    assert (None if each is None else (each[1].name, each[1].type, each[1].value)) == found
    debugger.abandon()


@cases(
    "given, stored",
    [
        (-(2**31), -(2**31)),
        (-(2**31) - 1, None),
        (2**31 - 1, 2**31 - 1),
        (2**31, None),
        (7.0, 7),
        (2.5, 2.5),
        (3e9 + 0.5, 3e9 + 0.5),
        ("seven", None),
    ],
)
def test_a_register_takes_32_bits_or_a_fraction(given: object, stored: float | None) -> None:
    debugger = mccl("AL7,AR10\nTR10\n")
    debugger.start()
    debugger.go_to_line(2)
    if stored is None:
        with pytest.raises(ValueError, match=r"32 bits of a register|a register takes a number"):
            debugger.assign(("module", "R10"), given)
    else:
        found = debugger.assign(("module", "R10"), given).value
        assert (found, type(found)) == (stored, type(stored))
    debugger.abandon()


def test_names_of_the_innermost_call_alone() -> None:
    """`k` belongs to the caller, which the expression does not see."""
    subs = "Sub Outer()\n  Dim k As Integer\n  Inner(k)\nEnd Sub\nSub Inner(ByVal n As Integer)\n  Print n\nEnd Sub\n"
    debugger = mint(subs + "Outer()\n")
    debugger.start()
    debugger.go_to_line(6)
    assert debugger.state().names() == ["n", *READINGS]
    debugger.abandon()


def test_a_gosub_has_the_name_of_its_label_and_time_is_that_of_the_program() -> None:
    """TIME counts from its last assignment, 5 ms after the beginning, up to the statement of the stop."""
    debugger = mint(
        "Dim n As Integer\nWAIT(5)\nTIME = 0\nWAIT(2)\nGosub fill\nEnd\nfill:\nn = n + 1\nReturn\n"
    )
    debugger.start()
    debugger.go_to_line(8)
    state = debugger.state()
    (task,) = state.tasks()
    frames = [(each.name, debugger.location_of(each.offset)[0]) for each in state.frames(task.task)]
    assert frames == [("fill", 8), ("main", 5)]
    assert state.variable("TIME", []) == 2
