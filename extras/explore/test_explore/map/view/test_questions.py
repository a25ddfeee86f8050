"""Ten questions about each of six old programs, and where their maps answer them.

An answer is a list of texts that the map has; a line of the map is compared without regard to its blanks.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cases import cases
from tests.cli.programs import Cell

OLD = Path(__file__).parents[5] / "examples" / "old"
QUESTIONS = {
    "packer.prg": {
        "what is input 4?": ["input 4 row of product complete in 31"],
        "what must be there before it pushes?": [
            "waits in 31: PAUSE INX.4 [input 4 (row of product complete)] input 4 (row of product complete) on → 65",
            "axis 0 (pusher) to 250 at 600",
        ],
        "what is one cycle, and how long does it take?": [
            "5.0798 s, 17 times (lines 34 to 68)",
            "0.995 55 axis 0 (pusher) from 0 to 250 at 600 0.537",
        ],
        "which outputs does it switch off at the start?": ["output bank 0 out 93, 103"],
        "which inputs are the home switches?": ["input 8 in 91 HOMEINPUT(0)", "input 9 in 92 HOMEINPUT(1)"],
        "how far does the pusher go, and how fast?": [
            "axis 0 (pusher) to 250 at 600; axis 0 (pusher) to 0 at 1000"
        ],
        "which move depends on the operator?": ["moves MOVER = -ht computed 34", "ht variable 16 17, 34"],
        "what if the operator wants 10 layers?": [
            "'Layers per carton' 10 (or 100, 0.5) → the same question",
            "'1 to 6'; 'Layers per carton ?'",
        ],
        "how long does it eject?": [
            "input 1 (carton clamped) off → 70 called in 37, 0.40 s: output 2 (eject cylinder) on; output 2 (eject"
        ],
        "what was never seen?": ["98 98 STOP[0,1] line 98: if INX.2 = 0", "event ONERROR"],
    },
    "drill.prg": {
        "what starts a cycle?": [
            "waits in 29: PAUSE INX.0 AND INX.3 [input 0 (plate present), input 3 (cycle start button)]"
        ],
        "what is output 2?": ["output 2 coolant out 40, 51"],
        "how long may the clamp take?": ["by itself → the end, 2.02 s: 'CLAMP!'; output 0 (clamp) off"],
        "when does the spindle start?": ["input 1 (clamp closed) on → 39, 0.00 s: output 1 (spindle) on"],
        "what if the drill breaks?": ["input 6 (drill broken) on → the end"],
        "how far does the table turn for each hole?": ["moves MOVER = ang computed 48", "ang variable 25 48"],
        "at what speed does it drill?": ["axis 1 (spindle feed) to 44 at 8"],
        "in how many pecks?": ["to 44 at 8", "to 48 at 8", "from 47 to 52 at 8"],
        "how long does a plate take?": ["43.60 s: output 2 (coolant) on"],
        "what must happen before the next plate?": ["input 0 (plate present) off → 29"],
    },
    "pickplace.mccl": {
        "what must be true before it enters the press?": [
            "waits in 17 called in 40, 32: WN3 [input 3 (press open)] input 3 (press open) on → 17",
            "waits in 17 called in 40, 32: WN1 [input 1 (part in press)] input 1 (part in press) on → 19",
        ],
        "what is output 34?": ["output 34 blow off out"],
        "which axis is which?": ["axis 1 (X)", "axis 2 (Z)"],
        "where is the die?": [
            "axis 1 (X) from 0 to 900000 at 400000",
            "axis 2 (Z) from 0 to 120000 at 150000",
        ],
        "what if there is no vacuum?": [
            "waits in 19 called in 40, 32: IN2 [input 2 (vacuum ok)] by itself → 29",
            "output 36 (alarm) on; output 33 (vacuum) off; axis 2 (Z) to 0 at 150000; axis 1 (X) to 0 at 400000;",
        ],
        "after how many seconds does it give up?": [
            "→ 29 called in 40, 32 (WF5), 4.60 s: output 36 (alarm) on"
        ],
        "what ends the alarm?": ["input 5 (auto/manual) off → 29", "output 36 (alarm) off"],
        "how is Z homed?": ["homed and zeroed FE = 0 13", "axis 2 (Z) GO to -20200.2 at 20000"],
        "what does the machine wait for before it lowers on the belt?": [
            "waits in 25 called in 40, 32: WN4 [input 4 (belt free)]"
        ],
        "which register counts the parts?": [
            "30 register 27, 36 register 30 + 1 (27), 0 (36) 27",
            "27 prints 'part 6'",
        ],
    },
    "palletiser.prg": {
        "what is input 2?": ["input 2 GRIPPER SHUT in 74"],
        "what must be there before it fetches a bag?": [
            "waits in 41-45: KY = INKEY [a key, input 4 (STOP BUTTON), input 3 (AIR OK), input 1 (PALLET IN PLACE)]",
            "input 1 (PALLET IN PLACE) on → 41-45, 47",
            "input 0 (BAG AT PICK) on → 73, 74 called in 49, 1.45 s: axis 0 (X) to 0",
        ],
        "what does the key R do?": [
            "and key R → 41-45, 47, 0.00 s: output 1 (PALLET CLAMP) on; output 1 (PALLET CLAMP) off"
        ],
        "what if there is no air?": [
            "input 3 (AIR OK) off → 121, 0.00 s: output 3 (RED LAMP) on; 'NO AIR'",
            "input 3 (AIR OK) on → 41-45, 0.00 s: output 3 (RED LAMP) off",
        ],
        "what does the stop button stop?": [
            "input 4 (STOP BUTTON) on → 130, 0.00 s: output 2 (GREEN LAMP) off; output 3 (RED LAMP) on; 'STOPPED'"
        ],
        "what if the gripper does not shut?": [
            "'GRIPPER'; output 0 (GRIPPER) off; output 3 (RED LAMP) on; axis 2 (Z) to 0 at 400"
        ],
        "where does a bag go?": [
            "moves MOVEA = PX(IX) computed 92",
            "moves MOVEA = 710 - LA * 110 computed 96",
        ],
        "in what order does it home?": [
            "by itself → 28, 3.46 s: axis 2 (Z) HOME; axis 1 (Y) HOME; axis 0 (X) HOME",
        ],
        "when is the truck called?": ["output 4 (CALL TRUCK) on; 'PALLET 1 FULL'"],
        "what switches the red lamp?": ["output 3 RED LAMP out 80, 119, 122, 128, 131 1, 0"],
    },
    "pressfeed.mnt": {
        "what is input 2?": ["input 2 loop low in 41"],
        "who fills the loop of strip?": [
            "task StripLoop 38 program (62)",
            "uncoiler define OUTX(1) 42, 44, 142",
        ],
        "what must be there before the first stroke?": [
            "input 3 (start) on and input 4 (guard) on → 73, 0.00 s: output 2 (lampRun) on"
        ],
        "how long does a stroke take?": ["0.67079 s, 447 times (lines 75 to 90)"],
        "what does the press wait for after it has fed?": [
            "axis 0 (feed roll) to 10 at 282.843; output 0 (clutch) on waits in 82: Pause Not INX(0) [input 0 (top dead"
        ],
        "what follows the stroke?": [
            "input 1 (pilot release) on → 73, 0.06 s: output 5 (blower) on; output 5 (blower) off; 'stroke 1 after"
        ],
        "which handlers are there?": ["event IN4 124 input 4", "event IN6 133 input 6"],
        "how far does it feed, and how fast?": [
            "moves MOVER = pitch computed 75",
            "speeds and rates SPEED = 900 35, 103",
        ],
        "what closes the press?": ["output 0 clutch out 81, 83, 109, 127, 134, 141 1, 0"],
        "which pitches may the operator choose?": [
            "55 55 pitch = 5 line 55: if pitch < 5",
            "56 56 pitch = 250 line 56: if pitch > 250",
        ],
    },
    "dispenser.mccl": {
        "what is input 5?": ["input 5 cartridge empty in"],
        "what does it wait for between parts?": [
            "waits in 23 called in 60: IN4 [input 4 (two hand start)] input 4 (two hand start) on → 23, 24"
        ],
        "what if no fixture is loaded?": [
            "waits in 23, 24 called in 60: IN4",
            "input 1 (fixture loaded) on → 27",
        ],
        "which register has the shot?": ["24 shot register 52 1000 (52) 33", "moves MR = @24 computed 33"],
        "after how long is the lock a fault?": [
            "by itself → 39 called in 60, 2.00 s: output 35 (fault lamp) on; 'table lock'"
        ],
        "what if there is no pressure?": [
            "output 35 (fault lamp) on; 'pressure'",
            "waits in 41 called in 60: WN3 [input 3 (pressure ok)]",
        ],
        "what happens when the cartridge is empty?": [
            "macro 92 43 macro 33 (36)",
            "'part 1'; output 35 (fault lamp) on; 'change cartridge'",
        ],
        "which macro is never used?": ["macro 99 48 old test of the lamps never reached"],
        "which axis is the pump?": ["axis 3 (pump)"],
        "how does it keep the needle from dripping?": [
            "draw back half a turn so that it does not drip, then up",
            "35 axis 3 (pump) from 11000 to 10800 at 800",
        ],
    },
}


@pytest.mark.slow
@cases("program", QUESTIONS)
def test_the_map_answers(program: str, cell: Cell) -> None:
    shown = " ".join(cell("map", str(OLD / program), "--all").out.split())
    asked = QUESTIONS[program]
    assert [question for question in asked if not all(each in shown for each in asked[question])] == []


def test_there_are_ten_questions_about_each_program() -> None:
    assert [len(asked) for asked in QUESTIONS.values()] == [10] * 6
