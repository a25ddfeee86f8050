"""A shorter cycle: within the limits, in the same order, with the fewest edits."""

from __future__ import annotations

import subprocess
from itertools import product
from math import sqrt
from pathlib import Path

import pytest

from motionlang import run
from motionlang.kernel import Source, dialect, dialect_for, settings_next_to
from motionlang_explore.improve import ExpectedWorld, Improver
from tests.cases import cases, one_in
from tests.cli.programs import Cell

ROOT = Path(__file__).parents[4]
# There and back: 2 (d/v + v/a) with equal rates.
SHUTTLE = """\
SPEED(0) = 100 : ACCEL(0) = 500 : DECEL(0) = 500
MOVEA(0) = 50 : GO(0) : PAUSE IDLE(0)
OUTX(1) = 1
MOVEA(0) = 0 : GO(0) : PAUSE IDLE(0)
PRINT "back after "; TIME; " ms"
"""
# The programs of the gallery that run without a machine file of the reader's, and the time that they are given.
PROGRAMS = sorted(path for path in (ROOT / "scripts").glob("m*/*") if path.suffix in (".mnt", ".mcl"))
PROGRAMS.remove(ROOT / "scripts" / "mint" / "recipe.mnt")  # an error ends it
UNTIL = 60.0
LIMITS = "[axis.0.limits]\nspeed = 200.0\nacceleration = 1000.0\n"


@pytest.fixture
def shuttle(cell: Cell) -> Cell:
    cell.write("shuttle.mnt", SHUTTLE)
    cell.write("shuttle.machine.toml", LIMITS)
    return cell


def improver(text: str, settings: dict[str, object], others: list[ExpectedWorld] = []) -> Improver:  # noqa: B006
    return Improver(Source("a.mnt", text), dialect("mint"), ExpectedWorld("", settings), others)


def test_a_number_that_a_define_gives_is_edited_in_its_line() -> None:
    text = SHUTTLE.replace("SPEED(0) = 100", "Define quick = 100\nSPEED(0) = quick")
    found = improver(text, {"axis.0.limits.speed": 150.0, "axis.0.limits.acceleration": 500.0}).improved()
    assert [(each.literal.address, each.value) for each in found.edits] == [("quick@1", 150.0)]
    assert found.patched.text == text.replace("quick = 100", "quick = 150")


def test_a_limit_of_the_position_keeps_its_place_when_the_zero_changes() -> None:
    """The axis is at 100 after two strokes of 50, which no edit changes; a search to -26 is homed to -1."""
    limits = {"axis.0.limits.position": [-2.0, 60.0], "axis.0.limits.speed": 200.0}
    machine = limits | {"axis.0.home_switch": [-60.0, -25.0]}
    stroke = "MOVEA(0) = 50 : GO(0) : PAUSE IDLE(0)\n"
    speed = "SPEED(0) = 100 : ACCEL(0) = 1800 : DECEL(0) = 1800 : HOMESPEED(0) = 60\n"
    beyond = improver(f"{speed}{stroke}POS(0) = 0\n{stroke}", machine).improved()
    assert (
        beyond.skipped[0]
        == "the highest position of axis 0 exceeds its limit already: see motionlang certify"
    )
    homed = improver(f"{speed}HOME(0) = _hmNEGATIVE_SWITCH : PAUSE IDLE(0)\n{stroke}", machine).improved()
    assert [(each.literal.address, each.value) for each in homed.edits] == [("SPEED[0]@1", 200.0)]


