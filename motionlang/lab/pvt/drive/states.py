"""The state machine of DS402: maps the control word to the status bits.

    disabled ─▶ ready ─▶ switched on ─▶ enabled ─▶ quick stop ─▶ disabled
                                           any ─▶ fault ─▶ disabled

A disabled drive can only become ready. From there a command may skip states, in both directions. A rising bit 7
ends a fault.
"""

from __future__ import annotations

DISABLED, READY, ON, ENABLED, QUICK_STOP, FAULT = range(6)
# The bits of the status word of each state.
STATUS = (0x40, 0x21, 0x23, 0x27, 0x07, 0x08)
SWITCH_ON, VOLTAGE, NO_QUICK_STOP, ENABLE, RESET = 1, 2, 4, 8, 0x80


def next_state(state: int, before: int, control: int) -> int:
    """Return the state after a control word; `before` is the previous one."""
    if state == FAULT:
        return DISABLED if control & ~before & RESET else FAULT
    if not control & VOLTAGE:
        return DISABLED
    if not control & NO_QUICK_STOP:
        return QUICK_STOP if state in (ENABLED, QUICK_STOP) else DISABLED
    if state == QUICK_STOP:
        return ENABLED if control & SWITCH_ON and control & ENABLE else QUICK_STOP
    requested = READY if not control & SWITCH_ON else ON if not control & ENABLE else ENABLED
    if state == DISABLED:
        return READY if requested == READY else DISABLED
    return requested
