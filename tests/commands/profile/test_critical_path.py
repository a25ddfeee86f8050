"""Complete critical paths: each link with its end, cause and line.

A statement takes 1 ms. At 100 units/s with rates of 1000 units/s² a move takes 0.1 s to speed up and 0.1 s to
slow down, 5 units each. The first line has three statements.
"""

from __future__ import annotations

import pytest

from motionlang import profile, run
from motionlang.kernel import Source

RATES = "SPEED(0, 1) = 100, 100; : ACCEL(0, 1) = 1000; : DECEL(0, 1) = 1000;\n"
WORLD = {
    "controller.instruction_time": 0.001,
    "input": [{"channel": 1, "at": 1.0}, {"channel": 2, "at": 2.0}],
}

# The lines from line 2 on, and of each link: its end, cause and line, the line that waited, the axes, the lines of the
# calls, and the task unless it is the parent.
PROGRAMS: dict[str, tuple[str, list[tuple[object, ...]]]] = {
    # 5 units after 1.102 s, and two statements; the last move begins before the program ends.
    "an input, a position, and a move after the end": (
        "PAUSE INX(1)\nMOVER(0) = 10 : GO(0)\nPAUSE POS(0) >= 5\nMOVER(1) = 20 : GO(1)\n",
        [
            (0.003, "computing", 1, 0, (), ()),
            (1.0, "waiting for an input", 2, 2, (), ()),
            (1.002, "computing", 2, 0, (), ()),
            (1.102, "accelerating", 3, 4, (0,), ()),
            (1.105, "computing", 4, 0, (), ()),
            (1.204, "accelerating", 5, 0, (1,), ()),
            (1.304, "at speed", 5, 0, (1,), ()),
            (1.404, "decelerating", 5, 0, (1,), ()),
        ],
    ),
    # The inner loops take 200 ms; a sub that a loop calls has its own time.
    "loops, and loops of a sub": (
        "For j = 1 To 2\n  For k = 1 To 200\n  Next\n  Inner\nNext\nEnd\nSub Inner()\n  y = y + 1\n"
        "  WAIT(1)\n  For k = 1 To 200\n  Next\nEnd Sub\n",
        [
            (0.004, "computing", 1, 0, (), ()),
            (0.005, "computing", 2, 0, (), ()),
            (0.205, "computing", 3, 0, (), ()),
            (0.206, "computing", 2, 0, (), ()),
            (0.207, "dwell", 10, 10, (), (5,)),
            (0.209, "computing", 10, 0, (), (5,)),
            (0.409, "computing", 11, 0, (), (5,)),
            (0.412, "computing", 2, 0, (), ()),
            (0.612, "computing", 3, 0, (), ()),
            (0.613, "computing", 2, 0, (), ()),
            (0.614, "dwell", 10, 10, (), (5,)),
            (0.616, "computing", 10, 0, (), (5,)),
            (0.816, "computing", 11, 0, (), (5,)),
            (0.818, "computing", 2, 0, (), ()),
        ],
    ),
    # 10 units take 0.2 s, 40 units 0.5 s.
    "a buffer, and two axes in a sub": (
        "MOVEBUFFERSIZE(0) = 5\nMOVER(0) = 10\nMOVER(0) = 10\nGO(0)\nWAIT(50)\nStroke\nEnd\n"
        "Sub Stroke()\n  PAUSE IDLE(0)\n  MOVER(0, 1) = 10, 40 : GO(0, 1)\n"
        "  PAUSE IDLE(0) And IDLE(1)\nEnd Sub\n",
        [
            (0.006, "computing", 1, 0, (), ()),
            (0.106, "accelerating", 3, 10, (0,), ()),
            (0.206, "decelerating", 3, 10, (0,), ()),
            (0.306, "accelerating", 4, 10, (0,), ()),
            (0.406, "decelerating", 4, 10, (0,), ()),
            (0.408, "computing", 10, 0, (), (7,)),
            (0.508, "accelerating", 11, 12, (1,), (7,)),
            (0.808, "at speed", 11, 12, (1,), (7,)),
            (0.908, "decelerating", 11, 12, (1,), (7,)),
            (0.91, "computing", 12, 0, (), (7,)),
        ],
    ),
    # The loops check every 0.302 s and 0.202 s: the rest after the cause is charged to their WAITs.
    "loops that poll": (
        "While INX(1) = 0\n  WAIT 300\nEnd While\nMOVER(0) = 30 : GO(0)\nWhile Not IDLE(0)\n"
        "  WAIT 200\nEnd While\n",
        [
            (0.004, "computing", 1, 0, (), ()),
            (1.0, "waiting for an input", 2, 2, (), ()),
            (1.21, "dwell", 3, 3, (), ()),
            (1.212, "computing", 2, 0, (), ()),
            (1.213, "computing", 3, 0, (), ()),
            (1.313, "accelerating", 5, 6, (0,), ()),
            (1.513, "at speed", 5, 6, (0,), ()),
            (1.613, "decelerating", 5, 6, (0,), ()),
            (1.617, "dwell", 7, 7, (), ()),
            (1.619, "computing", 6, 0, (), ()),
        ],
    ),
    # 10 units along the path. The jog is at 8 units, and at 20 units after 0.17 s.
    "a path, and a jog that is stopped": (
        "VECTORR(0, 1) = 6, 8\nGO(0)\nPAUSE IDLE(0)\nWAIT(20)\nJOG(1) = 100\nPAUSE POS(1) >= 20\n"
        "STOP(1)\nPAUSE IDLE(1)\n",
        [
            (0.004, "computing", 1, 0, (), ()),
            (0.104, "accelerating", 2, 4, (0, 1), ()),
            (0.204, "decelerating", 2, 4, (0, 1), ()),
            (0.205, "computing", 4, 0, (), ()),
            (0.225, "dwell", 5, 5, (), ()),
            (0.226, "computing", 5, 0, (), ()),
            (0.326, "accelerating", 6, 7, (1,), ()),
            (0.396, "at speed", 6, 7, (1,), ()),
            (0.397, "computing", 7, 0, (), ()),
            (0.497, "stopping", 6, 9, (1,), ()),
            (0.498, "computing", 9, 0, (), ()),
        ],
    ),
    # 20.2 units in 0.252 s, and 5 units to rest; the rest of 14.8 units takes 0.248 s.
    "a move that is suspended": (
        "MOVER(0) = 40 : GO(0)\nWAIT(250)\nSUSPEND(0) = 1\nWAIT(500)\nSUSPEND(0) = 0\nPAUSE IDLE(0)\n",
        [
            (0.005, "computing", 1, 0, (), ()),
            (0.255, "dwell", 3, 3, (), ()),
            (0.257, "computing", 3, 0, (), ()),
            (0.757, "dwell", 5, 5, (), ()),
            (0.758, "computing", 5, 0, (), ()),
            (0.858, "accelerating", 2, 7, (0,), ()),
            (0.906, "at speed", 2, 7, (0,), ()),
            (1.006, "decelerating", 2, 7, (0,), ()),
            (1.007, "computing", 7, 0, (), ()),
        ],
    ),
    # The first move gains little from its new speed, the second one more than from its start.
    "speeds that are raised in motion": (
        "MOVER(0) = 20 : GO(0)\nWAIT(150)\nSPEED(0) = 110\nPAUSE IDLE(0)\n"
        "SPEED(0) = 11 : MOVER(0) = 60 : GO(0)\nWAIT(500)\nSPEED(0) = 110\nPAUSE IDLE(0)\n",
        [
            (0.004, "computing", 1, 0, (), ()),
            (0.104, "accelerating", 2, 5, (0,), ()),
            (0.156, "at speed", 2, 5, (0,), ()),
            (0.166, "accelerating", 2, 5, (0,), ()),
            (0.190545, "at speed", 2, 5, (0,), ()),
            (0.300545, "decelerating", 2, 5, (0,), ()),
            (0.304545, "computing", 5, 0, (), ()),
            (0.804545, "dwell", 7, 7, (), ()),
            (0.805545, "computing", 7, 0, (), ()),
            (0.904545, "accelerating", 6, 9, (0,), ()),
            (1.2909, "at speed", 6, 9, (0,), ()),
            (1.4009, "decelerating", 6, 9, (0,), ()),
            (1.4019, "computing", 9, 0, (), ()),
        ],
    ),
    "a dwell of a buffer": (
        "MOVEBUFFERSIZE(0) = 4\nMOVER(0) = 10\nMOVEDWELL(0) = 100\nMOVER(0) = 10\nGO(0)\nPAUSE IDLE(0)\n",
        [
            (0.007, "computing", 1, 0, (), ()),
            (0.107, "accelerating", 3, 7, (0,), ()),
            (0.207, "decelerating", 3, 7, (0,), ()),
            (0.307, "dwell", 4, 7, (), ()),
            (0.407, "accelerating", 5, 7, (0,), ()),
            (0.507, "decelerating", 5, 7, (0,), ()),
            (0.508, "computing", 7, 0, (), ()),
        ],
    ),
    # The first handler starts a move from rest, the second one buffers a move.
    "handlers": (
        "PAUSE POS(1) = 10 And IDLE(1)\nMOVER(1) = 110 : GO(1)\nPAUSE POS(1) = 130 And IDLE(1)\n"
        "End\nEvent IN1\n  MOVER(1) = 10 : GO(1)\nEnd Event\nEvent IN2\n  MOVER(1) = 10 : GO(1)\n"
        "End Event\n",
        [
            (0.003, "computing", 1, 0, (), ()),
            (1.001, "waiting for a condition", 2, 2, (), ()),
            (1.101, "accelerating", 7, 2, (1,), ()),
            (1.201, "decelerating", 7, 2, (1,), ()),
            (1.203, "computing", 2, 0, (), ()),
            (1.303, "accelerating", 3, 4, (1,), ()),
            (2.303, "at speed", 3, 4, (1,), ()),
            (2.403, "decelerating", 3, 4, (1,), ()),
            (2.503, "accelerating", 10, 4, (1,), ()),
            (2.603, "decelerating", 10, 4, (1,), ()),
            (2.604, "computing", 4, 0, (), ()),
        ],
    ),
    # The parent and the third task compute in one time slice up to 0.218 s, which is charged to the task.
    "other tasks start the moves": (
        "Dim done\nRun Other\nWAIT(20)\nPAUSE IDLE(0)\nRun Third\nPAUSE done = 1\nEnd\nTask Other\n"
        "  WAIT(10)\n  MOVER(0) = 10 : GO(0)\n  WAIT(500)\nEnd Task\nTask Third\n  WAIT(10)\n"
        "  MOVER(1) = 10 : GO(1)\n  PAUSE IDLE(1)\n  done = 1\n  WAIT(100)\nEnd Task\n",
        [
            (0.004, "computing", 1, 0, (), ()),
            (0.014, "dwell", 10, 10, (), (), "other"),
            (0.016, "computing", 10, 0, (), (), "other"),
            (0.116, "accelerating", 11, 5, (0,), ()),
            (0.216, "decelerating", 11, 5, (0,), ()),
            (0.218, "computing", 15, 0, (), (), "third"),
            (0.228, "dwell", 15, 15, (), (), "third"),
            (0.23, "computing", 15, 0, (), (), "third"),
            (0.33, "accelerating", 16, 7, (1,), ()),
            (0.43, "decelerating", 16, 7, (1,), ()),
            (0.432, "computing", 7, 0, (), ()),
            (0.433, "computing", 7, 0, (), ()),
        ],
    ),
    # 200 iterations of a statement each.
    "a task that computes between two moves": (
        "Run Other\nPAUSE POS(0) = 20 And IDLE(0)\nEnd\nTask Other\n  MOVER(0) = 10 : GO(0)\n"
        "  PAUSE IDLE(0)\n  For k = 1 To 200\n  Next\n  MOVER(0) = 10 : GO(0)\n  WAIT(500)\n"
        "End Task\n",
        [
            (0.004, "computing", 1, 0, (), ()),
            (0.005, "computing", 6, 0, (), (), "other"),
            (0.105, "accelerating", 6, 7, (0,), (), "other"),
            (0.205, "decelerating", 6, 7, (0,), (), "other"),
            (0.207, "computing", 7, 0, (), (), "other"),
            (0.407, "computing", 8, 0, (), (), "other"),
            (0.408, "computing", 7, 0, (), (), "other"),
            (0.508, "accelerating", 10, 3, (0,), ()),
            (0.608, "decelerating", 10, 3, (0,), ()),
            (0.609, "computing", 3, 0, (), ()),
        ],
    ),
    "a task that computes before a move": (
        "WAIT(100)\nRun Other\nPAUSE POS(0) >= 5\nEnd\nTask Other\n  For k = 1 To 200\n  Next\n"
        "  MOVER(0) = 10 : GO(0)\n  WAIT(1000)\nEnd Task\n",
        [
            (0.003, "computing", 1, 0, (), ()),
            (0.103, "dwell", 2, 2, (), ()),
            (0.105, "computing", 2, 0, (), ()),
            (0.106, "computing", 7, 0, (), (), "other"),
            (0.306, "computing", 7, 0, (), (), "other"),
            (0.307, "computing", 7, 0, (), (), "other"),
            (0.407, "accelerating", 9, 4, (0,), ()),
            (0.408, "computing", 4, 0, (), ()),
            (0.507, "decelerating", 9, 0, (0,), ()),
        ],
    ),
}


@pytest.mark.parametrize("name", PROGRAMS)
def test_every_link_of_a_critical_path(name: str) -> None:
    text, expected = PROGRAMS[name]
    made = profile(run(Source("path.mnt", RATES + text), machine=WORLD))
    found = [
        (round(end, 6), cause, at.line, waited, axes, at.callers, *([task] if task != "ParentTask" else []))
        for _, end, (cause, at, task, axes, waited) in made.spans()
    ]
    assert found == expected
    begins = [round(begin, 6) for begin, _, _ in made.spans()]
    assert begins == [0.0, *(row[0] for row in expected[:-1])]
