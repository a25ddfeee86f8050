"""Channels, axes, units and variables of programs, with their names and lines."""

from __future__ import annotations

from typing import Any

import motionlang
from motionlang.kernel import Source
from tests.cases import cases


def made(text: str, language: str = "mint", **settings: object) -> Any:
    return motionlang.map(
        Source(f"a.{'mnt' if language == 'mint' else 'mcl'}", text), machine=settings, run=False
    )


def channel(text: str, title: str, language: str = "mint", **settings: object) -> Any:
    return next(each for each in made(text, language, **settings).channels if each.title == title)


@cases(
    "comment, wanted",
    [
        ("REM IN 0 product eye   IN 1 label gap", "input 0 product eye, input 1 label gap"),
        ("REM IN0 tray in place, IN1 two-hand start", "input 0 tray in place, input 1 two-hand start"),
        ("; in 1 bar in gripper  2 gripper closed", "input 1 bar in gripper, input 2 gripper closed"),
        ("; out 33 vacuum  34 blow off", "output 33 vacuum, output 34 blow off"),
        ("REM   OUT 0 clamp 1 spindle 2 coolant", "output 0 clamp, output 1 spindle, output 2 coolant"),
        ("REM IN 6 drill broken (sensor, 0 = ok)", "input 6 drill broken"),
        ("' inputs   1 lock pin out   2 lock pin in", "input 1 lock pin out, input 2 lock pin in"),
        ("; axis 1 table, axis 2 press slide", "axis 1 table, axis 2 press slide"),
        (
            "REM axis 0 pusher (ballscrew 10 mm)    axis 1 lift",
            "axis 0 pusher, axis 1 lift",
        ),
        ("REM   0 = table (36000 counts/rev)    1 = feed", "axis 0 table, axis 1 feed"),
        ("' Gasket glue table, X=0 Y=1 Z=2.", "axis 0 X, axis 1 Y, axis 2 Z"),
        ("REM OUT1 heat OUT2 knife OUT3 lamp", "output 1 heat, output 2 knife, output 3 lamp"),
        ("Rem INPUT 4 guard OUTPUT 5 knife", "input 4 guard, output 5 knife"),
        ("; reg 24 pitch   reg 25 parts", "register 24 pitch, register 25 parts"),
        (
            "' IN0 key switch, 1 = automatic   IN5 jog +   IN6 jog -",
            "input 0 key switch, input 5 jog +, input 6 jog -",
        ),
        ("' IN1 jog X+ IN2 jog X- IN3 recipe, 00 = none", "input 1 jog X+, input 2 jog X-, input 3 recipe"),
        ("REM IN 3 nest 1 bottle    4 filler up", "input 3 nest 1 bottle, input 4 filler up"),
        ("; in 1 up to speed 2 guard   3 bar", "input 1 up to speed, input 2 guard, input 3 bar"),
        ("' IN 4 state: 0 idle 1 busy", "input 4 state"),
        ("' IN 4 1 = new order, 2 = abort", ""),
        ("' wait 5 seconds for the 2 clamps", ""),
        ("' Rev C  11/2003", ""),
    ],
)
def test_names_in_comments(comment: str, wanted: str) -> None:
    assert ", ".join(names(comment)) == wanted


# What uses all channels, axes and registers that comments name.
MINT = "".join(f"OUTX({k}) = INX({k})\n" for k in range(7)) + "MOVER(0) = 1 : MOVER(1) = 1 : MOVER(2) = 1\n"
MCCL = "WN1,WN2,CN33,CN34,1MR5,2MR5,RA24,AR25\n"


def names(comment: str) -> list[str]:
    """Return the names that a comment gives, in the order in which it has them."""
    found = made(f"{comment}\n{MCCL}", "mccl") if comment.startswith(";") else made(f"{comment}\n{MINT}")
    named = [f"{each.title} {each.name}" for each in found.channels if each.name]
    named += [f"axis {each.axis} {each.name}" for each in found.axes if each.name]
    named += [f"register {each.name} {each.meaning}" for each in found.variables if each.meaning]
    return sorted(named, key=lambda each: comment.find(each.split(" ", 2)[2]))


