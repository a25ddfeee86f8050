"""An endless loop computes and never waits.

Such a loop takes all the time of its task, and nothing outside the program can influence it. Programs with tasks, event
handlers or a host are not checked, because these may use or change its variables.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.kernel.lang import STOP
from motionlang.kernel.mint.resolve.symbols import TIME
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import walk

if TYPE_CHECKING:
    from motionlang.commands.check.mint.mint_facts import MintFacts

# Statements that let time pass or start another task.
_TAKES_TIME = (nodes.Pause, nodes.Input, nodes.Run)
_COMPUTES = (nodes.Assign, nodes.Call, nodes.Print)


def check(facts: MintFacts, warn: Warn) -> None:
    if len([each for each in facts.functions if each.kind != "sub"]) != 1 or facts.hosted:
        return
    if any(facts.entries[function][1:] for function in facts.functions):
        return
    for loop in facts.endless():
        inside = _with_subs(facts, loop)
        computes = any(isinstance(facts.nodes_at.get(p), _COMPUTES) for p in inside)
        if computes and all(_is_quiet(facts, p) for p in inside):
            first = min(at for p in loop if (at := facts.graph.points[p].at) >= 0)
            message = "this loop computes forever: it never waits, and nothing can end it"
            warn(message, first, "add a WAIT, a PAUSE or an Exit to it")


def _is_quiet(facts: MintFacts, p: int) -> bool:
    """True if only values that the program sets are computed or printed at a point."""
    node = facts.nodes_at.get(p)
    if isinstance(node, _TAKES_TIME) or facts.graph.points[p].role == STOP:
        return False
    if any(not act.callee for act in facts.acts.get(p, ())):
        return False
    for each in walk([node]):
        if type(each) is nodes.Name:
            if each.row is not None and each.row.changes == "always":
                return False
            if each.symbol is not None and each.symbol.type.name == TIME:
                return False
    return True


def _with_subs(facts: MintFacts, loop: set[int]) -> set[int]:
    callees = [facts.callee(act) for p in loop for act in facts.acts.get(p, ()) if act.callee]
    called = [each for callee in callees for each in facts.called(callee)]
    return loop.union(*(facts.points[each] for each in called))


RULE = Rule(
    code="busy-loop",
    text="""\
A loop without an end that only computes or prints: it never waits, reads nothing that changes by itself, and nothing
leads out of it. There is no warning if the program has tasks, events or a host, which may use what the loop computes.
""",
    fix="add a WAIT, a PAUSE or an Exit to the loop",
    mint=RuleCase(
        check,
        wrong="Dim n\nLoop\n  n = n + 1\n  PRINT n\nEnd Loop\n",
        right="Dim n\nLoop\n  n = n + 1\n  PRINT n\n  WAIT = 10\nEnd Loop\n",
    ),
)
