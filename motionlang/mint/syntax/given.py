"""Values that come when a program starts: nodes that no text has, in the place of what one has there."""

from __future__ import annotations

from motionlang.mint.syntax.node import Node

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.resolve.symbols import Type
    from motionlang.mint.syntax.nodes import Expr


class Given(Node):
    """A value that the program is given when it starts.

    It stands where a name gets its first value, of a name whose value changes from run to run of one compiled program.
    """

    __slots__ = ("is_text", "name")

    def __init__(self, at: int, name: str, is_text: bool) -> None:
        self.at, self.name, self.is_text = at, name, is_text


class Cast(Node):
    """A value as another type: what a `Const` with a type makes of a `Given`."""

    __slots__ = ("type", "value")

    def __init__(self, at: int, value: Expr, type: Type) -> None:
        self.at, self.value, self.type = at, value, type
