"""One machine file on top of another: its keys count, and its entries replace those about the same thing."""

from __future__ import annotations

from motionlang.lang.machine.keys import ABOUT

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping

    Entry = Mapping[str, object]


def layered(below: Mapping[str, object], above: Mapping[str, object]) -> dict[str, object]:
    """The settings of two machine files: those of `above`, and of `below` what `above` does not speak of.

    An entry such as `[[input]]` of channel 3 takes the place of all entries of that channel.
    """
    out = dict(below)
    for key, value in above.items():
        under = below.get(key)
        if key in ABOUT and isinstance(under, list) and isinstance(value, list):
            spoken = {_about(key, entry) for entry in value}
            value = [entry for entry in under if _about(key, entry) not in spoken] + value
        out[key] = value
    return out


def _about(table: str, entry: Entry) -> tuple[object, ...]:
    """What an entry is about; numbers that are left out are those that stand for themselves, such as bus 1."""
    return tuple(entry.get(name, otherwise) for name, otherwise in ABOUT[table].items())
