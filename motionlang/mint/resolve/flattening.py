"""Rewrite blocks that contain labels as jumps.

v4 programs jump to a label at the end of a loop to begin its next iteration.

    LOOP                          #loop 1
      IF IN.0 = 0 THEN GOTO next    IF IN.0 = 0 THEN GOTO next
      OUT.1 = 1                     OUT.1 = 1
    #next                         #next
    ENDL                          GOTO loop 1

Only blocks with labels are flattened, because loops of Python are faster than jumps. The generated labels have a
blank in their names, which no program can write. Statement times do not change, with one exception: a For takes one
more statement for a limit, and one for a step, that is not a plain number.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from motionlang.lang.syntax.word import Word
from motionlang.mint.syntax import nodes
from motionlang.mint.syntax.traversal import walk

# The loops and Selects around a statement, innermost last, each with the label behind it, or "" if it is
# not flattened.
Around = tuple[tuple[str, Word], ...]

_KINDS = {
    nodes.For: "for",
    nodes.While: "while",
    nodes.Repeat: "repeat",
    nodes.Loop: "loop",
    nodes.Select: "select",
}


def holds_labels(body: list[nodes.Stmt], labels: Sequence[nodes.Node]) -> bool:
    """True if a label is inside one of the blocks of a function."""
    outermost = {id(node) for node in body}
    return any(id(label) not in outermost for label in labels)


def flattened(body: list[nodes.Stmt]) -> list[nodes.Stmt]:
    """Return the statements with every label at the outermost level."""
    return _Flattening().body(body, ())


def _has_label(node: nodes.Stmt) -> bool:
    return any(type(each) is nodes.Label for each in walk([node]))


def _bodies(node: nodes.Stmt) -> list[list[nodes.Stmt]]:
    if isinstance(node, nodes.Select):
        return [case.body for case in node.cases]
    bodies = (getattr(node, "body", None), getattr(node, "orelse", None))
    return [body for body in bodies if body]


class _Flattening:
    """The flattening of one function; counts the labels that it generates."""

    def __init__(self) -> None:
        self._made = 0

    def body(self, body: list[nodes.Stmt], around: Around) -> list[nodes.Stmt]:
        out: list[nodes.Stmt] = []
        for node in body:
            write = _WRITERS.get(type(node))
            if isinstance(node, nodes.Exit):
                out.append(self._exit(node, around))
            elif write is not None and _has_label(node):
                out += write(self, node, around)
            else:
                self._inside(node, around)
                out.append(node)
        return out

    def _label(self, what: str) -> Word:
        self._made += 1
        return Word(f"{what} {self._made}")

    def _exit(self, node: nodes.Exit, around: Around) -> nodes.Stmt:
        """Return an Exit, as a jump if the block that it leaves is flattened."""
        for kind, label in reversed(around):
            if kind == node.kind or (not node.kind and kind != "select"):
                return nodes.Jump(node.start, node.end, "exit", label) if label else node
        return node

    def _inside(self, node: nodes.Stmt, around: Around) -> None:
        """Rewrite the Exits inside a block that is not flattened.

        Such an Exit may leave an outer block that is flattened.
        """
        if not any(label for _, label in around):
            return
        inner = (*around, (_KINDS[type(node)], Word(""))) if type(node) in _KINDS else around
        for body in _bodies(node):
            body[:] = self.body(body, inner)

    # ------------------------------------------------------------------------------------------- the blocks

    def if_(self, node: nodes.If, around: Around) -> list[nodes.Stmt]:
        out: list[nodes.Stmt] = []
        ends: list[nodes.Stmt] = []
        while True:
            other, end = self._label("else"), self._label("end if")
            out += [
                nodes.If(
                    node.start,
                    node.end,
                    node.condition,
                    [],
                    [nodes.Jump(node.start, node.end, "exit", other)],
                ),
                *self.body(node.body, around),
                nodes.Jump(node.start, node.end, "exit", end),
                nodes.Label(node.start, node.end, other),
            ]
            ends.append(nodes.Label(node.start, node.end, end))
            if (
                len(node.orelse) != 1
                or type(node.orelse[0]) is not nodes.If
                or not _has_label(node.orelse[0])
            ):
                return [*out, *self.body(node.orelse, around), *reversed(ends)]
            node = node.orelse[0]

    def select(self, node: nodes.Select, around: Around) -> list[nodes.Stmt]:
        end = self._label("end select")
        labels = [self._label("case") for _ in node.cases]
        chosen: list[nodes.Case] = []
        bodies: list[nodes.Stmt] = []
        for case, label in zip(node.cases, labels, strict=True):
            chosen.append(
                nodes.Case(
                    case.start, case.end, case.tests, [nodes.Jump(case.start, case.end, "exit", label)]
                )
            )
            bodies += [
                nodes.Label(case.start, case.end, label),
                *self.body(case.body, (*around, ("select", end))),
            ]
            bodies.append(nodes.Jump(case.start, case.end, "exit", end))
        head = nodes.Select(node.start, node.end, node.subject, chosen)
        return [
            head,
            nodes.Jump(node.start, node.end, "exit", end),
            *bodies,
            nodes.Label(node.start, node.end, end),
        ]

    def loop(self, node: nodes.Loop, around: Around) -> list[nodes.Stmt]:
        return self._rewritten_loop(node, "loop", node.body, None, [], around)

    def while_(self, node: nodes.While, around: Around) -> list[nodes.Stmt]:
        rewritten = self._rewritten_loop(node, "while", node.body, node.condition, [], around)
        first = rewritten[0]
        assert isinstance(first, nodes.Label)
        return [
            nodes.Jump(node.start, node.end, "goto", first.name),
            *rewritten,
        ]  # the statement time of the While itself

    def repeat(self, node: nodes.Repeat, around: Around) -> list[nodes.Stmt]:
        begin, end = self._label("repeat"), self._label("end repeat")
        again = nodes.Jump(node.condition.start, node.condition.end, "again", begin)
        return [
            nodes.Label(node.start, node.end, begin),
            *self.body(node.body, (*around, ("repeat", end))),
            nodes.If(node.condition.start, node.condition.end, node.condition, [], [again]),
            nodes.Label(node.start, node.end, end),
        ]

    def for_(self, node: nodes.For, around: Around) -> list[nodes.Stmt]:
        """Rewrite a For; limit and step are evaluated once, before the first assignment."""
        before: list[nodes.Stmt] = []
        stop = self._stored(node, node.stop, before)
        step = (
            nodes.Number(node.start, node.end, 1)
            if node.step is None
            else self._stored(node, node.step, before)
        )
        variable = node.variable
        before.append(nodes.Assign(node.start, node.end, variable, [node.first]))
        total = nodes.Binary(node.start, node.end, "+", variable, step)
        next_ = [nodes.Assign(node.start, node.end, variable, [total])]
        return [
            *before,
            *self._rewritten_loop(node, "for", node.body, _goes_on(variable, stop, step), next_, around),
        ]

    def _stored(self, node: nodes.For, value: nodes.Expr, before: list[nodes.Stmt]) -> nodes.Expr:
        if isinstance(value, nodes.Number):
            return value
        self._made += 1
        name = nodes.Name(node.start, node.end, Word(f"_for{self._made}"))
        before.append(nodes.Assign(node.start, node.end, name, [value]))
        return name

    def _rewritten_loop(
        self,
        node: nodes.Stmt,
        kind: str,
        body: list[nodes.Stmt],
        condition: nodes.Expr | None,
        last: list[nodes.Assign],
        around: Around,
    ) -> list[nodes.Stmt]:
        """Rewrite a loop: condition, body, end of the iteration, and the jump back."""
        begin, end = self._label(kind), self._label(f"end {kind}")
        test = [] if condition is None else [nodes.Jump(node.start, node.end, "exit", end, condition)]
        return [
            nodes.Label(node.start, node.end, begin),
            *test,
            *self.body(body, (*around, (kind, end))),
            *last,
            nodes.Jump(node.start, node.end, "again" if last else "goto", begin),
            nodes.Label(node.start, node.end, end),
        ]


def _goes_on(variable: nodes.Expr, stop: nodes.Expr, step: nodes.Expr) -> nodes.Expr:
    """Build the condition under which a For runs another iteration.

    The sign of the step may be known only at run time.
    """
    at = variable.start, variable.end
    up, down = nodes.Binary(*at, "<=", variable, stop), nodes.Binary(*at, ">=", variable, stop)
    if isinstance(step, nodes.Number):
        return up if step.value >= 0 else down
    zero = nodes.Number(*at, 0)
    upward = nodes.Binary(*at, "And", nodes.Binary(*at, ">=", step, zero), up)
    return nodes.Binary(*at, "Or", upward, nodes.Binary(*at, "And", nodes.Binary(*at, "<", step, zero), down))


_WRITERS: dict[type, Callable[..., list[nodes.Stmt]]] = {
    nodes.If: _Flattening.if_,
    nodes.Select: _Flattening.select,
    nodes.Loop: _Flattening.loop,
    nodes.While: _Flattening.while_,
    nodes.Repeat: _Flattening.repeat,
    nodes.For: _Flattening.for_,
}
