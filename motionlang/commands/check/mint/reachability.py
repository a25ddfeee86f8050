"""Checks of control flow: dead code, endless waits and loops, constant conditions."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from motionlang.commands.check.axis_state import IDLE, Follower, State
from motionlang.commands.check.mint.facts import MintFacts
from motionlang.commands.check.silence import driven_inputs
from motionlang.kernel.mint.keywords.event_kinds import kind_and_number, label_event
from motionlang.kernel.mint.resolve.facts import changed, meaning
from motionlang.kernel.mint.resolve.symbols import TIME, Function, Symbol
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import walk

Add = Callable[..., None]

_COMPARED = frozenset(("=", "<>", "<", ">", "<=", ">="))
# Statements that do nothing themselves, or that are commonly written as a precaution at the end of a block.
_SILENT = (nodes.End, nodes.Return, nodes.Exit, nodes.Dim, nodes.Const, nodes.Define, nodes.Label, nodes.Auto)
_LEAVES = (nodes.Exit, nodes.Jump, nodes.Return, nodes.End, nodes.Label)


class Reachability:
    """The checks of control flow.

    `settings` are those of the machine file. `add` records a warning.
    """

    def __init__(
        self, facts: MintFacts, follower: Follower, settings: Mapping[str, object], add: Add
    ) -> None:
        self.facts, self.follower, self.settings, self.add = facts, follower, settings, add
        # Without a machine file any input may change.
        self.driven = driven_inputs(settings)

    def check(self, function: Function) -> None:
        """Run all checks of control flow on a function."""
        reached = self.facts.reached(function)
        self._unreachable(function, reached)
        self._labels(function)
        for p, node in self.facts.nodes_of(function):
            if p in reached:
                self._carried_out(function, p, node)
        for loop in self.facts.of_kind(nodes.While, function):
            self._endless_loop(function, loop)
        for repeat in self.facts.of_kind(nodes.Repeat, function):
            self._endless_loop(function, repeat)

    # ------------------------------------------------------------------------------------------ never reached

    def _unreachable(self, function: Function, reached: set[int]) -> None:
        """Report the first statement of each unreachable run of statements."""
        is_reported = False
        for p, node in self.facts.nodes_of(function):
            if p in reached:
                is_reported = False
            elif not is_reported and not isinstance(node, _SILENT):
                is_reported = True
                self.add("unreachable", "this statement is unreachable", node.start,
                         "the code before it never ends")  # fmt: skip

    def _labels(self, function: Function) -> None:
        targets = {node.name.lower() for node in self.facts.of_kind(nodes.Jump, function)}
        for label in self.facts.of_kind(nodes.Label, function):
            handler = function.kind == "main" and label_event(label.name) is not None
            if label.name.lower() not in targets and not handler and " " not in label.name:
                event = function.kind == "main" and kind_and_number(label.name) is not None
                hint = f"Mint v4 has no event {label.name} for programs; MintMT has one" if event else ""
                self.add("unused-label", f"label {label.name} is never used", label.start, hint)

    # ---------------------------------------------------------------------------------------------- conditions

    def _carried_out(self, function: Function, p: int, node: nodes.Node) -> None:
        if type(node) is nodes.Pause:
            self._wait(function, p, node)
            self._fixed(node.condition)
        elif self.facts.is_test(p):
            self._fixed(node)

    def _fixed(self, node: nodes.Node) -> None:
        """Report a comparison of constants, or an uncompared number next to And or Or."""
        if type(node) is nodes.Binary and node.op in _COMPARED:
            value = self.facts.number(node)
            if value is not None:
                self.add(
                    "constant-condition",
                    f"this condition is always {'true' if value else 'false'}",
                    node.start,
                )
        elif type(node) is nodes.Binary and node.op in ("And", "Or"):
            for side in (node.left, node.right):
                if type(side) is nodes.Number:
                    self._lone_number(node, side)
                else:
                    self._fixed(side)
        elif type(node) is nodes.Unary and node.op == "Not":
            self._fixed(node.operand)

    def _lone_number(self, node: nodes.Binary, side: nodes.Number) -> None:
        always = (
            "true"
            if (node.op == "Or") and side.value
            else "false"
            if not side.value and node.op == "And"
            else ""
        )
        effect = f"so the condition is always {always}" if always else "so it changes nothing"
        self.add(
            "constant-condition",
            f"{side.value:.10g} is an operand of {node.op} on its own, {effect}",
            side.start,
            "compare it, as in x = 1 Or x = 2; & and | work on bits",
        )

    # --------------------------------------------------------------------------------- waits that nothing ends

    def _wait(self, function: Function, p: int, node: nodes.Pause) -> None:
        state = self.follower.before[function].get(p)
        names = [each for each in walk([node.condition]) if type(each) is nodes.Name]
        if state is None or not names or self.facts.value(node.condition) is not None:
            return
        words = [each for name in names for each in self._inner(name)]
        if any(self._may_change(function, each, state) for each in words):
            return
        keywords = [name.name for name in words if name.symbol is None]
        why = f"axis {self._axis(words)} is at rest" if keywords and self._is_at_rest(words) else (
            "no entry of the machine file drives it" if keywords else "no other task and no event changes it"
        )  # fmt: skip
        self.add("endless-wait", f"this waits for a condition that cannot change: {why}", node.start,
                 "it continues at once or never")  # fmt: skip

    def _inner(self, name: nodes.Name) -> list[nodes.Name]:
        """Return a name or, if it is a Define, the names in its expression."""
        if name.definition is None:
            return [name]
        return [each for each in walk([name.definition]) if type(each) is nodes.Name]

    def _is_at_rest(self, words: list[nodes.Name]) -> bool:
        rows = [each.row for each in words]
        return any(row is not None and row.changes == "motion" for row in rows)

    def _axis(self, words: list[nodes.Name]) -> str:
        for each in words:
            row = each.row
            if row is not None and row.changes == "motion":
                key = self.facts.key_of(each)
                return str(key)
        return ""

    def _may_change(self, function: Function, name: nodes.Name, state: State) -> bool:
        symbol, row = name.symbol, name.row
        if symbol is not None:
            return self._variable_may_change(function, symbol)
        if row is None:
            return True
        if row.kind == "constant":
            return False
        if row.kind == "function":
            return row.changes == "always"
        if row.changes == "motion":
            return self.follower.known(state, self.facts.key_of(name)).motion != IDLE
        if row.driven == "input" and row.index == "input":
            return self._input_may_change(name)
        return True

    def _variable_may_change(self, function: Function, symbol: Symbol) -> bool:
        """True if another task, an event handler or a host may change a variable while this function runs."""
        if symbol.kind == "const":
            return False
        if symbol.kind not in ("variable", "parameter") or symbol.type.name == TIME or symbol.by_ref:
            return True
        if symbol in self.facts.hosted or symbol in self.facts.handled:
            return True
        mine = self.facts.roots[function]
        if len(mine) != 1:
            return True
        writers = self.facts.writers.get(symbol, set())
        return any(self.facts.roots[writer] - mine for writer in writers)

    def _input_may_change(self, name: nodes.Name) -> bool:
        if self.driven is None or not name.args:
            return True
        channel = self.facts.number(name.args[0])
        return channel is None or channel in self.driven

    # ---------------------------------------------------------------------------------- loops that nothing ends

    def _endless_loop(self, function: Function, node: nodes.While | nodes.Repeat) -> None:
        names = [each for each in walk([node.condition]) if type(each) is nodes.Name]
        symbols = [each.symbol for each in names]
        if not names or self.facts.value(node.condition) is not None:
            return
        inputs = [name for name, symbol in zip(names, symbols, strict=True) if self._is_dead(name, symbol)]
        for name, symbol in zip(names, symbols, strict=True):
            if symbol is None and name not in inputs:
                row = name.row
                if row is None or row.kind not in ("constant", "function") or row.changes == "always":
                    return
            elif symbol is None:
                continue
            elif symbol.kind != "const" and (
                symbol.kind not in ("variable", "parameter") or self._variable_may_change(function, symbol)
            ):
                return
        inside = list(walk(node.body))
        if any(isinstance(each, _LEAVES) for each in inside):
            return
        written = {meaning(each) for inner in inside for each in changed(inner)}
        calls = [each for each in inside if type(each) is nodes.Name and self._calls(each)]
        if written & {each for each in symbols if each is not None} or (
            calls and any(self._written_elsewhere(function, each) for each in symbols)
        ):
            return
        word = "While" if type(node) is nodes.While else "Repeat"
        if inputs:
            message = f"this {word} waits for a condition that cannot change: no entry of the machine file drives it"
            self.add("endless-wait", message, inputs[0].start, "it ends at once or never")
            return
        self.add("endless-loop", f"nothing in this {word} changes what its condition depends on", node.start,
                 "the program never leaves it")  # fmt: skip

    def _is_dead(self, name: nodes.Name, symbol: Symbol | None) -> bool:
        """True if a name is an input that nothing drives."""
        row = name.row
        is_input = row is not None and row.driven == "input" and row.index == "input"
        return is_input and not self._input_may_change(name)

    def _written_elsewhere(self, function: Function, symbol: Symbol | None) -> bool:
        """True if a function that this one calls may write the variable."""
        if symbol is None:
            return False
        return symbol.home is not function or bool(self.facts.writers.get(symbol, set()) - {function})

    def _calls(self, name: nodes.Name) -> bool:
        return name.symbol is not None and name.symbol.kind == "sub"