def test_the_edits_and_the_difference_that_patch_applies(shuttle: Cell) -> None:
    """2 (50/200 + 200/1000) = 0.9 s in place of 2 (50/100 + 100/500) = 1.4 s; statements take 40 µs."""
    ran = shuttle("improve", "shuttle.mnt", "--patch", "faster.diff")
    assert (ran.status, ran.err) == (0, "")
    assert (
        ran.out
        == """\
shuttle.mnt: run 1.4001 s → 0.90009 s, -35.7 % (no cycle: the whole run)

edit        line  from    to    gain  bounded by
                                   s
────────────────────────────────────────────────────────────────────────
SPEED[0]@1     1   100   200  0.1351  speed of axis 0: 200 uu/s
ACCEL[0]@1     1   500  1000  0.1695  acceleration of axis 0: 1000 uu/s²
DECEL[0]@1     1   500  1000  0.1954  acceleration of axis 0: 1000 uu/s²
22 trials

note: 1 way played with the edits, too: the same but for time

axis  limit                allowed  reached        at  line  margin
                                                    s
──────────────────────────────────────────────────────────────────────
   0  speed         uu/s       200      200  0.200040     2   0.0 %
   0  acceleration  uu/s²     1000     1000  0.000040     2   0.0 %

--- shuttle.mnt
+++ shuttle.mnt
@@ -1,4 +1,4 @@
-SPEED(0) = 100 : ACCEL(0) = 500 : DECEL(0) = 500
+SPEED(0) = 200 : ACCEL(0) = 1000 : DECEL(0) = 1000
 MOVEA(0) = 50 : GO(0) : PAUSE IDLE(0)
 OUTX(1) = 1
 MOVEA(0) = 0 : GO(0) : PAUSE IDLE(0)
"""
    )
    assert (shuttle.folder / "faster.diff").read_text() in ran.out
    assert shuttle("run", "shuttle.mnt").out.startswith("back after 1400 ms")  # it is not changed


def test_the_fewest_edits_for_a_wanted_gain(shuttle: Cell) -> None:
    """The speed alone, of which 158 uu/s are reached: 2 · 2 √(50/500) = 1.265 s; all of it is 36 %."""
    lines = shuttle("improve", "shuttle.mnt", "--by", "7%").out.splitlines()
    assert lines[0] == "shuttle.mnt: run 1.4001 s → 1.265 s, -9.6 % (no cycle: the whole run)"
    ran = shuttle("improve", "shuttle.mnt", "--by", "50%")
    assert (ran.status, ran.err) == (1, "not 50 %: this is all that the limits and the program allow\n")


def test_the_best_of_so_many_edits(shuttle: Cell) -> None:
    lines = shuttle("improve", "shuttle.mnt", "--edits", "2").out.splitlines()
    assert sum(line[:5] in ("SPEED", "ACCEL", "DECEL") for line in lines) == 2


def test_a_constant_that_is_the_number_of_an_axis_is_none_of_a_speed(cell: Cell) -> None:
    """No axis is 0.75, so the program is refused with it, and the trial shows nothing."""
    home = "HOMESPEED(0) = 20 : HOME(0) = 0 : PAUSE IDLE(0)\nMOVEA(0) = 50"
    text = SHUTTLE.replace("SPEED(0) = 100", "SPEED(0) = _FAST").replace("MOVEA(0) = 50", home)
    cell.write("axis.mnt", f"Const _FAST = 100\nConst _axX = 1\n{text.replace('(0)', '(_axX)')}")
    cell.write(
        "axis.machine.toml", f"axis.1.home_switch = [-200.0, -20.0]\n{LIMITS.replace('axis.0', 'axis.1')}"
    )
    ran = cell("improve", "axis.mnt")
    assert (ran.status, ran.err) == (0, "")
    assert "\n-Const _FAST = 100\n+Const _FAST = 200\n Const _axX = 1\n" in ran.out


def test_a_scenario_refutes_an_edit(shuttle: Cell) -> None:
    """In the scenario the axis may be at 25 uu not before 0.6 s, so only what comes later is faster."""
    (shuttle.folder / "shuttle.scenarios").mkdir()
    shuttle.write(
        "shuttle.scenarios/slow.toml", "[[expect]]\naxis = 0\nat = 0.35\nposition = 25.0\nwithin = 0.5\n"
    )
    ran = shuttle("improve", "shuttle.mnt")
    assert "scenario slow: axis 0 is at" in ran.out


