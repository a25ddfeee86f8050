"""Conditions that stop an axis: limits of its travel, and errors.

No kind of motion knows of a limit. Every new profile of an axis passes `extend_track`, which checks the limits that it
can meet. A condition is also checked when its state, position, mode or enablement changes. If a profile reverses into a
limit that is met, an event checks the limit again at that time.
"""

from __future__ import annotations

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.clock import TimedCall
from motionlang.kernel.controller.power import fault
from motionlang.kernel.planners.direction import sets_off

# The actions of an axis on a fault. "stop" uses DECEL, "error-stop" ERRORDECEL; "event" only notifies.
ACTIONS = ("ignore", "stop", "error-stop", "abort", "off", "event")
# Seconds by which a reversal may be early: an event's time has the resolution of the clock.
_NOW = 1e-9


class FaultCondition:
    """A condition that raises the fault `bit` of an axis while it is `met`.

    `sign` is the direction that it bars, +1 or -1; it ignores motion the other way, and an axis at rest. With
    0 the direction does not matter. It acts once when it becomes true, and again when it becomes true again
    or another motion is begun into it, but not at every check.
    """

    __slots__ = ("_action", "_enabled", "_event", "_raised", "a", "bit", "sign")

    def __init__(self, a: Axis, sign: int, bit: int, action: str) -> None:
        assert action in ACTIONS, action
        self.a, self.sign, self.bit = a, sign, bit
        self._action, self._enabled, self._raised = action, True, False
        self._event: TimedCall | None = None

    @property
    def met(self) -> bool:
        """True if the switch is closed, the position passed, or the value out of bounds."""
        raise NotImplementedError

    @property
    def action(self) -> str:
        """The action that the axis takes; a change applies at once."""
        return self._action

    @action.setter
    def action(self, action: str) -> None:
        assert action in ACTIONS, action
        if action != self._action:
            self._action, self._raised = action, False
            self.check()

    @property
    def enabled(self) -> bool:
        """True if the condition is in force."""
        return self._enabled

    @enabled.setter
    def enabled(self, enabled: bool) -> None:
        self._enabled = enabled
        self.check()

    @property
    def in_force(self) -> bool:
        """True if the axis acts once the condition is met."""
        return self._enabled and self._action != "ignore"

    def check(self, towards: int = 0) -> None:
        """Act if the condition has become true; in a `together` block, act at its end.

        `towards` is the direction in which the axis has just reached the condition.
        """
        if self._event is not None:
            self._event.cancel()
            self._event = None
        if not self.in_force or not self.met:
            self._raised = False
            return
        waiting = self.a.controller.deferred_checks
        if waiting is not None:
            waiting.append(self.check)
            return
        raised, self._raised = self._raised, self._bars(towards)
        if self._raised and not raised:
            self.act()

    def act(self) -> None:
        """Raise the fault of the condition."""
        fault(self.a, self.bit, self._action)

    def forget(self) -> None:
        """Forget a previous action, because another motion begins."""
        self._raised = False

    def _bars(self, towards: int) -> bool:
        """True if the axis moves in the barred direction.

        If a reversal will lead there, an event checks again.
        """
        if not self.sign:
            return True
        a, clock = self.a, self.a.clock
        if a.move is None or towards == self.sign:
            return a.move is not None
        elapsed = clock.now - a.starts[-1]
        found = sets_off(a.profiles[-1], self.sign, elapsed)
        if found is None or found <= elapsed + _NOW:
            return found is not None
        self._event = clock.at(a.starts[-1] + found, self.check)
        return False


class Undirected(FaultCondition):
    """An error independent of direction, such as an error input, while it is `active`."""

    __slots__ = ("_active",)

    def __init__(self, a: Axis, bit: int, action: str) -> None:
        super().__init__(a, 0, bit, action)
        self._active = False

    @property
    def met(self) -> bool:
        return self._active

    def set_active(self, active: bool) -> None:
        """Set the state of the error."""
        self._active = active
        self.check()
