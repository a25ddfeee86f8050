"""The writer of one function: its steps, and what their values use of its variables."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.lang.steps import BEGIN, JUMP, NOTE, NOW, RETURN, Uses, Values
from motionlang.kernel.mint.resolve.symbols import TIME, Function, Symbol
from motionlang.kernel.mint.steps import expressions
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import meant, walk
from motionlang.kernel.tools import named

if TYPE_CHECKING:
    from motionlang.kernel.mint.steps.program import ProgramWriter

# Words of the language that neither read the machine nor act on it.
_PURE = frozenset(("function", "constant"))


class UnitWriter:
    """Writes the steps of one function, or checks it.

    `reads`, `nonlinear`, `spans` and `parts` collect what the next step uses of the variables; `is_known` is False if
    it may use others.
    """

    def __init__(self, program: ProgramWriter, function: Function) -> None:
        self.program, self.function = program, function
        # True if it reports errors and annotates the tree, and writes no steps.
        self.checks = program.checks
        self.steps = program.steps[function]
        # The offset of the statement that is being written.
        self.at = function.at
        # The loops and Selects around it, innermost last, each with the jumps that leave it.
        self.around: list[tuple[str, list[int]]] = []
        # The labels by name, the jumps to them, and the last label.
        self.labels: dict[str, int] = {}
        self.jumps: list[tuple[int, str]] = []
        self.label = ""
        self.regions: dict[str, GotoLoop] = regions(function)
        # The loops of Gotos by the offset of the statement at whose end they end.
        self._ending: dict[int, list[GotoLoop]] = {}
        for each in self.regions.values():
            self._ending.setdefault(each.statement.start, []).append(each)
        # The sub that was called last.
        self.callee: Function | None = None
        self.forget_uses()

    def forget_uses(self) -> None:
        """Begin with the variables of the next step."""
        self.reads: set[int] = set()
        self.nonlinear: set[int] = set()
        self.spans: set[int] = set()
        self.parts: set[int] = set()
        self.is_known = True

    # ------------------------------------------------------------------------------------------------- steps

    def add(
        self,
        kind: int,
        do: Any = None,
        to: int = -1,
        cost: float = 0.0,
        sets: int | None = None,
        role: str = "",
        is_copy: bool = False,
        name: str = "",
    ) -> int:
        """Append a step, which sets a variable, maybe to a copy of a reading; return its index.

        In a stack and in a profile its function has the `name`.
        """
        if self.checks:
            return 0
        if name:
            named(name, do)
        if kind in (NOW, NOTE):  # what has been written so far is used by the step after it
            return self.steps.add(kind, do, to, self.at, Uses(), cost)
        uses = None
        if self.is_known and kind != RETURN:
            is_set = frozenset() if sets is None else frozenset((sets,))
            reads, nonlinear, parts = map(frozenset, (self.reads, self.nonlinear, self.parts))
            spans = frozenset(self.spans if sets is None else ())  # a sum of the difference says nothing
            uses = Uses(
                reads, is_set, nonlinear, frozenset(), spans, parts, is_set if is_copy else frozenset()
            )
        self.forget_uses()
        return self.steps.add(kind, do, to, self.at, uses, cost, role)

    def pay(self) -> None:
        """Append a step that only takes the time of a statement."""
        self.add(JUMP, to=len(self.steps) + 1, cost=1.0)

    def settle(self, *parts: object) -> None:
        """Let what is due happen before a statement if any of these parts observes the machine."""
        if not self.checks and any(self.observes(each) for each in parts):
            self.add(NOW)

    def settle_before_calls(self, *parts: object) -> None:
        """Let what is due happen before a statement that acts and calls: time passes in the sub."""
        if any(map(self.has_steps, parts)):
            self.add(NOW)

    def here(self, *jumps: int) -> int:
        """Let jumps lead to the next step; return its index."""
        if self.checks:
            return 0
        for each in jumps:
            self.steps.set_target(each, len(self.steps))
        return len(self.steps)

    def new_index(self) -> int:
        """Return the index of something that a step keeps for later ones, in the list of the call."""
        return self.program.places.new_index(self.function)

    def begins(self, at: int) -> None:
        """Let a debugger stop before a statement."""
        if self.program.is_debug:
            self.steps.add(BEGIN, at=at)

    def close_regions(self, statement: nodes.Stmt) -> None:
        """Note the end of the loops of Gotos that end with this statement."""
        ended = [each for each in self._ending.get(statement.start, ()) if each.statement is statement]
        for each in ended:
            each.last = len(self.steps) - 1
        if ended:
            environment = self.program.environment
            self.add(NOTE, lambda values: environment.task.loop_log.passed())

    def marking(
        self, mark: Callable[..., Callable[..., float]], get: Callable[..., Any]
    ) -> Callable[..., Any]:
        """Return the function for a reading, for a level if it has one, with all that it depends on marked."""
        dependencies = self.program.environment.dependencies

        def read(values: Values, *level: Any) -> Any:
            notes = dependencies.notes
            if notes is None:
                return get(values, *level)
            first = len(notes)
            found = get(values, *level)
            marked = [(mark(*level), (until, *about)) for until, about in notes[first:]]
            notes[first:] = marked or [(mark(*level), (_never,))]
            return found

        return read

    # ------------------------------------------------------------------------------------------- the check

    def error(self, code: str, message: str, node: nodes.Node, hint: str = "") -> None:
        """Report an error, if this is a check: a value that a run is given may be out of range."""
        if self.checks:
            self.program.names.diagnostics.add(code, message, node.start, hint)

    # ------------------------------------------------------------------------------------------- properties

    def has_steps(self, part: object) -> bool:
        """True if an expression has steps of its own: it calls a function of the program, or has a long chain."""
        return not self.checks and any(
            isinstance(each, nodes.Chain)
            or (
                isinstance(each, nodes.Name)
                and each.symbol is not None
                and each.symbol.kind == "sub"
                and not self.is_result(each)
            )
            for each in expressions.parts(part)
        )

    def is_result(self, node: nodes.Name) -> bool:
        """True if a name is the result of the function so far."""
        return self.function.result_named(node) is not None

    def observes(self, part: object) -> bool:
        """True if an expression reads the machine or its time."""
        return any(map(self._observes, expressions.parts(part)))

    def _observes(self, node: nodes.Node) -> bool:
        if isinstance(node, nodes.Member):
            return self.symbol(node).type.name == TIME
        if not isinstance(node, nodes.Name):
            return False
        if node.symbol is None:
            return node.row is not None and node.row.kind not in _PURE
        return node.symbol.kind in ("variable", "parameter") and node.symbol.type.name == TIME

    def symbol(self, node: nodes.Expr) -> Symbol:
        """Return the variable or member that a name means."""
        node = meant(node)
        assert isinstance(node, nodes.Name | nodes.Member), node
        result = self.function.result_named(node) if isinstance(node, nodes.Name) else None
        symbol = result or node.symbol
        assert symbol is not None, node
        return symbol


def _never() -> float:
    return INFINITY


@dataclass(slots=True)
class GotoLoop:
    """A loop of Gotos: its first and last step, and the statement at whose end it ends."""

    statement: nodes.Stmt
    first: int = -1
    last: int = -1


def regions(function: Function) -> dict[str, GotoLoop]:
    """Return the loops formed by the Gotos of a function, by their labels."""
    if not function.jumps:
        return {}
    parts = sorted(walk(function.body), key=lambda each: each.start)
    labels = {each.name.lower(): each for each in parts if isinstance(each, nodes.Label)}
    found: dict[str, GotoLoop] = {}
    for each in parts:
        label = (
            labels.get(each.name.lower()) if isinstance(each, nodes.Jump) and each.kind == "goto" else None
        )
        if label is not None and label.start < each.start:
            found[label.name.lower()] = GotoLoop(_end(function.body, label, each))
    return found


def _end(body: list[nodes.Stmt], label: nodes.Node, jump: nodes.Node) -> nodes.Stmt:
    """Return the statement with a jump, in the innermost block that also has its label."""
    node = body[bisect_right(body, jump.start, key=lambda each: each.start) - 1]
    for inner in _bodies(node):
        if inner and inner[0].start <= label.start and jump.start < inner[-1].end:
            return _end(inner, label, jump)
    return node


def _bodies(node: nodes.Stmt) -> list[list[nodes.Stmt]]:
    if isinstance(node, nodes.Select):
        return [case.body for case in node.cases]
    if isinstance(node, nodes.If):
        return [node.body, node.orelse]
    return [node.body] if isinstance(node, (nodes.For, nodes.While, nodes.Repeat, nodes.Loop)) else []