def test_what_cannot_be_improved(cell: Cell) -> None:
    cell.write("free.mnt", SHUTTLE)
    ran = cell("improve", "free.mnt")
    assert (ran.status, ran.err.splitlines()[0]) == (
        1, "error[beyond-limit]: nothing bounds a faster cycle: the machine file has no limits"
    )  # fmt: skip
    section = "[axis.0.limits] with speed = 500, acceleration = 8000"
    needs = "axis 0: limits.speed, limits.acceleration: --set axis.0.limits.speed=VALUE"
    hint = f"  hint: it needs {needs}, or add a section such as {section} to free.machine.toml next to the program"
    assert ran.err.splitlines()[-1] == hint
    cell.write("wrong.mnt", "n = 0\nPRINT 1 / n\n")
    assert "error[division-by-zero]" in cell("improve", "wrong.mnt").err
    cell.write("still.mnt", "Loop\nWAIT(100)\nEnd Loop\n")
    assert "nothing repeats" in cell("improve", "still.mnt", "--until", "1").err


def test_a_fixed_wait_that_is_too_long_is_named_and_stays(cell: Cell) -> None:
    cell.write("w.mnt", SHUTTLE.replace("PAUSE IDLE(0)\nOUTX", "WAIT(900)\nOUTX"))
    cell.write("w.machine.toml", LIMITS)
    out = cell("improve", "w.mnt").out
    assert "note: line 2 waits 0.9 s while axis 0 moves, which is at rest 0.45001 s before" in out
    assert "+MOVEA" not in out


@pytest.mark.slow
def test_a_cycle_of_a_program_that_never_ends(cell: Cell) -> None:
    first, _, rest = SHUTTLE.partition("\n")
    cell.write("line.mnt", f"{first}\nLoop\n{rest}End Loop\n")
    cell.write("line.machine.toml", f"run.until = 8.0\n{LIMITS}")
    for repeats, words in (
        ("cycle", ()),
        ("cycle(print back)", ("--cycle", "cycle(print back)")),
    ):
        found = cell("improve", "line.mnt", *words).out.splitlines()
        where = "4 times" if words else "lines 3 to 6, 5 times"
        assert found[0] == f"line.mnt: {repeats} 1.4001 s → 0.90007 s, -35.7 % ({where})"


@pytest.mark.parametrize("path", one_in(12, PROGRAMS), ids=lambda path: path.name)
def test_improve_and_run_agree_on_the_cycle(path: Path) -> None:
    settings = settings_next_to(str(path))
    cycle = run(str(path), machine=settings, until=UNTIL).cycle
    if cycle is not None:
        source = Source.read(str(path))
        found = Improver(source, dialect_for(source, None), ExpectedWorld("", settings), until=UNTIL)
        assert found.before == cycle.period


def test_two_moves_of_one_line_are_one_cycle(cell: Cell) -> None:
    """There in 0.7 s, 0.1 s, back in 0.7 s, 1 s: no move, output or print happens just once in the cycle of 2.5 s."""
    cell.write(
        "moves.mccl", "1SV20000,1SA100000,1DS100000,1MN\nMD1,1MA10000,1WS,WA.1,1MA0,1WS,WA1,MJ1\nMC1\n"
    )
    cell.write(
        "moves.machine.toml", "run.until = 20\n[axis.1]\nlimits.speed = 40000\nlimits.acceleration = 100000\n"
    )
    out = cell("improve", "moves.mccl").out
    assert out.splitlines()[0] == "moves.mccl: cycle 2.5 s → 2.365 s, -5.4 % (line 2, 7 times)"


@pytest.mark.slow
@cases("speed, rate, length", [(50.0, 200.0, 30.0), (80.0, 100.0, 5.0), (120.0, 900.0, 60.0)])
def test_brute_force_over_a_grid_finds_nothing_better(speed: float, rate: float, length: float) -> None:
    """All speeds and rates in steps of a tenth of their limits, each run and compared with the limits."""
    text = f"SPEED(0) = {speed}\nACCEL(0) = {rate}\nDECEL(0) = {rate}\nMOVER(0) = {length} : GO(0) : PAUSE IDLE(0)\n"
    limits: dict[str, object] = {"axis.0.limits.speed": 200.0, "axis.0.limits.acceleration": 1000.0}
    found = improver(text, limits).improved()
    grid = "SPEED(0) = {}\nACCEL(0) = {}\nDECEL(0) = {}\n" + text.splitlines(keepends=True)[-1]
    values = product(range(20, 201, 20), range(100, 1001, 100), range(100, 1001, 100))
    best = min(run(Source("a.mnt", grid.format(*each))).time for each in values)
    assert found.after == pytest.approx(best, rel=2e-4)


