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
            spoken = {_about(key, entry) for entry in value}
            value = [entry for entry in under if not spoken & _subjects(key, entry)] + value
        out[key] = value
    return out


def _subjects(table: str, entry: Entry) -> set[tuple[object, ...]]:
    """Return what an upper entry may be about to replace this one: an answer to any INPUT replaces all answers."""
    return {_about(table, entry), _about(table, {**entry, "prompt": ""})}


def _about(table: str, entry: Entry) -> tuple[object, ...]:
    """Return the subject of an entry; a missing number has its default, such as bus 1."""
    return tuple(entry.get(name, otherwise) for name, otherwise in ABOUT[table].items())
