"""`motionlang init` writes a first machine file, in which each guess is marked."""

from __future__ import annotations

import io
import sys

import pytest

from motionlang.kernel import Source, read_machine
from tests.cli.programs import Cell


def guesses(cell: Cell, text: str, name: str = "old.prg") -> dict[str, object]:
    """Return the settings of the machine file that init writes for a program."""
    cell.write(name, text)
    assert cell("init", name, "--format", "none").status == 0
    return read_machine(Source.read(str(cell.folder / "old.machine.toml")))


def inputs(cell: Cell, text: str, name: str = "old.prg") -> list[dict[str, object]]:
    found: list[dict[str, object]] = guesses(cell, text, name)["input"]  # type: ignore[assignment]
    assert all(each.pop("guess") is True for each in found)
    return found


def test_an_input_that_is_waited_for_comes_shortly_after(cell: Cell) -> None:
    assert inputs(cell, "WAIT = 700\nPAUSE INX.2\n") == [{"channel": 2, "at": 1.0}]


@pytest.mark.parametrize(
    ("since", "line"),
    [(5.9, "{ channel = 2, at = 6.2, guess = true }"), (6.1, "# { channel = 2, at = 0.0 }")],
)
def test_a_wait_that_begins_shortly_before_the_end_may_still_end(cell: Cell, since: float, line: str) -> None:
    """The run ends at 10 s, and another task goes on.

    A wait of 4 s gets an input 0.3 s after its beginning, a shorter one does not.
    """
    beside = "TASK t\nLOOP\nWAIT = 100\nEND LOOP\nEND TASK\n"
    cell.write("old.mnt", f"RUN t\nWAIT = {1000 * since:.0f}\nPAUSE INX(2)\nEND\n{beside}")
    assert cell("init", "old.mnt", "--until", "10", "--format", "none").status == 0
    machine = (cell.folder / "old.machine.toml").read_text()
    assert f"  {line}," in machine


def test_an_input_after_an_output_follows_it(cell: Cell) -> None:
    text = "OUTX.4 = 1\nPAUSE INX.2\nOUTX.4 = 0\nPAUSE INX.2 = 0\nOUTX.5 = 1\nOUTX.5 = 0\nPAUSE INX.3\n"
    assert inputs(cell, text) == [
        {"channel": 2, "output": 4, "delay": 0.3},
        {"channel": 3, "output": 5, "delay": 0.3, "value": 0},
    ]


def test_a_bank_that_is_waited_for(cell: Cell) -> None:
    text = (
        "PAUSE IN(0) = 1\nWHILE IN(0) & 4 = 0\nWEND\nDIM n\nn = IN(1)\nIF n & 2 THEN PRINT 7\nPRINT INX(n)\n"
    )
    assert inputs(cell, text, "old.mnt") == [{"channel": 0, "at": 0.3}, {"channel": 2, "at": 0.6}]
    machine = (cell.folder / "old.machine.toml").read_text()
    assert (
        "  # line 5: n = IN(1)\n  # line 6: IF n & 2 THEN PRINT 7\n  # { channel = 33, at = 0.0 }," in machine
    )
    assert "known while the program runs.\n# line 7: PRINT INX(n)\n" in machine


def test_an_endless_wait_stays_an_error(cell: Cell) -> None:
    """The time limit that init writes does not hide it, and no expectation certifies it."""
    cell.write("old.mnt", "JOG(0) = 5\nPAUSE IDLE(0)\n")
    for command in ("init", "run"):
        ran = cell(command, "old.mnt", "--format", "none")
        assert ran.status == 1
        assert "error[never]: the program waits until IDLE(0), which can never happen" in ran.err
    assert "\n[[expect]]" not in (cell.folder / "old.machine.toml").read_text()


def test_an_input_follows_no_relay(cell: Cell) -> None:
    assert inputs(cell, "RELAY.0 = 1\nPAUSE INX.2\n") == [{"channel": 2, "at": 0.3}]


def test_an_input_that_comes_and_goes(cell: Cell) -> None:
    text = "LOOP\nPAUSE INX.0\nPAUSE INX.0 = 0\nENDL\n"
    assert inputs(cell, text) == [{"channel": 0, "at": 1.0, "for": 1.0, "every": 2.0}]


