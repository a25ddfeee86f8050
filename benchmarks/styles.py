"""One shift written in 30 styles, for counting work.

Each program moves axis 0 there and back `CYCLES` times, unless it says otherwise. A style is a way of writing
that machine builders use: how the program waits, what runs alongside, and what it writes meanwhile. Most cycles
take 3.4 s of machine time. The programs use only features of commit 7b66ced, because they also run there.
"""

from __future__ import annotations

from typing import NamedTuple

CYCLES = 40
_AXES = "SPEED(0, 1) = 100;\nACCEL(0, 1) = 500;\nDECEL(0, 1) = 500;\nDim n As Integer\n"
_LOOP = "For n = 1 To {cycles}\n{there}{back}Next\nEnd\n"
_THERE, _BACK = "  MOVEA(0) = 100 : GO(0)\n", "  MOVEA(0) = 0 : GO(0)\n"
_PAUSE = "  PAUSE IDLE(0)\n"
# For loops that cannot be skipped: 0.14 s of polling in each direction.
_SHORT = "  MOVEA(0) = 2.5 : GO(0)\n"


class Style(NamedTuple):
    """A program, its file name, its machine file as settings, and its time limit, s.

    The suffix of the name selects the language.
    """

    file: str
    text: str
    machine: dict[str, object]
    until: float = 1000.0


def _mint(
    wait: str = _PAUSE,
    *,
    head: str = "",
    there: str = _THERE,
    back: str = _BACK,
    each: str = "  WAIT(500)\n",
    blocks: str = "",
    machine: dict[str, object] | None = None,
    cycles: int = CYCLES,
) -> Style:
    """Return a shift in Mint.

    `head` comes before the loop, `wait` after either move, `each` once per cycle, `blocks` at the end.
    """
    loop = _LOOP.format(cycles=cycles, there=there + wait, back=back + wait + each)
    return Style("shift.mnt", f"{_AXES}{head}{loop}{blocks}", machine or {})


def _mccl(text: str, until: float = 1000.0) -> Style:
    return Style("shift.mcl", text.replace("CYCLES", str(CYCLES - 1)), {}, until)


_POLLING_TASK = "Task Lamp\nLoop\n  If VEL(0) > 0 Then OUTX(1) = 1 Else OUTX(1) = 0\nEnd Loop\nEnd Task\n"
_BOTH = "VECTORA(0, 1) = {} : GO(0)\n"

