"""The range analysis of one function: what is known of its own variables wherever they are read.

An abstract run over the tree with `ranges` in place of values. Loops are repeated until nothing new comes out; bounds
that keep moving jump to the next constant of the function, then to the ends of Integer and of the exact doubles. The
result holds for every real run: what it leaves out (shared variables, arrays, by-reference) counts as unknown.
"""

from __future__ import annotations

from motionlang.mint.compile import intervals
from motionlang.mint.compile.intervals import Range
from motionlang.mint.resolve.folding import constant
from motionlang.mint.resolve.symbols import FLOAT, INTEGER, Function, Symbol
from motionlang.mint.syntax import nodes
from motionlang.mint.syntax.traversal import walk

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable


State = dict[Symbol, Range]
_COMPARED = frozenset(("=", "<>", "<", ">", "<=", ">="))
# Turns of a loop after which only the coarse thresholds are left.
_PATIENCE = 8
_COARSE = [-intervals.EXACT, intervals.INT_LOW, -1, 0, 1, intervals.INT_HIGH, intervals.EXACT]
_WHOLE_UNITS = frozenset(("bool", "bits", "integer", "ms", "counts"))


def analysed(function: Function) -> set[Symbol]:
    """The variables that the analysis follows: plain numbers that no other function can touch."""
    if function.jumps or not function.loops or function.plain:
        return set()
    found = set()
    for symbol in (*function.scope.names.values(), *((function.result,) if function.result else ())):
        simple = symbol.kind == "variable" and not (symbol.shared or symbol.boxed or symbol.by_ref)
        if (
            simple
            and not symbol.is_array
            and symbol.type.name in (INTEGER, FLOAT)
            and symbol.home is function
        ):
            found.add(symbol)
    return found


