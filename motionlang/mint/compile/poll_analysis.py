"""What the statements of a loop look at and give a value, for the watch on loops that poll.

Whether they do anything is counted as the program runs; here is said of which variables a turn is to be compared with
the one before, and at which moments a reading may answer differently by itself. Subs that the loop calls are part of
it, and so is what its Gosubs lead to.
"""

from __future__ import annotations

from motionlang.mint.compile.pause import COMPARED, moves, moves_by_itself, solved, spelled
from motionlang.mint.compile.polling import REPEATABLE
from motionlang.mint.resolve.symbols import NUMERIC, STRING, TIME
from motionlang.mint.syntax import nodes
from motionlang.mint.syntax.traversal import children, walk

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable

    from motionlang.lang.keyword import Keyword
    from motionlang.mint.compile.body import Body
    from motionlang.mint.resolve.symbols import Function, Scope, Symbol

# Arrays with more elements are not compared turn by turn.
MOST_ELEMENTS = 64


class Look:
    """One look at a loop of the function that is being written.

    `assigned`   the variables that it gives a value, as text
    `watches`    when readings change by themselves, as text
    `reads`      whether it reads what others can change
    `waits`      whether a turn may wait for a time
    `computes`   whether it gives a variable a value that depends on others
    `acts`       whether it does what cannot be followed, so that it is not watched at all
    `rewritten`  the keywords that it sets
    """

    def __init__(self, b: Body) -> None:
        self.b = b
        self.reads = self.waits = self.computes = self.acts = False
        self.assigned: set[str] = set()
        self.watches: list[str] = []
        self.rewritten: set[Keyword] = set()
        self._changed: set[Symbol] = set()
        self._compared: list[tuple[nodes.Binary, bool]] = []
        self._called: set[Function] = set()
        self._labels: set[str] = set()

    def at_all(
        self, body: Iterable[nodes.Stmt], conditions: Iterable[nodes.Expr] = (), *, is_written: bool = False
    ) -> None:
        """Look at a loop: its statements, whose text may be written already, its conditions, and all that it calls."""
        self._at(body, self.b.scope, is_written)
        self._at(conditions, self.b.scope, True)
        for node, was_written in self._compared:
            self._compare(node, was_written)

    def _at(self, found: Iterable[object], scope: Scope, is_written: bool) -> None:
        stack = list(found)
        while stack and not self.acts:
            node = stack.pop()
            if isinstance(node, nodes.Name):
                self._name(node, scope, is_written)
                stack += node.args or ()
            elif isinstance(node, nodes.Binary) and node.op in COMPARED and self._is_known_here(node, scope):
                self._compared.append((node, is_written))
            elif isinstance(node, nodes.Assign):
                stack += self._given(node.target, scope, node.values)
            elif isinstance(node, nodes.Call):
                stack += self._command(node.target, scope, is_written)
            elif node.__class__ not in _ACTS:
                self._other(node, scope)
                stack += children(node)

    def _other(self, node: object, scope: Scope) -> None:
        if isinstance(node, nodes.For):
            self._given(node.variable, scope)
        elif isinstance(node, nodes.Variable):
            self._given(nodes.Name(node.at, node.name), scope)
        elif isinstance(node, nodes.Jump) and node.kind == "gosub" and scope.function is self.b.function:
            self._gosub(node.name.lower())

    # ---------------------------------------------------------------------------------------- what is read

    def _name(self, node: nodes.Name, scope: Scope, is_written: bool) -> None:
        symbol = scope.find(node.name)
        if symbol is None:
            row = self.b.whole.table.get(node.name)
            if row is not None:
                self._keyword(node, row, is_written)
            return
        if symbol.kind == "sub":
            self._call(node, symbol, scope)
        elif symbol.kind == "define":
            self._at([symbol.node], scope, is_written)
        elif symbol.type.name == TIME:
            self._watch("('always',)")
        self.reads = self.reads or symbol.shared or symbol.by_ref

    def _keyword(self, node: nodes.Name, row: Keyword, is_written: bool) -> None:
        if row.verb == "wait":
            self.waits = True
        if row.kind in ("reading", "setting"):
            self.reads = True
        counts = moves_by_itself(row, counting=True)
        if not counts and not moves_by_itself(row, counting=False):
            return
        if is_written:
            self._watch("('always',)" if counts else "('moving',)")
        else:  # only the turns that come to it are no mere look
            self.b.whole.samples[id(node)] = "E.acts += 1" if counts else "E.task.sampled = True"

    def _compare(self, node: nodes.Binary, is_written: bool) -> None:
        """A comparison changes at a moment that can be solved, or whenever what it compares does."""
        steady = all(self.b.scope.find(name) not in self._changed for name in _names(node))
        watch = solved(self.b, node) if steady and moves(self.b, node) else None
        if watch is None:
            self._at([node.left, node.right], self.b.scope, is_written)
        else:
            self._watch(watch)

    def _is_known_here(self, node: nodes.Binary, scope: Scope) -> bool:
        """Whether all names of a comparison mean the same where the loop is."""
        here = self.b.scope
        return scope is here or all(scope.find(name) is here.find(name) for name in _names(node))

    def _watch(self, watch: str) -> None:
        self.reads = True
        if watch not in self.watches:
            self.watches.append(watch)

    # --------------------------------------------------------------------------------------- what is given

    def _given(
        self, target: nodes.Node, scope: Scope, values: list[nodes.Expr] | tuple[()] = ()
    ) -> list[nodes.Expr]:
        """A variable or a keyword is given a value: note it, and answer with what there is to look at yet."""
        while isinstance(target, nodes.Member):
            target = target.value
        if not isinstance(target, nodes.Name):
            return []
        symbol = scope.find(target.name)
        more = [*(target.args or ()), *values]
        if symbol is None:
            row = self.b.whole.table.get(target.name)
            return more if row is not None and self._is_set(row) else []
        if symbol.kind == "define" and target.args is None:
            assert isinstance(symbol.node, nodes.Node)
            return [*self._given(symbol.node, scope), *more]
        if symbol.kind == "sub":  # the result of the function
            result = scope.function.result
            symbol = symbol if result is None else result
        if symbol.type.name != TIME:  # which has another base after every turn that sets it
            self._changed.add(symbol)
        self.computes = self.computes or not values or any(_names(each) for each in values)
        if symbol.home is self.b.function or symbol.home.kind != "sub":
            text = _text(symbol)
            self.acts = self.acts or not text
            self.assigned.add(text)
        return more

    def _is_set(self, row: Keyword) -> bool:
        """Whether a keyword that is written may have had that value before; anything else is something done."""
        if row.verb == "wait":
            self.waits = True
        elif row.verb in REPEATABLE and row.kind != "move" and row.access == "RW":
            self.rewritten.add(row)
        else:
            return False
        return True

    # ------------------------------------------------------------------------------------- what is called

    def _command(self, target: nodes.Name, scope: Scope, is_written: bool) -> list[nodes.Expr]:
        """A sub, or a keyword that stands alone, which is something done."""
        symbol = scope.find(target.name)
        row = self.b.whole.table.get(target.name) if symbol is None else None
        if row is not None and row.verb != "wait":
            return []
        self._name(target, scope, is_written)
        return target.args or []

    def _call(self, node: nodes.Name, symbol: Symbol, scope: Scope) -> None:
        callee = symbol.home
        for arg, parameter in zip(node.args or (), callee.parameters, strict=False):
            if parameter.by_ref or parameter.is_array:
                self._given(arg, scope)
        if callee not in self._called:
            self._called.add(callee)
            self._at(callee.body, callee.scope, callee in self.b.whole.written)

    def _gosub(self, label: str) -> None:
        if label in self._labels:
            return
        self._labels.add(label)
        start = self.b.labels().get(label, 0)
        for _, body in self.b.stretches()[start:]:
            self._at(body, self.b.scope, True)
            if body and body[-1].__class__ in (nodes.Return, nodes.Jump, nodes.End):
                break


def _names(node: nodes.Node) -> list[str]:
    """The names in an expression."""
    return [each.name for each in walk([node]) if isinstance(each, nodes.Name)]


def _text(symbol: Symbol) -> str:
    """A variable as Python text, with a value that can be compared; "" where there is none."""
    if symbol.type.name not in (*NUMERIC, STRING):
        return ""
    if symbol.is_array:
        count = 1
        for size in symbol.dimensions:
            count *= size
        return f"tuple({symbol.python})" if 0 < count <= MOST_ELEMENTS else ""
    return spelled(symbol)


# Whoever does one of these has done something, whatever it looks at.
_ACTS = frozenset((nodes.Print, nodes.Input, nodes.End, nodes.Exit, nodes.Const, nodes.Define))
