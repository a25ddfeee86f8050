"""The rest of Mint's type library: keywords that are known but not simulated."""

from __future__ import annotations

import os
from collections.abc import Iterator

from motionlang.kernel.lang.keyword import KEPT, Keyword
from motionlang.kernel.mint.keywords import no_effect, unsimulated

_UNITS = {
    "int": "integer",
    "bool": "bool",
    "float": "number",
    "string": "text",
    "var": "text",
    "date": "text",
}


def _rows() -> Iterator[Keyword]:
    treatments = {
        "kept": no_effect.STORED,
        "value": unsimulated.ACTIONS[unsimulated.VALUE],
        "command": unsimulated.ACTIONS[unsimulated.COMMAND],
        "motion": unsimulated.ACTIONS[unsimulated.MOTION],
    }
    for name, short, index, kind, access, treatment, meaning in _lines("values"):
        kind, *bounds = kind.split()
        low, high = map(float, bounds) if bounds else (None, None)
        actions = treatments[treatment]
        sense = "reading" if access == "R" else "setting"
        yield Keyword(name, short, sense, access, index, _UNITS[kind], actions, meaning, low=low, high=high,
                      group=unsimulated.GROUPS.get(actions.function, KEPT), simulated=False,
                      effect="switch" if name in no_effect.SWITCHES else "",
                      tunes=no_effect.TUNES.get(name, ""))  # fmt: skip
    for file in ("commands", "commands_v4"):
        for name, short, index, treatment, meaning in _lines(file):
            actions = treatments[treatment]
            yield Keyword(name, short, "command", "C", index, "", actions, meaning,
                          group=unsimulated.GROUPS[actions.function], simulated=False)  # fmt: skip


def _lines(file: str) -> Iterator[list[str]]:
    """Yield the fields of each line of a type library file.

    The fields of `values` are NAME, short form, index, type, access, treatment and meaning; the type may have a
    range, such as "int 0 14". `commands` has neither type nor access.
    """
    path = os.path.join(os.path.dirname(__file__), "type_library", f"{file}.txt")
    for line in __loader__.get_data(path).decode("utf-8").splitlines():  # type: ignore[name-defined]
        yield line.split("|")


ROWS = tuple(_rows())
