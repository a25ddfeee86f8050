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
    "line, wanted",
    [
        ("PAUSE INX(3)   ' guard shut", "guard shut"),
        ("IF INX(3) THEN PRINT 1 : REM foot pedal", "foot pedal"),
        ("IF INX(3) OR INX(4) THEN OUTX(1) = 1 : REM both buttons", ""),
        ("IF INX(3) THEN PAUSE NOT INX(3) : REM wire taken out", ""),
        ("PAUSE INX(3)   ' must be let go", ""),
        ("PAUSE INX(3)   ' until the ram is up", ""),
        ("PAUSE INX(3)   ' ends at the very moment of the edge", ""),
        ("PAUSE INX(3)   ' guard\nPRINT INX(3)", ""),
        ("PAUSE INX(3) AND INX(4)   ' 3 = guard\nPRINT INX(3)", "guard"),
        ("PAUSE INX(3)   ' 4 = guard", ""),
        ("PAUSE INX(3) = 0   ' 0 = guard", ""),
    ],
)
def test_a_remark_names_the_channel_that_its_line_alone_reads(line: str, wanted: str) -> None:
    assert channel(f"{line}\n", "input 3").name == wanted


def test_a_remark_behind_a_command_is_no_name() -> None:
    assert channel("OUTX(3) = 1 : REM lift up\n", "output 3").name == ""


def test_a_number_in_a_list_of_channels_names_the_input_or_an_output_without_one() -> None:
    found = made("' CH1 pedal   CH2 lamp\nOUTX(1) = INX(1)\nOUTX(2) = 1\n").channels
    assert [each.known_as for each in found] == ["input 1 (pedal)", "output 1", "output 2 (lamp)"]


def test_a_channel_that_is_a_parameter_has_a_row_for_each_number_that_is_given() -> None:
    """A number that is computed leaves the row of the parameter."""
    text = "Look(1)\nLook(4)\n{}End\nSub Look(ch As Integer)\n  Pause INX(ch)\nEnd Sub\n"
    titles = [[each.title for each in made(text.format(more)).channels] for more in ("", "Look(TIME)\n")]
    assert titles == [["input 1", "input 4"], ["input ?"]]
    assert channel(text.format(""), "input 4").waits == [5]


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
        ("n = 1 : PRINT INX(n)", "input 1", "in"),
        ("PRINT INX(n) : n = n + 1", "input ?", "in"),
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


def test_a_soft_limit_of_mccl_is_a_limit() -> None:
    (axis,) = made("1HL320,1LL-5,1SV40\n", "mccl").axes
    assert {fact.keyword: fact.topic for fact in axis.facts} == {"HL": "limit", "LL": "limit", "SV": "speed"}


def test_values_and_conditions_are_whole() -> None:
    text = 'AXES[0, 1]\nSPEED = 5, (6 + 1) * 2\nPAUSE (INX.0 AND INX.1) OR INX.2\nPRINT ":)", (INX.3)\n'
    found = made(text)
    assert [fact.text for fact in found.axes[0].facts] == ["SPEED = 5, (6 + 1) * 2"]
    assert list(channel(text, "input 0").decides) == ["3: (INX.0 AND INX.1) OR INX.2"]
    assert found.structure.statements[text.index("PRINT")].text == 'PRINT ":)", (INX.3)'


def test_an_output_that_only_its_bank_switches_has_the_lines_of_the_bank() -> None:
    lamp = channel("REM OUT 0 valve  OUT 2 lamp\nOUTX.0 = 1\nOUT = 4\n", "output 2")
    assert (lamp.name, lamp.writes) == ("lamp", [3])


def test_a_pulse_is_told_by_its_time() -> None:
    assert channel("PULSEOUTX.3 = 50\n", "output 3").values == ["on for 50 ms"]


def test_a_level_decides_by_way_of_a_variable_as_it_was_played() -> None:
    text = "t = ADC.0 / 5\nIF t < 4 THEN MOVER.0 = 1 : GO.0\n"
    (gauge,) = (
        each for each in motionlang.map(Source("a.prg", text)).channels if each.kind == "analogue input"
    )
    assert list(gauge.decides) == ["2: t < 4"]


def test_a_parameter_decides_what_its_sub_reads_not_what_stands_above_it() -> None:
    text = "Sub Ready\n  Pause INX(1)\nEnd Sub\nSub Fed(ByVal to As Float)\n  If to > 3 Then Ready\nEnd Sub\nFed(4)\n"
    found = {each.name: list(each.decides) for each in made(text).variables}
    assert found == {"to": ["5: to > 3"]}


def test_of_two_labels_the_first_one_names_the_subroutine() -> None:
    text = "GOSUB HANDS\nEND\n#HANDS\n#AGAIN\nIF INX.1 = 0 THEN GOTO AGAIN\nRETURN\n"
    assert [unit.title for unit in made(text).units] == ["program", "subroutine HANDS"]


def test_units_and_what_nothing_reaches() -> None:
    text = "#Again : Fill\nRun Lamp\nGOTO Over\nPRINT 1\nPRINT 2\n#Over\nSub Fill\n  PRINT 3\nEnd Sub\n"
    text += "Sub Spare\n  PRINT 4\nEnd Sub\nTask Lamp\n  Fill\nEnd Task\n"
    found = made(text)
    units = {each.title: each for each in found.units}
    assert units["program"].calls == {"sub Fill": [1]}
    assert units["program"].starts == {"task Lamp": [2]}
    assert units["sub Fill"].called_by == {"program": [1], "task Lamp": [14]}
    assert [title for title, each in units.items() if not each.is_reached] == ["sub Spare"]
    assert len(units) == 4  # no Gosub calls a label
    assert [(each.first, each.last) for each in found.unreached] == [(4, 5), (11, 11)]


def test_variables_have_the_lines_that_read_and_write_them() -> None:
    text = "Dim n As Integer = 3\nDim NV total As Integer\nFor i = 1 To n\n  total = total + i\nNext\n"
    found = {each.name: each for each in made(text).variables}
    assert (found["n"].writes, found["n"].reads) == ([1], [3])
    assert (found["total"].writes, found["total"].reads, found["total"].is_retained) == ([4], [4], True)
    assert (found["i"].writes, found["i"].reads) == ([3], [4])


def test_registers_of_mccl() -> None:
    found = {each.name: each for each in made("AL5,AR20\nRA20,1MN,1MR@20\n", "mccl").variables}
    assert (found["20"].writes, found["20"].reads) == ([1], [2])


def test_a_register_is_set_to_what_the_accumulator_has() -> None:
    found = made("MD1,GA1,AR30,IG5.5,MJ30\nMD2,AL7,AR31,AA1,AR32,GA2,AR33,MJ@33\nMC1\n", "mccl")
    assert [each.given for each in found.variables] == [
        {"analogue input 1": [1]},
        {"7": [2]},
        {},
        {"analogue input 2": [2]},
    ]


def test_a_register_is_set_to_what_the_accumulator_has_in_all_ways() -> None:
    # IB skips two commands, and JR goes back to AA with another value.
    found = made("MD1,GA1,IB5,AL1,NO,AR30\nMD2,RA31,AA1,IB9,JR-2,NO,AR32\n", "mccl")
    assert [each.given for each in found.variables if each.name in ("30", "32")] == [{}, {}]


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