@pytest.mark.parametrize("text", ["{}", "LOOP\n{}ENDL\n"])
def test_two_values_of_a_bank_come_in_turn(cell: Cell, text: str) -> None:
    waits = "PAUSE IN = 5\nPAUSE IN = 10\n? TIME\n"
    starts = [(each["channel"], each["at"]) for each in inputs(cell, text.format(waits))]
    assert starts == [(0, 1.0), (1, 2.0), (2, 1.0), (3, 2.0)]
    assert cell("run", "old.prg", "--set", "run.until=9", "--format", "none").out.startswith("2000\n")


def test_an_input_that_only_a_handler_tests_for_0_is_on_from_the_begin(cell: Cell) -> None:
    text = "PAUSE INX(2)\nPAUSE INX(1)\nEND\nEvent IN3\nIF INX(2) = 0 THEN PRINT 7\nEnd Event\n"
    assert inputs(cell, text, "old.mnt") == [{"channel": 1, "at": 0.3}, {"channel": 2, "at": 0.0}]


def test_a_loop_with_a_time_limit_waits_too(cell: Cell) -> None:
    text = 'WAIT = 500\nWHILE INX.1 = 0\nn = n + 1\nWAIT = 10\nIF n > 200 THEN GOTO bad\nENDW\nEND\n#bad\n? "bad"\n'
    assert inputs(cell, text) == [{"channel": 1, "at": 0.8}]


def test_an_input_that_leads_to_a_fault_is_at_the_other_level(cell: Cell) -> None:
    text = 'IF INX.2 = 0 THEN GOTO bad\nIF INX.3 THEN GOTO bad\n? "good"\nEND\n#bad\n? "bad"\n'
    assert inputs(cell, text) == [{"channel": 2, "at": 0.0}]
    assert "  # { channel = 3, at = 0.0 }," in (cell.folder / "old.machine.toml").read_text()


def test_the_inventory_names_inputs_where_they_are_used(cell: Cell) -> None:
    """An input behind a Define has the lines that test it, and a label of v4 reads its input."""
    text = "DEFINE START = INX.5\nLOOP\nIF START THEN GOTO GO1\nENDL\n#GO1\nEND\n#IN3\n? 3\nRETURN\n"
    guesses(cell, text)
    machine = (cell.folder / "old.machine.toml").read_text()
    assert "  # line 3: IF START THEN GOTO GO1\n  # { channel = 5" in machine
    assert "  # line 7: #IN3\n  # { channel = 3" in machine
    ran = cell("run", "old.prg", "--input", "3=1@0.5", "--until", "1", "--format", "none")
    assert (ran.status, ran.out) == (0, "3\n")


def test_an_analogue_input_gets_the_level_that_is_waited_for(cell: Cell) -> None:
    found = guesses(cell, "WAIT = 500\nPAUSE ADC.2 > 60\nPAUSE ADC.2 < 101\n")
    assert found["analogue"] == [{"channel": 2, "value": 100.0, "at": 0.8, "guess": True}]


def test_only_the_analogue_inputs_of_a_condition_get_a_level(cell: Cell) -> None:
    found: list[dict[str, object]] = guesses(cell, "PAUSE ADC.2 > 60 And INX.3\n")["analogue"]  # type: ignore[assignment]
    assert [each["channel"] for each in found] == [2]


def test_mccl(cell: Cell) -> None:
    text = "CN33,WN1\nCF33,WF1\nWN2\nIN3,NO,NO\n"
    assert inputs(cell, text, "old.mccl") == [
        {"channel": 1, "output": 33, "delay": 0.3},
        {"channel": 2, "at": 0.9},  # 0.3 s after channel 1 has gone off again
    ]


def test_a_macro_that_polls_an_input_and_calls_one_that_waits(cell: Cell) -> None:
    text = "MD1,CN34,WN6,1MR45,1WS.05,CF34,WF6\nMD2,IN2,MC1,NO,WA.02,MJ2\n1MN\nMC2\n"
    assert inputs(cell, text, "old.mccl") == [
        {"channel": 2, "at": 0.3},
        {"channel": 6, "output": 34, "delay": 0.3},
    ]