# Lists below each other and side by side, with the names that they give.
LISTS = """
' IN  0 ram at bottom       OUT 0 press clutch
'     1 ram at top              1 lubricate
'                               2 box full lamp
'     3 stop (event)
= input 0 ram at bottom, output 0 press clutch, input 1 ram at top, output 1 lubricate, output 2 box full lamp,
= input 3 stop (event)

REM Inputs               Outputs
REM
REM  0 housing in nest    0 clamp
REM  1 nest 1 bottle      1 screwdriver
= input 0 housing in nest, output 0 clamp, input 1 nest 1 bottle, output 1 screwdriver

	' INPUTS (24 V):	OUTPUTS:
	' --------------	--------
	' 0 = guard		0 = lamp
= input 0 guard, output 0 lamp

; in  1 door          out 3 lamp
;     2 lid closed now  4 horn
; a number behind one blank, at that of the column
; in  1 door      out 3 lamp
;     2 lid shut      4 horn
= input 1 door, output 3 lamp, input 2 lid closed now, output 4 horn

' IN 0 door          OUT 0 lamp
' IN 1 lid           OUT 1 horn
'    2 nest full         2 clamp
= input 0 door, output 0 lamp, input 1 lid, output 1 horn, input 2 nest full, output 2 clamp

' the second row may go on with the text of the first: it has no names
' IN 0 door   IN 1 lid   OUT 2 lamp
'    3 horn    4 clamp
'    5 fan
= input 0 door, input 1 lid, output 2 lamp

' between two columns, and of a line that has a word itself
' IN 0 door          OUT 0 lamp
'           1 lid
' IN 2 nest          3 horn
= input 0 door, output 0 lamp, input 2 nest

' OUT 0 clamp 1 spindle
'     2 coolant 3 horn
= output 0 clamp, output 1 spindle, output 2 coolant, output 3 horn

' OUT 0 clamp
'     1 nest 2 full
'     2 nest 3 full
= output 0 clamp, output 1 nest 2 full, output 2 nest 3 full

' IN 0 key switch, 1 = automatic
'    2 = manual, 3 = test
= input 0 key switch
"""


@cases("lines", [each.strip("\n") for each in LISTS.split("\n\n")])
def test_names_in_lists(lines: str) -> None:
    comment = "\n".join(each for each in lines.splitlines() if not each.startswith("="))
    wanted = " ".join(each[2:] for each in lines.splitlines() if each.startswith("="))
    assert ", ".join(names(comment)) == wanted


def test_the_mark_of_a_comment_is_no_part_of_a_name() -> None:
    assert channel("OUTX(3) = 1 : REM clamp\n", "output 3").name == "clamp"


def test_an_input_with_all_its_uses() -> None:
    text = (
        "Const _START = 3\nPAUSE INX(_START)\nIf INX(3) Then PRINT 1\nHOMEINPUT(0) = 3\n"
        "Event IN3\n  STOP(0)\nEnd Event\n"
    )
    found = channel(text, "input 3")
    assert (found.name, found.direction) == ("_START", "in")
    assert (found.waits, found.reads, found.set_up) == ([2], [3], [4])
    assert found.starts == ["HOMEINPUT(0)", "event IN3"]
    assert found.sentences() == [
        "input 3 (_START)",
        "waited for at line 2",
        "read at line 3",
        "starts HOMEINPUT(0)",
        "starts event IN3",
    ]


@cases(
    "line, title, direction",
    [
        ("OUTX(2) = 1", "output 2", "out"),
        ("PRINT OUTX(2)", "output 2", "out"),
        ("OUT(0) = 5", "output bank 0", "out"),
        ("DAC(1) = 50", "analogue output 1", "out"),
        ("PRINT ADC(2)", "analogue input 2", "in"),
        ("COMMS(5) = COMMS(6)", "comms element 5", "out"),
        ("COMMS(5) = COMMS(6)", "comms element 6", "in"),
        ("NVLONG(7) = NVLONG(7) + 1", "nv word 7", "in/out"),
        ("PRINT REMOTEINX(1, 2, 3)", "remote node 1, 2, 3", "in"),
        ("PRINT INX(n) : n = 1", "input ?", "in"),
        ("DRIVEENABLEOUTPUT(0) = 4", "output 4", "out"),
    ],
)
def test_channels_of_mint(line: str, title: str, direction: str) -> None:
    assert channel(line + "\n", title).direction == direction


@cases(
    "line, title, direction",
    [
        ("WN3", "input 3", "in"),
        ("CN33,IN33,NO,NO", "output 33", "out"),
        ("GA2,TR0", "analogue input 2", "in"),
        ("AL5,OA1", "analogue output 1", "out"),
        ("CN@20", "output @20", "out"),
        ("1MN,1JN", "analogue input 1", "in"),
    ],
)
def test_channels_of_mccl(line: str, title: str, direction: str) -> None:
    assert channel(line + "\n", title, "mccl").direction == direction


def test_the_machine_file_names_an_input() -> None:
    entries = [{"channel": 3, "name": "door", "at": 1.0}]
    assert channel("PAUSE INX(3)\n", "input 3", input=entries).name == "door"