@cases("length", [1.0, 30.0, 39.0, 41.0, 200.0])
def test_a_single_move_takes_the_least_time_that_its_limits_allow(length: float) -> None:
    """v²/a is the length of a move that just reaches its speed; a shorter one takes 2 √(d/a)."""
    text = f"SPEED(0) = 20\nACCEL(0) = 90\nDECEL(0) = 80\nMOVER(0) = {length} : GO(0) : PAUSE IDLE(0)\n"
    speed, rate = 200.0, 1000.0
    found = improver(text, {"axis.0.limits.speed": speed, "axis.0.limits.acceleration": rate}).improved()
    least = 2 * sqrt(length / rate) if length < speed**2 / rate else length / speed + speed / rate
    assert found.result.moves[0].duration == pytest.approx(least, rel=3e-4)


def test_the_patched_program_is_run_and_certified() -> None:
    found = improver(SHUTTLE, {"axis.0.limits.speed": 150.0, "axis.0.limits.acceleration": 700.0}).improved()
    again = run(found.patched, machine={"axis.0.limits.speed": 150.0, "axis.0.limits.acceleration": 700.0})
    assert again.time == found.after
    assert [each.verdict for each in found.limits] == ["within", "within"]
    assert [move.end for move in again.moves] == [move.end for move in run(Source("a.mnt", SHUTTLE)).moves]


LAMP = """\
SPEED(0) = 100 : ACCEL(0) = 500 : DECEL(0) = 500
Run blink
For k = 1 To 3
  OUTX(1) = 1
  MOVEA(0) = 50 : GO(0) : PAUSE IDLE(0)
  MOVEA(0) = 0 : GO(0) : PAUSE IDLE(0)
  OUTX(1) = 0
Next
End
Task blink
  Loop
    OUTX(5) = 1 : Wait = 200
    OUTX(5) = 0 : Wait = 200
  End Loop
End Task
"""


def test_a_task_that_blinks_a_lamp_runs_beside_the_work(cell: Cell) -> None:
    """Two moves take 0.45 s in place of 0.7 s; the waits of the lamp are no waits of the work."""
    cell.write("lamp.mnt", LAMP)
    cell.write("lamp.machine.toml", LIMITS)
    out = cell("improve", "lamp.mnt").out
    assert out.splitlines()[0] == "lamp.mnt: cycle 1.4001 s → 0.90007 s, -35.7 % (lines 4 to 7, 3 times)"
    assert "waits 0.2 s" not in out


def test_an_output_stays_among_the_moves(cell: Cell) -> None:
    """The nozzle opens 0.45 s after the start, while the axis moves; at 200 uu/s the axis has stopped by then."""
    cell.write(
        "glue.mnt",
        "Dim n As Integer\nSPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\nFor n = 1 To 3\n"
        "  MOVER(0) = 40 : GO(0)\n  WAIT(450) : OUTX(1) = 1\n  PAUSE IDLE(0) : OUTX(1) = 0\nNext\n",
    )
    cell.write("glue.machine.toml", LIMITS)
    assert (
        "line 5: output 1 = 1 no longer at 38.751 uu of the move of line 4" in cell("improve", "glue.mnt").out
    )


