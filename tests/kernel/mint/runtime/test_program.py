"""Checked programs: started twice, and with overrides."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.kernel import Machine, Scheduler, Source
from motionlang.kernel.mint import DIALECT

BALL_SCREW = """\
Const LENGTH = 200
vmax = 250
SCALE(0) = 1200
SPEED(0) = vmax
ACCEL(0) = 1250
DECEL(0) = 1250
MOVER(0) = LENGTH
GO(0)
PAUSE IDLE(0)
PRINT POS(0)
"""


def execute(text: str, machine: Machine) -> None:
    task = DIALECT.program(Source("a.mnt", text)).start(machine)
    scheduler = machine.scheduler = Scheduler(machine.controller, task)
    scheduler.run()


def test_a_program_runs() -> None:
    machine = Machine()
    execute(BALL_SCREW, machine)
    assert machine.terminal.lines == ["200.0000"]
    (move,) = machine.controller.log.moves
    assert (move.command, move.line) == ("MOVER", 7)
    assert move.start_time == pytest.approx(6 * 10e-6, abs=1e-15)


def test_the_sixth_statement_runs_after_the_time_of_five() -> None:
    machine = Machine()
    execute(BALL_SCREW.replace("vmax = 250\n", "").replace("vmax", "250"), machine)
    assert machine.controller.log.moves[0].start_time == 5e-05


def test_machine_file_sets_the_statement_time() -> None:
    machine = Machine({"controller.instruction_time": 1e-3})
    execute("For i = 1 To 10\n  x = x + 1\nNext\nPRINT TIME", machine)
    assert machine.terminal.lines == ["21"]
    assert machine.controller.clock.now == pytest.approx(22e-3)


def test_a_program_can_be_started_again() -> None:
    program = DIALECT.program(Source("a.mnt", "n = n + 1\nPRINT n"))
    for _ in range(2):
        machine = Machine()
        Scheduler(machine.controller, program.start(machine)).run()
        assert machine.terminal.lines == ["1.0000"]


@pytest.mark.parametrize(
    ("overrides", "printed"),
    [
        ({"t": "c", "n": 5.0}, "c5.0000 1"),
        ({"t": "c", "n": 1e300}, "c1.000000e+300 1"),
        ({"t": "c"}, "c2.0000 1"),
        ({"n": 5.0}, "a5.0000 1"),
        ({"t": "c", "n": 5.0, "k": 7}, "c5.0000 7"),
    ],
)
def test_a_program_that_is_made_for_values_of_some_names_takes_fewer_and_more(
    overrides: dict[str, float | str], printed: str
) -> None:
    source = Source("a.mnt", 'Dim t As String = "a", n As Float = 2\nConst k = 1\nPRINT t; n; " "; k')
    program = DIALECT.program(source).for_values({"t": "b", "n": 3.0})
    machine = Machine()
    machine.overrides = overrides
    Scheduler(machine.controller, program.start(machine)).run()
    assert machine.terminal.lines == [printed]


@pytest.mark.parametrize(
    ("overrides", "printed"),
    [({}, "20"), ({"parts": 5}, "70"), ({"FAULTS": 3}, "23"), ({"parts": 1, "faults": 1}, "31")],
)
def test_a_counter_that_only_counts_begins_with_another_value(
    overrides: dict[str, float], printed: str
) -> None:
    """An override replaces the initial value, not that of `parts = parts + 1`.

    The same applies to a variable that only a sub writes.
    """
    text = (
        "Dim parts As Integer, faults As Integer\nparts = parts + 1\nparts = parts + 1\nfault\n"
        "PRINT parts; faults\nparts = 0\nEnd\nSub fault\n  faults = faults + 0\nEnd Sub"
    )
    assert run(Source("a.mnt", text), overrides=overrides).output == [printed]


@pytest.mark.parametrize(
    ("overrides", "printed"),
    [
        ({"LENGTH": 50}, "50.0000"),
        ({"length": 50, "VMAX": 100}, "50.0000"),
        ({"vmax": 10}, "200.0000"),
    ],
)
def test_overrides_replace_the_values_of_the_program(overrides: dict[str, float], printed: str) -> None:
    for text in (BALL_SCREW, BALL_SCREW.replace("vmax = 250", "Dim vmax As Float = 250")):
        result = run(Source("a.mnt", text), overrides=overrides)
        assert result.output == [printed]
        assert result.controller.axes[0].speed == overrides.get("vmax", overrides.get("VMAX", 250)) * 1200


def test_a_value_for_a_name_that_is_not_there_is_a_mistake() -> None:
    result = run(Source("a.mnt", BALL_SCREW), overrides={"LENGHT": 50})
    (diagnostic,) = result.diagnostics
    assert diagnostic.code == "unknown-word"
    assert diagnostic.hint == "did you mean LENGTH?"


@pytest.mark.parametrize(
    ("model", "printed"), [("", "3.0000 0.5000"), ("ESB-2", "3.0000 0.5000"), ("mint4", "3 0.5")]
)
def test_a_controller_of_v4_drops_the_zeros_of_a_float(model: str, printed: str) -> None:
    settings: dict[str, object] = {"controller.model": model} if model else {}
    result = run(Source("a.mnt", 'n = 3\nPRINT n," ",n / 6'), machine=settings)
    assert result.output == [printed]


def test_wait_for_a_task_reports_the_wait_of_that_task() -> None:
    text = "Run A\nPAUSE TASKSTATUS(A) = 0\nTask A\n  PAUSE INX(3)\nEnd Task"
    result = run(Source("a.mnt", text))
    (diagnostic,) = result.diagnostics
    assert diagnostic.line == 2
    assert "[[input]]" in diagnostic.hint
    assert result.notes[1] == "line 4: a waits until INX(3)"
