"""Guesses of a first machine file: the world that a program waits for."""

from __future__ import annotations

import pytest

from motionlang.commands.init import guessed
from motionlang.commands.worlds import Worlds
from motionlang.kernel import Source, dialect, run

# The program, its inputs in the guessed machine file, and when it ends. An input changes 0.3 s after the program
# waits for it; one that has to come and go is on from 1 s to 2 s, from 3 s to 4 s and so on.
PROGRAMS: dict[str, tuple[str, list[dict[str, object]], float]] = {
    "an input": ("PAUSE INX(3) = 1", [{"channel": 3, "at": 0.3}], 0.3),
    "an input that is as wanted": ("PAUSE INX(3) = 0", [], 0.0),
    "a loop": ("While INX(2) = 0\nWend", [{"channel": 2, "at": 0.3}], 0.3),
    "two inputs": (
        "PAUSE INX(3) = 1\nPAUSE INX(4) = 1", [{"channel": 3, "at": 0.3}, {"channel": 4, "at": 0.6}], 0.6,
    ),
    "one that comes and goes, and another one": (
        "PAUSE INX(3) = 1\nPAUSE INX(4) = 1\nPAUSE INX(3) = 0",
        [{"channel": 3, "at": 1.0, "for": 1.0, "every": 2.0}, {"channel": 4, "at": 0.6}],
        2.0,
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", PROGRAMS)
def test_an_input_changes_after_the_program_waits_for_it(name: str) -> None:
    text, inputs, time = PROGRAMS[name]
    source, mint = Source("wait.mnt", text + "\nPRINT 7\n"), dialect("mint")
    guesses, result = guessed(Worlds(mint.program(source, is_debug=True), mint), 5.0, {})
    assert (result.status, result.output) == ("ended", ["7"])
    assert guesses.settings(5.0).get("input", []) == inputs
    assert result.time == pytest.approx(time, abs=1e-3)


def answers(prompt: str, *texts: str) -> dict[str, object]:
    return {"answer": [{"prompt": prompt, "text": text} for text in texts]}


def on(channel: int, at: float) -> dict[str, object]:
    return {"channel": channel, "at": at}


def follows(channel: int, output: int) -> dict[str, object]:
    return {"channel": channel, "output": output, "delay": 0.3}


def pulses(channel: int) -> dict[str, object]:
    return {"channel": channel, "at": 1.0, "for": 1.0, "every": 2.0}


KEYS = "#key\nK = INKEY\nIF K <> 82 THEN GOTO key\n"
GUARD = "IF INX.2 = 0 THEN GOTO bad\n"
FAULT = "END\n#bad\n? 2\n"
FAR = [1e9, 2e9]
GO = "MOVER.0 = 10 : GO.0\n"
HALT, HALT0, HALTED = "IF INX.4 THEN GOTO HALT\n", "IF INX.4 = 0 THEN GOTO HALT\n", 'END\n#HALT\n? "HALT"\n'
STROKE = "MOVER.0 = 10 : GO.0 : PAUSE IDLE.0\n"
# The program, the settings that a person gave, all settings of the guessed machine file, the number of guesses,
# and how often the program runs. It runs up to 20 s, and once more than it gets guesses that it needs in turn.
DRAFTS: dict[str, tuple[str, dict[str, object], dict[str, object], int, int]] = {
    # The middle of the range, then 10, 1, 100, 1000 and 0.5; 5 has been tried. None is left.
    "a rejected answer": ('#a\nINPUT "Parts 3 to 8", n\nIF n <> 9 THEN GOTO a\n', {},
                          answers("Parts 3 to 8", "0.5"), 1, 7),
    "an answer that is rejected with a range": ('#a\nINPUT "Parts", n\nIF n <> 9 THEN ? "3 to 8" : GOTO a\n', {},
                                                answers("Parts", "0.5"), 1, 7),
    # 10 is rejected, 3 is the middle of 1 and 6, 7 that of 7 and 8.
    "two ranges": ('#a\nINPUT "Parts", n\nIF n <> 7 THEN ? "1 to 6 or 7..8" : GOTO a\n', {},
                   answers("Parts", "7"), 1, 4),
    "a question in each of 20 cycles": (
        'FOR i = 1 TO 20\nINPUT "Parts", n\nMOVER.0 = 1 : GO.0 : PAUSE IDLE.0\nNEXT\n', {},
        answers("Parts", *["10"] * 20), 20, 21,
    ),
    # Nobody answers the 21st question, so the run ends there.
    "a question in more than 20 cycles": (
        'LOOP\nINPUT "Parts", n\nMOVER.0 = 1 : GO.0 : PAUSE IDLE.0\nENDL\n', {},
        {"run.stop.event": "input", **answers("Parts", *["10"] * 20)}, 20, 22,
    ),
    # The output was set before the first answer: the second question is not one of another cycle.
    "two questions": ('OUTX.1 = 1\nINPUT "Parts", n\nINPUT "Holes", m\n', {},
                      {"answer": [*answers("Parts", "10")["answer"], *answers("Holes", "10")["answer"]]}, 2, 3),  # type: ignore[misc]
    # A key is pressed 0.5 s after the last act: after the move to 2 s, and after the input at 0.3 s.
    "a key after a move": (f"WAIT = 2000\nMOVER.0 = 5 : GO.0 : PAUSE IDLE.0\n{KEYS}", {},
                           {"key": [{"at": 2.5, "text": "R"}]}, 1, 2),
    "a key after an input": (f"PAUSE INX.3\n{KEYS}", {},
                             {"input": [on(3, 0.3)], "key": [{"at": 0.5, "text": "R"}]}, 2, 3),
    "a key that a person presses": (KEYS, {"key": [{"at": 30.0, "text": "R"}]},
                                    {"key": [{"at": 30.0, "text": "R"}]}, 0, 1),
    "any key": ("#key\nK = INKEY\nIF K = 0 THEN GOTO key\n", {}, {}, 0, 1),
    # It waits for a key if it has been quiet for more than 10 of the 20 s.
    "a key after 9.9 s": (f"WAIT = 9900\nOUTX.1 = 1\n{KEYS}", {}, {"key": [{"at": 10.4, "text": "R"}]}, 1, 2),
    "a key after 10.1 s": (f"WAIT = 10100\nMOVER.0 = 5 : GO.0 : PAUSE IDLE.0\n{KEYS}", {}, {}, 0, 1),
    # Homing at 4000 counts/s: the switch is a second ahead and a tenth long, the marks are a fifth apart.
    "a home switch": ("HOME.0 = 0\nPAUSE IDLE.0\n", {}, {"axis.0.home_switch": [-4400.0, -4000.0]}, 1, 2),
    "a home switch and an index mark": ("HOME.1 = 4\nPAUSE IDLE.1\n", {}, {
        "axis.1.home_switch": [-4400.0, -4000.0], "axis.1.index_every": 800.0}, 1, 3),
    # A person's switch is out of reach, so neither guess lets the homing end.
    "a switch out of reach": ("HOME.0 = 0\nPAUSE IDLE.0\n", {"axis.0.home_switch": FAR},
                              {"axis.0.home_switch": FAR, "axis.0.index_every": 800.0}, 1, 3),
    "an axis that never comes to rest": ("JOG.1 = 5\nPAUSE IDLE.1\n", {}, {}, 0, 1),
    "a guard": (f"{GUARD}? 1\n{FAULT}", {}, {"input": [on(2, 0.0)]}, 1, 1),
    "an input that is tested before it is waited for": (
        "IF INX.2 = 0 THEN ? 3\nPAUSE INX.2\nIF INX.3 = 0 THEN PAUSE INX.3\nPAUSE INX.4\nIF INX.4 = 0 THEN ? 3\n", {},
        {"input": [on(2, 0.0), on(3, 0.0), on(4, 0.3)]}, 3, 2),
    "a guard of an input that has to be off": (f"{GUARD}PAUSE INX.2 = 0\n? 1\n{FAULT}", {}, {}, 0, 1),
    "a guard, and another input that has to be off": (f"{GUARD}PAUSE INX.3 = 0\nPAUSE INX.2\n? 1\n{FAULT}", {},
                                                      {"input": [on(2, 0.0)]}, 1, 1),
    "a guard that a person knows": (f"{GUARD}? 1\n{FAULT}", {"input": [on(2, 1.0)]}, {"input": [on(2, 1.0)]}, 0, 1),
    "a guard, and an input that a person knows": (f"{GUARD}? 1\n{FAULT}", {"input": [on(3, 1.0)]},
                                                  {"input": [on(2, 0.0), on(3, 1.0)]}, 1, 1),
    "an input that a person knows": ("PAUSE INX.2\n", {"input": [on(2, 40.0)]}, {"input": [on(2, 40.0)]}, 0, 1),
    # First it follows the output, then it is on from 0.3 s, then it comes and goes.
    "all forms of an input": ("OUTX.4 = 1\nPAUSE INX.2\nPAUSE INX.2 = 0\nPAUSE INX.2\nPAUSE INX.2 = 0\n", {},
                              {"input": [pulses(2)]}, 1, 4),
    "an input after a move": ("OUTX.4 = 1\nMOVER.0 = 5 : GO.0 : PAUSE IDLE.0\nPAUSE INX.2\n", {},
                              {"input": [on(2, 0.3)]}, 1, 2),
    "an input shortly after an output": ("OUTX.4 = 1\nWAIT = 990\nPAUSE INX.2\n", {},
                                         {"input": [follows(2, 4)]}, 1, 2),
    "an input long after an output": ("OUTX.4 = 1\nWAIT = 1010\nPAUSE INX.2\n", {}, {"input": [on(2, 1.3)]}, 1, 2),
    "two inputs after an output": ("OUTX.4 = 1\nPAUSE INX.1\nPAUSE INX.2\n", {},
                                   {"input": [follows(1, 4), follows(2, 4)]}, 2, 3),
    "two inputs at once": ("PAUSE INX.1 AND INX.2\n", {}, {"input": [on(1, 0.3), on(2, 0.3)]}, 2, 2),
    # The run ends at 20 s.
    "inputs that are not reached": ("PAUSE INX.1\nWAIT = 30000\nPAUSE INX.2\n", {}, {"input": [on(1, 0.3)]}, 1, 2),
    "a level and an input at once": ("PAUSE ADC.2 > 60 AND INX.1\n", {}, {
        "input": [on(1, 0.3)], "analogue": [{"channel": 2, "value": 100.0, "at": 0.3}]}, 2, 3),
    "an input that a loop polls": (
        f"n = 0\nLOOP\nIF INX.1 DO\n{STROKE}n = n + 1\nENDIF\nIF n = 3 THEN EXIT\nENDL\n", {},
        {"input": [on(1, 0.3)]}, 1, 2),
    "two inputs that a loop polls together": (
        f"n = 0\nLOOP\nIF INX.1 AND INX.2 DO\n{STROKE}n = n + 1\nENDIF\nIF n = 3 THEN EXIT\nENDL\n", {},
        {"input": [on(1, 0.3), on(2, 0.3)]}, 2, 6),
    # Input 1 alone moves nothing; with it, input 2 is tested.
    "two inputs that a loop polls one after the other": (
        f"n = 0\nLOOP\nIF INX.1 DO\nIF INX.2 DO\n{STROKE}n = n + 1\nENDIF\nENDIF\nIF n = 3 THEN EXIT\nENDL\n", {},
        {"input": [on(1, 0.3), on(2, 0.3)]}, 2, 7),
    "inputs that a subroutine polls": (
        f"n = 0\nLOOP\nGOSUB SCAN\nIF s = 1 THEN {STROKE[:-1]} : n = n + 1\nIF n = 3 THEN EXIT\nENDL\nEND\n"
        "#SCAN\ns = 0\nIF INX.4 AND NOT INX.5 THEN s = 1\nRETURN\n", {}, {"input": [on(4, 0.3)]}, 1, 4),
    # Without it the loop ends after 0.5 s, and the program goes on.
    "an input that a loop of Gotos polls for a time": (
        "TIME = 0\n#TRY\nIF INX.2 THEN GOTO DONE\nIF TIME < 500 THEN GOTO TRY\n? \"EMPTY\"\nEND\n#DONE\n"
        f"{STROKE}", {}, {"input": [on(2, 0.3)]}, 1, 2),
    "an input whose event ends a wait": (
        f"STOPINPUT.0 = 2\n{STROKE}s = 0\nPAUSE s\n? 1\nEND\n#STOP\ns = 1\nRETURN\n", {},
        {"input": [on(2, 0.3)]}, 1, 2),
    # The stroke takes an edge, so the input that is on at 0.3 s does not repeat it.
    "an edge that a loop polls": (
        f"n = 0 : b = 0\nLOOP\na = INX.1\nIF a > b THEN {STROKE[:-1]} : n = n + 1\nb = a\nIF n = 3 THEN EXIT\nENDL\n",
        {}, {"input": [pulses(1)]}, 1, 3),
    # Input 4 calls the fault routine, which moves on one line; the cycle moves on two.
    "a start button beside a fault": (
        f"#MAIN\nIF INX.4 THEN GOSUB FAULT\nIF INX.1 THEN GOSUB CYCLE\nWAIT = 20\nGOTO MAIN\n"
        f"#CYCLE\n{STROKE}{STROKE}RETURN\n#FAULT\n{STROKE}PAUSE INX.7\nRETURN\n", {},
        {"input": [on(1, 0.3)]}, 1, 4),
    # A lamp that blinks is no work: the program waits for the start button all the same.
    "a loop that blinks": (f"LOOP\nOUTX.3 = 1 - OUTX.3\nWAIT = 500\nIF INX.1 THEN {STROKE}ENDL\n", {},
                           {"input": [on(1, 0.3)]}, 1, 2),
    "a level that a loop polls": (f"LOOP\nv = ADC.2\nIF v > 60 THEN {STROKE}ENDL\n", {},
                                  {"analogue": [{"channel": 2, "value": 100.0, "at": 0.3}]}, 1, 3),
    "a key that a loop polls": (f"LOOP\n? \"PRESS G\"\nWAIT = 500\nK = INKEY\nIF K = 71 THEN {STROKE}ENDL\n", {},
                                {"key": [{"at": 0.5, "text": "G"}]}, 1, 2),
    # Each of these leaves the work at the level 1 of input 4, or at 0, so it stays at the other one.
    "an input beside a position": (
        f"LOOP\n{GO}PAUSE POS.0 > 6 OR INX.4\n{HALT}PAUSE IDLE.0\nENDL\n{HALTED}", {}, {}, 0, 1),
    "an input beside the end of a move": (f"LOOP\n{GO}PAUSE IDLE.0 OR INX.4\n{HALT}ENDL\n{HALTED}", {}, {}, 0, 1),
    "an input beside a position in a loop": (
        f"LOOP\n{GO}REPEAT\nUNTIL POS.0 > 6 OR INX.4\n{HALT}PAUSE IDLE.0\nENDL\n{HALTED}", {}, {}, 0, 1),
    "an input beside a time": (
        f"LOOP\n{STROKE}TIME = 0\nPAUSE TIME > 500 OR INX.4\n{HALT}ENDL\n{HALTED}", {}, {}, 0, 1),
    "an input that is off beside the end of a move": (
        f"LOOP\n{GO}PAUSE IDLE.0 OR INX.4 = 0\n{HALT0}ENDL\n{HALTED}", {}, {"input": [on(4, 0.0)]}, 1, 1),
    "an input that is off beside a position in a loop": (
        f"LOOP\n{GO}REPEAT\nUNTIL POS.0 > 6 OR INX.4 = 0\n{HALT0}PAUSE IDLE.0\nENDL\n{HALTED}", {},
        {"input": [on(4, 0.0)]}, 1, 1),
    "an input that is off beside a time": (
        f"LOOP\n{STROKE}TIME = 0\nPAUSE TIME > 500 OR INX.4 = 0\n{HALT0}ENDL\n{HALTED}", {},
        {"input": [on(4, 0.0)]}, 1, 1),
    "a start and a stop button": (f"PAUSE INX.1 OR INX.4\n{HALT}{STROKE}{HALTED}", {}, {"input": [on(1, 0.3)]}, 1, 2),
    "a run switch": (f"WHILE INX.2 = 1\n{STROKE}ENDW\n", {}, {"input": [on(2, 0.0)]}, 1, 1),
    # On, and with pulses, fewer strokes are made, and no other line moves.
    "a stop switch": (f"WHILE INX.2 = 0\n{STROKE}ENDW\n", {}, {}, 0, 3),
    "a run switch of a loop that calls": (f"WHILE INX.2\nGOSUB A\nENDW\nEND\n#A\n{STROKE}RETURN\n", {},
                                          {"input": [on(2, 0.0)]}, 1, 1),
    # The steps end at the sensor, after which another line moves.
    "steps towards a sensor": (f"WHILE INX.3 = 0\n{STROKE}ENDW\nMOVEA.0 = 0 : GO.0 : PAUSE IDLE.0\n", {},
                               {"input": [on(3, 0.3)]}, 1, 2),
    # It must be on to go on, and leads elsewhere when it is off.
    "an input that is waited for and leaves the work": (
        f"LOOP\nIF INX.2 = 0 THEN GOTO HALT\nPAUSE INX.2\n{STROKE}ENDL\n{HALTED}", {}, {"input": [on(2, 0.0)]}, 1, 1),
    # The axis moves without it.
    "a jam that never comes": (
        f"LOOP\n{STROKE}IF INX.2 THEN GOSUB JAM\nWAIT = 500\nENDL\n#JAM\nOUTX.1 = 1\nPAUSE INX.7\nOUTX.1 = 0\nRETURN\n",
        {}, {}, 0, 1),
    # All five levels are tried.
    "a level out of reach": ("PAUSE ADC.2 > 101\n", {},
                             {"analogue": [{"channel": 2, "value": 75.0, "at": 0.3}]}, 1, 6),
    "a program with an error": ("PAUSE INX.1\nx = 1 / 0\n", {}, {}, 0, 1),
    # 0.3 s to the input, twice to 0.6 s for the levels of 50 and 100 %, 0.5 s to the key.
    "one of each": (
        f'PAUSE INX.1\nPAUSE ADC.2 > 60\nINPUT "Way", s\n{KEYS}HOME.1 = 4\nPAUSE IDLE.1\n', {},
        {"axis.1.home_switch": [-4400.0, -4000.0], "axis.1.index_every": 800.0, "input": [on(1, 0.3)],
         "analogue": [{"channel": 2, "value": 100.0, "at": 0.6}], **answers("Way", "10"),
         "key": [{"at": 1.1, "text": "R"}]}, 5, 8,
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", DRAFTS)
def test_the_draft_of_a_machine_file(name: str) -> None:
    text, fixed, settings, count, runs = DRAFTS[name]
    worlds = Worlds(
        dialect("mint").program(Source("old.prg", text), is_debug=True),
        dialect("mint"),
    )
    guesses, result = guessed(worlds, 20.0, fixed)
    assert guesses.settings(20.0) == {"run.until": 20.0, **settings}
    assert (guesses.count, worlds.count) == (count, runs)
    assert run(worlds.source, machine=guesses.settings(20.0)).output == result.output