@pytest.mark.parametrize(
    ("text", "found"),
    [
        # Off, input 2 leaves the work for another macro; on, input 4 does.
        ("MD1,IF2,MJ9,NO,IN4,MJ9,NO,1MR10,1WS.1,RP\nMD9,CN33\n1MN\nMC1\n", [{"channel": 2, "at": 0.0}]),
        # The macro begins again while input 2 is off.
        ("MD1,IF2,MJ1,NO,1MR10,1WS.1\n1MN\nMC1\n", [{"channel": 2, "at": 0.3}]),
        # The macro tries three times; without input 2 it gives up.
        (
            "MD1,AL0,AR1,CN33,WA.2,MJ2\nMD2,IN2,MJ3,NO,RA1,AA1,AR1,IG2,MJ9,NO,WA.3,MJ2\nMD3,1MR10,1WS.1\nMD9,CN36\n"
            "1MN\nMC1\n",
            [{"channel": 2, "output": 33, "delay": 0.3}],
        ),
    ],
)
def test_a_jump_to_another_macro_leaves_the_work(
    cell: Cell, text: str, found: list[dict[str, object]]
) -> None:
    assert inputs(cell, text, "old.mccl") == found


@pytest.mark.parametrize(
    ("text", "answers"),
    [
        ('INPUT "Speed ", v', [("Speed", "10")]),
        ('INPUT "Speed (20-80): ", v', [("Speed (20-80)", "50")]),
        ('INPUT "BOTTLES 1-9999 ", n', [("BOTTLES 1-9999", "10")]),
        ('INPUT "BOTTLES 2000-999999 ", n', [("BOTTLES 2000-999999", "2000")]),
        ('? CHR(27);"[2JHOLES?"\nINPUT n\n', [("HOLES", "10")]),
        ('#a\nINPUT "Layers ", n\nIF n > 6 THEN ? "1 to 6" : GOTO a\n', [("Layers", "3")]),
        ('#a\nINPUT "Gap ", n\nIF n > 6 THEN GOTO a\n', [("Gap", "1")]),
        ('? "HOLES?"\nINPUT n\n', [("HOLES", "10")]),
        ('FOR i = 1 TO 2\nINPUT "Way ", s\nMOVER.0 = s : GO.0 : PAUSE IDLE.0\nNEXT\n', [("Way", "10")] * 2),
    ],
)
def test_answers(cell: Cell, text: str, answers: list[tuple[str, str]]) -> None:
    found: list[dict[str, str]] = guesses(cell, text)["answer"]  # type: ignore[assignment]
    assert [(each["prompt"], each["text"]) for each in found] == answers


MENU = """\
SPEED.0 = 100 : ACCEL.0 = 1000 : DECEL.0 = 1000
#MENU
INPUT "Choice ", c
IF c = 1 THEN GOSUB RUNIT
IF c = 2 THEN ? "HELP"
IF c = 3 THEN GOSUB SERV
GOTO MENU
#RUNIT
PAUSE INX.1
MOVER.0 = 10 : GO.0 : PAUSE IDLE.0
RETURN
#SERV
INPUT "Service ", s
IF s = 1 THEN MOVER.0 = 30 : GO.0 : PAUSE IDLE.0
IF s = 2 THEN OUTX.1 = 1
RETURN
"""


def test_a_menu_is_explored_as_a_tree(cell: Cell) -> None:
    """Every choice is made once; a path that moves an axis becomes a scenario, which ends at the next question."""
    found = guesses(cell, MENU)
    assert [(each["prompt"], each["text"]) for each in found["answer"]] == [  # type: ignore[attr-defined]
        ("Choice", "1"),
        ("Choice", "2"),
        ("Choice", "3"),
        ("Service", "1"),
    ]
    folder = cell.folder / "old.scenarios"
    assert sorted(path.name for path in folder.iterdir()) == ["choice-1.toml", "choice-3-1.toml"]
    assert (
        (folder / "choice-3-1.toml").read_text()
        == """\
# "Choice" 3, "Service" 1: a path through the menus of old.prg, written by motionlang init.
# It adds to the machine file next to the program. docs/scenarios.md explains scenarios.

run.until = 300    # the run ends here if the program does not
run.stop = { event = "input" }    # the program asks again, and there is no further answer

input = [
  { channel = 1, at = 0.0, value = 0, guess = true },
]

answer = [
  { prompt = "Choice", text = "3", guess = true },
  { prompt = "Service", text = "1", guess = true },
]

[[expect]]
status = "stopped"
"""
    )
    assert cell("verify", "old.prg").out.endswith("2 of 2 scenarios pass\n")
    assert "stopped after 0.90025 s by an INPUT without an answer" in cell("run", "old.prg").out