class Flow:
    """One analysis; `facts` holds, by `id` of a Name (or of a For, for its variable at Next), what is known there."""

    def __init__(self, function: Function, followed: set[Symbol]) -> None:
        self.function, self.followed = function, followed
        self.facts: dict[int, Range] = {}
        self._exits: list[tuple[str, list[State | None]]] = []
        self._heads: dict[int, State] = {}
        self._fine = sorted({*_COARSE, *_constants(function.body)})

    def run(self) -> dict[int, Range]:
        """All facts of the function."""
        start: State = {
            symbol: (0, 0, "i") if symbol.home is self.function else intervals.ANY for symbol in self.followed
        }
        self._block(self.function.body, start)
        return self.facts

    # --------------------------------------------------------------------------------------- statements

    def _block(self, body: list[nodes.Stmt], state: State | None) -> State | None:
        for node in body:
            if state is None:
                return None
            state = self._statement(node, state)
        return state

    def _statement(self, node: nodes.Stmt, state: State) -> State | None:
        follow = _STATEMENTS.get(type(node))
        if follow is not None:
            return follow(self, node, state)
        self._read_all(node, state)
        return state

    def _if(self, node: nodes.If, state: State) -> State | None:
        yes = _own(self._narrow(node.condition, True, state))
        no = self._narrow(node.condition, False, state)
        return _join(self._block(node.body, yes), self._block(node.orelse, no))

    def _while(self, node: nodes.While, state: State) -> State | None:
        return self._loop(node, "while", state, node.condition)

    def _repeat(self, node: nodes.Repeat, state: State) -> State | None:
        return self._loop(node, "repeat", state, None, node.condition)

    def _endless(self, node: nodes.Loop, state: State) -> State | None:
        return self._loop(node, "loop", state, None)

    def _return(self, node: nodes.Return, state: State) -> State | None:
        return None

    def _end(self, node: nodes.End, state: State) -> State | None:
        return state if node.name is not None else None

    def _assign(self, node: nodes.Assign, state: State) -> State:
        found = [self._value(each, state)[1] for each in node.values]
        symbol = self._followed(node.target)
        if symbol is None:
            if type(node.target) is nodes.Name:
                for each in node.target.args or ():
                    self._value(each, state)
            else:
                self._read_all(node.target, state)
            return state
        state[symbol] = _held(symbol, found[0] if found else intervals.ANY)
        return state

    def _dim(self, node: nodes.Dim, state: State) -> State:
        for variable in node.variables:
            found = [self._value(each, state)[1] for each in variable.values]
            symbol = variable.symbol
            if found and symbol in self.followed:
                assert symbol is not None
                state[symbol] = _held(symbol, found[0])
        return state

    def _input(self, node: nodes.Input, state: State) -> State:
        self._read_all(node, state)
        symbol = self._followed(node.target)
        if symbol is not None:
            state[symbol] = _held(symbol, intervals.ANY)
        return state

    def _select(self, node: nodes.Select, state: State) -> State | None:
        self._value(node.subject, state)
        self._exits.append(("select", []))
        out: State | None = None
        default = False
        for case in node.cases:
            for test in case.tests:
                self._read_all(test, state)
            out = _join(out, self._block(case.body, dict(state)))
            default = default or not case.tests
        for left in self._exits.pop()[1]:
            out = _join(out, left)
        return out if default else _join(out, state)

    def _exit(self, node: nodes.Exit, state: State) -> State | None:
        for kind, states in reversed(self._exits):
            if kind == node.kind or (not node.kind and kind != "select"):
                states.append(state)
                break
        return None

    # -------------------------------------------------------------------------------------------- loops

    def _for(self, node: nodes.For, state: State) -> State | None:
        start = self._value(node.start, state)
        stop = self._value(node.stop, state)[1]
        step = self._value(node.step, state)[1] if node.step is not None else (1, 1, "i")
        symbol = self._followed(node.variable)
        if symbol is None:
            return self._loop(node, "for", state, None, bounded=True)
        state[symbol] = _held(symbol, start[1])
        op = "<=" if step[0] > 0 else ">=" if step[1] < 0 else ""
        return self._loop(node, "for", state, None, bounded=True, counter=(symbol, op, stop, step))

    def _loop(
        self,
        node: nodes.For | nodes.While | nodes.Repeat | nodes.Loop,
        kind: str,
        entry: State,
        test: nodes.Expr | None,
        until: nodes.Expr | None = None,
        bounded: bool = False,
        counter: tuple[Symbol, str, Range, Range] | None = None,
    ) -> State | None:
        """Repeat the body until its head no longer changes; answers with what holds after the loop."""
        head = _widened(self._heads.get(id(node)), entry, self._fine)
        turn = 0
        while True:
            turn += 1
            self._exits.append((kind, []))
            inside = _own(self._enter(head, test, counter))
            back = self._block(node.body, inside)
            left = self._exits.pop()[1]
            if until is not None and back is not None:
                left.append(self._narrow(until, True, back))
                back = self._narrow(until, False, back)
            if counter is not None and back is not None:
                back = self._step(node, back, counter)
            grown = (
                head if back is None else _widened(head, back, self._fine if turn < _PATIENCE else _COARSE)
            )
            if grown == head:
                break
            head = grown
        self._heads[id(node)] = head
        if test is not None:
            left.append(self._narrow(test, False, head))
        elif bounded:
            left.append(head)
        out: State | None = None
        for each in left:
            out = _join(out, each)
        return _own(out)  # the head stays as it is

    def _enter(
        self, head: State, test: nodes.Expr | None, counter: tuple[Symbol, str, Range, Range] | None
    ) -> State | None:
        if test is not None:
            return self._narrow(test, True, head)
        if counter is not None and counter[1]:
            symbol, op, stop, _ = counter
            known = intervals.narrow(head[symbol], op, stop)
            return None if known is None else head | {symbol: known}
        return head

    def _step(self, node: nodes.Stmt, state: State, counter: tuple[Symbol, str, Range, Range]) -> State:
        symbol, _, _, step = counter
        known = state[symbol]
        self.facts[id(node)] = known
        total = _result("+", False, known, step)
        if symbol.type.name == INTEGER:
            total = intervals.to_integer(total)
        return state | {symbol: total}

    # -------------------------------------------------------------------------------------- expressions

    def _followed(self, node: nodes.Expr) -> Symbol | None:
        """The followed variable that a name stands for."""
        if type(node) is not nodes.Name or node.args is not None:
            return None
        symbol = node.symbol
        result = self.function.result
        if (
            (symbol is None or symbol.kind == "sub")
            and result is not None
            and result.name.lower() == node.name.lower()
        ):
            symbol = result
        return symbol if symbol in self.followed else None

    def _value(self, node: nodes.Expr, state: State) -> tuple[str, Range]:
        """Type and range of an expression; notes what is known of each variable in it."""
        follow = _VALUES.get(type(node))
        if follow is not None:
            return follow(self, node, state)
        self._read_all(node, state)
        return FLOAT, intervals.ANY

    def _number(self, node: nodes.Number, state: State) -> tuple[str, Range]:
        known = intervals.constant(node.value)
        whole = known[2] == "i" and intervals.INT_LOW <= known[0] <= intervals.INT_HIGH
        return (INTEGER if whole else FLOAT), known

    def _name(self, node: nodes.Name, state: State) -> tuple[str, Range]:
        symbol = self._followed(node)
        if symbol is not None:
            known = self.facts[id(node)] = state[symbol]
            return symbol.type.name, known
        for each in node.args or ():
            self._value(each, state)
        found = node.symbol
        if found is None:
            return self._keyword(node)
        if found.kind == "const" and isinstance(found.const, (int, float)):
            return found.type.name, intervals.constant(found.const)
        if node.stands is not None:
            return self._value(node.stands, state)
        if found.type.name == INTEGER:
            return INTEGER, intervals.INTEGER
        return FLOAT, intervals.ANY

    def _keyword(self, node: nodes.Name) -> tuple[str, Range]:
        row = node.row
        if row is None:
            return FLOAT, intervals.ANY
        if row.kind == "constant":
            known = intervals.constant(constant(row.verb, row.unit))
            return (INTEGER if known[2] == "i" else FLOAT), known
        if row.unit == "bool":
            return INTEGER, intervals.BOOL
        if row.unit in _WHOLE_UNITS:
            return INTEGER, intervals.INTEGER
        return FLOAT, intervals.ANY

    def _unary(self, node: nodes.Unary, state: State) -> tuple[str, Range]:
        kind, known = self._value(node.operand, state)
        if node.op == "Not":
            return INTEGER, intervals.BOOL
        if node.op == "~":
            return INTEGER, intervals.INTEGER
        if node.op == "+":
            return kind, known
        if kind == FLOAT:
            return FLOAT, (-known[1], -known[0], known[2])
        return INTEGER, intervals.arithmetic("-", True, (0, 0, "i"), known)[0]

    def _binary(self, node: nodes.Binary, state: State) -> tuple[str, Range]:
        op = node.op
        left_type, left = self._value(node.left, state)
        # What follows And and Or is looked at only sometimes: what is known there holds all the same.
        right_type, right = self._value(node.right, state)
        integer = left_type == INTEGER and right_type == INTEGER
        kind = INTEGER if integer else FLOAT
        if op in ("+", "-", "*"):
            return kind, _result(op, integer, left, right)
        if op in _COMPARED or op in ("And", "Or"):
            return INTEGER, intervals.BOOL
        if op in ("/", "^"):
            return FLOAT, intervals.FLOAT
        if op == "\\" and intervals.fits_integer(left) and intervals.fits_integer(right):
            return INTEGER, intervals.quotient(left, right)
        if op == "Mod":
            whole = left[2] == "i" and right[2] == "i"
            return kind, intervals.remainder(left, right) if whole else intervals.ANY
        if op == "&" and min(left[0], right[0]) >= 0 and left[2] == right[2] == "i":
            return INTEGER, (0, min(left[1], right[1], intervals.INT_HIGH), "i")
        return INTEGER, intervals.INTEGER

    def _read_all(self, node: nodes.Node, state: State) -> None:
        """Note what is known in every expression below a statement."""
        for slot in type(node).__slots__:
            child = getattr(node, slot)
            for each in child if child.__class__ is list else (child,):
                if isinstance(each, (nodes.Name, nodes.Binary, nodes.Unary)):
                    self._value(each, state)
                elif isinstance(each, nodes.Node):
                    self._read_all(each, state)

    # ---------------------------------------------------------------------------------------- branching

    def _narrow(self, node: nodes.Expr, truth: bool, state: State | None) -> State | None:
        """What is known where a condition is true, or false."""
        if state is None:
            return None
        if type(node) is nodes.Unary and node.op == "Not":
            return self._narrow(node.operand, not truth, state)
        if type(node) is nodes.Binary and node.op in ("And", "Or"):
            if (node.op == "And") is truth:
                return self._narrow(node.right, truth, self._narrow(node.left, truth, state))
            first = self._narrow(node.left, truth, state)
            second = self._narrow(node.right, truth, self._narrow(node.left, not truth, state))
            return _join(first, second)
        if type(node) is nodes.Binary and node.op in _COMPARED:
            return self._compare(node, truth, state)
        self._value(node, state)
        return state

    def _compare(self, node: nodes.Binary, truth: bool, state: State) -> State | None:
        left, right = self._value(node.left, state)[1], self._value(node.right, state)[1]
        op = node.op if truth else intervals.opposite(node.op)
        for side, known, other, how in (
            (node.left, left, right, op),
            (node.right, right, left, intervals.swapped(op)),
        ):
            symbol = self._followed(side)
            if symbol is not None:
                narrowed = intervals.narrow(known, how, other)
                if narrowed is None:
                    return None
                state = state | {symbol: narrowed}
        return state


