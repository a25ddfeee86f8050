"""The contents of the move buffer: moves, paths, cams, offsets, dwells."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.controller import lazy_family

if TYPE_CHECKING:
    from motionlang.kernel.controller.moves import buffer, path

# A program with plain moves only needs none of these.
__getattr__ = lazy_family(__name__, "buffer", "path")

__all__ = ["buffer", "path"]
