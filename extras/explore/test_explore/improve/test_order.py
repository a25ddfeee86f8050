"""What no edit may change: each task does the same in the same order, and at the same place of a move."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.kernel import Run, Source, dialect
from motionlang_explore.improve import ExpectedWorld, Improvement, Improver
from motionlang_explore.improve.acts import acts_of
from motionlang_explore.improve.tasks import Tasks
from tests.cases import cases

LIMITS: dict[str, object] = {
    "run.until": 12.0,
    "axis.0.limits.speed": 400.0,
    "axis.0.limits.acceleration": 4000.0,
    "axis.1.limits.speed": 400.0,
    "axis.1.limits.acceleration": 4000.0,
}
LIMITS_MCCL: dict[str, object] = {
    "controller.model": "dcx-pci300",
    "run.until": 12.0,
    "axis.2.limits.speed": 40000.0,
    "axis.2.limits.acceleration": 400000.0,
}


def improved(name: str, text: str, **given: object) -> Improvement:
    language, limits = ("mccl", LIMITS_MCCL) if name.endswith(".mccl") else ("mint", LIMITS)
    return Improver(Source(name, text), dialect(language), ExpectedWorld("", {**limits, **given})).improved()


def edits(found: Improvement) -> dict[str, float]:
    return {each.literal.address: each.value for each in found.edits}


def places(result: Run, channel: int, axis: int, scale: float) -> list[float]:
    """Return where an axis is as an output is switched, in its units at power-up."""
    found = []
    for each in result.machine.log.outputs:
        if each.channel == channel:
            move = [m for m in result.machine.log.moves if m.axis == axis and m.start_time <= each.time][-1]
            assert move.profile is not None
            found.append(move.profile.position(each.time - move.start_time) / scale)
    return found


# The glue opens 100 ms and closes 500 ms after the flag: 5 to 45 mm of a move that takes 1.1 s. The way back is free.
GLUE = {
    "glue.mnt": """\
Dim flag As Integer
ACCEL(0) = 1000 : DECEL(0) = 1000
Run tkGlue
Loop
  SPEED(0) = 100
  MOVEA(0) = 100 : flag = 1 : GO(0) : Pause IDLE(0)
  SPEED(0) = 120
  MOVEA(0) = 0 : GO(0) : Pause IDLE(0)
  Wait(100)
End Loop
Task tkGlue
  Loop
    Pause flag = 1
    flag = 0
    Wait(100) : OUTX(1) = 1
    Wait(400) : OUTX(1) = 0
  End Loop
End Task
""",
    "glue.mccl": """\
1SA100000,1DS100000,2SA100000,2DS100000,1MN,2MN
MD1,AL1,AR50,2SV10000,2MA10000,2WS,2SV12000,2MA0,2WS,WA.1,MJ1
MD2,RA50,IE1,MJ3,NO,WA.001,MJ2
MD3,AL0,AR50,WA.1,CN9,WA.4,CF9,MJ2
GT2
MC1
""",
}


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "speeds"), [("glue.mnt", {"SPEED[0]@7": 400.0}), ("glue.mccl", {"2SV@2:2": 37800.0})]
)
def test_a_glue_task_opens_and_closes_at_the_same_place_of_the_move(
    name: str, speeds: dict[str, float]
) -> None:
    found = improved(name, GLUE[name])
    assert [line for line in found.refused if "output" in line and "of the move of line" in line]
    assert edits(found).items() >= speeds.items()
    was = run(Source(name, GLUE[name]), machine=LIMITS_MCCL if name.endswith("mccl") else LIMITS)
    given = (1, 0, 1.0) if name == "glue.mnt" else (9, 2, 100.0)
    before, after = places(was, *given), places(found.result, *given)
    assert after[: len(before)] == pytest.approx(before, abs=0.15)


# The arm leaves in 0.6 s, waits 0.3 s, and comes back in 0.6 s; the press is down from 0.65 to 0.85 s after the flag,
# kept apart from the arm by time alone.
PRESS = """\
Dim flag As Integer
SPEED(0) = 200 : ACCEL(0) = 2000 : DECEL(0) = 2000
Run tkPress
Loop
  flag = 1
  MOVEA(0) = 100 : GO(0) : Pause IDLE(0)
  Wait(300)
  MOVEA(0) = 0 : GO(0) : Pause IDLE(0)
End Loop
Task tkPress
  Loop
    Pause flag = 1
    flag = 0
    Wait(650) : {down}
    Wait(200) : {up}
  End Loop
