"""The speeds of a process stay: a homing, the glue, the feed of a drill, and what a comment names."""

from __future__ import annotations

from collections.abc import Mapping

import pytest

from motionlang.kernel import Source, dialect
from motionlang_explore.improve import ExpectedWorld, Improver
from motionlang_explore.improve.view import improvement_lines
from tests.cases import cases
from tests.cli.programs import Cell

LIMITS: dict[str, object] = {
    f"axis.{axis}.limits.{name}": value
    for axis in (0, 1)
    for name, value in (("speed", 400.0), ("acceleration", 4000.0))
}
MCCL: dict[str, object] = {"axis.1.limits.speed": 400.0, "axis.1.limits.acceleration": 4000.0}


def held(text: str, name: str = "a.mnt", given: Mapping[str, object] = {}) -> dict[str, str]:
    """Return the numbers that stay, with the reasons."""
    is_mint = name.endswith(".mnt")
    world = ExpectedWorld("", {"run.until": 30.0, **(LIMITS if is_mint else MCCL), **given})
    found = Improver(Source(name, text), dialect("mint" if is_mint else "mccl"), world).improved()
    assert not {each.literal.address for each in found.held} & {each.literal.address for each in found.edits}
    return {each.literal.address: each.reason for each in found.held}


RATES = "ACCEL(0) = 800 : DECEL(0) = 800 : ACCEL(1) = 800 : DECEL(1) = 800\n"


def test_the_feed_of_a_drill_while_the_coolant_is_on() -> None:
    """The coolant is on for nine tenths of the time."""
    text = f"""\
{RATES}Loop
  OUTX(2) = 1
  SPEED(0) = 6
  MOVEA(0) = 20 : GO(0) : Pause IDLE(0)
  OUTX(2) = 0
  SPEED(0) = 120
  MOVEA(0) = 0 : GO(0) : Pause IDLE(0)
End Loop
"""
    assert held(text) == {"SPEED[0]@4": "lower than 120 while output 2 is on"}


def test_the_name_of_the_output_is_that_of_the_program_or_of_a_comment() -> None:
    text = "{}{}OUTX(2) = 1\nSPEED(0) = 50\nMOVEA(0) = 90 : GO(0) : Pause IDLE(0)\n{}OUTX(2) = 0\n"
    text += "SPEED(0) = 90\nMOVEA(0) = 0 : GO(0) : Pause IDLE(0)\n"
    found = held(text.format("' OUT 1 lamp  2 glue gun\n", RATES, ""))
    assert found == {
        "SPEED[0]@4": "lower than 90 while glue gun (output 2) is on",
        "ACCEL[0]@2": "glue gun (output 2) is on for 1.863 s by it",
        "DECEL[0]@2": "glue gun (output 2) is on for 1.863 s by it",
    }
    named = text.replace("OUTX(2)", "opGlue").format("Define opGlue = OUTX(2)\n", RATES, "")
    assert held(named)["SPEED[0]@4"] == "lower than 90 while opGlue (output 2) is on"


def test_the_coolant_of_a_plate_is_on_for_all_of_its_holes() -> None:
    """The cycle is a hole; the coolant comes once a plate, which is often enough."""
    text = f"""\
Dim plate As Integer, hole As Integer
{RATES}For plate = 1 To 3
  OUTX(2) = 1
  For hole = 1 To 5
    SPEED(0) = 8
    MOVEA(0) = 20 : GO(0) : Pause IDLE(0)
    SPEED(0) = 120
    MOVEA(0) = 0 : GO(0) : Pause IDLE(0)
  Next
  OUTX(2) = 0
  Wait(500)
Next
"""
    assert held(text) == {"SPEED[0]@6": "lower than 120 while output 2 is on"}


@pytest.mark.slow
def test_a_run_lamp_and_a_heater_that_are_on_all_the_time_hold_nothing() -> None:
    text = f"""\
{RATES}OUTX(7) = 1
Run tkHeat
Loop
  SPEED(0) = 50
  MOVEA(0) = 90 : GO(0) : Pause IDLE(0)
  SPEED(0) = 90
  MOVEA(0) = 0 : GO(0) : Pause IDLE(0)
End Loop
Task tkHeat
  Loop
    OUTX(6) = 1 : Wait(500)
    OUTX(6) = 0 : Wait(100)
  End Loop
End Task
"""
    assert held(text) == {}


