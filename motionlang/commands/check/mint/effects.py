"""The linter's model of a program: effects of steps on axes, and the call graph.

It also records the functions that run concurrently: the parent task, the tasks and the event handlers.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import TypeVar

from motionlang.kernel import Keyword
from motionlang.kernel.lang import ENDLESS, STOP, TEST, UNTIL, Structure, Use, Vocabulary
from motionlang.kernel.lang import AxisKey as Key
from motionlang.kernel.mint.resolve.facts import axes_of, changed, meaning
from motionlang.kernel.mint.resolve.folding import Known, fold
from motionlang.kernel.mint.resolve.handlers import handled, label_handlers
from motionlang.kernel.mint.resolve.names import Names
from motionlang.kernel.mint.resolve.symbols import Function, Symbol
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import by_kind, meant, walk

AnyNode = TypeVar("AnyNode", bound=nodes.Node)

# Roles of keywords that command an axis. A keyword that only stops an axis is not among them.
COMMANDS = frozenset(("move", "entry", "course", "path", "go", "act", "zero", "scale"))


class Facts:
    """The facts about a module that all checks share.

    If it `has_host`, a host reads and writes the declared global variables of the module.
    """

    def __init__(self, names: Names, structure: Structure, table: Vocabulary, has_host: bool = False) -> None:
        self.names, self.table = names, table
        self.graph = graph = structure.graph
        self.functions = names.functions
        self._by_name = {function.qualified_name: function for function in names.functions}
        # The points of each function.
        self.points = {function: graph.ranges[function.qualified_name] for function in names.functions}
        # The statement, the Case or the condition that is carried out at a point, and what it does with keywords.
        self.nodes_at: dict[int, nodes.Node] = {}
        self.acts: dict[int, list[Use]] = {}
        # The event handlers among the labels of each function, by their points.
        self.handlers = {function: self._handlers(function) for function in names.functions}
        # The nodes of each function by their classes, its acts, and the acts of all functions by keyword.
        self.nodes = {function: by_kind(function.body) for function in self.functions}
        self.acts_of: dict[Function, list[Use]] = {}
        self.used: dict[Keyword, list[Use]] = {}
        self._apart: set[Symbol] = set()  # parameters that name the only axis of their sub
        self._touched: dict[frozenset[str], dict[Function, set[Key]]] = {}
        self.writers = self._writers()
        # The variables that labels which handle events assign to.
        self.handled = {
            meaning(name)
            for function in self.functions
            for node in handled(function, graph)
            for name in changed(node)
        }
        self.roots = self._roots()
        self.retained, self.begun = self._find_retained()
        variables = [
            each for each in names.module.names.values() if each.kind == "variable" and each.declared
        ]
        self.hosted = set(variables) if has_host else set()
        self.retained |= self.hosted
        for function in self.functions:
            found = self._carried_out(function)
            self.nodes_at |= found
            uses = {p: structure.statements[graph.points[p].at].uses for p in sorted(found)}
            self.acts |= self._resolved(function, uses)
            mine = self.acts_of[function] = [act for p in uses for act in self.acts[p]]
            for act in mine:
                if act.row is not None:
                    self.used.setdefault(act.row, []).append(act)

    # ------------------------------------------------------------------------------------- who and where

    def _handlers(self, function: Function) -> list[int]:
        handlers, own = label_handlers(function), self.points[function]
        return [p for p, name in self.graph.labels.items() if p in own and name.lower() in handlers]

    def nodes_of(self, function: Function) -> Iterator[tuple[int, nodes.Node]]:
        """Yield the points at which a function carries something out, with the statement or condition."""
        return ((p, self.nodes_at[p]) for p in self.points[function] if p in self.nodes_at)

    def reached(self, function: Function) -> set[int]:
        """Return the points of a function that its beginning and the handlers among its labels lead to."""
        return self.graph.reached_within(self.points[function][0], *self.handlers[function])

    def is_test(self, p: int) -> bool:
        """True if a condition is tested at a point."""
        return self.graph.points[p].role in (TEST, UNTIL, ENDLESS)

    def leaves(self, p: int) -> bool:
        """True if a function is left at a point, by a return, an Exit or the end of its text."""
        return not self.graph.within[p] and self.graph.points[p].role != STOP

    def _carried_out(self, function: Function) -> dict[int, nodes.Node]:
        """Return what is carried out at each point: a condition at its test, a statement at its first step."""
        firsts: dict[int, int] = {}
        tests: dict[int, int] = {}
        for p in self.points[function]:
            point = self.graph.points[p]
            firsts.setdefault(point.at, p)
            if self.is_test(p):
                tests[point.at] = p
        found: dict[int, nodes.Node] = {}
        for node in walk(function.body):
            where, at = firsts, node.start
            if isinstance(node, nodes.If | nodes.While):
                where, node = tests, node.condition
            elif isinstance(node, nodes.Repeat):
                found[tests[node.condition.start]] = node.condition
            elif not isinstance(node, nodes.Stmt | nodes.Case):
                continue
            if at in where:
                found[where[at]] = node
        return found

    def written_by(self, wanted: Callable[[Keyword], object]) -> Iterator[Use]:
        """Yield the uses, other than reads, of the keywords that are `wanted`."""
        for row, acts in self.used.items():
            if wanted(row):
                yield from (act for act in acts if act.role != "read")

    def of_kind(self, kind: type[AnyNode], function: Function | None = None) -> list[AnyNode]:
        """Return the nodes of a class in a function, or in the whole program."""
        if function is not None:
            return self.nodes[function].get(kind, [])
        return [node for found in self.nodes.values() for node in found.get(kind, ())]

    def called(self, function: Function) -> list[Function]:
        """Return the function and all that it calls, directly or indirectly, each once."""
        found: dict[Function, None] = {}
        stack = [function]
        while stack:
            each = stack.pop()
            if each not in found:
                found[each] = None
                stack.extend(sorted(each.calls, key=lambda f: f.at, reverse=True))
        return list(found)

    def _roots(self) -> dict[Function, set[Function]]:
        """Map each function to the parent task, tasks and handlers that run it.

        Label handlers belong to the parent task.
        """
        found: dict[Function, set[Function]] = {function: set() for function in self.functions}
        for root in self.functions:
            if root.kind != "sub":
                for function in self.called(root):
                    found[function].add(root)
        return found

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

    def value(self, node: nodes.Expr | None) -> Known | None:
        """Return the value of an expression, None if it is unknown before the run."""
        return None if node is None else fold(meant(node))

    def number(self, node: nodes.Expr | None) -> float | None:
        """Return the value of an expression if it is a known number, else None."""
        value = self.value(node)
        return value if isinstance(value, (int, float)) else None

    # ---------------------------------------------------------------------------------------------- acts

    def given(self, *effects: str) -> set[Key]:
        """Return the axes of all keywords with one of these effects, except in reads."""
        acts = self.written_by(lambda row: any(map(row.does, effects)))
        return {key for act in acts for key in act.axes}

    def named(self, word: str) -> set[Key]:
        """Return the axes for which the program writes or executes a keyword."""
        return {key for act in self.written_by(lambda row: row.name == word) for key in act.axes}

    def word(self, verb: str) -> str:
        """Return the keyword with this verb that the program uses, "" if it uses none."""
        return next((row.name for row in self.used if row.verb == verb), "")

    def constants(self, word: str) -> dict[Key, list[float] | None]:
        """Map each axis to the constants that a keyword assigns to it.

        An axis maps to None if one of the values is unknown.
        """
        found: dict[Key, list[float] | None] = {}
        for act in self.written_by(lambda row: row.name == word):
            for number, key in enumerate(act.axes):
                value = act.number(number)
                known = found.setdefault(key, [])
                if value is None:
                    found[key] = None
                elif known is not None:
                    known.append(value)
        return found

    def key_of(self, name: nodes.Name) -> Key:
        """Return the axis that a keyword names, None unless it is one known axis."""
        row = name.row
        axes = axes_of(name, row, self.names, self.writers) if row is not None else ()
        key = axes[0] if len(axes) == 1 else None
        if isinstance(key, str) and name.args and getattr(name.args[0], "symbol", None) not in self._apart:
            return None
        return key

    def _resolved(self, function: Function, found: dict[int, list[Use]]) -> dict[int, list[Use]]:
        """Return the uses of a function, with "any axis" for its parameters if it names more than one axis.

        A parameter may be the same axis as another one that the function names.
        """
        keys = {key for uses in found.values() for use in uses for key in use.axes}
        if len(keys) > 1:
            return {p: [_without_parameters(use) for use in uses] for p, uses in found.items()}
        self._apart.update(each for each in function.parameters if each.name in keys)
        return found

    def touched(self, function: Function, roles: frozenset[str]) -> set[Key]:
        """Return the axes that a function and its callees use in one of these roles.

        The axes are those of the caller: parameters of callees are replaced by their arguments.
        """
        known = self._touched.get(roles)
        if known is None:
            known = self._touched[roles] = self._all_touched(roles)
        return known[function]

    def _all_touched(self, roles: frozenset[str]) -> dict[Function, set[Key]]:
        """Return the axes that each function uses in these roles.

        They are computed to a fixed point, because subs may be recursive.
        """
        found: dict[Function, set[Key]] = {}
        calls: dict[Function, list[tuple[Function, Use]]] = {}
        for function, acts in self.acts_of.items():
            found[function] = {key for act in acts if act.role in roles for key in act.axes}
            for act in acts:
                if act.callee:
                    calls.setdefault(self.callee(act), []).append((function, act))
        grown = list(calls)
        while grown:
            callee = grown.pop()
            for caller, act in calls.get(callee, ()):
                more = {self.outer(act, key) for key in found[callee]} - found[caller]
                if more:
                    found[caller] |= more
                    grown.append(caller)
        return found

    def callee(self, call: Use) -> Function:
        """Return the function that a call enters."""
        return self._by_name[call.callee]

    def outer(self, call: Use, key: Key) -> Key:
        """Return the caller's axis that corresponds to an axis of the called sub."""
        if not isinstance(key, str):
            return key
        parameters = (each.name for each in self.callee(call).parameters)
        return next(
            (axis for axis, name in zip(call.arguments, parameters, strict=False) if name == key), None
        )


def spelt(key: Key) -> str:
    """Return an axis as shown in messages: its number, or the parameter that holds it."""
    return "?" if key is None else str(key)


def _without_parameters(use: Use) -> Use:
    axes = tuple(None if isinstance(key, str) else key for key in use.axes)
    return use if axes == use.axes else replace(use, axes=axes)
