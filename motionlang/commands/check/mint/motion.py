"""Checks of motion: early reads of position, late scales, targets out of reach."""

from __future__ import annotations

from collections.abc import Callable

from motionlang.commands.check.axis_state import Axis, Follower
from motionlang.commands.check.facts import spelt
from motionlang.kernel.lang import AxisKey as Key
from motionlang.kernel.lang import Use

Add = Callable[..., None]


class Motion:
    """The checks of motion; `add(code, message, at, hint)` records a warning."""

    def __init__(self, follower: Follower, add: Add) -> None:
        self.follower, self.add = follower, add

    def check(self) -> None:
        """Report all problems that the analysis of the axes has found."""
        for problem, report in _REPORTS.items():
            for act, key, axis in self.follower.problems.get(problem, ()):
                report(self, act, key, axis)

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
        what = self.follower.reach.beyond(key, axis)
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
