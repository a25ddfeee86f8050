"""All words of Mint: file by file what is simulated, then every further word of its type library."""

from __future__ import annotations

from importlib import import_module
from pkgutil import get_data

from motionlang.lang.keyword import Keyword
from motionlang.mint.keywords import no_effect, unsimulated

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from types import ModuleType


def files() -> tuple[ModuleType, ...]:
    """The modules that have rows, in their order."""
    return tuple(import_module(f"motionlang.mint.keywords.{name}") for name in _ORDER.split())


_ORDER = """
correction presets hold_to_analogue torque jogging drives
axis feedrate motion buffer compensation on_the_fly paths following following_masters following_auxiliary
table_motion_cams table_motion_splines state timing tasks terminal
camboxes captures auxiliary_latches monitoring event_flags relays steppers
io_inputs io_outputs io_signals comms modbus remote network network_groups serial limits limits_switches
limits_resetting homing latches latches_position_compare sensing servo functions nonvolatile encoder_wrap
no_effect identity legacy factory_defaults units constants language
"""
_UNITS = {
    "int": "integer",
    "bool": "bool",
    "float": "number",
    "string": "text",
    "var": "text",
    "date": "text",
}


def library() -> Iterator[Keyword]:
    """The rest of the type library: recognised and explained, not simulated."""
    fates = {
        "kept": no_effect.KEPT,
        "value": unsimulated.ACTIONS[unsimulated.VALUE],
        "command": unsimulated.ACTIONS[unsimulated.COMMAND],
        "motion": unsimulated.ACTIONS[unsimulated.MOTION],
    }
    for name, short, index, kind, access, fate, meaning in _lines("values"):
        actions = fates[fate]
        sense = "reading" if access == "R" else "setting"
        yield Keyword(name, short, sense, access, index, _UNITS[kind], actions, meaning,
                      group=unsimulated.GROUPS.get(actions.verb, unsimulated.KEPT_GROUP), simulated=False,
                      effect="switch" if name in no_effect.SWITCHES else "",
                      tunes=no_effect.TUNES.get(name, ""))  # fmt: skip
    for file in ("commands", "commands_v4"):
        for name, short, index, fate, meaning in _lines(file):
            actions = fates[fate]
            yield Keyword(name, short, "command", "C", index, "", actions, meaning,
                          group=unsimulated.GROUPS[actions.verb], simulated=False)  # fmt: skip


def _lines(file: str) -> Iterator[list[str]]:
    """The fields of a file of the type library.

    `values`: NAME, short form, index, type, access, what becomes of it, meaning; the commands have no type and access.
    """
    text = get_data("motionlang.mint.keywords", f"type_library/{file}.txt")
    assert text is not None
    for line in text.decode("utf-8").splitlines():
        yield line.split("|")
