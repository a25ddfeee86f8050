"""Loops that only poll: what is written into their turns so that those which cannot differ are skipped.

A turn that did nothing (`E.acts` counts what a program does) and left every variable as it was before will be repeated
as it was until something happens. `motionlang.mint.runtime.loop_skipping` pays for all those turns at once, to the
exact same end. A `Goto` back to an earlier label ends a turn as `End Loop` does.

    if w2: w2 -= 1
    elif w3: w3 -= 1; w2 = 255
    else: t, H, w1, w2, (v_n,) = k1.turn(t, H, w1, (E.acts, v_state), (v_n,)); w3, w2 = divmod(w2, 256)
    if t >= H: t, H = yield t; w1 = None

`w1` is what the turn began with; nobody looks for `w2` turns and `w3` times 256. What decides nothing (`idle`) is no
part of the state; counters are given beside it, and come back as they are when turns have been skipped.
"""

from __future__ import annotations

from motionlang.mint.resolve.symbols import FLOAT, NUMERIC, STRING, TIME
from motionlang.mint.syntax import nodes
from motionlang.mint.syntax.traversal import walk

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Collection, Iterable, Iterator, Sequence

    from motionlang.lang.keyword import Keyword
    from motionlang.mint.compile.body import Body
    from motionlang.mint.resolve.symbols import Symbol

# A loop that names more variables is not looked at turn by turn.
MOST_VARIABLES = 100
# So many turns are counted down at a time: of small numbers Python has one object each.
STRETCH = 256
# Types whose values do not change by themselves.
PLAIN = NUMERIC | {STRING}
# What stands for a level, in generated text, until the reading turns round, and whatever it does.
UNTIL_IT_TURNS, WHATEVER = "1e999", "-1e999"
COUNTER = "counter"


class Poll:
    """One loop that is watched, and the names of what its turn began with and for how many turns nobody looks."""

    __slots__ = ("alone", "counters", "look", "named", "site", "state", "stretches")

    def __init__(
        self,
        b: Body,
        state: dict[str, Symbol],
        asks: bool,
        counters: Sequence[str] = (),
        mere: Collection[str] = (),
    ) -> None:
        self.site = b.whole.use("loop", asks, b.whole.polls, bool(mere))
        b.whole.polls += 1
        self.look, self.alone, self.stretches = b.temp(), b.temp(), b.temp()
        self.named = state.values()
        self.counters = f"({', '.join(counters)},)" if counters else "z"
        self.state = f"({', '.join(['E.acts', *sorted(state.keys() - mere)])},)"
        if counters:
            self.state += f", {self.counters}"

    @property
    def first(self) -> str:
        """What stands before the first turn."""
        return f"{self.look} = None; {self.stretches}, {self.alone} = divmod({self.site}.left, {STRETCH})"


def watched(b: Body, body: list[nodes.Stmt], *conditions: nodes.Expr) -> Poll | None:
    """The watch on a loop, None where it would never find anything to skip."""
    turn = [*body, *conditions]
    left = None if any(_plainly_acts(node) for node in body) else left_behind(b, turn)
    if left is None:
        return None
    counters, mere, levels = idle(b, reached(b, turn))
    poll = Poll(b, *left, counters, mere)
    b.emit(poll.first)
    b.levels.update(levels)
    b.watching += 1
    return poll


def left_behind(b: Body, turn: Sequence[nodes.Node]) -> tuple[dict[str, Symbol], bool] | None:
    """The variables, as text, that turns of a loop are compared by, and whether these look at what others can change.

    They are all that the loop and what it calls name. None where there are too many, or where the loop just computes.
    """
    state: dict[str, Symbol] = {}
    rewritten: set[Keyword] = set()
    reads = computes = False
    for node in reached(b, turn):
        if isinstance(node, nodes.Assign):
            computes = computes or any(not isinstance(each, nodes.Number) for each in node.values)
        if not isinstance(node, (nodes.Name, nodes.Variable)):
            continue
        symbol, row = node.symbol, node.row
        if row is not None:
            reads = reads or row.kind in ("reading", "setting")
            rewritten.update([row] if is_repeated(row) else ())
        if symbol is None:
            continue
        reads = reads or symbol.shared or symbol.by_ref or symbol.type.name == TIME
        if symbol.kind == "sub":
            symbol = symbol.home.result or symbol
        if symbol.kind in ("variable", "parameter") and _outlasts(b, symbol):
            state[_text(b, symbol)] = symbol
    if len(state) > MOST_VARIABLES or (computes and not reads):
        return None  # with nothing but its own variables it computes
    b.whole.rewritten |= rewritten
    return state, reads


