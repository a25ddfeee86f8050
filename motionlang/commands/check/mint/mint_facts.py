"""The facts about a Mint program: those of any program, its variables, and the nodes of its tree."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TypeVar

from motionlang.commands.check.axis_state import IDLE, MOVES, AllAxes, AxisFacts
from motionlang.commands.check.rule_facts import Facts, Part
from motionlang.commands.check.silence import has_host
from motionlang.kernel.lang import AxisKey as Key
from motionlang.kernel.lang import Use
from motionlang.kernel.mint import MintProgram
from motionlang.kernel.mint.resolve.folding import Known, binary, fold
from motionlang.kernel.mint.resolve.handlers import handled, label_handlers
from motionlang.kernel.mint.resolve.statements import axes_of
from motionlang.kernel.mint.resolve.symbols import Function, Symbol
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import by_kind, changed, meaning, meant, walk

# The values of the modes of limits with which an axis stops there.
_STOPPING = frozenset((1.0, 2.0, 3.0, 4.0))
AnyNode = TypeVar("AnyNode", bound=nodes.Node)


class MintFacts(Facts):
    """The facts about a Mint program."""

    one_limit_arms_both = True

    def __init__(self, program: MintProgram) -> None:
        self.module, self.names = program.tree, program.checked
        self.functions = self.names.functions
        # The nodes of each function by their classes.
        self.nodes = {function: by_kind(function.body) for function in self.functions}
        # The variables that are passed by reference.
        self.referred: set[Symbol] = set()
        self.writers = self._writers()
        # The parameters that name the only axis of their sub.
        self._apart: set[Symbol] = set()
        graph = program.graph
        points: dict[Part, Sequence[int]] = {
            function: graph.ranges[function.qualified_name] for function in self.functions
        }
        entries: dict[Part, list[int]] = {function: [own[0]] for function, own in points.items()}
        for function in self.functions:
            handlers = label_handlers(function)
            labels = ((p, name.lower()) for p, name in graph.labels.items() if p in points[function])
            entries[function] += [p for p, name in labels if name in handlers]
        by_name = {function.qualified_name: function for function in self.functions}
        super().__init__(program.structure, program.settings, entries, points, by_name)
        # The statement, the Case or the condition that is carried out at a point.
        self.nodes_at = self._nodes_at()
        loops = {id(each.condition) for each in self.of_kind(nodes.While)}
        self.polling = {
            p for p, node in self.nodes_at.items() if isinstance(node, nodes.Pause) or id(node) in loops
        }
        # The variables that labels which handle events assign to.
        self.handled = {
            meaning(name)
            for function in self.functions
            for node in handled(function, graph)
            for name in changed(node)
        }
        self.retained, self.begun = self._find_retained()
        variables = self.names.module.names.values()
        hosted = has_host(program.source, program.language)
        self.hosted = {each for each in variables if each.kind == "variable" and each.declared and hosted}
        self.retained |= self.hosted

    # ---------------------------------------------------------------------------------------------- the tree

    def of_kind(self, kind: type[AnyNode], function: Function | None = None) -> list[AnyNode]:
        """Return the nodes of a class in a function, or in the whole program."""
        if function is not None:
            return self.nodes[function].get(kind, [])
        return [node for found in self.nodes.values() for node in found.get(kind, ())]

    def nodes_of(self, function: Function) -> Iterator[tuple[int, nodes.Node]]:
        """Yield the points at which a function carries something out, with the statement or condition."""
        return ((p, self.nodes_at[p]) for p in self.points[function] if p in self.nodes_at)

    def _nodes_at(self) -> dict[int, nodes.Node]:
        found: dict[int, nodes.Node] = {}
        for function in self.functions:
            places = {statement.at: p for p, statement in self.statements_of(function)}
            for node in walk(function.body):
                if isinstance(node, nodes.If | nodes.While):
                    found[places.get(node.start, -1)] = node.condition
                elif isinstance(node, nodes.Stmt | nodes.Case):
                    found[places.get(node.start, -1)] = node
                if isinstance(node, nodes.Repeat):
                    found[places[node.condition.start]] = node.condition
        found.pop(-1, None)  # statements at which nothing happens
        return found

    # ---------------------------------------------------------------------------------------------- variables

    def _writers(self) -> dict[Symbol, set[Function]]:
        """Map each variable to the functions that assign to it after its declaration."""
        found: dict[Symbol, set[Function]] = {}
        for function in self.functions:
            for kind in (nodes.Assign, nodes.Input, nodes.For, nodes.Name):
                for node in self.of_kind(kind, function):
                    for name in changed(node):
                        symbol = meaning(name)
                        if symbol is not None:
                            found.setdefault(symbol, set()).add(function)
                            self.referred |= {symbol} if kind is nodes.Name else set()
        return found

    def _find_retained(self) -> tuple[set[Symbol], set[Symbol]]:
        """Return the `Dim nv` variables, and the variables that any Dim initialises.

        The next run may read the value of an nv variable.
        """
        retained: set[Symbol] = set()
        begun: set[Symbol] = set()
        for node in self.of_kind(nodes.Dim):
            for variable in node.variables:
                symbol = variable.symbol
                if symbol is not None and node.nv:
                    retained.add(symbol)
                if symbol is not None and variable.values:
                    begun.add(symbol)
        return retained, begun

    # ------------------------------------------------------------------------------------------- expressions

    def value(self, node: nodes.Expr | None) -> Known | None:
        """Return the value of an expression, None if it is unknown before the run."""
        return None if node is None else fold(meant(node))

    def number(self, node: nodes.Expr | None) -> float | None:
        """Return the value of an expression if it is a known number, else None."""
        value = self.value(node)
        return value if isinstance(value, (int, float)) else None

    def key_of(self, name: nodes.Name) -> Key:
        """Return the axis that a keyword names, None unless it is one known axis."""
        row = name.row
        axes = axes_of(name, row, self.names, self.writers) if row is not None else ()
        key = axes[0] if len(axes) == 1 else None
        if isinstance(key, str) and name.args and getattr(name.args[0], "symbol", None) not in self._apart:
            return None
        return key

    def resolved(self, part: Part, found: dict[int, list[Use]]) -> dict[int, list[Use]]:
        keys = {key for uses in found.values() for use in uses for key in use.axes}
        if len(keys) == 1 and isinstance(part, Function):
            self._apart.update(each for each in part.parameters if each.name in keys)
        return super().resolved(part, found)

    def limits_in_force(self, key: Key, axis: AxisFacts) -> frozenset[str]:
        return frozenset() if self._may_pass("SOFTLIMITMODE", key) else super().limits_in_force(key, axis)

    def triggered(self) -> set[Key]:
        """Return the axes whose moves may start without a GO."""
        return self.named("TRIGGERMODE")

    def passes_switches(self, key: Key) -> bool:
        return self._may_pass("LIMITMODE", key)

    def _may_pass(self, mode: str, key: Key) -> bool:
        """True if the program sets the mode of a limit to a value that does not stop the axis, or to an unknown one."""
        given = self.constants(mode)
        found = [given[each] for each in (key, None) if each in given]
        return any(values is None or not _STOPPING.issuperset(values) for values in found)

    def refined(self, p: int, truth: bool, state: AllAxes) -> AllAxes:
        node = self.nodes_at[p]
        condition = node.condition if isinstance(node, nodes.Pause) else node
        return self._refined(condition, truth, state) if isinstance(condition, nodes.Expr) else state

    def _at_level(self, node: nodes.Expr, results: list[object], truth: bool, state: AllAxes) -> AllAxes:
        """Return the state after a comparison with a number was `truth`.

        `results` are those of the comparison if `node` is 0 and if it is 1.
        """
        if set(results) != {0, 1}:  # the same for both, or no number
            return state
        return self._refined(node, results[1] == truth, state)

    def _refined(self, node: nodes.Expr, truth: bool, state: AllAxes) -> AllAxes:
        if type(node) is nodes.Unary and node.op == "Not":
            return self._refined(node.operand, not truth, state)
        if type(node) is nodes.Binary:
            if node.op == ("And" if truth else "Or"):
                return self._refined(node.right, truth, self._refined(node.left, truth, state))
            left, right = self.number(node.left), self.number(node.right)
            if right is not None:
                return self._at_level(
                    node.left, [binary(node.op, each, right) for each in (0, 1)], truth, state
                )
            if left is not None:
                return self._at_level(
                    node.right, [binary(node.op, left, each) for each in (0, 1)], truth, state
                )
            return state
        if type(node) is not nodes.Name:
            return state
        if node.symbol is not None:
            known = isinstance(node.definition, nodes.Name)
            return self._refined(node.definition, truth, state) if known else state  # type: ignore[arg-type]
        row = node.row
        if row is None or row.function != "is_idle":
            return state
        key = self.key_of(node)
        if key is None:
            return state
        axis = state[key]
        return state.put(
            key, axis._replace(motion=IDLE if truth else MOVES, fresh=False, jogs=axis.jogs and not truth)
        )
