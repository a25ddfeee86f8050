"""Overlay of one machine file on another.

The keys of the upper file take precedence, and its entries replace the lower file's entries about the same
subject.
"""

from __future__ import annotations

from collections.abc import Mapping

from motionlang.kernel.errors import ProgramError
from motionlang.kernel.lang.machine.keys import ABOUT, DRIVES, NAMED
from motionlang.kernel.tools import nearest

Entry = Mapping[str, object]


def layered(below: Mapping[str, object], above: Mapping[str, object]) -> dict[str, object]:
    """Merge the settings of two machine files; those of `above` take precedence.

    An entry such as `[[input]]` of channel 3 replaces all entries of that channel. An input of `above` may
    refer to its channel by the name that `below` gives it. What stops the run of `below` stops no run of another
    world: `run.stop` is that of `above` or none. Raises ProgramError for a name that is not there.
    """
    out = {key: value for key, value in below.items() if not key.startswith("run.stop.")}
    for key, value in above.items():
        under = below.get(key)
        if key in NAMED and isinstance(value, list):
            value = [_with_channel(key, each, under) for each in value]
        if key in ABOUT and isinstance(under, list) and isinstance(value, list):
            value = [each for each in under if not any(_replaces(key, e, each) for e in value)] + value
        out[key] = value
    return out


def is_key_of_entries(name: str) -> bool:
    """True for the name of a key in entries of a channel, such as `input.3.asked`."""
    parts = name.split(".")
    return len(parts) == 3 and bool(DRIVES.get(parts[0], ("", ""))[1]) and parts[1].isdecimal()


def with_key_of_entries(settings: Mapping[str, object], name: str, value: object) -> dict[str, object]:
    """Return settings with another value of a key in all entries of a channel that have it.

    `input.3.asked` is the key `asked` of the entries `[[input]]` of channel 3. Raises ValueError if none has it.
    """
    table, number, key = name.split(".")
    entries: list[Entry] = settings.get(table, [])  # type: ignore[assignment]
    changed = [
        {**each, key: value} if each[DRIVES[table][1]] == int(number) and key in each else each
        for each in entries
    ]
    if all(each is old for each, old in zip(changed, entries, strict=True)):
        raise ValueError(f"no [[{table}]] of {DRIVES[table][1]} {number} in the machine file has {key}")
    return {**settings, table: changed}


def _with_channel(table: str, entry: Entry, below: object) -> Entry:
    """Return an entry with its name resolved to the channel in the file below."""
    if "channel" in entry:
        return entry
    known = (
        {str(each["name"]): each["channel"] for each in below if "name" in each}
        if isinstance(below, list)
        else {}
    )
    wanted = str(entry["name"]).lower()
    for name, channel in known.items():
        if name.lower() == wanted:
            return {"channel": channel, **entry}
    near = nearest(wanted, known)
    hint = (
        f"did you mean {near}?"
        if near
        else f"its names are {', '.join(known)}"
        if known
        else "write channel = N"
    )
    message = f"no [[{table}]] of the machine file is named {entry['name']}"
    raise ProgramError.of("machine-file", message, hint=hint)


def _replaces(table: str, above: Entry, below: Entry) -> bool:
    """True if two entries are about the same subject.

    An answer to any INPUT replaces all answers. An answer with a prompt replaces those whose prompts contain
    it or are contained in it.
    """
    if _about(table, above) != _about(table, below):
        return False
    new, old = (str(each.get("prompt", "")).lower() for each in (above, below))
    return not new or (bool(old) and (new in old or old in new))


def _about(table: str, entry: Entry) -> tuple[object, ...]:
    """Return the subject of an entry; missing numbers have defaults, such as bus 1."""
    return tuple(entry.get(name, otherwise) for name, otherwise in ABOUT[table].items())