def test_a_homing_search_may_overshoot_less(cell: Cell) -> None:
    """With DECEL 1000 in place of 50 the search at 50 overshoots its switch by 1.25 in place of 25."""
    cell.write(
        "home.mnt",
        "HOMESPEED(0) = 50 : ACCEL(0) = 100 : DECEL(0) = 50 : SPEED(0) = 100\nHOME(0) = 0 : PAUSE IDLE(0)\n"
        "MOVEA(0) = 50 : GO(0) : PAUSE IDLE(0)\n",
    )
    cell.write("home.machine.toml", f"axis.0.home_switch = [-200.0, -80.0]\n{LIMITS}")
    out = cell("improve", "home.mnt").out
    assert "DECEL[0]@1     1    50  1000" in out
    cell.write("only.mnt", "HOME(0) = 0 : PAUSE IDLE(0)\n")
    cell.write("only.machine.toml", f"axis.0.home_switch = [-200.0, -80.0]\n{LIMITS}")
    ran = cell("improve", "only.mnt")
    assert ran.status == 1
    assert ran.err.startswith(
        "error[option]: the program has no cycle to improve: the run only homes its axes\n"
    )


HELD = """\
SPEED(0) = 100 : ACCEL(0) = 500 : DECEL(0) = 500
MOVEA(0) = 50 : GO(0) : PAUSE IDLE(0)
SPEED(0) = 20{}
MOVEA(0) = 0 : GO(0) : PAUSE IDLE(0)
"""


@cases("comment, setting, words", [
    ("    ' improve: hold", "", ()),
    ("    REM the glue, improve: hold", "", ()),
    ("", 'improve.hold = ["SPEED[0]@3"]\n', ()),
    ("", "", ("--hold", "SPEED[0]@3")),
])  # fmt: skip
def test_a_number_that_is_meant_stays(cell: Cell, comment: str, setting: str, words: tuple[str, ...]) -> None:
    cell.write("held.mnt", HELD.format(comment))
    cell.write("held.machine.toml", f"{setting}{LIMITS}")
    out = cell("improve", "held.mnt", *words).out
    assert "held: --also SPEED[0]@3 tries one\n  SPEED[0]@3 = 20  as you said\n" in out
    assert "+SPEED(0) = 200 : ACCEL" in out
    assert "\n+SPEED(0) = 20\n" not in out


def test_an_edit_that_was_refused_is_named_with_the_reason(cell: Cell) -> None:
    cell.write(
        "at.mnt", "SPEED(0) = 200 : ACCEL(0) = 500 : DECEL(0) = 500\nMOVEA(0) = 500 : GO(0) : PAUSE IDLE(0)\n"
    )
    cell.write("at.machine.toml", LIMITS)
    assert "note: SPEED[0]@1 stays 200: speed of axis 0: 200 uu/s\n" in cell("improve", "at.mnt").out


def test_without_an_edit_it_says_what_sets_the_cycle(cell: Cell) -> None:
    cell.write(
        "top.mnt",
        "SPEED(0) = 200 : ACCEL(0) = 1000 : DECEL(0) = 1000\nMOVEA(0) = 50 : GO(0) : PAUSE IDLE(0)\n",
    )
    cell.write("top.machine.toml", f'improve.hold = ["SPEED[0]@1", "ACCEL[0]@1", "DECEL[0]@1"]\n{LIMITS}')
    ran = cell("improve", "top.mnt")
    assert ran.status == 1
    assert "sets the cycle: it takes 0.45001 s of 0.45005 s, MOVEA of axis 0, 50 uu at 200 uu/s\n" in ran.out


def test_a_patch_has_the_line_endings_and_the_encoding_of_the_program(cell: Cell) -> None:
    path = cell.folder / "old.mnt"
    path.write_bytes(HELD.format("    ' gr\xf6\xdfe").replace("\n", "\r\n").encode("latin-1"))
    cell.write("old.machine.toml", LIMITS)
    cell("improve", "old.mnt", "--patch", "faster.diff")
    subprocess.run(["patch", "-p0", "-s", "-i", "faster.diff"], cwd=cell.folder, check=True)
    assert b"' gr\xf6\xdfe\r\n" in path.read_bytes()
    assert path.read_bytes().startswith(b"SPEED(0) = 200 : ACCEL(0) = 1000")


