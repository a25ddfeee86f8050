"""`motionlang init` writes a first machine file, in which each guess is marked."""

from __future__ import annotations

import io
import sys
from math import inf

import pytest

from motionlang.kernel import Source, read_machine
from motionlang_explore.init import slug
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


def program(text: str) -> str:
    """Return a program in Mint v4 after usual rates."""
    return f"SPEED.0 = 100 : ACCEL.0 = 1000 : DECEL.0 = 1000\n{text}"


STROKE = "MOVER.0 = 10 : GO.0 : PAUSE IDLE.0\n"


def test_an_input_that_may_always_be_on_is_on_from_the_start(cell: Cell) -> None:
    assert inputs(cell, "WAIT = 700\nPAUSE INX.2\n") == [{"channel": 2, "at": 0.0}]


def test_an_input_that_comes_after_an_output_and_goes_follows_it(cell: Cell) -> None:
    """A start button is pressed and released when the program asks for it."""
    text = (
        f"LOOP\nPAUSE INX.2\nOUTX.4 = 1\nPAUSE INX.1\n{STROKE}"
        f"OUTX.4 = 0\nPAUSE INX.1 = 0\n{STROKE}PAUSE INX.2 = 0\nENDL\n"
    )
    assert inputs(cell, program(text)) == [
        {"channel": 1, "output": 4, "delay": 0.3},
        {"channel": 2, "asked": 0.3},
    ]


def test_a_program_without_motion_does_all_that_it_can(cell: Cell) -> None:
    text = "OUTX.4 = 1\nPAUSE INX.2\nOUTX.4 = 0\nPAUSE INX.2 = 0\nOUTX.5 = 1\nOUTX.5 = 0\nPAUSE INX.3\n"
    assert inputs(cell, text) == [
        {"channel": 2, "output": 4, "delay": 0.3},
        {"channel": 3, "at": 0.0},
    ]


@pytest.mark.slow
def test_two_values_of_a_bank_come_in_turn(cell: Cell) -> None:
    found = inputs(cell, "PAUSE IN = 5\nPAUSE IN = 10\n? TIME\n")
    assert found == [
        {"channel": 0, "asked": 0.3},
        {"channel": 1, "at": 0.6},
        {"channel": 2, "asked": 0.3},
        {"channel": 3, "at": 0.6},
    ]
    assert cell("run", "old.prg", "--format", "none").out == "600\n"


def test_an_endless_wait_stays_an_error(cell: Cell) -> None:
    """The time limit that init writes does not hide it, and no expectation certifies it."""
    cell.write("old.mnt", "JOG(0) = 5\nPAUSE IDLE(0)\n")
    for command in ("init", "run"):
        ran = cell(command, "old.mnt", "--format", "none")
        assert ran.status == 1
        assert "error[never]: the program waits until IDLE(0), which can never happen" in ran.err
    assert "\n[[expect]]" not in (cell.folder / "old.machine.toml").read_text()


def test_an_input_that_only_a_handler_tests_is_on(cell: Cell) -> None:
    text = "PAUSE INX(2)\nPAUSE INX(1)\nEND\nEvent IN3\nIF INX(2) = 0 THEN PRINT 7\nEnd Event\n"
    assert inputs(cell, text, "old.mnt") == [{"channel": 1, "at": 0.0}, {"channel": 2, "at": 0.0}]


def test_an_input_that_leads_to_a_fault_stays_off(cell: Cell) -> None:
    """In a guard the machine stops with input 2 off or input 3 on."""
    guard = "IF INX.2 = 0 THEN GOTO bad\nIF INX.3 THEN GOTO bad\n"
    text = f'LOOP\n{guard}PAUSE INX.1\n{STROKE}PAUSE INX.1 = 0\nENDL\n#bad\n? "bad"\n'
    found = inputs(cell, program(text))
    assert {"channel": 2, "at": 0.0} in found
    assert 3 not in [each["channel"] for each in found]


@pytest.mark.slow
def test_a_stop_button_of_a_task_beside_the_cycle_stays_off(cell: Cell) -> None:
    guard = "Loop\nIf INX(6) Then\nSTOP(0)\nOUTX(3) = 1\nPAUSE Not INX(6)\nEnd If\nWAIT(10)\nEnd Loop\n"
    work = (
        "Run Guard\nLoop\nPAUSE INX(1)\nMOVER(0) = 40 : GO(0) : PAUSE IDLE(0)\nPAUSE Not INX(1)\nEnd Loop\n"
    )
    found = inputs(cell, f"{work}Task Guard\n{guard}End Task\n", "old.mnt")
    assert found == [{"channel": 1, "asked": 0.3}]


