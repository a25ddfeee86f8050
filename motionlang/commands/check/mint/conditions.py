"""Checks of conditions: those of moving axes, of a WAIT and of a PAUSE.

A WAIT takes a time, a PAUSE a condition. A moving axis is rarely read at exactly one position. A wait never ends if
the axis jogs, or if its moves never reach the position it waits for.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping

from motionlang.commands.check.axis_state import IDLE, MOVES, Axis, Follower, State
from motionlang.commands.check.facts import spelt
from motionlang.commands.check.mint.facts import MintFacts
from motionlang.kernel.lang import AxisKey as Key
from motionlang.kernel.mint import table
from motionlang.kernel.mint.resolve.symbols import Function
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import meant, walk

Add = Callable[..., None]

_COMPARED = frozenset(("=", "<>", "<", ">", "<=", ">="))
_OPPOSITE = {"=": "<>", "<>": "=", "<": ">=", ">=": "<", ">": "<=", "<=": ">"}
_MIRRORED = {"=": "=", "<>": "<>", "<": ">", ">": "<", "<=": ">=", ">=": "<="}
_POSITIONS = frozenset(("position", "demand"))
_LEAVES = (nodes.Exit, nodes.Jump, nodes.Return, nodes.End, nodes.Label, nodes.Run)
# The subjects whose settings let something other than the program stop an axis.
_MAY_STOP = frozenset(("buffer", "homing", "latches", "limits"))
_WAIT = re.compile(r"(\w+)[ \t]*=?[ \t]*")
# A position counts as out of reach if it is further away than this fraction of the distance moved: a motor
# overshoots, and a target is rounded to whole counts.
MARGIN = 0.05


class Conditions:
    """The checks of conditions; `add` records a warning."""

    def __init__(
        self,
        facts: MintFacts,
        follower: Follower,
        module: nodes.Module,
        settings: Mapping[str, object],
        add: Add,
    ) -> None:
        self.facts, self.follower, self.module, self.add = facts, follower, module, add
        self.limited = _limited(facts, settings)
        # The names in the function being checked that move or stop an axis, or call a sub.
        self._commands: set[int] = set()

    def check(self, function: Function) -> None:
        """Run all checks of conditions on a function."""
        before = self.follower.before[function]
        self._commands = {
            act.at
            for act in self.facts.acts_of[function]
            if act.role == "call" or (act.axes and act.role not in ("read", "slot"))
        }
        tests: dict[int, int] = {}
        for p, node in self.facts.nodes_of(function):
            if p not in before:
                continue
            if type(node) is nodes.Assign or type(node) is nodes.Call:
                self._wait_for_condition(node)
            elif type(node) is nodes.Pause:
                self._pause_for_time(node)
                self._waits(node.condition, True, before[p], node.start)
            elif self.facts.is_test(p):
                tests[id(node)] = p
                self._equalities(node, None, before[p])
        for loop, truth in self._loops(function):
            test = tests.get(id(loop.condition))
            if test is None:
                continue
            if self._only_polls(loop):
                self._waits(loop.condition, truth, before[test], loop.condition.start)
            else:
                self._equalities(loop.condition, truth, before[test])

    # ------------------------------------------------------------------------------------ WAIT with a condition

    def _wait_for_condition(self, node: nodes.Assign | nodes.Call) -> None:
        """Report a WAIT whose time is a condition, which is 0 or 1 ms."""
        target = meant(node.target)
        if type(target) is not nodes.Name or target.row is None or target.row.verb != "wait":
            return
        values = node.values if type(node) is nodes.Assign else target.args or []
        if len(values) != 1 or not self._is_condition(values[0]):
            return
        message = "WAIT takes a time in ms, and this is a condition: it waits 0 or 1 ms"
        self._wrong_wait(node, message, "PAUSE waits until a condition is true", "PAUSE")

    def _pause_for_time(self, node: nodes.Pause) -> None:
        """Report a PAUSE whose condition is a number above 1, which was meant as a time."""
        number = meant(node.condition)
        if type(number) is nodes.Number and number.value > 1:
            message = f"PAUSE takes a condition, and {number.value:.10g} is always true: it does not wait"
            word = next(row.name for row in table() if row.verb == "wait")
            self._wrong_wait(node, message, f"{word} waits for a time in ms", word)

    def _wrong_wait(self, node: nodes.Node, message: str, hint: str, word: str) -> None:
        """Report a WAIT or PAUSE that should be the other, which is `word`."""
        found = _WAIT.match(self.module.source.text, node.start)
        assert found is not None
        self.add(
            "wait-condition",
            message,
            node.start,
            hint,
            length=len(found[0].rstrip()),
            fix=(word if found[1].isupper() else word.capitalize()) + " " * (not found[0][-1:].isspace()),
        )

    def _is_condition(self, node: nodes.Expr) -> bool:
        node = meant(node)
        if type(node) is nodes.Binary:
            return node.op in _COMPARED or node.op in ("And", "Or")
        if type(node) is nodes.Unary:
            return node.op == "Not"
        return type(node) is nodes.Name and node.row is not None and node.row.unit == "bool"

    # --------------------------------------------------------------------------- equality with a moving position

    def _equalities(self, node: nodes.Node, truth: bool | None, state: State) -> None:
        """Report comparisons for equality of the position of a moving axis.

        `truth` is the value for which a program waits, None if it only branches.
        """
        for each in walk([node]):
            if type(each) is not nodes.Binary or each.op not in ("=", "<>"):
                continue
            for side, other in ((each.left, each.right), (each.right, each.left)):
                name = meant(side)
                if type(name) is not nodes.Name or name.row is None:
                    continue
                if name.row.verb not in _POSITIONS:
                    continue
                key = self.facts.key_of(name)
                axis = self.follower.known(state, key)
                wanted = truth is not None and (each.op == "=") is truth
                if axis.motion == MOVES or (wanted and axis.motion != IDLE):
                    self._equality(each, name, key, axis, self.facts.number(other))
                    break

    def _equality(
        self, node: nodes.Binary, name: nodes.Name, key: Key, axis: Axis, number: float | None
    ) -> None:
        assert name.row is not None
        what = f"{name.row.name}({spelt(key)})"
        if number is None or name.row.verb != "position":
            hint = "compare it with >= or <="
        elif number == axis.target:
            hint = f"PAUSE IDLE({spelt(key)}) waits for the end of the move"
        elif axis.span is not None and axis.target == axis.span[0] < axis.span[1]:
            hint = f"{what} <= {number:.10g} stays true from there on"
        elif axis.span is not None and axis.target == axis.span[1] > axis.span[0]:
            hint = f"{what} >= {number:.10g} stays true from there on"
        else:
            hint = f"compare it with >= {number:.10g} or <= {number:.10g}, as the axis moves"
        message = f"{what} is compared for equality while axis {spelt(key)} moves, which is rarely true"
        self.add("exact-position", message, node.start, hint)

    # ------------------------------------------------------------------------------------- waits that never end

    def _waits(self, node: nodes.Expr, truth: bool, state: State, at: int) -> None:
        """Report a wait for a condition to become `truth`, if that never happens."""
        why = self._never(node, truth, state)
        if why:
            self.add("endless-wait", f"this waits for a condition that cannot change: {why[0]}", at, why[1])
        else:
            self._equalities(node, truth, state)

    def _never(self, node: nodes.Expr, truth: bool, state: State) -> tuple[str, str] | None:
        """Return why a condition never becomes `truth`, and a hint; None if it may."""
        node = meant(node)
        if type(node) is nodes.Unary and node.op == "Not":
            return self._never(node.operand, not truth, state)
        if type(node) is nodes.Binary and node.op in ("And", "Or"):
            found = [self._never(side, truth, state) for side in (node.left, node.right)]
            if (node.op == "And") is truth:
                return found[0] or found[1]
            return found[0] if all(found) else None
        if type(node) is nodes.Binary and node.op in _COMPARED:
            return self._never_compared(node, truth, state)
        if type(node) is nodes.Name and node.row is not None and node.row.verb == "is_idle" and truth:
            return self._never_idle(node, state)
        return None

    def _never_idle(self, name: nodes.Name, state: State) -> tuple[str, str] | None:
        key = self.facts.key_of(name)
        if not self.follower.known(state, key).jogs or self._stops_otherwise(key):
            return None
        return (
            f"axis {spelt(key)} jogs until it is stopped",
            f"STOP({spelt(key)}) or JOG({spelt(key)}) = 0 first",
        )

    def _never_compared(self, node: nodes.Binary, truth: bool, state: State) -> tuple[str, str] | None:
        left, right, op = meant(node.left), meant(node.right), node.op
        if type(left) is not nodes.Name or left.row is None:
            left, right, op = right, left, _MIRRORED[op]
        number = self.facts.number(right)
        if type(left) is not nodes.Name or left.row is None or number is None:
            return None
        op = op if truth else _OPPOSITE[op]
        if left.row.verb == "is_idle":
            # IDLE = 1 and IDLE <> 0 wait for standstill.
            return self._never_idle(left, state) if (op, number) in (("=", 1), ("<>", 0)) else None
        key = self.facts.key_of(left)
        span = self.follower.known(state, key).span
        if left.row.verb != "position" or span is None:
            return None
        low, high = span
        margin = MARGIN * (high - low)
        above = op in ("=", ">", ">=") and number > high + margin
        below = op in ("=", "<", "<=") and number < low - margin
        if not (above or below) or low == high:
            return None
        why = f"axis {spelt(key)} moves between {low:.10g} and {high:.10g}"
        return why, f"compare POS({spelt(key)}) with a position that a move reaches"

    def _stops_otherwise(self, key: Key) -> bool:
        """True if an input, a limit, a handler or a task may stop the axis."""
        return bool({key, None} & (self.limited | self.follower.stopped))

    def _only_polls(self, loop: nodes.While | nodes.Repeat) -> bool:
        """True if the body of a loop neither leaves it nor affects an axis."""
        return not any(
            isinstance(each, _LEAVES) or (isinstance(each, nodes.Name) and each.start in self._commands)
            for each in walk(loop.body)
        )

    def _loops(self, function: Function) -> Iterator[tuple[nodes.While | nodes.Repeat, bool]]:
        """Yield each loop with a condition, and the truth value that ends it."""
        yield from ((node, False) for node in self.facts.of_kind(nodes.While, function))
        yield from ((node, True) for node in self.facts.of_kind(nodes.Repeat, function))


def _limited(facts: MintFacts, settings: Mapping[str, object]) -> set[Key]:
    """Return the axes that something other than the program may stop."""
    found: set[Key] = set()
    for act in facts.written_by(lambda row: row.group in _MAY_STOP):
        found.update(act.axes or (None,))
    found.update(int(key.split(".")[1]) for key in settings if key.startswith("axis."))
    return found