End Task
"""
PRESS_MCCL = """\
1SA1000000,1DS1000000,1SV40000,2SA200000,2DS200000,2SV20000,1MN,2MN
MD1,AL1,AR50,2MA10000,2WS,WA.3,2MA0,2WS,MJ1
MD2,RA50,IE1,MJ3,NO,WA.001,MJ2
MD3,AL0,AR50,WA.65,CN9,WA.2,CF9,MJ2
GT2
MC1
"""


@pytest.mark.slow
@pytest.mark.parametrize(("name", "text"), [
    ("press.mnt", PRESS.format(down="OUTX(2) = 1", up="OUTX(2) = 0")),
    ("press.mnt", PRESS.format(down="MOVEA(1) = 2 : GO(1)", up="MOVEA(1) = 0 : GO(1)").replace(
        "Run", "SPEED(1) = 100 : ACCEL(1) = 4000 : DECEL(1) = 4000\nRun")),
    ("press.mccl", PRESS_MCCL),
])  # fmt: skip
def test_a_press_never_closes_on_an_arm_that_moves(name: str, text: str) -> None:
    found = improved(name, text)
    arm = 2 if name.endswith("mccl") else 0
    moves = [
        (each.start_time, each.start_time + each.duration) for each in found.result.moves if each.axis == arm
    ]
    downs = [each.time for each in found.result.machine.log.outputs if each.value]
    downs += [move.start_time for move in found.result.moves if move.axis == 1 and move.end]
    assert downs
    assert not [time for time in downs for begin, end in moves if begin < time < end]
    assert any(" while axis " in each for each in [*found.refused, *(e.bound for e in found.edits)])


# Axis 1 leaves as axis 0 has passed 150; axis 0 is at 190 of 200 as axis 1 arrives.
MEETING = """\
Dim n As Integer
{0}
{1}
For n = 1 To 4
  MOVEA(0) = 200 : GO(0)
  PAUSE POS(0) > 150
  MOVEA(1) = 60 : GO(1)
  PAUSE IDLE(0) And IDLE(1)
  MOVEA(0) = 0 : GO(0)
  MOVEA(1) = 0 : GO(1)
  PAUSE IDLE(0) And IDLE(1)