@pytest.mark.slow
def test_the_torch_of_a_task_that_follows_the_carriage_counts() -> None:
    text = f"""\
Dim weld As Integer
{RATES}Run tkTorch
Loop
  SPEED(0) = 35
  weld = 1 : Wait(100)
  MOVEA(0) = 90 : GO(0) : Pause IDLE(0)
  weld = 0
  SPEED(0) = 250
  MOVEA(0) = 0 : GO(0) : Pause IDLE(0)
End Loop
Task tkTorch
  Loop
    Pause weld = 1
    OUTX(4) = 1
    Pause weld = 0
    OUTX(4) = 0
  End Loop
End Task
"""
    rate = "output 4 is on for 2.715 s by it"
    speed = "lower than 250 while output 4 is on"
    assert held(text) == {"SPEED[0]@5": speed, "ACCEL[0]@2": rate, "DECEL[0]@2": rate}


@pytest.mark.slow
def test_the_speeds_of_a_homing_and_of_a_search() -> None:
    """The GO of line 2 runs until the edge of the switch, and the jog of line 2 until the input."""
    text = """\
MD1,1SA800,1DS800,1MN,MJ2
MD2,1VM,1DI1,1SV40,1GO,1FE0,1ST,1WS.1,1PM,1SV120,MJ3
MD3,1MA10,1WS.1,1MA0,1WS.1,MJ3
MC1
"""
    home: dict[str, object] = {"axis.1.home_switch": [-400.0, -12.0]}
    assert held(text, "home.mccl", home) == {"1SV@2:1": "the program stops the GO of line 2"}
    jog = f"{RATES}SPEED(0) = 90\nJOG(0) = 20 : Pause INX(3) : STOP(0) : Pause IDLE(0)\nLoop\n"
    jog += "  MOVER(0) = 9 : GO(0) : Pause IDLE(0)\nEnd Loop\n"
    given: dict[str, object] = {"input": [{"channel": 3, "at": 1.0}]}
    assert held(jog, given=given) == {"JOG[0]@3": "the program stops the JOG of line 3"}


def test_a_note_says_how_far_other_rates_shift_the_rest_of_a_jog(cell: Cell) -> None:
    """From 40 uu/s the jog stops in 40²/(2·800) = 1 uu, and with 4000 uu/s² in 0.2 uu."""
    text = f"SCALE(0) = 100 : {RATES}SPEED(0) = 90\nJOG(0) = 40 : Pause INX(3) : STOP(0) : Pause IDLE(0)\n"
    text += "POS(0) = 0\nFor k = 1 To 4\n"
    cell.write("jog.mnt", f"{text}  MOVER(0) = 9 : GO(0) : Pause IDLE(0)\nNext\n")
    cell.write(
        "jog.machine.toml",
        "run.until = 9\ninput = [{ channel = 3, axis = 0, between = [20.0, 30.0] }]\naxis.0.limits.speed = 200\n"
        "axis.0.limits.acceleration = 4000\n",
    )
    out = cell("improve", "jog.mnt").out
    assert "DECEL[0]@1     1   800  4000" in out
    assert "note: line 3: JOG of axis 0 comes to rest -0.8 uu from where it did" in out


@pytest.mark.slow
@cases("comment, line, reasons", [
    ("; index at 15 deg/s", "1SV15,1MA90,1WS,1SV120,1MA0,1WS", {"1SV@3:1": "the comment of line 2 names it"}),
    ("; up, over the glue wheel", "1SV15,1MA90,1WS,1SV120,1MA0,1WS", {"1SV@3:1": "the comment of line 2 says glue"}),
    ("; vorsichtig, das Blech ist dünn", "1SV15,1MA90,1WS,1SV120,1MA0,1WS",
     {"1SV@3:1": "the comment of line 2 says vorsichtig"}),
    ("; changed 15.3.1999, 15/3, V1.15", "1SV15,1MA90,1WS,1SV120,1MA0,1WS", {}),
    ("; OUTPUTS 9 ink, 10 clamp", "1SV15,1MA90,1WS,1SV120,1MA0,1WS", {}),
    ("; feeder, faster since 2004", "1SV15,1MA90,1WS,1SV120,1MA0,1WS", {}),
])  # fmt: skip
def test_a_comment_holds_what_it_names_and_the_lowest_speed_of_its_line(
    comment: str, line: str, reasons: dict[str, str]
) -> None:
    text = f"1SA800,1DS800,1MN\n{comment}\nMD3,{line},MJ3\nMC3\n"
    assert held(text, "a.mccl") == reasons


