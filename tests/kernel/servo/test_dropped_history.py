"""A run with a motor whose older history is dropped, as `serve` does: nothing else differs, and memory is constant."""

from __future__ import annotations

import pytest

from motionlang.kernel import Controller, Machine, Run, Source, run
from motionlang.kernel.tracks import recall

MOTOR: dict[str, object] = {
    "axis.0.plant.load_inertia": 4e-5,
    "axis.0.plant.viscous": 2e-5,
    "axis.0.servo.proportional": 0.02,
    "axis.0.servo.integral": 2e-5,
    "axis.0.servo.derivative": 0.5,
}
SET = "SCALE(0) = 100 : SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\n"
# Gains, an open loop and the zero of the axis change.
CHANGES = """Dim n As Integer
For n = 1 To 40
  KPROP(0) = 2 + n Mod 3
  MOVER(0) = 5 + n Mod 7 : GO(0) : PAUSE IDLE(0)
  If n Mod 5 = 0 Then
    TORQUE(0) = 10 : WAIT(20) : CANCEL(0)
  End If
  If n Mod 4 = 0 Then
    POS(0) = 3
  End If
  MOVEA(0) = 0 : GO(0) : PAUSE IDLE(0)
  Print POS(0), " ", FOLERROR(0)
Next
"""


def forgetful(text: str, retained: int, every: float, until: float) -> tuple[Run, list[str], list[int]]:
    """Return a run that drops history at intervals, what it prints, and the largest numbers of records at each."""
    shown, counts = list[str](), list[int]()

    def begun(machine: Machine) -> None:
        controller = machine.controller

        def forget() -> None:
            if retained:
                controller.forget_history(retained)
            counts.append(records(controller))
            controller.clock.at(controller.clock.now + every, forget)

        controller.clock.at(every, forget)

    source = Source("motor.mnt", SET + text)
    made = run(source, machine=MOTOR, until=until, begun=begun, show=shown.append)
    return made, shown, counts


def records(controller: Controller) -> int:
    """Return the number of records, profiles and changes of the loop that a controller has."""
    a = controller.axes[0]
    assert a.feedback is not None
    return sum(map(len, controller.log.streams())) + len(a.starts) + len(a.feedback.changes)


@pytest.mark.slow
@pytest.mark.parametrize("retained", [1, 3])
def test_a_motor_whose_history_is_dropped_moves_and_is_recalled_as_before(retained: int) -> None:
    whole, printed, counts = forgetful(CHANGES, 0, 0.37, 30.0)
    found, also_printed, fewer = forgetful(CHANGES, retained, 0.37, 30.0)
    assert (found.diagnostics, found.time, also_printed) == ([], whole.time, printed)
    assert fewer[-1] < counts[-1] / 2
    times = [found.time - 0.5 + 0.001 * k for k in range(500)]
    for quantity in ("actual", "following error", "output"):
        assert recall(found.controller, 0, quantity, times) == recall(whole.controller, 0, quantity, times)


@pytest.mark.slow
def test_a_day_with_a_motor_takes_no_more_memory_than_an_hour() -> None:
    """A move every five minutes; two to four records of a kind are retained, and ten times as many profiles."""
    text = "Loop\n  MOVER(0) = 1 : GO(0) : WAIT(300000)\n  MOVER(0) = -1 : GO(0) : WAIT(300000)\nEnd Loop\n"
    made, _, counts = forgetful(text, 2, 600.0, 86_400.0)
    moves = made.controller.log.moves
    assert (moves.past, len(moves)) == (288, 4)
    assert max(counts[-72:]) <= max(counts[:72])
    assert made.controller.log.budget.left > 1.9999e9
