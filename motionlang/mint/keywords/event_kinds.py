"""The kinds of event that a program may handle: their names, their order of urgency, and which have a number.

The sources give the order only from memory (docs/fidelity.md).
"""

from __future__ import annotations

# Most urgent first. The place of a kind is also its bit in EVENTACTIVE, EVENTPENDING and EVENTDISABLE.
KINDS = (
    "onerror", "bus", "stop", "fastin", "latch", "timer", "in", "netdata", "comms", "dpr", "axisidle", "mblow",
    "terminalreceive", "serialreceive", "busmessage", "modbus", "knife", "reset",
)  # fmt: skip
# The keyword whose file raises the events of a kind for programs that handle them: `SOURCES` there says what does.
RAISED_BY = {
    "in": "IN", "latch": "LATCH", "fastin": "FASTENABLE", "stop": "STOPINPUT", "comms": "COMMS", "netdata": "NETFLOAT",
    "bus": "NODELIVE", "terminalreceive": "EVENTPEND", "serialreceive": "SERIALCHAR",
}  # fmt: skip
# Kinds that only EVENTPEND raises here: nothing of the simulated machine is their source.
SOURCELESS = frozenset(("dpr", "busmessage", "modbus", "knife", "reset"))
# What a kind is called too: COMMSX in the manuals, and CAN by v4.
_OTHER_NAMES = {"commsx": "comms", "can": "bus"}
# Kinds that exist once; the others have a number (`Event IN3`).
SINGLE = frozenset((
    "onerror", "stop", "timer", "dpr", "axisidle", "mblow", "terminalreceive", "serialreceive", "modbus", "knife",
    "reset",
))  # fmt: skip


def kind_and_number(name: str) -> tuple[str, int] | None:
    """The kind and the number of a handler's name, None when no event is called so."""
    word = name.lower()
    kind = word.rstrip("0123456789")
    number = word[len(kind) :]
    kind = _OTHER_NAMES.get(kind, kind)
    if kind not in KINDS:
        return None
    if kind in SINGLE:
        return None if number else (kind, 0)
    return kind, int(number) if number else -1
