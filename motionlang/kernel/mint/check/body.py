"""The function that is being checked, and what the functions of a program share.

Each kind of expression and statement has a function in a table. `Body.value` and `Body.statements` call it, so the
files of this folder need not import each other where an expression contains a keyword, whose arguments are
expressions.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from motionlang.kernel.lang.vocabulary import Vocabulary
from motionlang.kernel.mint.check.values import NOTHING, Value, article
from motionlang.kernel.mint.resolve.symbols import FLOAT, INTEGER, NUMERIC, STRING, TIME, Function, Type
from motionlang.kernel.mint.syntax import nodes

if TYPE_CHECKING:
    from motionlang.kernel.mint.resolve.names import Symbols
    from motionlang.kernel.mint.resolve.problems import Problems


@dataclass(eq=False, slots=True)
class CheckContext:
    """The data that all functions of a program share.

    `supplied` are the keywords whose values the machine file gives. The rules check each class of expression and of
    statement.
    """

    table: Vocabulary
    names: Symbols
    problems: Problems
    axes: range
    supplied: frozenset[str]
    value_rules: Mapping[type, Callable[..., Value]]
    statement_rules: Mapping[type, Callable[..., None]]


class Body:
    """One function that is being checked."""

    def __init__(self, program: CheckContext, function: Function) -> None:
        self.program, self.function, self.scope = program, function, function.scope
        # The kinds of the loops and Selects around the statement, innermost last.
        self.loops: list[str] = []

    def statements(self, body: Iterable[nodes.Stmt]) -> None:
        """Check statements in sequence."""
        rules = self.program.statement_rules
        for node in body:
            rules[node.__class__](self, node)

    # -------------------------------------------------------------------------------------- expressions

    def value(self, node: nodes.Expr) -> Value:
        """Check an expression and annotate it; report an error and return a harmless value."""
        found = self.program.value_rules[node.__class__](self, node)
        node.type, node.const = found.type, found.const
        return found

    def number(self, node: nodes.Expr, what: str = "a number") -> Value:
        """Check an expression that must be a number."""
        return self.as_number(self.value(node), node, what)

    def condition(self, node: nodes.Expr) -> None:
        """Check a condition."""
        self.number(node, "a condition")

    def as_number(self, found: Value, node: nodes.Node, what: str) -> Value:
        """Report a value that must be a number and is none."""
        if found.type in NUMERIC:
            return found
        self.problem("type", f"{what} is needed here, not {article(found.type)}", node)
        return NOTHING

    def convert(self, found: Value, kind: Type, node: nodes.Node) -> None:
        """Report a value that cannot be assigned to a variable of a type."""
        if kind.name in (FLOAT, INTEGER, TIME) and found.is_number:
            return
        if (kind.name == STRING and found.type == STRING) or found is NOTHING:
            return
        hint = ""
        if kind.name == STRING and found.is_number:
            hint = "convert the number with Str"
        elif found.type == STRING:
            hint = "convert the text with Val"
        self.problem("type", f"cannot assign {article(found.type)} to {article(str(kind))}", node, hint)

    # ------------------------------------------------------------------------------------------ reports

    def problem(self, code: str, message: str, node: nodes.Node, hint: str = "") -> None:
        self.program.problems.add(code, message, node.start, hint)

    def warn(self, code: str, message: str, node: nodes.Node, hint: str = "") -> None:
        self.program.problems.add(code, message, node.start, hint, "warning")
