"""Motion other than moves: jogs, following, references, stops, suspension."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.controller import lazy_family

if TYPE_CHECKING:
    from motionlang.kernel.controller.motion import feedrate, halt

# A program with plain moves only needs none of these.
__getattr__ = lazy_family(__name__, "feedrate", "halt")

__all__ = ["feedrate", "halt"]
