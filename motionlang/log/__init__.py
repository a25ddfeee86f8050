"""The motion of a completed run: as columns, trajectory points, and motor data."""

from __future__ import annotations

from motionlang.controller import lazy_family

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.log import move_rows, moves, older_profiles

# A run without motion needs none of these; only a long run, or one whose moves are continued, needs all.
__getattr__ = lazy_family(__name__, "move_rows", "moves", "older_profiles")

__all__ = ["move_rows", "moves", "older_profiles"]
