"""The facts about an axis that the checks of motion know at the end of a program.

A test compares all facts: those that it does not list are the ones at power-up.
"""

from __future__ import annotations

from typing import Any

from motionlang.commands.check.mint.axis_state import ANY, IDLE, MOVES, UNKNOWN, Axis, Follower
from motionlang.commands.check.mint.effects import Facts
from motionlang.kernel import Source
from motionlang.kernel.mint import table
from motionlang.kernel.mint.check.check import check_module
from motionlang.kernel.mint.syntax.parser import parse
from tests.cases import cases

Known = dict[str, object]

# An axis at rest at 0; no setting has been made, and no move is loaded.
POWER_UP = Axis(IDLE, target=0.0, frame=0.0, speeded=False, empty=True, span=(0.0, 0.0))


def facts_at_end(text: str, axis: int = 0) -> Known:
    """Return the facts that differ from power-up at the end of a program."""
    names = check_module(parse(Source("a.mnt", text)), {}).names
    follower = Follower(Facts(names, table()), lambda key, axis: False)
    follower.analyse(names.main)
    last = follower.before[names.main][follower.facts.graphs[names.main].leave]
    found = follower.known(last, axis)._asdict()
    return {name: value for name, value in found.items() if value != getattr(POWER_UP, name)}


MOVED = "MOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\n"


@cases(
    "text, known",
    [
        ("PRINT POS(0)", {}),
        ("GO(0)", {}),
        ("STOP(0)", {}),
        ("SCALE(0) = 2", {}),
        ("MOVER(0) = 5", {"waiting": 1, "target": 5.0, "loaded": 0, "empty": False, "span": (0.0, 5.0)}),
        (
            "MOVER(0) = 5\nMOVEA(0) = -3",
            {"waiting": 2, "target": -3, "loaded": 0, "empty": False, "span": (-3, 5.0)},
        ),
        ("MOVER(0) = 5\nSTOP(0)", {"target": None, "span": (0.0, 5.0)}),
        (
            "MOVER(0) = 5 : GO(0)",
            {"motion": MOVES, "fresh": True, "target": 5.0, "span": (0.0, 5.0)},
        ),
        ("MOVER(0) = 5 : GO(0)\nWAIT 1", {"motion": MOVES, "target": 5.0, "span": (0.0, 5.0)}),
        (MOVED, {"target": 5.0, "span": (0.0, 5.0)}),
        (MOVED + "STOP(0)", {"target": 5.0, "span": (0.0, 5.0)}),
        (MOVED + "POS(0) = 7", {"target": 7, "frame": -2.0, "span": (7, 7)}),
        (MOVED + "SCALE(0) = 2", {"target": None, "scaled": 35, "span": None}),
        ("POS(0) = 7", {"target": 7, "frame": -7.0, "span": (7, 7)}),
        (
            "MOVER(0) = 5\nPOS(0) = 7",
            {"waiting": 1, "target": None, "frame": None, "loaded": 0, "empty": False, "span": None},
        ),
        ("n = 1\nPOS(0) = n", {"target": None, "frame": None, "span": None}),
        ("JOG(0) = 5", {"motion": MOVES, "target": None, "empty": False, "span": None, "jogs": True}),
        ("JOG(0) = 0", {"motion": UNKNOWN, "target": None, "empty": False, "span": None}),
        ("JOG(0) = 5\nSTOP(0)", {"motion": UNKNOWN, "target": None, "span": None}),
        ("JOG(0) = 5\nCANCEL(0)", {"target": None, "span": None}),
        ("JOG(0) = 5 : GO(0)", {"motion": UNKNOWN, "target": None, "span": None}),
        ("RESET(0)", {"target": None, "frame": None, "span": None}),
        ("HOME(0) = 0", {"motion": UNKNOWN, "target": None, "frame": None, "empty": False, "span": None}),
        ("DRIVEENABLE(0) = 1", {"motion": UNKNOWN, "target": None, "empty": False, "span": None}),
        (
            "SPEED(0) = 0 : MOVER(0) = 5 : DRIVEENABLE(0) = 0",
            {
                "motion": UNKNOWN,
                "target": None,
                "set": {"speed"},
                "speeded": True,
                "empty": False,
                "span": None,
            },
        ),
        ("SPEED(0) = 5 : ACCEL(0) = 0", {"set": {"speed", "accel"}, "speeded": True, "zeros": {"accel"}}),
        ("SPEED(0) = 5 : SCALE(0) = 2", {"stale": {"speed"}, "scaled": 15, "speeded": True}),
        ("SPEED(0) = 5 : SCALE(0) = 2 : SPEED(0) = 3", {"set": {"speed"}, "scaled": 15, "speeded": True}),
        ("SPEED(0) = 5 : ACCELTIME(0) = 9", {"set": {"speed"}, "speeded": True}),
        ("PRINT 1 : ACCELTIME(0) = 9 : DECELTIME(0) = 9", {"timed": 10}),
        ("ACCELTIME(0) = 9 : SPEED(0) = 5", {"set": {"speed"}, "speeded": True}),
        (
            "VECTORR(0, 1) = 3, 4",
            {"waiting": 1, "target": 3.0, "loaded": 0, "empty": False, "span": (0.0, 3.0)},
        ),
        ("VECTORR(1, 0) = 3, 4", {"motion": UNKNOWN, "target": 4.0, "empty": False, "span": None}),
        (
            "CIRCLER(0, 1) = 6, 0, 180",
            {"waiting": 1, "target": None, "loaded": 0, "empty": False, "span": None},
        ),
    ],
)
def test_the_facts_about_an_axis(text: str, known: Known) -> None:
    """Tokens count from 0; an axis that a path takes along may move by itself."""
    assert facts_at_end(text) == known


