"""The range that each axis can reach: its travel, and the software limits that a program sets."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.lang import AxisKey as Key

if TYPE_CHECKING:
    from motionlang.commands.check.axis_state import Axis
    from motionlang.commands.check.facts import Facts


class Reach:
    """The range that each axis can reach.

    Travel comes from the machine file, software limits come from the program.
    """

    def __init__(self, facts: Facts) -> None:
        self.settings = facts.settings
        self.facts = facts
        self.forward = facts.values(lambda row: row.does("upper"))
        self.reverse = facts.values(lambda row: row.does("lower"))
        self.wrapped = facts.named("POSWRAP")

    def beyond(self, key: Key, axis: Axis) -> str:
        """Return a text that names the limit which an axis's target exceeds, "" for none."""
        target = axis.target
        assert target is not None
        if {key, None} & self.wrapped:
            return ""
        forward, reverse = self._software(key)
        if forward is not None and target > forward:
            return f"the software limit at {forward:.10g}"
        if reverse is not None and target < reverse:
            return f"the software limit at {reverse:.10g}"
        travel = self.settings.get(f"axis.{key}.travel")
        if not isinstance(travel, list) or axis.frame is None:
            return ""
        start = self.settings.get(f"axis.{key}.start", 0.0)
        assert isinstance(start, (int, float))
        zero = start + axis.frame
        if travel[0] <= zero + target <= travel[1]:
            return ""
        switch = travel[1] if zero + target > travel[1] else travel[0]
        return f"the limit switch at {switch - zero:.10g}"

    def _software(self, key: Key) -> tuple[float | None, float | None]:
        if not self.facts.has_soft_limits(key):
            return None, None
        forward, reverse = self.forward.get(key), self.reverse.get(key)
        return (max(forward) if forward else None, min(reverse) if reverse else None)
