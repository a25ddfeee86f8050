"""The range that each axis can reach: its travel, and the software limits that a program sets."""

from __future__ import annotations

from math import inf
from typing import TYPE_CHECKING, NamedTuple

from motionlang.kernel.lang import AxisKey as Key

if TYPE_CHECKING:
    from motionlang.commands.check.axis_state import AxisFacts
    from motionlang.commands.check.rule_facts import Facts

UPPER, LOWER = "upper", "lower"


class TravelLimit(NamedTuple):
    """A limit of an axis, as shown in a message, and what happens there."""

    text: str
    hint: str


class Reach:
    """The range that each axis can reach.

    Travel comes from the machine file, software limits come from the program.
    """

    def __init__(self, facts: Facts) -> None:
        self.facts = facts
        # The known values of the software limits of each axis, None if one of them is not known.
        self.values = {side: facts.values(lambda row, side=side: row.does(side)) for side in (UPPER, LOWER)}  # type: ignore[misc]
        self.wrapped = facts.named("POSWRAP")

    def beyond(self, key: Key, axis: AxisFacts) -> TravelLimit | None:
        """Return the limit that the target of an axis exceeds, None if there is none."""
        if {key, None} & self.wrapped:
            return None
        return self._software(key, axis) or self._switch(key, axis)

    def _software(self, key: Key, axis: AxisFacts) -> TravelLimit | None:
        target, in_force = float(axis.target or 0.0), self.facts.limits_in_force(key, axis)
        known = {side: self.values[side].get(key) or () for side in in_force}
        upper, lower = max(known.get(UPPER, ()), default=inf), min(known.get(LOWER, ()), default=-inf)
        if not lower <= target <= upper:
            limit = upper if target > upper else lower
            return TravelLimit(f"the software limit at {limit:.10g}", "the axis stops there with an error")
        if not self.facts.one_limit_arms_both or not axis.limited or not in_force:
            return None
        # The program has set one limit, which puts the other one in force, too.
        unset = {side for side in in_force if not {key, None} & self.values[side].keys()}
        if (target > 0.0 and UPPER in unset) or (target < 0.0 and LOWER in unset):
            hint = "it is 0 until it is set, and the other limit puts it in force"
            return TravelLimit("the software limit at 0", hint)
        return None

    def _switch(self, key: Key, axis: AxisFacts) -> TravelLimit | None:
        assert axis.target is not None
        travel = self.facts.settings.get(f"axis.{key}.travel")
        if not isinstance(travel, list) or axis.frame is None or self.facts.passes_switches(key):
            return None
        start = self.facts.settings.get(f"axis.{key}.start", 0.0)
        assert isinstance(start, (int, float))
        zero = start + axis.frame
        if travel[0] <= zero + axis.target <= travel[1]:
            return None
        switch = travel[1] if zero + axis.target > travel[1] else travel[0]
        return TravelLimit(f"the limit switch at {switch - zero:.10g}", self.facts.at_limit)