def test_axes_have_literal_and_computed_moves() -> None:
    text = "SPEED(0, 1) = 10, 20\nx = 5\nMOVEA(0) = 12.5 : MOVER(1) = x\nGO(0, 1)\nMASTERSOURCE(1) = 1\n"
    found = {each.axis: each for each in made(text).axes}
    assert [(fact.text, fact.is_computed, fact.lines) for fact in found[0].of("move")] == [
        ("MOVEA = 12.5", False, [3])
    ]
    assert [(fact.text, fact.is_computed) for fact in found[1].of("move")] == [("MOVER = x", True)]
    assert [fact.text for fact in found[1].of("speed")] == ["SPEED = 20"]
    assert [fact.keyword for fact in found[1].of("master")] == ["MASTERSOURCE"]


def test_units_and_what_nothing_reaches() -> None:
    text = "Fill\nRun Lamp\nGOTO Over\nPRINT 1\nPRINT 2\n#Over\nSub Fill\n  PRINT 3\nEnd Sub\n"
    text += "Sub Spare\n  PRINT 4\nEnd Sub\nTask Lamp\n  Fill\nEnd Task\n"
    found = made(text)
    units = {each.title: each for each in found.units}
    assert units["program"].calls == {"sub Fill": [1]}
    assert units["program"].starts == {"task Lamp": [2]}
    assert units["sub Fill"].called_by == {"program": [1], "task Lamp": [14]}
    assert [title for title, each in units.items() if not each.is_reached] == ["sub Spare"]
    assert found.unreached == [(4, 5), (11, 11)]


def test_variables_have_the_lines_that_read_and_write_them() -> None:
    text = "Dim n As Integer = 3\nDim NV total As Integer\nFor i = 1 To n\n  total = total + i\nNext\n"
    found = {each.name: each for each in made(text).variables}
    assert (found["n"].writes, found["n"].reads) == ([1], [3])
    assert (found["total"].writes, found["total"].reads, found["total"].is_retained) == ([4], [4], True)
    assert (found["i"].writes, found["i"].reads) == ([3], [4])


def test_registers_of_mccl() -> None:
    found = {each.name: each for each in made("AL5,AR20\nRA20,1MN,1MR@20\n", "mccl").variables}
    assert (found["20"].writes, found["20"].reads) == ([1], [2])


def test_registers_macros_and_keys_have_names() -> None:
    found = made("; reg 24 pitch\nAL5,AR24\n; macro 3: advance\nMD3,1MR@24\nMC3\n", "mccl")
    assert [(each.name, each.meaning) for each in found.variables] == [("24", "pitch")]
    assert [each.meaning for each in found.units] == ["", "advance"]
    assert channel("k = INKEY\nSelect Case k\nCase 49\n  PRINT 1\nEnd Select\n", "key 0").name == "'1'"


def test_outputs_of_mccl_have_values() -> None:
    assert channel("CN33\nCF33\n", "output 33", "mccl").values == ["1", "0"]
    assert channel("AL5,OA1\n", "analogue output 1", "mccl").values == ["accumulator"]


def test_a_define_is_no_read() -> None:
    found = made("Define lamp = OUTX(3)\nDefine spare = 7\nlamp = 1 - lamp\n")
    output = next(each for each in found.channels if each.title == "output 3")
    assert (output.direction, output.reads, output.writes) == ("out", [3], [3])
    assert [each.name for each in found.variables if not each.is_used] == ["spare"]


def test_an_input_that_a_loop_polls_is_waited_for() -> None:
    text = (
        "While n < 4\n  If INX(1) Then MOVER(0) = 10 : GO(0) : n = n + 1\nEnd While\nIf INX(1) Then PRINT n\n"
    )
    found = channel(text, "input 1")
    assert (found.waits, found.reads) == ([2], [4])


def test_a_task_and_a_handler_are_started_not_called() -> None:
    found = made("MD3,CN33\nGT3\n", "mccl").units[1]
    assert (found.called_by, found.started_by) == ({}, {"program": [2]})
    stop = made("STOPINPUT(0) = 2\nPAUSE s\nEND\n#STOP\ns = 1\nRETURN\n")
    assert stop.units[1].started_by == {"input 2": []}
    assert next(each for each in stop.channels if each.title == "input 2").starts == [
        "STOPINPUT(0)",
        "event STOP",
    ]


def test_the_direction_of_velocity_mode_is_a_fact_of_its_axis() -> None:
    found = made("1DI1\n", "mccl").axes[0]
    assert [fact.text for fact in found.of("move")] == ["DI = 1"]


def test_a_list_goes_on_in_the_next_line() -> None:
    comment = "REM  IN  0 carton     1 clamped\nREM      3 start     4 row of product"
    assert names(comment) == ["input 0 carton", "input 1 clamped", "input 3 start", "input 4 row of product"]
