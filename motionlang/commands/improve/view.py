"""A shorter cycle as text: the edits with what each gains, what bounds it, and the program's difference."""

from __future__ import annotations

from collections.abc import Iterator
from difflib import unified_diff

from motionlang.commands.certify.view import limits_table
from motionlang.commands.improve import Improvement
from motionlang.kernel.tools import count_of
from motionlang.views.table import Column, Document, Table
from motionlang.views.terminal import styled


def improvement_document(found: Improvement, file: str) -> Document:
    """Return an improvement as data; `diff` is that of the program."""
    texts = (*found.skipped, *found.refused, *([found.sets] if found.sets else []), *found.waits)
    remarks = Table("remarks", (Column("text"),), [{"text": each} for each in texts])
    values = {
        "cycle": found.cycle,
        "before": found.before,
        "after": found.after,
        "trials": found.trials,
        "diff": "".join(difference(found, file)),
    }
    return Document([edits_table(found), limits_table(found.limits), remarks], values)


def edits_table(found: Improvement) -> Table:
    """Return the edits in the order of their gain, each with what bounds it."""
    rows = [
        {
            "literal": each.literal.address,
            "line": each.literal.line,
            "old": each.literal.value,
            "new": each.value,
            "gain": each.share,
            "bound": each.bound,
            "outputs": ", ".join(map(str, each.outputs)) or None,
        }
        for each in found.edits
    ]
    columns = (
        Column("literal", "edit", left=True, style="word"),
        Column("line"),
        Column("old", "from"),
        Column("new", "to"),
        Column("gain", unit="s", text="{:.4f}".format),
        Column("bound", "bounded by", left=True),
        Column("outputs", "used while output is on", left=True, drop=1),
    )
    return Table(
        "edits", columns, rows, empty="no edit gains anything", notes=[count_of(found.trials, "trial")]
    )


def improvement_lines(found: Improvement, file: str, *, width: int, colour: bool) -> list[str]:
    """Return an improvement as lines of text."""
    share = 100.0 * (found.after / found.before - 1.0)
    edits = count_of(len(found.edits), "edit")
    repeats = f"{found.cycle}, " if found.cycle else ""
    head = f"{file}: {repeats}{found.before:.6g} s → {found.after:.6g} s, {share:.1f} % with {edits}"
    lines = [styled(head, "bold", colour), "", *edits_table(found).lines(width, colour=colour)]
    note = styled("note:", "note", colour)
    sets = [found.sets] if found.sets else []
    remarks = [f"{note} {each}" for each in (*found.skipped, *found.refused, *sets, *found.waits)]
    lines += ["", *remarks] if remarks else []
    if found.edits:
        lines += ["", *limits_table(found.limits).lines(width, colour=colour)]
        lines += ["", *(line.rstrip("\n") for line in difference(found, file))]
    return lines


def difference(found: Improvement, file: str) -> Iterator[str]:
    """Yield the lines of a unified diff of the program, which `patch` applies."""
    old, new = (each.text.splitlines(keepends=True) for each in (found.source, found.patched))
    return unified_diff(old, new, file, file)
