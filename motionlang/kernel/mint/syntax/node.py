"""The base class of all syntax tree nodes: position, and equality by content."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Self

from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.lang.syntax.word import Word

if TYPE_CHECKING:
    from motionlang.kernel.mint.resolve.symbols import Symbol
    from motionlang.kernel.mint.syntax.nodes import Expr


def own_fields(node: Node) -> list[str]:
    """Return the fields of a node's class itself by name: its content, without the position."""
    return sorted(type(node).__slots__)


@dataclass(eq=False, repr=False, slots=True)
class Node:
    """A node of the syntax tree, from offset `start` to offset `end` of the text."""

    start: int
    end: int

    def __repr__(self) -> str:
        fields = ", ".join(repr(getattr(self, name)) for name in own_fields(self))
        return f"{type(self).__name__}({fields})"

    def __eq__(self, other: object) -> bool:
        """Nodes with equal contents are equal; their positions do not count."""
        return type(self) is type(other) and all(
            getattr(self, name) == getattr(other, name) for name in own_fields(self)
        )

    __hash__ = None  # type: ignore[assignment]


class Expression(Node):
    """An expression, with its type and its value as far as the check knows them.

    `type` is "Integer", "Float", "String" or the name of another type. A wrong expression, which the check has
    reported, is a Float. `const` is the value that is known before the program runs. Both are None until the check,
    and are no part of the content.
    """

    __slots__ = ("const", "type")

    const: float | str | None
    type: str | None

    def __new__(cls, *_: object, **__: object) -> Self:
        made = super().__new__(cls)
        made.type = made.const = None
        return made


class Resolved(Node):
    """A statement or declaration with a name in it, and what the name refers to; see `ResolvedName`.

    A declaration has its own symbol, also if it repeats an earlier one.
    """

    __slots__ = ("row", "symbol")

    row: Keyword | None
    symbol: Symbol | None

    def resolve(self, symbol: Symbol | None, row: Keyword | None = None) -> Self:
        """Record what the name refers to."""
        self.symbol, self.row = symbol, row
        return self


class ClosedByName(Node):
    """A loop whose end may repeat the name of its variable, which is no part of its content."""

    __slots__ = ("last_name",)

    last_name: Word | None


class ResolvedName(Expression):
    """A name and what it refers to, which `resolve.names` records once for each use.

    `symbol` is the variable, constant, sub, task or member of that name in the program. `row` is the keyword of that
    name if there is no symbol. Both are None for an unknown name. `definition` is the expression that a Define gives
    the name, copied for each use.
    """

    __slots__ = ("definition", "row", "symbol")

    row: Keyword | None
    definition: Expr | None
    symbol: Symbol | None

    def resolve(
        self, symbol: Symbol | None, row: Keyword | None = None, definition: Expr | None = None
    ) -> Self:
        """Record what the name refers to."""
        self.symbol, self.row, self.definition = symbol, row, definition
        return self
