"""All words of Mint: group by group what is simulated, then every further word of its type library."""

from __future__ import annotations

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
    from motionlang.mint.keywords import (
        axis,
        buffer,
        camboxes,
        captures,
        changing,
        comms,
        constants,
        control,
        correcting,
        drives,
        fastaux,
        feedrate,
        following,
        functions,
        holding,
        homing,
        identity,
        io,
        jogging,
        kept,
        language,
        latches,
        limits,
        memory,
        modbus,
        monitoring,
        motion,
        network,
        older,
        paths,
        pending,
        presets,
        profiles,
        relays,
        remote,
        restoring,
        sensing,
        serial,
        servo,
        state,
        steppers,
        tasks,
        terminal,
        torque,
        turns,
        units,
    )

    return (
        correcting, presets, holding, torque, jogging, drives,
        axis, feedrate, motion, buffer, changing, paths, following, profiles, state, control, tasks, terminal,
        camboxes, captures, fastaux, monitoring, pending, relays, steppers,
        io, comms, modbus, remote, network, serial, limits, homing, latches, sensing, servo, functions, memory, turns,
        kept, identity, older, restoring, units, constants, language,
    )  # fmt: skip


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
    from motionlang.mint.keywords import commands, kept, known, library_a_i, library_j_z

    source = "Mint ActiveX type library, build 5626"
    for line in (library_a_i.WORDS + library_j_z.WORDS).splitlines():
        name, short, index, kind, access, meaning = line.split("|")
        sense = "reading" if access == "R" else "setting"
        verb = kept.VERB if name in kept.WORDS else known.verb(name)
        yield Keyword(name, short, sense, access, index, _UNITS[kind], verb, meaning, source=source, trust="code",
                      group=known.GROUPS.get(verb, known.KEPT_GROUP), simulated=False)  # fmt: skip
    for text, origin, trust in ((commands.WORDS, source, "code"), (known.COMMANDS, "Mint v4", "memory")):
        for line in text.splitlines():
            name, short, index, meaning = line.split("|")
            verb = known.verb(name)
            yield Keyword(name, short, "command", "C", index, "", verb, meaning, source=origin, trust=trust,
                          group=known.GROUPS[verb], simulated=False)  # fmt: skip
