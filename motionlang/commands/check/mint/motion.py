"""Checks of motion: early reads of position, late scales, targets out of reach."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from motionlang.commands.check.axis_state import Axis, Follower
from motionlang.commands.check.facts import spelt
from motionlang.commands.check.mint.facts import MintFacts
from motionlang.kernel.lang import AxisKey as Key
from motionlang.kernel.lang import Use
from motionlang.kernel.mint.resolve.symbols import Function

Add = Callable[..., None]


class Reach:
    """The range that each axis can reach.

    Travel comes from the machine file, software limits come from the program.
    """

    def __init__(self, facts: MintFacts, settings: Mapping[str, object]) -> None:
        self.settings = settings
        self.forward = facts.constants("SOFTLIMITFORWARD")
        self.reverse = facts.constants("SOFTLIMITREVERSE")
        self.unlimited = facts.named("SOFTLIMITMODE")
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
        if key in self.unlimited or None in self.unlimited:
            return None, None
        forward, reverse = self.forward.get(key), self.reverse.get(key)
        return (max(forward) if forward else None, min(reverse) if reverse else None)


class Motion:
    """The checks of motion; `add(code, message, at, hint)` records a warning."""

    def __init__(self, follower: Follower, reach: Reach, add: Add) -> None:
        self.follower, self.reach, self.add = follower, reach, add

    def check(self, function: Function) -> None:
        """Run all checks of motion on a function."""
        self.follower.report_problems(function, self._on_problem)

    def _on_problem(self, problem: str, act: Use, key: Key, axis: Axis) -> None:
        _REPORTS[problem](self, act, key, axis)

    def _in_motion(self, act: Use, key: Key, axis: Axis) -> None:
        zeroed = act.role == "zero"
        what = "set" if zeroed else "read"
        self.add(
            "in-motion",
            f"the position of axis {spelt(key)} is {what} while the move just started is in motion",
            act.at,
            f"PAUSE IDLE({spelt(key)}) waits for its end",
        )

    def _scale_in_motion(self, act: Use, key: Key, axis: Axis) -> None:
        assert act.row is not None
        self.add("scale-in-motion", f"{act.row.name} is changed while axis {spelt(key)} moves", act.at,
                 f"PAUSE IDLE({spelt(key)}) waits until it is at rest")  # fmt: skip

    def _scale_late(self, act: Use, key: Key, axis: Axis) -> None:
        words = ", ".join(sorted(each.upper() for each in axis.stale))
        self.add(
            "scale-after-speed",
            f"the scale of axis {spelt(key)} is set after {words}, whose value it changes",
            axis.scaled,
            "set the scale first",
        )

    def _time_first(self, act: Use, key: Key, axis: Axis) -> None:
        self.add(
            "time-before-speed",
            f"the time of a ramp of axis {spelt(key)} is set before SPEED, on which it depends",
            axis.timed,
            "set SPEED first",
        )

    def _no_motion(self, act: Use, key: Key, axis: Axis) -> None:
        assert axis.loaded is not None
        what = {"speed": "speed", "accel": "acceleration", "decel": "deceleration"}
        zeros = [word for slot, word in what.items() if slot in axis.zeros]
        code = "zero-speed" if "speed" in axis.zeros else "zero-acceleration"
        does = "holds" if code == "zero-speed" else "cannot run"
        message = f"the move {does}: the {zeros[0]} of axis {spelt(key)} is 0 at its GO"
        self.add(code, message, axis.loaded, "set it above zero first")

    def _nothing(self, act: Use, key: Key, axis: Axis) -> None:
        axes = ", ".join(map(spelt, act.axes))
        self.add("nothing-loaded", "this GO starts nothing: no move is loaded", act.at,
                 f"load one first, as in MOVER({axes}) = 10")  # fmt: skip

    def _beyond(self, act: Use, key: Key, axis: Axis) -> None:
        what = self.reach.beyond(key, axis)
        self.add("beyond-travel", f"the move ends at {axis.target:.10g}, beyond {what} of axis {spelt(key)}", act.at,
                 "the axis stops there with an error")  # fmt: skip


_REPORTS: dict[str, Callable[..., None]] = {
    "beyond-travel": Motion._beyond,
    "nothing-loaded": Motion._nothing,
    "zeros": Motion._no_motion,
    "in-motion": Motion._in_motion,
    "scale-in-motion": Motion._scale_in_motion,
    "scale-after-speed": Motion._scale_late,
    "time-before-speed": Motion._time_first,
}
