"""What the statements of a loop look at and give a value, for the watch on loops that poll.

Whether they do anything is counted as the program runs; here is said of which variables a turn is to be compared with
the one before. Subs that the loop calls are part of it, and so is what its Gosubs lead to.
"""

from __future__ import annotations

from motionlang.mint.compile.polling import is_repeated
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
    `reads`      whether it reads what others can change
    `computes`   whether it gives a variable a value that depends on others
    `acts`       whether it does what cannot be followed, so that it is not watched at all
    `rewritten`  the keywords that it sets
    """

    def __init__(self, b: Body, turn: Iterable[object]) -> None:
        self.b = b
        self.reads = self.computes = self.acts = False
        self.assigned: set[str] = set()
        self.rewritten: set[Keyword] = set()
        self._called: set[Function] = set()
        self._labels: set[str] = set()
        self._at(turn, b.scope)

    def _at(self, found: Iterable[object], scope: Scope) -> None:
        stack = list(found)
        while stack and not self.acts:
            node = stack.pop()
            if isinstance(node, nodes.Name):
                self._name(node, scope)
                stack += node.args or ()
            elif isinstance(node, nodes.Assign):
                stack += self._given(node.target, scope, node.values)
            elif isinstance(node, nodes.Call):
                stack += self._command(node.target, scope)
            elif node.__class__ not in _ACTS:
                self._other(node, scope)
                stack += children(node)

    def _other(self, node: object, scope: Scope) -> None:
        if isinstance(node, nodes.For):
            self._given(node.variable, scope)
        elif isinstance(node, nodes.Variable):
            self._given(nodes.Name(node.at, node.name).resolve(node.symbol), scope)
        elif isinstance(node, nodes.Jump) and node.kind == "gosub" and scope.function is self.b.function:
            self._gosub(node.name.lower())

    # ---------------------------------------------------------------------------------------- what is read

    def _name(self, node: nodes.Name, scope: Scope) -> None:
        symbol, row = node.symbol, node.row
        if symbol is None:
            self.reads = self.reads or (row is not None and row.kind in ("reading", "setting"))
            return
        if symbol.kind == "sub":
            self._call(node, symbol, scope)
        elif node.stands is not None:
            self._at([node.stands], scope)
        self.reads = self.reads or symbol.shared or symbol.by_ref or symbol.type.name == TIME

    # --------------------------------------------------------------------------------------- what is given

    def _given(
        self, target: nodes.Node, scope: Scope, values: list[nodes.Expr] | tuple[()] = ()
    ) -> list[nodes.Expr]:
        """A variable or a keyword is given a value: note it, and answer with what there is to look at yet."""
        while isinstance(target, nodes.Member):
            target = target.value
        if not isinstance(target, nodes.Name):
            return []
        symbol = target.symbol
        more = [*(target.args or ()), *values]
        if symbol is None:
            row = target.row
            return more if row is not None and self._is_set(row) else []
        if target.stands is not None and target.args is None:
            return [*self._given(target.stands, scope), *more]
        if symbol.kind == "sub":  # the result of the function
            result = scope.function.result
            symbol = symbol if result is None else result
        self.computes = self.computes or not values or any(_names(each) for each in values)
        if symbol.home is self.b.function or symbol.home.kind != "sub":
            text = _text(symbol)
            self.b.spelt(symbol)
            self.acts = self.acts or not text
            self.assigned.add(text)
        return more

    def _is_set(self, row: Keyword) -> bool:
        """Whether a keyword that is written may have had that value before; anything else is something done."""
        if is_repeated(row):
            self.rewritten.add(row)
            return True
        return row.verb == "wait"

    # ------------------------------------------------------------------------------------- what is called

    def _command(self, target: nodes.Name, scope: Scope) -> list[nodes.Expr]:
        """A sub, or a keyword that stands alone, which is something done."""
        row = target.row
        if row is not None and row.verb != "wait":
            return target.args or [] if self._is_set(row) else []
        self._name(target, scope)
        return target.args or []

    def _call(self, node: nodes.Name, symbol: Symbol, scope: Scope) -> None:
        callee = symbol.home
        for arg, parameter in zip(node.args or (), callee.parameters, strict=False):
            if parameter.by_ref or parameter.is_array:
                self._given(arg, scope)
        if callee not in self._called:
            self._called.add(callee)
            self._at(callee.body, callee.scope)

    def _gosub(self, label: str) -> None:
        if label in self._labels:
            return
        self._labels.add(label)
        start = self.b.labels().get(label, 0)
        for _, body in self.b.stretches()[start:]:
            self._at(body, self.b.scope)
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
    if symbol.by_ref:
        return f"{symbol.python}[{symbol.python}_k]"
    return f"{symbol.python}[0]" if symbol.boxed else symbol.python


# Whoever does one of these has done something, whatever it looks at.
_ACTS = frozenset((nodes.Print, nodes.Input, nodes.End, nodes.Exit, nodes.Const, nodes.Define))