ONCE = "SPEED(0) = 50 : ACCEL(0) = 500 : DECEL(0) = 500\n"
HALT = "MOVER(0) = 120 : GO(0)\nPause IDLE(0) Or INX(3)\nIf INX(3) Then STOP(0)\nPause IDLE(0)\n"
EARLY = "JOG(0) = 30\nWhile POS(0) < 70 And Not INX(3)\nEnd While\nSTOP(0)\nPause IDLE(0)\n"
PAIR = 'If INX(1) And Not INX(3) And INX(5) Then ? "pair"\nMOVER(0) = 10 : GO(0) : Pause IDLE(0)\n'


@pytest.mark.parametrize("text", [HALT, EARLY, PAIR], ids=["halt", "early", "pair"])
def test_what_the_work_of_a_program_that_runs_once_does_not_need_is_off(cell: Cell, text: str) -> None:
    assert inputs(cell, ONCE + text, "old.mnt") == []


def test_a_sensor_that_ends_a_jog_comes_in_the_jog(cell: Cell) -> None:
    text = f"{ONCE}JOG(0) = 40\nPause INX(2)\nSTOP(0)\nPause IDLE(0)\n"
    assert inputs(cell, text, "old.mnt") == [{"channel": 2, "at": 0.3}]


def test_a_question_how_many_gets_a_small_answer(cell: Cell) -> None:
    piece = 'MOVER.0 = 20 : GO.0 : PAUSE IDLE.0\n? "PIECE ", i\n'
    found = guesses(cell, f'INPUT "how many ", n\nFOR i = 1 TO n\n{piece}NEXT\n? "READY"\nEND\n')
    assert [each["text"] for each in found["answer"]] == ["1"]  # type: ignore[attr-defined]
    assert cell("run", "old.prg", "--format", "none").out.endswith("READY\n")


UNUSED = f"LOOP\nPAUSE INX.1\n{STROKE}PAUSE INX.1 = 0\nIF INX.2 THEN OUTX.6 = 1\nENDL\n"


def test_an_input_that_the_cycle_does_not_need_is_a_comment_with_its_effect(cell: Cell) -> None:
    guesses(cell, program(UNUSED))
    machine = (cell.folder / "old.machine.toml").read_text()
    assert "  # { channel = 2, at = 0.0 },    # line 5, with input 1 off: output 6 on\n" in machine


def test_unknown_channels_and_labels_of_inputs_are_named(cell: Cell) -> None:
    """A label of v4 reads its input, and a channel may be known only while the program runs."""
    text = "n = 5\nIF INX(n) THEN ? 1\nEND\n#IN3\n? 3\nRETURN\n"
    guesses(cell, text)
    machine = (cell.folder / "old.machine.toml").read_text()
    assert "  # line 4: #IN3\n  # { channel = 3" in machine
    assert "known while the program runs.\n# line 2: IF INX(n) THEN ? 1\n" in machine
    ran = cell("run", "old.prg", "--input", "3=1@0.5", "--until", "1", "--format", "none")
    assert ran.status == 0


@pytest.mark.parametrize(
    ("condition", "value"), [("ADC.2 > 60", 62.0), ("ADC.2 < 0 - 5 OR ADC.2 > 30", 32.0)]
)
def test_an_analogue_input_gets_a_level_from_the_comparison(cell: Cell, condition: str, value: float) -> None:
    found: list[dict[str, object]] = guesses(cell, program(f"PAUSE {condition}\n{STROKE}"))["analogue"]  # type: ignore[assignment]
    assert [(each["channel"], each["value"]) for each in found] == [(2, value)]


def test_a_macro_that_polls_an_input_and_calls_one_that_waits(cell: Cell) -> None:
    text = "MD1,CN34,WN6,1MR45,1WS.05,CF34,WF6\nMD2,IN2,MC1,NO,WA.02,MJ2\n1MN\nMC2\n"
    assert inputs(cell, text, "old.mccl") == [
        {"channel": 2, "at": 0.0},
        {"channel": 6, "output": 34, "delay": 0.3},
    ]


