"""Open readings for a person: what a program rests on, one a line."""

from __future__ import annotations

import textwrap
from typing import TYPE_CHECKING

from motionlang.views.terminal import styled

if TYPE_CHECKING:
    from collections.abc import Sequence

    from motionlang.readings.entries import Reading


def listing(found: Sequence[Reading], *, width: int = 100, colour: bool = False) -> str:
    """What a program rests on: strength, name and question of each reading, and what was chosen below it."""
    if not found:
        return "  rests on no open reading\n"
    count = f"{len(found)} open reading{'s' if len(found) > 1 else ''}"
    asked, settable = sum(each.probe is not None for each in found), sum(each.key != "" for each in found)
    lines = [
        f"  rests on {count}; {asked} can be asked of a controller (motionlang probe), {settable} can be set"
    ]
    for each in found:
        lines.append("")
        name = styled(each.name, "word", colour)
        lines += [f"  {name}  {styled(each.strength, 'dim', colour)}"]
        others = f"; or: {'; or '.join(each.alternatives)}" if each.alternatives else ""
        lines += textwrap.wrap(
            f"{each.question}: {each.chosen}{others}",
            max(40, width - 4),
            initial_indent="    ",
            subsequent_indent="    ",
        )
    return "\n".join(lines) + "\n"


def as_dict(reading: Reading) -> dict[str, object]:
    """A reading as JSON shows it."""
    return {
        "name": reading.name,
        "question": reading.question,
        "chosen": reading.chosen,
        "alternatives": list(reading.alternatives),
        "why": reading.why,
        "strength": reading.strength,
        "asked": reading.probe is not None,
        "key": reading.key,
    }
