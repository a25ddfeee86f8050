"""`motionlang map` as a user sees it."""

from __future__ import annotations

import json

import pytest

from tests.cli.programs import Cell

PROGRAM = """\
' IN 1 part in place   IN 2 door    IN 5 ribbon low   OUT 3 clamp
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
Loop
  PAUSE INX(1)
  OUTX(3) = 1
  MOVEA(0) = 50 : GO(0)
  PAUSE IDLE(0)
  MOVEA(0) = 0 : GO(0)
  PAUSE IDLE(0)
  OUTX(3) = 0
  n = n + 1
  PRINT "piece ", n
  If n > 1000000 Then Spare
  PAUSE INX(1) = 0
End Loop
Sub Spare
  OUTX(3) = 0
End Sub
Event IN2
  STOP(0)
End Event
"""
SHOWN = """\
a.mnt: Mint, 4 channels, 1 axis, 3 units, 2 states, played 13 times

Cycle
1.8001 s, 23 times (lines 5 to 12), cycle(print piece)

   at  line  what                         takes
    s                                         s
───────────────────────────────────────────────
0.000     5  output 3 (clamp) on
0.000     6  axis 0 from 0 to 50 at 100     0.6
0.600     8  axis 0 from 50 to 0 at 100     0.6
1.200    10  output 3 (clamp) off
1.200    12  prints 'piece 23.0000'
1.200    14  waits for an input             0.3
1.500        input 1 (part in place) off
1.500     4  waits for an input             0.3
1.800        input 1 (part in place) on

axis 0                   ██████████████████████████████████████████████████·························
input 1 (part in place)  ██████████████████████████████████████████████████████████████············█
output 3 (clamp)         ██████████████████████████████████████████████████·························

in this world, which motionlang init writes:
  [[input]] channel = 1, asked = 0.3

Before you change anything
  input 1 (part in place) on starts the cycle
  input 2 (door) on cuts off moves of lines 6, 8 by event IN2
  waits of lines 4, 14 have no time-out

States
power-up
  by itself → 4, 0.00 s

waits in 4: PAUSE INX(1)   [input 1 (part in place)]
  input 1 (part in place) on → 14, 1.20 s: output 3 (clamp) on; axis 0 to 50 at 100; axis 0 to 0 at 100; output 3
      (clamp) off; 'piece 1.0000'

waits in 14: PAUSE INX(1) = 0   [input 1 (part in place)]
  input 1 (part in place) off → 4, 0.00 s

Handlers
  event IN2: input 1 (part in place) on and input 2 (door) on while axis 0 moves (line 6), waiting in 4 → 14: axis 0 to
      29.997 at 100; axis 0 to 0 at 100; output 3 (clamp) off; 'piece 1.0000'
  event IN2: input 1 (part in place) on and input 2 (door) on while axis 0 moves (line 8), waiting in 4 → 14: axis 0 to
      19.995 at 100; output 3 (clamp) off; 'piece 1.0000'

Inputs and outputs
channel   name           use  waited for  read  written    values  decides                    starts
───────────────────────────────────────────────────────────────────────────────────────────────────────────────────
input 1   part in place  in   4, 14                                4: INX(1); 14: INX(1) = 0
input 2   door           in                                                                   event IN2
input 5   ribbon low     in                                                                              never used
output 3  clamp          out                    5, 10, 17  1, 0

Axes
axis    what              statement     lines
─────────────────────────────────────────────
axis 0  moves             MOVEA = 50    6
        moves             MOVEA = 0     8
        speeds and rates  SPEED = 100   2
        speeds and rates  ACCEL = 1000  2
        speeds and rates  DECEL = 1000  2
        stopped           STOP          20

Structure
unit       line  called by     started by  calls
────────────────────────────────────────────────────────────
program                                    sub Spare (13)
sub Spare    16  program (13)
event IN2    19                input 2

Variables
name  kind      written  read   decides
──────────────────────────────────────────────────
n     variable  11       11-13  13: n > 1000000

Never played
from line  to line  text         why
────────────────────────────────────────────────────────
       13       13  Spare        line 13: if n > 1000000
       17       17  OUTX(3) = 0  sub Spare
"""
UNIT = """\
program
line  statement          waits for
────────────────────────────────────────────────
   2  SPEED(0) = 100
   2  ACCEL(0) = 1000
   2  DECEL(0) = 1000
   4  PAUSE INX(1)       input 1 (part in place)
   5  OUTX(3) = 1
   6  MOVEA(0) = 50
   6  GO(0)
   7  PAUSE IDLE(0)      axis 0
   8  MOVEA(0) = 0
   8  GO(0)
   9  PAUSE IDLE(0)      axis 0
  10  OUTX(3) = 0
  11  n = n + 1
  12  PRINT "piece ", n
  13  If n > 1000000
  13  Spare
  14  PAUSE INX(1) = 0   input 1 (part in place)
"""
LINE = """\
line 20: STOP(0)

Handlers
  event IN2: input 1 (part in place) on and input 2 (door) on while axis 0 moves (line 6), waiting in 4 → 14: axis 0 to
      29.997 at 100; axis 0 to 0 at 100; output 3 (clamp) off; 'piece 1.0000'
  event IN2: input 1 (part in place) on and input 2 (door) on while axis 0 moves (line 8), waiting in 4 → 14: axis 0 to
      19.995 at 100; output 3 (clamp) off; 'piece 1.0000'
"""


