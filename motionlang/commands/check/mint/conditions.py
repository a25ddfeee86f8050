"""Waits for a condition, and conditions that moving axes can never make true, for the rules about them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

from motionlang.commands.check.rule_facts import spelt
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import meant, walk

if TYPE_CHECKING:
    from motionlang.commands.check.axis_state import AllAxes
    from motionlang.commands.check.mint.mint_facts import MintFacts
    from motionlang.kernel.lang import AxisKey as Key
    from motionlang.kernel.mint.resolve.symbols import Function

# A loop with a condition.
Conditional = nodes.While | nodes.Repeat
COMPARISONS = frozenset(("=", "<>", "<", ">", "<=", ">="))
_OPPOSITE = {"=": "<>", "<>": "=", "<": ">=", ">=": "<", ">": "<=", "<=": ">"}
_MIRRORED = {"=": "=", "<>": "<>", "<": ">", ">": "<", "<=": ">=", ">=": "<="}
_LEAVES = (nodes.Exit, nodes.Jump, nodes.Return, nodes.End, nodes.Label, nodes.Run)
# The subjects whose settings let something other than the program stop an axis.
_MAY_STOP = frozenset(("buffer", "homing", "latches", "limits"))
# A position counts as out of reach if it is further away than this fraction of the distance moved: a motor
# overshoots, and a target is rounded to whole counts.
MARGIN = 0.05


class Awaited(NamedTuple):
    """A condition that the program waits for to become `truth`.

    `polls` is True unless the body of its loop leaves it or affects an axis. `at` is the offset of the wait.
    """

    condition: nodes.Expr
    truth: bool
    state: AllAxes
    at: int
    polls: bool


def is_truth_value(node: nodes.Expr) -> bool:
    """True if an expression is certainly 0 or 1."""
    if type(node) is nodes.Binary:
        return node.op in COMPARISONS or node.op in ("And", "Or")
    if type(node) is nodes.Unary:
        return node.op == "Not"
    return type(node) is nodes.Name and node.row is not None and node.row.unit == "bool"


def tested(facts: MintFacts) -> Iterator[nodes.Node]:
    """Yield the conditions of all reachable tests and waits."""
    for function in facts.functions:
        reached = facts.reached(function)
        for p, node in facts.nodes_of(function):
            if p in reached and type(node) is nodes.Pause:
                yield node.condition
            elif p in reached and facts.is_test(p):
                yield node


def awaited(facts: MintFacts, function: Function) -> Iterator[Awaited]:
    """Yield the conditions of every reachable PAUSE, While and Repeat of a function."""
    before = facts.axes.before[function]
    commands = {
        act.at
        for act in facts.acts_of[function]
        if act.role == "call" or (act.axes and act.role not in ("read", "slot"))
    }
    tests: dict[int, int] = {}
    for p, node in facts.nodes_of(function):
        if p in before and type(node) is nodes.Pause:
            yield Awaited(node.condition, True, before[p], node.start, True)
        elif p in before and facts.is_test(p):
            tests[id(node)] = p
    loops: list[Conditional] = [*facts.of_kind(nodes.While, function), *facts.of_kind(nodes.Repeat, function)]
    for loop in loops:
        test = tests.get(id(loop.condition))
        if test is not None:
            polls = not any(
                isinstance(each, _LEAVES) or (isinstance(each, nodes.Name) and each.start in commands)
                for each in walk(loop.body)
            )
            truth = type(loop) is nodes.Repeat
            yield Awaited(loop.condition, truth, before[test], loop.condition.start, polls)


class Unattainable:
    """The search for conditions that the motion of the axes never makes true or false."""

    def __init__(self, facts: MintFacts) -> None:
        self._facts = facts
        self._stopped = facts.axes.stopped | _limited(facts)

    def why(self, node: nodes.Expr, truth: bool, state: AllAxes) -> tuple[str, str] | None:
        """Return why a condition never becomes `truth`, and a hint; None if it may."""
        node = meant(node)
        if type(node) is nodes.Unary and node.op == "Not":
            return self.why(node.operand, not truth, state)
        if type(node) is nodes.Binary and node.op in ("And", "Or"):
            found = [self.why(side, truth, state) for side in (node.left, node.right)]
            if (node.op == "And") is truth:
                return found[0] or found[1]
            return found[0] if all(found) else None
        if type(node) is nodes.Binary and node.op in COMPARISONS:
            return self._compared(node, truth, state)
        if type(node) is nodes.Name and node.row is not None and node.row.function == "is_idle" and truth:
            return self._idle(node, state)
        return None

    def _idle(self, name: nodes.Name, state: AllAxes) -> tuple[str, str] | None:
        key = self._facts.key_of(name)
        if not self._facts.axes.known(state, key).jogs or {key, None} & self._stopped:
            return None
        return (
            f"axis {spelt(key)} jogs until it is stopped",
            f"STOP({spelt(key)}) or JOG({spelt(key)}) = 0 first",
        )

    def _compared(self, node: nodes.Binary, truth: bool, state: AllAxes) -> tuple[str, str] | None:
        left, right, op = meant(node.left), meant(node.right), node.op
        if type(left) is not nodes.Name or left.row is None:
            left, right, op = right, left, _MIRRORED[op]
        number = self._facts.number(right)
        if type(left) is not nodes.Name or left.row is None or number is None:
            return None
        op = op if truth else _OPPOSITE[op]
        if left.row.function == "is_idle":
            # IDLE = 1 and IDLE <> 0 wait for standstill.
            return self._idle(left, state) if (op, number) in (("=", 1), ("<>", 0)) else None
        key = self._facts.key_of(left)
        span = self._facts.axes.known(state, key).span
        if left.row.function != "position" or span is None:
            return None
        low, high = span
        margin = MARGIN * (high - low)
        above = op in ("=", ">", ">=") and number > high + margin
        below = op in ("=", "<", "<=") and number < low - margin
        if not (above or below) or low == high:
            return None
        why = f"axis {spelt(key)} moves between {low:.10g} and {high:.10g}"
        return why, f"compare POS({spelt(key)}) with a position that a move reaches"


def _limited(facts: MintFacts) -> set[Key]:
    """Return the axes that something other than the program may stop."""
    found: set[Key] = set()
    for act in facts.written_by(lambda row: row.group in _MAY_STOP):
        found.update(act.axes or (None,))
    found.update(int(key.split(".")[1]) for key in facts.settings if key.startswith("axis."))
    return found
