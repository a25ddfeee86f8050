"""Compile `For`, as a simple loop or in chunks.

A counted loop whose body neither waits nor observes time runs in chunks. A chunk is as many iterations as are
certain to end before the horizon, even if each takes the most expensive path. Nothing is tested within a chunk,
the cost is counted in whole statements, and the loop yields after exactly the same iteration as without chunks.

    n = (stop - i) // step + 1           iterations that remain
    w = (H - t) / worst                 iterations that surely fit
    if n > w: n = int(w) if w > 1.0 else 1
    c = n * statements
    for i in range(i, i + n * step, step): …; c += 1 where a branch costs something
    i += step
    t += c
    if t >= H: t, H = yield (t, minimum time of the iterations that remain)
"""

from __future__ import annotations

from motionlang.mint.compile import intervals, loop_times
from motionlang.mint.compile.body import Body, Value
from motionlang.mint.compile.conversions import as_float, as_integer, converted, literal
from motionlang.mint.compile.expressions import number, reference
from motionlang.mint.compile.lines import LOOP, Line, moved
from motionlang.mint.compile.loops import body_of, end_iteration, flag_for, go_on_leaving
from motionlang.mint.compile.operators import arithmetic
from motionlang.mint.resolve.symbols import FLOAT, INTEGER, NUMERIC, Symbol
from motionlang.mint.runtime.code_units import SCRATCH
from motionlang.mint.syntax import nodes
from motionlang.mint.syntax.traversal import walk


class Counter:
    """The data of a For: its variable as text and symbol, start, limit and step."""

    __slots__ = ("exact", "kind", "start", "step", "stop", "symbol", "text")

    def __init__(self, b: Body, node: nodes.For, symbol: Symbol) -> None:
        self.symbol = symbol
        self.text, type_, scalar = reference(b, node.variable)
        self.kind = type_.name
        self.exact = scalar not in b.analysed
        self.start = number(b, node.first)
        self.stop = number(b, node.stop)
        self.step = number(b, node.step) if node.step is not None else literal(1)
        if self.step.const == 0 and not _may_end(b, node, symbol):
            b.problem(
                "range", "a For that counts by 0 never ends", node.step or node, "leave it with Exit For"
            )
        b.settle()
        first = converted(b, self.start, type_, node.first, self.exact)
        # Limit and step are evaluated once, before the variable has its first value.
        self.stop, self.step = _stored(b, self.stop), _stored(b, self.step)
        b.emit(f"{self.text} = {first}")


def count(b: Body, node: nodes.For) -> None:
    """Compile `For variable = start To stop Step step … Next`."""
    symbol = node.variable.symbol
    if symbol is None or symbol.kind not in ("variable", "parameter") or symbol.type.name not in NUMERIC:
        name = node.variable.name
        row = node.variable.row
        hint = f"it is a word of Mint, {row.name}; Dim {name} makes a variable of it" if row else ""
        b.problem("type", f"{name} cannot count: it is not a numeric variable", node.variable, hint)
        return
    if not (symbol.boxed or symbol.by_ref or symbol.is_array):
        b.use_outside(symbol)
    counter = Counter(b, node, symbol)
    b.pending += 1
    b.flush()
    loop_times.begin(b)
    flag = flag_for(b, "for", node.body)
    noted, b.noted = b.noted, False
    outer, b.lines = b.lines, []
    chunks = len(b.chunks)
    at = b.at
    b.indent += 1
    body_of(b, "for", node.body, flag)
    b.indent -= 1
    b.at = at
    body, b.lines = b.lines, outer
    if b.noted or len(b.chunks) > chunks or not _can_be_cut(b, node, counter):
        _plain(b, node, counter, body)
    else:
        _chunks(b, counter, body)
    b.noted = b.noted or noted
    loop_times.end(b)
    go_on_leaving(b)


def _stored(b: Body, found: Value) -> Value:
    """Store a limit, so that it does not change during the loop."""
    if found.const is not None:
        return found
    name = b.temp()
    b.emit(f"{name} = {found.bare}")
    return Value(name, found.type, found.range)


# ---------------------------------------------------------------------------------------------------- plain


def _plain(b: Body, node: nodes.For, counter: Counter, body: list[Line]) -> None:
    b.emit(f"while {_continues(counter)}:", LOOP)
    b.lines += body
    b.indent += 1
    _next(b, counter, _known(b, node, counter))
    end_iteration(b)
    b.indent -= 1