# An alarm and its reset, in a machine whose cycle has more rows than a screen.
ALARM = """\
' IN 1 start   2 pressure ok   3 reset
' OUT 1 clamp   2 horn
Loop
  Pause INX(1)
  If INX(2) = 0 Then
    OUTX(2) = 1
    Pause INX(3)
    OUTX(2) = 0
  End If
  OUTX(1) = 1 : MOVEA(0) = 10 : GO(0) : Pause IDLE(0) : OUTX(1) = 0
  OUTX(1) = 1 : MOVEA(0) = 20 : GO(0) : Pause IDLE(0) : OUTX(1) = 0
  OUTX(1) = 1 : MOVEA(0) = 30 : GO(0) : Pause IDLE(0) : OUTX(1) = 0
  OUTX(1) = 1 : MOVEA(0) = 0 : GO(0) : Pause IDLE(0) : OUTX(1) = 0
  Pause INX(1) = 0
End Loop
"""


@pytest.fixture
def program(cell: Cell) -> Cell:
    cell.write("a.mnt", PROGRAM)
    return cell


def test_the_map_as_text(program: Cell) -> None:
    ran = program("map", "a.mnt", "--all")
    assert (ran.status, ran.err) == (0, "")
    assert [line.rstrip() for line in ran.out.splitlines()] == SHOWN.splitlines()


def test_what_follows_an_output_does_not_start_the_cycle(cell: Cell) -> None:
    cell.write(
        "a.mnt",
        """\
' IN 1 start   2 clamped
' OUT 1 clamp
Loop
  Pause INX(1)
  OUTX(1) = 1
  Pause INX(2)
  MOVEA(0) = 10 : GO(0) : Pause IDLE(0)
  MOVEA(0) = 0 : GO(0) : Pause IDLE(0)
  OUTX(1) = 0
  Pause INX(2) = 0
  Pause INX(1) = 0
End Loop
""",
    )
    shown = cell("map", "a.mnt", "--all").out.splitlines()
    started = (
        "  input 1 (start) on starts the cycle; played with input 2 (clamped) behind an output or an axis"
    )
    assert started in shown


def test_the_first_screen_has_the_cycle_its_start_and_its_alarms(cell: Cell) -> None:
    cell.write("a.mnt", ALARM)
    shown = cell("map", "a.mnt").out.splitlines()
    assert len(shown) <= 40
    begin = shown.index("Before you change anything")
    assert shown[begin - 2].endswith("lines more")
    assert shown[begin + 1 : begin + 6] == [
        "  input 1 (start) on starts the cycle with input 2 (pressure ok) on",
        "  nothing that was played cuts off a move to a target",
        "  input 2 (pressure ok) off in the move of line 10 stops the machine at the end of its cycle",
        "  output 2 (horn) comes by input 2 (pressure ok) off, line 6; ends by input 3 (reset) on, and comes again "
        "without input",
        "      2 (pressure ok) on",
    ]
    assert shown[-1].startswith("--all shows")


