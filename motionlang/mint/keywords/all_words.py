"""All words of Mint: group by group what is simulated, then every further word of its type library."""

from __future__ import annotations

from importlib import import_module

from motionlang.lang.keyword import Keyword

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from types import ModuleType


def rows() -> list[Keyword]:
    """Every row, the groups in their order, then what is left of the library."""
    found = [row for group in groups() for row in group.ROWS]
    taken = {spelling.lower() for row in found for spelling in (row.name, row.short) if spelling}
    for row in _not_simulated():
        if row.name.lower() not in taken:
            taken.add(row.name.lower())
            if row.short.lower() in taken:
                row.short = ""
            elif row.short:
                taken.add(row.short.lower())
            found.append(row)
    return found


def groups() -> tuple[ModuleType, ...]:
    """The modules of the groups, in their order."""
    return tuple(import_module(f"motionlang.mint.keywords.{name}") for name in _ORDER.split())


_ORDER = """
correction presets hold_to_analogue torque jogging drives
axis feedrate motion buffer compensation on_the_fly paths following table_motion state timing tasks terminal
camboxes captures auxiliary_latches monitoring event_flags relays steppers
io comms modbus remote network serial limits homing latches sensing servo functions nonvolatile encoder_wrap
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


def _not_simulated() -> Iterator[Keyword]:
    """The rest of the type library: recognised and explained, not simulated."""
    from motionlang.mint.keywords import no_effect, unsimulated
    from motionlang.mint.keywords.type_library import commands, words_a_i, words_j_z

    source = "Mint ActiveX type library, build 5626"
    for line in (words_a_i.WORDS + words_j_z.WORDS).splitlines():
        name, short, index, kind, access, meaning = line.split("|")
        sense = "reading" if access == "R" else "setting"
        verb = no_effect.VERB if name in no_effect.WORDS else unsimulated.verb(name)
        yield Keyword(name, short, sense, access, index, _UNITS[kind], verb, meaning, source=source, trust="code",
                      group=unsimulated.GROUPS.get(verb, unsimulated.KEPT_GROUP), simulated=False)  # fmt: skip
    for text, origin, trust in (
        (commands.WORDS, source, "code"),
        (unsimulated.COMMANDS, "Mint v4", "memory"),
    ):
        for line in text.splitlines():
            name, short, index, meaning = line.split("|")
            verb = unsimulated.verb(name)
            yield Keyword(name, short, "command", "C", index, "", verb, meaning, source=origin, trust=trust,
                          group=unsimulated.GROUPS[verb], simulated=False)  # fmt: skip
