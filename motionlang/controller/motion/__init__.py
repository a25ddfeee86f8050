"""Motion that is not a move to a position: jogs, following, references; stopping, suspending, overriding."""

from __future__ import annotations

from motionlang.controller import door

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.controller.motion import feedrate, halt

# A program whose moves are plain comes to none of these.
__getattr__ = door(__name__, "feedrate", "halt")

__all__ = ["feedrate", "halt"]
