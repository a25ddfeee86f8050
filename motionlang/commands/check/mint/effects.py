"""The linter's model of a program: effects of steps on axes, and the call graph.

It also records the functions that run concurrently: the parent task, the tasks and the event handlers.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TypeVar

from motionlang.kernel import Keyword
from motionlang.kernel.lang import ENDLESS, STOP, TEST, UNTIL, StepGraph, Vocabulary
from motionlang.kernel.mint.resolve.folding import Known, fold
from motionlang.kernel.mint.resolve.handlers import handled, label_handlers
from motionlang.kernel.mint.resolve.names import Names
from motionlang.kernel.mint.resolve.symbols import Function, Symbol
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import by_kind, meant, walk

AnyNode = TypeVar("AnyNode", bound=nodes.Node)

# An axis: its number, the parameter of a sub that holds it, or None if it is unknown.
Key = int | Symbol | None
# Roles of keywords that command an axis. A keyword that only stops an axis is not among them.
COMMANDS = frozenset(("move", "entry", "course", "path", "go", "act", "zero", "scale"))


def _role(row: Keyword, written: bool) -> str:
    """Return the role of a keyword, its effect on the axes that it names.

    The role is "read", a name from `ROLES`, "slot" (sets a property of moves) or "use" (any other
    assignment or command).
    """
    if not written:
        return "read"
    return row.role or ("slot" if row.gives else "use")


class Act:
    """One use of a keyword, or one call of a sub.

    `role` is its effect, `row` its keyword, `values` the values assigned, and `node` its name in the tree.
    `axes` is empty for a keyword without axes. A call has the role "call", a `callee`, and the arguments in `values`.
    """

    __slots__ = ("axes", "callee", "node", "role", "row", "values")

    def __init__(
        self,
        role: str,
        row: Keyword | None,
        node: nodes.Name,
        axes: tuple[Key, ...] = (),
        values: list[nodes.Expr] | None = None,
        callee: Function | None = None,
    ) -> None:
        self.role, self.row, self.node, self.axes, self.callee = role, row, node, axes, callee
        self.values = values or []

    @property
    def at(self) -> int:
        return self.node.start

    def value(self, number: int) -> nodes.Expr | None:
        """Return the value for the n-th axis; the last value applies to all further axes."""
        return self.values[min(number, len(self.values) - 1)] if self.values else None


class Facts:
    """The facts about a module that all checks share.

    If it `has_host`, a host reads and writes the declared global variables of the module.
    """

    def __init__(self, names: Names, graph: StepGraph, table: Vocabulary, has_host: bool = False) -> None:
        self.names, self.graph, self.table = names, graph, table
        self.functions = names.functions
        # The points of each function.
        self.points = {function: graph.ranges[function.qualified_name] for function in names.functions}
        # The statement, the Case or the condition that is carried out at a point, and what it does with keywords.
        self.nodes_at: dict[int, nodes.Node] = {}
        self.acts: dict[int, list[Act]] = {}
        # The event handlers among the labels of each function, by their points.
        self.handlers = {function: self._handlers(function) for function in names.functions}
        # The nodes of each function by their classes, its acts, and the acts of all functions by keyword.
        self.nodes = {function: by_kind(function.body) for function in self.functions}
        self.acts_of: dict[Function, list[Act]] = {}
        self.used: dict[Keyword, list[Act]] = {}
        self._apart: set[Symbol] = set()  # parameters that name the only axis of their sub
        self._touched: dict[frozenset[str], dict[Function, set[Key]]] = {}
        self.default_axes = names.uses_axes  # then a keyword without brackets may mean any axis
        self.writers = self._writers()
        # The variables that labels which handle events assign to.
        self.handled = {
            self.symbol(name)
            for function in self.functions
            for node in handled(function, graph)
            for name in self.written(node)
        }
        self.roots = self._roots()
        self.retained, self.begun = self._find_retained()
        variables = [
            each for each in names.module.names.values() if each.kind == "variable" and each.declared
        ]
        self.hosted = set(variables) if has_host else set()
        self.retained |= self.hosted
        for function in self.functions:
            mine = self.acts_of[function] = []
            found = self._carried_out(function)
            for p in sorted(found):
                self.nodes_at[p] = found[p]
                self.acts[p] = list(self._acts(function, found[p]))
                mine += self.acts[p]
            self._resolve_parameters(function)
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

    def written_by(self, wanted: Callable[[Keyword], object]) -> Iterator[Act]:
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
                    for name in self.written(node):
                        symbol = self.symbol(name)
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

    def written(self, node: nodes.Node) -> Iterator[nodes.Name]:
        """Yield the names that a statement changes, including arrays and ByRef arguments."""
        if type(node) is nodes.Assign or type(node) is nodes.Input:
            target: nodes.Expr = node.target
            while type(target) is nodes.Member:
                target = target.value
            if type(target) is nodes.Name:
                yield target
        elif type(node) is nodes.For:
            yield node.variable
        elif type(node) is nodes.Name and node.args:
            symbol = node.symbol
            if symbol is not None and symbol.kind == "sub":
                for argument, parameter in zip(node.args, symbol.home.parameters, strict=False):
                    if type(argument) is nodes.Name and (parameter.by_ref or parameter.is_array):
                        yield argument

    def symbol(self, name: nodes.Name) -> Symbol | None:
        """Return the variable that a name refers to, directly or through a Define."""
        meaning = meant(name)
        return meaning.symbol if isinstance(meaning, nodes.Name) else name.symbol

    def value(self, node: nodes.Expr | None) -> Known | None:
        """Return the value of an expression, None if it is unknown before the run."""
        return None if node is None else fold(meant(node))

    def number(self, node: nodes.Expr | None) -> float | None:
        """Return the value of an expression if it is a known number, else None."""
        value = self.value(node)
        return value if isinstance(value, (int, float)) else None

    # ---------------------------------------------------------------------------------------------- acts

    def _acts(self, function: Function, node: nodes.Node) -> Iterator[Act]:
        written: nodes.Expr | None = None
        target: nodes.Expr | None = None
        if isinstance(node, nodes.Assign | nodes.Call):
            target = node.target
            written = meant(node.target)
        for expression in own_expressions(node):
            for name in reversed(list(walk([expression]))):
                if (
                    type(name) is nodes.Name
                    and name is not written
                    and (written is None or name is not target)
                ):
                    yield from self._word(function, name, False, [])
        if type(written) is nodes.Name:
            values = node.values if type(node) is nodes.Assign else []
            yield from self._word(function, written, True, values)

    def _word(
        self, function: Function, name: nodes.Name, written: bool, values: list[nodes.Expr]
    ) -> Iterator[Act]:
        symbol, row = name.symbol, name.row
        if symbol is not None:
            if symbol.kind == "sub" and not (
                function.result and function.result.name == symbol.name and written
            ):
                yield Act("call", None, name, values=name.args, callee=symbol.home)
            elif name.definition is not None:
                for inner in walk([name.definition]):
                    if type(inner) is nodes.Name:
                        yield from self._word(function, inner, False, [])
            return
        if row is None or row.kind in ("function", "constant", "statement"):
            return
        yield Act(_role(row, written), row, name, self._axes(name, row), values)

    def _axes(self, name: nodes.Name, row: Keyword) -> tuple[Key, ...]:
        if row.does("all"):
            return (None,)
        kinds = row.index.split(", ")
        if not {"axis", "axes"} & set(kinds):
            return ()
        if not name.args:
            return (None,) if self.default_axes else (0,)
        found = []
        for number, argument in enumerate(name.args):
            if kinds[min(number, len(kinds) - 1)] in ("axis", "axes"):
                found.append(self._key(argument))
        return tuple(found)

    def _key(self, node: nodes.Expr) -> Key:
        number = self.number(node)
        if number is not None:
            return int(number) if number == int(number) else None
        symbol = node.symbol if type(node) is nodes.Name and node.args is None else None
        if symbol is not None and symbol.kind == "parameter" and not (symbol.by_ref or symbol.is_array):
            return symbol if symbol not in self.writers else None
        return None

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
                value = self.number(act.value(number))
                known = found.setdefault(key, [])
                if value is None:
                    found[key] = None
                elif known is not None:
                    known.append(value)
        return found

    def key_of(self, name: nodes.Name) -> Key:
        """Return the axis that a keyword names, None unless it is one known axis."""
        row = name.row
        axes = self._axes(name, row) if row is not None else ()
        key = axes[0] if len(axes) == 1 else None
        return None if isinstance(key, Symbol) and key not in self._apart else key

    def _resolve_parameters(self, function: Function) -> None:
        """Replace parameters by "any axis" if the function names more than one axis.

        A parameter may be the same axis as another one that the function names.
        """
        mine = self.acts_of[function]
        keys = {key for act in mine for key in act.axes}
        if len(keys) > 1:
            for act in mine:
                act.axes = tuple(None if isinstance(key, Symbol) else key for key in act.axes)
        else:
            self._apart.update(key for key in keys if isinstance(key, Symbol))

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
        calls: dict[Function, list[tuple[Function, Act]]] = {}
        for function, acts in self.acts_of.items():
            found[function] = {key for act in acts if act.role in roles for key in act.axes}
            for act in acts:
                if act.callee is not None:
                    calls.setdefault(act.callee, []).append((function, act))
        grown = list(calls)
        while grown:
            callee = grown.pop()
            for caller, act in calls.get(callee, ()):
                more = {self.outer(act, key) for key in found[callee]} - found[caller]
                if more:
                    found[caller] |= more
                    grown.append(caller)
        return found

    def outer(self, call: Act, key: Key) -> Key:
        """Return the caller's axis that corresponds to an axis of the called sub."""
        if not isinstance(key, Symbol):
            return key
        assert call.callee is not None
        for argument, parameter in zip(call.values, call.callee.parameters, strict=False):
            if parameter is key:
                return self._key(argument)
        return None


def own_expressions(node: nodes.Node) -> list[nodes.Node]:
    """Return the expressions that a step evaluates itself, without inner blocks."""
    kind = type(node)
    if kind is nodes.For:
        return [each for each in (node.first, node.stop, node.step) if each is not None]  # type: ignore[attr-defined]
    if kind is nodes.Select:
        return [node.subject]  # type: ignore[attr-defined]
    if kind is nodes.Case:
        return list(node.tests)  # type: ignore[attr-defined]
    if kind is nodes.Loop or kind is nodes.Repeat:
        return []
    return [node]


def spelt(key: Key) -> str:
    """Return an axis as shown in messages: its number, or the parameter that holds it."""
    return "?" if key is None else key.name if isinstance(key, Symbol) else str(key)