@pytest.mark.parametrize(
    ("name", "text", "status", "notes"),
    [
        (
            "old.prg",
            "PAUSE INX.4\nOUTX.1 = 1\nMOVER.0 = 5 : GO.0 : PAUSE IDLE.0\nIF INX.5 THEN OUTX.2 = 1\nPAUSE INX.4\n",
            0,
            ["input 4 ended the wait of line 1", "output 2 was never switched on"],
        ),
        (
            "old.mccl",
            "MD1,CN33,WN1,1MR5,1WS.1,CF33,WF1,WN2,WA30,RP\nMD2,CN34,CN35\n1MN\nMC1\n",
            0,
            [
                "input 1 ended the wait of line 1",
                "input 2 ended the wait of line 1",
                "outputs 34, 35 were never switched on",
                "10 cycles began, in each of which line 1 moves an axis",
            ],
        ),
        (
            "old.prg",
            "IF INX.1 = 0 THEN ? 1\nIF INX.2 = 5 THEN MOVER.0 = 5 : GO.0\n",
            1,
            ["no axis moved, and line 2 commands motion"],
        ),
        ("old.prg", "? 1\n", 0, []),
        (
            "old.prg",
            "REM IN 3 knife up  IN 4 part\nSTOPINPUT.0 = 6\nMOVER.0 = 5 : GO.0\nIF INX.4 THEN MOVER.0 = 9 : GO.0\n",
            0,
            [
                "line 4 commands motion and moved no axis; unchanged so far: input 4 (line 4)",
                "input 3 (knife up): named in the comment of line 1, never used",
            ],
        ),
    ],
)
def test_the_last_lines(cell: Cell, name: str, text: str, status: int, notes: list[str]) -> None:
    cell.write(name, text)
    ran = cell("init", name, "--format", "none")
    found = [line.removeprefix("note: ") for line in ran.err.splitlines() if line.startswith("note: ")]
    assert (ran.status, found) == (status, notes)


def test_an_endless_run_ends_after_whole_cycles(cell: Cell) -> None:
    """The moves of the inner loop, and those of the homing, are no cycles."""
    pecks = "FOR s = 1 TO 3\nMOVER.0 = 5 : GO.0 : PAUSE IDLE.0\nNEXT\n"
    text = f"HOME.0 = 0 : PAUSE IDLE.0\nLOOP\n{pecks}MOVEA.0 = 0 : GO.0 : PAUSE IDLE.0\nWAIT = 40000\nENDL\n"
    found = guesses(cell, text)
    assert (found["run.stop.line"], found["run.stop.times"]) == (6, 8)


def test_a_scenario_that_exists_stays(cell: Cell) -> None:
    (cell.folder / "old.scenarios").mkdir()
    mine = cell.write("old.scenarios/choice-1.toml", "run.until = 1\n")
    guesses(cell, MENU)
    assert mine.read_text() == "run.until = 1\n"


def test_keys(cell: Cell) -> None:
    text = '#key\nK = INKEY\nIF K = 67 THEN ? "C" : GOTO key\nIF K <> 82 THEN GOTO key\n? "R"\n'
    assert [(each["text"], each["at"]) for each in guesses(cell, text)["key"]] == [  # type: ignore[attr-defined]
        ("C", 0.5),
        ("R", 1.0),
    ]


def test_a_home_switch_lies_a_second_ahead(cell: Cell) -> None:
    text = "SCALE.1 = 100\nSPEED.1 = 50 : HOMESPEED.1 = 20\nHOME.1 = 0\nPAUSE IDLE.1\n? POS.1\n"
    found = guesses(cell, text)
    assert (found["axis.1.home_switch"], found["axis.1.guess"]) == ([-22.0, -20.0], True)


def test_index_marks_are_guessed_for_a_search_of_a_mark(cell: Cell) -> None:
    found = guesses(cell, "1MN,1VM,1DI0,1SV1000,1SA9000,1GO,1FI0,1ST\n", "old.mccl")
    assert {key for key in found if key.startswith("axis.")} == {"axis.1.index_every", "axis.1.guess"}


def test_a_home_switch_is_guessed_after_a_move_too(cell: Cell) -> None:
    """The guess is based on the endless homing motion, to -20, not on the move before."""
    text = "SPEED.1 = 50 : HOMESPEED.1 = 20\nMOVER.1 = 5 : GO.1\nPAUSE IDLE.1\nHOME.1 = 0\nPAUSE IDLE.1\n"
    assert guesses(cell, text)["axis.1.home_switch"] == [-22.0, -20.0]