# The move is cut off where the selector comes on again, and the lamp goes off between what is done as usual.
SELECTOR = """\
' in 0 auto  1 start  3 hot
' out 1 clamp  3 lamp ready
Dim aut As Integer, stage As Integer
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
Loop
  If INX(0) Then
    If aut = 0 Then CANCEL(0) : stage = 0 : aut = 1
  Else
    aut = 0
  End If
  OUTX(3) = INX(3)
  If aut = 1 Then
    If stage = 0 And INX(1) And INX(3) Then MOVEA(0) = 200 : GO(0) : stage = 1
    If stage = 1 And IDLE(0) Then OUTX(1) = 1 : Wait(500) : OUTX(1) = 0 : MOVEA(0) = 0 : GO(0) : stage = 2
    If stage = 2 And IDLE(0) Then stage = 0
  End If
  Wait(10)
End Loop
"""


def test_an_input_that_has_to_come_back_to_cut_off_a_move_is_told_so(cell: Cell) -> None:
    cell.write("a.mnt", SELECTOR)
    shown = cell("map", "a.mnt", "--all").out.splitlines()
    assert [each.strip() for each in shown if " cuts off " in each or " stops the machine " in each] == [
        "input 0 (auto) off and on again cuts off moves of line 14",
        "input 1 (start) off or input 3 (hot) off in the move of line 13 stops the machine at the end of its cycle",
    ]


def test_both_levels_that_cut_off_moves_are_one_sentence(cell: Cell) -> None:
    stroke = "MOVEA(0) = {} : GO(0)\nWhile Not IDLE(0)\n  If INX(7) = {} Then STOP(0)\nEnd While\n"
    text = f"Loop\nPause INX(1)\n{stroke.format(50, 1)}Pause INX(7)\n{stroke.format(0, 0)}Pause INX(1) = 0\nEnd Loop\n"
    cell.write("a.mnt", f"SPEED(0) = 100 : ACCEL(0) = 1000\n{text}")
    assert "  input 7 off cuts off moves of line 9, on those of line 4\n" in cell("map", "a.mnt").out


def test_a_go_that_waits_for_the_move_before_is_no_step_of_the_cycle(cell: Cell) -> None:
    moves = "MOVER(0) = 10 : GO(0)\n" * 4
    cell.write(
        "a.mnt", f"SPEED(0) = 100 : ACCEL(0) = 1000\nLoop\nPause INX(1)\n{moves}Pause INX(1) = 0\nEnd Loop\n"
    )
    rows = [each.split() for each in cell("map", "a.mnt").out.split("────\n")[1].splitlines()]
    assert [each[1] for each in rows if each[2:3] == ["axis"]] == ["4", "5", "6", "7"]


def test_the_statements_of_a_unit(program: Cell) -> None:
    assert program("map", "a.mnt", "--unit", "program").out == UNIT
    assert program("map", "a.mnt", "--unit", "spare").out.splitlines()[0] == "sub Spare, line 16"


def test_without_a_run_the_map_has_what_the_text_says(program: Cell) -> None:
    ran = program("map", "a.mnt", "--no-run")
    begin = SHOWN.index("Inputs and outputs")
    end = SHOWN.index("Never played")
    assert ran.out == (
        "a.mnt: Mint, 4 channels, 1 axis, 3 units\n\n"
        f"{SHOWN[begin:end]}Never played\nevery statement can be reached\n"
    )


def test_a_choice_is_played_too(cell: Cell) -> None:
    """The keys 1 and 2 lead to the same question, and move another axis each."""
    cell.write(
        "menu.prg",
        '#MENU\nk = INKEY\nIF k = 49 OR k = 50 THEN GOTO ASK\nGOTO MENU\n#ASK\nINPUT "HOW FAR ",n\n'
        'IF n > 50 THEN ? "TOO FAR" : GOTO ASK\n'
        "IF k = 49 THEN MOVER.0 = n : GO.0 : PAUSE IDLE.0\nIF k = 50 THEN MOVER.1 = n : GO.1 : PAUSE IDLE.1\n"
        "GOTO MENU\n",
    )
    shown = " ".join(cell("map", "menu.prg", "--all").out.split())
    assert "key 1 (or 2) → 6" in shown
    assert "'HOW FAR' 100 → the same question, 0.00 s: 'HOW FAR 100'; 'TOO FAR'" in shown
    assert "Choices key 2, waiting in 2-4: 'HOW FAR 10'; axis 1 to 10 at 1000" in shown


