"""The functions of MCAPI, one file per subject.

Importing this package registers them all.
"""

from __future__ import annotations

from motionlang_mcapi.calls import (
    blocks,
    channels,
    controller,
    handles,
    low_level,
    motion,
    readings,
    recording,
    settings,
)

__all__ = [
    "blocks",
    "channels",
    "controller",
    "handles",
    "low_level",
    "motion",
    "readings",
    "recording",
    "settings",
]
