"""Travel limits: software limits that the program sets and switches that the machine has.

A limit that is passed, or already active when a motion heads into it, raises a fault on its axis, and the axis does
what the limit's `action` says. Moving away from an active limit is always allowed.
"""

from __future__ import annotations

from motionlang.controller.triggers.conditions import Condition

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.controller.controller import Controller
    from motionlang.controller.triggers.watch import Watch


class Limit(Condition):
    """One end of an axis's travel: `sign` +1 or -1 says which, `bit` is the fault it raises.

    `position` is in counts; a `physical` limit stays where the machine has it. A limit may have no position at all and
    only be a switch that somebody opens and closes. Listeners of the controller hear "limit" when it changes.
    """

    __slots__ = ("_switch", "physical", "watch")

    def __init__(
        self, controller: Controller, axis: int, sign: int, bit: int, action: str, physical: bool = False
    ) -> None:
        super().__init__(controller, axis, sign, bit, action)
        self.physical = physical
        self._switch = False
        self.watch: Watch | None = None

    @property
    def active(self) -> bool:
        """Whether the axis is beyond the limit or its switch is closed."""
        return self._switch or self.passed

    met = active

    @property
    def passed(self) -> bool:
        """Whether the axis is beyond the limit; to stand on it is to have reached it."""
        return self.watch is not None and self.watch.side in (self.sign, 0)

    def place(self, position: float | None) -> None:
        """Set where the limit is; None takes it away."""
        controller = self.controller
        if self.watch is not None:
            controller.unwatch(self.axis, self.watch)
            self.watch = None
        if position is not None:
            self.watch = controller.watch(self.axis, position, self._pass, self.physical)
        self.look()

    def set_active(self, active: bool) -> None:
        """The switch has opened or closed."""
        changed, self._switch = self._switch is not active, active
        self.look()
        if changed:
            self.controller.tell("limit", self.axis)

    def _pass(self, direction: int) -> None:
        self.look(direction)
        self.controller.tell("limit", self.axis)
