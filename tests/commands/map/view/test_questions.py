"""Ten questions about each of three old programs, and where their maps answer them.

An answer is a list of texts that the map has; a line of the map is compared without regard to its blanks.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from motionlang.commands.map.program_map import mapped
from motionlang.commands.map.view.text import render

OLD = Path(__file__).parents[4] / "examples" / "old"
QUESTIONS = {
    "packer.prg": {
        "what is input 4?": ["input 4 row of product complete in 31"],
        "what must be there before it pushes?": [
            "31 PAUSE INX.4 [waits for input 4 (row of product complete)] -> 32 GOSUB PUSH"
        ],
        "what happens when the guard opens?": [
            "event IN2 97 input 2",
            "if INX.2 = 0: (STOP[0,1]; OUTX.3 = 1); -> return",
        ],
        "which outputs does it switch off at the start?": ["output bank 0 out 93, 103"],
        "which inputs are the home switches?": ["input 8 in 91 HOMEINPUT(0)", "input 9 in 92 HOMEINPUT(1)"],
        "how far does the pusher go, and how fast?": [
            "moves MOVEA = 250 55",
            "speeds and rates SPEED = 600 54, 88",
            "speeds and rates SPEED = 1000 58",
        ],
        "which move depends on the operator?": ["moves MOVER = -ht computed 34", "ht variable 16 17, 34"],
        "what if the operator wants 7 layers?": [
            'if nl < 1 OR nl > 6: ? "1 to 6"; -> 14 INPUT "Layers per carton ? ", nl'
        ],
        "how long does it eject?": ["OUTX.2 = 1; -> 67 WAIT = 400", "OUTX.2 = 0; -> 70 PAUSE INX.0 = 0"],
        "what does an error do?": ['? "ERROR ",ERR," LINE ",ERL; OUT.0 = 8; -> end'],
    },
    "drill.prg": {
        "what starts a cycle?": [
            "29 PAUSE INX.0 AND INX.3 [waits for input 0 (plate present), input 3 (cycle start button)]"
        ],
        "what is output 2?": ["output 2 coolant out 40, 51"],
        "how long may the clamp take?": ['if TM > 200: ? "CLAMP!"; OUT.0 = 0;', "35 WAIT = 10"],
        "when does the spindle start?": [
            "TIME = 0; OUTX.0 = 1; TM = 0; unless INX.1 = 0: OUTX.1 = 1; -> 39 PAUSE INX.2"
        ],
        "what if the drill breaks?": ['if INX.6: bad = bad + 1; ? "DRILL BROKEN, HOLE "'],
        "how far does the table turn for each hole?": ["moves MOVER = ang computed 48", "ang variable 25 48"],
        "at what speed does it drill?": ["speeds and rates SPEED = 8 68"],
        "in how many pecks?": ["D = 40; if S in 1 To 3: D = D + 4; SPEED.1 = 8; MOVEA.1 = D;"],
        "what is counted?": ["parts variable 14, 56 56, 58", "bad variable 15, 47 47"],
        "what must happen before the next plate?": ["60 PAUSE INX.0 = 0 [waits for input 0 (plate present)]"],
    },
    "pickplace.mccl": {
        "what must be true before it enters the press?": [
            "17 WN3 [waits for input 3 (press open) to be on]",
            "17 WN1 [waits for input 1 (part in press) to be on]",
        ],
        "what is output 34?": ["output 34 blow off out"],
        "which axis is which?": ["axis 1 (X 2000 counts/mm)", "axis 2 (Z 1000 counts/mm)"],
        "where is the die?": ["moves MA = 900000", "moves MA = 120000"],
        "what if there is no vacuum?": ["CF33; -> 19 WA0.2", "CN33; -> 19 WA0.4"],
        "after how many tries does it give up?": [
            "MJ11; unless channel 2 on: RA31; AA1; AR31; if accumulator > 2: MJ12; -> goes on in macro 12"
        ],
        "what ends the alarm?": ["29 WF5 [waits for input 5 (auto/manual (1 = auto)) to be off]"],
        "how is Z homed?": ["homed and zeroed FE = 0 13", "speeds and rates SV = 20000 13"],
        "what does the machine wait for before it lowers on the belt?": [
            "25 WN4 [waits for input 4 (belt free) to be on]"
        ],
        "which register counts the parts?": [
            "30 register 27, 36 27",
            'RA30; AA1; AR30; FT"part %d"; -> return',
        ],
    },
}


@pytest.mark.parametrize(
    ("program", "question"),
    [(program, question) for program, asked in QUESTIONS.items() for question in asked],
)
def test_the_map_answers(program: str, question: str) -> None:
    shown = " ".join(render(mapped(str(OLD / program)), width=200).split())
    for answer in QUESTIONS[program][question]:
        assert answer in shown


def test_there_are_ten_questions_about_each_program() -> None:
    assert [len(asked) for asked in QUESTIONS.values()] == [10, 10, 10]
