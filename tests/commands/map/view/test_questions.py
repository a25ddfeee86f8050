"""Ten questions about each of six old programs, and where their maps answer them.

An answer is a list of texts that the map has; a line of the map is compared without regard to its blanks.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.programs import Cell

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
    "palletiser.prg": {
        "what is input 2?": ["input 2 GRIPPER SHUT in 74"],
        "what must be there before it fetches a bag?": [
            "41 KY = INKEY [waits for input 0 (BAG AT PICK), input 1 (PALLET IN PLACE), input 3 (AIR OK), "
            "input 4 (STOP BUTTON), key 0 ('R')]"
        ],
        "what does the key R do?": [
            "if KY = 82 ('R'): NB = 0; LA = 1; OUTX.1 = 0; OUTX.4 = 0; -> 41 KY = INKEY",
        ],
        "what if there is no air?": [
            'OUTX.3 = 1; ? "NO AIR"; -> 121 PAUSE INX.3',
            "OUTX.3 = 0; -> 41 KY = INKEY",
        ],
        "what does the stop button stop?": [
            'STOP[0,1,2]; OUTX.2 = 0; OUTX.3 = 1; ? "STOPPED"; -> 130 PAUSE INX.4 = 0'
        ],
        "what if the gripper does not shut?": [
            'meanwhile if TIME - TM0 > 1500: (? "GRIPPER"; OUTX.0 = 0; OUTX.3 = 1; BAD = 1'
        ],
        "where does a bag go?": [
            "moves MOVEA = PX(IX) computed 92",
            "moves MOVEA = 710 - LA * 110 computed 96",
        ],
        "in what order does it home?": ["HOME.2 = 0; -> 139 PAUSE IDLE.2", "HOME.1 = 0; -> 141 PAUSE IDLE.1"],
        "when is the truck called?": ["NB = 0; LA = LA + 1; unless LA <= LY: -> 57 GOSUB TRUCK"],
        "what switches the red lamp?": ["output 3 RED LAMP out 80, 119, 122, 128, 131 1, 0"],
    },
    "pressfeed.mnt": {
        "what is input 2?": ["input 2 loop low in 41"],
        "who fills the loop of strip?": [
            "task StripLoop 38 program (62)",
            "if INX(2): uncoiler = 1; -> 43 WAIT = 400",
        ],
        "what must be there before the first stroke?": [
            "68 Pause INX(4) And INX(3) [waits for input 3 (start), input 4 (guard)]"
        ],
        "what happens when the guard opens?": [
            "event IN4 124 input 4",
            "if INX(4) = 0: (STOP(0); clutch = 0; state = stFault); -> return",
        ],
        "what does the misfeed pin do?": [
            'clutch = 0; STOP(0); Print "misfeed at "; POS(0); state = stFault; -> return'
        ],
        "how does it leave the fault?": [
            "112 Pause INX(4) [waits for input 4 (guard)] -> 113 Pause INX(3)",
            "lampFault = 0; scrap = scrap + 1; state = stFeed; -> 65 Select Case state",
        ],
        "what does it do when the batch is done?": [
            "if state is stLoop: SPEED(0) = 200; MOVER(0) = 3 * pitch; GO(0); -> 102 Pause IDLE(0)"
        ],
        "how far does it feed, and how fast?": [
            "moves MOVER = pitch computed 75",
            "speeds and rates SPEED = 900 35, 103",
        ],
        "what closes the press?": ["output 0 clutch out 81, 83, 109, 127, 134, 141 1, 0"],
        "which pitches may the operator choose?": [
            "if pitch < 5: (pitch = 5); if pitch > 250: (pitch = 250)"
        ],
    },
    "dispenser.mccl": {
        "what is input 5?": ["input 5 cartridge empty in 43 36"],
        "what does it wait for between parts?": ["23 WA.02 [polls input 4 (two hand start)]"],
        "what if no fixture is loaded?": ["CF34; if channel 1 off: MJ10; -> goes on in macro 10"],
        "which register has the shot?": ["24 shot register 52 33", "moves MR = @24 computed 33"],
        "after how many tries is the lock a fault?": [
            "unless channel 2 on: RA26; AA1; AR26; if accumulator > 2: MJ90; -> goes on in macro 90"
        ],
        "what if there is no pressure?": [
            "if channel 3 off: MJ91; -> goes on in macro 91",
            'CN35; OT"pressure"; -> 41 WN3',
        ],
        "what happens when the cartridge is empty?": [
            "macro 92, line 43: cartridge is empty, change it and purge",
            "43 MC95 [runs macro 95]",
        ],
        "which macro is never used?": ["macro 99 48 old test of the lamps never reached"],
        "which axis is the pump?": ["axis 3 (pump)"],
        "how does it keep the needle from dripping?": [
            "macro 32, line 35: draw back half a turn so that it does not drip, then up",
            "moves MR = -200 35",
        ],
    },
}


@pytest.mark.parametrize(
    ("program", "question"),
    [(program, question) for program, asked in QUESTIONS.items() for question in asked],
)
def test_the_map_answers(program: str, question: str, cell: Cell) -> None:
    shown = " ".join(cell("map", str(OLD / program)).out.split())
    for answer in QUESTIONS[program][question]:
        assert answer in shown


def test_there_are_ten_questions_about_each_program() -> None:
    assert [len(asked) for asked in QUESTIONS.values()] == [10] * 6
