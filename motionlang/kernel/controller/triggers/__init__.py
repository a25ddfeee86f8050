"""Triggers by position: watches, zones, limits, homing."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.controller import lazy_family

if TYPE_CHECKING:
    from motionlang.kernel.controller.triggers import conditions, events, watch

# A program with plain moves only needs none of these.
__getattr__ = lazy_family(__name__, "conditions", "events", "watch")

__all__ = ["conditions", "events", "watch"]
