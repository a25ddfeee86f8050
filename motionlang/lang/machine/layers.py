"""Overlay of one machine file on another.

The keys of the upper file take precedence, and its entries replace those about the same subject.
"""

from __future__ import annotations

from motionlang.lang.machine.keys import ABOUT

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping

    Entry = Mapping[str, object]


def layered(below: Mapping[str, object], above: Mapping[str, object]) -> dict[str, object]:
    """Merge the settings of two machine files; those of `above` take precedence.

    An entry such as `[[input]]` of channel 3 replaces all entries of that channel.
    """
    out = dict(below)
    for key, value in above.items():
        under = below.get(key)
        if key in ABOUT and isinstance(under, list) and isinstance(value, list):
            value = [each for each in under if not any(_replaces(key, e, each) for e in value)] + value
        out[key] = value
    return out


def _replaces(table: str, above: Entry, below: Entry) -> bool:
    """True if two entries are about the same subject.

    An answer to any INPUT replaces all answers, one with a prompt those whose prompts are part of it or contain it.
    """
    if _about(table, above) != _about(table, below):
        return False
    new, old = (str(each.get("prompt", "")).lower() for each in (above, below))
    return not new or (bool(old) and (new in old or old in new))


def _about(table: str, entry: Entry) -> tuple[object, ...]:
    """Return the subject of an entry; a missing number has its default, such as bus 1."""
    return tuple(entry.get(name, otherwise) for name, otherwise in ABOUT[table].items())
