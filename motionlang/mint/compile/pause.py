"""`Pause condition`: what it looks at decides when it is looked at again, without polling."""

from __future__ import annotations

from motionlang.mint.compile.expressions import condition
from motionlang.mint.syntax.unparse import shown

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.compile.body import Body
    from motionlang.mint.syntax import nodes


def pause(b: Body, node: nodes.Pause) -> None:
    """Write the wait: test once, then give way until the condition is true."""
    b.begin()
    test = condition(b, node.condition)
    calls = b.calls
    b.observes = True
    b.calls = False
    b.flush()
    b.settle()
    b.gives_way()
    if calls:  # a condition that calls a sub is tested at every tick
        b.emit(f"while not {test}: t, H = yield {b.whole.use('env', 'tick')}(t)")
    else:
        why = f"until {shown(node.condition)}"
        pause = f"{b.whole.use('env', 'pause')}(t, lambda: {test}, {why!r}, {b.at})"
        b.emit(f"if not {test}: t, H = {pause} or (yield E.wait)")
    b.noted = True
    b.pending += 1
