"""The vendors' notes as a library: `motionlang.lab.notes`."""

from __future__ import annotations

import sys

from motionlang.lab import notes
from motionlang.lab.notes import (
    an00115,
    chapter12,
    dac_override,
    dissect,
    figures,
    slip,
    tn1069,
    tn1069_servo,
)

__all__ = ["an00115", "chapter12", "dac_override", "dissect", "figures", "slip", "tn1069", "tn1069_servo"]

# `from motionlang.notes.dissect import slip_acceleration` finds the same module.
sys.modules.update({f"{__name__}.{each}": getattr(notes, each) for each in __all__})
