"""A condition compares constants, inverts the bits of a truth value, or joins a number that is not compared."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from operator import eq, gt, lt, ne
from typing import TYPE_CHECKING

from motionlang.commands.check.mint.conditions import COMPARISONS, is_truth_value, tested
from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.kernel.mccl import NUMBER
from motionlang.kernel.mccl.runtime.register_uses import ACCUMULATOR, uses_of
from motionlang.kernel.mint.syntax import nodes

if TYPE_CHECKING:
    from motionlang.commands.check.mccl.mccl_facts import MacroFacts
    from motionlang.commands.check.mint.mint_facts import MintFacts
    from motionlang.commands.check.rule_facts import Part
    from motionlang.kernel.mccl import Command


# The value of the accumulator of MCCL before a command.
Known = tuple[float | None]
_UNKNOWN: Known = (None,)
_COMPARISONS: dict[str, Callable[[float, float], bool]] = {
    "if_below": lt,
    "if_equal": eq,
    "if_greater": gt,
    "if_unequal": ne,
}
# Commands without an axis that leave the accumulator as it is.
_KEEPS = frozenset(
    ("define_macro", "call_macro", "jump_macro", "wait", "wait_on", "wait_off", "motor_on", "stop")
)


def check_mint(facts: MintFacts, warn: Warn) -> None:
    for condition in tested(facts):
        _check_condition(facts, condition, warn)


def _check_condition(facts: MintFacts, node: nodes.Node, warn: Warn) -> None:
    if type(node) is nodes.Binary and node.op in COMPARISONS:
        value = facts.number(node)
        if value is not None:
            warn(f"this condition is always {'true' if value else 'false'}", node.start)
    elif type(node) is nodes.Binary and node.op in ("And", "Or"):
        for side in (node.left, node.right):
            if type(side) is nodes.Number:
                _lone_number(node, side, warn)
            else:
                _check_condition(facts, side, warn)
    elif type(node) is nodes.Unary and node.op == "Not":
        _check_condition(facts, node.operand, warn)
    elif type(node) is nodes.Unary and node.op == "~" and is_truth_value(node.operand):
        sign = facts.module.source.text[node.start]
        message = f"{sign} inverts bits, and of 0 or 1 makes -1 or -2: this condition is always true"
        warn(message, node.start, f"write Not instead of {sign}")


def _lone_number(node: nodes.Binary, side: nodes.Number, warn: Warn) -> None:
    decides = bool(side.value) is (node.op == "Or")
    always = "true" if side.value else "false"
    effect = f"so the condition is always {always}" if decides else "so it changes nothing"
    message = f"{side.value:.10g} is an operand of {node.op} on its own, {effect}"
    warn(message, side.start, "compare it, as in x = 1 Or x = 2; & and | work on bits")


def check_mccl(facts: MacroFacts, warn: Warn) -> None:
    """Follow the value of the accumulator; a tuple with None stands for one that is not known."""
    commands = {at: command for command, at in facts.commands}
    for part in facts.parts:
        before = _values(facts, part, commands)
        for p, statement in facts.statements_of(part):
            command, (value,) = commands[statement.at], before.get(p, _UNKNOWN)
            holds = None if value is None else _holds(command, value)
            if holds is not None:
                always = "true" if holds else "false"
                message = f"{command.text}: the accumulator is {value:.10g} here, so this is always {always}"
                warn(message, statement.at, "load a value that changes, such as a register or a reading")


def _values(facts: MacroFacts, part: Part, commands: Mapping[int, Command]) -> dict[int, Known]:
    """Return the value of the accumulator before each point of a part."""
    before: dict[int, Known] = {}

    def follow(p: int, known: Known) -> tuple[Known, Known]:
        before[p] = known
        statement = facts.statement_at.get(p)
        after = known if statement is None else _after(commands[statement.at], known)
        return after, after

    first = dict.fromkeys(facts.entries[part], _UNKNOWN)
    facts.graph.forward(first, follow, lambda one, other, p: one if one == other else _UNKNOWN)
    return before


def _after(command: Command, known: Known) -> Known:
    if command.function == "load":
        return (float(command.value) if command.kind == NUMBER else None,)
    if command.pure:
        uses = uses_of(command)
        return known if uses is not None and ACCUMULATOR not in uses.sets else _UNKNOWN
    # GT puts the number of the task there; a command for an axis has no register.
    return known if command.axis or command.function in _KEEPS else _UNKNOWN


def _holds(command: Command, value: float) -> bool | None:
    """Return whether a comparison with the accumulator holds, None if that is unknown."""
    compare = _COMPARISONS.get(command.function)
    number = float(command.value) if command.kind == NUMBER else None
    return None if compare is None or number is None else compare(value, number)


RULE = Rule(
    code="constant-condition",
    text="""\
Both sides of a comparison are constants; or a number is an operand of And or Or by itself, as in `If n = 1 Or 2 Then`,
which is always true; or `!` or `~`, which invert bits, stand for Not, as in `PAUSE !INX(5)`. There is no warning for a
constant alone, because `If _DEBUG Then` is a switch and `While 1` an intended endless loop.

In MCCL: IB, IE, IG or IU compares the accumulator after an AL with a number, and nothing between them can change it.
""",
    fix="compare each value, as in n = 1 Or n = 2",
    mint=RuleCase(
        check_mint,
        wrong="Dim n = INX(1)\nIf n = 1 Or 2 Then OUTX(1) = 1\n",
        right="Dim n = INX(1)\nIf n = 1 Or n = 2 Then OUTX(1) = 1\n",
    ),
    mccl=RuleCase(check_mccl, wrong="AL5,IE6,TR0,NO\n", right="GA1,IE6,TR0,NO\n"),
)