def test_a_comment_two_lines_above_counts_and_its_word_only_for_the_next_speed() -> None:
    text = f"{RATES}' slowly, the film wrinkles\nLoop\nSPEED(0) = 50\nMOVEA(0) = 90 : GO(0) : Pause IDLE(0)\n"
    text += "SPEED(0) = 40\nMOVEA(0) = 0 : GO(0) : Pause IDLE(0)\nEnd Loop\n"
    assert held(text) == {"SPEED[0]@4": "the comment of line 2 says slowly"}


@pytest.mark.slow
@cases("uses, reason", [
    ("OUTX(1) = 1 : Wait(v) : OUTX(1) = 0\n", "line 5 waits 0.12 s by it"),
    ("TIME = 0 : Pause TIME > 12000 / v\n", "line 5 waits 0.101 s by it"),
    ("PULSEOUTX(1) = v\n", "output 1 is on for 0.12 s by it"),
    ("DAC(1) = v / 4\n", "line 5 sets analogue output 1 by it"),
    # Between two places an output follows the motion alone.
    ("MOVER(0) = 90 : GO(0) : Pause POS(0) > 30 : OUTX(2) = 1 : Pause POS(0) > 60 : OUTX(2) = 0 : Pause IDLE(0)\n", ""),
    ("MOVER(0) = 5 : GO(0) : Wait(200) : Pause IDLE(0)\n", ""),
])  # fmt: skip
def test_a_constant_that_sets_something_else_stays(uses: str, reason: str) -> None:
    text = f"Const v = 120\n{RATES}SPEED(0) = v\nLoop\n{uses}MOVEA(0) = 0 : GO(0) : Pause IDLE(0)\n"
    found = held(f"{text}MOVEA(0) = 60 : GO(0) : Pause IDLE(0)\nEnd Loop\n", given={"run.until": 6.0})
    assert found == ({"v": reason} if reason else {})


# A stroke of 40 at 50 takes 40/50 + 50/500 = 0.9 s; the axis moves back with nothing on.
SHOT = """\
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
SPEED(1) = 50 : ACCEL(1) = 500 : DECEL(1) = 500
Loop
  MOVEA(0) = 200 : GO(0) : Pause IDLE(0)
  {on}
  MOVER(1) = 40 : GO(1) : Pause IDLE(1)
  {off}
  MOVEA(0) = 0 : GO(0) : Pause IDLE(0)
  {back}
End Loop
"""
BACK = "MOVER(1) = -40 : GO(1) : Pause IDLE(1)"


@pytest.mark.slow
@cases("on, off, back, reason", [
    ("OUTX(1) = 1", "OUTX(1) = 0", BACK, "output 1 is on for 0.9 s by it"),
    ("DAC(1) = 40", "DAC(1) = 0", BACK, "analogue output 1 is on for 0.9 s by it"),
    # The valve opens before the pump, and closes after it.
    ("OUTX(1) = 1 : Wait(300)", "Wait(100) : OUTX(1) = 0", BACK, "output 1 is on for 1.3 s by it"),
    # It is on during all moves of its axis.
    ("OUTX(1) = 1", "OUTX(1) = 0", "", ""),
    # A gripper carries a part, and the part is somewhere else then.
    ("OUTX(1) = 1", "MOVEA(0) = 100 : GO(0) : Pause IDLE(0) : OUTX(1) = 0", BACK, ""),
])  # fmt: skip
def test_an_output_that_is_on_while_an_axis_moves_is_on_as_long(
    on: str, off: str, back: str, reason: str
) -> None:
    found = held(SHOT.format(on=on, off=off, back=back))
    numbers = ("SPEED[1]@2", "ACCEL[1]@2", "DECEL[1]@2")
    assert found == (dict.fromkeys(numbers, reason) if reason else {})