_STATEMENTS: dict[type, Callable[..., State | None]] = {
    nodes.Assign: Flow._assign,
    nodes.Dim: Flow._dim,
    nodes.End: Flow._end,
    nodes.Exit: Flow._exit,
    nodes.For: Flow._for,
    nodes.If: Flow._if,
    nodes.Input: Flow._input,
    nodes.Loop: Flow._endless,
    nodes.Repeat: Flow._repeat,
    nodes.Return: Flow._return,
    nodes.Select: Flow._select,
    nodes.While: Flow._while,
}
_VALUES: dict[type, Callable[..., tuple[str, Range]]] = {
    nodes.Number: Flow._number,
    nodes.Name: Flow._name,
    nodes.Binary: Flow._binary,
    nodes.Unary: Flow._unary,
}


def _result(op: str, integer: bool, a: Range, b: Range) -> Range:
    """As `ranges.arithmetic`; the compiler may know more than this analysis, so a Float that would have to be made a
    float here may still be an int there."""
    known, how = intervals.arithmetic(op, integer, a, b)
    return intervals.ANY if how == intervals.COERCED else known


def _held(symbol: Symbol, known: Range) -> Range:
    """What a variable holds after it was given a value."""
    return intervals.to_integer(known) if symbol.type.name == INTEGER else known


def _own(state: State | None) -> State | None:
    """A copy that may be changed: statements change the state they are given."""
    return None if state is None else dict(state)


def _join(a: State | None, b: State | None) -> State | None:
    if a is None or b is None:
        return b if a is None else a
    if a is b:
        return a
    return {
        s: known if (other := b[s]) is known else intervals.join(known, other) or known
        for s, known in a.items()
    }


def _widened(old: State | None, new: State, thresholds: list[int]) -> State:
    if old is None:
        return new
    return {
        s: known if (other := new[s]) is known else intervals.widen(known, other, thresholds)
        for s, known in old.items()
    }


def _constants(body: Iterable[object]) -> set[int]:
    """The whole numbers that occur in a function, and their neighbours: where bounds settle."""
    found: set[int] = set()
    for node in walk(body):
        known: object = None
        if type(node) is nodes.Number:
            known = node.value
        elif type(node) is nodes.Name and node.args is None and (symbol := node.symbol) is not None:
            known = symbol.const
        if type(known) is int and known < intervals.EXACT:
            found.add(known)
    return {each + k for each in found for k in (-1, 0, 1)} | {-each for each in found}
