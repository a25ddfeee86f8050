"""Jumps, conditions and RP by the assumptions of the machine file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

_PREFIX = "assumptions.mccl."


@dataclass(eq=False, slots=True)
class Flow:
    """The settled assumptions on flow.

    Commands count from `base`, JR from `after` commands behind itself. A condition governs `skipped` commands. RP
    without a number repeats for ever if `endless`.
    """

    base: int
    after: int
    skipped: int
    endless: bool

    def target(self, function: str, number: int, here: int) -> int:
        """Return the command, from 0, to which JP or JR jumps if it is command `here`."""
        return number - self.base if function == "jump" else here + number + self.after


def flow_of(settings: Mapping[str, object]) -> Flow:
    """Return the flow of a board with these settings."""
    return Flow(
        _number(settings, "jump-base", 0),
        int(settings.get(f"{_PREFIX}jump-relative") == "next"),
        _number(settings, "skipped", 2),
        settings.get(f"{_PREFIX}repeat-for-ever") != "once",
    )


def _number(settings: Mapping[str, object], name: str, usual: int) -> int:
    value = settings.get(_PREFIX + name, usual)
    return value if isinstance(value, int) else usual
