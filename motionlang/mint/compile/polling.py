"""Polling loops: code that lets identical iterations be skipped.

An iteration that did nothing (`E.acts` counts what a program does) and left every variable unchanged will
repeat identically until something happens. `motionlang.mint.runtime.loop_skipping` pays for all these
iterations at once, with exactly the same result. A `Goto` back to an earlier label ends an iteration as `End
Loop` does.

    if (t := t + 2.0) >= w2: t, H, w1, w2, (v_n,) = k1.turn_at(t, H, w1, (E.acts, v_state), (v_n,))
    if t >= H: yield; w2 = k1.due; w1 = None

`w1` is the state at the beginning of the iteration. No check is made before statement `w2`. After each yield in
the loop `w2` is set again from `k1.due`, because statements may count from another time after a wait. In a
loop that itself waits, `w2` is a number of iterations (`if w2: w2 -= 1.0`, `else: … k1.turn(…)`). Variables
that decide nothing (`idle`) are not part of the state. Counters are passed separately, and are returned with
the values that they have after the skipped iterations.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from motionlang.lang.keyword import Keyword
from motionlang.mint.compile import operators
from motionlang.mint.compile.body import Body
from motionlang.mint.compile.lines import HORIZON, YIELDS
from motionlang.mint.resolve.symbols import FLOAT, NUMERIC, STRING, TIME, Symbol
from motionlang.mint.runtime.code_units import SCRATCH
from motionlang.mint.syntax import nodes
from motionlang.mint.syntax.traversal import walk
from motionlang.mint.syntax.unparse import shown
from motionlang.record import record

# Variables by the text of their values.
State = dict[str, Symbol]

# A loop that names more variables is not checked.
MAX_VARIABLES = 100
# The maximum number of readings that are named for a loop.
MAX_NAMED = 3
# Types whose values do not change by themselves.
PLAIN = NUMERIC | {STRING}
# Used in generated text in place of a level: until the reading reverses, and regardless of the reading.
UNTIL_EXTREMUM, WHATEVER = "1e999", "-1e999"
COUNTER = "counter"
# The parts of the machine file that write to the memory that the controller shares with its host.
HOST_MEMORY = frozenset(("comms", "netdata", "dpr"))


@record
class Idle:
    """Values that change in each iteration of a loop and decide nothing.

    `counters` maps variables to the constants that they are compared with; `mere` are all such variables. Both
    use Python names. `copies` is true if the loop stores readings in host memory that it does not read, or for a loop
    around it.
    """

    counters: dict[str, list[float]]
    mere: frozenset[str]
    copies: bool


NO_IDLE = Idle({}, frozenset(), False)


class Poll:
    """The watch on a loop: the line before its `first` iteration, and iteration ends."""

    __slots__ = ("_begin", "_compared", "_counted", "_named", "_next", "_reads", "_site", "_start", "first")

    def __init__(
        self, b: Body, state: State, reads: bool, alters: bool, read_names: str, idle: Idle = NO_IDLE
    ) -> None:
        counters, mere = idle.counters, idle.mere
        self._reads = reads
        levels = tuple(map(tuple, counters.values()))
        carries, alters = bool(mere) or idle.copies, alters or idle.copies
        self._site = b.whole.use("loop", reads, carries, alters, read_names, levels, len(b.whole.specs))
        self._start, self._next, self._named = b.temp(SCRATCH), b.temp(SCRATCH), state.values()
        self._counted = f"({', '.join(counters)},)" if counters else "()"
        self._compared = ", ".join(["E.acts", *sorted(state.keys() - mere)])
        self.first = f"{self._start} = None; {self._next} = {self._site}.left"
        self._begin = len(b.lines)

    def end_iteration(self, b: Body) -> None:
        """Write the end of an iteration."""
        lines = b.lines[self._begin :]
        if b.whole.guarded or any(YIELDS in line.names and line.kind != HORIZON for line in lines):
            self.counted(b)
            return
        lines[0].text = self.first.replace(".left", ".due")
        again = f"; {self._next} = {self._site}.due"
        for line in lines:
            if line.kind == HORIZON:
                line.text += again
        now = f"(t := t + {b.pending}.0)" if b.pending else "t"
        b.pending = 0
        self._spell(b)
        b.emit(f"if {now} >= {self._next}: {self._check_call('check_at')}")
        # A loop that only counts gives way nowhere else, so its iterations are compared across time slices.
        b.horizon(then=f"{again}; {self._start} = None" if self._reads else again)

    def counted(self, b: Body) -> None:
        """Write the end of an iteration in a loop that waits: count unchecked iterations."""
        b.flush()
        b.emit(f"if {self._next}: {self._next} -= 1.0")
        self._spell(b)
        b.emit(f"else: {self._check_call('check')}")
        b.horizon(then=f"; {self._start} = None")

    def _spell(self, b: Body) -> None:
        for each in self._named:
            b.spelt(each)

    def _check_call(self, how: str) -> str:
        given = f"(t, H, {self._start}, ({self._compared},), {self._counted})"
        return f"t, H, {self._start}, {self._next}, {self._counted} = {self._site}.{how}{given}"


def watched(b: Body, body: list[nodes.Stmt], *conditions: nodes.Expr) -> Poll | None:
    """Write the watch on a loop; return None if no iteration could ever be skipped."""
    if not may_poll(body):
        return None
    iteration = list(reached(b, [*body, *conditions]))
    left = left_behind(b, iteration, not conditions)
    if left is None:
        return None
    poll = Poll(b, *left, idle(b, iteration))
    b.emit(poll.first)
    b.watching += 1
    return poll


def may_poll(body: Sequence[nodes.Stmt]) -> bool:
    """True unless a statement of a loop obviously does something in every iteration."""
    return not any(map(plainly_acts, body))


def left_behind(
    b: Body, iteration: Sequence[nodes.Node], endless: bool = False
) -> tuple[State, bool, bool, str] | None:
    """Return the state by which iterations of a loop are compared.

    `endless`: the loop has no condition.

    The result has the variables as text, True if the loop reads data that others can change, True if it assigns to
    variables that others read, and the names of its readings. The variables are all those named in the statements
    that an iteration reaches. The result is None if there are too many, or if the loop only computes.
    """
    names = [node for node in iteration if isinstance(node, (nodes.Name, nodes.Variable))]
    rows = {node.row for node in names if node.row is not None}
    symbols = list(dict.fromkeys(node.symbol for node in names if node.symbol is not None))
    reads = any(row.kind in ("reading", "setting") for row in rows) or any(
        symbol.shared or symbol.by_ref or symbol.type.name == TIME for symbol in symbols
    )
    assigns = [node for node in iteration if isinstance(node, nodes.Assign)]
    if not reads and not all(isinstance(value, nodes.Number) for node in assigns for value in node.values):
        # A loop that ends is often short, and quicker without a watch.
        ends = not endless or any(
            isinstance(node, (nodes.Exit, nodes.Jump, nodes.Return)) for node in iteration
        )
        counters = {} if ends else idle(b, iteration).counters
        if not counters or not all(_counts(b, node, counters) for node in assigns):
            return None  # a loop with only its own variables computes
    stored = [symbol.home.result or symbol if symbol.kind == "sub" else symbol for symbol in symbols]
    state = {_text(b, symbol): symbol for symbol in stored if _outlasts(b, symbol)}
    if len(state) > MAX_VARIABLES:
        return None
    b.whole.rewritten.update(filter(is_repeated, rows))
    return state, reads, any(_alters(b, node) for node in iteration), _read_names(iteration)


def _counts(b: Body, node: nodes.Assign, counters: dict[str, list[float]]) -> bool:
    """True if a statement advances a counter."""
    own = _own(b, node.target)
    return own is not None and own.python in counters


def _read_names(iteration: Sequence[nodes.Node]) -> str:
    """Return the names of the first few readings in an iteration, joined by "and"."""
    written = {id(node.target) for node in iteration if isinstance(node, nodes.Assign)}
    names = [node for node in iteration if isinstance(node, nodes.Name) and id(node) not in written]
    read = [node for node in names if node.row is not None and node.row.kind in ("reading", "setting")]
    found = dict.fromkeys(shown(node) for node in read if node.row is not None and node.row.verb != "wait")
    return " and ".join([*found][:MAX_NAMED])


def _alters(b: Body, node: nodes.Node) -> bool:
    """True if a statement assigns to a variable that others may use."""
    target: object = None
    if isinstance(node, nodes.Assign):
        target = node.target
    elif isinstance(node, nodes.For):
        target = node.variable
    while isinstance(target, nodes.Member):
        target = target.value
    symbol = target.symbol if isinstance(target, nodes.Name) else None
    return symbol is not None and (symbol.shared or symbol.by_ref or b.whole.typed)


def idle(b: Body, iteration: Sequence[nodes.Node]) -> Idle:
    """Return the values that change in each iteration and decide nothing.

        n = n + 1                               If POS(0) > peak Then peak = POS(0)                 x = POS(0)

    A counter may be compared with constants, as in `If n > 1000 Then STOP(0)`. Iterations that differ only in
    these variables can be skipped, except for the last one, which assigns the values to the copy and the extremum.
    A counter is advanced by the number of skipped iterations.

    The readings assigned are called with a level. The condition of an extremum does not change until the reading
    reverses, so its reading is called with that in place of a level. A mere copy depends on nothing.
    """
    if b.watching:
        copies = any(id(node) in b.copies or id(node) in b.levels for node in iteration)
        return Idle({}, frozenset(), copies)
    if b.function.kind == "sub" or b.function.jumps:
        return NO_IDLE
    uses: dict[Symbol | None, int] = {}
    # How each variable is assigned. One that is assigned in several ways does decide something.
    assignments: dict[Symbol, set[object]] = {}
    levels: dict[int, tuple[Symbol, str]] = {}
    # The constants that variables are compared with, and the number of places at which they count.
    constants: dict[Symbol, list[float]] = {}
    steps: dict[Symbol, int] = {}
    for node in iteration:
        if isinstance(node, nodes.Binary) and node.op in operators.COMPARISONS:
            for side, other in ((node.left, node.right), (node.right, node.left)):
                own = _own(b, side)
                if own is not None and isinstance(other, nodes.Number):
                    constants.setdefault(own, []).append(other.value)
        own = _own(b, node)
        uses[own] = uses.get(own, 0) + 1
        given = node.body[0] if isinstance(node, nodes.If) and len(node.body) == 1 else node
        own = _own(b, given.target) if isinstance(given, nodes.Assign) else None
        if own is None or not isinstance(given, nodes.Assign):
            continue
        value, reading = given.values[0], _reading(given.values[0])
        if isinstance(node, nodes.If):
            test = node.condition
            sides = (
                (test.left, test.right) if isinstance(test, nodes.Binary) and test.op in ("<", ">") else ()
            )
            if (
                reading
                and not _is_sampled(value)
                and {_own(b, side) or _reading(side) for side in sides} == {own, reading}
            ):
                uses[own] = uses.get(own, 0) - 1
                levels[id(value)] = own, UNTIL_EXTREMUM
        elif isinstance(value, nodes.Binary) and value.op in "+-" and _own(b, value.left) is own:
            if isinstance(value.right, nodes.Number) and isinstance(value.right.value, int):
                uses[own] = uses.get(own, 0) - 2
                steps[own] = steps.get(own, 0) + 1
                assignments.setdefault(own, set()).add(COUNTER)
        elif own.type.name == FLOAT and reading:
            uses[own] = uses.get(own, 0) - 1
            assignments.setdefault(own, set()).add(id(value) if id(value) in levels else WHATEVER)
            levels.setdefault(id(value), (own, WHATEVER))
    # A counter that passes a constant must count in one direction, so it is counted at one place.
    compared = {own: len(found) for own, found in constants.items() if steps.get(own) == 1}
    mere = {
        own for own, found in assignments.items() if uses[own] == compared.get(own, 0) and len(found) == 1
    }
    b.levels.update({number: text for number, (own, text) in levels.items() if own in mere})
    counters = sorted((own.python, constants.get(own, [])) for own in mere if COUNTER in assignments[own])
    return Idle(dict(counters), frozenset(own.python for own in mere), _copies(b, iteration))


def _copies(b: Body, iteration: Sequence[nodes.Node]) -> bool:
    """True if an iteration writes to host memory in a way that decides nothing.

    This is never so in a loop that reads the memory of a host or a bus. The readings that are written are called
    regardless of the level.
    """
    writes = [node for node in iteration if isinstance(node, nodes.Assign) and _is_host_memory(node.target)]
    targets = {id(node.target) for node in writes}
    names = [node for node in iteration if isinstance(node, nodes.Name) and node.row is not None]
    if not writes or any(name.row.group == "comms" for name in names if id(name) not in targets):  # type: ignore[union-attr]
        return False
    b.copies.update(map(id, writes))
    for name in walk([value for node in writes for value in node.values]):
        if isinstance(name, nodes.Name) and name.row is not None and name.row.solved:
            b.levels.setdefault(id(name), WHATEVER)
    return True


def _is_host_memory(node: object) -> bool:
    """True for a name of the memory that the controller shares with its host."""
    row = node.row if isinstance(node, nodes.Name) else None
    return row is not None and row.simulated and row.driven in HOST_MEMORY


def is_repeated(row: Keyword) -> bool:
    """True if a keyword may be a no-op when a loop repeats it.

    It may write the present value again, or stop an axis at rest. The operation itself reports whether it was a
    no-op.
    """
    return row.kind != "move" and (row.access == "RW" or row.effect.startswith("stop"))


def plainly_acts(node: nodes.Stmt) -> bool:
    """True if a statement obviously does something in every iteration."""
    if not isinstance(node, (nodes.Assign, nodes.Call)):
        # A LINE may print the text that its row shows already.
        return isinstance(node, (nodes.Input, nodes.End)) or (isinstance(node, nodes.Print) and not node.word)
    row = node.target.row if isinstance(node.target, nodes.Name) else None
    return row is not None and row.verb not in ("wait", "line") and not is_repeated(row)


def reached(b: Body, iteration: Sequence[object]) -> Iterator[nodes.Node]:
    """Yield every node of an iteration and of everything that it calls."""
    bodies, seen = [iteration], {id(iteration)}
    for body in bodies:  # the list grows during the loop
        for node in walk(body):
            yield node
            more: Sequence[object] = ()
            if isinstance(node, nodes.Name) and node.definition is not None:
                more = [node.definition]
            elif isinstance(node, nodes.Name) and node.symbol is not None and node.symbol.kind == "sub":
                more = node.symbol.home.body
            elif isinstance(node, nodes.Jump) and node.kind == "gosub":
                more = b.function.body
            if more and id(more) not in seen:
                seen.add(id(more))
                bodies.append(more)


def _outlasts(b: Body, symbol: Symbol) -> bool:
    """True if a variable persists between iterations.

    A local variable of a sub that the iteration calls does not.
    """
    is_variable = symbol.kind in ("variable", "parameter")
    return is_variable and (symbol.home is b.function or symbol.home.kind != "sub")


def _text(b: Body, symbol: Symbol) -> str:
    """Return the Python text of an immutable copy of a variable's value."""
    if symbol.is_array and symbol.type.name in PLAIN:
        return f"tuple({symbol.python})"
    if symbol.is_array or symbol.boxed or symbol.by_ref or symbol.type.name not in PLAIN:
        return f"{b.whole.use('fn', 'frozen')}({symbol.python})"
    return symbol.python


def _own(b: Body, node: nodes.Node) -> Symbol | None:
    """Return the numeric variable of this function that a node names, if any."""
    symbol = node.symbol if isinstance(node, nodes.Name) and node.args is None else None
    if symbol is None or symbol.kind != "variable" or symbol.home is not b.function:
        return None
    shared = symbol.shared or symbol.boxed or symbol.by_ref or symbol.is_array
    return None if shared or symbol.type.name not in NUMERIC else symbol


def _is_sampled(node: nodes.Node) -> bool:
    """True for a reading that changes in steps; it mostly equals its running maximum."""
    return isinstance(node, nodes.Name) and node.row is not None and node.row.driven == "analogue"


def _reading(node: nodes.Node) -> tuple[object, ...]:
    """Return a key for a reading that accepts a level, () for any other node.

    The reading must be of one axis or channel.
    """
    row = node.row if isinstance(node, nodes.Name) else None
    args = getattr(node, "args", None) or ()
    if row is None or not row.solved or not all(isinstance(each, nodes.Number) for each in args):
        return ()
    return row, *[each.value for each in args]