def test_the_shot_of_a_pump_stays_as_long(cell: Cell) -> None:
    """The cycle is shorter by the way of axis 0 alone; the pump doses for 40/80 + 80/500 = 0.66 s."""
    text = SHOT.format(on="OUTX(2) = 1", off="OUTX(2) = 0", back=BACK)
    cell.write("pump.mnt", text.replace("SPEED(1) = 50", "SPEED(1) = 80"))
    limits = "[axis.{}.limits]\nspeed = 250\nacceleration = 2500\n"
    cell.write("pump.machine.toml", f"run.until = 20\n{limits.format(0)}{limits.format(1)}")
    out = cell("improve", "pump.mnt").out
    assert "  SPEED[1]@2 = 80   output 2 is on for 0.66 s by it\n" in out
    assert "\n-SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\n+SPEED(0) = 250 : ACCEL(0) = 2500 :" in out
    assert "\n-SPEED(1)" not in out


@pytest.mark.slow
def test_a_rate_is_no_speed_that_is_lower() -> None:
    """The short way of 2 with 1000 uu/s² reaches √2000 = 44.7 uu/s of 100, which is what is lower, and not 1000."""
    text = """\
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000 : ACCEL(1) = 1000 : DECEL(1) = 1000
Loop
  VECTORA(0, 1) = 100, 100 : GO(0) : Pause IDLE(0)
  Wait(1000)
  OUTX(1) = 1
  VECTORR(0, 1) = 2, 0 : GO(0) : Pause IDLE(0)
  Wait(1000)
  OUTX(1) = 0
  VECTORA(0, 1) = 0, 0 : GO(0) : Pause IDLE(0)
End Loop
"""
    reason = "44.7214 uu/s in line 6 is lower than 100 while output 1 is on"
    assert held(text) == {"ACCEL[0]@1": reason, "DECEL[0]@1": reason}


PAIR = "{}Loop\nSPEED(0) = 50\nMOVEA(0) = 90 : GO(0) : Pause IDLE(0)\n{}Pause IDLE(0) And IDLE(1)\nEnd Loop\n"


@pytest.mark.slow
@cases("moves, reasons", [
    # One GO.
    ("SPEED(0) = 50 ' glue\nSPEED(1) = 20\nMOVEA(0) = 0 : MOVER(1) = 90 : GO(0, 1)\n",
     {"SPEED[0]@5": "the comment of line 5 says glue",
      "SPEED[1]@6": "its axis moves with that of SPEED[0]@5, which stays"}),
    # Nothing scales the other axis, so it is as it is.
    ("SPEED(0) = 40\nMOVEA(0) = 0 : MOVER(1) = 9 : GO(0, 1)\n",
     {"SPEED[0]@5": "its axis moves with axis 1, which keeps its own"}),
    # The offset of a slave is in front of its master.
    ("FOLLOW(1) = 0.5\nSPEED(0) = 40\nMOVEA(0) = 0 : GO(0) : Wait(99)\nSPEED(1) = 9 ' weld\nOFFSET(1) = 5 : GO(1)\n"
     "Pause IDLE(0)\nCANCEL(1)\n",
     {"SPEED[0]@6": "its axis moves with that of SPEED[1]@8, which stays"}),
    # Two GOs, but both moves end at once: 90 at 40 takes 2.3 s, as do 23 at 10 and 0.0125 s of ramp.
    ("SPEED(1) = 10\nMOVER(1) = 23 : GO(1)\nWait(12)\nSPEED(0) = 40 ' saw\nMOVEA(0) = 0 : GO(0) : Pause IDLE(1)\n",
     {"SPEED[0]@8": "the comment of line 8 says saw",
      "SPEED[1]@5": "its axis moves with that of SPEED[0]@8, which stays"}),
    ("SPEED(0) = 40 ' weld\nMOVEA(0) = 0 : GO(0) : Pause IDLE(0)\nSPEED(1) = 9\nMOVER(1) = 9 : GO(1)\n",
     {"SPEED[0]@5": "the comment of line 5 says weld"}),
])  # fmt: skip
def test_axes_that_move_together_are_held_together(moves: str, reasons: dict[str, str]) -> None:
    found = held(PAIR.format(RATES, moves))
    speeds = {name: reason for name, reason in found.items() if name.startswith("SPEED")}
    assert speeds == reasons
    # Their rates stay with them.
    rates = {reason for name, reason in found.items() if name not in speeds}
    assert rates <= {reason for reason in reasons.values() if reason.startswith("its axis moves")} | {
        f"its axis moves with that of {name}, which stays" for name in reasons
    }