def test_a_macro_that_begins_again_without_an_input(cell: Cell) -> None:
    text = "MD1,IF2,MJ1,NO,1MR10,1WS.1\n1MN\nMC1\n"
    assert inputs(cell, text, "old.mccl") == [{"channel": 2, "at": 0.0}]


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
        ('LINE 1,"MENU"\nLINE 2,"HOLES"\nINPUT n\n', [("HOLES", "10")]),
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


def test_each_choice_of_a_menu_that_moves_an_axis_is_a_scenario(cell: Cell) -> None:
    found = guesses(cell, MENU)
    assert found["run.stop.event"] == "input"
    folder = cell.folder / "old.scenarios"
    assert sorted(path.name for path in folder.iterdir()) == ["choice-1.toml", "choice-3-1.toml"]
    text = (folder / "choice-1.toml").read_text()
    assert text.startswith(
        '# "Choice" 1: a path through the menus of old.prg, written by motionlang init. It adds to the\n'
        "# machine file next to the program. docs/scenarios.md explains scenarios.\n"
    )
    assert '  { prompt = "Choice", text = "1", guess = true },\n' in text
    assert cell("verify", "old.prg").out.endswith("2 of 2 scenarios pass\n")


PIECE = program(f"LOOP\nPAUSE INX.1\n{STROKE}PAUSE INX.1 = 0\nENDL\n")


