"""The kinds of event that a program can handle: names, order of urgency, numbers.

No source prints the order of urgency; it is from memory (docs/contributing/assumptions.md).
"""

from __future__ import annotations

# Most urgent first. The index of a kind is also its bit in EVENTACTIVE, EVENTPENDING and EVENTDISABLE.
KINDS = (
    "onerror", "bus", "stop", "fastin", "latch", "timer", "in", "netdata", "comms", "dpr", "axisidle", "mblow",
    "terminalreceive", "serialreceive", "busmessage", "modbus", "knife", "reset",
)  # fmt: skip
# The keyword whose file raises the events of a kind for programs that handle them. `SOURCES` in that file
# names the source.
RAISED_BY = {
    "in": "IN", "latch": "LATCH", "fastin": "FASTENABLE", "stop": "STOPINPUT", "comms": "COMMS", "netdata": "NETFLOAT",
    "bus": "NODELIVE",
}  # fmt: skip
# Kinds that nothing raises here, because the simulated machine has no source for them.
SOURCELESS = frozenset(("dpr", "terminalreceive", "serialreceive", "busmessage", "modbus", "knife", "reset"))
# Kinds that happen again and again by time alone.
_TIMED = frozenset(("timer",))
# Other names of a kind: COMMSX in the manuals, and CAN in v4.
_OTHER_NAMES = {"commsx": "comms", "can": "bus"}
# Kinds with a single event. The others have a number (`Event IN3`).
SINGLE = frozenset((
    "onerror", "stop", "timer", "dpr", "axisidle", "mblow", "terminalreceive", "serialreceive", "modbus", "knife",
    "reset",
))  # fmt: skip


# The numbers of the channels that raise the events of a kind; a host may have any number of elements.
NUMBERS = {"bus": range(1, 3), "fastin": range(1000), "latch": range(32), "in": range(1000)}

# Kinds that a v4 label cannot handle: Mint v4 reports them to an embedded or a host application alone
# [MN1270 p. 106].
_NO_LABEL = frozenset(("mblow",))


def label_event(name: str) -> tuple[str, int] | None:
    """Return kind and number of the event that a v4 label handles, None if none."""
    found = kind_and_number(name)
    return None if found is None or found[0] in _NO_LABEL else found


def is_timed(name: str) -> bool:
    """True if time alone raises the event that a handler names."""
    found = kind_and_number(name)
    return found is not None and found[0] in _TIMED


def kind_and_number(name: str) -> tuple[str, int] | None:
    """Return kind and number of the event that a handler names, None if it names none."""
    word = name.lower()
    kind = word.rstrip("0123456789")
    number = word[len(kind) :]
    kind = _OTHER_NAMES.get(kind, kind)
    if kind not in KINDS:
        return None
    if kind in SINGLE:
        return None if number else (kind, 0)
    return kind, int(number) if number else -1