def test_axes_that_move_together_are_scaled_by_one_factor_of_time() -> None:
    """In 1/k of the time speeds are k times as large and rates k²: 240 k is at most 400, so k² is at most 2.78."""
    text = f"{RATES}Loop\nSPEED(0) = 200 : SPEED(1) = 240\nMOVER(0) = 200 : MOVER(1) = 240 : GO(0, 1)\nPause IDLE(1)\n"
    improver = Improver(
        Source("a.mnt", text + "End Loop\n"),
        dialect("mint"),
        ExpectedWorld("", {"run.until": 30.0, **LIMITS}),
    )
    found = improver.improved(most=1)
    values = {each.literal.address: each.value for each in found.edits}
    k = values["SPEED[0]@3"] / 200
    assert 1.66 < k <= 400 / 240
    assert values["SPEED[1]@3"] == pytest.approx(240 * k, rel=1e-5)
    assert [values[name] for name in values if "CEL" in name] == pytest.approx([800 * k * k] * 4, rel=1e-5)


DRILL = """\
SPEED(0) = 120 : ACCEL(0) = 800 : DECEL(0) = 800
Loop
  SPEED(0) = 6       ' drill
  MOVEA(0) = 5 : GO(0) : Pause IDLE(0)
  SPEED(0) = 120
  MOVEA(0) = 0 : GO(0) : Pause IDLE(0)
End Loop
"""


@pytest.fixture
def drill(cell: Cell) -> Cell:
    cell.write("drill.mnt", DRILL)
    cell.write(
        "drill.machine.toml", "run.until = 12\naxis.0.limits.speed = 120\naxis.0.limits.acceleration = 800\n"
    )
    return cell


@pytest.mark.slow
def test_also_tries_a_number_of_the_process(drill: Cell) -> None:
    out = drill("improve", "drill.mnt").out
    assert "held: --also SPEED[0]@3 tries one\n" in out
    assert "  SPEED[0]@3 = 6  the comment of line 3 says drill\n" in out
    for also in ("SPEED[0]@3", "SPEED(0)@3", "all"):
        out = drill("improve", "drill.mnt", "--also", also, "--patch", "faster.diff").out
        assert "held: --also" not in out
        assert "\n-  SPEED(0) = 6       ' drill\n" in out
    held_all_the_same = drill("improve", "drill.mnt", "--also", "all", "--hold", "SPEED[0]@3").out
    assert "  SPEED[0]@3 = 6  as you said\n" in held_all_the_same


def test_a_terminal_of_80_columns_shows_the_output_before_the_old_value() -> None:
    text = (
        "Const _axCarriage As Integer = 0\nDefine opClampOfTheTray = OUTX(3)\n"
        "SPEED(_axCarriage) = 50 : ACCEL(_axCarriage) = 500 : DECEL(_axCarriage) = 500\nopClampOfTheTray = 1\n"
        "MOVER(0) = 100 : GO(0) : PAUSE IDLE(0)\nWAIT(3000)\nopClampOfTheTray = 0\n"
        "MOVER(0) = -100 : GO(0) : PAUSE IDLE(0)\n"
    )
    world = ExpectedWorld("", {"axis.0.limits.speed": 200.0, "axis.0.limits.acceleration": 1000.0})
    found = Improver(Source("clamp.mnt", text), dialect("mint"), world).improved()
    for width, heads in (
        (120, "edit line from to gain bounded by while this is on"),
        (80, "edit to bounded by while this is on"),
    ):
        lines = improvement_lines(found, "clamp.mnt", width=width, colour=False)
        assert " ".join(lines[2].split()) == heads
        assert next(line for line in lines if line.startswith("SPEED[")).endswith("(output 3)")


def test_a_name_of_no_number_is_an_error(drill: Cell) -> None:
    """Without it a misspelt number would stay, or be changed, in silence."""
    for option in ("--also", "--hold"):
        ran = drill("improve", "drill.mnt", option, "SPED[0]@3")
        assert (ran.status, ran.out) == (1, "")
        assert ran.err == (
            "error[option]: the program has no number SPED[0]@3\n  hint: did you mean SPEED[0]@3?\n"
        )
