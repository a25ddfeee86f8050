"""The assumptions that a program depends on, as text."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping, Sequence

from motionlang.commands.probe.assumption import Assumption
from motionlang.commands.probe.probe import lines_of, meanings
from motionlang.kernel.tools import count_of
from motionlang.views.table import Column, Table
from motionlang.views.terminal import styled

# A program with this many lines is written to a file by the command and not shown.
LONG = 7


def listing(found: Sequence[Assumption], *, width: int = 100, colour: bool = False) -> str:
    """List evidence, name and question of each assumption, with the default below."""
    if not found:
        return "  depends on no unconfirmed assumption\n"
    count = count_of(len(found), "unconfirmed assumption")
    with_probe = sum(each.probe is not None for each in found)
    settable = sum(each.key != "" for each in found)
    lines = [f"  depends on {count}; a probe can settle {with_probe}, the machine file can set {settable}"]
    for each in found:
        lines.append("")
        name = styled(each.name, "word", colour)
        lines += [f"  {name}  {styled(each.strength, 'dim', colour)}"]
        lines += _wrapped(_open(each), width)
    return "\n".join(lines) + "\n"


def of_word(found: Sequence[Assumption], axis: int, *, width: int = 100, colour: bool = False) -> str:
    """Return the open questions about a keyword.

    Each has the program to type and the meaning of each possible answer of a controller.
    """
    how = "not settled by the sources; motionlang probe NAME writes a test program for a controller"
    lines = [styled(f"  {how}", "dim", colour)]
    for each in found:
        lines += ["", f"  {styled(each.name, 'word', colour)}"]
        lines += (
            _wrapped(_open(each), width) if each.probe is None else _probe_lines(each, axis, width, colour)
        )
    return "\n".join(lines) + "\n"


def _probe_lines(assumption: Assumption, axis: int, width: int, colour: bool) -> list[str]:
    """Return the program that answers a question: its lines, and its possible answers."""
    probe = assumption.probe
    assert probe is not None
    lines = _wrapped(f"{assumption.question}:", width)
    before, ask, _ = lines_of(probe, axis, 1.0)
    if probe.needs:
        needs = probe.needs.replace("{a}", str(axis)).replace("{b}", str(axis + 1))
        lines += _wrapped(f"first: {needs}", width)
    if probe.motion:
        how = f"motionlang probe {assumption.name} --motion DISTANCE"
        lines += _wrapped(f"needs motion: write a test program with {how}", width)
    elif probe.behind or len(before) >= LONG:
        lines += _wrapped(f"write a test program with motionlang probe {assumption.name}", width)
    else:
        typed = [*before, f"PRINT {ask}" if probe.language == "mint" else ask]
        if probe.error:
            typed.append(f"' after an error, ONERROR does PRINT {probe.error}")
        lines += [f"      {styled(line, 'word', colour)}" for line in typed]
    lines += [f"    {line}" for line in meanings(assumption, max(40, width - 4))[1:]]
    beyond = [] if probe.form else assumption.alternatives[len(probe.answers) - 1 :]
    lines += [line for other in beyond for line in _wrapped(f"or, not distinguished by it: {other}", width)]
    return lines


def _open(assumption: Assumption) -> str:
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
            "has_probe": each.probe is not None,
            "probe_by_name": each.probe is not None and each.probe.alone,
            "key": each.key,
        }
        for place, each in found
    ]
    names = ("name", "question", "chosen", "alternatives", "reason", "strength", "motionlang_only")
    return Table(
        "assumptions", [Column(name) for name in (*about, *names, "has_probe", "probe_by_name", "key")], rows
    )
