"""Loops that only poll: the turns that cannot differ from the one before are skipped, to the exact same end.

A turn that gave no variable another value, did nothing but look, and was not interrupted, will be repeated as it was
until something happens: the next event, or the moment at which a compared reading (POS, TIME …) passes its level.
So many whole turns as fit before it are paid for at once. What a turn did is noted in one local variable; a loop that
does something in every turn anyway is not watched.
"""

from __future__ import annotations

from motionlang.mint import nodes
from motionlang.mint.pausing import moves, solved
from motionlang.mint.symbols import NUMERIC, STRING

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from motionlang.mint.body import Body


class Poll:
    """One loop that is watched: `dirty` is the variable that says that a turn did something."""

    __slots__ = ("before", "dirty", "since", "state", "watches")

    def __init__(self, b: Body, state: list[str], watches: list[str]) -> None:
        self.dirty, self.before, self.since = b.temp(), b.temp(), b.temp()
        self.state, self.watches = state, watches


def watched(b: Body, body: list[nodes.Stmt], *conditions: nodes.Expr) -> Poll | None:
    """The watch on a loop, None where it would never find anything to skip."""
    if any(_plainly_acts(b, node) for node in body):
        return None
    look = _Look(b)
    if not all(look.only_looks(test) for test in conditions) or any(look.acts(node) for node in body):
        return None
    look.conditional(body)
    if look.assigned and not look.reads:
        return None  # nothing but its own variables: it computes
    poll = Poll(b, sorted(look.assigned), look.watches)
    b.emit(f"{poll.dirty} = True; {poll.before} = None; {poll.since} = t")
    return poll


def _plainly_acts(b: Body, node: nodes.Stmt) -> bool:
    """What `_Look.acts` says of most statements, at a glance."""
    if node.__class__ is nodes.Assign:
        target = node.target
        return target.__class__ is nodes.Name and b.scope.find(target.name) is None
    return node.__class__ not in _MAY_LOOK


def mark(b: Body, node: nodes.Stmt) -> None:
    """Before a statement that does something: this turn is no mere look."""
    poll = b.polls[-1] if b.polls else None
    if poll is not None and _Look(b).acts(node):
        b.emit(f"{poll.dirty} = True")


def turn(b: Body, poll: Poll) -> None:
    """The end of a turn, `t` being up to date."""
    state = f"({', '.join(poll.state)},)" if poll.state else "()"
    watches = f"({', '.join(poll.watches)},)" if poll.watches else "()"
    b.emit(f"if {poll.dirty}: {poll.dirty} = False")
    b.emit(f"elif {poll.before} == {state}: t = {b.whole.use('env', 'skip')}(t, {poll.since}, H, {watches})")
    b.emit(f"{poll.before} = {state}; {poll.since} = t")


class _Look:
    """What the statements of a loop do to it: read, assign, act."""

    def __init__(self, b: Body) -> None:
        self.b = b
        self.reads = False
        self.assigned: set[str] = set()
        self.watches: list[str] = []

    def acts(self, node: nodes.Stmt) -> bool:
        """Whether a statement does something whatever its conditions say."""
        if isinstance(node, nodes.If):
            return not self.only_looks(node.condition)
        if isinstance(node, nodes.Select):
            return self._moves_or_calls([node.subject, *(test for case in node.cases for test in case.tests)])
        if isinstance(node, nodes.Assign):
            return self._target(node) is None or self._moves_or_calls(node.values)
        return not isinstance(node, (nodes.Exit, nodes.Const, nodes.Define, nodes.Label))

    def conditional(self, body: Iterable[nodes.Stmt]) -> None:
        """Note what is assigned and read in a loop, in all of its branches."""
        for node in body:
            if isinstance(node, nodes.Assign):
                target = self._target(node)
                if target is not None:
                    self.assigned.add(target)
            elif isinstance(node, nodes.If):
                self.only_looks(node.condition)
                self.conditional(node.body)
                self.conditional(node.orelse)
            elif isinstance(node, nodes.Select):
                for case in node.cases:
                    self.conditional(case.body)
            self._note_reads(node)

    def only_looks(self, node: nodes.Expr) -> bool:
        """Whether a condition changes only at events and at moments that can be solved; notes the latter."""
        self._note_reads(node)
        if isinstance(node, nodes.Binary) and node.op in ("And", "Or"):
            return self.only_looks(node.left) and self.only_looks(node.right)
        if isinstance(node, nodes.Unary) and node.op == "Not":
            return self.only_looks(node.operand)
        if self._calls([node]):
            return False
        if not moves(self.b, node):
            return True
        watch = solved(self.b, node)
        if watch is not None and watch not in self.watches:
            self.watches.append(watch)
        return watch is not None

    def _target(self, node: nodes.Assign) -> str | None:
        """The variable that an assignment gives a value, as Python text; None where it does more than that."""
        if not isinstance(node.target, nodes.Name) or node.target.args is not None:
            return None
        symbol = self.b.scope.find(node.target.name)
        if symbol is None or symbol.kind not in ("variable", "parameter") or symbol.is_array:
            return None
        if symbol.type.name not in (*NUMERIC, STRING) or symbol.type.name == "Time":
            return None
        if symbol.by_ref:
            return f"{symbol.python}[{symbol.python}_k]"
        return f"{symbol.python}[0]" if symbol.boxed else symbol.python

    def _moves_or_calls(self, found: Sequence[nodes.Node]) -> bool:
        return self._calls(found) or any(moves(self.b, each) for each in found)

    def _calls(self, found: Iterable[nodes.Node]) -> bool:
        """Whether an expression calls a sub, or a word that answers differently each time."""
        from motionlang.mint.survey import walk

        for node in walk(found):
            if isinstance(node, nodes.Name):
                symbol = self.b.scope.find(node.name)
                if symbol is not None and symbol.kind == "sub":
                    return True
                if symbol is not None and symbol.kind == "define" and self._calls([symbol.node]):  # type: ignore[list-item]
                    return True
                row = None if symbol is not None else self.b.whole.table.get(node.name)
                if row is not None and row.verb in _CHANGES_BY_READING:
                    return True
        return False

    def _note_reads(self, node: nodes.Node) -> None:
        """Note whether anything is read that others can change."""
        from motionlang.mint.survey import walk

        if self.reads:
            return
        for each in walk([node]):
            if isinstance(each, nodes.Name):
                symbol = self.b.scope.find(each.name)
                if symbol is None or symbol.shared or symbol.kind == "define":
                    row = self.b.whole.table.get(each.name)
                    if symbol is not None or (row is not None and row.kind in ("reading", "setting")):
                        self.reads = True
                        return


# What may do nothing, or only sometimes.
_MAY_LOOK = frozenset((nodes.If, nodes.Select, nodes.Exit, nodes.Const, nodes.Define, nodes.Label))

# Words whose reading takes something away.
_CHANGES_BY_READING = frozenset(
    {
        "random",
        "error_read_next",
        "error_read_code",
        "error_code",
        "error_line",
        "error_string",
        "error_data",
    }
)
