"""The motion of a run afterwards: as columns, as trajectory points, as what the motors did."""

from __future__ import annotations

from motionlang.controller import door

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.controller.record import move_rows, older_profiles

# Only a long run, or one whose moves go on as others, comes to these.
__getattr__ = door(__name__, "move_rows", "older_profiles")

__all__ = ["move_rows", "older_profiles"]