def test_a_machine_that_nothing_moves(cell: Cell) -> None:
    cell.write("a.mnt", "Loop\n  PAUSE INX(1)\n  PRINT 1\n  PAUSE INX(1) = 0\nEnd Loop\n")
    assert cell("map", "a.mnt").out.splitlines()[2:4] == ["Cycle", "none: no axis moved"]
    cell.write("a.mnt", "PRINT 1\n")
    assert "the program waits for nothing around it" in cell("map", "a.mnt", "--all").out


@pytest.mark.parametrize(
    ("name", "begins"),
    [
        ("m.html", "<!doctype html>"),
        ("m.md", "# a.mnt"),
        ("m.mmd", "flowchart TD"),
        ("m.json", "{"),
        ("m.csv", "channel,name,"),
        ("m.txt", "a.mnt: Mint"),
    ],
)
def test_the_extension_of_the_output_chooses_the_form(name: str, begins: str, program: Cell) -> None:
    assert program("map", "a.mnt", "-o", name).out == ""
    assert (program.folder / name).read_text(encoding="utf-8").startswith(begins)


def test_values_of_the_program_are_those_of_set(program: Cell) -> None:
    made = json.loads(program("map", "a.mnt", "--set", "SPEED[0]@2=50", "--format", "json").out)
    assert [each["what"] for each in made["cycle"]][1] == "axis 0 from 0 to 50 at 50"


def test_what_is_wrong_with_the_command_line(program: Cell) -> None:
    assert (
        "names of the program in --set need a run" in program("map", "a.mnt", "--no-run", "--set", "n=5").err
    )
    ran = program("map", "a.mnt", "--set", "spares=5")
    assert (ran.status, ran.out) == (1, "")
    assert "the program has no constant or variable spares" in ran.err
    ran = program("map", "a.mnt", "--unit", "Spar")
    assert (ran.status, ran.err) == (
        2,
        "error[option]: the program has no unit Spar\n  hint: did you mean Spare?\n",
    )


def test_a_program_with_errors_has_no_map(program: Cell) -> None:
    program.write("b.mnt", "MOVEA(0 = 5\n")
    ran = program("map", "b.mnt")
    assert (ran.status, ran.out) == (1, "")
    assert "error[syntax]" in ran.err


@pytest.mark.slow
def test_a_line_with_the_states_and_ways_in_which_it_runs(program: Cell) -> None:
    assert program("map", "a.mnt", "--line", "20").out == LINE
    assert program("map", "a.mnt", "--line", "17").out == "line 17: OUTX(3) = 0\n  never ran: sub Spare\n"
    assert program("map", "a.mnt", "--line", "99").out == "line 99\n  has no statement of its own\n"
    assert "--line and --no-run exclude each other" in program("map", "a.mnt", "--line", "4", "--no-run").err


def test_a_line_in_none_of_the_states_and_ways(cell: Cell) -> None:
    cell.write("a.mnt", "Const _N = 1\nn = _N\nPAUSE n > 1\nPRINT n\n")
    assert cell("map", "a.mnt", "--line", "1").out == "line 1: Const _N = 1\n  has no statement of its own\n"
    assert cell("map", "a.mnt", "--line", "4").out == "line 4: PRINT n\n  never ran in what was played\n"


def test_a_line_of_a_macro_runs_where_its_commands_do(cell: Cell) -> None:
    cell.write("a.mcl", "MD3,CN4,CF4\nMD5,CN6,RP\nMD7,WN1,MC3,WF1,MJ7\nMJ7\n")
    states = [each for each in cell("map", "a.mcl", "--line", "1").out.splitlines() if "waits" in each]
    assert [each.partition(" (")[0] for each in states] == ["waits in 3: WN1   [input 1]"]
    assert "power-up" not in cell("map", "a.mcl", "--line", "1").out
    assert cell("map", "a.mcl", "--line", "2").out == "line 2: MD5,CN6,RP\n  never ran: nothing leads here\n"


