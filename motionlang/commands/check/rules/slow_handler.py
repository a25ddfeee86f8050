"""The handler of the timer waits longer than the period of its event, so that the program itself gets no time."""

from __future__ import annotations

from math import fsum
from typing import TYPE_CHECKING

from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.kernel.mint.keywords.event_kinds import kind_and_number
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import walk

if TYPE_CHECKING:
    from motionlang.commands.check.mint.mint_facts import MintFacts
    from motionlang.kernel.mint.resolve.symbols import Function

# Statements with which a path may leave the handler.
_LEAVES = (nodes.Label, nodes.Jump, nodes.Return, nodes.Exit, nodes.End)


def check(facts: MintFacts, warn: Warn) -> None:
    periods = [act.number(0) for act in facts.written_by(lambda row: row.function == "timer_event")]
    known = [each for each in periods if each]
    if not known or None in periods:
        return
    for function in facts.functions:
        if function.kind == "event" and kind_and_number(function.name) == ("timer", 0):
            waits = _least_wait(facts, function)
            if waits > max(known):
                warn(
                    f"this handler waits {waits:.10g} ms, and its event comes every {max(known):.10g} ms",
                    function.at,
                    "the program gets no time: wait less, or set a longer TIMEREVENT",
                )


def _least_wait(facts: MintFacts, function: Function) -> float:
    """Return the time, ms, that a function waits on every path through its text."""
    found: list[float] = []
    for node in function.body:
        if any(isinstance(each, _LEAVES) for each in walk([node])):
            break
        statement = facts.structure.statements.get(node.start)
        uses = statement.uses if statement is not None and isinstance(node, nodes.Assign | nodes.Call) else []
        found += (use.number(0) or 0.0 for use in uses if use.row is not None and use.row.function == "wait")
    return fsum(found)


RULE = Rule(
    code="slow-handler",
    text="""\
The handler of TIMER waits longer than TIMEREVENT, the period of its event. The next event is due before the handler
ends, so the program between two events gets no time. Both numbers are constants; a WAIT in a branch or a loop does not
count, since it may be skipped.
""",
    fix="wait less in the handler, or set a longer TIMEREVENT",
    mint=RuleCase(
        check,
        wrong="TIMEREVENT = 20\nWAIT = 500\nEnd\nEvent TIMER\n  WAIT = 50\nEnd Event\n",
        right="TIMEREVENT = 100\nWAIT = 500\nEnd\nEvent TIMER\n  WAIT = 50\nEnd Event\n",
    ),
)
