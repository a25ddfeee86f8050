"""No path leads to a statement; the first one of each unreachable stretch is reported."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.commands.check.mccl.loops import REPEATS
from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.kernel.mint.syntax import nodes

if TYPE_CHECKING:
    from motionlang.commands.check.mccl.mccl_facts import MacroFacts
    from motionlang.commands.check.mint.mint_facts import MintFacts
    from motionlang.kernel.mccl import Line

# Commands after which the line does not continue.
_LEAVES = frozenset({"jump_macro", "leave"})
# Statements that do nothing themselves, or that are commonly written as a precaution at the end of a block.
_SILENT = (nodes.End, nodes.Return, nodes.Exit, nodes.Dim, nodes.Const, nodes.Define, nodes.Label, nodes.Auto)


def check_mint(facts: MintFacts, warn: Warn) -> None:
    for function in facts.functions:
        reached = facts.reached(function)
        is_reported, before = False, -1
        for p in facts.points[function]:
            node = facts.nodes_at.get(p)
            if p in reached:
                before = p
                is_reported = is_reported and node is None
            elif node is not None and not is_reported and not isinstance(node, _SILENT):
                is_reported = True
                warn("this statement is unreachable", node.start, _why(facts.nodes_at.get(before)))


def _why(before: nodes.Node | None) -> str:
    """Return why what follows a statement is not reached."""
    word = ""
    if isinstance(before, nodes.Exit):
        word = f"Exit {before.kind.title()}".strip()
    elif isinstance(before, nodes.Jump) and before.kind == "goto":
        word = "Goto"
    elif isinstance(before, nodes.Return):
        word = "Return"
    return f"the {word} before it leads elsewhere" if word else "the code before it never ends"


def check_mccl(facts: MacroFacts, warn: Warn) -> None:
    graph = facts.structure.graph
    reached = {graph.points[p].at for p in graph.reached(*(unit.entry for unit in facts.structure.units))}
    is_reported = False
    for line in facts.lines:
        if line.offsets[0] in reached:
            is_reported = is_reported and line.commands[0].function == "define_macro"
            _check_commands(line, reached, warn)
        elif not is_reported:
            is_reported = True
            warn("this line can never run: the line before repeats forever", line.offsets[0])


def _check_commands(line: Line, reached: set[int], warn: Warn) -> None:
    is_reported = False
    for k, (command, at) in enumerate(zip(line.commands, line.offsets, strict=True)):
        if at in reached or command.function == "nothing":
            is_reported = is_reported and at not in reached
        elif not is_reported:
            is_reported = True
            # The first command runs, so there is one between that does not lead to the next.
            before = next(each for each in reversed(line.commands[:k]) if each.function in REPEATS | _LEAVES)
            repeats = before.function == "repeat"
            why = "repeats the commands before it forever" if repeats else "always jumps elsewhere"
            warn(f"this command can never run: {before.text} {why}", at)


RULE = Rule(
    code="unreachable",
    text="""\
The statement can never be reached: it follows a Goto, an Exit, an End or a loop without an end. Only the first
statement of a section is reported; an extra End or Return is not. In MCCL: commands after `RP` without a number,
`JP`, `MJ` and `BK` if nothing skips these, and the line below one that repeats itself forever.
""",
    fix="remove the statement, or the one before it that never continues",
    mint=RuleCase(
        check_mint,
        wrong="End\nPRINT 1\n",
        right="PRINT 1\nEnd\n",
    ),
    mccl=RuleCase(check_mccl, wrong="1MN,BK,1MR100\n", right="1MN,1MR100,BK\n"),
)