TICK = """\
Dim n As Integer, ticks As Integer
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
SPEED(1) = 100 : ACCEL(1) = 1000 : DECEL(1) = 1000
TIMEREVENT = 100
For n = 1 To 5
  MOVER(0) = 20 : GO(0) : PAUSE IDLE(0)
  MOVER(1) = 20 : GO(1) : PAUSE IDLE(1)
  ticks = 0
  PAUSE ticks >= 3
Next
End
Event TIMER
  ticks = ticks + 1
End Event
"""


@cases(
    "look, speeds",
    [
        ("", {"SPEED[1]@3": 150.0}),
        # With all numbers at their limits, axis 0 would be idle at 0.24 s, and the output would go on.
        ("WAIT = 240 : OUTX(3) = IDLE(0) : ", {"SPEED[0]@2": 150.0, "SPEED[1]@3": 133.0}),
    ],
)
def test_edits_that_gain_only_together_because_of_a_tick_are_found(
    look: str, speeds: dict[str, float]
) -> None:
    """Two strokes of 0.3 s and three ticks: 0.9 s. One edit reaches 0.8 s, the next tick takes three more."""
    limits: dict[str, object] = {
        f"axis.{axis}.limits.{name}": limit
        for axis in (0, 1)
        for name, limit in (("speed", 150.0), ("acceleration", 2000.0))
    }
    found = improver(TICK.replace("PAUSE IDLE(0)", f"{look}PAUSE IDLE(0)"), limits).improved()
    assert found.before == pytest.approx(0.9, abs=1e-4)
    assert found.after == pytest.approx(0.7, abs=1e-4)
    edits = {each.literal.address: each.value for each in found.edits}
    assert {name: value for name, value in edits.items() if name.startswith("SPEED")} == speeds
    assert len(edits) == 4


@pytest.mark.slow
def test_a_gain_of_the_homing_is_none_of_the_cycle(cell: Cell) -> None:
    """The search takes 4 s; only the strokes count."""
    cell.write(
        "home.mnt",
        "HOMESPEED(0) = 20 : ACCEL(0) = 100 : DECEL(0) = 100 : SPEED(0) = 100\nHOME(0) = 0 : PAUSE IDLE(0)\n"
        "Loop\n  SPEED(0) = 200\n  MOVEA(0) = 50 : GO(0) : PAUSE IDLE(0)\n  MOVEA(0) = 0 : GO(0) : PAUSE IDLE(0)\n"
        "End Loop\n",
    )
    cell.write("home.machine.toml", f"run.until = 20\naxis.0.home_switch = [-200.0, -80.0]\n{LIMITS}")
    out = cell("improve", "home.mnt").out
    assert out.startswith("home.mnt: cycle 2.8285 s → 0.90006 s, -68.2 % (lines 5 to 6, ")
    assert "HOMESPEED[0]@1 = 20  the speed of a homing" in out


def test_the_limits_that_are_missing_are_named_once(cell: Cell) -> None:
    cell.write(
        "two.mnt",
        "SPEED(0, 1) = 100, 50 : ACCEL(0, 1) = 500, 400 : DECEL(0, 1) = 500, 400\nLoop\n"
        "  MOVEA(0, 1) = 50, 40 : GO(0, 1) : PAUSE IDLE(0, 1)\n  MOVEA(0, 1) = 0, 0 : GO(0, 1) : PAUSE IDLE(0, 1)\n"
        "End Loop\n",
    )
    cell.write("two.machine.toml", f"run.until = 8\n{LIMITS}")
    out = cell("improve", "two.mnt").out
    note = (
        "SPEED[1]@1 = 50, ACCEL[1]@1 = 400, DECEL[1]@1 = 400 stay: limits are missing in two.machine.toml, "
        "axis 1: limits.speed, limits.acceleration"
    )
    assert out.count(note) == 1
    assert "  SPEED[0]@1 = 100  its axis moves with that of SPEED[1]@1, which stays\n" in out
    assert "--set axis.1.limits.speed=VALUE gives one\n" in out