def test_a_result_says_what_it_depends_on(cell: Cell) -> None:
    cell.write("old.prg", 'INPUT "Way ", s\nPAUSE INX.2\nMOVER.0 = s : GO.0 : PAUSE IDLE.0\n? POS.0\n')
    ran = cell("init", "old.prg", "--format", "none")
    assert ran.out == "old.machine.toml: written, 2 guesses\nWay 10\n10\n"  # Mint v4 prints no zeros
    depends = "warning[guess]: this result depends on 2 guesses of the machine file: input 2; 1 answer"
    assert ran.err.splitlines()[0] == depends
    text = (cell.folder / "old.machine.toml").read_text()
    (cell.folder / "old.machine.toml").write_text(text.replace(", guess = true", ""))
    assert cell("run", "old.prg", "--format", "none").err == ""


@pytest.mark.parametrize(
    ("name", "text", "line"),
    [
        ("old.prg", "OUTX.1 = 0 : SPEED.0 = 5\nSPEED.0 = 6", '"mint4"    # line 1: OUTX.1; line 1: SPEED.0'),
        ("old.mnt", "Dim n As Integer\nSPEED(0) = 5", '"mintmt"    # line 1: As; line 2: SPEED(0)'),
        ("old.mnt", "PRINT 1", None),
        ("old.prg", "PRINT 1", '"mint4"    # the extension .prg'),
        ("old.mnt", "AUTO\n#GO\nPRINT 1", '"mint4"    # line 1: AUTO; line 2: #GO'),
        ("old.mnt", "AUTO\nSPEED.0 = 5\nLOCATE(1, 2)\nLINE(1)", '"mint4"    # line 2: SPEED.0'),
        ("old.prg", "Dim n As Integer\n#GO\nPRINT 1", '"mintmt"    # line 1: As'),
        ("old.mnt", "SPEED(0) = 5\nACCEL.0 = 5", None),
        ("old.mccl", "CF35,CN34", '"multiflex"    # line 1: CF35, and 33 to 48 are outputs at power-up'),
        ("old.mccl", "CN10", '"dcx-pci300"    # line 1: CN10, and 9 to 16 are outputs at power-up'),
        ("old.pc1", "1TP", '"dcx-pc100"    # the extension .pc1'),
        ("old.mccl", "CT3,CN3", None),
        ("old.mccl", "1TP", None),
    ],
)
def test_the_controller_is_that_of_the_notation(cell: Cell, name: str, text: str, line: str | None) -> None:
    guesses(cell, f"{text}\n", name)
    machine = (cell.folder / "old.machine.toml").read_text()
    found = [each for each in machine.splitlines() if each.startswith("controller.model")]
    assert found == ([f"controller.model = {line}"] if line else [])


@pytest.mark.parametrize(
    ("text", "others"),
    [
        ("CN10", "dcx-pci100, dcx-at200 and dcx-pc100 fit the program as well"),
        ("CN10\n8MN", "dcx-pci100 and dcx-pc100 fit the program as well"),
        ("CN10\n1PP", "dcx-at200 fits the program as well"),
    ],
)
def test_models_that_the_program_cannot_tell_apart_are_named(cell: Cell, text: str, others: str) -> None:
    cell.write("old.mccl", f"{text}\n")
    ran = cell("init", "old.mccl", "--format", "none")
    assert f"controller.model is dcx-pci300; {others}\n" in ran.out
    first, *_ = (cell.folder / "old.machine.toml").read_text().split("\n\n")[1:]
    assert [line.partition(" ")[0] for line in first.splitlines()] == ["controller.model", "#", "run.until"]
    assert f"# {others}\n" in first


def test_the_limits_are_there_to_fill_in(cell: Cell) -> None:
    text = "SPEED.0 = 100 : ACCEL.0 = 1000 : DECEL.0 = 1000\nMOVEA.0 = 50 : GO.0 : PAUSE IDLE.0\n"
    guesses(cell, text)
    file = cell.folder / "old.machine.toml"
    assert (
        "# limits.position = [0, 50]\n# limits.speed = 100\n# limits.acceleration = 1000\n"
        in file.read_text()
    )
    file.write_text(file.read_text().replace("# limits", "limits"))
    ran = cell("certify", "old.prg", "--format", "none")
    assert (ran.status, ran.err) == (0, "")


