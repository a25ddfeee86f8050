"""Checks of motion: positions read too soon, scales that come too late, targets out of reach."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.mint.lint_acts import Act, Facts, Key, spelt
from motionlang.mint.lint_axis import Axis, Follower

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from motionlang.mint.flowgraph import Step

    Add = Callable[..., None]


class Motion:
    """The checks; `add(code, message, at, hint)` notes a warning, `settings` are those of the machine file."""

    def __init__(self, facts: Facts, follower: Follower, settings: Mapping[str, object], add: Add) -> None:
        self.follower, self.settings, self.add = follower, settings, add
        self.forward = facts.constants("SOFTLIMITFORWARD")
        self.reverse = facts.constants("SOFTLIMITREVERSE")
        self.unlimited = facts.named("SOFTLIMITMODE")

    def check(self) -> None:
        """All of them."""
        self.follower.tell(self._hear)

    def _hear(self, code: str, step: Step, act: Act, key: Key, axis: Axis) -> None:
        _HEARD[code](self, step, act, key, axis)

    def _in_motion(self, step: Step, act: Act, key: Key, axis: Axis) -> None:
        zeroed = act.role == "zero"
        what = "given a new value" if zeroed else "read"
        self.add(
            "in-motion",
            f"the position of axis {spelt(key)} is {what} while the move that was just started is under way",
            act.at,
            f"PAUSE IDLE({spelt(key)}) waits for its end",
        )

    def _scale_in_motion(self, step: Step, act: Act, key: Key, axis: Axis) -> None:
        assert act.row is not None
        self.add("scale-in-motion", f"{act.row.name} is changed while axis {spelt(key)} moves", act.at,
                 f"PAUSE IDLE({spelt(key)}) waits until it stands")  # fmt: skip

    def _scale_late(self, step: Step, act: Act, key: Key, axis: Axis) -> None:
        words = ", ".join(sorted(each.upper() for each in axis.stale))
        self.add(
            "scale-after-speed",
            f"the scale of axis {spelt(key)} is set after {words}, which keeps its counts and so gets another value",
            axis.scaled,
            "set the scale first",
        )

    def _time_first(self, step: Step, act: Act, key: Key, axis: Axis) -> None:
        self.add(
            "time-before-speed",
            f"the time of a ramp of axis {spelt(key)} is set before SPEED, to which it counts",
            axis.timed,
            "set SPEED first",
        )

    def _target(self, step: Step, act: Act, key: Key, axis: Axis) -> None:
        target = axis.target
        assert target is not None
        forward, reverse = self._soft_limits(key)
        if forward is not None and target > forward:
            self._beyond(act, key, target, f"the software limit at {forward:g}")
        elif reverse is not None and target < reverse:
            self._beyond(act, key, target, f"the software limit at {reverse:g}")
        travel = self.settings.get(f"axis.{key}.travel")
        if isinstance(travel, list) and axis.frame is not None:
            start = self.settings.get(f"axis.{key}.start", 0.0)
            assert isinstance(start, (int, float))
            place = start + axis.frame + target
            if not travel[0] <= place <= travel[1]:
                switch = travel[1] if place > travel[1] else travel[0]
                self._beyond(act, key, target, f"the limit switch at {switch - start - axis.frame:g}")

    def _soft_limits(self, key: Key) -> tuple[float | None, float | None]:
        if key in self.unlimited or None in self.unlimited:
            return None, None
        forward, reverse = self.forward.get(key), self.reverse.get(key)
        return (max(forward) if forward else None, min(reverse) if reverse else None)

    def _beyond(self, act: Act, key: Key, target: float, what: str) -> None:
        self.add("beyond-travel", f"the move ends at {target:g}, beyond {what} of axis {spelt(key)}", act.at,
                 "the axis stops there with an error")  # fmt: skip


_HEARD: dict[str, Callable[..., None]] = {
    "target": Motion._target,
    "in-motion": Motion._in_motion,
    "scale-in-motion": Motion._scale_in_motion,
    "scale-after-speed": Motion._scale_late,
    "time-before-speed": Motion._time_first,
}