def test_a_path_is_improved_as_a_move(cell: Cell) -> None:
    """The lower rate is hidden by the other one, and axis 1 does not move."""
    rates = "SPEED(0, 1) = 250; : ACCEL(0, 1) = 2000; : DECEL(0, 1) = 2000;\n"
    for command in ("VECTORA(0, 1) = {}, 0", "MOVEA(0) = {}"):
        moves = "".join(f"{command.format(end)} : GO(0) : Pause IDLE(0)\n" for end in (100, 0))
        cell.write("path.mnt", f"{rates}Loop\n{moves}End Loop\n")
        cell.write(
            "path.machine.toml", "run.until = 8\naxis.0.limits = { speed = 400, acceleration = 4000 }\n"
        )
        assert cell("improve", "path.mnt").out.startswith("path.mnt: cycle 1.0501 s → 0.70005 s, -33.3 %"), (
            command
        )


def test_an_edit_that_fails_in_a_scenario_is_taken_out_and_the_others_stay(shuttle: Cell) -> None:
    """There the first stroke must not reach 40 uu before 0.5 s; the run back may be faster."""
    shuttle.write("shuttle.mnt", SHUTTLE.replace("MOVEA(0) = 0", "SPEED(0) = 90 : MOVEA(0) = 0"))
    (shuttle.folder / "shuttle.scenarios").mkdir()
    shuttle.write(
        "shuttle.scenarios/slow.toml", "[[expect]]\naxis = 0\nat = 0.5\nposition = 40.0\nwithin = 0.5\n"
    )
    out = shuttle("improve", "shuttle.mnt").out
    assert "SPEED[0]@1 stays 100: scenario slow: axis 0 is at" in out
    assert "SPEED[0]@4     4    90   200" in out


def test_a_constant_that_a_speed_follows_through_a_variable_is_a_candidate(cell: Cell) -> None:
    """80 is twice the speed; at 400 uu/s and 4000 uu/s² a stroke of 100 takes 0.35 s, and the dwell 0.2 s."""
    limits = "axis.0.limits.speed = 400\naxis.0.limits.acceleration = 4000\n"
    for value, best in (("_FAST / 2", 800), ("_FAST", 400)):
        cell.write(
            "fast.mnt",
            f"Const _FAST = 80\nDim v As Float\nv = {value}\nSPEED(0) = v\nACCEL(0) = 1000 : DECEL(0) = 1000\n"
            "For i = 1 To 5\n  MOVER(0) = 100 : GO(0) : Pause IDLE(0)\n  Wait(200)\n"
            '  MOVER(0) = -100 : GO(0) : Pause IDLE(0)\n  Print "part"\nNext\n',
        )
        cell.write("fast.machine.toml", limits)
        out = cell("improve", "fast.mnt").out
        assert f"-Const _FAST = 80\n+Const _FAST = {best}\n" in out
        assert " → 0.90007 s, " in out


@pytest.mark.slow
def test_what_follows_the_last_whole_cycle_is_not_compared(cell: Cell) -> None:
    """Input 7 ends the shift at 14 s, wherever in its cycle the machine is then."""
    cell.write(
        "shift.prg",
        "AUTO\nSPEED.0 = 100 : ACCEL.0 = 500 : DECEL.0 = 500\nLOOP\n  IF INX.7 THEN EXIT\n  OUTX.4 = 1\n"
        '  IF INX.0 THEN GOSUB BAG\nENDL\nOUT.0 = 0\n? "SHIFT"\nEND\n#BAG\n'
        '  MOVER.0 = 200 : GO.0 : PAUSE IDLE.0\n  OUTX.4 = 0\n  PAUSE INX.0 = 0\n  ? "BAG"\nRETURN\n',
    )
    cell.write(
        "shift.machine.toml",
        "run.until = 60\ninput = [{ channel = 7, at = 14.0 }, { channel = 0, output = 4, delay = 1.0 }]\n"
        "axis.0.limits.speed = 200\naxis.0.limits.acceleration = 2000\n",
    )
    assert cell("improve", "shift.prg").out.startswith(
        "shift.prg: cycle 4.2001 s → 3.1001 s, -26.2 % (lines 5 to "
    )