NOTHING = {name: value for name, value in ANY._asdict().items() if value != getattr(POWER_UP, name)}
TASK = "\nTask press\nMOVER(1) = 2 : GO(1)\nEnd Task"


@cases(
    "text, known",
    [
        ("n = 1\nSPEED(n) = 5\nPRINT POS(n)", {}),
        ("n = 1\nMOVER(n) = 5", NOTHING),
        (
            "load()\nSub load()\nMOVER(0) = 5\nEnd Sub",
            NOTHING | {"waiting": 1, "loaded": 18},
        ),
        (
            "Run press\nMOVER(1) = 5\nJOG(0) = 0" + TASK,
            {"motion": UNKNOWN, "target": None, "empty": False, "span": None},
        ),
        ("Run press\nMOVER(0) = 5" + TASK.replace("(1)", "(0)"), NOTHING),
        ("Run press\nn = 1\nMOVER(n) = 5\nMOVEA(0) = 3" + TASK, NOTHING),
    ],
)
def test_axes_that_may_be_any(text: str, known: Known) -> None:
    """A task or a keyword that may command any axis leaves nothing certain."""
    assert facts_at_end(text) == known


# All facts are certain, and differ from those of `ANY`.
CERTAIN = Axis(
    *(MOVES, True, 2, 5.0, 1.0, frozenset(("speed", "accel")), frozenset(("decel",)), 7, 3, False),
    *(frozenset(("accel",)), 4, True, (0.0, 5.0), True),
)  # fmt: skip


@cases(
    "name, other, joined",
    [
        ("motion", IDLE, UNKNOWN),
        ("fresh", False, False),
        ("waiting", 1, 1),
        ("waiting", 3, 2),
        ("target", 4.0, None),
        ("frame", 0.0, None),
        ("set", frozenset(("speed", "decel")), {"speed"}),
        ("stale", frozenset(("speed",)), set()),
        ("scaled", 8, 0),
        ("timed", 4, None),
        ("speeded", True, True),
        ("zeros", frozenset(("accel", "speed")), {"accel"}),
        ("loaded", 5, None),
        ("empty", False, False),
        ("span", (0.0, 6.0), None),
        ("jogs", False, False),
    ],
)
def test_a_fact_on_which_two_paths_disagree(name: str, other: Any, joined: Any) -> None:
    """All other facts stay, and at the head of a loop time has passed in addition."""
    different = CERTAIN._replace(**{name: other})
    for one, two in ((CERTAIN, different), (different, CERTAIN)):
        found = one.joined(two, at_loop_head=False)
        assert found == CERTAIN._replace(**{name: joined})
        assert one.joined(two, at_loop_head=True) == found._replace(fresh=False)


def test_nothing_is_certain_about_any_axis() -> None:
    """Paths that agree on nothing leave the facts of `ANY`."""
    assert CERTAIN.joined(CERTAIN, at_loop_head=False) == CERTAIN
    assert CERTAIN.joined(CERTAIN, at_loop_head=True) == CERTAIN._replace(fresh=False)
    assert CERTAIN.joined(ANY, at_loop_head=False) == ANY
    nothing = Axis(
        *(UNKNOWN, False, 0, None, None, frozenset(), frozenset(), 0, None, True),
        *(frozenset(), None, False, None, False),
    )  # fmt: skip
    assert nothing == ANY
