"""The assumptions that a program depends on, as text."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping, Sequence

from motionlang.commands.evidence.assumption import Assumption
from motionlang.kernel.tools import count_of
from motionlang.views.table import Column, Table
from motionlang.views.terminal import styled


def listing(found: Sequence[Assumption], *, width: int = 100, colour: bool = False) -> str:
    """List evidence, name and question of each assumption, with the default below."""
    if not found:
        return "  depends on no unconfirmed assumption\n"
    count = count_of(len(found), "unconfirmed assumption")
    settable = sum(each.key != "" for each in found)
    lines = [f"  depends on {count}; the machine file can set {settable}"]
    for each in found:
        lines.append("")
        name = styled(each.name, "word", colour)
        lines += [f"  {name}  {styled(each.strength, 'dim', colour)}"]
        lines += _wrapped(question_of(each), width)
    return "\n".join(lines) + "\n"


def of_word(found: Sequence[Assumption], *, width: int = 100, colour: bool = False) -> str:
    """Return the open assumptions about a keyword."""
    lines = [styled("  not settled by the sources", "dim", colour)]
    for each in found:
        lines += ["", f"  {styled(each.name, 'word', colour)}", *_wrapped(question_of(each), width)]
    return "\n".join(lines) + "\n"


def question_of(assumption: Assumption) -> str:
    """Return a question with the chosen answer and the alternatives."""
    others = f"; or: {'; or '.join(assumption.alternatives)}" if assumption.alternatives else ""
    return f"{assumption.question}: {assumption.chosen}{others}"


def _wrapped(text: str, width: int) -> list[str]:
    return textwrap.wrap(text, max(40, width - 4), initial_indent="    ", subsequent_indent="    ")


def assumptions_table(
    found: Sequence[tuple[Mapping[str, object], Assumption]], about: Sequence[str]
) -> Table:
    """Return assumptions as data, each with the columns `about` what it concerns."""
    rows = [
        {
            **place,
            "name": each.name,
            "question": each.question,
            "chosen": each.chosen,
            "alternatives": each.alternatives,
            "reason": each.why,
            "strength": each.strength,
            "motionlang_only": each.own,
            "key": each.key,
        }
        for place, each in found
    ]
    names = ("name", "question", "chosen", "alternatives", "reason", "strength", "motionlang_only", "key")
    return Table("assumptions", [Column(name) for name in (*about, *names)], rows)
