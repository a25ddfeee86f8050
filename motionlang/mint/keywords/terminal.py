"""The terminal."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

ROWS: tuple[Keyword, ...] = ()