Next n
"""
RATES = (
    "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000",
    "SPEED(1) = 200 : ACCEL(1) = 2000 : DECEL(1) = 2000",
)
TIMES = (
    "PROFILEMODE(0) = 1 : SPEED(0) = 100 : ACCELTIME(0) = 200 : DECELTIME(0) = 200 : ACCELJERKTIME(0) = 50"
    " : DECELJERKTIME(0) = 50",
    "PROFILEMODE(1) = 1 : SPEED(1) = 200 : ACCELTIME(1) = 100 : DECELTIME(1) = 100 : ACCELJERKTIME(1) = 30"
    " : DECELJERKTIME(1) = 30",
)


def arrival(result: Run) -> float:
    """Return where axis 0 is as axis 1 first arrives."""
    first, other = (next(move for move in result.moves if move.axis == axis) for axis in (0, 1))
    move = next(each for each in result.machine.log.moves if each.axis == 0)
    assert move.profile is not None
    return move.profile.position(other.start_time + other.duration - first.start_time)


@cases("speeds, factor, scaled", [
    # 2000 k² is at most 4000.
    (RATES, 1.41, {"SPEED[1]@3": 282.0, "ACCEL[0]@2": 1988.1, "DECEL[1]@3": 3976.2}),
    (TIMES, 1.41, {"SPEED[1]@3": 282.0, "ACCELTIME[0]@2": 141.844, "ACCELJERKTIME[1]@3": 21.2766}),
])  # fmt: skip
def test_two_axes_meet_where_they_met(
    speeds: tuple[str, str], factor: float, scaled: dict[str, float]
) -> None:
    text = MEETING.format(*speeds)
    found = improved(
        "meet.mnt", text, **{"axis.0.limits.jerk": 1e6, "axis.1.limits.jerk": 1e6} if "JERK" in text else {}
    )
    assert edits(found)["SPEED[0]@2"] == 100 * factor
    assert edits(found).items() >= scaled.items()
    was = run(Source("meet.mnt", text), machine=LIMITS)
    assert arrival(found.result) == pytest.approx(arrival(was), abs=0.01)


def test_axes_whose_rates_are_no_numbers_stay_with_their_places() -> None:
    """With a lower rate of its own, that no number sets, axis 1 would be later on its way than axis 0."""
    text = MEETING.format(*RATES).replace("ACCEL(1) = 2000", "ACCEL(1) = 1000 + n * 0 + SPEED(0) * 10")
    assert edits(improved("meet.mnt", text)) == {}


def test_axes_stay_with_their_places_if_no_number_sets_the_jerk_of_a_stop() -> None:
    """Axis 1 has no DECELJERKTIME, so the jerk of its stop would not be scaled with that of axis 0."""
    text = MEETING.format(TIMES[0], TIMES[1].replace(" : DECELJERKTIME(1) = 30", ""))
    found = improved("meet.mnt", text, **{"axis.0.limits.jerk": 1e6, "axis.1.limits.jerk": 1e6})
    assert edits(found) == {}
    assert {each.reason for each in found.held} == {"its axis moves with axis 1, which keeps its own"}


@cases("lamp", [
    "TIMEREVENT = 400\n{}Event TIMER\n  lamp = 1 - lamp : OUTX(5) = lamp\nEnd Event\n",
    "Run tkLamp\n{}Task tkLamp\n  Loop\n    OUTX(5) = 1 : Wait(330)\n    OUTX(5) = 0 : Wait(330)\n"
    "  End Loop\nEnd Task\n",
    "Run tkHeat\n{}Task tkHeat\n  Loop\n    If ADC(0) < 50 Then OUTX(5) = 1 Else OUTX(5) = 0\n    Wait(70)\n"
    "    COMMS(3) = COMMS(3) + 1 : Print \"heat\"\n  End Loop\nEnd Task\n",
])  # fmt: skip
def test_a_lamp_a_heartbeat_and_a_thermostat_refuse_nothing(lamp: str) -> None:
    """A stroke of 50 at 100 takes 0.6 s; at 400 and 4000 it takes 0.224 s."""
    work = (
        "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\nFor n = 1 To 5\n  OUTX(1) = 1\n"
        "  MOVER(0) = 50 : GO(0) : Pause IDLE(0)\n  OUTX(1) = 0\n  Wait(200)\nNext\nEnd\n"
    )
    text = "Dim n As Integer, lamp As Integer\n" + lamp.format(work)
    found = improved("lamp.mnt", text, analogue=[{"channel": 0, "value": 40, "at": 0.0}])
    assert found.after == pytest.approx(found.before - 0.6 + 0.225, abs=2e-3)


def test_a_program_that_reads_the_lamp_keeps_its_own_order() -> None:
    text = """\
Dim n As Integer
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
Run tkLamp
For n = 1 To 4
  MOVER(0) = 50 : GO(0) : Pause IDLE(0)
  If OUTX(5) Then Print "lamp"
Next
End
Task tkLamp
  Loop
    OUTX(5) = 1 : Wait(330)
    OUTX(5) = 0 : Wait(330)
  End Loop
End Task
"""
    found = improved("read.mnt", text)
    was = run(Source("read.mnt", text), machine=LIMITS)
    assert len(found.result.output) == len(was.output)
    assert any("of outputs, prints and moves" in each or "the order" in each for each in found.refused)


def test_the_end_of_a_shift_ends_the_comparison_and_not_the_search() -> None:
    """A button at 10 s ends both runs; the faster one has made more strokes by then."""
    text = """\
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
Loop
  OUTX(1) = 1
  MOVER(0) = 100 : GO(0) : Pause IDLE(0)
  OUTX(1) = 0
  Wait(500)
  If INX(1) Then Exit
End Loop
Print "shift over"
"""
    found = improved("shift.mnt", text, input=[{"channel": 1, "at": 10.0}])
    assert found.after < 0.9
    assert found.result.output == ["shift over"]


def test_a_homing_is_one_act_with_all_its_phases() -> None:
    text = "HOME(0) = 0 : PAUSE IDLE(0)\nOUTX(1) = 1\nHOME(1) = 0 : PAUSE IDLE(1)\nMOVEA(0) = 5 : GO(0)\n"
    ran = run(Source("a.mnt", text), machine={f"axis.{axis}.home_switch": [-30.0, -10.0] for axis in (0, 1)})
    phases = [each.axis for each in ran.moves if each.command == "HOME"]
    assert min(phases.count(0), phases.count(1)) > 1
    (acts,) = acts_of(ran, Tasks(ran, ())).values()
    assert [each.text for each in acts] == [
        "HOME of axis 0",
        "output 1 = 1",
        "HOME of axis 1",
        "MOVEA of axis 0",
    ]
