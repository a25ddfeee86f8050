"""`Pause condition`: what to look at so that the wait ends at the exact moment, without polling.

A comparison of a reading that changes by itself (POS, VEL, TIME …) with something that does not is solved; everything
else in a condition changes only when something happens, and is tested then. What fits neither is tested at every
tick of the profiler.
"""

from __future__ import annotations

from motionlang.mint.compile.expressions import condition, number
from motionlang.mint.compile.keyword_use import indices
from motionlang.mint.resolve.symbols import TIME
from motionlang.mint.syntax import nodes
from motionlang.mint.syntax.traversal import meant, walk
from motionlang.mint.syntax.unparse import shown

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.lang.keyword import Keyword
    from motionlang.mint.compile.body import Body
    from motionlang.mint.resolve.symbols import Symbol

# Verbs of readings that change while time passes and nothing happens.
MOVING = frozenset(
    {
        "position", "velocity", "remaining", "following_error", "time", "demand", "demand_velocity",
        "sensing.acceleration", "sensing.encoder", "sensing.encoder_speed", "sensing.encoder_count", "sensing.seconds",
        "sensing.turns", "identity.date", "following.offset", "path_speed", "paths.angle",
        "following.auxiliary.position", "encoder_wrap.demand", "encoder_wrap.frequency", "jogging.time",
        "torque.demand", "torque.effort", "torque.current",
    }
)  # fmt: skip
COUNTING = frozenset({"time", "sensing.seconds", "identity.date", "jogging.time"})
# Those of them whose crossing of a value can be solved.
SOLVED = frozenset({"position", "demand", "remaining", "following.offset", "time"})
# What counts milliseconds from a moment of its own, with the reading that tells the moment.
_BASES = {"jogging.time": "jogging.began"}
# What takes away what it tells of, or tells something else each time.
TAKING = frozenset(
    {
        "random", "terminal.key", "serial.character", "network.event", "auxiliary_latches.passed",
        "auxiliary_latches.aux_passed", "latches.caught", "io.inputs.bit", "io.inputs.bank",
        "error_read_next", "error_read_code",
    }
)  # fmt: skip
COMPARED = frozenset(("=", "<>", "<", ">", "<=", ">="))


def pause(b: Body, node: nodes.Pause) -> None:
    """Write the wait: test once, then give way until the condition is true."""
    b.begin()
    test = condition(b, node.condition)
    calls = b.calls
    b.observes = True
    b.calls = False
    b.flush()
    b.settle()
    if calls:
        _poll(b, test)
    else:
        watches: list[str] = []
        _watch(b, node.condition, watches)
        why = f"until {shown(node.condition)}"
        watched = f"({', '.join(watches)},)" if watches else "()"
        b.emit(
            f"if not {test}: t, H = yield {b.whole.use('env', 'pause')}(t, lambda: {test}, {watched}, {why!r})"
        )
    b.waits = b.noted = True
    b.pending += 1


def _poll(b: Body, test: str) -> None:
    """A condition that calls a sub is tested at every tick."""
    b.emit(f"while not {test}: t, H = yield {b.whole.use('env', 'tick')}(t)")


def _watch(b: Body, node: nodes.Expr, watches: list[str]) -> None:
    """Add what decides when `node` may change: nothing where only events can change it."""
    node = meant(b.scope, node)
    if type(node) is nodes.Binary and node.op in ("And", "Or"):
        _watch(b, node.left, watches)
        _watch(b, node.right, watches)
    elif type(node) is nodes.Unary and node.op == "Not":
        _watch(b, node.operand, watches)
    elif moves(b, node):
        watch = solved(b, node)
        if watch is None:
            watch = "('tick',)" if moves(b, node, counting=True) else "('motion',)"
        if watch not in watches:
            watches.append(watch)


def solved(b: Body, node: nodes.Expr) -> str | None:
    """A watch for `reading op level`, None where there is no closed form for it."""
    if type(node) is not nodes.Binary or node.op not in COMPARED:
        return None
    for reading, level in ((node.left, node.right), (node.right, node.left)):
        reading = meant(b.scope, reading)
        if type(reading) is not nodes.Name or moves(b, level) or _acts(b, node):
            continue
        symbol = b.scope.find(reading.name)
        if symbol is not None and symbol.type.name == TIME and reading.args is None and not symbol.is_array:
            return f"('time', lambda: {spelled(symbol)}, lambda: {number(b, level).text})"
        row = None if symbol is not None else b.whole.table.get(reading.name)
        if row is not None and row.verb in SOLVED:
            where = indices(b, reading, row, single=True)
            axis = f"lambda: {where[0]}" if where else "None"
            return f"({row.verb!r}, {axis}, lambda: {number(b, level).text})"
        if row is not None and row.verb in _BASES:
            base = b.whole.use("read", _BASES[row.verb], row.name, row.unit, row.index, row.low, row.high)
            axis = indices(b, reading, row, single=True)[0]
            return f"('time', lambda: {base}({axis}), lambda: {number(b, level).text})"
    return None


def _acts(b: Body, node: object) -> bool:
    """Whether it does something to work out an expression: its value is then not to be had by the way."""
    for each in walk([node]):
        if type(each) is nodes.Name:
            symbol = b.scope.find(each.name)
            row = b.whole.table.get(each.name) if symbol is None else None
            if symbol is not None and (
                symbol.kind == "sub" or (symbol.kind == "define" and _acts(b, symbol.node))
            ):
                return True
            if row is not None and row.verb in TAKING:
                return True
    return False


def spelled(symbol: Symbol) -> str:
    """A variable as Python text."""
    if symbol.by_ref:
        return f"{symbol.python}[{symbol.python}_k]"
    return f"{symbol.python}[0]" if symbol.boxed else symbol.python


def moves(b: Body, node: nodes.Node, counting: bool = False) -> bool:
    """Whether the value of an expression changes by itself; `counting`: also while every axis stands still."""
    for each in walk([node]):
        if type(each) is nodes.Name:
            symbol = b.scope.find(each.name)
            if symbol is not None:
                if symbol.type.name == TIME or (symbol.kind == "define" and moves(b, symbol.node, counting)):  # type: ignore[arg-type]
                    return True
            else:
                row = b.whole.table.get(each.name)
                if row is not None and moves_by_itself(row, counting):
                    return True
    return False


def moves_by_itself(row: Keyword, counting: bool) -> bool:
    """Whether a keyword's value changes while nothing happens: `counting`, even while every axis stands still."""
    if counting or row.kind == "function":
        return row.verb in COUNTING
    return row.verb in MOVING or (row.kind == "reading" and row.unit.startswith("uu"))