def test_what_variables_are_set_to_and_which_inputs_are_active_low(cell: Cell) -> None:
    cell.write(
        "a.mnt",
        "Const _WAIT = 1\nDim state As Integer, n As Integer, a(2) As Integer : a(2) = 7\n"
        "INPUTACTIVELEVEL(0) = 0xFFFD\nLoop\n  state = _WAIT\n"
        "  Pause INX(1) = 0\n  state = 2 : n = n + 1\n  MOVER(0) = n : GO(0) : Pause IDLE(0)\n"
        "  If state = 2 Then state = 0\n  Pause INX(1)\nEnd Loop\n",
    )
    shown = [" ".join(line.split()) for line in cell("map", "a.mnt", "--all").out.splitlines()]
    assert "state variable 5, 7, 9 _WAIT (5), 2 (7), 0 (9) 9 9: state = 2" in shown
    assert "a variable 2 (2): 7 (2)" in shown
    assert "active low, so the program reads 0 when it is on: input 1" in shown


def test_numbers_of_a_host_with_the_states_in_which_they_are_written_and_read(cell: Cell) -> None:
    cell.write(
        "a.mnt",
        "Loop\n  Pause COMMS(1) = 7\n  COMMS(2) = 1\n  MOVER(0) = 20 : GO(0) : Pause IDLE(0)\n"
        "  Pause INX(3)\n  COMMS(2) = 0\n  Pause INX(3) = 0\nEnd Loop\n",
    )
    shown = [" ".join(line.split()) for line in cell("map", "a.mnt", "--all").out.splitlines()]
    begin = shown.index("Numbers of a host")
    assert shown[begin + 1] == "channel written what in read in"
    assert shown[begin + 3 : begin + 5] == [
        "comms element 1 2 3 states",
        "comms element 2 3, 6 1, 0 3 states",
    ]


def test_what_the_program_remembers_decides_between_two_rows(cell: Cell) -> None:
    """Both keys lead to the same wait, which goes on as the key was."""
    cell.write(
        "a.mnt",
        "Dim k As Integer, kind As Integer\nLoop\n  Repeat\n    k = INKEY\n  Until k = 49 Or k = 50\n"
        "  kind = k - 48\n  Pause INX(1)\n  If kind = 1 Then MOVER(0) = 20 : GO(0)\n"
        "  If kind = 2 Then MOVER(1) = 30 : GO(1)\n"
        "  Pause IDLE(0) And IDLE(1)\n  Pause INX(1) = 0\nEnd Loop\n",
    )
    shown = " ".join(cell("map", "a.mnt", "--all").out.split())
    assert shown.count("waits in 7: Pause INX(1)") == 1
    assert "input 1 on, seen with kind = 1 → " in shown
    assert "input 1 on, seen with kind = 2 → " in shown


def test_a_menu_shows_what_it_remembers(cell: Cell) -> None:
    cell.write(
        "menu.mnt",
        "Dim size As Integer, k As Integer\nsize = 0\nLoop\n  k = INKEY\n"
        '  If k = 49 Then Input "size", size\n'
        '  If k = 50 And size = 0 Then Print "size first"\n'
        "  If k = 50 And size > 0 Then MOVER(0) = size : GO(0) : Pause IDLE(0)\n  Wait(50)\nEnd Loop\n",
    )
    shown = cell("map", "menu.mnt", "--all").out
    assert "key 2, seen with size = 0 →" in shown
    assert "key 2, seen with size is not 0 →" in shown


def test_all_of_a_block_that_never_ran_has_its_condition(cell: Cell) -> None:
    loop = "Loop\n  Pause INX(1)\n  MOVER(0) = 10 : GO(0) : Pause IDLE(0)\n  n = n + 1\n"
    block = '  If n > 90000 Then\n    Print "FULL"\n    n = 0\n  End If\n'
    cell.write(
        "a.mnt",
        f"Dim n As Integer\nSPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\n{loop}{block}End Loop\n",
    )
    shown = cell("map", "a.mnt", "--all").out
    assert shown[shown.index("Never played") :].splitlines()[3:] == [
        '        8        9  Print "FULL"  line 7: if n > 90000',
    ]
