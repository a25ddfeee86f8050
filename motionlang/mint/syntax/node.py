"""What every node of the syntax tree has: its place, and equality by what it says."""

from __future__ import annotations

from motionlang.record import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import ClassVar, Self

    from motionlang.lang.keyword import Keyword
    from motionlang.mint.resolve.symbols import Symbol
    from motionlang.mint.syntax.nodes import Expr


@record
class Node:
    """A piece of a program that starts at token number `at`."""

    if TYPE_CHECKING:
        __slots__: ClassVar[tuple[str, ...]]  # the fields of the class itself

    at: int

    def __repr__(self) -> str:
        fields = ", ".join(repr(getattr(self, name)) for name in self.__slots__)
        return f"{type(self).__name__}({fields})"

    def __eq__(self, other: object) -> bool:
        """Nodes are equal when what they say is equal; where they stand takes no part."""
        return type(self) is type(other) and all(
            getattr(self, name) == getattr(other, name) for name in self.__slots__
        )

    __hash__ = None  # type: ignore[assignment]


class Resolved(Node):
    """A name, and what it stands for, which `resolve.names` writes down once wherever it stands.

    `symbol` is what the program declares or assigns under that name, `row` the keyword that it is otherwise, both None
    where it is neither. `stands` is what a Define has it stand for, a copy of its own.
    """

    __slots__ = ("row", "stands", "symbol")

    row: Keyword | None
    stands: Expr | None
    symbol: Symbol | None

    def resolve(self, symbol: Symbol | None, row: Keyword | None = None, stands: Expr | None = None) -> Self:
        """Say what it stands for."""
        self.symbol, self.row, self.stands = symbol, row, stands
        return self