def idle(b: Body, turn: Iterable[nodes.Node]) -> tuple[list[str], set[str], dict[int, str]]:
    """The variables to which a loop gives other values turn by turn and which decide nothing, of all that it reaches.

        n = n + 1                               If POS(0) > peak Then peak = POS(0)                 x = POS(0)

    Counters, all of them, by their spelling, and the levels of the readings they are given. Turns that are alike but
    for these can be skipped, all but the last one: it gives the copy and the extremum the values that they would have,
    and a counter has counted on by as many turns. The condition of an extremum is the same again until the reading
    turns round, which the copy is asked for instead of a level; of a mere copy nobody asks anything.
    """
    uses: dict[Symbol | None, int] = {}
    # How each is given its values: one that is so in several ways decides something after all.
    ways: dict[Symbol, set[object]] = {}
    levels: dict[int, tuple[Symbol, str]] = {}
    alone = b.function.kind != "sub" and not b.function.jumps and not b.watching
    for node in turn if alone else ():
        own = _own(b, node)
        uses[own] = uses.get(own, 0) + 1
        given = node.body[0] if isinstance(node, nodes.If) and len(node.body) == 1 else node
        own = _own(b, given.target) if isinstance(given, nodes.Assign) else None
        if own is None or not isinstance(given, nodes.Assign):
            continue
        value, reading = given.values[0], _reading(given.values[0])
        if isinstance(node, nodes.If):
            test = node.condition
            if reading and isinstance(test, nodes.Binary) and test.op in ("<", ">"):
                sides = {_own(b, side) or _reading(side) for side in (test.left, test.right)}
                if sides == {own, reading}:
                    uses[own] = uses.get(own, 0) - 1
                    levels[id(value)] = own, UNTIL_IT_TURNS
        elif isinstance(value, nodes.Binary) and value.op in "+-" and _own(b, value.left) is own:
            if isinstance(value.right, nodes.Number) and isinstance(value.right.value, int):
                uses[own] = uses.get(own, 0) - 2
                ways.setdefault(own, set()).add(COUNTER)
        elif own.type.name == FLOAT and reading:
            uses[own] = uses.get(own, 0) - 1
            ways.setdefault(own, set()).add(id(value) if id(value) in levels else WHATEVER)
            levels.setdefault(id(value), (own, WHATEVER))
    mere = {own for own, found in ways.items() if not uses[own] and len(found) == 1}
    kept = {number: text for number, (own, text) in levels.items() if own in mere}
    return sorted(own.python for own in mere if COUNTER in ways[own]), {own.python for own in mere}, kept


def turn(b: Body, poll: Poll) -> None:
    """The end of a turn, `t` being up to date."""
    look, alone, stretches = poll.look, poll.alone, poll.stretches
    b.emit(f"if {alone}: {alone} -= 1")
    b.emit(f"elif {stretches}: {stretches} -= 1; {alone} = {STRETCH - 1}")
    for each in poll.named:
        b.spelt(each)
    split = f"{stretches}, {alone} = divmod({alone}, {STRETCH})"
    b.emit(
        f"else: t, H, {look}, {alone}, {poll.counters} = {poll.site}.turn(t, H, {look}, {poll.state}); {split}"
    )
    b.horizon(then=f"; {look} = None")


def is_repeated(row: Keyword) -> bool:
    """Whether a word may be written with what it has already, or stops what stands; the operation itself tells."""
    return row.kind != "move" and (row.access == "RW" or row.effect.startswith("stop"))


def _plainly_acts(node: nodes.Stmt) -> bool:
    """Whether a statement does something in every turn, at a glance."""
    if not isinstance(node, (nodes.Assign, nodes.Call)):
        return isinstance(node, (nodes.Print, nodes.Input, nodes.End))
    row = node.target.row if isinstance(node.target, nodes.Name) else None
    return row is not None and row.verb != "wait" and not is_repeated(row)


def reached(b: Body, turn: Sequence[object]) -> Iterator[nodes.Node]:
    """Every node of a turn and of all that it calls."""
    bodies, seen = [turn], {id(turn)}
    for body in bodies:  # which grow meanwhile
        for node in walk(body):
            yield node
            more: Sequence[object] = ()
            if isinstance(node, nodes.Name) and node.stands is not None:
                more = [node.stands]
            elif isinstance(node, nodes.Name) and node.symbol is not None and node.symbol.kind == "sub":
                more = node.symbol.home.body
            elif isinstance(node, nodes.Jump) and node.kind == "gosub":
                more = b.function.body
            if more and id(more) not in seen:
                seen.add(id(more))
                bodies.append(more)


def _outlasts(b: Body, symbol: Symbol) -> bool:
    """Whether a variable is there from turn to turn: not one of a sub that is called in it."""
    return symbol.home is b.function or symbol.home.kind != "sub"


def _text(b: Body, symbol: Symbol) -> str:
    """What a variable holds, as Python text of what does not change with it."""
    if symbol.is_array and symbol.type.name in PLAIN:
        return f"tuple({symbol.python})"
    if symbol.is_array or symbol.boxed or symbol.by_ref or symbol.type.name not in PLAIN:
        return f"{b.whole.use('fn', 'frozen')}({symbol.python})"
    return symbol.python


def _own(b: Body, node: nodes.Node) -> Symbol | None:
    """The number of this function alone that a name stands for."""
    symbol = node.symbol if isinstance(node, nodes.Name) and node.args is None else None
    if symbol is None or symbol.kind != "variable" or symbol.home is not b.function:
        return None
    shared = symbol.shared or symbol.boxed or symbol.by_ref or symbol.is_array
    return None if shared or symbol.type.name not in NUMERIC else symbol


def _reading(node: nodes.Node) -> tuple[object, ...]:
    """A reading of one axis or channel that can be asked for, for comparison; () where it is anything else."""
    row = node.row if isinstance(node, nodes.Name) else None
    args = getattr(node, "args", None) or ()
    if row is None or not row.solved or not all(isinstance(each, nodes.Number) for each in args):
        return ()
    return row, *[each.value for each in args]
