"""Conditions that stop an axis: errors, and reasons for suspension.

No kind of motion knows of a limit. Every new profile of an axis passes `Core.extend_track`, which checks the
conditions of the axis. A condition is also checked when its state, position, mode or enablement changes. If a
profile reverses into a condition that is met, an event checks the condition again at that time.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.controller.axis import BY_WORD, Axis
from motionlang.kernel.controller.clock import Event
from motionlang.kernel.controller.faults import fault_names
from motionlang.kernel.errors import Rejected
from motionlang.kernel.planners.direction import sets_off

if TYPE_CHECKING:
    from motionlang.kernel.controller.controller import Controller
    from motionlang.kernel.controller.queue.life import Core

# The actions of an axis on a fault. "stop" uses DECEL, "error-stop" ERRORDECEL; "event" only notifies.
ACTIONS = ("ignore", "stop", "error-stop", "abort", "off", "event")
# Seconds by which a reversal may be early: an event's time has the resolution of the clock.
_NOW = 1e-9


class Condition:
    """A condition that raises the fault `bit` of an axis while it is `met`.

    `sign` is the direction that it bars, +1 or -1; it ignores motion the other way, and an axis at rest. With
    0 the direction does not matter. It acts once when it becomes true, and again when it becomes true again
    or another motion is begun into it, but not at every check.
    """

    __slots__ = ("_action", "_enabled", "_event", "_raised", "axis", "bit", "controller", "sign")

    def __init__(self, controller: Controller, axis: int, sign: int, bit: int, action: str) -> None:
        assert action in ACTIONS, action
        self.controller, self.axis, self.sign, self.bit = controller, axis, sign, bit
        self._action, self._enabled, self._raised = action, True, False
        self._event: Event | None = None

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

    def check(self, towards: int = 0) -> None:
        """Act if the condition has become true; in a `together` block, act at its end.

        `towards` is the direction in which the axis has just reached the condition.
        """
        if self._event is not None:
            self._event.cancel()
            self._event = None
        if not self._enabled or self._action == "ignore" or not self.met:
            self._raised = False
            return
        waiting = self.controller.deferred_checks
        if waiting is not None:
            waiting.append(self)
            return
        raised, self._raised = self._raised, self._bars(towards)
        if self._raised and not raised:
            self.act()

    def act(self) -> None:
        """Raise the fault of the condition."""
        self.controller.fault(self.axis, self.bit, self._action)

    def forget(self) -> None:
        """Forget a previous action, because another motion begins."""
        if self.sign:
            self._raised = False

    def _bars(self, towards: int) -> bool:
        """True if the axis moves in the barred direction.

        If a reversal will lead there, an event checks again.
        """
        if not self.sign:
            return True
        a, clock = self.controller.axes[self.axis], self.controller.clock
        if a.move is None or towards == self.sign:
            return a.move is not None
        elapsed = clock.now - a.starts[-1]
        found = sets_off(a.profiles[-1], self.sign, elapsed)
        if found is None or found <= elapsed + _NOW:
            return found is not None
        self._event = clock.at(a.starts[-1] + found, self.check)
        return False


class Undirected(Condition):
    """An error independent of direction, such as an error input, while it is `active`."""

    __slots__ = ("_active",)

    def __init__(self, controller: Controller, axis: int, sign: int, bit: int, action: str) -> None:
        super().__init__(controller, axis, sign, bit, action)
        self._active = False

    @property
    def met(self) -> bool:
        return self._active

    def set_active(self, active: bool) -> None:
        """Set the state of the error."""
        self._active = active
        self.check()


class Together:
    """A block that starts several axes; conditions are checked at its end."""

    __slots__ = ("_controller", "_outer")

    def __init__(self, controller: Core) -> None:
        self._controller = controller
        self._outer: list[Condition] | None = None

    def __enter__(self) -> None:
        self._outer = self._controller.deferred_checks
        if self._outer is None:
            self._controller.deferred_checks = []

    def __exit__(self, kind: object, *_: object) -> None:
        if self._outer is not None:
            return
        waiting, self._controller.deferred_checks = self._controller.deferred_checks or [], None
        if kind is None:
            for condition in dict.fromkeys(waiting):
                condition.check()


def release(controller: Core, a: Axis) -> tuple[Axis, ...]:
    """End the suspension by a keyword of an axis and of the axes suspended with it.

    Return these axes.
    """
    freed = (a, *(each for each in controller.suspended_with.get(a.index, ()) if each is not a))
    for each in freed:
        each.suspend_reasons &= ~BY_WORD
        controller.suspended_with.pop(each.index, None)
    return freed


def refuse_motion(controller: Core, a: Axis) -> None:
    """Raise Rejected if the axis is locked by an error, disabled, or its brake is set."""
    if a.faults & a.locks:
        what = fault_names(a.faults)
        raise Rejected(
            "axis-error", f"axis {a.index} has an error: {what}", "clear the error before moving it"
        )
    if not a.enabled:
        raise Rejected("disabled-axis", f"axis {a.index} is off", "enable the axis before moving it")
    if a.index in controller.braked:
        raise Rejected("brake", f"the brake of axis {a.index} is set", "release the brake before moving it")
