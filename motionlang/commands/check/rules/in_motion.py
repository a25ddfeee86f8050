"""A position is read or set right behind the GO that started a move, when no time has passed."""

from __future__ import annotations

from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.commands.check.rule_facts import Facts, spelt


def check_mint(facts: Facts, warn: Warn) -> None:
    _check(facts, warn, "PAUSE IDLE({}) waits for its end")


def check_mccl(facts: Facts, warn: Warn) -> None:
    _check(facts, warn, "{}WS before it waits for its end")


def _check(facts: Facts, warn: Warn, hint: str) -> None:
    for act, key, _ in facts.axes.problems.get("in-motion", ()):
        what = "set" if act.role == "zero" else "read"
        message = f"the position of axis {spelt(key)} is {what} while the move just started is in motion"
        warn(message, act.at, hint.format(spelt(key)))


RULE = Rule(
    code="in-motion",
    text="""\
The program reads or sets the position immediately after the GO that started a move, when no time has passed. It gets
the start of the move, where it probably needs the end. If a PAUSE, a WAIT or a loop comes in between, the position is
meant to be read during the move, and there is no warning. In MCCL: a TP or DH directly behind a move, outside a loop.
""",
    fix="wait for the end of the move with PAUSE IDLE before you use the position",
    mint=RuleCase(
        check_mint,
        wrong="MOVER(0) = 5 : GO(0)\nPRINT POS(0)\n",
        right="MOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\nPRINT POS(0)\n",
    ),
    mccl=RuleCase(check_mccl, wrong="1MN,1MR100,1TP\n", right="1MN,1MR100,1WS,1TP\n"),
)
