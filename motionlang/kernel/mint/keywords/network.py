"""Events of buses, which the machine file's `[[remote]]` and `[[bus]]` schedule. Their numbers: MN1274 p. 113."""

from __future__ import annotations

from motionlang.kernel.lang.keyword import Actions, Keyword, constant
from motionlang.kernel.mint.keywords.remote import Nodes
from motionlang.kernel.mint.runtime.binding import of


def read_event(nodes: Nodes, bus: int) -> int:
    """BUSEVENT: return the next event and remove it."""
    code = nodes.bus(bus).take()
    if code:
        nodes.environment.acts += 1
    return code


# ------------------------------------------------------------------------------------------------- keywords

_EVENT = Actions(read=of(Nodes, read_event))
_EVENT_INFO = Actions(read=of(Nodes, lambda nodes, bus: nodes.bus(bus).taken[1]))

_CODES = (
    ("NONE", 0, "nothing has happened"),
    ("OPERATIONAL", 1, "the bus works"),
    ("PASSIVE", 2, "the bus has many errors"),
    ("OFF", 3, "the bus is off"),
    ("RECEIVE_OVERRUN", 4, "messages were lost"),
    ("DIED", 5, "a node died"),
    ("LIVE", 6, "a node lives"),
    ("EMERGENCY", 11, "a node has sent an emergency message"),
    ("TRANSMIT_OVERRUN", 13, "messages were not sent"),
)


def _bus(name: str, actions: Actions, help: str) -> tuple[Keyword, Keyword]:
    """Return the rows of a bus keyword and of its older name, which begins with CAN."""
    new, old = (
        Keyword(word, "", "reading", "R", "bus", "integer", actions, help + more, f"PRINT {word}(1)", default=0.0,
                group="remote")
        for word, more in ((f"BUS{name}", ""), (f"CAN{name}", " The older word for CAN buses."))
    )  # fmt: skip
    return new, old


ROWS = (
    *(constant(f"_cet{name}", value, f"BUSEVENT: {help}.") for name, value, help in _CODES),
    *_bus("EVENT", _EVENT,
          "Code of the next event of a bus, which is taken off its queue; 0 when there is none."),
    *_bus("EVENTINFO", _EVENT_INFO,
          "Node number of the event that was read last."),
)  # fmt: skip