def _known(b: Body, node: nodes.For, counter: Counter) -> intervals.Range:
    """Return the range of the loop variable at Next."""
    known = b.facts.get(id(node))
    if known is not None:
        return known
    if counter.kind == INTEGER:
        return intervals.INTEGER
    return intervals.FLOAT if counter.exact else intervals.ANY


def _continues(counter: Counter) -> str:
    text, stop, step = counter.text, counter.stop, counter.step
    low, high, kind = step.range
    if step.const is not None:
        return f"{text} {'<=' if step.const >= 0 else '>='} {stop.text}"  # type: ignore[operator]
    if kind == "i" and low > 0:
        return f"{text} <= {stop.text}"
    if kind == "i" and high < 0:
        return f"{text} >= {stop.text}"
    return f"({text} <= {stop.text} if {step.text} >= 0 else {text} >= {stop.text})"


def _next(b: Body, counter: Counter, known: intervals.Range) -> None:
    text, step = counter.text, counter.step
    total = arithmetic(b, "+", Value(text, counter.kind, known), step)
    if counter.kind == FLOAT:
        source = as_float(total) if counter.exact else total.text
    else:
        source = as_integer(b, total)
    b.emit(f"{text} += {step.text}" if source == f"({text} + {step.text})" else f"{text} = {source}")


# --------------------------------------------------------------------------------------------------- chunks


def _can_be_cut(b: Body, node: nodes.For, counter: Counter) -> bool:
    """True if the loop can run in chunks.

    Its variable must only count, in integers that cannot overflow.
    """
    step, stop = counter.step.const, counter.stop.range
    if b.whole.debugging is not None or counter.exact or type(step) is not int or step == 0 or stop[2] != "i":
        return False
    known = b.facts.get(id(node))
    if known is None or known[2] != "i" or counter.start.range[2] != "i":
        return False
    reached = intervals.arithmetic("+", counter.kind == INTEGER, known, counter.step.range)
    return reached[1] == intervals.PLAIN and not _changes(b, node, counter.symbol)


def _changes(b: Body, node: nodes.For, symbol: Symbol) -> bool:
    """True if the body assigns to the variable."""
    for each in walk(node.body):
        target = (
            each.target
            if isinstance(each, nodes.Assign)
            else each.variable
            if isinstance(each, nodes.For)
            else None
        )
        if type(target) is nodes.Name and target.args is None and target.symbol is symbol:
            return True
    return False


def _may_end(b: Body, node: nodes.For, symbol: Symbol) -> bool:
    """True if the body may leave the loop, or assigns to its variable."""
    leaving = (nodes.Exit, nodes.Jump, nodes.Return, nodes.End)
    return _changes(b, node, symbol) or any(
        isinstance(each, leaving) or (isinstance(each, nodes.Call) and each.target.row is None)
        for each in walk(node.body)
    )


def _chunks(b: Body, counter: Counter, body: list[Line]) -> None:
    each, b.pending = b.pending + 1, 0
    worst = each + sum([line.cost for line in body])
    text, stop, step = counter.text, counter.stop.text, counter.step.const
    n, w, c = b.temp(SCRATCH), b.temp(SCRATCH), b.temp(SCRATCH)
    b.emit(f"while {_continues(counter)}:", LOOP)
    b.indent += 1
    b.emit(f"{n} = {f'{stop} - {text} + 1' if step == 1 else f'({stop} - {text}) // {step} + 1'}")
    b.emit(f"{w} = (H - t) / {worst}.0")
    b.emit(f"if {n} > {w}: {n} = int({w}) if {w} > 1.0 else 1")
    b.emit(f"{c} = {n} * {each}")
    iterations = f"{n}" if step == 1 else f"{n} * {step}"
    b.emit(f"for {text} in range({text}, {text} + {iterations}{'' if step == 1 else f', {step}'}):", LOOP)
    for line in moved(body, 1):
        if line.cost:
            line.text = f"{c} += {line.cost}"
        b.lines.append(line)
    if not body:
        b.emit(" pass")
    b.emit(f"{text} += {step}")
    b.emit(f"t += {c}")
    left = f"({stop} - {text})" if step == 1 else f"(({stop} - {text}) // {step})"
    b.horizon(f"(t, {left} * {each}.0)")
    b.indent -= 1