@pytest.mark.parametrize(
    ("moves", "limits"),
    [
        ("MOVEA.0 = 42.5 : GO.0", "[0, 42.5]"),
        ("MOVER.0 = 0.1 : GO.0 : PAUSE IDLE.0 : MOVER.0 = 0.2 : GO.0", "[0, 0.3]"),
        ("MOVEA.0 = 5 : GO.0 : PAUSE IDLE.0 : JOG.0 = -10 : WAIT = 777 : STOP.0", "[-3, 5]"),
        ("MOVEA.0 = 360 / 7 : GO.0", "[0, 51.4286]"),
    ],
)
def test_limits_have_the_decimal_places_of_the_commanded_positions(
    cell: Cell, moves: str, limits: str
) -> None:
    guesses(cell, f"SCALE.0 = 100\n{moves} : PAUSE IDLE.0\n")
    assert f"# limits.position = {limits}\n" in (cell.folder / "old.machine.toml").read_text()


def test_an_edge_is_not_found_by_an_axis_at_rest(cell: Cell) -> None:
    cell.write("old.mccl", "1MN,1FE0,1ST\n")
    ran = cell("init", "old.mccl", "--format", "none")
    assert (ran.status, ran.out) == (1, "old.machine.toml: written, 0 guesses\n")
    hint = "  hint: axis 1 does not move and never finds the edge: start it before the search\n"
    assert "error[never]: the program waits for the home switch of axis 1" in ran.err
    assert hint in ran.err


def test_a_machine_file_that_exists_stays(cell: Cell) -> None:
    machine = cell.write("old.machine.toml", "run.until = 5\n")
    cell.write("old.prg", "PRINT 1\n")
    ran = cell("init", "old.prg")
    assert ran.status == 1
    assert ran.err.startswith(
        "error[file]: old.machine.toml exists, and is not overwritten\n  hint: motionlang run old.prg"
    )
    assert machine.read_text() == "run.until = 5\n"


def test_errors_of_the_program_are_shown_as_by_check(cell: Cell) -> None:
    cell.write("bad.prg", "MOVR.0 = 1\nx = = 2\n")
    ran = cell("init", "bad.prg")
    assert (ran.status, ran.out) == (1, "")
    assert f"{ran.err}bad.prg: 2 errors\n" == cell("check", "bad.prg").out
    assert "  hint: did you mean MOVER?\n" in ran.err
    assert not (cell.folder / "bad.machine.toml").exists()


def test_the_scenarios_of_a_program_in_a_folder_are_next_to_it(cell: Cell) -> None:
    (cell.folder / "old").mkdir()
    cell.write("old/a.prg", MENU)
    ran = cell("init", "old", "--format", "none")
    assert ran.out.startswith(
        "old/a.machine.toml: written, 5 guesses\nold/a.scenarios: 2 scenarios written\n"
    )
    assert cell("init", "old/a.prg").status == 1
    (cell.folder / "b.prg").write_text(MENU)
    cell.write("b.scenarios", "")
    assert "error[file]: b.scenarios cannot be written: file exists" in cell("init", "b.prg").err


def test_a_folder(cell: Cell) -> None:
    (cell.folder / "old").mkdir()
    for name in ("a.prg", "b.mccl"):
        cell.write(f"old/{name}", "PAUSE INX.1\n" if name == "a.prg" else "WN1\n")
    ran = cell("init", "old", "--format", "none")
    assert [line.split(":")[0] for line in ran.out.splitlines()] == [
        "old/a.machine.toml",
        "old/b.machine.toml",
    ]


def test_a_person_is_asked(cell: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    """Enter accepts a guess; after an invalid line the question is repeated.

    At the end of input the remaining guesses are accepted.
    """

    class Terminal(io.StringIO):
        def isatty(self) -> bool:
            return True

    cell.write("old.prg", 'PAUSE INX.1\nPAUSE INX.2\nINPUT "Way ", s\nINPUT "Speed ", v\nPRINT TIME\n')
    monkeypatch.setattr(sys, "stdin", Terminal("\nsoon\n1@2\n7\n"))
    monkeypatch.setattr(sys.stdout, "isatty", lambda: True)
    ran = cell("init", "old.prg", "--format", "none")
    question = "input 2: { channel = 2, at = 0.6 }, or type 1@0.5 or out4+0.3: "
    assert f'{question}  "soon" is not a level of input 2: 0 or 1\n{question}' in ran.out
    found = read_machine(Source.read(str(cell.folder / "old.machine.toml")))
    assert found["input"] == [
        {"channel": 1, "at": 0.3, "guess": True},
        {"channel": 2, "value": 1, "at": 2.0},
    ]
    assert [each.get("guess") for each in found["answer"]] == [None, True]  # type: ignore[attr-defined]
