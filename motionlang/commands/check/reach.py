"""The range that each axis can reach: its travel, and the software limits that a program sets."""

from __future__ import annotations

from math import inf
from typing import TYPE_CHECKING, NamedTuple

from motionlang.kernel.lang import AxisKey as Key

if TYPE_CHECKING:
    from motionlang.commands.check.axis_state import AxisFacts, Follower
    from motionlang.kernel.lang import Use

UPPER, LOWER = "upper", "lower"


class TravelLimit(NamedTuple):
    """A limit of an axis, as shown in a message, and what happens there."""

    text: str
    hint: str


class Setting(NamedTuple):
    """A software limit that the program sets: its value, None if unknown, and the points that follow."""

    value: float | None
    point: int
    following: set[int]


class Reach:
    """The range that each axis can reach.

    Travel comes from the machine file, software limits come from the program.
    """

    def __init__(self, axes: Follower) -> None:
        self.axes, self.facts = axes, axes.facts
        self.points = {id(act): p for p, acts in self.facts.acts.items() for act in acts}
        self.settings = {side: self._settings(side) for side in (UPPER, LOWER)}
        self.wrapped = self.facts.named("POSWRAP")

    def _settings(self, side: str) -> dict[Key, list[Setting]]:
        """Map each axis to the settings of its software limit on a side."""
        found: dict[Key, list[Setting]] = {}
        for act in self.facts.written_by(lambda row: row.does(side)):
            p = self.points[id(act)]
            following = self.facts.graph.reached(p)
            for number, key in enumerate(act.axes):
                found.setdefault(key, []).append(Setting(act.number(number), p, following))
        return found

    def beyond(self, act: Use, key: Key, axis: AxisFacts) -> TravelLimit | None:
        """Return the limit that the target of a move exceeds, None if there is none."""
        if {key, None} & self.wrapped:
            return None
        return self._software(act, key, axis) or self._switch(key, axis)

    def _limits(self, side: str, act: Use, key: Key) -> list[float | None]:
        """Return the software limits that a move may meet, None for one that is unknown.

        One that is set when the move is over is none of them.
        """
        p = self.points[id(act)]
        return [
            each.value
            for each in self.settings[side].get(key, ())
            if p in each.following or not self.axes.is_over(p, key, each.point)
        ]

    def _software(self, act: Use, key: Key, axis: AxisFacts) -> TravelLimit | None:
        target, in_force = float(axis.target or 0.0), self.facts.limits_in_force(key, axis)
        limits = {side: self._limits(side, act, key) for side in in_force}
        upper = max(_certain(limits.get(UPPER, [])), default=inf)
        lower = min(_certain(limits.get(LOWER, [])), default=-inf)
        if not lower <= target <= upper:
            limit = upper if target > upper else lower
            return TravelLimit(f"the software limit at {limit:.10g}", "the axis stops there with an error")
        if not self.facts.one_limit_arms_both or not axis.limited or not in_force:
            return None
        # The program has set one limit, which puts the other one in force, too.
        unset = {side for side in in_force if not limits[side] and None not in self.settings[side]}
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


def _certain(values: list[float | None]) -> list[float]:
    """Return the values, none if one of them is unknown."""
    known = [value for value in values if value is not None]
    return known if len(known) == len(values) else []