STYLES: dict[str, Style] = {
    # Waits until the axis is at rest.
    "pause": _mint(),
    "while": _mint("  While Not IDLE(0)\n  End While\n"),
    "repeat": _mint("  Repeat\n  Until IDLE(0)\n"),
    "while_with_wait": _mint("  While Not IDLE(0)\n    WAIT(5)\n  End While\n"),
    "time_out": _mint(
        "  t = TIME\n  While Not IDLE(0) And TIME - t < 5000\n  End While\n", there=_SHORT, cycles=1
    ),
    "counter": _mint("  k = 0\n  While Not IDLE(0)\n    k = k + 1\n  End While\n"),
    "position_window": _mint(
        "  While ABS(POS(0) - POSTARGET(0)) > 0.01\n  End While\n  PAUSE IDLE(0)\n", there=_SHORT, cycles=1
    ),
    "sub": _mint("  Settle\n", blocks="Sub Settle\n  PAUSE IDLE(0)\nEnd Sub\n"),
    "function": _mint(
        "  While Not Rest(0)\n  End While\n",
        blocks="Function Rest(ByVal a As Integer) As Integer\n  Rest = IDLE(a)\nEnd Function\n",
    ),
    # Tasks and handlers alongside.
    "second_task_polls": _mint(head="Run Lamp\n", blocks=_POLLING_TASK),
    "second_task_waits": _mint(
        head="Run Blink\n",
        blocks="Task Blink\nLoop\n  OUTX(2) = 1\n  WAIT(250)\n  OUTX(2) = 0\n  WAIT(250)\nEnd Loop\nEnd Task\n",
    ),
    "four_tasks": _mint(
        head="Run T1\nRun T2\nRun T3\n",
        blocks="".join(
            f"Task T{k}\nLoop\n  PAUSE INX({k})\n  WAIT(100)\nEnd Loop\nEnd Task\n" for k in (1, 2, 3)
        ),
    ),
    "timer": _mint(head="TIMEREVENT = 100\n", blocks="Event TIMER\n  OUTX(3) = 1\nEnd Event\n"),
    "input_handler": _mint(
        head="Dim parts As Integer\n",
        blocks="Event IN0\n  parts = parts + 1\nEnd Event\n",
        machine={"input": [{"channel": 0, "at": 0.7, "for": 0.3, "every": 0.7, "times": 150}]},
    ),
    # Output.
    "print": _mint(each='  WAIT(500)\n  PRINT "part ", n\n'),
    "display": _mint("  While Not IDLE(0)\n    LINE 1, POS(0)\n    WAIT(100)\n  End While\n"),
    "comms": _mint("  While Not IDLE(0)\n    COMMS(1) = POS(0)\n    WAIT(20)\n  End While\n"),
    "output_at_position": _mint(
        "  While POS(0) < 50 And Not IDLE(0)\n  End While\n  OUTX(1) = 1\n  PAUSE IDLE(0)\n"
    ),
    "recipe": _mint(
        head="Dim r(3) As Float\nr(1) = 20 : r(2) = 60 : r(3) = 100\n",
        there="  MOVEA(0) = r(1 + n Mod 3) : GO(0)\n",
    ),
    # Other motion.
    "path": _mint(there=f"  {_BOTH.format('60, 80')}", back=f"  {_BOTH.format('0, 0')}"),
    "arc": _mint(
        there="  CIRCLER(0, 1) = 50, 0, 180 : GO(0)\n",
        back="  CIRCLER(0, 1) = -50, 0, 180 : GO(0)\n",
        cycles=10,
    ),
    "contour": _mint(
        head="CONTOURMODE(0) = 1\nMOVEBUFFERSIZE(0, 1) = 20;\n",
        there="  VECTORR(0, 1) = 30, 0 : VECTORR(0, 1) = 30, 4 : VECTORR(0, 1) = 40, 9 : GO(0)\n",
        back=f"  {_BOTH.format('0, 0')}",
    ),
    "follower": _mint(head="MASTERSOURCE(1) = _msPOS\nMASTERCHANNEL(1) = 0\nFOLLOW(1) = 0.5\n"),
    "jog": _mint(there="  JOG(0) = 40\n  WAIT(1000)\n  STOP(0)\n"),
    "override": _mint(there=f"{_THERE}  WAIT(300)\n  FEEDRATEOVERRIDE(0) = 50 + n\n"),
    "travel_limits": _mint(machine={"axis.0.travel": [-10.0, 150.0]}),
    # MCCL.
    "mccl_moves": _mccl("1MN,1SV1000,1SA5000,1DS5000\n1MA1000,1WS0.1,1MA0,1WS0.1,RPCYCLES\n"),
    "mccl_polls": _mccl(
        'MD1,1LU"STATUS",1RL@0,IC3,JR-3,NO\n1MN,1SV1000,1SA5000,1DS5000\n1MA1000,MC1,1MA0,MC1,RPCYCLES\n'
    ),
    "mccl_watch": _mccl(
        "MD5,IN5,CN34,NO,IF5,CF34,NO,RP\n1MN,1SV1000,1SA5000,1DS5000\nGT5\n1MA1000,1WS0.1,1MA0,1WS0.1\n", 0.2
    ),
    "mccl_registers": _mccl(
        "1MN,1SV1000,1SA5000,1DS5000,AL0,AR10\nRA10,AA1,AR10,1MA@10,1WS,WA0.5,1MA0,1WS,RPCYCLES\n"
    ),
}