@pytest.mark.parametrize(
    ("name", "text", "status", "notes"),
    [
        (
            "old.prg",
            PIECE,
            0,
            ["input 1 leads on from lines 3, 5", "cycle: 0.80005 s, 374 times (line 4), cycle(4)"],
        ),
        ("old.prg", "? 1\n", 0, []),
        (
            "old.prg",
            "PAUSE INKEY = 13\nPAUSE INKEY = 999\nMOVER.0 = 5 : GO.0\n",
            1,
            [
                "no axis moved, and line 3 commands motion",
                "waits in line 2 for a key; tried 0 to 9, Enter",
            ],
        ),
        (
            "old.prg",
            f"REM IN 3 knife up  IN 4 part\n{STROKE}PAUSE INX.4\n",
            0,
            [
                "input 4 leads on from line 3",
                "input 3 (knife up): named in the comment of line 1, never used",
            ],
        ),
        (
            "old.prg",
            f"REM IN 3 size 1  4 size 2  5 part\nPAUSE INX.5\nIF (IN.0 & 24) = 24 THEN {STROKE}",
            0,
            ["input 5 leads on from line 2"],
        ),
        (
            "old.prg",
            f"REM IN 0 jog  OUT 2 fault\nLOOP\nPAUSE INX.0\nOUTX.2 = 1\n{STROKE}OUTX.2 = 0\nPAUSE INX.0 = 0\nENDL\n",
            1,
            [
                "input 0 leads on from lines 3, 7",
                "cycle: 0.62007 s, 484 times (lines 4 to 6), cycle(5)",
                "no good piece was found: the best cycle switches on output 2, an alarm by its name",
                "to find by hand what leads there: motionlang panel old.prg; or correct an entry, remove its "
                "guess = true, and let motionlang init old.prg --update search the rest",
            ],
        ),
        (
            "old.prg",
            f"k = 0\nLOOP\nPAUSE INX.0\n{STROKE}IF k = 3 THEN OUTX.1 = 1 : OUTX.2 = 1\nPAUSE INX.0 = 0\nENDL\n",
            1,
            [
                "input 0 leads on from lines 3, 6",
                "outputs 1, 2 were never switched on",
                "cycle: 0.62006 s, 483 times (line 4), cycle(4)",
                "no good piece was found: the best cycle switches no output",
                "to find by hand what leads there: motionlang panel old.prg; or correct an entry, remove its "
                "guess = true, and let motionlang init old.prg --update search the rest",
            ],
        ),
        (
            "old.mnt",
            "Loop\nPause INX(0)\nMOVER(0) = 10 : GO(0) : Pause IDLE(0)\n"
            'If INX(1) Then Print "part" Else Print 5.0; " thrown out"\nPause INX(0) = 0\nEnd Loop\n',
            0,
            [
                "input 0 leads on from lines 2, 5",
                "cycle: 0.62007 s, 484 times (lines 3 to 4), cycle(print part)",
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
    assert (found["run.stop.line"], found["run.stop.times"]) == (6, 7)


def test_a_scenario_that_exists_stays(cell: Cell) -> None:
    (cell.folder / "old.scenarios").mkdir()
    mine = cell.write("old.scenarios/choice-1.toml", "run.until = 1\n")
    guesses(cell, MENU)
    assert mine.read_text() == "run.until = 1\n"


def test_a_key_that_leads_on(cell: Cell) -> None:
    text = "#key\nK = INKEY\nIF K <> 82 THEN GOTO key\nMOVER.0 = 5 : GO.0 : PAUSE IDLE.0\n"
    assert [each["text"] for each in guesses(cell, text)["key"]] == ["R"]  # type: ignore[attr-defined]


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


TWO = program(f"""\
LOOP
PAUSE INX.1 OR INX.2
IF INX.1 THEN GOSUB A
IF INX.2 THEN GOSUB B
ENDL
#A
{STROKE * 2}PAUSE INX.1 = 0
RETURN
#B
MOVEA.0 = -5 : GO.0 : PAUSE IDLE.0
PAUSE INX.2 = 0
RETURN
""")


@pytest.mark.parametrize(
    ("words", "cycles"),
    [
        (
            [],
            ["cycle: 3 → 10, input 1, axis 0, ", "--cycle 2: 3 → 10 → 14, inputs 1 and 2, axis 0, ",
             "--cycle 3: 3 → 14, input 2, axis 0, "],
        ),
        (
            ["--cycle", "2"],
            ["cycle: 3 → 10 → 14, inputs 1 and 2, axis 0, ", "--cycle 1: 3 → 10, input 1, axis 0, ",
             "--cycle 3: 3 → 14, input 2, axis 0, "],
        ),
    ],
)  # fmt: skip
def test_the_head_names_the_cycle_and_the_next_two(cell: Cell, words: list[str], cycles: list[str]) -> None:
    cell.write("old.prg", TWO)
    cell("init", "old.prg", "--format", "none", *words)
    head = (cell.folder / "old.machine.toml").read_text().split("\n\n")[0]
    found = [line.lstrip("# ") for line in head.splitlines() if "cycle" in line]
    assert len(found) == 3
    assert all(line.startswith(start) for line, start in zip(found, cycles, strict=True)), found


def test_a_cycle_that_is_not_there(cell: Cell) -> None:
    cell.write("old.prg", TWO)
    ran = cell("init", "old.prg", "--cycle", "9")
    assert (ran.status, ran.err.splitlines()[0]) == (2, "motionlang init: error: --cycle 9: 3 cycles found")
    assert not (cell.folder / "old.machine.toml").exists()


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
    written = [line for line in ran.out.splitlines() if line.endswith(" written") or "written, " in line]
    assert [line.split(":")[0] for line in written] == ["old/a.machine.toml", "old/a.scenarios"]
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


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


@pytest.mark.parametrize(("typed", "cycle"), [("9\n2\n", "3 → 10 → 14"), ("9\n\n", "3 → 10, input 1")])
def test_a_person_chooses_the_cycle(
    cell: Cell, monkeypatch: pytest.MonkeyPatch, typed: str, cycle: str
) -> None:
    cell.write("old.prg", TWO)
    monkeypatch.setattr(sys, "stdin", Terminal(typed))
    monkeypatch.setattr(sys.stdout, "isatty", lambda: True)
    question = "Which is the cycle? Enter for the likeliest that repeats: "
    assert (
        f"{question}  type a number from 1 to 3\n{question}"
        in cell("init", "old.prg", "--format", "none").out
    )
    assert f"\n# cycle: {cycle}, " in (cell.folder / "old.machine.toml").read_text()


def test_a_person_is_asked(cell: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    """Enter accepts a guess; after an invalid line the question is repeated.

    At the end of input the remaining guesses are accepted.
    """
    cell.write("old.prg", 'PAUSE INX.1\nPAUSE INX.2\nINPUT "Way ", s\nINPUT "Speed ", v\nPRINT TIME\n')
    monkeypatch.setattr(sys, "stdin", Terminal("\nsoon\n1@2\n7\n"))
    monkeypatch.setattr(sys.stdout, "isatty", lambda: True)
    ran = cell("init", "old.prg", "--format", "none")
    question = "input 2: { channel = 2, at = 0.0 }, or type 1@0.5 or out4+0.3: "
    assert f'{question}  "soon" is not a level of input 2: 0 or 1\n{question}' in ran.out
    found = read_machine(Source.read(str(cell.folder / "old.machine.toml")))
    assert found["input"] == [
        {"channel": 1, "at": 0.0, "guess": True},
        {"channel": 2, "value": 1, "at": 2.0},
    ]
    assert [each.get("guess") for each in found["answer"]] == [None, True]  # type: ignore[attr-defined]


def test_a_machine_that_only_rejects_is_no_success(cell: Cell) -> None:
    """Nothing in the world makes a good piece: the sum of the count never comes to 3."""
    cell.write(
        "old.mnt",
        "Dim k As Integer\nLoop\nPause INX(1)\nMOVER(0) = 5 : GO(0) : Pause IDLE(0)\n"
        'If k = 3 Then Print "part" : OUTX(3) = 1\nPrint "reject"\nPause INX(1) = 0\nEnd Loop\n',
    )
    ran = cell("init", "old.mnt", "--format", "none")
    assert ran.status == 1
    assert ran.err.endswith(
        "note: no good piece was found: the best cycle prints 'reject'\n"
        'note: not reached: line 5, Print "part" (line 5: if k = 3)\n'
        "note: to find by hand what leads there: motionlang panel old.mnt; or correct an entry, that of input 1 "
        "first, remove its guess = true, and let motionlang init old.mnt --update search the rest\n"
    )
    assert cell("verify", "old.mnt").status == 0
    line = cell("map", "old.mnt").out.splitlines()[3]
    assert line.startswith("no good piece was found; the best cycle prints 'reject': ")


def test_what_a_task_says_that_leads_another_one_counts(cell: Cell) -> None:
    """It moves nothing and waits for no more than time, but another task waits for what it sets."""
    cell.write(
        "old.mnt",
        """\
Dim asked As Integer, done As Integer, waiting As Integer
Run Spindle
Loop
  If INX(1) And Not waiting Then done = 0 : waiting = 1 : asked = 1
  If waiting And done Then waiting = 0 : Print "lens scrapped"
  Wait(10)
End Loop
Task Spindle
  Loop
    Pause asked
    asked = 0
    MOVER(0) = 20 : GO(0) : Pause IDLE(0)
    done = 1
  End Loop
End Task
""",
    )
    ran = cell("init", "old.mnt", "--format", "none")
    assert "note: no good piece was found: the best cycle prints 'lens scrapped'\n" in ran.err
    assert ran.status == 1


def test_a_silent_machine_that_soon_stands_still_makes_no_piece(cell: Cell) -> None:
    cell.write("old.mnt", "Loop\nPause INX(1)\nMOVER(0) = 5 : GO(0)\nPause ADC(1) > 200\nEnd Loop\n")
    ran = cell("init", "old.mnt", "--format", "none")
    assert "note: no good piece was found: the best cycle begins no move after 0.3 s\n" in ran.err
    assert ran.status == 1


def test_a_hyphen_of_a_word_is_no_minus() -> None:
    assert [slug(each) for each in ("-", "answer -5", "re-load part", "stop +")] == [
        "minus", "answer-minus-5", "re-load-part", "stop-plus"
    ]  # fmt: skip


def test_the_head_numbers_the_cycles_as_the_option_does(cell: Cell) -> None:
    cut = "MOVER.0 = 100 : GO.0 : WAIT = 500 : STOP.0 : PAUSE IDLE.0 : PAUSE NOT INX.3"
    lamp = 'OUTX.1 = 1 : PRINT "flushed" : PAUSE NOT INX.2 : OUTX.1 = 0'
    piece = f"IF INX.1 THEN {STROKE.strip()} : PAUSE NOT INX.1"
    guesses(cell, program(f"LOOP\n{piece}\nIF INX.2 THEN {lamp}\nIF INX.3 THEN {cut}\nENDL\n"))
    assert "#   --cycle 3: 3 → 5, input 3, axis 0" in (cell.folder / "old.machine.toml").read_text()


def test_an_infinite_acceleration_is_no_figure_to_fill_in(
    cell: Cell, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(
        "motionlang_explore.init.file._figure", lambda name, run: inf if "accel" in name else 1.0
    )
    guesses(cell, PIECE)
    shown = (cell.folder / "old.machine.toml").read_text()
    assert ("# limits.speed = 1\n" in shown, "limits.acceleration" in shown) == (True, False)
