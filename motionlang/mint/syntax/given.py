"""Values that come when a program starts: nodes that no text has, in the place of what one has there."""

from __future__ import annotations

from motionlang.mint.syntax.node import Node
from motionlang.record import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.resolve.symbols import Type
    from motionlang.mint.syntax.nodes import Expr


@record
class Given(Node):
    """A value that the program is given when it starts.

    It stands where a name gets its first value, of a name whose value changes from run to run of one compiled program.
    """

    name: str
    is_text: bool


@record
class Cast(Node):
    """A value as another type: what a `Const` with a type makes of a `Given`."""

    value: Expr
    type: Type
